// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCurvedFilters.cxx
 * Curved cells of red-green refinement and of labels: nodes are those of the uniform filter, and
 * cells fit together, also where a refined cell meets its neighbours.
 */
#include "CurvedTools.h"
#include "LabelTools.h"
#include "RedGreenRefinementTools.h"

#include "vtkSubdivisionModelSource.h"

#include <numeric>

using namespace red_green_refinement_tools;

namespace
{

Grid Project(vtkDataObject* input, int levels, int cells = 0, int order = 2)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(levels);
  filter->ProjectToLimitOn();
  filter->SetOutputCells(cells);
  filter->SetCellOrder(order);
  filter->Update();
  return filter->GetOutput();
}

/// Quadratic cells for order 0, else Lagrange cells.
void SetOrder(Filter* filter, int order)
{
  filter->SetOutputCells(order == 0 ? Filter::QUADRATIC_CELLS : Filter::LAGRANGE_CELLS);
  filter->SetCellOrder(order == 0 ? 2 : order);
}

/// A box of upright tetrahedra. The array V has the coordinates: it follows the same rules, and no
/// repair moves it.
Grid MakeMarkedBox(int most)
{
  const Grid box = MakeBox(1);
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(box, i));
  }
  for (vtkIdType c = 0; c < box->GetNumberOfCells(); ++c)
  {
    cells.push_back({ box->GetCellType(c), GetCell(box, c) });
    if (GetSignedVolume(box, cells.back().Points) < 0.)
    {
      std::swap(cells.back().Points[0], cells.back().Points[1]);
    }
  }
  const Grid input = MakeGrid(points, cells);
  vtkNew<vtkDoubleArray> values;
  values->SetName("V");
  values->SetNumberOfComponents(3);
  for (const Point& p : points)
  {
    values->InsertNextTuple(p.data());
  }
  input->GetPointData()->AddArray(values);
  AddWantedLevels(input, most, 5);
  return input;
}

/// The largest distance of V at a node from the nearest at some points of another grid.
double FindFarthest(
  vtkUnstructuredGrid* from, const Ids& nodes, vtkUnstructuredGrid* to, const Ids& all)
{
  vtkDataArray* own = from->GetPointData()->GetArray("V");
  vtkDataArray* others = to->GetPointData()->GetArray("V");
  double most = 0.;
  for (const vtkIdType node : nodes)
  {
    double p[3];
    double q[3];
    own->GetTuple(node, p);
    double least = 1e300;
    for (const vtkIdType other : all)
    {
      others->GetTuple(other, q);
      least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
    most = std::max(most, least);
  }
  return most;
}

Ids ListPoints(vtkUnstructuredGrid* grid)
{
  Ids all(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  std::iota(all.begin(), all.end(), vtkIdType(0));
  return all;
}

Grid RefineCurved(vtkDataObject* input, int most, int order, bool toLimit, int scheme = 0)
{
  return Refine(
    input,
    [&](Filter* filter)
    {
      filter->RefineByWantedLevelOn();
      filter->SetMaximumLevel(most);
      filter->SetPlacement(toLimit ? Filter::LIMIT : Filter::LINEAR);
      filter->SetVolumeScheme(scheme);
      filter->SetRefineByCurvature(scheme > 0); // of nothing, but octahedra are read for the limit
      filter->SetMaximumAngle(180.);
      SetOrder(filter, order);
    },
    vtkNew<Messages>());
}

/// The places of points in a mesh that has them.
void FindPlaces(vtkUnstructuredGrid* mesh, vtkDataArray* points, place_tools::Places& places)
{
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    double p[3];
    points->GetTuple(i, p);
    bool isFound = false;
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells() && !isFound; ++c)
    {
      int part = 0;
      Point at;
      double distance = 0.;
      double weights[4];
      mesh->GetCell(c)->EvaluatePosition(p, nullptr, part, at.data(), distance, weights);
      isFound = *std::min_element(weights, weights + 4) > -1e-12;
      std::for_each(at.begin(), at.end(), [](double& x) { x = std::max(x, 0.); });
      isFound ? places.Add(c, at) : void();
    }
    ASSERT_TRUE(isFound) << i;
  }
}

}

