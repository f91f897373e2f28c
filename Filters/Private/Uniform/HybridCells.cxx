// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridCells.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/QuadDiagonals.h"
#include "Private/Reading/SolidCells.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>

namespace subdivision
{

void HybridCells::Add(vtkIdType source, CellShape shape, const vtkIdType* corners)
{
  this->Shapes.push_back(shape);
  this->Corners.insert(this->Corners.end(), corners, corners + GetCellTable(shape).Corners);
  this->Sources.push_back(source);
}

vtkIdType HybridCells::AddCentre(vtkIdType source, const vtkIdType* members, vtkIdType size)
{
  SimplicesOfCells& centres = this->Centres;
  centres.CentreMembers.insert(centres.CentreMembers.end(), members, members + size);
  centres.CentreOffsets.push_back(static_cast<vtkIdType>(centres.CentreMembers.size()));
  this->CentreSources.push_back(source);
  return this->NumberOfPoints++;
}

void HybridCells::AddCone(vtkIdType source, vtkIdType centre, const vtkIdType* face, vtkIdType size)
{
  vtkIdType corners[5];
  std::reverse_copy(face, face + size, corners);
  corners[size] = centre;
  this->Add(source, size == 3 ? CellShape::Tet : CellShape::Pyramid, corners);
}

void HybridCells::Append(const HybridCells& more)
{
  const vtkIdType input = more.GetNumberOfInputPoints();
  const vtkIdType shift = this->NumberOfPoints - input;
  this->Shapes.insert(this->Shapes.end(), more.Shapes.begin(), more.Shapes.end());
  this->Sources.insert(this->Sources.end(), more.Sources.begin(), more.Sources.end());
  std::transform(more.Corners.begin(), more.Corners.end(), std::back_inserter(this->Corners),
    [&](vtkIdType p) { return p < input ? p : p + shift; });
  for (const std::size_t c : InTurn(more.CentreSources.size()))
  {
    const vtkIdType* members = more.Centres.CentreMembers.data();
    const std::vector<vtkIdType>& offsets = more.Centres.CentreOffsets;
    this->AddCentre(more.CentreSources[c], members + offsets[c], offsets[c + 1] - offsets[c]);
  }
}

namespace
{

/// Finds the cells that give way, and writes all cells anew.
class WayGiver
{
public:
  WayGiver(HybridCells& cells, const PointOrder& order)
    : Cells(cells)
    , InputPoints(cells.GetNumberOfInputPoints())
    , Diagonals(order)
  {
    this->Made.NumberOfPoints = this->InputPoints;
  }

  void Run()
  {
    const std::size_t size = this->Cells.Shapes.size();
    if (!this->HasQuadsAndTriangles())
    {
      return;
    }
    this->Offsets.resize(size + 1);
    for (const std::size_t c : InTurn(size))
    {
      this->Offsets[c + 1] = this->Offsets[c] + GetCellTable(this->Cells.Shapes[c]).Corners;
    }
    this->FindTriangles();
    std::vector<unsigned char> gives(size, 0);
    ForEach(static_cast<vtkIdType>(size), [&](vtkIdType c) { gives[c] = this->GivesWay(c); });
    if (std::find(gives.begin(), gives.end(), 1) != gives.end())
    {
      this->Rewrite(gives);
    }
  }

private:
  bool HasQuadsAndTriangles() const
  {
    std::array<bool, NumberOfShapes> has{};
    for (const CellShape shape : InTurn(this->Cells.Shapes))
    {
      has[static_cast<std::size_t>(shape)] = true;
    }
    bool found[2] = { false, false };
    for (int s = 0; s < NumberOfShapes; ++s)
    {
      for (const auto& face : GetCellTable(static_cast<CellShape>(s)).Faces)
      {
        found[face.size() - 3] = found[face.size() - 3] || has[static_cast<std::size_t>(s)];
      }
    }
    return found[0] && found[1];
  }

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Cells.Shapes.size()); }
  CellShape GetShape(vtkIdType cell) const
  {
    return this->Cells.Shapes[static_cast<std::size_t>(cell)];
  }

  /// Calls visit(face) for the faces of three or four points.
  template <typename Visit>
  void ForFaces(vtkIdType cell, std::size_t size, const Visit& visit) const
  {
    const vtkIdType* corners =
      this->Cells.Corners.data() + this->Offsets[static_cast<std::size_t>(cell)];
    for (const auto& local : GetCellTable(this->GetShape(cell)).Faces)
    {
      vtkIdType face[4];
      for (std::size_t i = 0; i < local.size() && local.size() == size; ++i)
      {
        face[i] = corners[local[i]];
      }
      if (local.size() == size)
      {
        visit(face);
      }
    }
  }

  /// Only triangles between points of quads can lie against a quad.
  void FindTriangles()
  {
    const vtkIdType points = this->Cells.NumberOfPoints;
    std::vector<bool> isOfQuad(static_cast<std::size_t>(points), false);
    const auto mark = [&](const vtkIdType* quad)
    {
      for (int i = 0; i < 4; ++i)
      {
        isOfQuad[static_cast<std::size_t>(quad[i])] = true;
      }
    };
    for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
    {
      this->ForFaces(c, 4, mark);
    }
    std::vector<TriangleKey> triangles;
    const auto add = [&](const vtkIdType* face)
    {
      if (std::all_of(
            face, face + 3, [&](vtkIdType p) { return isOfQuad[static_cast<std::size_t>(p)]; }))
      {
        triangles.push_back(MakeTriangleKey(face[0], face[1], face[2]));
      }
    };
    for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
    {
      this->ForFaces(c, 3, add);
    }
    this->Diagonals.SetTriangles(std::move(triangles), points);
  }

