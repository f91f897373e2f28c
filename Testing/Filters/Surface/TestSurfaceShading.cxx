// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceShading.cxx
 * Normals of surfaces where there is no tangent plane are those of the limit: the same on all
 * levels, whether points are projected or not.
 */
#include "SurfaceTools.h"

#include <set>

using namespace surfacetools;

namespace
{

/// The first cells of a surface, its lines, flagged or sharp for so many levels.
void AddToLines(vtkPolyData* surface, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    array->InsertNextValue(i < surface->GetNumberOfLines() ? value : 0.);
  }
  surface->GetCellData()->AddArray(array);
}

/// A sheet of 3 x 3 quads the middle one of which is cut between a vertex and two of its corners.
Model MakeDoublet(bool isHalf)
{
  Model model = MakeSheet(3, 3, false, { 1., 0., 0.2 }, { 0.1, 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(model.Points.size() + 1, 5);
  model.Corners.clear();
  const std::vector<vtkIdType> middle = model.Faces[4];
  Point centre = { 0., 0., 0. };
  for (const vtkIdType corner : middle)
  {
    for (int c = 0; c < 3; ++c)
    {
      centre[c] += model.Points[corner][c] / 4.;
    }
  }
  const auto added = static_cast<vtkIdType>(model.Points.size());
  model.Points.push_back(centre);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      model.Points[i][c] += 0.2 * noise[i][c];
    }
  }
  model.Faces.erase(model.Faces.begin() + 4);
  if (isHalf)
  {
    model.Faces.push_back({ middle[0], middle[1], added });
    model.Faces.push_back({ middle[1], middle[2], middle[3], middle[0], added });
  }
  else
  {
    model.Faces.push_back({ middle[0], middle[1], middle[2], added });
    model.Faces.push_back({ middle[2], middle[3], middle[0], added });
  }
  return model;
}

const std::vector<int> Schemes = { vtkSurfaceSubdivision::LOOP,
  vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, vtkSurfaceSubdivision::CATMULL_CLARK,
  vtkSurfaceSubdivision::FOUR_EIGHT, vtkSurfaceSubdivision::SQRT_THREE,
  vtkSurfaceSubdivision::LINEAR };

void ExpectSameOnLevels(vtkPolyData* input, const std::string& name,
  const std::function<void(vtkSurfaceSubdivision*)>& configure = nullptr)
{
  const auto size = static_cast<std::size_t>(input->GetNumberOfPoints());
  for (const int scheme : Schemes)
  {
    std::vector<Point> first;
    for (int levels = 0; levels < 4; ++levels)
    {
      for (const bool projects : { false, true })
      {
        const auto output = RunFilter(input, scheme, levels, projects,
          [&](vtkSurfaceSubdivision* filter)
          {
            configure ? configure(filter) : void();
            filter->GenerateLimitNormalsOn();
          });
        const auto normals = GetNormals(output, size);
        first = first.empty() ? normals : first;
        for (std::size_t i = 0; i < size; ++i)
        {
          // What has one side only may have the other one on another level.
          const Point& n = first[i];
          const Point opposite = { -n[0], -n[1], -n[2] };
          const double turned = name == "moebius" ? GetDistance(normals[i], opposite) : 2.;
          EXPECT_LT(std::min(GetDistance(normals[i], n), turned), 1e-7)
            << name << ", scheme " << scheme << ", level " << levels << ", point " << i;
        }
      }
    }
  }
}

}

TEST(SurfaceShading, IsTheSameOnAllLevels)
{
  for (const bool triangles : { false, true })
  {
    for (const auto& [name, model] : MakeZoo(triangles))
    {
      const auto input = MakeInput(model);
      ExpectSameOnLevels(input, name);
      if (!model.Lines.empty())
      {
        AddToLines(input, "Singular", 1.);
        ExpectSameOnLevels(input, name + ", flagged");
        ExpectSameOnLevels(input, name + ", darts",
          [](vtkSurfaceSubdivision* filter) { filter->SetCreaseEnd(vtkSurfaceSubdivision::DART); });
        ExpectSameOnLevels(input, name + ", plain",
          [](vtkSurfaceSubdivision* filter) { filter->ModifiedBoundaryOff(); });
      }
    }
  }
}

