// SPDX-License-Identifier: BSD-3-Clause
// JoinSides: sides of one surface share the points where they touch, cracks stay.
#include "MultiDimensionalSubdivisionTools.h"

#include "Private/Control/TouchingSides.h"

#include "vtkSurfaceSubdivision.h"
#include "vtkTriangle.h"

using namespace multi_dimensional_subdivision_tools;
using subdivision::FindTouchingSides;

namespace
{

/// The points of a box in the order in which faces use them, so that joined ones have these ids.
const std::vector<Point> BoxPoints = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 1, 0, 0 },
  { 0, 0, 1.5 }, { 1, 0, 1.5 }, { 1, 1, 1.5 }, { 0, 1, 1.5 } };
const std::vector<Ids> BoxFaces = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 3, 5, 4 }, { 1, 7, 6, 2 },
  { 0, 4, 7, 1 }, { 3, 2, 6, 5 } };

/// A box whose faces share points, or have points, texture coordinates and normals of their own.
vtkSmartPointer<vtkPolyData> MakeBox(bool sharesPoints, bool hasTexture = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkFloatArray> texture;
  vtkNew<vtkFloatArray> normals;
  texture->SetName("texture");
  texture->SetNumberOfComponents(2);
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < 8 && sharesPoints; ++i)
  {
    points->InsertNextPoint(BoxPoints[i].data());
  }
  for (const Ids& face : BoxFaces)
  {
    polys->InsertNextCell(4);
    for (std::size_t k = 0; k < 4; ++k)
    {
      const auto i = static_cast<std::size_t>(face[k]);
      polys->InsertCellPoint(sharesPoints ? face[k] : points->InsertNextPoint(BoxPoints[i].data()));
      texture->InsertNextTuple2(k == 1 || k == 2, k > 1);
      normals->InsertNextTuple3(0, 0, static_cast<double>(polys->GetNumberOfCells()));
    }
  }
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(polys);
  if (hasTexture)
  {
    box->GetPointData()->SetTCoords(texture);
    box->GetPointData()->SetNormals(normals);
  }
  return box;
}

template <typename FilterClass>
std::vector<Point> FindPlaces(vtkDataObject* input,
  const std::function<void(FilterClass*)>& configure = {}, Messages* messages = nullptr)
{
  vtkNew<FilterClass> filter;
  filter->SetNumberOfLevels(2);
  if (configure)
  {
    configure(filter);
  }
  UpdateInSilence(filter, input, messages);
  std::vector<Point> places;
  vtkPointSet* output = filter->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    places.push_back(GetPoint(output, i));
    for (double& x : places.back())
    {
      x = std::round(x * 1e9) / 1e9 + 0.;
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

void Unique(std::vector<Point>& places)
{
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

const std::vector<Point> Places = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { -0., 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 }, { 2, 2, 2 }, { 0, 0, 0 }, { 1, 0, 0 },
  { 0, -3, 0 } };

std::size_t CountPairs(const std::vector<Cell>& cells)
{
  return FindTouchingSides(MakeGrid(Places, cells)).size();
}

}

TEST(TouchingSides, BoxOfSixPiecesIsOneBox)
{
  using Main = vtkMultiDimensionalSubdivision;
  using OfSurfaces = vtkSurfaceSubdivision;
  EXPECT_EQ(FindPlaces<Main>(MakeBox(false)), FindPlaces<Main>(MakeBox(true)));
  for (int scheme = OfSurfaces::LOOP; scheme <= OfSurfaces::LINEAR; ++scheme)
  {
    SCOPED_TRACE(scheme);
    const auto choose = [scheme](OfSurfaces* filter) { filter->SetScheme(scheme); };
    EXPECT_EQ(FindPlaces<OfSurfaces>(MakeBox(false), choose),
      FindPlaces<OfSurfaces>(MakeBox(true), choose));
  }
}

TEST(TouchingSides, OffTheSidesComeApart)
{
  using Main = vtkMultiDimensionalSubdivision;
  vtkNew<Messages> messages;
  const auto apart =
    FindPlaces<Main>(MakeBox(false), [](Main* filter) { filter->JoinSidesOff(); }, messages);
  EXPECT_NE(apart, FindPlaces<Main>(MakeBox(true)));
  EXPECT_EQ(messages->CountWarnings("cells that do not share points come apart there"), 1);
}

TEST(TouchingSides, TextureKeepsItsSeams)
{
  using Main = vtkMultiDimensionalSubdivision;
  for (const bool ofSurfaces : { false, true })
  {
    auto places = ofSurfaces ? FindPlaces<vtkSurfaceSubdivision>(MakeBox(false, true))
                             : FindPlaces<Main>(MakeBox(false, true));
    const std::size_t points = places.size();
    Unique(places);
    EXPECT_GT(points, places.size()); // for both values
    EXPECT_EQ(places,
      ofSurfaces ? FindPlaces<vtkSurfaceSubdivision>(MakeBox(true))
                 : FindPlaces<Main>(MakeBox(true)));
  }
  vtkNew<Main> filter;
  UpdateInSilence(filter, MakeBox(false, true));
  vtkUnstructuredGrid* output = filter->GetOutput();
  auto* texture = output->GetPointData()->GetArray("texture");
  ASSERT_TRUE(texture);
  std::array<double, 6> areas = {}; // of the texture on each face, whose children are in turn
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    double p[3][3] = {};
    for (std::size_t i = 0; i < 3; ++i)
    {
      texture->GetTuple(GetCell(output, c)[i], p[i]);
    }
    areas[static_cast<std::size_t>(6 * c / output->GetNumberOfCells())] +=
      vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  }
  for (const double area : areas)
  {
    EXPECT_NEAR(area, 0.48, 0.02); // each face has the whole texture, smoothed at its corners
  }
}

