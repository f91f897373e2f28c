// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenChecks.h
 * What must hold for every output of red-green refinement, checked without its help.
 */
#ifndef SubdivisionObjects_RedGreenChecks_h
#define SubdivisionObjects_RedGreenChecks_h

#include "RedGreenReference.h"

namespace redgreen_reference
{

/// The cells of one input cell: faces with their supports, facets counted.
struct PartsOfCell
{
  std::map<Tuple, std::set<Tuple>> Inside; ///< for each face of the input cell, what it is cut into
  std::map<Tuple, int> Facets;
  double Volume = 0.;
};

/// The faces of one part.
void AddFaces(PartsOfCell& parts, const Tuple& cell, const Cell& points);

using VerticesBySupport = std::map<Tuple, std::vector<vtkIdType>>;

/// Vertices of an input cell's parts that lie in a part without being one of its corners.
template <typename Id>
int CountHanging(const Written<Id>& written, const VerticesBySupport& vertices, const Tuple& input,
  const std::vector<Tuple>& parts)
{
  std::vector<vtkIdType> inside;
  std::vector<std::array<double, 4>> rows;
  for (const Tuple& face : FacesOf(Sorted(input)))
  {
    const auto found = vertices.find(face);
    for (std::size_t i = 0; found != vertices.end() && i < found->second.size(); ++i)
    {
      inside.push_back(found->second[i]);
      rows.push_back(Coordinates({ written.Keys[inside.back()] }, input)[0]);
    }
  }
  const std::size_t step = 1 + inside.size() * parts.size() / 20000;
  int hanging = 0;
  for (std::size_t p = 0; p < parts.size(); p += step)
  {
    Cell corners;
    for (vtkIdType v : parts[p])
    {
      corners.push_back(written.Keys[v]);
    }
    const auto matrix = Coordinates(corners, input);
    for (std::size_t k = 0; k < inside.size(); ++k)
    {
      if (std::find(parts[p].begin(), parts[p].end(), inside[k]) != parts[p].end())
      {
        continue;
      }
      bool outside = false;
      for (std::size_t i = 0; i < input.size() && !outside; ++i)
      {
        auto replaced = matrix;
        replaced[i] = rows[k];
        outside = Determinant(replaced, static_cast<int>(input.size())) < 0.;
      }
      hanging += outside ? 0 : 1;
    }
  }
  return hanging;
}

/// Conforming inside each input cell and between any two; a partition of each; orientation kept.
template <typename Id>
void CheckConforming(const SimplexList& input, const Written<Id>& written)
{
  ASSERT_EQ(std::set<Key>(written.Keys.begin(), written.Keys.end()).size(), written.Keys.size())
    << "a point has two vertices";
  const auto inputCells = GetCells(input);
  const auto cells = GetCells(written.Cells);
  const auto points = written.GetPointsOfCells();
  std::map<Tuple, std::set<Tuple>> cuts;
  std::map<Tuple, vtkIdType> cutBy;
  VerticesBySupport vertices;
  for (std::size_t v = 0; v < written.Keys.size(); ++v)
  {
    vertices[Support({ written.Keys[v] })].push_back(static_cast<vtkIdType>(v));
  }
  std::vector<Tuple> wholes;
  std::size_t next = 0;
  for (std::size_t c = 0; c < inputCells.size(); ++c)
  {
    if (next < cells.size() && cells[next] == inputCells[c])
    {
      ASSERT_EQ(written.InputCells[next], static_cast<vtkIdType>(c));
      wholes.push_back(Sorted(cells[next++]));
      continue;
    }
    PartsOfCell parts;
    std::vector<Tuple> list;
    const std::size_t size = inputCells[c].size();
    for (; next < cells.size() && written.InputCells[next] == static_cast<vtkIdType>(c); ++next)
    {
      ASSERT_EQ(cells[next].size(), size);
      list.push_back(cells[next]);
      const double volume =
        Determinant(Coordinates(points[next], inputCells[c]), static_cast<int>(size));
      ASSERT_GT(volume, 0.) << "inverted or flat: cell " << next;
      parts.Volume += volume;
      AddFaces(parts, cells[next], points[next]);
    }
    ASSERT_EQ(parts.Volume, 1.) << "input cell " << c;
    for (const auto& facet : parts.Facets)
    {
      std::vector<Key> corners;
      for (vtkIdType v : facet.first)
      {
        corners.push_back(written.Keys[v]);
      }
      ASSERT_EQ(facet.second, Support(corners).size() == size ? 2 : 1) << "input cell " << c;
    }
    for (const auto& inside : parts.Inside)
    {
      const auto known = cuts.emplace(inside);
      ASSERT_EQ(known.first->second, inside.second)
        << "input cells " << cutBy[inside.first] << " and " << c << " cut their common face apart";
      cutBy[inside.first] = static_cast<vtkIdType>(c);
    }
    if (size > 1)
    {
      ASSERT_EQ(CountHanging(written, vertices, inputCells[c], list), 0) << "input cell " << c;
    }
  }
  ASSERT_EQ(next, cells.size());
  for (const Tuple& whole : wholes)
  {
    for (const Tuple& face : FacesOf(whole))
    {
      const auto cut = cuts.find(face);
      ASSERT_TRUE(cut == cuts.end() || cut->second == std::set<Tuple>{ face })
        << "a whole cell has a face that input cell " << cutBy[face] << " cuts";
    }
  }
}

/// What the arrays of the output say of each other.
template <typename Id>
void CheckArrays(const SimplexList& input, const Written<Id>& written)
{
  const auto inputCells = GetCells(input);
  const auto cells = GetCells(written.Cells);
  vtkIdType green = -1;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto kind = static_cast<RefinementKind>(written.Kinds[i]);
    const bool same = cells[i] == inputCells[written.InputCells[i]];
    ASSERT_EQ(kind == RefinementKind::Untouched, same);
    ASSERT_EQ(
      kind == RefinementKind::Untouched, written.Levels[i] == 0 && written.GreenParents[i] < 0);
    ASSERT_EQ(kind >= RefinementKind::GreenI, written.GreenParents[i] >= 0);
    if (written.GreenParents[i] < 0)
    {
      continue;
    }
    green = std::max(green, written.GreenParents[i]);
    ASSERT_LT(green, static_cast<vtkIdType>(written.GreenLeaves.size()));
    const auto& leaf = written.GreenLeaves[written.GreenParents[i]];
    ASSERT_GE(static_cast<vtkIdType>(i), leaf.FirstCell);
    ASSERT_LT(static_cast<vtkIdType>(i), leaf.FirstCell + leaf.NumberOfCells);
    ASSERT_EQ(leaf.Input, written.InputCells[i]);
    ASSERT_EQ(leaf.Level, written.Levels[i]);
    int split = 0;
    for (int k = 0; k < 6; ++k)
    {
      if (leaf.Midpoints[k] >= 0)
      {
        ++split;
        const auto& ends =
          leaf.Dimension == 3 ? tetrahedron::EdgeVertices[k] : triangle::EdgeVertices[k];
        ASSERT_EQ(written.Keys[leaf.Midpoints[k]],
          Middle(written.Keys[leaf.Vertices[ends[0]]], written.Keys[leaf.Vertices[ends[1]]]));
      }
    }
    const int parts[4] = { 1, 2, 4, 4 };
    ASSERT_LT(split, 4);
    ASSERT_EQ(leaf.NumberOfCells, parts[split]);
    ASSERT_EQ(static_cast<int>(kind), 1 + split);
  }
  ASSERT_EQ(green + 1, static_cast<vtkIdType>(written.GreenLeaves.size()));
}