TEST(CurvedFilters, EverythingMarkedIsTheUniformFilter)
{
  const Grid input = MakeMarkedBox(1);
  for (const int order : { 0, 1, 2, 3, 4, 5, 6 })
  {
    for (const int levels : { 0, 1 })
    {
      const Grid made = HalveAll(
        input, levels,
        [order](Filter* filter)
        {
          filter->SetPlacementToLimit();
          SetOrder(filter, order);
        },
        vtkNew<Messages>());
      const Grid uniform = Project(input, levels, order == 0 ? 2 : 3, order == 0 ? 2 : order);
      ASSERT_EQ(made->GetNumberOfCells(), uniform->GetNumberOfCells());
      for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c)
      {
        EXPECT_LE(FindFarthest(made, GetCell(made, c), uniform, GetCell(uniform, c)), 1e-12) << c;
      }
      EXPECT_EQ(made->GetNumberOfPoints(), uniform->GetNumberOfPoints());
      EXPECT_EQ(made->GetCellType(0), uniform->GetCellType(0));
      EXPECT_NE(made->GetCellData()->GetArray("ScaledJacobian"), nullptr);
      EXPECT_NE(made->GetCellData()->GetArray("RefinementLevel"), nullptr);
      EXPECT_EQ(made->GetFieldData()->GetAbstractArray("Subdivision"), nullptr);
    }
  }
}

/// Green cells share the nodes of their neighbours, and all nodes are limits of finer levels.
TEST(CurvedFilters, GreenCellsFit)
{
  constexpr int most = 2;
  const Grid input = MakeMarkedBox(most);
  for (const int order : { 0, 4 })
  {
    const Grid made = RefineCurved(input, most, order, true);
    EXPECT_GT(CountKind(made, 2) + CountKind(made, 3) + CountKind(made, 4), 0);
    curved_tools::ExpectConforming(made);
    curved_tools::ExpectVtkOrder(made);
    const Grid fine = Project(input, most + (order == 0 ? 1 : 2));
    EXPECT_LE(FindFarthest(made, ListPoints(made), fine, ListPoints(fine)), 1e-12);
    const Grid straight = RefineCurved(input, most, order, false);
    curved_tools::ExpectConforming(straight);
    vtkDataArray* scaled = straight->GetCellData()->GetArray("ScaledJacobian");
    EXPECT_NEAR(scaled->GetRange()[0], 1., 1e-9);
    for (vtkIdType i = 0; i < straight->GetNumberOfPoints(); ++i)
    {
      double p[3];
      straight->GetPointData()->GetArray("V")->GetTuple(i, p);
      const Point q = GetPoint(straight, i);
      EXPECT_NEAR(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 0., 1e-15);
    }
  }
}

/// Nodes of all orders, in octahedra too, are what EvaluateLimit has at their places.
TEST(CurvedFilters, NodesAreLimitsAtTheirPlaces)
{
  for (const int scheme : { 0, 1 })
  {
    const int most = 2 - scheme;
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetVolumeScheme(scheme);
    Grid input = MakeMarkedBox(most);
    if (scheme == 1)
    {
      vtkNew<vtkMultiDimensionalSubdivision> level;
      level->SetVolumeScheme(scheme);
      level->SetNumberOfLevels(1);
      level->SetInputDataObject(input);
      level->Update();
      input = level->GetOutput();
    }
    filter->SetInputDataObject(input);
    for (const int order : { 3, 5 * (1 - scheme) })
    {
      const Grid made = RefineCurved(input, most, order, true, scheme);
      const Grid straight = RefineCurved(input, most, order, false, scheme);
      ASSERT_GT(CountKind(made, 2) + CountKind(made, 3) + CountKind(made, 4), 0);
      curved_tools::ExpectConforming(made);
      curved_tools::ExpectVtkOrder(made);
      ASSERT_EQ(made->GetNumberOfPoints(), straight->GetNumberOfPoints());
      place_tools::Places places;
      FindPlaces(input, straight->GetPointData()->GetArray("V"), places);
      const auto limit = place_tools::Evaluate(filter, places);
      vtkDataArray* expected = limit->GetPointData()->GetArray("V");
      vtkDataArray* found = made->GetPointData()->GetArray("V");
      double worst = 0.;
      for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          worst =
            std::max(worst, std::abs(expected->GetComponent(i, k) - found->GetComponent(i, k)));
        }
      }
      EXPECT_LE(worst, 1e-12) << scheme << " " << order;
    }
  }
}

