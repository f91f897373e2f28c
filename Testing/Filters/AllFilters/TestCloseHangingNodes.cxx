// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCloseHangingNodes.cxx
 * CloseHangingNodes cuts cells so that all fit: no border is left inside, and areas and volumes
 * stay.
 */
#include "HangingTools.h"
#include "PartitionTools.h"

#include "Private/Reading/HangingNodes.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkTetra.h"
#include "vtkTriangle.h"

using namespace hanging_tools;

namespace
{

double GetMeasure(vtkUnstructuredGrid* grid)
{
  double sum = 0.;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(grid, c);
    double x[4][3];
    for (std::size_t i = 0; i < ids.size() && i < 4; ++i)
    {
      grid->GetPoint(ids[i], x[i]);
    }
    sum += ids.size() == 4 ? vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3])
      : ids.size() == 3    ? vtkTriangle::TriangleArea(x[0], x[1], x[2])
                           : 0.;
  }
  return sum;
}

/// The total length or area of the parts of the border of triangles or tetrahedra.
double GetBorder(vtkUnstructuredGrid* grid)
{
  std::map<Ids, int> uses;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Ids ids = GetCell(grid, c);
    std::sort(ids.begin(), ids.end());
    for (std::size_t omitted = 0; omitted < ids.size(); ++omitted)
    {
      Ids part = ids;
      part.erase(part.begin() + static_cast<std::ptrdiff_t>(omitted));
      ++uses[part];
    }
  }
  double sum = 0.;
  for (const auto& [part, count] : uses)
  {
    double x[3][3];
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      grid->GetPoint(part[i], x[i]);
    }
    const double size = part.size() == 3
      ? vtkTriangle::TriangleArea(x[0], x[1], x[2])
      : std::hypot(x[0][0] - x[1][0], x[0][1] - x[1][1], x[0][2] - x[1][2]);
    sum += count == 1 ? size : 0.;
  }
  return sum;
}

/// That the cells fit, have the measure and border that they had, and a value that is linear.
void ExpectClosed(const Grid& grid, double measure, double border)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* x = grid->GetPoint(i);
    values->InsertNextValue(x[0] + 2. * x[1] - x[2]);
  }
  grid->GetPointData()->AddArray(values);
  const Grid closed = Execute(grid, 0, Close);
  EXPECT_NEAR(GetMeasure(closed), measure, 1e-12);
  EXPECT_NEAR(GetBorder(closed), border, 1e-12);
  for (vtkIdType i = 0; i < closed->GetNumberOfPoints(); ++i)
  {
    const double* x = closed->GetPoint(i);
    const double value = closed->GetPointData()->GetArray("values")->GetComponent(i, 0);
    EXPECT_NEAR(value, x[0] + 2. * x[1] - x[2], 1e-12);
  }
  // No crack opens: new points of the border are on that of the level before, or near.
  const Grid fine = Execute(grid, 1, Close);
  EXPECT_LT(GetBorder(fine), border + 1e-12);
}

}

TEST(CloseHangingNodes, Quadtrees)
{
  for (int depth = 1; depth < 5; ++depth)
  {
    ExpectClosed(MakeTree(VTK_QUAD, depth), 4., 8.);
  }
}

TEST(CloseHangingNodes, Octrees)
{
  for (int depth = 1; depth < 4; ++depth)
  {
    ExpectClosed(MakeTree(VTK_HEXAHEDRON, depth), 8., 24.);
    ExpectClosed(MakeTree(VTK_VOXEL, depth), 8., 24.);
  }
}

TEST(CloseHangingNodes, SeveralSizesBesideOneCube)
{
  // A cube beside 4 x 4 x 4 ones, of which some are cut once more.
  Builder builder;
  builder.AddBox(VTK_HEXAHEDRON, { 0, 0, 0 }, 1.);
  for (int i = 0; i < 64; ++i)
  {
    const Point low = { 1. + 0.25 * (i % 4), 0.25 * (i / 4 % 4), 0.25 * (i / 16) };
    if (i % 5)
    {
      builder.AddBox(VTK_HEXAHEDRON, low, 0.25);
      continue;
    }
    for (int k = 0; k < 8; ++k)
    {
      builder.AddBox(VTK_HEXAHEDRON,
        { low[0] + 0.125 * (k % 2), low[1] + 0.125 * (k / 2 % 2), low[2] + 0.125 * (k / 4) },
        0.125);
    }
  }
  ExpectClosed(builder.Make(), 2., 10.);
}

TEST(CloseHangingNodes, TrianglesAndPolygons)
{
  for (const int size : { 1, 2, 7 })
  {
    const Grid grid = MakeTJunction(size);
    const Grid closed = Execute(grid, 0, Close);
    EXPECT_EQ(closed->GetNumberOfCells(), 2 * (size + 1));
    EXPECT_NEAR(GetMeasure(closed), 0.5 + 0.5 * std::hypot(1., 0.2), 1e-12) << size;
  }
}

