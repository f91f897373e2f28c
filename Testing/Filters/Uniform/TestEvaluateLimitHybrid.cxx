// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEvaluateLimitHybrid.cxx
 * The limit at places of cells that keep their types, by the parameters of VTK's cells.
 */
#include "HybridFilterTools.h"
#include "PlaceTools.h"

#include "vtkGenericCell.h"

using namespace hybrid_filter_tools;
using namespace place_tools;

namespace
{

vtkSmartPointer<vtkPolyData> EvaluateIn(
  vtkDataObject* input, const Places& places, const Configure& configure = Hybrid)
{
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  configure(filter);
  return Evaluate(filter.Get(), places);
}

/// The error of one place.
std::string FindError(vtkDataObject* input, vtkIdType cell, const std::array<double, 3>& at)
{
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(input);
  Hybrid(filter);
  Places places;
  places.Add(cell, at);
  vtkNew<vtkPolyData> result;
  EXPECT_FALSE(filter->EvaluateLimit(places.Cells, places.Parameters, result));
  return messages->Errors.empty() ? std::string() : messages->Errors[0];
}

}

/// The parameters of VTK's corners give the limits of the points, by HYBRID and by the default.
TEST(EvaluateLimitHybrid, CornersOfAllTypes)
{
  const Grid input = MakeAllTypes();
  const Grid limit = Execute(input, 0, With([](Filter* filter) { filter->ProjectToLimitOn(); }));
  Places places;
  std::vector<vtkIdType> points;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    input->GetCell(c, cell);
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      const double* at = cell->GetParametricCoords() + 3 * i;
      places.Add(c, { at[0], at[1], at[2] });
      points.push_back(cell->GetPointId(static_cast<int>(i)));
    }
  }
  for (const bool isDefault : { false, true })
  {
    const auto result = EvaluateIn(input, places, [isDefault](Filter* filter)
      { isDefault ? filter->SetVolumeSchemeToAutomatic() : filter->SetVolumeSchemeToHybrid(); });
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(result->GetPoint(i)[k], GetPoint(limit, points[i])[k], 1e-12) << i;
      }
    }
  }
}

/// A sphere of quads: places are Catmull-Clark's, with their normals and curvatures.
TEST(EvaluateLimitHybrid, QuadsAreCatmullClark)
{
  const Grid quads = MakeGrid({ { 0, 0, 0 }, { 1, 0, .2 }, { 1, 1, 0 }, { 0, 1, .1 }, { 0, 0, 1 },
                                { 1, 0, 1.3 }, { 1, 1, 1 }, { -.1, 1, 1 } },
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 4, 5, 6, 7 } }, { VTK_QUAD, { 0, 1, 5, 4 } },
      { VTK_QUAD, { 1, 2, 6, 5 } }, { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_QUAD, { 3, 0, 4, 7 } } });
  Places places;
  for (vtkIdType c = 0; c < 6; ++c)
  {
    places.Add(c, { .3, .6, 0. });
    places.Add(c, { .05, .9, 0. });
  }
  const auto result = EvaluateIn(quads, places);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(quads->GetPoints());
  surface->SetPolys(quads->GetCells());
  vtkNew<vtkSurfaceSubdivision> catmullClark;
  catmullClark->SetInputData(surface);
  catmullClark->SetSchemeToCatmullClark();
  const auto expected = Evaluate(catmullClark.Get(), places);
  for (const char* name : { "LimitNormals", "MeanCurvature", "GaussianCurvature", "DerivativeU" })
  {
    vtkDataArray* a = result->GetPointData()->GetArray(name);
    vtkDataArray* b = expected->GetPointData()->GetArray(name);
    ASSERT_TRUE(a && b) << name;
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      for (int k = 0; k < a->GetNumberOfComponents(); ++k)
      {
        EXPECT_NEAR(a->GetComponent(i, k), b->GetComponent(i, k), 1e-9) << name << i;
      }
    }
  }
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(result->GetPoint(i)[k], expected->GetPoint(i)[k], 1e-13);
    }
  }
}

/// Octahedra that a filter wrote in tetrahedra have places in these.
TEST(EvaluateLimitHybrid, PiecesOfOctahedra)
{
  const Grid tet = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Grid input = Execute(tet, 1, Hybrid);
  ASSERT_EQ(input->GetNumberOfCells(), 8);
  const Grid limit = Execute(input, 0, With([](Filter* filter) { filter->ProjectToLimitOn(); }));
  Places places;
  for (vtkIdType c = 0; c < 8; ++c)
  {
    for (const auto& at : std::vector<Point>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } })
    {
      places.Add(c, at);
    }
  }
  const auto result = EvaluateIn(input, places);
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    const vtkIdType point = input->GetCell(i / 4)->GetPointId(static_cast<int>(i % 4));
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(result->GetPoint(i)[k], GetPoint(limit, point)[k], 1e-12) << i;
    }
  }
}

TEST(EvaluateLimitHybrid, Errors)
{
  const Grid cube = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                               { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
      { VTK_HEXAHEDRON, { 0, 1, 1, 0, 4, 5, 6, 7 } } });
  const auto has = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(FindError(cube, 2, { .5, .5, .5 }), "no such cell"));
  EXPECT_TRUE(has(FindError(cube, 0, { .5, 1.5, .5 }), "outside of it"));
  EXPECT_TRUE(has(FindError(cube, 1, { .5, .5, .5 }), "is no cell of its own"));
}
