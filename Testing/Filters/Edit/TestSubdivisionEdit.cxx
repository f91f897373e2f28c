// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionEdit.cxx
 * vtkSubdivisionEdit moves and paints what is selected, and nothing else; the next filter goes on.
 */
#include "EditTools.h"

#include "vtkSurfaceSubdivision.h"

using namespace edit_tools;

namespace
{

/// A strip of triangles and a tetrahedron, with values.
Grid MakeMesh(int type = VTK_DOUBLE)
{
  const Grid mesh = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0.5 }, { 0, 2, 0 },
                               { 0.3, 0.3, 2 }, { 4, 4, 4 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 3, 2 } }, { VTK_TRIANGLE, { 2, 3, 4 } },
      { VTK_TETRA, { 0, 1, 2, 5 } }, { VTK_VERTEX, { 6 } } },
    type);
  mesh->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Heat", 2, 7, 1., 2., 3));
  mesh->GetPointData()->AddArray(MakeArray<vtkIntArray>("Label", 1, 7, 1., 9., 4));
  mesh->GetCellData()->AddArray(MakeArray<vtkFloatArray>("Density", 1, 5, 1., 2., 5));
  mesh->GetCellData()->AddArray(MakeArray<vtkUnsignedCharArray>("MaterialId", 1, 5, 1., 9., 6));
  return mesh;
}

std::vector<int> FindMoved(vtkPointSet* before, vtkPointSet* after)
{
  std::vector<int> moved;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    if (GetPoint(before, i) != GetPoint(after, i))
    {
      moved.push_back(static_cast<int>(i));
    }
  }
  return moved;
}

std::vector<int> FindMovedBy(vtkSelection* selection)
{
  const Grid mesh = MakeMesh();
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0., 0., 1.);
  return FindMoved(mesh, Edit(edit, mesh, selection));
}

}

TEST(SubdivisionEdit, MovesWhatIsSelected)
{
  using Ints = std::vector<int>;
  const int points = vtkSelectionNode::POINT;
  const int cells = vtkSelectionNode::CELL;
  const int indices = vtkSelectionNode::INDICES;
  EXPECT_EQ(FindMovedBy(MakeSelection(points, indices, { 1, 5 })), (Ints{ 1, 5 }));
  EXPECT_EQ(FindMovedBy(MakeSelection(cells, indices, { 2 })), (Ints{ 2, 3, 4 }));
  EXPECT_EQ(FindMovedBy(nullptr), (Ints{ 0, 1, 2, 3, 4, 5, 6 }));
  const auto inverse = MakeSelection(points, indices, { 1, 5 });
  inverse->GetNode(0u)->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  EXPECT_EQ(FindMovedBy(inverse), (Ints{ 0, 2, 3, 4, 6 }));
  // Two nodes, of points and of cells.
  const auto both = MakeSelection(points, indices, { 6 });
  both->AddNode(MakeSelection(cells, indices, { 0 })->GetNode(0u));
  EXPECT_EQ(FindMovedBy(both), (Ints{ 0, 1, 2, 6 }));
  // By the values of an array.
  const auto threshold = MakeSelection(points, vtkSelectionNode::THRESHOLDS, {});
  const Grid mesh = MakeMesh();
  vtkDataArray* labels = mesh->GetPointData()->GetArray("Label");
  vtkNew<vtkDoubleArray> range;
  range->SetName("Label");
  range->SetNumberOfComponents(2);
  range->InsertNextTuple2(labels->GetComponent(2, 0), labels->GetComponent(2, 0));
  threshold->GetNode(0u)->SetSelectionList(range);
  Ints expected;
  for (int i = 0; i < 7; ++i)
  {
    if (labels->GetComponent(i, 0) == labels->GetComponent(2, 0))
    {
      expected.push_back(i);
    }
  }
  EXPECT_EQ(FindMovedBy(threshold), expected);
}