/// Wedges, pyramids and tetrahedra whose faces others cover.
TEST(CloseHangingNodes, OtherSolids)
{
  const Point top = { 0.5, 0.5, 2. };
  Builder builder;
  builder.Add(VTK_PYRAMID, { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, top });
  for (int i = 0; i < 4; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { 0.5 * (i % 2), 0.5 * (i / 2), 0.5 }, 0.5);
  }
  const double side = 4. * 0.5 * std::hypot(1., 0.5);
  ExpectClosed(builder.Make(), 1. / 3. + 0.5, side + 2. + 1.);
  // A wedge below a triangle that is cut in four.
  Builder other;
  const std::vector<Point> at = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 } };
  const auto down = [](Point p) { return Point{ p[0], p[1], -1. }; };
  other.Add(VTK_WEDGE, { at[0], at[1], at[2], down(at[0]), down(at[1]), down(at[2]) });
  const Point tip = { 0.5, 0.5, 1. };
  for (const auto& t : std::vector<Ids>{ { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 } })
  {
    other.Add(VTK_TETRA, { at[t[0]], at[t[1]], at[t[2]], tip });
  }
  const Grid grid = other.Make();
  const Grid closed = Execute(grid, 0, Close);
  EXPECT_NEAR(std::abs(GetMeasure(closed)), 2. + 2. / 3., 1e-12);
  EXPECT_TRUE(Tell(grid, 1, Close).empty());
}

TEST(CloseHangingNodes, CellsThatCannotBeCutAreCounted)
{
  // 2 x 2 beside 3 x 3.
  Builder builder;
  for (int i = 0; i < 4; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { -0.5, 0.5 * (i % 2), 0.5 * (i / 2) }, 0.5);
  }
  for (int i = 0; i < 9; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { 0., i % 3 / 3., i / 3 / 3. }, 1. / 3.);
  }
  EXPECT_TRUE(
    Has(Tell(builder.Make(), 1, Close), "cannot be cut so that they do (the first is cell 0)"));
}

/// A smooth surface has no crack where a mesh of quads is finer than that beside it.
TEST(CloseHangingNodes, NoCrackAfterThreeLevels)
{
  const Grid grid = MakeTree(VTK_QUAD, 2);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    x[2] = 0.1 * x[0] * (2. - x[1]); // bilinear: points in the middle of an edge stay on it
    grid->GetPoints()->SetPoint(i, x);
  }
  const Grid fine = Execute(grid, 3, Close);
  int ends = 0;
  for (const auto& [a, b] : GetEdges(fine))
  {
    int uses = 0;
    double x[2][3];
    fine->GetPoint(a, x[0]);
    fine->GetPoint(b, x[1]);
    const bool isInside =
      std::all_of(&x[0][0], &x[0][0] + 2, [](double v) { return v > 0.2 && v < 1.8; });
    for (vtkIdType c = 0; isInside && c < fine->GetNumberOfCells(); ++c)
    {
      const Ids ids = GetCell(fine, c);
      uses += std::count(ids.begin(), ids.end(), a) && std::count(ids.begin(), ids.end(), b);
    }
    ends += isInside && uses != 2;
  }
  EXPECT_EQ(ends, 0);
}

TEST(CloseHangingNodes, AcrossBlocks)
{
  const Grid whole = MakeTree(VTK_HEXAHEDRON, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const int part : { 0, 1 })
  {
    Builder builder;
    for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
    {
      std::vector<Point> places;
      for (const vtkIdType id : GetCell(whole, c))
      {
        double x[3];
        whole->GetPoint(id, x);
        places.push_back({ x[0], x[1], x[2] });
      }
      if ((c < 7) == (part == 0))
      {
        builder.Add(VTK_HEXAHEDRON, places);
      }
    }
    blocks->SetBlock(part, builder.Make());
  }
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToBoxSpline();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->SetNumberOfLevels(1);
  filter->CloseHangingNodesOn();
  filter->Update();
  EXPECT_TRUE(messages->Warnings.empty());
  const Grid expected = Execute(whole, 1, Close);
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(made->GetNumberOfCells(), expected->GetNumberOfCells());
}

/// On ranks, cells fit to those of others.
TEST(CloseHangingNodes, PartitionsHaveWhatTheWholeHas)
{
  const Grid tree = MakeTree(VTK_HEXAHEDRON, 2);
  partition_tools::NumberCells(tree);
  subdivision::UniformOptions options;
  options.Levels = 2;
  options.Warn = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Fail = options.Warn;
  subdivision::DistributionOptions distribution;
  distribution.Layers = 3;
  distribution.Change = [](vtkPointSet* mesh)
  {
    std::vector<std::string> warnings;
    auto closed = subdivision::CloseHangingNodes(mesh, warnings);
    EXPECT_TRUE(warnings.empty());
    return closed;
  };
  vtkNew<vtkUnstructuredGrid> whole;
  ASSERT_TRUE(subdivision::SubdivideUniformly(distribution.Change(tree), options, whole));
  for (const auto& partition : partition_tools::CommonPartitions)
  {
    std::vector<partition_tools::Mesh> outputs;
    ASSERT_TRUE(partition_tools::RunOnParts(
      partition_tools::Cut(tree, partition), partition, distribution, options,
      [&](vtkPointSet* mesh, vtkPointSet* made)
      {
        return subdivision::SubdivideUniformly(
          mesh, options, vtkUnstructuredGrid::SafeDownCast(made));
      },
      outputs));
    SCOPED_TRACE(partition.Name);
    partition_tools::ExpectWhole(whole, outputs);
  }
}
