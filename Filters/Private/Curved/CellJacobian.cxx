// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CellJacobian.h"

#include "vtkMath.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

constexpr int Lanes = CellJacobian::Lanes;
constexpr int Width = 3 * Lanes; ///< of a coefficient with three components

/// The lower bound may be so much smaller than the smallest value that is known.
constexpr double Tightness = 0.9;
/// How many parts are looked at where that alone is not known, and where the sign is not known.
constexpr int MostPartsForBound = 40;
constexpr int MostPartsForSign = 4000;
constexpr double Rounding = 1e-13; ///< of the largest coefficient

double ComputeFactorial(int n)
{
  return std::tgamma(n + 1.);
}

/// Applies a sparse matrix to coefficients with three components, in lanes.
template <typename Entries>
void Apply(const Entries& entries, const std::vector<double>& from, std::vector<double>& to)
{
  std::fill(to.begin(), to.end(), 0.);
  for (const auto& entry : entries)
  {
    const double* in = from.data() + entry.From * Width;
    double* out = to.data() + entry.To * Width;
    for (int i = 0; i < Width; ++i)
    {
      out[i] += entry.Factor * in[i];
    }
  }
}

}

CellJacobian::CellJacobian(const CurvedShape& shape)
  : Order(shape.Order)
  , IsPyramid(shape.Shape == CellShape::Pyramid)
  , Nodes(shape.GetNumberOfNodes())
{
  if (shape.Shape == CellShape::Tet)
  {
    this->Simplex = { { 0, 0, 0 } };
  }
  else if (shape.Shape == CellShape::Wedge)
  {
    this->Simplex = { { 0, 0, 1 } };
  }
  // The determinant of a tetrahedron has the degree 3 (p - 1), of others 3 p - 1 at most.
  const int size = shape.Shape == CellShape::Tet ? std::max(3 * this->Order - 2, this->Order + 1)
                                                 : 3 * this->Order;
  this->Strides = { { 1, size, size * size } };
  this->Size = size * size * size;
  this->Values = this->ListTerms({ { this->Order, this->Order, this->Order } });
  std::array<Degrees, 3> slopes{};
  Degrees cross{};
  Degrees determinant{};
  for (int axis = 0; axis < 3; ++axis)
  {
    Degrees& degrees = slopes[axis] = { { this->Order, this->Order, this->Order } };
    for (int other = 0; other < 3; ++other)
    {
      degrees[other] -= this->Simplex[other] == this->Simplex[axis] ? 1 : 0;
    }
    degrees[2] -= this->IsPyramid && axis < 2 ? 1 : 0;
    for (int other = 0; other < 3; ++other)
    {
      cross[other] += axis > 0 ? degrees[other] : 0;
      determinant[other] += degrees[other];
    }
  }
  this->FindValues(shape);
  this->FindSlopes(slopes);
  const Terms crossTerms = this->ListTerms(cross);
  this->CrossTerms = this->NumberPlaces(crossTerms);
  for (const Term& term : crossTerms)
  {
    this->CrossPlaces.push_back(term.Place);
  }
  this->Determinant = this->ListTerms(determinant);
  this->DeterminantTerms = this->NumberPlaces(this->Determinant);
  for (std::size_t t = 0; t < this->Determinant.size(); ++t)
  {
    this->Divisors.push_back(1. / this->Determinant[t].Multinomial);
    if (this->Determinant[t].Multinomial < 1.5) // all others are 2 or more
    {
      this->Corners.push_back(static_cast<int>(t));
    }
  }
  this->FindLines();
}