TEST(TouchingSides, FiltersThatCannotKeepBothValuesTell)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetSchemeToDooSabin();
  vtkNew<Messages> messages;
  UpdateInSilence(filter, MakeBox(false, true), messages);
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("JoinSides: sides that touch differ in \"texture\" ("), 1);
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray("texture"));
}

TEST(TouchingSides, CracksStay)
{
  const Cell tet = { VTK_TETRA, { 0, 1, 2, 3 } };
  EXPECT_EQ(CountPairs({ { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 5, 4, 8 } } }), 2u);
  EXPECT_EQ(CountPairs({ { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 1, 4, 8 } } }), 1u);
  // Solids, also where a sheet lies on one.
  EXPECT_EQ(CountPairs({ tet, { VTK_TETRA, { 5, 4, 6, 7 } } }), 0u);
  EXPECT_EQ(CountPairs({ tet, { VTK_TRIANGLE, { 4, 5, 8 } } }), 0u);
  EXPECT_EQ(CountPairs({ tet, { VTK_TRIANGLE, { 0, 1, 7 } }, { VTK_TRIANGLE, { 5, 4, 8 } } }), 0u);
  // An edge that three faces would have, and sheets that lie on each other.
  EXPECT_EQ(CountPairs({ { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 5, 4, 8 } },
              { VTK_TRIANGLE, { 9, 10, 11 } } }),
    0u);
  EXPECT_EQ(CountPairs({ { VTK_QUAD, { 0, 1, 8, 2 } }, { VTK_QUAD, { 4, 5, 8, 6 } },
              { VTK_TRIANGLE, { 0, 1, 3 } } }),
    2u); // only where the third face is not: the points 2 and 6, and 0 and 4
  // Parts that touch at a point, a face with two points at one place, and curves.
  EXPECT_EQ(CountPairs({ { VTK_TRIANGLE, { 0, 3, 8 } }, { VTK_TRIANGLE, { 4, 7, 2 } } }), 0u);
  EXPECT_EQ(CountPairs({ { VTK_QUAD, { 0, 4, 1, 3 } }, { VTK_TRIANGLE, { 5, 9, 8 } } }), 0u);
  EXPECT_EQ(CountPairs({ { VTK_LINE, { 0, 3 } }, { VTK_LINE, { 4, 7 } } }), 0u);
}

TEST(TouchingSides, MinusZeroIsZeroAndHugeMeshesAreSearchedWhole)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < 3000; ++i) // more than the smallest table has places
  {
    points.insert(
      points.end(), { { double(i), 1, 0 }, { double(i) + 0.5, 2, 0 }, { i + 1., 1, 0 } });
    cells.push_back({ VTK_TRIANGLE, { 3 * i, 3 * i + 1, 3 * i + 2 } });
  }
  EXPECT_TRUE(FindTouchingSides(MakeGrid(points, cells)).empty()); // they touch at corners
  points.insert(points.end(), { { 2999.5, 2, -0. }, { 3000, 1, -0. }, { 9, 9, 9 } });
  cells.push_back({ VTK_TRIANGLE, { 9000, 9001, 9002 } });
  const auto pairs = FindTouchingSides(MakeGrid(points, cells));
  ASSERT_EQ(pairs.size(), 2u);
}