TEST(SubdivisionEdit, TransformsAboutTheCentre)
{
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const Grid mesh = MakeMesh(type);
    vtkNew<vtkSubdivisionEdit> edit;
    edit->SetTranslation(10., 20., 30.);
    edit->SetRotation(0., 0., 90.);
    edit->SetScale(2., 3., 4.);
    edit->SetCentre(1., 1., 0.);
    const Grid moved = Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, { 3, 4 }));
    EXPECT_EQ(moved->GetPoints()->GetDataType(), type);
    for (vtkIdType i = 0; i < 7; ++i)
    {
      const Point x = GetPoint(mesh, i);
      // Scaled about (1, 1, 0), then (x, y) to (-y, x), then moved.
      const Point y = { 11. - 3. * (x[1] - 1.), 21. + 2. * (x[0] - 1.), 30. + 4. * x[2] };
      EXPECT_LT(GetDistance(GetPoint(moved, i), i == 3 || i == 4 ? y : x), 1e-12) << i;
    }
    EXPECT_EQ(GetCells(moved), GetCells(mesh));
    EXPECT_EQ(CompareArrays(mesh->GetPointData(), moved->GetPointData(), "points"), "");
    EXPECT_EQ(CompareArrays(mesh->GetCellData(), moved->GetCellData(), "cells"), "");
  }
}

TEST(SubdivisionEdit, TurnsInTheOrderOfProps)
{
  const Grid mesh = MakeMesh();
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetRotation(90., 90., 0.);
  const Grid moved = Edit(edit, mesh, nullptr);
  for (vtkIdType i = 0; i < 7; ++i)
  {
    const Point x = GetPoint(mesh, i);
    const Point y = { x[2], x[1], -x[0] }; // about y
    EXPECT_LT(GetDistance(GetPoint(moved, i), { y[0], -y[2], y[1] }), 1e-12);
  }
}

TEST(SubdivisionEdit, FadesOutInSpace)
{
  const Grid mesh =
    LoadModel(vtkSubdivisionModelSource::MATERIAL_BLOCK, vtkAlgorithm::DOUBLE_PRECISION);
  const Ids chosen = { 0, 3 };
  const std::function<double(double)> weights[] = { [](double s) { return s; },
    [](double s) { return s * s * (3. - 2. * s); }, [](double s) { return s * s; } };
  const double radius = 0.9 * mesh->GetLength() / 2.;
  for (int shape = 0; shape < 3; ++shape)
  {
    vtkNew<vtkSubdivisionEdit> edit;
    edit->SetTranslation(0., 1., 0.);
    edit->SetFalloffRadius(radius);
    edit->SetFalloffShape(shape);
    const Grid moved = Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, chosen));
    int between = 0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double nearest = VTK_DOUBLE_MAX;
      for (const vtkIdType k : chosen)
      {
        nearest = std::min(nearest, GetDistance(GetPoint(mesh, i), GetPoint(mesh, k)));
      }
      const double weight = weights[shape](std::max(0., 1. - nearest / radius));
      EXPECT_NEAR(GetPoint(moved, i)[1] - GetPoint(mesh, i)[1], weight, 1e-12);
      between += weight > 0.01 && weight < 0.99 ? 1 : 0;
    }
    EXPECT_GT(between, 5);
  }
}

TEST(SubdivisionEdit, FadesOutAlongEdges)
{
  // A curve that comes back beside its beginning.
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < 11; ++i)
  {
    points.push_back({ i < 6 ? double(i) : 10.5 - i, i < 6 ? 0. : 0.5, 0. });
    if (i > 0)
    {
      cells.push_back({ VTK_LINE, { i - 1, i } });
    }
  }
  const Grid mesh = MakeGrid(points, cells);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0., 0., 1.);
  edit->SetFalloffRadius(4.);
  edit->SetFalloffShapeToLinear();
  edit->SetFalloffAlongToEdges();
  const Grid moved = Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, { 0 }));
  for (int i = 0; i < 11; ++i)
  {
    EXPECT_NEAR(GetPoint(moved, i)[2], std::max(0., 1. - i / 4.), 1e-12) << i;
  }
  // All edges of a solid, which has no neighbours that have them too.
  const Grid tet = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (vtkIdType from = 0; from < 4; ++from)
  {
    const Grid pulled = Edit(edit, tet, MakeSelection(vtkSelectionNode::POINT, { from }));
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const double distance = GetDistance(GetPoint(tet, i), GetPoint(tet, from));
      EXPECT_NEAR(GetPoint(pulled, i)[2] - GetPoint(tet, i)[2], 1. - distance / 4., 1e-12);
    }
  }
  edit->SetFalloffAlongToSpace();
  EXPECT_GT(GetPoint(Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, { 0 })), 10)[2], 0.8);
}

