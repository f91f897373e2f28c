// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceMarks.cxx
 * Corners, creases and faces of surfaces that are marked are those of flagged cells.
 */
#include "SelectionTools.h"
#include "SurfaceTools.h"

using namespace surfacetools;

namespace
{

/// Schemes with creases.
constexpr int Schemes[] = { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
  vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, vtkSurfaceSubdivision::SQRT_THREE,
  vtkSurfaceSubdivision::FOUR_EIGHT };

bool NeedsTriangles(int scheme)
{
  return scheme != vtkSurfaceSubdivision::CATMULL_CLARK &&
    scheme != vtkSurfaceSubdivision::FOUR_EIGHT;
}

Model MakeBumps(bool triangles)
{
  Model model = MakeSheet(6, 5, triangles, { 1., 0., 0. }, { 0.2, 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(model.Points.size(), 3);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    model.Points[i][2] += noise[i][2];
  }
  return model;
}

vtkSmartPointer<vtkPolyData> MakeMarked(const Model& model, const std::vector<int>& marked)
{
  const auto input = MakeInput(model);
  vtkNew<vtkIntArray> marks;
  marks->SetName("Marks");
  for (const int mark : marked)
  {
    marks->InsertNextValue(mark);
  }
  input->GetPointData()->AddArray(marks);
  return input;
}

void SetMarks(vtkSurfaceSubdivision* filter)
{
  filter->SetInputArrayToProcess(8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
}

/// The points and all faces are equal, bit for bit.
void ExpectSamePoints(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType p = 0; p < a->GetNumberOfPoints(); ++p)
  {
    Point x;
    Point y;
    a->GetPoint(p, x.data());
    b->GetPoint(p, y.data());
    ASSERT_EQ(x, y) << "point " << p;
  }
  ASSERT_EQ(a->GetNumberOfPolys(), b->GetNumberOfPolys());
}

/// With flagged vertices and lines.
vtkSmartPointer<vtkPolyData> MakeFlagged(Model model, const std::vector<vtkIdType>& corners,
  const Polygons& lines, const std::set<std::size_t>& faces)
{
  model.Lines = lines;
  const auto input = MakeInput(model);
  vtkNew<vtkCellArray> vertices;
  for (const vtkIdType corner : corners)
  {
    vertices->InsertNextCell(1, &corner);
  }
  input->SetVerts(vertices);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  const std::size_t first = corners.size() + lines.size();
  for (std::size_t c = 0; c < first + model.Faces.size(); ++c)
  {
    flags->InsertNextValue(c < first || faces.count(c - first) > 0);
  }
  input->GetCellData()->AddArray(flags);
  return input;
}

}

TEST(SurfaceMarks, PointsAreFlaggedCells)
{
  for (const int scheme : Schemes)
  {
    SCOPED_TRACE(scheme);
    const Model model = MakeBumps(NeedsTriangles(scheme));
    std::mt19937 random(5);
    std::vector<int> marked;
    for (std::size_t p = 0; p < model.Points.size(); ++p)
    {
      marked.push_back(random() % 5 < 3);
    }
    std::vector<vtkIdType> corners;
    std::set<std::vector<vtkIdType>> lines;
    std::set<std::size_t> faces;
    for (std::size_t p = 0; p < marked.size(); ++p)
    {
      if (marked[p])
      {
        corners.push_back(static_cast<vtkIdType>(p));
      }
    }
    for (std::size_t f = 0; f < model.Faces.size(); ++f)
    {
      const auto& face = model.Faces[f];
      bool all = true;
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const vtkIdType a = face[i];
        const vtkIdType b = face[(i + 1) % face.size()];
        all = all && marked[a];
        if (marked[a] && marked[b])
        {
          lines.insert({ std::min(a, b), std::max(a, b) });
        }
      }
      if (all)
      {
        faces.insert(f);
      }
    }
    ASSERT_FALSE(faces.empty());
    const auto run = [&](bool byCorners, bool byCreases, bool bySurfaces)
    {
      return RunFilter(MakeMarked(model, marked), scheme, 2, false,
        [=](vtkSurfaceSubdivision* filter)
        {
          SetMarks(filter);
          filter->SetMarkCorners(byCorners);
          filter->SetMarkCreases(byCreases);
          filter->SetMarkSurfaces(bySurfaces);
        });
    };
    ExpectSamePoints(
      run(true, false, false), RunFilter(MakeFlagged(model, corners, {}, {}), scheme, 2));
    ExpectSamePoints(run(false, true, false),
      RunFilter(MakeFlagged(model, {}, Polygons(lines.begin(), lines.end()), {}), scheme, 2));
    ExpectSamePoints(
      run(false, false, true), RunFilter(MakeFlagged(model, {}, {}, faces), scheme, 2));
  }
}

