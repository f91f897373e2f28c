// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/SolidMaps.h"

#include "Core/Memory/Vectors.h"
#include "Core/Rules/Pi.h"
#include "Core/Smoothness/LocalMatrix.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace subdivision
{
namespace
{

/// Where a vertex lies: its weights on the star's vertices, in multiples of the smallest.
using Place = std::vector<int>;
using Point = vectors::Vector;
using vectors::Cross;
using vectors::Dot;

Place Add(const Place& a, const Place& b)
{
  Place sum(a);
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] += b[i];
  }
  return sum;
}

/// How far a place is from the middle: the solids there end at 1, and twice as far at 2.
int Measure(const Place& offset)
{
  int most = 0;
  for (const int weight : offset)
  {
    most = std::max(most, std::abs(weight));
  }
  return most;
}

double Determinant(const Point& a, const Point& b, const Point& c)
{
  return Dot(a, Cross(b, c));
}

/// The signed solid angle of a triangle, seen from the origin (A. van Oosterom and J. Strackee).
double FindSolidAngle(const Point& a, const Point& b, const Point& c)
{
  const double la = std::sqrt(Dot(a, a));
  const double lb = std::sqrt(Dot(b, b));
  const double lc = std::sqrt(Dot(c, c));
  return 2. *
    std::atan2(
      Determinant(a, b, c), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
}

/// The parity of the order of four vertices, 1 or -1.
int FindParity(const std::array<int, 4>& order)
{
  int sign = 1;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      sign = order[j] > order[i] ? -sign : sign;
    }
  }
  return sign;
}

/// For each tetrahedron 1 or -1: whether it is oriented as the first one.
/// Across a face the orders (face, apex) of two tetrahedra are opposite.
std::vector<int> FindTurns(const std::vector<std::array<int, 4>>& tets)
{
  std::map<std::array<int, 3>, std::vector<std::pair<int, int>>> atFaces; // tetrahedron, sign
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      std::array<int, 3> face{ { tets[t][(k + 1) % 4], tets[t][(k + 2) % 4],
        tets[t][(k + 3) % 4] } };
      std::sort(face.begin(), face.end());
      std::array<int, 4> order = tets[t];
      std::replace(order.begin(), order.end(), tets[t][k], std::numeric_limits<int>::max());
      atFaces[face].emplace_back(static_cast<int>(t), FindParity(order));
    }
  }
  std::vector<int> turns(tets.size(), 0);
  turns[0] = 1;
  for (std::size_t known = 1, before = 0; known != before;)
  {
    before = known;
    for (const auto& [face, sides] : atFaces)
    {
      for (int i = 0; sides.size() == 2 && i < 2; ++i)
      {
        const auto [from, fromSign] = sides[i];
        const auto [to, toSign] = sides[1 - i];
        if (turns[from] != 0 && turns[to] == 0)
        {
          turns[to] = -turns[from] * fromSign * toSign;
          ++known;
        }
      }
    }
  }
  return turns;
}

/// The levels around the middle of a star.
template <typename Scheme>
class StarLevels
{
public:
  using Level = typename Scheme::Level;

  /// `levels`: that are made of the star of the middle, 1 or more.
  StarLevels(const SolidStar& star, int levels)
    : Star(star)
    , First(std::min(star.Corners - 1, 2))
  {
    this->MakeControl();
    for (; this->Steps <= this->First; ++this->Steps)
    {
      this->Places = this->MakeChildPlaces(this->Places);
      this->Current = Refine(this->Current, Depth::ForRefinement);
    }
    for (int level = 1; level <= levels; ++level)
    {
      this->Finer.push_back(this->MakeChildPlaces(level == 1 ? this->Places : this->Finer.back()));
      if (level == levels)
      {
        this->MakeCells();
        this->Operators.push_back(TakeStencils(this->Current));
        break;
      }
      Level next = Refine(this->Current, Depth::ForRefinement);
      this->Operators.push_back(TakeStencils(this->Current));
      this->Current = std::move(next);
    }
    this->Children = this->Finer.front();
    this->Number();
  }

  SmoothnessFacts Examine(bool samples) const
  {
    SmoothnessFacts facts = this->FindEigenvalues();
    const std::vector<Point> map = samples ? this->FindMap(facts) : std::vector<Point>();
    if (!map.empty())
    {
      this->Sample(map, facts);
    }
    return facts;
  }