TEST(SubdivisionEdit, PathsAlongEdgesAreTheShortest)
{
  const Grid mesh = MakeMixedBox(3);
  const auto size = static_cast<std::size_t>(mesh->GetNumberOfPoints());
  // All paths over edges of the mesh, cut as the first filter cuts it.
  const Grid cut = Execute(mesh, 0);
  std::vector<double> distances(static_cast<std::size_t>(cut->GetNumberOfPoints()), 1e300);
  distances[5] = distances[17] = 0.;
  const auto edges = GetEdges(cut);
  for (bool changes = true; changes;)
  {
    changes = false;
    for (const auto& [a, b] : edges)
    {
      const bool hasCentre = std::max(a, b) >= static_cast<vtkIdType>(size);
      const double length = hasCentre ? 1e300 : GetDistance(GetPoint(cut, a), GetPoint(cut, b));
      for (const auto& [from, to] : { std::pair(a, b), std::pair(b, a) })
      {
        if (distances[from] + length < distances[to] - 1e-14)
        {
          distances[to] = distances[from] + length;
          changes = true;
        }
      }
    }
  }
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(1., 0., 0.);
  edit->SetFalloffRadius(1.5);
  edit->SetFalloffShapeToLinear();
  edit->SetFalloffAlongToEdges();
  const Grid moved = Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, { 5, 17 }));
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    EXPECT_NEAR(
      GetPoint(moved, id)[0] - GetPoint(mesh, id)[0], std::max(0., 1. - distances[i] / 1.5), 1e-12);
  }
}

TEST(SubdivisionEdit, TheNextFilterGoesOn)
{
  // Creases that the first filter found, and the second one would not.
  const Grid mesh = MakeMixedBox(2);
  const auto withFeatures = [](Filter* filter)
  {
    filter->SetDetectFeatures(true);
    filter->SetFeatureAngle(40.);
  };
  const Grid two = Execute(mesh, 2, withFeatures);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0.5, -2., 3.);
  const Grid next = Execute(Edit(edit, Execute(mesh, 1, withFeatures), nullptr), 1);
  ASSERT_EQ(next->GetNumberOfPoints(), two->GetNumberOfPoints());
  EXPECT_EQ(GetCells(next), GetCells(two));
  for (vtkIdType i = 0; i < two->GetNumberOfPoints(); ++i)
  {
    const Point x = GetPoint(two, i);
    EXPECT_LT(GetDistance(GetPoint(next, i), { x[0] + 0.5, x[1] - 2., x[2] + 3. }), 1e-12) << i;
  }
}

TEST(SubdivisionEdit, TheNextSurfaceFilterGoesOn)
{
  const auto sphere = MakeSurface();
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
         vtkSurfaceSubdivision::SQRT_THREE })
  {
    const auto subdivide = [scheme](vtkDataObject* input, int levels, bool detects)
    {
      vtkNew<vtkSurfaceSubdivision> filter;
      filter->SetScheme(scheme);
      filter->SetNumberOfLevels(levels);
      filter->SetDetectFeatures(detects);
      return UpdateWithoutErrors<vtkPolyData>(filter.Get(), input);
    };
    const auto two = subdivide(sphere, 2, true);
    vtkNew<vtkSubdivisionEdit> edit;
    edit->SetTranslation(1., 0., 0.);
    edit->SetInputData(subdivide(sphere, 1, true));
    edit->Update();
    const auto next = subdivide(edit->GetOutput(), 1, false);
    ASSERT_EQ(next->GetNumberOfPoints(), two->GetNumberOfPoints());
    for (vtkIdType i = 0; i < two->GetNumberOfPoints(); ++i)
    {
      const Point x = GetPoint(two, i);
      EXPECT_LT(GetDistance(GetPoint(next, i), { x[0] + 1., x[1], x[2] }), 1e-12) << i;
    }
  }
}

TEST(SubdivisionEdit, PaintsPoints)
{
  const Grid mesh = MakeMesh();
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetFalloffRadius(1.2);
  edit->SetFalloffShapeToLinear();
  edit->SetPaintedValue(7.);
  for (const char* name : { "Heat", "Label", "New" })
  {
    edit->AddPaintedArray(name);
  }
  const Grid painted = Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, { 2 }));
  EXPECT_TRUE(FindMoved(mesh, painted).empty());
  for (vtkIdType i = 0; i < 7; ++i)
  {
    const double weight =
      std::max(0., 1. - GetDistance(GetPoint(mesh, i), GetPoint(mesh, 2)) / 1.2);
    for (int c = 0; c < 2; ++c)
    {
      const double before = mesh->GetPointData()->GetArray("Heat")->GetComponent(i, c);
      EXPECT_NEAR(painted->GetPointData()->GetArray("Heat")->GetComponent(i, c),
        before + weight * (7. - before), 1e-12);
    }
    EXPECT_EQ(painted->GetPointData()->GetArray("Label")->GetComponent(i, 0),
      i == 2 ? 7. : mesh->GetPointData()->GetArray("Label")->GetComponent(i, 0));
    EXPECT_NEAR(painted->GetPointData()->GetArray("New")->GetComponent(i, 0), 7. * weight, 1e-12);
  }
  EXPECT_EQ(painted->GetPointData()->GetArray("New")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(Compare(mesh, MakeMesh()), ""); // the input is as it was
}

