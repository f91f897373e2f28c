// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNestedPieces.cxx
 * Pieces of cells, the sectors of their points, and ranges of vectors.
 */
#include "BoundTools.h"

#include "Private/Bounds/Sectors.h"
#include "Private/Bounds/VectorRanges.h"

using namespace feature_tools;
using subdivision::MatrixFactors;
using subdivision::NestedPieces;
using subdivision::Sectors;
using subdivision::VectorRanges;

namespace
{

/// The pieces of a mesh, which the filter of some levels makes of `input`.
NestedPieces MakePieces(vtkDataObject* input, vtkSmartPointer<vtkPointSet>& mesh, int levels = 1,
  const Configure& configure = {})
{
  std::array<vtkIdType, NestedPieces::Steps + 1> points{};
  Grid fine;
  for (int step = 0; step <= NestedPieces::Steps; ++step)
  {
    fine = Execute(input, levels + step, configure);
    points[step] = fine->GetNumberOfPoints();
    if (step == 0)
    {
      mesh = fine;
    }
  }
  return NestedPieces(fine, points);
}

}

TEST(NestedPieces, LieInTheirCells)
{
  vtkSmartPointer<vtkPointSet> mesh;
  const Grid input = MakeRandomComplex(4);
  const NestedPieces pieces = MakePieces(input, mesh);
  ASSERT_TRUE(pieces.AreOf(mesh));
  EXPECT_FALSE(pieces.AreOf(Execute(input, 2)));
  // Midpoints without smoothing: each point is where its weights and its parents say.
  const Configure linear = [](Filter* filter) { filter->SetVolumeSchemeToLinear(); };
  const Grid fine = Execute(input, 1 + NestedPieces::Steps, linear);
  const auto getMean = [&](const vtkIdType* ids, const double* weights, int size)
  {
    Point mean{};
    for (int k = 0; k < size; ++k)
    {
      const Point p = GetPoint(fine, ids[k]);
      for (int x = 0; x < 3; ++x)
      {
        mean[x] += weights[k] * p[x];
      }
    }
    return mean;
  };
  const auto expectNear = [](const Point& a, const Point& b)
  {
    for (int x = 0; x < 3; ++x)
    {
      ASSERT_NEAR(a[x], b[x], 1e-12);
    }
  };
  for (vtkIdType c = 0; c < pieces.GetNumberOfCells(); ++c)
  {
    const int corners = pieces.GetNumberOfCorners(c);
    vtkIdType ids[4]{};
    for (int k = 0; k < corners; ++k)
    {
      ids[k] = pieces.GetCorner(c, k);
    }
    const NestedPieces::Lattice& lattice = pieces.GetLattice(c);
    EXPECT_EQ(lattice.GetNumberOfPieces(), 1 << (NestedPieces::Steps * pieces.GetDimension(c)));
    for (std::size_t i = 0; i < lattice.Points.size(); ++i)
    {
      const vtkIdType place = pieces.GetFirstPlace(c) + static_cast<vtkIdType>(i);
      expectNear(
        GetPoint(fine, pieces.GetPoint(place)), getMean(ids, lattice.Points[i].data(), corners));
    }
  }
  const double half[2] = { 0.5, 0.5 };
  for (const int step : { 2, 3 })
  {
    for (vtkIdType i = pieces.GetNumberOfPoints(step - 1); i < pieces.GetNumberOfPoints(step); ++i)
    {
      const vtkIdType* parents = pieces.GetParents(step, i);
      ASSERT_GE(parents[1], 0);
      ASSERT_LT(parents[2], 0);
      expectNear(GetPoint(fine, i), getMean(parents, half, 2));
    }
  }
}

/// Inside an octahedron all points of a level are alike: twelve edges, and six octahedra, whose
/// opposite points may lie in other quarters.
TEST(PieceLattice, OfAQuarterHasNeighboursInOthers)
{
  using subdivision::PieceLattice;
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    const PieceLattice& lattice = PieceLattice::Get(PieceLattice::FirstQuarter + quarter);
    int inside = 0;
    int others = 0;
    for (int point = 0; point < lattice.CountPoints(); ++point)
    {
      const auto place = lattice.GetPlaceInSolid(point);
      if (std::abs(place[0]) + std::abs(place[1]) + std::abs(place[2]) < PieceLattice::Divisions)
      {
        ++inside;
        const std::vector<int>& neighbours = lattice.Neighbours[point];
        EXPECT_EQ(neighbours.size(), 19U);
        others += static_cast<int>(std::count_if(neighbours.begin(), neighbours.end(),
          [&](int neighbour) { return !lattice.Has(neighbour); }));
      }
    }
    EXPECT_EQ(inside, 84);
    EXPECT_GT(others, 100);
  }
  const PieceLattice& tet = PieceLattice::Get(PieceLattice::TetOctTetrahedron);
  const int middle = tet.Find({ { 2, 2, 2 } });
  EXPECT_EQ(tet.Neighbours[middle].size(), 19U);
}

