// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridNormals.cxx
 * VolumeScheme = HYBRID: normals and tangents without the last level against those of the last
 * level, and what is kept of them.
 */
#include "HybridFilterTools.h"
#include "HybridZoo.h"

#include "vtkSMPTools.h"

using namespace hybrid_filter_tools;

namespace
{

const Configure Frames = [](Filter* filter)
{
  filter->GenerateLimitNormalsOn();
  filter->GenerateTangentsOn();
};

/// A box of all types or a fan, by its seed, without what lies at solids; materials. Some hexahedra
/// collapse.
Grid MakeSolids(unsigned int seed)
{
  const hybridtest::Mesh drawn = hybridtest::MakeRandomHybrid(seed, false);
  std::vector<Cell> cells;
  std::vector<int> materials;
  for (const hybridtest::Cell& cell : drawn.Cells)
  {
    constexpr int types[] = { 0, 0, 0, 0, VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };
    const int type = types[static_cast<int>(cell.Shape)];
    if (type > 0)
    {
      cells.push_back({ type, { cell.Corners.begin(), cell.Corners.end() } });
      materials.push_back(drawn.Points[cell.Corners[0]][0] > .5 ? 2 : 1);
    }
  }
  for (std::size_t c = 0; c < cells.size() && seed % 3 == 0; c += 3)
  {
    if (cells[c].Type == VTK_HEXAHEDRON)
    {
      const vtkIdType from = cells[c].Points[1];
      const vtkIdType to = cells[c].Points[0];
      for (Cell& cell : cells)
      {
        std::replace(cell.Points.begin(), cell.Points.end(), from, to);
      }
    }
  }
  const Grid grid = MakeGrid({ drawn.Points.begin(), drawn.Points.end() }, cells);
  AddCellArray(grid, "Material", materials);
  return grid;
}

Configure Choose(unsigned int seed)
{
  return With(
    [seed](Filter* filter)
    {
      Frames(filter);
      filter->SetModifiedBoundary(seed % 4 == 1);
      filter->SetDetectFeatures(seed % 4 >= 2);
      filter->SetFeatureAngle(seed % 4 == 2 ? 50. : 75.);
      filter->SetPreserveInterfaces(seed % 5 == 0);
      SetCellArray(filter, 1, "Material");
      filter->SetProjectToLimit(seed % 7 == 0);
    });
}

/// Collapsed cells are told.
Grid ExecuteTold(const Grid& input, int levels, const Configure& configure)
{
  vtkNew<Messages> messages;
  Grid output = Execute(input, levels, configure, messages);
  EXPECT_TRUE(messages->Errors.empty());
  return output;
}

}

/// The classification needs the last level.
TEST(HybridNormals, EqualThoseOfTheLastLevel)
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const Grid input = MakeSolids(seed);
    const Configure configure = Choose(seed);
    const int levels = input->GetNumberOfCells() < 8 ? 3 : input->GetNumberOfCells() < 20 ? 2 : 1;
    const Grid output = ExecuteTold(input, levels, configure);
    const Grid expected = ExecuteTold(input, levels,
      [&](Filter* filter)
      {
        configure(filter);
        filter->GenerateClassificationOn();
      });
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
    for (vtkIdType i = 0; i < 3 * output->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(GetPoint(output, i / 3), GetPoint(expected, i / 3));
      for (const auto& [name, tolerance] : std::map<const char*, double>{
             { "LimitNormals", 1e-8 }, { "LimitTangent1", 1e-12 }, { "LimitTangent2", 1e-12 } })
      {
        ASSERT_NEAR(output->GetPointData()->GetArray(name)->GetComponent(i / 3, i % 3),
          expected->GetPointData()->GetArray(name)->GetComponent(i / 3, i % 3), tolerance)
          << name << " of point " << i / 3;
      }
    }
  }
}

TEST(HybridNormals, ThreadsChangeNothing)
{
  for (const unsigned int seed : { 4u, 6u, 9u })
  {
    SCOPED_TRACE(seed);
    const Grid input = MakeSolids(seed);
    std::vector<Grid> made;
    for (const int threads : { 1, 2, 4 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        [&] { made.push_back(ExecuteTold(input, 2, Choose(seed))); });
      EXPECT_EQ(Compare(made.front(), made.back()), "") << threads << " threads";
    }
  }
}

TEST(HybridNormals, LevelsAreKept)
{
  for (const bool isSolid : { true, false })
  {
    SCOPED_TRACE(isSolid);
    const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
      isSolid ? std::vector<Cell>{ { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } }
              : std::vector<Cell>{ { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 0, 4, 5, 1 } } });
    const Configure smooth = With([](Filter* filter) { filter->SetNumberOfLevels(2); });
    const Configure framed = [&](Filter* filter)
    {
      smooth(filter);
      Frames(filter);
    };
    Kept filter(smooth);
    filter.Update(input);
    EXPECT_EQ(filter.CountBuilds(), 1);
    Frames(filter.Get());
    const Grid first = filter.Update(input);
    EXPECT_EQ(Compare(first, Fresh(input, framed)), "");
    const Grid turned = DeepCopy(input); // inside out
    for (vtkIdType i = 0; i < 8; ++i)
    {
      const Point p = GetPoint(input, i);
      MovePoint(turned, i, p[0] + .1 * std::sin(3. * i), p[1], -p[2]);
    }
    const Grid second = filter.Update(turned);
    EXPECT_EQ(filter.CountBuilds(), 0);
    EXPECT_EQ(Compare(second, Fresh(turned, framed)), "");
    EXPECT_TRUE(SharesCells(first, second));
  }
  // A line on a solid: its normals are those of the last level, which is made each time.
  const Grid mixed = MakeAllTypes();
  const Configure framed = With([](Filter* filter) { filter->SetNumberOfLevels(1); });
  Kept filter(framed);
  filter.Update(mixed);
  EXPECT_EQ(filter.CountBuilds(), 1);
  Frames(filter.Get());
  const Grid output = filter.Update(mixed);
  EXPECT_EQ(filter.CountBuilds(), 0);
  EXPECT_TRUE(HoldsNothing(filter.Get()));
  EXPECT_EQ(Compare(output,
              Fresh(mixed,
                [&](Filter* fresh)
                {
                  framed(fresh);
                  Frames(fresh);
                })),
    "");
}
