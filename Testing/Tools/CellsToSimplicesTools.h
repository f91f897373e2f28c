// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellsToSimplicesTools.h
 * Meshes written down as lists, and what the tests of CellsToSimplices ask of a result.
 */
#ifndef SubdivisionObjects_CellsToSimplicesTools_h
#define SubdivisionObjects_CellsToSimplicesTools_h

#include "Private/Reading/CellsToSimplices.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace cells_to_simplices_tools
{

using subdivision::CellsToSimplices;
using subdivision::SimplicesOfCells;
using Point = std::array<double, 3>;
using Ids = std::vector<vtkIdType>;
using Face = std::array<vtkIdType, 3>;

struct Cell
{
  int Type;
  Ids Points;
};

struct Mesh
{
  std::vector<Point> Points;
  std::vector<Cell> Cells;
};

inline vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkCellArray> cells;
  for (const Cell& cell : mesh.Cells)
  {
    types->InsertNextValue(static_cast<unsigned char>(cell.Type));
    cells->InsertNextCell(static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(types, cells);
  return grid;
}

inline SimplicesOfCells Convert(const Mesh& mesh)
{
  return CellsToSimplices(MakeGrid(mesh), nullptr);
}

inline std::vector<Ids> GetSimplices(const SimplicesOfCells& result)
{
  std::vector<Ids> simplices;
  auto at = result.Simplices.Connectivity.begin();
  for (const unsigned char dimension : result.Simplices.Dimensions)
  {
    simplices.emplace_back(at, at + dimension + 1);
    at += dimension + 1;
  }
  EXPECT_TRUE(at == result.Simplices.Connectivity.end());
  return simplices;
}

inline std::vector<Point> AddCentres(std::vector<Point> points, const SimplicesOfCells& result)
{
  for (vtkIdType c = 0; c < result.GetNumberOfCentres(); ++c)
  {
    Point centre{};
    const double n = static_cast<double>(result.CentreOffsets[c + 1] - result.CentreOffsets[c]);
    for (vtkIdType m = result.CentreOffsets[c]; m < result.CentreOffsets[c + 1]; ++m)
    {
      for (int i = 0; i < 3; ++i)
      {
        centre[i] += points[result.CentreMembers[m]][i] / n;
      }
    }
    points.push_back(centre);
  }
  return points;
}

inline Point Subtract(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double Volume(const std::vector<Point>& points, const Ids& tet)
{
  const Point& p = points[tet[0]];
  return Dot(Cross(Subtract(points[tet[1]], p), Subtract(points[tet[2]], p)),
           Subtract(points[tet[3]], p)) /
    6;
}

inline Point TwiceArea(const std::vector<Point>& points, const Ids& triangle)
{
  const Point& p = points[triangle[0]];
  return Cross(Subtract(points[triangle[1]], p), Subtract(points[triangle[2]], p));
}

inline Face MakeFace(vtkIdType a, vtkIdType b, vtkIdType c)
{
  Face face{ a, b, c };
  std::sort(face.begin(), face.end());
  return face;
}

inline std::map<Face, int> CountFaces(const std::vector<Ids>& simplices)
{
  std::map<Face, int> count;
  for (const Ids& s : simplices)
  {
    for (size_t left = 0; s.size() == 4 && left < 4; ++left)
    {
      ++count[MakeFace(s[(left + 1) % 4], s[(left + 2) % 4], s[(left + 3) % 4])];
    }
  }
  return count;
}

inline std::set<Face> FacesUsed(const std::map<Face, int>& count, int times)
{
  std::set<Face> faces;
  for (const auto& [face, n] : count)
  {
    if (n == times)
    {
      faces.insert(face);
    }
  }
  return faces;
}

/// What every result keeps to, whatever the input.
inline void ExpectSound(const SimplicesOfCells& result, vtkIdType numberOfCells)
{
  vtkIdType last = 0;
  for (const vtkIdType parent : result.ParentCells)
  {
    EXPECT_LE(last, parent);
    EXPECT_LT(parent, numberOfCells);
    last = parent;
  }
  if (!result.ParentCells.empty())
  {
    EXPECT_EQ(result.ParentCells.size(), result.Simplices.Dimensions.size());
  }
  const auto simplices = GetSimplices(result);
  for (const Ids& s : simplices)
  {
    EXPECT_EQ(std::set<vtkIdType>(s.begin(), s.end()).size(), s.size());
    EXPECT_GE(*std::min_element(s.begin(), s.end()), 0);
    EXPECT_LT(*std::max_element(s.begin(), s.end()), result.Simplices.NumberOfPoints);
  }
  EXPECT_EQ(result.CentreOffsets.back(), static_cast<vtkIdType>(result.CentreMembers.size()));
}

/// All tets positive, together `volume`, and no face used more than twice.
inline void ExpectFills(
  const SimplicesOfCells& result, const std::vector<Point>& points, double volume)
{
  const std::vector<Point> all = AddCentres(points, result);
  const auto simplices = GetSimplices(result);
  double sum = 0;
  for (const Ids& s : simplices)
  {
    if (s.size() == 4)
    {
      const double v = Volume(all, s);
      EXPECT_GT(v, 0);
      sum += v;
    }
  }
  EXPECT_NEAR(sum, volume, 1e-9 * volume);
  for (const auto& [face, n] : CountFaces(simplices))
  {
    EXPECT_LE(n, 2) << face[0] << " " << face[1] << " " << face[2];
  }
}

inline Ids Range(size_t size)
{
  Ids ids(size);
  for (size_t i = 0; i < size; ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  return ids;
}

/// The points of a cell under a random numbering.
inline Mesh Shuffled(int type, const std::vector<Point>& points, std::mt19937& random)
{
  Ids ids(points.size());
  for (size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  std::shuffle(ids.begin(), ids.end(), random);
  Mesh mesh;
  mesh.Points.resize(points.size());
  for (size_t i = 0; i < ids.size(); ++i)
  {
    mesh.Points[ids[i]] = points[i];
  }
  mesh.Cells.push_back({ type, ids });
  return mesh;
}

inline bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Runs the mesh and expects exactly one warning with all these parts.
inline void ExpectOneWarning(
  const Mesh& mesh, const std::vector<std::string>& parts, const std::vector<Ids>& simplices)
{
  const auto result = Convert(mesh);
  ASSERT_EQ(result.Warnings.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_TRUE(Has(result.Warnings[0], part)) << result.Warnings[0] << "\nlacks: " << part;
  }
  EXPECT_EQ(GetSimplices(result), simplices);
  ExpectSound(result, static_cast<vtkIdType>(mesh.Cells.size()));
}

}

#endif