namespace
{

/// The points in the sectors of a cell at one of its corners, after three steps.
std::set<vtkIdType> FindSector(vtkDataObject* input, vtkIdType cell, vtkIdType corner)
{
  vtkSmartPointer<vtkPointSet> mesh;
  const NestedPieces pieces = MakePieces(input, mesh, 0);
  vtkNew<Filter> filter;
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(NestedPieces::Steps);
  const std::vector<MatrixFactors::Matrix> factors = bound_tools::GetLastFactors(filter.Get(), 2);
  const Sectors sectors(pieces, { &factors[0], &factors[1] });
  std::set<vtkIdType> points;
  const NestedPieces::Lattice& lattice = pieces.GetLattice(cell);
  for (std::size_t i = 0; i < lattice.Points.size(); ++i)
  {
    if (pieces.GetPoint(pieces.GetFirstPlace(cell) + static_cast<vtkIdType>(i)) == corner)
    {
      sectors.ForSector(
        cell, static_cast<int>(i),
        [&](vtkIdType place)
        {
          const vtkIdType other = sectors.GetCell(place);
          const vtkIdType first = pieces.GetFirstPlace(other);
          for (const int neighbour : pieces.GetLattice(other).Neighbours[place - first])
          {
            points.insert(pieces.GetPoint(first + neighbour));
          }
        },
        [&](vtkIdType place) { points.insert(pieces.GetPoint(place)); });
    }
  }
  return points;
}

}

TEST(Sectors, EndAtCreases)
{
  // A fan of six triangles around point 0: all of them, and those on each side of a crease.
  EXPECT_EQ(FindSector(MakeFan(6), 0, 0).size(), 7U);
  const Grid creased = MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 3 } } });
  std::vector<int> flags(static_cast<std::size_t>(creased->GetNumberOfCells()), 0);
  flags[6] = flags[7] = 1;
  AddCellArray(creased, "Singular", flags);
  std::array<std::set<vtkIdType>, 6> found;
  for (vtkIdType c = 0; c < 6; ++c)
  {
    found[c] = FindSector(creased, c, 0);
  }
  const auto count = [&](std::size_t size)
  {
    return std::count_if(
      found.begin(), found.end(), [=](const auto& f) { return f.size() == size; });
  };
  EXPECT_EQ(count(4), 2); // two triangles between creases
  EXPECT_EQ(count(6), 4); // four triangles
  // The line itself depends on creases only.
  EXPECT_EQ(FindSector(creased, 6, 0).size(), 3U);
}

TEST(Sectors, OfSolidsGoThroughFacesAndNotThroughVertices)
{
  // Two tetrahedra with a common face, and one that has a point of it only.
  const Grid grid =
    MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. }, { 0., 0., -1. },
               { -1., 0., 0.3 }, { -1., -1., 0. }, { -1., 0., -1. } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 4 } },
        { VTK_TETRA, { 0, 5, 6, 7 } } });
  EXPECT_EQ(FindSector(grid, 0, 1).size(), 5U);
  EXPECT_EQ(FindSector(grid, 0, 3).size(), 4U);
  EXPECT_EQ(FindSector(grid, 2, 5).size(), 4U);
  // The joint has the relief ring.
  EXPECT_EQ(FindSector(grid, 2, 0).size(), 8U);
}

TEST(VectorRanges, WhatIsNotFiniteIsUnknown)
{
  VectorRanges ranges(1, 1);
  const double values[2] = { 1., std::nan("") };
  ranges.Add(0, values);
  EXPECT_EQ(ranges.Get(0)[0], 1.);
  EXPECT_EQ(ranges.Get(0)[1], 1.);
  ranges.Add(0, values + 1);
  ranges.Add(0, values);
  EXPECT_EQ(ranges.Get(0)[0], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(ranges.Get(0)[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(ranges.Get(0)[2], std::numeric_limits<double>::infinity());
}

TEST(VectorRanges, AreExtendedByOthers)
{
  VectorRanges ranges(2, 2);
  const double a[2] = { 3., -4. };
  const double b[2] = { 1., 1. };
  ranges.Add(0, a);
  ranges.Add(1, b);
  ranges.Extend(1, ranges.Get(0));
  EXPECT_EQ(std::vector<double>(ranges.Get(1), ranges.Get(1) + 5),
    (std::vector<double>{ 1., -4., 3., 1., 5. }));
}
