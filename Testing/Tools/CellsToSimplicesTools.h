// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellsToSimplicesTools.h
 * Meshes written down as lists, and what the tests of CellsToSimplices ask of a result.
 */
#ifndef SubdivisionObjects_CellsToSimplicesTools_h
#define SubdivisionObjects_CellsToSimplicesTools_h

#include "PointTools.h"

#include "Private/Reading/CellsToSimplices.h"

#include "vtkCellType.h"

namespace cells_to_simplices_tools
{

using subdivision::CellsToSimplices;
using subdivision::SimplicesOfCells;
using namespace point_tools;
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

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const Mesh& mesh);

inline SimplicesOfCells Convert(const Mesh& mesh)
{
  return CellsToSimplices(MakeGrid(mesh), nullptr);
}

std::vector<Ids> GetSimplices(const SimplicesOfCells& result);

std::vector<Point> AddCentres(std::vector<Point> points, const SimplicesOfCells& result);

double Volume(const std::vector<Point>& points, const Ids& tet);

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

std::map<Face, int> CountFaces(const std::vector<Ids>& simplices);

std::set<Face> FacesUsed(const std::map<Face, int>& count, int times);

/// What every result keeps to, whatever the input.
void ExpectSound(const SimplicesOfCells& result, vtkIdType numberOfCells);

/// All tets positive, together `volume`, and no face used more than twice.
void ExpectFills(const SimplicesOfCells& result, const std::vector<Point>& points, double volume);

Ids Range(size_t size);

/// The points of a cell under a random numbering.
Mesh Shuffled(int type, const std::vector<Point>& points, std::mt19937& random);

inline bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Runs the mesh and expects exactly one warning with all these parts.
void ExpectOneWarning(
  const Mesh& mesh, const std::vector<std::string>& parts, const std::vector<Ids>& simplices);

}

#endif
