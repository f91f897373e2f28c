// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLocalFrames.cxx
 * Subdivide, edit in local frames, subdivide: the fine edit follows the control mesh.
 */
#include "EditTools.h"

#include "vtkTransform.h"

using namespace edit_tools;

namespace
{

using Map = vtkSmartPointer<vtkTransform>;

Map MakeSimilarity()
{
  auto map = Map::New();
  map->Translate(3., -2., 0.7);
  map->RotateWXYZ(71., 0.3, -1., 0.55);
  map->Scale(1.7, 1.7, 1.7);
  return map;
}

Grid Apply(vtkTransform* map, vtkPointSet* mesh)
{
  const auto moved = Grid::New();
  moved->DeepCopy(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    moved->GetPoints()->SetPoint(i, map->TransformPoint(GetPoint(mesh, i).data()));
  }
  return moved;
}

double FindLargest(vtkPointSet* a, vtkPointSet* b)
{
  EXPECT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  double largest = 0.;
  for (vtkIdType i = 0; i < std::min(a->GetNumberOfPoints(), b->GetNumberOfPoints()); ++i)
  {
    largest = std::max(largest, GetDistance(GetPoint(a, i), GetPoint(b, i)));
  }
  return largest;
}

struct Case
{
  std::string Name;
  Grid Mesh;
  Ids Selected; ///< of level 1; empty: all
};

Grid MakeGridOf(vtkPolyData* surface)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(surface, i));
  }
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(c, ids);
    cells.push_back({ VTK_TRIANGLE, Ids(ids->begin(), ids->end()) });
  }
  return MakeGrid(points, cells);
}

Grid MakeCurve()
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < 7; ++i)
  {
    const double angle = 2. * vtkMath::Pi() * i / 7.;
    points.push_back(
      { std::cos(angle), std::sin(angle) * (1. + 0.1 * i), 0.3 * std::cos(2 * angle) });
    cells.push_back({ VTK_LINE, { i, (i + 1) % 7 } });
  }
  return MakeGrid(points, cells);
}

Grid MakeQuads()
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1.2, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
                    { 1, 1, 1.4 }, { 0, 1, 1 } },
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 4, 5, 6, 7 } }, { VTK_QUAD, { 0, 1, 5, 4 } },
      { VTK_QUAD, { 1, 2, 6, 5 } }, { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_QUAD, { 3, 0, 4, 7 } } });
}

std::vector<Case> MakeCases()
{
  return { { "surface", MakeGridOf(MakeSurface()), { 3, 20, 21, 40 } },
    { "quads", MakeQuads(), { 0, 9, 14 } },
    { "solid", LoadModel(vtkSubdivisionModelSource::MATERIAL_BLOCK, vtkAlgorithm::DOUBLE_PRECISION),
      {} },
    { "curve", MakeCurve(), { 2, 3, 9 } } };
}

Grid SubdivideOnce(const Case& one, vtkUnstructuredGrid* mesh, bool withFrames)
{
  return Execute(mesh, 1,
    [&](Filter* filter)
    {
      filter->SetGenerateLimitNormals(withFrames);
      filter->SetGenerateTangents(withFrames);
      if (one.Name == "quads")
      {
        filter->SetVolumeSchemeToAutomatic();
      }
    });
}

Grid FindLimit(const Case& one, vtkUnstructuredGrid* mesh)
{
  return Execute(mesh, 1,
    [&](Filter* filter)
    {
      filter->SetProjectToLimit(true);
      if (one.Name == "quads")
      {
        filter->SetVolumeSchemeToAutomatic();
      }
    });
}

void SetEdit(vtkSubdivisionEdit* edit)
{
  edit->SetTranslation(0.1, 0.2, -0.15);
  edit->SetRotation(20., 5., -12.);
  edit->SetScale(1.1, 0.9, 1.3);
  edit->SetCentre(0.1, 0.2, 0.3);
  edit->SetFalloffRadius(0.6);
}

Selection Select(const Case& one)
{
  return one.Selected.empty() ? nullptr : MakeSelection(vtkSelectionNode::POINT, one.Selected);
}

}

TEST(LocalFrames, DetailTurnsAndScalesWithTheControlMesh)
{
  const Map map = MakeSimilarity();
  for (const Case& one : MakeCases())
  {
    for (const bool withFrames : { false, true })
    {
      vtkNew<vtkSubdivisionEdit> edit;
      SetEdit(edit);
      edit->SetFrameToLocal();
      const Grid rest = SubdivideOnce(one, one.Mesh, withFrames);
      const Grid moved = SubdivideOnce(one, Apply(map, one.Mesh), withFrames);
      const Grid atRest = FindLimit(one, Edit(edit, rest, Select(one), rest));
      const Grid after = FindLimit(one, Edit(edit, moved, Select(one), rest));
      EXPECT_LT(FindLargest(Apply(map, atRest), after), 1e-10) << one.Name << " " << withFrames;
      // At rest local and world are the same, and something moves.
      edit->SetFrameToWorld();
      const Grid world = FindLimit(one, Edit(edit, rest, Select(one)));
      EXPECT_LT(FindLargest(world, atRest), 1e-12) << one.Name;
      EXPECT_GT(FindLargest(atRest, FindLimit(one, rest)), 0.02) << one.Name;
      const Grid other = FindLimit(one, Edit(edit, moved, Select(one)));
      EXPECT_GT(FindLargest(Apply(map, atRest), other), 0.02) << one.Name;
    }
  }
}

