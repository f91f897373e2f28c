// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesMarks.cxx
 * Corners, creases and surfaces that are marked by points, a selection, a function or geometry are
 * those of flagged cells.
 */
#include "MarkTools.h"
#include "SelectionTools.h"

#include "vtkPlane.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSphere.h"
#include "vtkSurfaceSubdivision.h"

using namespace feature_tools;
using namespace selection_tools;

namespace
{

std::vector<vtkIdType> ListMarked(const std::vector<char>& marked)
{
  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i < marked.size(); ++i)
  {
    if (marked[i])
    {
      ids.push_back(static_cast<vtkIdType>(i));
    }
  }
  return ids;
}

}

TEST(FeaturesMarks, PointsAreFlaggedCells)
{
  unsigned seed = 1;
  for (const Grid& mesh : MakeMarkMeshes())
  {
    const Grid simplices = ExecuteQuietly(mesh, 0, {});
    for (const Meaning& meaning : Meanings)
    {
      SCOPED_TRACE(seed);
      const std::vector<char> marked =
        Draw(mesh->GetNumberOfPoints(), meaning.Corners ? 0.4 : 0.6, seed);
      AddMarks(mesh, marked);
      const std::vector<Cell> cells = FindMarked(mesh, simplices, marked, meaning);
      EXPECT_FALSE(cells.empty());
      const Grid flagged = AddFlagged(mesh, cells);
      for (const bool tetOct : { false, true })
      {
        const Configure scheme = [&](Filter* filter)
        {
          filter->SetVolumeScheme(tetOct);
          filter->SetGenerateClassification(true);
          filter->SetProjectToLimit(seed % 2 == 0);
        };
        const Grid made = ExecuteQuietly(mesh, 2,
          [&](Filter* filter)
          {
            scheme(filter);
            SetMarks(filter);
            SetMeaning(filter, meaning);
          });
        ExpectSame(made, ExecuteQuietly(flagged, 2, scheme));
        if (HasFatalFailure())
        {
          return;
        }
        EXPECT_EQ(made->GetPointData()->GetArray("Marks")->GetRange()[1], 0.);
      }
      ++seed;
    }
  }
}

TEST(FeaturesMarks, ChangeTheShape)
{
  const Grid mesh = MakeOctahedron();
  AddMarks(mesh, { 1, 1, 1, 0, 0, 0, 0 });
  const Matrix corners(mesh, [](Filter* filter) { SetMarks(filter); });
  EXPECT_TRUE(Near(corners.Vertex(0), Corner(0)));
  const Configure creases = [](Filter* filter)
  {
    SetMarks(filter);
    SetMeaning(filter, { false, true, false });
  };
  const Matrix crease(mesh, creases);
  EXPECT_TRUE(Near(crease.Vertex(0), CurveVertex(0, 1, 2)));
  EXPECT_TRUE(Near(crease.Edge(0, 1), CurveEdge(0, 1)));
}

TEST(FeaturesMarks, OfFiltersInARowAreThoseOfOne)
{
  for (const Grid& mesh : MakeMarkMeshes())
  {
    AddMarks(mesh, Draw(mesh->GetNumberOfPoints(), 0.6, 5));
    const Configure marking = [](Filter* filter)
    {
      SetMarks(filter);
      SetMeaning(filter, { false, true, true });
    };
    const Grid once = ExecuteQuietly(mesh, 3, marking);
    const Grid first = ExecuteQuietly(mesh, 1, marking);
    EXPECT_EQ(Compare(once, ExecuteQuietly(ExecuteQuietly(first, 1, marking), 1, marking)), "");
    EXPECT_EQ(Compare(once, ExecuteQuietly(first, 2, {})), "");
  }
}