// ---- in space ------------------------------------------------------------------------------

using Corners = std::vector<std::array<double, 3>>;

Corners GetCorners(const Tuple& cell, const std::vector<double>& points);

/// d! times the d-volume.
double Measure(const Corners& c);

/// Volume against the longest edge: between 0 and some number, whatever the size.
double Quality(const Corners& c);

inline std::array<double, 3> MiddleOf(
  const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) } };
}

inline std::array<Corners, 2> Bisect(const Corners& cell, int i, int j)
{
  std::array<Corners, 2> halves{ { cell, cell } };
  halves[0][j] = halves[1][i] = MiddleOf(cell[i], cell[j]);
  return halves;
}

/// The worst quality of a cell and its green parts.
double WorstGreen(const Corners& cell);

double WorstGreenOfDescendants(const Corners& cell, int levels);

/// Volume kept, quality bounded. Red descendants of a tetrahedron have three shapes at most, all of
/// them there after two steps.
template <typename Id>
void CheckShape(
  const SimplexList& input, const std::vector<double>& points, const Written<Id>& written)
{
  const auto inputCells = GetCells(input);
  const auto cells = GetCells(written.Cells);
  std::vector<double> volumes(inputCells.size(), 0.);
  std::vector<double> worst(inputCells.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Corners corners = GetCorners(cells[i], written.Points);
    volumes[written.InputCells[i]] += Measure(corners);
    worst[written.InputCells[i]] = std::min(worst[written.InputCells[i]], Quality(corners));
  }
  for (std::size_t c = 0; c < inputCells.size(); ++c)
  {
    const Corners corners = GetCorners(inputCells[c], points);
    const double size = Measure(corners);
    if (Quality(corners) < 1e-5)
    {
      continue; // flat to begin with: square roots of rounding errors
    }
    ASSERT_NEAR(volumes[c], size, 1e-12 * std::max(size, 1.)) << "input cell " << c;
    if (worst[c] >= Quality(corners))
    {
      continue; // nothing, or nothing bad, happened to it
    }
    ASSERT_GE(worst[c], WorstGreenOfDescendants(corners, 2) * (1. - 1e-9)) << "input cell " << c;
  }
}

}

#endif
