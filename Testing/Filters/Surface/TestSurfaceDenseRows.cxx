// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceDenseRows.cxx
 * Where a scheme computes k new points from k neighbours each, many neighbours are an error before
 * any work, which says where they are and what helps.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "SurfaceTools.h"

#include "Core/Rules/Pi.h"

using namespace surfacetools;

namespace
{

constexpr int Many = 20001; // 400,040,001 values, just above the bound

/// The filter's first error, if any; that of the pipeline comes after it.
std::string FindError(
  const Model& model, int scheme, int levels,
  const std::function<void(vtkSurfaceSubdivision*)>& set = [](vtkSurfaceSubdivision*) {})
{
  vtkNew<vtkSurfaceSubdivision> filter;
  vtkNew<multi_dimensional_subdivision_tools::Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(MakeInput(model));
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  set(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells() == 0, !messages->Errors.empty());
  return messages->Errors.empty() ? "no error" : messages->Errors[0];
}

/// Triangles around point 3, after cells and points that have nothing to do with them.
Model MakeLateFan(int n)
{
  Model model;
  model.Points = { { 0., 0., 9. }, { 1., 0., 9. }, { 0., 1., 9. }, { 0., 0., 1. } };
  model.Faces = { { 0, 1, 2 } };
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2. * Pi * i / n;
    model.Points.push_back({ std::cos(angle), std::sin(angle), 0. });
    model.Faces.push_back({ 3, 4 + i, 4 + (i + 1) % n });
  }
  return model;
}

Model MakePolygon(int n)
{
  Model model = MakeLateFan(n);
  model.Faces.resize(2);
  model.Faces[1].clear();
  for (int i = 0; i < n; ++i)
  {
    model.Faces[1].push_back(4 + i);
  }
  return model;
}

void ExpectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

}

TEST(SurfaceDenseRows, ButterflyAtAVertexOfManyFaces)
{
  const std::string error =
    FindError(MakeLateFan(Many), vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, 1);
  ExpectHas(error, "Point 3 has 20001 faces around it");
  ExpectHas(error, "400040001 values, above 400000000");
  ExpectHas(error, "Take the scheme Loop or SqrtThree");
}

TEST(SurfaceDenseRows, ButterflyCountsNormalsToo)
{
  const Model fan = MakeLateFan(7000);
  const auto normals = [](vtkSurfaceSubdivision* filter) { filter->GenerateLimitNormalsOn(); };
  ExpectHas(
    FindError(fan, vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, 1, normals), "539000000 values");
}

TEST(SurfaceDenseRows, DooSabinInAPolygonOfManyCorners)
{
  const std::string error = FindError(MakePolygon(Many), vtkSurfaceSubdivision::DOO_SABIN, 1);
  ExpectHas(error, "Cell 1 has 20001 corners");
  ExpectHas(error, "Take the scheme CatmullClark or Midedge, or cut the cell");
}

/// The first level makes faces of vertices, the second is the first to compute points of them.
TEST(SurfaceDenseRows, DooSabinAtAVertexFromTheSecondLevelOn)
{
  const Model fan = MakeLateFan(Many);
  EXPECT_EQ(FindError(fan, vtkSurfaceSubdivision::DOO_SABIN, 1), "no error");
  ExpectHas(
    FindError(fan, vtkSurfaceSubdivision::DOO_SABIN, 2), "Point 3 has 20001 faces around it");
}

TEST(SurfaceDenseRows, LimitsOfDooSabin)
{
  const auto limit = [](vtkSurfaceSubdivision* filter) { filter->ProjectToLimitOn(); };
  const auto normals = [](vtkSurfaceSubdivision* filter) { filter->GenerateLimitNormalsOn(); };
  constexpr int scheme = vtkSurfaceSubdivision::DOO_SABIN;
  EXPECT_EQ(FindError(MakeLateFan(Many), scheme, 0, limit), "no error");
  const std::string error = FindError(MakeLateFan(12000), scheme, 1, limit);
  ExpectHas(error, "Point 3 has 12000 faces around it");
  ExpectHas(error, "576000000 values");
  ExpectHas(FindError(MakePolygon(12000), scheme, 1, limit), "Cell 1 has 12000 corners");
  ExpectHas(FindError(MakeLateFan(8000), scheme, 1, normals), "512000000 values");
  EXPECT_EQ(FindError(MakeLateFan(2000), scheme, 1, normals), "no error");
}

TEST(SurfaceDenseRows, LimitsOfFourEight)
{
  const auto limit = [](vtkSurfaceSubdivision* filter) { filter->ProjectToLimitOn(); };
  const auto all = [](vtkSurfaceSubdivision* filter)
  {
    filter->ProjectToLimitOn();
    filter->GenerateTangentsOn();
  };
  for (const int levels : { 0, 1 })
  {
    const std::string error =
      FindError(MakeLateFan(Many), vtkSurfaceSubdivision::FOUR_EIGHT, levels, limit);
    ExpectHas(error, "Point 3 has 20001 faces around it");
    ExpectHas(error, "2000200005 values");
    ExpectHas(error, "Take the scheme CatmullClark or Midedge, or cut the faces");
  }
  ExpectHas(FindError(MakePolygon(8000), vtkSurfaceSubdivision::FOUR_EIGHT, 1, all),
    "Cell 1 has 8000 corners");
  EXPECT_EQ(FindError(MakeLateFan(2000), vtkSurfaceSubdivision::FOUR_EIGHT, 1, all), "no error");
  EXPECT_EQ(FindError(MakePolygon(2000), vtkSurfaceSubdivision::FOUR_EIGHT, 1, all), "no error");
}

TEST(SurfaceDenseRows, OtherSchemesTakeThem)
{
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::LINEAR; ++scheme)
  {
    SCOPED_TRACE(scheme);
    if (scheme != vtkSurfaceSubdivision::MODIFIED_BUTTERFLY)
    {
      EXPECT_EQ(FindError(MakeLateFan(Many), scheme, 1), "no error");
    }
    if (scheme != vtkSurfaceSubdivision::DOO_SABIN)
    {
      EXPECT_EQ(FindError(MakePolygon(Many), scheme, 1), "no error");
    }
  }
}