TEST(SubdivisionEdit, PaintsCells)
{
  const Grid mesh = MakeMesh();
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetPaintedToCells();
  edit->SetAddedArraysToIds();
  edit->SetPaintedValue(200.);
  for (const char* name : { "MaterialId", "Singular" })
  {
    edit->AddPaintedArray(name);
  }
  const auto list = [&](const Grid& painted, const char* name)
  {
    std::vector<int> cells;
    for (vtkIdType i = 0; i < 5; ++i)
    {
      vtkDataArray* old = mesh->GetCellData()->GetArray(name);
      vtkDataArray* now = painted->GetCellData()->GetArray(name);
      if (now->GetComponent(i, 0) == 200.)
      {
        cells.push_back(static_cast<int>(i));
      }
      else
      {
        EXPECT_EQ(now->GetComponent(i, 0), old ? old->GetComponent(i, 0) : 0.);
      }
    }
    return cells;
  };
  for (const char* name : { "MaterialId", "Singular" })
  {
    EXPECT_EQ(list(Edit(edit, mesh, MakeSelection(vtkSelectionNode::CELL, { 1, 3 })), name),
      (std::vector<int>{ 1, 3 }));
    // Cells all of whose points are selected.
    EXPECT_EQ(list(Edit(edit, mesh, MakeSelection(vtkSelectionNode::POINT, { 1, 2, 3, 4 })), name),
      (std::vector<int>{ 1, 2 }));
  }
  const Grid painted = Edit(edit, mesh, MakeSelection(vtkSelectionNode::CELL, { 1 }));
  EXPECT_EQ(painted->GetCellData()->GetArray("Singular")->GetDataType(), VTK_INT);
  EXPECT_EQ(painted->GetCellData()->GetArray("MaterialId")->GetDataType(), VTK_UNSIGNED_CHAR);
}

TEST(SubdivisionEdit, PaintedNumbersOfCellsAreBlended)
{
  const Grid mesh = MakeMesh();
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetPaintedToCells();
  edit->AddPaintedArray("Sharpness");
  edit->SetPaintedValue(3.);
  edit->SetFalloffRadius(1e9);
  edit->SetFalloffShapeToLinear();
  const Grid all = Edit(edit, mesh, MakeSelection(vtkSelectionNode::CELL, { 0 }));
  EXPECT_EQ(all->GetCellData()->GetArray("Sharpness")->GetComponent(0, 0), 3.);
  EXPECT_NEAR(all->GetCellData()->GetArray("Sharpness")->GetComponent(4, 0), 3., 1e-6);
  edit->SetFalloffRadius(1e-9);
  const Grid some = Edit(edit, mesh, MakeSelection(vtkSelectionNode::CELL, { 0 }));
  EXPECT_EQ(some->GetCellData()->GetArray("Sharpness")->GetComponent(0, 0), 3.);
  EXPECT_NEAR(some->GetCellData()->GetArray("Sharpness")->GetComponent(1, 0), 2., 1e-12);
  EXPECT_EQ(some->GetCellData()->GetArray("Sharpness")->GetComponent(4, 0), 0.);
  edit->SetFalloffRadius(0.);
  const Grid one = Edit(edit, mesh, MakeSelection(vtkSelectionNode::CELL, { 0 }));
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_EQ(one->GetCellData()->GetArray("Sharpness")->GetComponent(i, 0), i == 0 ? 3. : 0.);
  }
}

TEST(SubdivisionEdit, APaintedMaterialIsAnInterface)
{
  const Grid box = Execute(MakeMixedBox(2), 0);
  const Grid solids = TakeSolids(box);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetPaintedToCells();
  edit->SetAddedArraysToIds();
  edit->AddPaintedArray("MaterialId");
  const Grid painted = Edit(edit, solids, MakeSelection(vtkSelectionNode::CELL, { 0, 1, 2 }));
  const auto preserve = [](Filter* filter) { filter->SetPreserveInterfaces(true); };
  const Grid with = Execute(painted, 1, preserve);
  const Grid without = Execute(solids, 1);
  EXPECT_FALSE(FindMoved(without, with).empty());
}