TEST(FeaturesMarks, OfALaterFilterMakeItsInputTheControlMesh)
{
  const Grid level = ExecuteQuietly(MakeKuhnBox(2, 0.1), 1, {});
  const std::vector<char> marked = Draw(level->GetNumberOfPoints(), 0.3, 2);
  const Grid flagged = AddFlagged(level, FindMarked(level, level, marked, Meanings[3]));
  RemoveStamp(flagged);
  AddMarks(level, marked);
  const Grid made = ExecuteQuietly(level, 1,
    [](Filter* filter)
    {
      SetMarks(filter);
      SetMeaning(filter, Meanings[3]);
    });
  const Grid expected = ExecuteQuietly(flagged, 1, {});
  ASSERT_EQ(made->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType p = 0; p < level->GetNumberOfPoints(); ++p)
  {
    if (marked[p])
    {
      EXPECT_EQ(GetPoint(made, p), GetPoint(level, p));
    }
  }
}

TEST(FeaturesMarks, AreAChoiceOfTheCache)
{
  const Grid mesh = MakeKuhnBox(2, 0.1);
  vtkNew<Filter> filter;
  SetMarks(filter.Get());
  filter->SetMarkCreases(true);
  filter->SetNumberOfLevels(2);
  vtkIdType builds = 0;
  for (const unsigned seed : { 1u, 1u, 2u })
  {
    const Grid input = DeepCopy(mesh);
    AddMarks(input, Draw(mesh->GetNumberOfPoints(), 0.5, seed));
    filter->SetInputDataObject(input);
    filter->Update();
    builds += filter->GetNumberOfTopologyBuilds() > builds;
    EXPECT_EQ(Compare(filter->GetOutput(),
                ExecuteQuietly(input, 2,
                  [](Filter* fresh)
                  {
                    SetMarks(fresh);
                    fresh->SetMarkCreases(true);
                  })),
      "");
  }
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
  EXPECT_EQ(builds, 2);
}

TEST(FeaturesMarks, BySelectionOfPointsAreThoseByAnArray)
{
  for (const Grid& mesh : MakeMarkMeshes())
  {
    const std::vector<char> marked = Draw(mesh->GetNumberOfPoints(), 0.6, 7);
    const Selection selection = MakeSelection(vtkSelectionNode::POINT, ListMarked(marked));
    const Grid made = ExecuteQuietly(mesh, 2,
      [&](Filter* filter)
      {
        filter->SetInputDataObject(1, selection);
        SetMeaning(filter, Meanings[3]);
      });
    AddMarks(mesh, marked);
    const Grid byArray = ExecuteQuietly(mesh, 2,
      [&](Filter* filter)
      {
        SetMarks(filter);
        SetMeaning(filter, Meanings[3]);
      });
    byArray->GetPointData()->RemoveArray("Marks");
    EXPECT_EQ(Compare(made, byArray), "");
  }
}

TEST(FeaturesMarks, BySelectionOfCellsAreThoseByFlags)
{
  const Grid mesh = MakeMixedBox(2);
  std::vector<vtkIdType> cells;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    if (mesh->GetCell(c)->GetCellDimension() < 3 && c % 3 > 0)
    {
      cells.push_back(c);
    }
  }
  ASSERT_GT(cells.size(), 3u);
  std::vector<int> flags(mesh->GetNumberOfCells(), 0);
  for (const vtkIdType c : cells)
  {
    flags[c] = 1;
  }
  const Selection selection = MakeSelection(vtkSelectionNode::CELL, cells);
  const Configure marking = [&](Filter* filter) { filter->SetInputDataObject(1, selection); };
  const Grid made = ExecuteQuietly(mesh, 2, marking);
  ExpectSame(made, ExecuteQuietly(With(mesh, "Singular", flags), 2, {}));
  EXPECT_FALSE(made->GetCellData()->HasArray("Singular"));
  // A selection of points and one of cells together: all of both.
  selection->AddNode(MakeSelection(vtkSelectionNode::POINT, { 3 })->GetNode(0u));
  const Grid both = AddFlagged(With(mesh, "Singular", flags), { { VTK_VERTEX, { 3 } } });
  ExpectSame(ExecuteQuietly(mesh, 2, marking), ExecuteQuietly(both, 2, {}));
}

