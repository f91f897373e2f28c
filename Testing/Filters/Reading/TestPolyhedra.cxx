// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPolyhedra.cxx
 * Polyhedra and prisms of five and six sides are cut from their centre, and fit to their
 * neighbours.
 */
#include "FeatureTools.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkExtractDimensions.h"

using namespace feature_tools;

TEST(Polyhedra, PolyhedraFitToTheirNeighbours)
{
  // A box as a polyhedron, a hexahedron on its side, and a quad between them.
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
               { 1, 1, 1 }, { 0, 1, 1 }, { 2, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 2, 1, 1 } },
      {});
  grid->Allocate(4);
  const vtkIdType faces[] = { 4, 0, 4, 7, 3, 4, 1, 2, 6, 5, 4, 0, 1, 5, 4, 4, 3, 7, 6, 2, 4, 0, 3,
    2, 1, 4, 4, 5, 6, 7 };
  grid->InsertNextCell(VTK_POLYHEDRON, 6, faces);
  const vtkIdType hexahedron[] = { 1, 8, 9, 2, 5, 10, 11, 6 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
  const vtkIdType quad[] = { 1, 2, 6, 5 };
  grid->InsertNextCell(VTK_QUAD, 4, quad);
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Values", 1, grid->GetNumberOfPoints(), 0, 1, 7));
  const Grid result = Execute(grid, 0);
  ASSERT_EQ(result->GetNumberOfCells(), 12 + 6 + 2);
  EXPECT_EQ(result->GetNumberOfPoints(), 13);
  double volume = 0;
  std::map<std::set<vtkIdType>, int> count;
  for (vtkIdType c = 0; c < 18; ++c)
  {
    const Ids tet = GetCell(result, c);
    EXPECT_GT(GetSignedVolume(result, tet), 0);
    volume += GetSignedVolume(result, tet);
    for (int left = 0; left < 4; ++left)
    {
      std::set<vtkIdType> face(tet.begin(), tet.end());
      face.erase(tet[left]);
      ++count[face];
    }
  }
  EXPECT_NEAR(volume, 2, 1e-12);
  EXPECT_EQ(
    std::count_if(count.begin(), count.end(), [](const auto& f) { return f.second == 1; }), 20)
    << "the faces of a box of two cubes";
  for (vtkIdType c = 18; c < 20; ++c)
  {
    const Ids triangle = GetCell(result, c);
    EXPECT_EQ(count[std::set<vtkIdType>(triangle.begin(), triangle.end())], 2);
  }
  // The centre has the mean of the values.
  double sum = 0;
  vtkDataArray* values = result->GetPointData()->GetArray("Values");
  for (int i = 0; i < 8; ++i)
  {
    sum += values->GetComponent(i, 0) / 8;
  }
  EXPECT_NEAR(values->GetComponent(12, 0), sum, 1e-12);
}

TEST(Polyhedra, PrismsAreCutLikePolygons)
{
  for (const int n : { 5, 6 })
  {
    std::vector<Point> points;
    Ids ids;
    Ids face;
    double area = 0;
    for (int layer = 0; layer < 2; ++layer)
    {
      for (int i = 0; i < n; ++i)
      {
        const double angle = 6.283185307179586 * i / n;
        points.push_back(
          { 2 * std::cos(angle), std::sin(angle) + .3 * std::cos(angle), 1. * layer });
        ids.push_back(layer * n + i);
      }
    }
    for (int i = 0; i < n; ++i)
    {
      const Point& a = points[i];
      const Point& b = points[(i + 1) % n];
      area += (a[0] * b[1] - a[1] * b[0]) / 2;
      face.push_back(n + (i + 2) % n); // the top, with another start
    }
    const Grid grid = MakeGrid(points,
      { { n == 5 ? VTK_PENTAGONAL_PRISM : VTK_HEXAGONAL_PRISM, ids }, { VTK_POLYGON, face } });
    const Grid result = Execute(grid, 0);
    ASSERT_EQ(result->GetNumberOfCells(), 2 * (n - 2) + 2 * n + n - 2);
    double volume = 0;
    std::set<std::set<vtkIdType>> tops;
    for (vtkIdType c = 0; c < result->GetNumberOfCells(); ++c)
    {
      Ids cell = GetCell(result, c);
      if (cell.size() == 4)
      {
        EXPECT_GT(GetSignedVolume(result, cell), 0);
        volume += GetSignedVolume(result, cell);
        cell.erase(cell.begin()); // the centre
        tops.insert(std::set<vtkIdType>(cell.begin(), cell.end()));
      }
      else
      {
        EXPECT_TRUE(tops.count(std::set<vtkIdType>(cell.begin(), cell.end())));
      }
    }
    EXPECT_NEAR(volume, area, 1e-12);
  }
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) // later ones store faces in another way

/// Locations and counts of faces come from a file, and so may be anything.
TEST(Polyhedra, FacesThatLeadNowhere)
{
  constexpr vtkIdType huge = std::numeric_limits<vtkIdType>::max();
  const Ids tetrahedron = { 4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3 };
  auto make = [](const Ids& values)
  {
    vtkNew<vtkIdTypeArray> array;
    for (vtkIdType value : values)
    {
      array->InsertNextValue(value);
    }
    return vtkSmartPointer<vtkIdTypeArray>(array);
  };
  auto run = [&](const Ids& locations, const Ids& faces)
  {
    const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, {});
    vtkNew<vtkUnsignedCharArray> types;
    types->InsertNextValue(VTK_POLYHEDRON);
    types->InsertNextValue(VTK_POLYHEDRON);
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[4] = { 0, 1, 2, 3 };
    cells->InsertNextCell(4, corners);
    cells->InsertNextCell(4, corners);
    grid->SetCells(types, cells, make(locations), make(faces));
    vtkNew<vtkExtractDimensions> extract;
    extract->SetInputData(grid);
    extract->Update();
    vtkNew<Messages> messages;
    const Grid result = Execute(grid, 0, {}, messages);
    for (const std::string& warning : messages->Warnings)
    {
      EXPECT_NE(warning.find("cell 1, type 42"), std::string::npos) << warning;
    }
    EXPECT_LE(messages->Warnings.size(), 1U);
    return std::make_pair(result->GetNumberOfCells(), messages->Warnings.size());
  };
  const auto both = run({ 0, 0 }, tetrahedron);
  EXPECT_EQ(both.second, 0U);
  EXPECT_GT(both.first, 0);
  for (const Ids& locations : std::vector<Ids>{ { 0 }, { 0, -1 }, { 0, 17 }, { 0, huge } })
  {
    const auto one = run(locations, tetrahedron);
    EXPECT_EQ(one.second, 1U);
    EXPECT_EQ(one.first, both.first / 2);
  }
  for (const Ids& second : std::vector<Ids>{ { huge, 3, 0, 1, 2 }, { 2, 3, 0, 1, 2 },
         { 1, huge, 0, 1, 2 }, { 1, 4, 0, 1, 2 }, { -1 }, { 1, -1 }, { 0 } })
  {
    Ids faces = tetrahedron;
    faces.insert(faces.end(), second.begin(), second.end());
    const auto one = run({ 0, static_cast<vtkIdType>(tetrahedron.size()) }, faces);
    EXPECT_EQ(one.second, 1U);
    EXPECT_EQ(one.first, both.first / 2);
  }
}

#endif
