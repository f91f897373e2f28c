// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/SurfaceStars.h"

#include "Core/Memory/Loops.h"
#include "Core/Rules/Pi.h"
#include "Core/Smoothness/FaceStars.h"
#include "Core/Smoothness/LocalMatrix.h"
#include "Core/Smoothness/MapSamples.h"
#include "Core/Smoothness/SurfaceStarLevels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace subdivision
{
namespace
{

using Kind = SurfaceStar::Kind;
using Place = MapPlace;
using Matrix = SurfaceStarLevels::Matrix;

std::array<long long, 2> Round(const Place& place, double factor)
{
  return { { std::llround(place[0] * factor * 1e6), std::llround(place[1] * factor * 1e6) } };
}

/// Steps around the vertex in the middle.
class VertexStar
{
public:
  /// `levels`: that are made after the first one.
  VertexStar(const SurfaceStar& star, int levels)
    : Star(star)
    , Repeats(GetPeriod(star.Scheme))
    , Last(Repeats.Steps * (1 + levels))
    , Mesh(star.Faces, GetAngle(star), GetRegularFaces(star.Scheme) == 4)
    , Made(star, Mesh, Last)
  {
    const int period = this->Repeats.Steps;
    this->Places = FindStarPlaces(this->Made, this->Mesh.GetPlaces(), this->Last);
    const double near = 3. / this->Repeats.Factor;
    this->Columns.assign(this->Places[period].size(), -1);
    for (std::size_t v = 0; v < this->Places[period].size(); ++v)
    {
      if (this->Mesh.Measure(this->Places[period][v]) < near + 1e-6)
      {
        this->Columns[v] = static_cast<int>(this->Vertices.size());
        this->Vertices.push_back(static_cast<int>(v));
      }
    }
  }

  SmoothnessFacts Examine(bool samples) const
  {
    SmoothnessFacts facts;
    LocalMatrix matrix;
    this->FindEigenvalues(matrix, facts);
    const std::vector<Place> map =
      samples && facts.Condition == Answer::Yes ? this->FindMap(matrix) : std::vector<Place>();
    if (!map.empty())
    {
      this->Sample(map, facts);
    }
    return facts;
  }

  StarMap MakeMap() const
  {
    SmoothnessFacts facts;
    LocalMatrix matrix;
    const std::vector<Place> points =
      this->FindEigenvalues(matrix, facts) ? this->FindMap(matrix) : std::vector<Place>();
    StarMap map = points.empty() ? StarMap() : this->MakeMap(points);
    map.Facts = facts;
    return map;
  }

private:
  /// Returns whether l2 > l3.
  bool FindEigenvalues(LocalMatrix& matrix, SmoothnessFacts& facts) const
  {
    facts.Valence = this->Star.Faces;
    if (!this->MakeMatrix(matrix))
    {
      return false;
    }
    const std::vector<double> moduli = matrix.FindModuli();
    facts.SetEigenvalues(moduli);
    facts.Condition = this->Star.IsAround() ? HoldsInside(moduli, 2)
                                            : HoldsBesideCurves(moduli, 1. / this->Repeats.Factor,
                                                this->Star.Where == Kind::Corner ? 2 : 1);
    return HoldsInside(moduli, 2) == Answer::Yes;
  }

  /// The map at the vertices of the last level, no numbers where it is not known; empty if there is
  /// none.
  std::vector<Place> FindMap(const LocalMatrix& matrix) const
  {
    const int period = this->Repeats.Steps;
    const std::vector<double> basis = matrix.FindLeading(2);
    return basis.empty() ? std::vector<Place>()
                         : this->Made.Apply(period, this->Last,
                             PlaceValues(basis, this->Vertices, this->Columns.size()));
  }

  StarMap MakeMap(const std::vector<Place>& map) const
  {
    std::vector<StarMap::Point> points;
    for (const Place& place : map)
    {
      points.push_back({ { place[0], place[1], 0. } });
    }
    const std::vector<Place>& places = this->Places.back();
    std::vector<double> rings;
    for (const Place& place : places)
    {
      rings.push_back(this->Mesh.Measure(place));
    }
    StarMapMaker maker(2, std::move(points), rings);
    const PolygonMesh<int>& mesh = this->Made.Get(this->Last).Mesh;
    for (const int face : InTurn(static_cast<int>(mesh.NumberOfFaces)))
    {
      const int* corners = mesh.Vertices.data() + mesh.GetFirst(face);
      double area = 0.;
      for (int i = 2; i < mesh.GetSize(face); ++i)
      {
        area += FindTriangleArea(places, { { corners[0], corners[i - 1], corners[i] } }) / 2.;
      }
      maker.AddCell(corners, mesh.GetSize(face), area);
    }
    int first = 0;
    for (int v = 0; v < static_cast<int>(places.size()); ++v)
    {
      const bool isOnRay = this->Mesh.FindTurn(places[v]) < 1e-6;
      first = isOnRay && maker.IsKnown(v) && rings[v] > rings[first] ? v : first;
    }
    return maker.Make(0, first, first);
  }

  /// Only rules know the angle of a corner; here any does.
  static double GetAngle(const SurfaceStar& star)
  {
    return star.IsAround() ? 2. * Pi : star.Faces == 1 ? 2. / 3. * Pi : Pi;
  }

  /// Returns false if rows read vertices farther away.
  bool MakeMatrix(LocalMatrix& matrix) const
  {
    const int period = this->Repeats.Steps;
    const Matrix steps = this->Made.GetSteps(period, 2 * period);
    std::map<std::array<long long, 2>, vtkIdType> rows;
    for (std::size_t v = 0; v < this->Places[2 * period].size(); ++v)
    {
      rows[Round(this->Places[2 * period][v], this->Repeats.Factor)] = static_cast<vtkIdType>(v);
    }
    matrix = LocalMatrix(static_cast<int>(this->Vertices.size()));
    bool isClosed = true;
    for (int i = 0; i < matrix.GetSize(); ++i)
    {
      const auto row = rows.find(Round(this->Places[period][this->Vertices[i]], 1.));
      if (row == rows.end())
      {
        return false;
      }
      for (vtkIdType k = steps.Offsets[row->second]; k < steps.Offsets[row->second + 1]; ++k)
      {
        const int column = this->Columns[steps.Columns[k]];
        isClosed = isClosed && (column >= 0 || std::abs(steps.Weights[k]) < 1e-14);
        if (column >= 0)
        {
          matrix.At(i, column) += steps.Weights[k];
        }
      }
    }
    return isClosed;
  }

  void Sample(std::vector<Place> map, SmoothnessFacts& facts) const
  {
    const Place middle = map[0];
    for (Place& place : map)
    {
      place = { { place[0] - middle[0], place[1] - middle[1] } };
    }
    const double outer = 1. / this->Repeats.Factor;
    SetSamples(
      map, this->ListTriangles(outer), this->ListRing(outer), !this->Star.IsAround(), facts);
  }

  /// Three corners in a row of each face between the first ring and its image by a step.
  std::vector<std::array<int, 3>> ListTriangles(double outer) const
  {
    const PolygonMesh<int>& mesh = this->Made.Get(this->Last).Mesh;
    const std::vector<Place>& places = this->Places.back();
    std::vector<std::array<int, 3>> triangles;
    for (const int corner : InTurn(static_cast<int>(mesh.GetNumberOfCorners())))
    {
      const int face = mesh.GetFace(corner);
      const int first = mesh.GetFirst(face);
      if (mesh.GetSize(face) == 3 && corner != first)
      {
        continue; // a triangle is looked at once
      }
      bool isBetween = true;
      for (int k = first; k < first + mesh.GetSize(face); ++k)
      {
        const double distance = this->Mesh.Measure(places[mesh.Vertices[k]]);
        isBetween =
          isBetween && distance < outer + 1e-6 && distance > outer / this->Repeats.Factor - 1e-6;
      }
      if (isBetween)
      {
        std::array<int, 3> ids{ { mesh.Vertices[corner], mesh.Vertices[mesh.Next(corner)],
          mesh.Vertices[mesh.Next(mesh.Next(corner))] } };
        if (FindTriangleArea(places, ids) < 0.)
        {
          std::swap(ids[0], ids[1]);
        }
        triangles.push_back(ids);
      }
    }
    return triangles;
  }

  /// The vertices of a ring, in the order in which they lie around the middle.
  std::vector<int> ListRing(double distance) const
  {
    std::vector<std::pair<double, int>> found;
    for (std::size_t v = 0; v < this->Places.back().size(); ++v)
    {
      const Place& place = this->Places.back()[v];
      if (std::abs(this->Mesh.Measure(place) - distance) < 1e-6)
      {
        found.emplace_back(this->Mesh.FindTurn(place), static_cast<int>(v));
      }
    }
    std::sort(found.begin(), found.end());
    std::vector<int> ring;
    for (const auto& [turn, vertex] : found)
    {
      ring.push_back(vertex);
    }
    return ring;
  }

  const SurfaceStar Star;
  const Period Repeats;
  const int Last; ///< level
  const StarMesh Mesh;
  const SurfaceStarLevels Made;
  std::vector<std::vector<Place>> Places; ///< of the vertices of each level
  std::vector<int> Columns;               ///< of the vertices of the level after one period
  std::vector<int> Vertices;
};

}

int GetRegularFaces(SurfaceSchemeKind scheme)
{
  switch (scheme)
  {
    case SurfaceSchemeKind::Linear:
    case SurfaceSchemeKind::Loop:
    case SurfaceSchemeKind::ModifiedButterfly:
    case SurfaceSchemeKind::SqrtThree:
      return 6;
    default:
      return 4;
  }
}

bool IsDual(SurfaceSchemeKind scheme)
{
  return scheme == SurfaceSchemeKind::DooSabin || scheme == SurfaceSchemeKind::Midedge;
}

bool HasCentres(SurfaceSchemeKind scheme)
{
  return scheme == SurfaceSchemeKind::CatmullClark || scheme == SurfaceSchemeKind::FourEight;
}

bool CanExamine(const SurfaceStar& star, int itemsOfFace)
{
  return star.Faces >= (star.IsAround() ? 3 : 1) &&
    star.Faces < LocalMatrix::MostItems / itemsOfFace;
}

int CountItemsOfFace(SurfaceSchemeKind scheme)
{
  return GetRegularFaces(scheme) == 4 ? 15 : 6; // three rings
}

StarMap MapSurface(const SurfaceStar& star, int levels)
{
  if (IsDual(star.Scheme))
  {
    return star.Where == Kind::Closed && CanExamine(star, CountAroundCorner(MappedDistance))
      ? MapFace(star, levels)
      : StarMap();
  }
  return CanExamine(star, CountItemsOfFace(star.Scheme)) ? VertexStar(star, levels).MakeMap()
                                                         : StarMap();
}

SmoothnessFacts ExamineSurface(const SurfaceStar& star, bool samples)
{
  if (IsDual(star.Scheme))
  {
    if (star.Where == Kind::Closed && CanExamine(star, CountAroundCorner(SampledDistance)))
    {
      return ExamineFace(star, samples);
    }
  }
  else if (CanExamine(star, CountItemsOfFace(star.Scheme)))
  {
    constexpr int further = 2; // sqrt(3), 4-8: one
    return VertexStar(star, GetPeriod(star.Scheme).Steps == 1 ? further : 1).Examine(samples);
  }
  SmoothnessFacts facts;
  facts.Valence = star.Faces;
  facts.SetEigenvalues({});
  return facts;
}

}
