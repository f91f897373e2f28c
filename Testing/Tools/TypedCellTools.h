// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TypedCellTools.h
 * Types, faces and volumes of cells of all types, by VTK's own cells.
 */
#ifndef SubdivisionObjects_TypedCellTools_h
#define SubdivisionObjects_TypedCellTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkCell.h"

namespace typed_cell_tools
{

using namespace multi_dimensional_subdivision_tools;

/// The corners of the faces of cells, by VTK's own cells.
inline std::vector<Ids> GetFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  std::vector<Ids> faces;
  vtkCell* of = grid->GetCell(cell);
  for (int f = 0; f < of->GetNumberOfFaces(); ++f)
  {
    vtkIdList* ids = of->GetFace(f)->GetPointIds();
    faces.emplace_back(ids->begin(), ids->end());
  }
  return faces;
}

/// Six times the volume below the bilinear or flat face, seen along z, with its orientation: summed
/// over the faces of a cell with faces turned outward it is six times the volume.
inline double GetFlux(vtkPointSet* grid, const Ids& face)
{
  // A quad is the mean of its two cuts: exact for a bilinear face.
  const auto triangle = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Point p = GetPoint(grid, a);
    const Point q = GetPoint(grid, b);
    const Point r = GetPoint(grid, c);
    return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
      p[2] * (q[0] * r[1] - q[1] * r[0]);
  };
  if (face.size() == 3)
  {
    return triangle(face[0], face[1], face[2]);
  }
  return (triangle(face[0], face[1], face[2]) + triangle(face[0], face[2], face[3]) +
           triangle(face[0], face[1], face[3]) + triangle(face[1], face[2], face[3])) /
    2.;
}

inline std::map<int, int> CountTypes(vtkUnstructuredGrid* grid)
{
  std::map<int, int> counts;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ++counts[grid->GetCellType(c)];
  }
  return counts;
}

/// The volume inside the faces of the solids. A cell whose faces look inwards counts negatively.
inline double MeasureSolids(vtkUnstructuredGrid* grid)
{
  double flux = 0.;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    for (const Ids& face : GetFaces(grid, c))
    {
      flux += GetFlux(grid, face);
    }
  }
  return flux / 6.;
}

/// The same by the values of a cell array.
inline std::map<int, double> MeasureSolidsBy(vtkUnstructuredGrid* grid, const char* name)
{
  std::map<int, double> volumes;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    double& volume = volumes[static_cast<int>(grid->GetCellData()->GetArray(name)->GetTuple1(c))];
    for (const Ids& face : GetFaces(grid, c))
    {
      volume += GetFlux(grid, face) / 6.;
    }
  }
  return volumes;
}

/// The faces of solids, by their sorted corners.
struct SolidFaces
{
  struct Face
  {
    Ids Loop;
    int Solids = 0;
  };

  explicit SolidFaces(vtkUnstructuredGrid* grid)
  {
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    {
      for (const Ids& loop : GetFaces(grid, c))
      {
        Face& face = this->Faces[Sort(loop)];
        face.Loop = loop;
        ++face.Solids;
      }
    }
  }
  /// Of all faces.
  int GetMostSolids() const
  {
    int most = 0;
    for (const auto& face : this->Faces)
    {
      most = std::max(most, face.second.Solids);
    }
    return most;
  }
  /// How many edges have an odd number of faces of one solid: none where the boundary is closed.
  int CountOpenEdges() const
  {
    std::map<Ids, int> edges;
    for (const auto& [key, face] : this->Faces)
    {
      for (std::size_t i = 0; i < face.Loop.size() && face.Solids == 1; ++i)
      {
        ++edges[Sort({ face.Loop[i], face.Loop[(i + 1) % face.Loop.size()] })];
      }
    }
    return static_cast<int>(std::count_if(
      edges.begin(), edges.end(), [](const auto& edge) { return edge.second % 2 == 1; }));
  }
  /// How many quads lie against two triangles.
  int CountCutQuads() const
  {
    int count = 0;
    for (const auto& face : this->Faces)
    {
      const Ids& q = face.second.Loop;
      for (std::size_t d = 0; d < 2 && q.size() == 4; ++d)
      {
        count += this->Faces.count(Sort({ q[d], q[d + 1], q[d + 2] })) &&
            this->Faces.count(Sort({ q[d + 2], q[(d + 3) % 4], q[d] }))
          ? 1
          : 0;
      }
    }
    return count;
  }

  static Ids Sort(Ids ids)
  {
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  std::map<Ids, Face> Faces;
};

/// Solids fit together, and no edge or face of one ends inside a face of another.
inline void ExpectFitting(vtkUnstructuredGrid* grid)
{
  const SolidFaces faces(grid);
  EXPECT_LE(faces.GetMostSolids(), 2);
  EXPECT_EQ(faces.CountOpenEdges(), 0);
  EXPECT_EQ(faces.CountCutQuads(), 0);
}

}

#endif