CellJacobian::Terms CellJacobian::ListTerms(const Degrees& degrees) const
{
  Terms terms;
  for (int k = 0; k <= degrees[2]; ++k)
  {
    for (int j = 0; j <= degrees[1]; ++j)
    {
      for (int i = 0; i <= degrees[0]; ++i)
      {
        Term term{ { { i, j, k } }, degrees, i + j * this->Strides[1] + k * this->Strides[2], 1. };
        for (int axis = 0; axis < 3; ++axis)
        {
          for (int other = 0; other < 3; ++other)
          {
            term.Firsts[axis] -=
              this->Simplex[other] == this->Simplex[axis] ? term.Exponents[other] : 0;
          }
          term.Multinomial /= ComputeFactorial(term.Exponents[axis]);
          if (axis == 0 || this->Simplex[axis] != this->Simplex[axis - 1])
          {
            term.Multinomial *=
              ComputeFactorial(degrees[axis]) / ComputeFactorial(std::max(0, term.Firsts[axis]));
          }
        }
        if (*std::min_element(term.Firsts.begin(), term.Firsts.end()) >= 0)
        {
          terms.push_back(term);
        }
      }
    }
  }
  return terms;
}

/// Which term stands at each place; -1: none.
std::vector<int> CellJacobian::NumberPlaces(const Terms& terms) const
{
  std::vector<int> numbers(this->Size, -1);
  for (std::size_t t = 0; t < terms.size(); ++t)
  {
    numbers[terms[t].Place] = static_cast<int>(t);
  }
  return numbers;
}

/// The shape functions of VTK's cell as polynomials, by their values at as many places.
void CellJacobian::FindValues(const CurvedShape& shape)
{
  const std::size_t size = this->Values.size();
  const std::size_t nodes = shape.Nodes.size();
  std::vector<std::vector<double>> values(size, std::vector<double>(nodes));
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size));
  std::vector<std::vector<double>> inverse = matrix;
  std::vector<double*> rows;
  std::vector<double*> inverseRows;
  for (std::size_t place = 0; place < size; ++place)
  {
    const Term& at = this->Values[place];
    double parameters[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      parameters[axis] = static_cast<double>(at.Exponents[axis]) / this->Order;
    }
    shape.Cell->InterpolateFunctions(parameters, values[place].data());
    for (std::size_t t = 0; t < size; ++t)
    {
      const Term& term = this->Values[t];
      double& value = matrix[place][t] = term.Multinomial;
      for (int axis = 0; axis < 3; ++axis)
      {
        value *= std::pow(parameters[axis], term.Exponents[axis]);
        value *= axis == 0 || this->Simplex[axis] != this->Simplex[axis - 1]
          ? std::pow(static_cast<double>(at.Firsts[axis]) / this->Order, term.Firsts[axis])
          : 1.;
      }
    }
    rows.push_back(matrix[place].data());
    inverseRows.push_back(inverse[place].data());
  }
  vtkMath::InvertMatrix(rows.data(), inverseRows.data(), static_cast<int>(size));
  std::vector<double> row(nodes);
  for (std::size_t t = 0; t < size; ++t)
  {
    std::fill(row.begin(), row.end(), 0.);
    double largest = 0.;
    for (std::size_t place = 0; place < size; ++place)
    {
      const double weight = inverse[t][place] * this->Values[t].Multinomial;
      largest = std::max(largest, std::abs(weight));
      for (std::size_t node = 0; node < nodes; ++node)
      {
        row[node] += weight * values[place][node];
      }
    }
    for (std::size_t node = 0; node < nodes; ++node)
    {
      if (std::abs(row[node]) > Rounding * largest) // else it is 0 but for rounding
      {
        this->ToValues.push_back({ static_cast<int>(node), static_cast<int>(t), row[node] });
      }
    }
  }
}

/// The derivative by a parameter, which grows at the cost of the first weight of its simplex. The
/// square of a pyramid is a point at the apex, so that all terms have the weight of the square's
/// side as a factor: without it the determinant is not 0 there.
void CellJacobian::FindSlopes(const std::array<Degrees, 3>& degrees)
{
  int start = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Terms terms = this->ListTerms(degrees[axis]);
    const std::vector<int> numbers = this->NumberPlaces(terms);
    const auto add = [&](std::size_t from, int place, int factor)
    {
      if (factor != 0 && place >= 0 && numbers[place] >= 0)
      {
        this->ToSlopes.push_back(
          { static_cast<int>(from), start + numbers[place], static_cast<double>(factor) });
      }
    };
    for (std::size_t t = 0; t < this->Values.size(); ++t)
    {
      const Term& term = this->Values[t];
      add(
        t, term.Exponents[axis] > 0 ? term.Place - this->Strides[axis] : -1, term.Exponents[axis]);
      add(t, term.Place, -term.Firsts[axis]);
    }
    for (const Term& term : terms)
    {
      this->SlopePlaces[axis].push_back(term.Place);
    }
    this->SlopeStarts[axis] = start;
    start += static_cast<int>(terms.size());
  }
}

