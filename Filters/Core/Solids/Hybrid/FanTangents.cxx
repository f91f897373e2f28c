// SPDX-License-Identifier: BSD-3-Clause
// The tangents of fans of triangles and quads.
#include "Core/Rules/SectorMasks.h"
#include "Core/Solids/Hybrid/HybridTangents.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subdivision
{
namespace
{

using Vector = std::vector<double>;

double Dot(const Vector& a, const Vector& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}
void Subtract(double factor, const Vector& b, Vector& a)
{
  std::transform(a.begin(), a.end(), b.begin(), a.begin(),
    [factor](double x, double y) { return x - factor * y; });
}
void Normalise(Vector& a)
{
  const double length = std::sqrt(Dot(a, a));
  for (double& x : a)
  {
    x /= length;
  }
}

/// The angles at which edges and the far corners of quads lie in a regular fan.
struct FanAngles
{
  explicit FanAngles(const Neighbourhood& key)
    : IsClosed(key.back() == 1)
    , Faces(key.size() - 1)
    , Angle((this->IsClosed ? 2. * Pi : Pi) / static_cast<double>(this->Faces))
  {
  }
  std::size_t CountEdges() const { return this->Faces + (this->IsClosed ? 0 : 1); }
  double At(double edge) const { return edge * this->Angle; }

  const bool IsClosed;
  const std::size_t Faces;
  const double Angle;
};

/// Values of all items: own(), at edges, and, for each quad, between two edges.
template <typename AtEdge, typename AtQuad>
Vector FillItems(const Neighbourhood& key, double own, const AtEdge& atEdge, const AtQuad& atQuad)
{
  const FanAngles angles(key);
  Vector items{ own };
  for (std::size_t e = 0; e < angles.CountEdges(); ++e)
  {
    items.push_back(atEdge(static_cast<double>(e)));
  }
  for (std::size_t f = 0; f < angles.Faces; ++f)
  {
    if (key[f] == 4)
    {
      items.push_back(atQuad(static_cast<double>(f)));
    }
  }
  return items;
}

/// A function of the direction, of a regular fan.
template <typename Wave>
Vector FillWave(const Neighbourhood& key, double atEdges, double atQuads, const Wave& wave)
{
  const FanAngles angles(key);
  return FillItems(
    key, 0., [&](double e) { return atEdges * wave(angles.At(e)); },
    [&](double f) { return atQuads * (wave(angles.At(f)) + wave(angles.At(f + 1.))); });
}

double Cosine(double angle)
{
  return std::cos(angle);
}
double Sine(double angle)
{
  return std::sin(angle);
}

/// The left eigenvectors of a matrix for its two largest eigenvalues below 1, from a guess.
class LeadingTangents
{
public:
  explicit LeadingTangents(const LocalRows& rows)
    : Size(rows.GetNumberOfItems())
    , Matrix(rows.Fill())
  {
    const Vector limit = rows.FindLimit(); // takes away the eigenvalue 1
    for (std::size_t i = 0; i < this->Matrix.size(); ++i)
    {
      this->Matrix[i] -= limit[i % this->Size];
    }
  }

  /// Turns both vectors into an orthonormal basis of the space. False: it was not found.
  bool Find(Vector& a, Vector& b) const
  {
    Vector power = this->Matrix;
    for (int doubling = 0; doubling < 6; ++doubling)
    {
      power = this->Square(power);
    }
    for (int round = 0; round < 60; ++round)
    {
      a = this->Multiply(a, power);
      b = this->Multiply(b, power);
      Normalise(a);
      Subtract(Dot(a, b), a, b);
      Normalise(b);
    }
    double rest = 0.;
    for (Vector image : { this->Multiply(a, this->Matrix), this->Multiply(b, this->Matrix) })
    {
      Subtract(Dot(image, a), a, image);
      Subtract(Dot(image, b), b, image);
      rest = std::max(rest, Dot(image, image));
    }
    return rest < 1e-20;
  }

  /// Turns a basis into eigenvectors where their eigenvalues differ.
  void Separate(Vector& a, Vector& b) const
  {
    const Vector imageA = this->Multiply(a, this->Matrix);
    const Vector imageB = this->Multiply(b, this->Matrix);
    const double m[4] = { Dot(imageA, a), Dot(imageA, b), Dot(imageB, a), Dot(imageB, b) };
    const double half = (m[0] - m[3]) / 2.;
    const double square = half * half + m[1] * m[2];
    if (!(square > 1e-18))
    {
      return;
    }
    // x m = l x for x = (m[2], l - m[0]), or (l - m[3], m[1]), whichever is longer.
    const Vector both[2] = { a, b };
    Vector* made[2] = { &a, &b };
    for (int i = 0; i < 2; ++i)
    {
      const double l = (m[0] + m[3]) / 2. + (i == 0 ? 1. : -1.) * std::sqrt(square);
      const bool isFirst =
        std::abs(l - m[0]) + std::abs(m[2]) >= std::abs(l - m[3]) + std::abs(m[1]);
      const double x[2] = { isFirst ? m[2] : l - m[3], isFirst ? l - m[0] : m[1] };
      for (std::size_t k = 0; k < this->Size; ++k)
      {
        (*made[i])[k] = x[0] * both[0][k] + x[1] * both[1][k];
      }
      Normalise(*made[i]);
    }
  }

private:
  Vector Multiply(const Vector& left, const Vector& matrix) const
  {
    Vector product(this->Size, 0.);
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      for (std::size_t j = 0; j < this->Size; ++j)
      {
        product[j] += left[i] * matrix[i * this->Size + j];
      }
    }
    return product;
  }
  /// The square, scaled so that it neither grows nor vanishes.
  Vector Square(const Vector& matrix) const
  {
    Vector square;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      const auto row = matrix.begin() + static_cast<std::ptrdiff_t>(i * this->Size);
      const Vector product =
        this->Multiply({ row, row + static_cast<std::ptrdiff_t>(this->Size) }, matrix);
      square.insert(square.end(), product.begin(), product.end());
    }
    const double largest = std::abs(*std::max_element(
      square.begin(), square.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (double& x : square)
    {
      x /= largest;
    }
    return square;
  }

  const std::size_t Size;
  Vector Matrix;
};

/// Around a vertex of triangles and quads.
FanTangents SolveClosed(const Neighbourhood& key, LoopWeights weights)
{
  const Vector cosine = FillWave(key, 1., 1., Cosine);
  const Vector sine = FillWave(key, 1., 1., Sine);
  FanTangents tangents{ cosine, sine };
  const LeadingTangents leading(MakeFanRows(key, weights));
  if (!leading.Find(tangents.First, tangents.Second))
  {
    return {};
  }
  leading.Separate(tangents.First, tangents.Second);
  const double turn = Dot(tangents.First, cosine) * Dot(tangents.Second, sine) -
    Dot(tangents.First, sine) * Dot(tangents.Second, cosine);
  for (double& x : tangents.Second)
  {
    x = turn < 0. ? -x : x;
  }
  return std::abs(turn) > 1e-6 ? tangents : FanTangents();
}

/// In a sector of triangles and quads.
FanTangents SolveOpen(const Neighbourhood& key, LoopWeights weights, const Vector& along)
{
  const Vector sine = FillWave(key, 1., 1., Sine);
  Vector curve = along;
  Vector across = sine;
  const LeadingTangents leading(MakeFanRows(key, weights));
  if (!leading.Find(curve, across))
  {
    return {};
  }
  Vector rest = along;
  Subtract(Dot(along, curve), curve, rest);
  Subtract(Dot(along, across), across, rest);
  if (Dot(rest, rest) > 1e-16)
  {
    return {};
  }
  leading.Separate(curve, across);
  // The one that is less parallel to the tangent of the curve.
  Vector second = std::abs(Dot(curve, along)) < std::abs(Dot(across, along)) ? curve : across;
  const double sign = Dot(second, sine) < 0. ? -1. : 1.;
  for (double& x : second)
  {
    x *= sign;
  }
  return { along, second };
}

/// Faces of one type.
FanTangents FindPure(const Neighbourhood& key, bool modified, const Vector& along)
{
  const bool areQuads = key[0] == 4;
  const FanAngles angles(key);
  if (angles.IsClosed)
  {
    const double c = std::cos(angles.Angle);
    const double ofEdges = areQuads ? 1. + c + std::sqrt((9. + c) * (1. + c)) : 1.;
    return { FillWave(key, ofEdges, 1., Cosine), FillWave(key, ofEdges, 1., Sine) };
  }
  if (angles.Faces == 1) // the second difference of the curve
  {
    return { along, FillItems(key, -2., [](double) { return 1.; }, [](double) { return 0.; }) };
  }
  const auto faces = static_cast<int>(angles.Faces);
  const TransversalMask mask = GetTransversalMask(faces, areQuads, modified);
  Vector across = FillWave(key, 1., mask.Faces, Sine);
  across[0] = mask.Own;
  across[1] = across[angles.CountEdges()] = mask.End;
  // With more faces the plain rule has no tangent plane.
  return modified || faces <= (areQuads ? 4 : 6) ? FanTangents{ along, across } : FanTangents();
}

}

FanTangents FindFanTangents(const Neighbourhood& key, LoopWeights weights, bool modified)
{
  constexpr std::size_t most = 64; // powers of larger matrices take too long
  const FanAngles angles(key);
  const double last = static_cast<double>(angles.Faces);
  const Vector along = FillItems(
    key, 0., [last](double e) { return e == 0. ? 1.
                                  : e == last  ? -1.
                                               : 0.; },
    [](double) { return 0.; });
  const bool isPure = std::all_of(key.begin(), key.end() - 1, [&](int n) { return n == key[0]; });
  return isPure           ? FindPure(key, modified, along)
    : angles.Faces > most ? FanTangents()
    : key.back() == 1     ? SolveClosed(key, weights)
                          : SolveOpen(key, weights, along);
}

}