  unsigned char GivesWay(vtkIdType cell) const
  {
    bool gives = false;
    this->ForFaces(
      cell, 4, [&](const vtkIdType* quad) { gives = gives || this->Diagonals.FindCut(quad) >= 0; });
    return gives ? 1 : 0;
  }

  void Rewrite(const std::vector<unsigned char>& gives)
  {
    std::vector<vtkIdType> moved(this->Cells.CentreSources.size(), -1);
    for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
    {
      const auto cell = static_cast<std::size_t>(c);
      const vtkIdType source = this->Cells.Sources[cell];
      const vtkIdType* from = this->Cells.Corners.data() + this->Offsets[cell];
      const vtkIdType size = this->Offsets[cell + 1] - this->Offsets[cell];
      vtkIdType corners[8];
      std::transform(from, from + size, corners,
        [&](vtkIdType point) { return this->MoveCentre(point, source, moved); });
      if (gives[cell])
      {
        this->Split(this->Cells.Shapes[cell], source, corners);
      }
      else
      {
        this->Made.Add(source, this->Cells.Shapes[cell], corners);
      }
    }
    this->Made.Warnings = std::move(this->Cells.Warnings);
    this->Made.Warnings.push_back(this->Describe());
    this->Cells = std::move(this->Made);
  }
  /// Centres keep the order of cells, among the new points.
  vtkIdType MoveCentre(vtkIdType point, vtkIdType source, std::vector<vtkIdType>& moved)
  {
    if (point < this->InputPoints)
    {
      return point;
    }
    const auto centre = static_cast<std::size_t>(point - this->InputPoints);
    if (moved[centre] < 0)
    {
      const std::vector<vtkIdType>& offsets = this->Cells.Centres.CentreOffsets;
      moved[centre] =
        this->Made.AddCentre(source, this->Cells.Centres.CentreMembers.data() + offsets[centre],
          offsets[centre + 1] - offsets[centre]);
    }
    return moved[centre];
  }

  void Split(CellShape shape, vtkIdType source, const vtkIdType* corners)
  {
    this->First = this->First < 0 ? source : this->First;
    ++this->Counts[static_cast<std::size_t>(shape)];
    if (shape == CellShape::Quad)
    {
      this->Cut(corners,
        [&](const vtkIdType* triangle) { this->Made.Add(source, CellShape::Triangle, triangle); });
    }
    else if (shape == CellShape::Pyramid)
    {
      this->AddCones(source, corners[4], VTK_PYRAMID, 1, corners);
    }
    else
    {
      const int type = shape == CellShape::Hex ? VTK_HEXAHEDRON : VTK_WEDGE;
      const SolidFaces& table = *GetFaceTable(type);
      const vtkIdType centre = this->Made.AddCentre(source, corners, table.NumberOfPoints);
      this->AddCones(source, centre, type, table.NumberOfFaces, corners);
    }
  }
  /// From a point to the first faces of a cell, of which the base of a pyramid is one.
  void AddCones(vtkIdType source, vtkIdType apex, int type, int faces, const vtkIdType* corners)
  {
    const SolidFaces& table = *GetFaceTable(type);
    for (int f = 0; f < faces; ++f)
    {
      const int* local = table.Faces[f];
      const int size = local[3] < 0 ? 3 : 4;
      vtkIdType face[4];
      std::transform(local, local + size, face, [corners](int i) { return corners[i]; });
      if (size == 3 || this->Diagonals.FindCut(face) < 0)
      {
        this->Made.AddCone(source, apex, face, size);
      }
      else
      {
        this->Cut(
          face, [&](const vtkIdType* triangle) { this->Made.AddCone(source, apex, triangle, 3); });
      }
    }
  }
  /// Calls visit(triangle) for the two that lie against a quad.
  template <typename Visit>
  void Cut(const vtkIdType* quad, const Visit& visit)
  {
    ++this->NumberOfQuads;
    const int d = this->Diagonals.FindCut(quad);
    for (const int first : { d, d + 2 })
    {
      const vtkIdType triangle[3] = { quad[first], quad[(first + 1) % 4],
        quad[(first + 2) % 4] }; // its last edge is the diagonal
      visit(triangle);
    }
  }

  std::string Describe() const
  {
    const auto count = [this](CellShape shape)
    { return std::to_string(this->Counts[static_cast<std::size_t>(shape)]); };
    return std::to_string(this->NumberOfQuads) +
      " quad(s) lie against two triangles, so that the cells with these quads give way: " +
      count(CellShape::Hex) + " hexahedra and " + count(CellShape::Wedge) +
      " wedges become tetrahedra and pyramids around a point in their middle, " +
      count(CellShape::Pyramid) + " pyramids two tetrahedra and " + count(CellShape::Quad) +
      " quads two triangles. The first is cell " + std::to_string(this->First) +
      ". Put pyramids between quads and triangles to keep them.";
  }

  HybridCells& Cells;
  const vtkIdType InputPoints;
  HybridCells Made;
  QuadDiagonals Diagonals;
  std::vector<vtkIdType> Offsets;
  vtkIdType NumberOfQuads = 0;
  vtkIdType First = -1;
  std::array<vtkIdType, NumberOfShapes> Counts{};
};

}

void GiveWayToTriangles(HybridCells& cells, const PointOrder& order)
{
  WayGiver(cells, order).Run();
}

}