void CellJacobian::FindLines()
{
  for (int to = 0; to < 3; ++to)
  {
    for (int from = -1; from < to; ++from)
    {
      const int stride = this->Strides[to] - (from < 0 ? 0 : this->Strides[from]);
      std::vector<std::vector<int>> all; // by their length
      for (const Term& term : this->Determinant)
      {
        if (term.Exponents[to] == 0 && (from < 0 || this->Simplex[from] == this->Simplex[to]))
        {
          const int degree = from < 0 ? term.Firsts[to] : term.Exponents[from];
          std::vector<int>& line = all.emplace_back();
          for (int i = 0; i <= degree; ++i)
          {
            line.push_back(this->DeterminantTerms[term.Place + i * stride]);
          }
        }
      }
      std::stable_sort(
        all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
      Lines& lines = this->LinesOfEdges[GetLines(from, to)];
      for (std::size_t first = 0; first < all.size();)
      {
        const std::size_t length = all[first].size();
        lines.Sizes.push_back(static_cast<int>(length));
        std::size_t last = first; // one with others of its length is there again
        for (; last + 1 < all.size() && last + 1 < first + Lanes && all[last + 1].size() == length;)
        {
          ++last;
        }
        for (std::size_t i = 0; i < length; ++i)
        {
          for (std::size_t l = 0; l < Lanes; ++l)
          {
            lines.Terms.push_back(all[std::min(first + l, last)][i]);
          }
        }
        first = last + 1;
      }
    }
  }
}

void CellJacobian::Start(Workspace& work) const
{
  work.Nodes.assign(static_cast<std::size_t>(Width) * this->Nodes, 0.);
  work.Values.resize(Width * this->Values.size());
  work.Slopes.resize(Width *
    (this->SlopePlaces[0].size() + this->SlopePlaces[1].size() + this->SlopePlaces[2].size()));
  work.Cross.resize(Width * this->CrossPlaces.size());
  work.Determinant.resize(Lanes * this->Determinant.size());
}

/// The Bernstein coefficients, in the order of the terms.
void CellJacobian::FindDeterminants(Workspace& work) const
{
  Apply(this->ToValues, work.Nodes, work.Values);
  Apply(this->ToSlopes, work.Values, work.Slopes);
  std::fill(work.Cross.begin(), work.Cross.end(), 0.);
  const double* const second = work.Slopes.data() + this->SlopeStarts[1] * Width;
  const double* const third = work.Slopes.data() + this->SlopeStarts[2] * Width;
  const int* const places = this->SlopePlaces[2].data();
  for (std::size_t s = 0; s < this->SlopePlaces[1].size(); ++s)
  {
    const int* const terms = this->CrossTerms.data() + this->SlopePlaces[1][s];
    double a[Width];
    std::copy_n(second + s * Width, Width, a);
    for (std::size_t t = 0; t < this->SlopePlaces[2].size(); ++t)
    {
      const double* b = third + t * Width;
      double* sum = work.Cross.data() + terms[places[t]] * Width;
      for (int l = 0; l < Lanes; ++l)
      {
        sum[l] += a[Lanes + l] * b[2 * Lanes + l] - a[2 * Lanes + l] * b[Lanes + l];
        sum[Lanes + l] += a[2 * Lanes + l] * b[l] - a[l] * b[2 * Lanes + l];
        sum[2 * Lanes + l] += a[l] * b[Lanes + l] - a[Lanes + l] * b[l];
      }
    }
  }
  std::fill(work.Determinant.begin(), work.Determinant.end(), 0.);
  const double* const first = work.Slopes.data() + this->SlopeStarts[0] * Width;
  const int* const crossPlaces = this->CrossPlaces.data();
  for (std::size_t s = 0; s < this->SlopePlaces[0].size(); ++s)
  {
    const int* const terms = this->DeterminantTerms.data() + this->SlopePlaces[0][s];
    double a[Width];
    std::copy_n(first + s * Width, Width, a);
    for (std::size_t t = 0; t < this->CrossPlaces.size(); ++t)
    {
      const double* b = work.Cross.data() + t * Width;
      double* sum = work.Determinant.data() + terms[crossPlaces[t]] * Lanes;
      for (int l = 0; l < Lanes; ++l)
      {
        sum[l] += a[l] * b[l] + a[Lanes + l] * b[Lanes + l] + a[2 * Lanes + l] * b[2 * Lanes + l];
      }
    }
  }
  for (std::size_t t = 0; t < this->Divisors.size(); ++t)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      work.Determinant[Lanes * t + l] *= this->Divisors[t];
    }
  }
}