/// One normal for all faces at a point would blur what is sharp.
TEST(SurfaceShading, IsAutomaticWhereNothingIsSharp)
{
  const std::set<std::string> sharp = { "book", "bow tie", "touching tetrahedra", "crease",
    "free line", "moebius" };
  const auto run = [](vtkPolyData* input, int scheme, bool shades, bool normals)
  {
    return RunFilter(input, scheme, 2, false,
      [=](vtkSurfaceSubdivision* filter)
      {
        filter->SetSmoothShading(shades);
        filter->SetGenerateLimitNormals(normals);
      });
  };
  for (const int scheme : Schemes)
  {
    const bool isCheap =
      scheme == vtkSurfaceSubdivision::LOOP || scheme == vtkSurfaceSubdivision::CATMULL_CLARK;
    for (const auto& [name, model] : MakeZoo(scheme == vtkSurfaceSubdivision::LOOP))
    {
      const auto input = MakeInput(model);
      const auto output = run(input, scheme, true, false);
      const bool has = isCheap && sharp.count(name) == 0;
      EXPECT_EQ(output->GetPointData()->GetNormals() != nullptr, has) << name << " " << scheme;
      ExpectSameBits(output, run(input, scheme, false, has));
    }
  }
  Model sheet = MakeSheet(3, 3, false, { 1., 0., 0. }, { 0., 1., 0. });
  sheet.Points[5][2] = 1.;
  for (const bool isSharp : { false, true })
  {
    const auto output = RunFilter(MakeInput(sheet), vtkSurfaceSubdivision::CATMULL_CLARK, 1, false,
      [&](vtkSurfaceSubdivision* filter)
      {
        filter->SetDetectFeatures(isSharp);
        filter->SetFeatureAngle(20.);
      });
    EXPECT_EQ(output->GetPointData()->GetNormals() == nullptr, isSharp);
  }
}

/// Whether there are normals depends on features, which the kept levels do not know.
TEST(SurfaceShading, IsAutomaticWithACacheToo)
{
  Model sheet = MakeSheet(3, 3, false, { 1., 0., 0. }, { 0., 1., 0. });
  sheet.Points[5][2] = 1.;
  const auto input = MakeInput(sheet);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(vtkSurfaceSubdivision::CATMULL_CLARK);
  filter->SetNumberOfLevels(2);
  filter->SetFeatureAngle(20.);
  filter->CacheOperatorOn();
  for (const bool isSharp : { false, true, true, false, true })
  {
    filter->SetDetectFeatures(isSharp);
    input->GetPoints()->Modified();
    input->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals() == nullptr, isSharp);
    ExpectSameBits(filter->GetOutput(),
      RunFilter(input, vtkSurfaceSubdivision::CATMULL_CLARK, 2, false,
        [&](vtkSurfaceSubdivision* plain)
        {
          plain->SetFeatureAngle(20.);
          plain->SetDetectFeatures(isSharp);
        }));
  }
}

/// Creases that are sharp for some levels only leave the same tags as none.
TEST(SurfaceShading, IsAutomaticWithACacheOfSemiSharpLevelsToo)
{
  const auto input = MakeInput(MakeSheet(3, 3, false, { 1., 0., 0. }, { 0., 1., 0.2 }));
  const auto add = [&input](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      array->InsertNextValue(i >= 4 && i < 8 ? value : 0.);
    }
    input->GetPointData()->AddArray(array);
  };
  const auto configure = [](vtkSurfaceSubdivision* filter)
  {
    filter->SetInputArrayToProcess(8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
    filter->SetInputArrayToProcess(9, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Sharpness");
    filter->MarkCreasesOn();
    filter->MarkCornersOff();
  };
  add("Sharpness", 1.5);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(vtkSurfaceSubdivision::CATMULL_CLARK);
  filter->SetNumberOfLevels(2);
  filter->CacheOperatorOn();
  configure(filter);
  for (const bool isSharp : { true, false, true, false })
  {
    add("Marks", isSharp ? 1. : 0.);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals() == nullptr, isSharp);
    ExpectSameBits(filter->GetOutput(),
      RunFilter(input, vtkSurfaceSubdivision::CATMULL_CLARK, 2, false, configure));
  }
}

TEST(SurfaceShading, OfVerticesOfTwoFaces)
{
  for (const bool isHalf : { false, true })
  {
    ExpectSameOnLevels(MakeInput(MakeDoublet(isHalf)), isHalf ? "triangle" : "quads");
  }
}

/// Normals do not count by the size of faces or by their number, but by angle.
TEST(SurfaceShading, IsTheMeanOfTheSectorsByAngle)
{
  Model model;
  const double x = std::sqrt(0.5);
  // Two flat sheets that touch in point 0, one of 90 degrees, seen from above, and one of 45.
  model.Points = { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 3., 0. }, { 0., 0., 2. }, { -x, 0., x } };
  model.Faces = { { 0, 1, 2 }, { 0, 4, 3 } };
  const Point expected = { 0., 1. / std::sqrt(5.), 2. / std::sqrt(5.) };
  const auto output = RunFilter(MakeInput(model), vtkSurfaceSubdivision::LINEAR, 2, true);
  EXPECT_LT(GetDistance(GetNormals(output, 1)[0], expected), 1e-9);
}