/// Triangles, lines and tetrahedra in one mesh, with blocks and without.
TEST(CurvedFilters, MixedMeshesAndBlocks)
{
  vtkNew<vtkSubdivisionModelSource> model;
  model->SetModelToSpringAndValve();
  model->Update();
  int order = 0;
  const auto configure = [&order](Filter* filter)
  {
    filter->RefineByCurvatureOn();
    filter->SetMaximumAngle(30.);
    filter->SetMaximumLevel(order == 0 ? 2 : 1);
    filter->SetPlacementToLimit();
    SetOrder(filter, order);
  };
  for (order = 0; order <= 3; order += 3)
  {
    const Grid whole = Refine(model->GetOutput(), configure, vtkNew<Messages>());
    ASSERT_GT(whole->GetNumberOfCells(), 0);
    curved_tools::ExpectConforming(whole);
    std::set<int> types;
    for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
    {
      types.insert(whole->GetCellType(c));
    }
    EXPECT_GT(types.size(), 1u);
    if (order > 0) // Ranks.ranks_curved has these in blocks
    {
      continue;
    }
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, model->GetOutput());
    vtkNew<Filter> filter;
    configure(filter);
    filter->RefineByAttributeErrorOff();
    filter->SetInputDataObject(blocks);
    filter->Update();
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(made, nullptr);
    auto* block = vtkUnstructuredGrid::SafeDownCast(made->GetBlock(0));
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(block->GetNumberOfCells(), whole->GetNumberOfCells());
    EXPECT_EQ(block->GetNumberOfPoints(), whole->GetNumberOfPoints());
  }
}

/// Blocks share the nodes that are repaired, with solids, faces and lines in either.
TEST(CurvedFilters, BlocksAreRepairedAsTheWhole)
{
  using Uniform = vtkMultiDimensionalSubdivision;
  vtkNew<vtkSubdivisionModelSource> model;
  model->SetModelToMixedDimensions();
  model->Update();
  vtkUnstructuredGrid* given = model->GetOutput();
  vtkNew<vtkMultiBlockDataSet> blocks;
  std::vector<Point> allPoints; // in the order of blocks, as sums are
  std::vector<Cell> allCells;
  std::map<vtkIdType, vtkIdType> allNumbers;
  for (vtkIdType b = 0; b < 3; ++b)
  {
    std::vector<Point> points;
    std::vector<Cell> cells;
    std::map<vtkIdType, vtkIdType> numbers;
    for (vtkIdType c = b; c < given->GetNumberOfCells(); c += 3)
    {
      Ids ids = GetCell(given, c);
      allCells.push_back({ given->GetCellType(c), {} });
      for (vtkIdType& id : ids)
      {
        const auto next = static_cast<vtkIdType>(allPoints.size());
        const auto found = allNumbers.emplace(id, next);
        found.second ? allPoints.push_back(GetPoint(given, id)) : void();
        allCells.back().Points.push_back(found.first->second);
        const auto entry = numbers.emplace(id, static_cast<vtkIdType>(points.size()));
        entry.second ? points.push_back(GetPoint(given, id)) : void();
        id = entry.first->second;
      }
      cells.push_back({ given->GetCellType(c), ids });
    }
    blocks->SetBlock(static_cast<unsigned int>(b), MakeGrid(points, cells));
  }
  const auto run = [](vtkDataObject* input, Messages* messages)
  {
    vtkNew<Uniform> filter;
    messages->Watch(filter);
    filter->SetInputDataObject(input);
    filter->SetNumberOfLevels(0);
    filter->SetOutputCellsToQuadratic();
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    return vtkSmartPointer<vtkDataObject>(filter->GetOutputDataObject(0));
  };
  vtkNew<Messages> ofWhole;
  vtkNew<Messages> ofBlocks;
  const auto whole = run(MakeGrid(allPoints, allCells), ofWhole);
  const auto made = run(blocks, ofBlocks);
  EXPECT_EQ(ofWhole->CountWarnings("nodes of them went back"), 1);
  EXPECT_EQ(ofBlocks->CountWarnings("nodes of them went back"), 1);
  EXPECT_EQ(ofBlocks->CountWarnings(" of block "), 1);
  const auto list = [](vtkDataObject* grid, std::set<Point>& places)
  {
    auto* curved = vtkUnstructuredGrid::SafeDownCast(grid);
    EXPECT_EQ(curved->GetCellData()->GetArray("Valid")->GetRange()[0], 1.);
    for (vtkIdType i = 0; i < curved->GetNumberOfPoints(); ++i)
    {
      places.insert(GetPoint(curved, i));
    }
  };
  std::set<Point> expected;
  std::set<Point> found;
  list(whole, expected);
  for (unsigned int b = 0; b < 3; ++b)
  {
    list(vtkMultiBlockDataSet::SafeDownCast(made)->GetBlock(b), found);
  }
  EXPECT_EQ(found, expected);
}