/// The longest edge that halves a part: from the first weight of a simplex (-1) or that of a
/// parameter to that of another.
void CellJacobian::FindLongestEdge(const Part& part, int& from, int& to) const
{
  double most = -1.;
  for (int end = 0; end < 3; ++end)
  {
    for (int begin = -1; begin < end; ++begin)
    {
      const auto& a = begin < 0 ? part.Firsts[end] : part.Corners[begin];
      const auto& b = part.Corners[end];
      const double length = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
        (a[2] - b[2]) * (a[2] - b[2]);
      const bool isEdge = begin < 0 || this->Simplex[begin] == this->Simplex[end];
      if (isEdge && length > most * (1. + 2. * Rounding))
      {
        most = length;
        from = begin;
        to = end;
      }
    }
  }
}

/// Halves a part across its longest edge, by de Casteljau's algorithm on the lines along it.
/// Returns the second half; the first takes the place of the part.
int CellJacobian::Halve(Workspace& work, int number) const
{
  int from = -1;
  int to = 0;
  this->FindLongestEdge(work.Parts[number], from, to);
  const auto size = this->Determinant.size();
  const auto second = work.Parts.size();
  work.Parts.push_back(work.Parts[number]);
  work.Coefficients.resize(std::max(work.Coefficients.size(), (second + 1) * size));
  double* const begin = work.Coefficients.data() + number * size;
  double* const end = work.Coefficients.data() + second * size;
  const Lines& lines = this->LinesOfEdges[GetLines(from, to)];
  const int* terms = lines.Terms.data();
  work.Line.resize(static_cast<std::size_t>(Lanes) * (3 * this->Order + 1));
  double* const values = work.Line.data();
  for (const int length : lines.Sizes)
  {
    for (int i = 0; i < Lanes * length; ++i)
    {
      values[i] = begin[terms[i]];
    }
    for (int step = 0; step < length; ++step)
    {
      const int last = Lanes * (length - 1 - step);
      for (int l = 0; l < Lanes; ++l)
      {
        begin[terms[Lanes * step + l]] = values[l];
        end[terms[last + l]] = values[last + l];
      }
      for (int i = 0; i < last; i += Lanes)
      {
        for (int l = 0; l < Lanes; ++l)
        {
          values[i + l] = 0.5 * (values[i + l] + values[i + Lanes + l]);
        }
      }
    }
    terms += static_cast<std::ptrdiff_t>(Lanes) * length;
  }
  Part& first = work.Parts[number];
  Part& other = work.Parts[second];
  for (int k = 0; k < 3; ++k)
  {
    const double middle =
      0.5 * ((from < 0 ? first.Firsts[to] : first.Corners[from])[k] + first.Corners[to][k]);
    first.Corners[to][k] = middle;
    for (int axis = 0; axis < 3 && from < 0; ++axis)
    {
      other.Firsts[axis][k] =
        this->Simplex[axis] == this->Simplex[to] ? middle : other.Firsts[axis][k];
    }
    if (from >= 0)
    {
      other.Corners[from][k] = middle;
    }
  }
  return static_cast<int>(second);
}