TEST(SubdivisionEdit, LeavesNormalsOutWherePointsMove)
{
  const auto sphere = MakeSurface();
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(sphere);
  filter->SetGenerateLimitNormals(true);
  filter->SetGenerateTangents(true);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetInputConnection(filter->GetOutputPort());
  edit->Update();
  const auto names = { "LimitNormals", "LimitTangent1", "LimitTangent2" };
  for (const char* name : names)
  {
    EXPECT_TRUE(GetData(edit)->GetPointData()->HasArray(name)) << name;
  }
  edit->SetScale(2., 2., 2.);
  edit->Update();
  for (const char* name : names)
  {
    EXPECT_FALSE(GetData(edit)->GetPointData()->HasArray(name)) << name;
    EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray(name)) << name;
  }
}

TEST(SubdivisionEdit, EditsBlocksByThemselves)
{
  const Grid one = MakeMesh();
  const Grid other = MakeMixedBox(1);
  const auto blocks = MakeBlocks(std::vector<Grid>{ one, other });
  const auto selection = MakeSelection(vtkSelectionNode::POINT, { 1 });
  selection->GetNode(0u)->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 2);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0., 0., 1.);
  edit->SetInputDataObject(blocks);
  Connect(edit, 1, selection);
  edit->Update();
  const auto made = GetMeshes(edit->GetOutputDataObject(0));
  ASSERT_EQ(made.size(), 2u);
  EXPECT_TRUE(FindMoved(one, made[0]).empty());
  EXPECT_EQ(FindMoved(other, made[1]), std::vector<int>{ 1 });
}

TEST(SubdivisionEdit, TellsWhatIsWrong)
{
  const Grid mesh = MakeMesh();
  mesh->GetPointData()->AddArray(MakeNames("Names", 7));
  const auto find = [&](
                      const std::function<void(vtkSubdivisionEdit*)>& set, vtkSelection* selection)
  {
    vtkNew<vtkSubdivisionEdit> edit;
    edit->SetTranslation(0., 0., 1.);
    set(edit);
    vtkNew<Messages> messages;
    messages->Watch(edit);
    edit->SetInputDataObject(mesh);
    Connect(edit, 1, selection);
    edit->Update();
    EXPECT_EQ(messages->Errors.size() + messages->Warnings.size(), 1u);
    if (!messages->Errors.empty())
    {
      EXPECT_EQ(Compare(mesh, edit->GetOutputDataObject(0)), "");
    }
    return messages->Errors.empty() ? messages->Warnings.front() : messages->Errors.front();
  };
  const auto has = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  const auto paint = [](const char* name, double value)
  {
    return [name, value](vtkSubdivisionEdit* edit)
    {
      edit->AddPaintedArray(name);
      edit->SetPaintedValue(value);
    };
  };
  EXPECT_TRUE(has(find([](vtkSubdivisionEdit*) {}, MakeSelection(vtkSelectionNode::POINT, { 99 })),
    "has no point or cell"));
  const auto faulty = MakeSelection(vtkSelectionNode::POINT, vtkSelectionNode::FRUSTUM, { 1 });
  EXPECT_TRUE(has(find([](vtkSubdivisionEdit*) {}, faulty), "cannot be used"));
  EXPECT_TRUE(has(find(paint("Names", 1.), nullptr), "has no numbers"));
  EXPECT_TRUE(has(find(paint("Label", 1.5), nullptr), "is rounded"));
  EXPECT_TRUE(has(find(paint("Label", 1e12), nullptr), "beyond the range"));
  EXPECT_TRUE(has(find(paint("New", std::nan("")), nullptr), "beyond the range"));
  const auto far = [](vtkSubdivisionEdit* edit)
  {
    edit->SetScale(1e308, 1., 1.);
    edit->SetTranslation(1.7e308, 0., 0.);
  };
  EXPECT_TRUE(has(find(far, nullptr), "would move farther"));
  const auto other = MakeMixedBox(1);
  const auto rest = [&](vtkSubdivisionEdit* edit)
  {
    edit->SetFrameToLocal();
    edit->SetInputDataObject(2, other);
  };
  EXPECT_TRUE(has(find(rest, nullptr), "The mesh at rest has"));
  const auto blocks = [&](vtkSubdivisionEdit* edit)
  {
    edit->SetFrameToLocal();
    edit->SetInputDataObject(2, MakeBlocks(std::vector<Grid>{ mesh, mesh }));
  };
  EXPECT_TRUE(has(find(blocks, nullptr), "other blocks"));
}