TEST(FeaturesMarks, OfSolidsAndOfNothingGiveAWarning)
{
  const Grid mesh = MakeOctahedron();
  const Selection selection = MakeSelection(vtkSelectionNode::CELL, { 2, 5 });
  vtkNew<Messages> messages;
  const Configure marking = [&](Filter* filter) { filter->SetInputDataObject(1, selection); };
  const Grid made = Execute(mesh, 1, marking, messages);
  EXPECT_EQ(Compare(made, Execute(mesh, 1)), "");
  EXPECT_EQ(messages->CountWarnings("3D cells, which cannot be singular"), 1);
  EXPECT_EQ(messages->CountWarnings("first cell 2"), 1);
  const Selection empty = MakeSelection(vtkSelectionNode::POINT, {});
  vtkNew<Messages> others;
  Execute(mesh, 1, [&](Filter* filter) { filter->SetInputDataObject(1, empty); }, others);
  EXPECT_EQ(others->CountWarnings("has no point or cell of the input"), 1);
}

TEST(FeaturesMarks, ByAFunctionAreThoseByAnArray)
{
  const Grid mesh = MakeKuhnBox(3);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0., 0., 1.);
  plane->SetNormal(0., 0., 1.);
  std::vector<char> marked;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    marked.push_back(GetPoint(mesh, p)[2] <= 1.);
  }
  vtkNew<Filter> filter;
  filter->SetInputDataObject(mesh);
  filter->SetMarkByFunction(true);
  filter->SetMarkFunction(plane);
  SetMeaning(filter.Get(), { false, false, true });
  filter->Update();
  const Grid byFunction = DeepCopy(filter->GetOutput());
  AddMarks(mesh, marked);
  const Grid byArray = ExecuteQuietly(mesh, 1,
    [](Filter* made)
    {
      SetMarks(made);
      SetMeaning(made, { false, false, true });
    });
  byArray->GetPointData()->RemoveArray("Marks");
  EXPECT_EQ(Compare(byFunction, byArray), "");
  plane->SetOrigin(0., 0., -1.);
  filter->Update(); // the function is an option
  EXPECT_NE(Compare(byFunction, filter->GetOutput()), "");
  vtkNew<Messages> messages;
  Execute(mesh, 1, [](Filter* made) { made->SetMarkByFunction(true); }, messages);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("needs a MarkFunction"), std::string::npos);
}

/// Cells on the points of a mesh in the opposite order.
static Grid MakeGeometry(vtkUnstructuredGrid* mesh, std::vector<Cell> cells)
{
  std::vector<Point> points;
  const vtkIdType size = mesh->GetNumberOfPoints();
  for (vtkIdType p = size; p-- > 0;)
  {
    points.push_back(GetPoint(mesh, p));
  }
  for (Cell& cell : cells)
  {
    for (vtkIdType& id : cell.Points)
    {
      id = size - 1 - id;
    }
  }
  const Grid geometry = MakeGrid(points, cells, VTK_FLOAT);
  if (vtkDataArray* known = mesh->GetPointData()->GetGlobalIds())
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("Ids");
    for (vtkIdType p = size; p-- > 0;)
    {
      ids->InsertNextTuple1(known->GetTuple1(p));
    }
    geometry->GetPointData()->SetGlobalIds(ids);
  }
  return geometry;
}