TEST(SurfaceMarks, OfFiltersInARowAreThoseOfOne)
{
  for (const int scheme : Schemes)
  {
    SCOPED_TRACE(scheme);
    const Model model = MakeBumps(NeedsTriangles(scheme));
    std::vector<int> marked(model.Points.size(), 0);
    for (std::size_t p = 0; p < marked.size(); p += 2)
    {
      marked[p] = 1;
      marked[p + 1] = p % 4 == 0;
    }
    const auto marking = [](vtkSurfaceSubdivision* filter)
    {
      SetMarks(filter);
      filter->SetMarkCreases(true);
      filter->SetMarkCorners(false);
    };
    const auto once = RunFilter(MakeMarked(model, marked), scheme, 3, false, marking);
    const auto first = RunFilter(MakeMarked(model, marked), scheme, 1, false, marking);
    ExpectSameBits(once, RunFilter(first, scheme, 2, false, marking));
    ExpectSameBits(once, RunFilter(first, scheme, 2));
  }
}

TEST(SurfaceMarks, BySelectionAreThoseByAnArray)
{
  const Model model = MakeBumps(false);
  std::vector<int> marked(model.Points.size(), 0);
  const std::vector<vtkIdType> ids{ 8, 9, 10, 17, 24 };
  const auto selection = selection_tools::MakeSelection(vtkSelectionNode::POINT, ids);
  for (const vtkIdType p : ids)
  {
    marked[p] = 1;
  }
  const int scheme = vtkSurfaceSubdivision::CATMULL_CLARK;
  const auto bySelection = RunFilter(MakeMarked(model, marked), scheme, 2, true,
    [&](vtkSurfaceSubdivision* filter)
    {
      filter->SetInputDataObject(1, selection);
      filter->SetMarkCreases(true);
    });
  const auto byArray = RunFilter(MakeMarked(model, marked), scheme, 2, true,
    [](vtkSurfaceSubdivision* filter)
    {
      SetMarks(filter);
      filter->SetMarkCreases(true);
    });
  ExpectSamePoints(bySelection, byArray);
  EXPECT_FALSE(bySelection->GetPointData()->HasArray("SubdivisionMarked"));
  EXPECT_FALSE(bySelection->GetCellData()->HasArray("SubdivisionMarked"));
  const auto plain = RunFilter(MakeMarked(model, marked), scheme, 2, true);
  Point a;
  Point b;
  byArray->GetPoint(9, a.data());
  plain->GetPoint(9, b.data());
  EXPECT_GT(GetDistance(a, b), 1e-3);
}

TEST(SurfaceMarks, ByGeometryAreFlaggedLines)
{
  const Model model = MakeBumps(true);
  const Polygons lines = { { 8, 9 }, { 9, 10 }, { 10, 17 } };
  Model creases = model;
  creases.Faces.clear();
  creases.Lines = lines;
  const int scheme = vtkSurfaceSubdivision::LOOP;
  const auto geometry = MakeInput(creases);
  ExpectSamePoints(RunFilter(MakeInput(model), scheme, 2, false, [&](vtkSurfaceSubdivision* filter)
                     { filter->SetInputDataObject(2, geometry); }),
    RunFilter(MakeFlagged(model, {}, lines, {}), scheme, 2));
}

TEST(SurfaceMarks, StaySharpForSomeLevelsAsLinesDo)
{
  for (const int scheme : { static_cast<int>(vtkSurfaceSubdivision::LOOP),
         static_cast<int>(vtkSurfaceSubdivision::CATMULL_CLARK) })
  {
    const Model model = MakeBumps(NeedsTriangles(scheme));
    std::vector<int> marked(model.Points.size(), 0);
    vtkNew<vtkDoubleArray> levels;
    levels->SetName("Levels");
    for (std::size_t p = 0; p < marked.size(); ++p)
    {
      levels->InsertNextValue(p == 17 ? 0.75 : 1.5);
    }
    const Polygons lines = { { 8, 9 }, { 9, 10 }, { 10, 17 } };
    for (const int p : { 8, 9, 10, 17 })
    {
      marked[p] = 1;
    }
    const auto input = MakeMarked(model, marked);
    input->GetPointData()->AddArray(levels);
    const auto marking = [](vtkSurfaceSubdivision* filter)
    {
      SetMarks(filter);
      filter->SetInputArrayToProcess(9, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Levels");
      filter->SetMarkCorners(false);
      filter->SetMarkCreases(true);
    };
    const auto flagged = MakeFlagged(model, {}, lines, {});
    flagged->GetCellData()->RemoveArray("Singular");
    vtkNew<vtkDoubleArray> sharpness;
    sharpness->SetName("Sharpness");
    for (vtkIdType c = 0; c < flagged->GetNumberOfCells(); ++c)
    {
      sharpness->InsertNextValue(c == 2 ? 0.75 : c < 2 ? 1.5 : 0.);
    }
    flagged->GetCellData()->AddArray(sharpness);
    const auto once = RunFilter(input, scheme, 3, false, marking);
    ExpectSamePoints(once,
      RunFilter(flagged, scheme, 3, false,
        [](vtkSurfaceSubdivision* filter)
        {
          filter->SetInputArrayToProcess(
            4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
        }));
    const auto first = RunFilter(input, scheme, 1, false, marking);
    ExpectSameBits(once, RunFilter(first, scheme, 2));
    ExpectSameBits(once, RunFilter(first, scheme, 2, false, marking));
  }
}