/// Where values jump between materials nodes of green cells are doubled, too.
TEST(CurvedFilters, NodesAreDoubledWhereValuesJump)
{
  const Grid input = MakeMarkedBox(2);
  vtkNew<vtkDoubleArray> density;
  density->SetName("Density");
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(static_cast<int>(c % 2));
    density->InsertNextValue(static_cast<double>(3 + c % 2));
  }
  input->GetCellData()->AddArray(density);
  input->GetCellData()->AddArray(materials);
  for (const int order : { 0, 3, 4 })
  {
    for (const bool toLimit : { true, false })
    {
      const Grid made = Refine(
        input,
        [&](Filter* filter)
        {
          filter->RefineByWantedLevelOn();
          filter->SetMaximumLevel(2);
          filter->SetPlacement(toLimit ? Filter::LIMIT : Filter::LINEAR);
          filter->PreserveInterfacesOn();
          filter->SetInterfaceValuesToDiscontinuous();
          filter->AddFieldOfCells("Density");
          SetOrder(filter, order);
        },
        vtkNew<Messages>());
      vtkDataArray* values = made->GetPointData()->GetArray("Density");
      ASSERT_NE(values, nullptr);
      std::set<Point> places;
      for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
      {
        places.insert(GetPoint(made, i));
      }
      EXPECT_LT(places.size(), static_cast<std::size_t>(made->GetNumberOfPoints()));
      for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c)
      {
        const double own = made->GetCellData()->GetArray("Density")->GetComponent(c, 0);
        for (const vtkIdType node : GetCell(made, c))
        {
          ASSERT_NEAR(values->GetComponent(node, 0), own, 1e-12) << c;
        }
      }
    }
  }
}

/// Two materials: nodes of interfaces are shared, corners are the linear solid, labels are kept.
TEST(CurvedFilters, LabelsAsCurvedCells)
{
  const auto image = label_tools::MakeImage(
    { 4, 4, 4 }, [](int i, int j, int k) { return i + j + k > 8 ? 0
                                             : i < 2            ? 1
                                                                : 2; });
  for (const bool hexahedra : { false, true })
  {
    for (const int levels : { 0, 1 })
    {
      label_tools::Made made;
      made->SetCellType(hexahedra ? 1 : 0);
      made->SetNumberOfLevels(levels);
      made->SetNumberOfControlCells(0);
      Grid linear = Grid::New();
      linear->DeepCopy(made.Run(image));
      made->SetOutputCellsToQuadratic();
      vtkUnstructuredGrid* curved = made.Run(image);
      EXPECT_TRUE(made.Heard->Errors.empty());
      ASSERT_EQ(curved->GetNumberOfCells(), linear->GetNumberOfCells());
      EXPECT_EQ(curved->GetCellType(0), hexahedra ? VTK_QUADRATIC_HEXAHEDRON : VTK_QUADRATIC_TETRA);
      curved_tools::ExpectConforming(curved);
      vtkDataArray* valid = curved->GetCellData()->GetArray("Valid");
      ASSERT_NE(valid, nullptr);
      EXPECT_STREQ(curved->GetCellData()->GetScalars()->GetName(), "Tissue");
      for (vtkIdType c = 0; c < curved->GetNumberOfCells(); ++c)
      {
        EXPECT_EQ(valid->GetComponent(c, 0), 1.);
        EXPECT_EQ(curved->GetCellData()->GetScalars()->GetComponent(c, 0),
          linear->GetCellData()->GetScalars()->GetComponent(c, 0));
        const Ids corners = GetCell(linear, c);
        const Ids nodes = GetCell(curved, c);
        for (std::size_t k = 0; k < corners.size(); ++k)
        {
          const Point a = GetPoint(linear, corners[k]);
          const Point b = GetPoint(curved, nodes[k]);
          ASSERT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0., 1e-8)
            << c; // a system is solved
        }
      }
    }
  }
}