  StarMap MakeMap() const
  {
    const SmoothnessFacts facts = this->FindEigenvalues();
    std::vector<Point> points = this->FindMap(facts);
    StarMap map = points.empty() ? StarMap() : this->MakeMap(std::move(points));
    map.Facts = facts;
    return map;
  }

private:
  static Point NotKnown()
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return { { unknown, unknown, unknown } };
  }

  SmoothnessFacts FindEigenvalues() const
  {
    SmoothnessFacts facts;
    facts.Valence = this->Near - 1;
    if (this->IsClosed)
    {
      const std::vector<double> moduli = this->MakeMatrix(this->Near).FindModuli();
      facts.SetEigenvalues(moduli);
      facts.Condition = HoldsInside(moduli, 3);
    }
    return facts;
  }

  /// The map at the vertices of the last level: the leading eigenvectors of the middle, continued
  /// to the star. Not a number where it is not known; empty if there is none.
  std::vector<Point> FindMap(const SmoothnessFacts& facts) const
  {
    const auto size = static_cast<int>(this->Vertices.size());
    const std::vector<double> basis = facts.Condition == Answer::Yes
      ? this->MakeMatrix(this->Near).FindLeading(3)
      : std::vector<double>();
    const std::vector<double> values =
      basis.empty() ? basis : this->MakeMatrix(size).Continue(this->Near, basis, 3);
    if (values.empty())
    {
      return {};
    }
    std::vector<Point> points(this->Places.size(), NotKnown());
    for (int i = 0; i < size; ++i)
    {
      std::copy_n(values.begin() + std::ptrdiff_t(3) * i, 3, points[this->Vertices[i]].begin());
    }
    for (std::size_t level = 0; level < this->Finer.size(); ++level)
    {
      points = this->TakeStepInside(points, level);
    }
    return points;
  }

  /// Where the star ends, its rules are not the rules of the mapped mesh: nothing is known there.
  std::vector<Point> TakeStepInside(const std::vector<Point>& points, std::size_t level) const
  {
    const std::vector<Place>& places = this->Finer[level];
    std::vector<Point> made(places.size(), NotKnown());
    for (std::size_t row = 0; row < made.size(); ++row)
    {
      const auto corners = places[row].begin() + this->Star.Corners;
      if (std::find(places[row].begin(), corners, 0) == corners)
      {
        for (int c = 0; c < 3; ++c)
        {
          made[row][c] = SumRow(this->Operators[level], static_cast<int>(row),
            [&](int vertex) { return points[vertex][c]; });
        }
      }
    }
    return made;
  }

  /// The map with the children of the last level's solids.
  StarMap MakeMap(std::vector<Point>&& points) const
  {
    const std::vector<Place>& places = this->Finer.back();
    const int steps = this->Steps + static_cast<int>(this->Finer.size());
    const Place middle = this->GetMiddle(steps);
    const double ring = std::ldexp(1., steps - this->First);
    int origin = 0;
    std::vector<double> rings;
    for (const Place& place : places)
    {
      rings.push_back(Measure(Subtract(place, middle)) / ring);
      origin = rings.back() == 0. ? static_cast<int>(rings.size()) - 1 : origin;
    }
    StarMapMaker maker(3, std::move(points), rings);
    const std::vector<int> turns = FindTurns(this->Star.Tets);
    const double size = 1. / (6. * ring * ring * ring);
    for (std::size_t cell = 0; 4 * cell < this->Cells.size(); ++cell)
    {
      maker.AddCell(this->Cells.data() + 4 * cell, 4, turns[cell >> (3 * steps)] * size);
    }
    int guides[2] = { origin, origin }; // the farthest towards the second and third vertex
    for (int v = 0; v < static_cast<int>(places.size()); ++v)
    {
      for (int g = 0; g < 2; ++g)
      {
        const bool isFarther = places[v][g + 1] > places[guides[g]][g + 1];
        guides[g] = isFarther && maker.IsKnown(v) ? v : guides[g];
      }
    }
    return maker.Make(origin, guides[0], guides[1]);
  }

  void MakeControl()
  {
    SimplexList list;
    for (const auto& tet : this->Star.Tets)
    {
      list.Dimensions.push_back(3);
      list.Connectivity.insert(list.Connectivity.end(), tet.begin(), tet.end());
    }
    const vtkIdType size =
      1 + *std::max_element(list.Connectivity.begin(), list.Connectivity.end());
    list.NumberOfPoints = size;
    subdivision::Level<int> control;
    control.Complex = BuildComplex<int>(list, this->Runs);
    control.Strata = BuildStrata(control.Complex, SingularSimplices(), StrataOptions());
    this->Current = Scheme::Start(std::move(control));
    this->Places.assign(size, Place(size, 0));
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Places[i][i] = 1;
    }
  }

  /// Vertices keep their place, in smaller multiples; new ones are the middle of two.
  std::vector<Place> MakeChildPlaces(const std::vector<Place>& places) const
  {
    std::vector<Place> made;
    for (const Place& place : places)
    {
      made.push_back(Add(place, place));
    }
    const auto add = [&](int a, int b) { made.push_back(Add(places[a], places[b])); };
    const auto& ends = this->Current.Complex.EdgeVertices;
    for (vtkIdType e = 0; e < this->Current.Complex.NumberOfEdges; ++e)
    {
      add(ends[2 * e], ends[2 * e + 1]);
    }
    if constexpr (Scheme::Traits.HasPieces)
    {
      for (vtkIdType o = 0; o < this->Current.NumberOfOctahedra; ++o)
      {
        add(this->Current.OctVertices[6 * o], this->Current.OctVertices[6 * o + 1]);
      }
    }
    return made;
  }

  /// The middle on a level: the vertex, the middle of the edge, or a vertex inside the face.
  Place GetMiddle(int steps) const
  {
    Place middle(this->Places.front().size(), 0);
    constexpr int parts[4][4] = { { 1 }, { 1, 1 }, { 2, 1, 1 }, { 1, 1, 1, 1 } };
    const int* part = parts[this->Star.Corners - 1];
    for (int i = 0; i < this->Star.Corners; ++i)
    {
      middle[i] = part[i] << (steps - this->First);
    }
    return middle;
  }

  static Place Subtract(const Place& place, const Place& middle)
  {
    Place offset(place);
    for (std::size_t i = 0; i < offset.size(); ++i)
    {
      offset[i] -= middle[i];
    }
    return offset;
  }

  /// The children of the last level's solids, as tetrahedra.
  void MakeCells()
  {
    const std::vector<CellRun> runs =
      RefineRuns(this->Runs, this->Steps + static_cast<int>(this->Finer.size()) - 1);
    const CellCounts counts = CountCells(RefineRuns(runs, 1));
    std::vector<int> offsets(static_cast<std::size_t>(counts.Cells) + 1);
    std::vector<unsigned char> types(static_cast<std::size_t>(counts.Cells));
    this->Cells.resize(static_cast<std::size_t>(counts.Entries));
    const CellStorage<int> storage{ this->Cells.data(), offsets.data(), types.data() };
    Scheme::WriteChildren(this->Current, runs, 1, static_cast<const double*>(nullptr), storage);
  }

  /// The rows and columns of the matrix: the middle, vertices near it, and the rest of the star.
  void Number()
  {
    std::map<Place, int> rows;
    const Place finer = this->GetMiddle(this->Steps + 1);
    for (std::size_t i = 0; i < this->Children.size(); ++i)
    {
      this->Children[i] = Subtract(this->Children[i], finer);
      rows[this->Children[i]] = static_cast<int>(i);
    }
    const Place middle = this->GetMiddle(this->Steps);
    this->Columns.assign(this->Places.size(), -1);
    for (int far = 0; far <= 2; ++far)
    {
      for (std::size_t i = 0; i < this->Places.size(); ++i)
      {
        const Place offset = Subtract(this->Places[i], middle);
        const auto row = rows.find(offset);
        if (Measure(offset) == far && row != rows.end())
        {
          this->Columns[i] = static_cast<int>(this->Vertices.size());
          this->Vertices.push_back(static_cast<int>(i));
          this->Rows.push_back(row->second);
        }
      }
      this->Near = far == 1 ? static_cast<int>(this->Vertices.size()) : this->Near;
    }
    for (int i = 0; i < static_cast<int>(this->Rows.size()); ++i)
    {
      const double inside = SumRow(this->Operators.front(), this->Rows[i],
        [&](int vertex)
        {
          const int column = this->Columns[vertex];
          return column >= 0 && (i >= this->Near || column < this->Near) ? 1. : 0.;
        });
      this->IsClosed = this->IsClosed && std::abs(inside - 1.) < 1e-9;
    }
  }

  template <typename Get>
  static double SumRow(const Stencils<int>& rows, int row, const Get& get)
  {
    ExplicitRows<int> entries;
    rows.AppendRow(row, 1., entries);
    double sum = 0.;
    for (std::size_t k = 0; k < entries.Columns.size(); ++k)
    {
      sum += entries.Weights[k] * get(entries.Columns[k]);
    }
    return sum;
  }

  LocalMatrix MakeMatrix(int size) const
  {
    LocalMatrix matrix(size);
    for (int i = 0; i < size; ++i)
    {
      ExplicitRows<int> entries;
      this->Operators.front().AppendRow(this->Rows[i], 1., entries);
      for (std::size_t k = 0; k < entries.Columns.size(); ++k)
      {
        const int column = this->Columns[entries.Columns[k]];
        if (column >= 0 && column < size)
        {
          matrix.At(i, column) += entries.Weights[k];
        }
      }
    }
    return matrix;
  }

  void Sample(const std::vector<Point>& map, SmoothnessFacts& facts) const
  {
    const std::vector<int> turns = FindTurns(this->Star.Tets);
    const Point middle = map[this->Rows[0]];
    std::vector<double> volumes;
    double around = 0.;
    for (std::size_t cell = 0; 4 * cell < this->Cells.size(); ++cell)
    {
      std::array<Point, 4> corners;
      int far = 0;
      int near = 4;
      for (int k = 0; k < 4; ++k)
      {
        const int vertex = this->Cells[4 * cell + k];
        const int distance = Measure(this->Children[vertex]);
        far = std::max(far, distance);
        near = std::min(near, distance);
        for (int c = 0; c < 3; ++c)
        {
          corners[k][c] = map[vertex][c] - middle[c];
        }
      }
      const int turn = turns[cell >> (3 * (this->Steps + 1))];
      if (near > 0 && far <= 3)
      {
        volumes.push_back(turn * this->FindVolume(corners));
      }
      else if (near == 0)
      {
        around += turn * this->FindAngle(4 * cell, corners);
      }
    }
    this->Judge(volumes, around, facts);
  }

  static double FindVolume(const std::array<Point, 4>& corners)
  {
    Point edges[3];
    for (int k = 0; k < 3; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        edges[k][c] = corners[k + 1][c] - corners[0][c];
      }
    }
    return Determinant(edges[0], edges[1], edges[2]);
  }

  /// The solid angle of the face opposite to the middle, as seen from there: positive in a positive
  /// tetrahedron.
  double FindAngle(std::size_t first, const std::array<Point, 4>& corners) const
  {
    int at = 0;
    while (Measure(this->Children[this->Cells[first + at]]) > 0)
    {
      ++at;
    }
    const int sign = at % 2 == 0 ? 1 : -1;
    return sign *
      FindSolidAngle(corners[at == 0 ? 1 : 0], corners[at <= 1 ? 2 : 1], corners[at <= 2 ? 3 : 2]);
  }

  static void Judge(const std::vector<double>& volumes, double around, SmoothnessFacts& facts)
  {
    const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
    if (volumes.empty() ||
      !std::all_of(volumes.begin(), volumes.end(), [](double v) { return std::isfinite(v); }))
    {
      return;
    }
    const double rounding = 1e-10 * std::max(std::abs(*least), std::abs(*most));
    const bool isRegular = *least > rounding || *most < -rounding;
    const bool goesOnce = std::abs(std::abs(around) - 4. * Pi) < 1e-6;
    facts.Samples = static_cast<int>(volumes.size());
    facts.Regular = isRegular ? Answer::Yes : Answer::No;
    facts.Injective = isRegular && goesOnce ? Answer::Yes : Answer::No;
  }

  const SolidStar& Star;
  const int First; ///< the steps after which the vertex in the middle exists
  std::vector<CellRun> Runs;
  int Steps = 0; ///< of the level of the matrix
  Level Current;
  std::vector<Place> Places;             ///< of the vertices of that level
  std::vector<Place> Children;           ///< of vertices of the next level, seen from the middle
  std::vector<std::vector<Place>> Finer; ///< of the vertices of all further levels
  std::vector<Stencils<int>> Operators;  ///< to each of these
  std::vector<int> Cells;                ///< of the last of them
  std::vector<int> Columns;              ///< of each vertex of that level, -1: none
  std::vector<int> Vertices;             ///< of each column
  std::vector<int> Rows; ///< of each column, the vertex of the next level at its place
  int Near = 0;          ///< the columns of the solids at the middle
  bool IsClosed = true;  ///< these read no others, and all columns no vertices beyond them
};

}

