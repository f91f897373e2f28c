// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceShading.cxx
 * Normals of surfaces where there is no tangent plane are those of the limit: the same on all
 * levels, whether points are projected or not.
 */
#include "SurfaceTools.h"

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