TEST(FeaturesMarks, ByGeometryAreFlaggedCells)
{
  for (const bool withIds : { false, true })
  {
    for (const Grid& mesh : MakeMarkMeshes())
    {
      if (withIds)
      {
        AddGlobalIds(mesh, 3);
      }
      const std::vector<char> marked = Draw(mesh->GetNumberOfPoints(), 0.6, 4);
      const std::vector<Cell> cells =
        FindMarked(mesh, ExecuteQuietly(mesh, 0, {}), marked, Meanings[3]);
      const Grid expected = ExecuteQuietly(AddFlagged(mesh, cells), 2, {});
      const auto run = [&](vtkUnstructuredGrid* geometry, bool byIds)
      {
        return ExecuteQuietly(mesh, 2,
          [&](Filter* filter)
          {
            filter->SetInputDataObject(2, geometry);
            filter->SetCreasePoints(byIds);
          });
      };
      const Grid turned = MakeGeometry(mesh, cells);
      ExpectSame(run(turned, false), expected);
      const Grid indexed = MakeGrid(std::vector<Point>(mesh->GetNumberOfPoints()), cells);
      ExpectSame(run(withIds ? turned : indexed, true), expected);
    }
  }
}

TEST(FeaturesMarks, OfGeometryBesideTheMeshGiveAWarning)
{
  const Grid mesh = MakeOctahedron();
  const Grid geometry =
    MakeGrid({ GetPoint(mesh, 0), GetPoint(mesh, 1), GetPoint(mesh, 2), { 9., 9., 9. } },
      { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 0, 3 } } });
  vtkNew<Messages> messages;
  const Grid made =
    Execute(mesh, 1, [&](Filter* filter) { filter->SetInputDataObject(2, geometry); }, messages);
  ExpectSame(made, Execute(AddFlagged(mesh, { { VTK_LINE, { 0, 1 } } }), 1));
  EXPECT_EQ(messages->CountWarnings("2 of 3 vertices, lines and triangles"), 1);
  EXPECT_EQ(messages->CountWarnings("the first in cell 1 of the geometry"), 1);
}

TEST(FeaturesMarks, OfBlocksOfGeometryWithPolyhedra)
{
  const Grid mesh = MakeOctahedron();
  const Grid line = MakeGrid({ GetPoint(mesh, 0), GetPoint(mesh, 1) }, { { VTK_LINE, { 0, 1 } } });
  const Grid solid = MakeGrid({ { 9, 0, 0 }, { 9, 1, 0 }, { 9, 0, 1 }, { 8, 0, 0 } }, {});
  const vtkIdType faces[] = { 3, 0, 1, 2, 3, 0, 3, 1, 3, 1, 3, 2, 3, 2, 3, 0 };
  solid->InsertNextCell(VTK_POLYHEDRON, 4, faces);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, solid);
  blocks->SetBlock(1, line);
  vtkNew<Messages> messages;
  const Grid made =
    Execute(mesh, 1, [&](Filter* filter) { filter->SetInputDataObject(2, blocks); }, messages);
  ExpectSame(made, Execute(AddFlagged(mesh, { { VTK_LINE, { 0, 1 } } }), 1));
}

TEST(FeaturesMarks, AreSingularInTheTopologyFilter)
{
  const Grid mesh = MakeOctahedron();
  AddMarks(mesh, { 1, 1, 1, 0, 0, 0, 0 });
  vtkNew<vtkSimplicialComplexTopology> topology;
  topology->SetInputDataObject(mesh);
  SetMarks(topology.Get());
  SetMeaning(topology.Get(), { false, true, false });
  topology->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(topology->GetOutputDataObject(0));
  vtkDataArray* singular = output->GetCellData()->GetArray("Singular");
  ASSERT_TRUE(singular);
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(output, c);
    const bool isMarked = ids.size() == 2 && ids[0] < 3 && ids[1] < 3;
    EXPECT_EQ(singular->GetComponent(c, 0) != 0., isMarked) << "cell " << c;
  }
}

TEST(FeaturesMarks, OfAMissingArrayAreAnError)
{
  vtkNew<Messages> messages;
  Execute(MakeOctahedron(), 1, [](Filter* filter) { SetMarks(filter); }, messages);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("Point array \"Marks\" (array index 8)"), std::string::npos);
}