/// An edge has about six vertices near by for each tetrahedron, a vertex three.
bool CanExamine(const SolidStar& star)
{
  return static_cast<int>(star.Tets.size()) * (star.Corners == 1 ? 3 : 6) <= LocalMatrix::MostItems;
}

template <typename Scheme>
SmoothnessFacts ExamineSolid(const SolidStar& star, bool samples)
{
  if (!CanExamine(star))
  {
    SmoothnessFacts facts;
    facts.SetEigenvalues({});
    return facts;
  }
  return StarLevels<Scheme>(star, 1).Examine(samples);
}

template <typename Scheme>
StarMap MapSolid(const SolidStar& star, int levels)
{
  return CanExamine(star) ? StarLevels<Scheme>(star, levels).MakeMap() : StarMap();
}

double CountCellsOfMap(const SolidStar& star, int levels)
{
  const int steps = std::min(star.Corners - 1, 2) + 1 + levels;
  return static_cast<double>(star.Tets.size()) * std::pow(8., steps);
}

template SmoothnessFacts ExamineSolid<BoxSplineScheme<int>>(const SolidStar&, bool);
template SmoothnessFacts ExamineSolid<TetOctScheme<int>>(const SolidStar&, bool);
template StarMap MapSolid<BoxSplineScheme<int>>(const SolidStar&, int);
template StarMap MapSolid<TetOctScheme<int>>(const SolidStar&, int);

}