/// The least coefficient of a part. Those at corners are values, which `known` is not larger than.
double CellJacobian::Look(const Workspace& work, int part, double& known) const
{
  const double* first = work.Coefficients.data() + part * this->Determinant.size();
  for (const int corner : this->Corners)
  {
    known = std::min(known, first[corner]);
  }
  const std::size_t size = this->Determinant.size();
  const std::size_t whole = size / Lanes * Lanes;
  double least[Lanes];
  std::fill_n(least, Lanes, first[0]);
  for (std::size_t i = 0; i < whole; i += Lanes)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      least[l] = std::min(least[l], first[i + l]);
    }
  }
  for (std::size_t i = whole; i < size; ++i)
  {
    least[0] = std::min(least[0], first[i]);
  }
  return *std::min_element(least, least + Lanes);
}

/// Halves the part with the least coefficient until the bound is near enough. Returns it.
double CellJacobian::Search(
  Workspace& work, int lane, double least, double known, double rounding) const
{
  const auto isAfter = [&work](int a, int b) { return work.Parts[a].Least > work.Parts[b].Least; };
  work.Parts.assign(1, Part());
  work.Parts[0].Least = least;
  work.Coefficients.resize(std::max(work.Coefficients.size(), this->Determinant.size()));
  for (std::size_t t = 0; t < this->Determinant.size(); ++t)
  {
    work.Coefficients[t] = work.Determinant[Lanes * t + lane];
  }
  work.Heap.assign(1, 0);
  for (int count = 1; known > rounding; ++count)
  {
    const int top = work.Heap.front();
    least = work.Parts[top].Least;
    if (least >= Tightness * known ||
      count >= (least > rounding ? MostPartsForBound : MostPartsForSign))
    {
      break;
    }
    std::pop_heap(work.Heap.begin(), work.Heap.end(), isAfter);
    work.Heap.pop_back();
    const int other = this->Halve(work, top);
    for (const int half : { top, other })
    {
      work.Parts[half].Least = this->Look(work, half, known);
      work.Heap.push_back(half);
      std::push_heap(work.Heap.begin(), work.Heap.end(), isAfter);
    }
  }
  return work.Parts[work.Heap.front()].Least;
}

void CellJacobian::Find(Workspace& work, int cells, Bound* bounds) const
{
  this->FindDeterminants(work);
  const std::size_t size = this->Determinant.size();
  double* const all = work.Determinant.data();
  const bool turns = this->Simplex[1] == 0 && this->Simplex[2] == 1; // wedges are in use both ways
  double sums[Lanes] = {};
  double least[Lanes];
  double known[Lanes];
  double largest[Lanes] = {};
  for (std::size_t i = 0; i < Lanes * size; ++i)
  {
    sums[i % Lanes] += all[i];
  }
  for (std::size_t i = 0; turns && i < Lanes * size; ++i)
  {
    all[i] = sums[i % Lanes] < 0. ? -all[i] : all[i];
  }
  std::fill_n(least, Lanes, VTK_DOUBLE_MAX);
  std::fill_n(known, Lanes, VTK_DOUBLE_MAX);
  for (std::size_t t = 0; t < size; ++t)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      least[l] = std::min(least[l], all[Lanes * t + l]);
      largest[l] = std::max(largest[l], std::abs(all[Lanes * t + l]));
    }
  }
  for (const int corner : this->Corners)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      known[l] = std::min(known[l], all[Lanes * corner + l]);
    }
  }
  for (int l = 0; l < cells; ++l)
  {
    const double mean = (turns ? std::abs(sums[l]) : sums[l]) / static_cast<double>(size);
    const double rounding = Rounding * largest[l];
    if (!(mean > rounding)) // also if it is not finite
    {
      bounds[l] = { false, -1. };
      continue;
    }
    if (known[l] > rounding && least[l] < Tightness * known[l])
    {
      least[l] = this->Search(work, l, least[l], known[l], rounding);
    }
    bounds[l] = { least[l] > rounding, std::max(-1., least[l] / mean) };
  }
}

CellJacobian::Bound CellJacobian::Find(const double* nodes) const
{
  Workspace work;
  this->Start(work);
  for (int n = 0; n < this->Nodes; ++n)
  {
    work.Set(0, n, nodes + static_cast<std::ptrdiff_t>(3) * n);
  }
  Bound bound{};
  this->Find(work, 1, &bound);
  return bound;
}

}