TEST(LocalFrames, WithoutAMeshAtRestLengthsAreEdges)
{
  const Map map = MakeSimilarity();
  for (const Case& one : MakeCases())
  {
    if (one.Name == "solid")
    {
      continue; // points inside move along the axes of the world
    }
    vtkNew<vtkSubdivisionEdit> edit;
    edit->SetTranslation(0.1, 0.2, 0.4);
    edit->SetFalloffRadius(1.5);
    edit->SetFrameToLocal();
    const Grid rest = SubdivideOnce(one, one.Mesh, false);
    const Grid moved = SubdivideOnce(one, Apply(map, one.Mesh), false);
    const Grid atRest = FindLimit(one, Edit(edit, rest, Select(one)));
    const Grid after = FindLimit(one, Edit(edit, moved, Select(one)));
    EXPECT_LT(FindLargest(Apply(map, atRest), after), 1e-10) << one.Name;
    EXPECT_GT(FindLargest(atRest, FindLimit(one, rest)), 0.02) << one.Name;
  }
}

TEST(LocalFrames, ATranslationAlongTheNormalIsALength)
{
  const Grid mesh = MakeGridOf(MakeSurface());
  const Grid framed =
    Execute(mesh, 1, [](Filter* filter) { filter->SetGenerateLimitNormals(true); });
  const vtkIdType chosen = 12;
  double sum = 0.;
  int count = 0;
  for (const auto& [a, b] : GetEdges(framed))
  {
    if (a == chosen || b == chosen)
    {
      // Each edge has two triangles, which count alike.
      sum += GetDistance(GetPoint(framed, a), GetPoint(framed, b));
      ++count;
    }
  }
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0., 0., 2.);
  edit->SetFrameToLocal();
  const Grid moved = Edit(edit, framed, MakeSelection(vtkSelectionNode::POINT, { chosen }));
  for (vtkIdType i = 0; i < framed->GetNumberOfPoints(); ++i)
  {
    Point expected = GetPoint(framed, i);
    const Point normal = GetTuple(framed, "LimitNormals", i);
    for (int c = 0; i == chosen && c < 3; ++c)
    {
      expected[c] += 2. * sum / count * normal[c];
    }
    EXPECT_LT(GetDistance(GetPoint(moved, i), expected), 1e-12) << i;
  }
}

TEST(LocalFrames, InsideSolidsAndAlongSurfacesAnyLinearMapIsFollowed)
{
  const Grid mesh =
    LoadModel(vtkSubdivisionModelSource::MATERIAL_BLOCK, vtkAlgorithm::DOUBLE_PRECISION);
  auto map = Map::New();
  map->RotateX(40.);
  map->Scale(1., 2., 0.7);
  map->RotateZ(25.);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0.1, 0.2, 0.3);
  edit->SetFrameToLocal();
  const Grid framed =
    Execute(mesh, 0, [](Filter* filter) { filter->SetGenerateLimitNormals(true); });
  const Grid moved = Apply(map, mesh);
  const Grid after = Edit(edit, moved, nullptr, mesh);
  int inside = 0;
  int along = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Point shifted = GetPoint(mesh, i);
    for (int c = 0; c < 3; ++c)
    {
      shifted[c] += 0.1 * (c + 1);
    }
    Point expected;
    map->TransformPoint(shifted.data(), expected.data());
    const Point normal = GetTuple(framed, "LimitNormals", i);
    const bool isInside = normal == Point{ 0., 0., 0. };
    // The tangent plane follows any map, the normal only similarities.
    const double across = normal[0] * 0.1 + normal[1] * 0.2 + normal[2] * 0.3;
    inside += isInside ? 1 : 0;
    along += !isInside && std::abs(across) < 1e-12 ? 1 : 0;
    EXPECT_EQ(GetDistance(GetPoint(after, i), expected) < 1e-11, std::abs(across) < 1e-12) << i;
  }
  EXPECT_GT(along, 0);
  EXPECT_GT(inside, 0);
}

TEST(LocalFrames, StraightCurvesTurnByTheLeast)
{
  const Grid mesh = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },
    { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 2, 3 } } });
  auto map = Map::New();
  map->RotateZ(90.);
  map->Scale(2., 2., 2.);
  vtkNew<vtkSubdivisionEdit> edit;
  edit->SetTranslation(0.1, 0.2, 0.3);
  edit->SetFrameToLocal();
  const Grid after = Edit(edit, Apply(map, mesh), nullptr, mesh);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    // Ends are corners, which move as in the world.
    const bool isEnd = i == 0 || i == 3;
    const Point expected =
      isEnd ? Point{ 0.1, 2. * i + 0.2, 0.3 } : Point{ -0.4, 2. * i + 0.2, 0.6 };
    EXPECT_LT(GetDistance(GetPoint(after, i), expected), 1e-12) << i;
  }
}

TEST(LocalFrames, ThreadsMakeTheSameBits)
{
  const Grid mesh = Execute(MakeMixedBox(3), 3);
  const Grid moved = Apply(MakeSimilarity(), mesh);
  for (const bool alongEdges : { false, true })
  {
    const auto make = [&]
    {
      vtkNew<vtkSubdivisionEdit> edit;
      SetEdit(edit);
      edit->SetFrameToLocal();
      edit->SetFalloffAlong(alongEdges ? 1 : 0);
      edit->AddPaintedArray("Painted");
      return Edit(edit, moved, MakeSelection(vtkSelectionNode::CELL, { 3, 50, 700 }), mesh);
    };
    EXPECT_GT(MakeInThreads(make)->GetNumberOfPoints(), 8192);
  }
}
