// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceInput.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellFaces.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace subdivision
{
namespace
{

/// The four lists of cells of a vtkPolyData.
struct Lists
{
  vtkNew<vtkCellArray> Cells[4];
  std::array<std::vector<vtkIdType>, 4> Parents;

  void Add(int list, vtkIdType parent, const vtkIdType* ids, vtkIdType size)
  {
    this->Cells[list]->InsertNextCell(size, ids);
    this->Parents[list].push_back(parent);
  }
  void AddLinear(int type, vtkIdType parent, const CellIds& cell)
  {
    vtkIdType quad[4];
    switch (type)
    {
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        this->Add(0, parent, cell.Ids, cell.Size);
        break;
      case VTK_LINE:
      case VTK_POLY_LINE:
        this->Add(1, parent, cell.Ids, cell.Size);
        break;
      case VTK_TRIANGLE_STRIP:
        this->Add(3, parent, cell.Ids, cell.Size);
        break;
      case VTK_PIXEL:
        GetQuad(type, cell.Ids, quad);
        this->Add(2, parent, quad, 4);
        break;
      default:
        this->Add(2, parent, cell.Ids, cell.Size);
        break;
    }
  }
};

/// Counts the solids; `first` is the first of them.
vtkIdType SortCells(vtkUnstructuredGrid* grid, const CellReader& reader,
  const CheckedCells& checked, Lists& lists, vtkIdType& first)
{
  NonLinearCells nonLinear(grid);
  std::vector<vtkIdType> scratch;
  vtkIdType solids = 0;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    if (!TakesPart(checked.States[c]))
    {
      continue;
    }
    const int type = reader.GetCellType(c);
    const CellIds cell = reader.GetCell(c, scratch);
    const CellPieces* table = IsNonLinear(type) ? nonLinear.Find(type, c, cell.Size) : nullptr;
    if (GetDimensionOfType(type) == 3)
    {
      first = solids++ == 0 ? c : first;
    }
    else if (table)
    {
      ForEachPiece(*table, cell,
        [&](int pieceType, const CellIds& piece) { lists.AddLinear(pieceType, c, piece); });
    }
    else
    {
      lists.AddLinear(type, c, cell);
    }
  }
  return solids;
}

/// Calls visit(cell, loop, size, whether it is of a solid) for the faces of solids, and for
/// polygons.
template <typename Visit>
void ForFaces(vtkUnstructuredGrid* grid, const CellReader& reader, const CheckedCells& checked,
  const Visit& visit)
{
  CellFaces faces(grid, reader);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const int dimension =
      TakesPart(checked.States[c]) ? GetDimensionOfType(reader.GetCellType(c)) : 0;
    if (dimension >= 2)
    {
      faces.ForEach(c, reader.GetCell(c, scratch),
        [&](const vtkIdType* loop, vtkIdType size) { visit(c, loop, size, dimension == 3); });
    }
  }
}

/// Adds the outside of solids. Returns the number of faces.
vtkIdType AddOutside(
  vtkUnstructuredGrid* grid, const CellReader& reader, const CheckedCells& checked, Lists& lists)
{
  std::vector<std::uint64_t> faces;
  ForFaces(grid, reader, checked, [&](vtkIdType, const vtkIdType* loop, vtkIdType size, bool)
    { faces.push_back(HashLoop(loop, size)); });
  KeepSingles(faces);
  vtkIdType count = 0;
  ForFaces(grid, reader, checked,
    [&](vtkIdType c, const vtkIdType* loop, vtkIdType size, bool isOfSolid)
    {
      if (isOfSolid && std::binary_search(faces.begin(), faces.end(), HashLoop(loop, size)))
      {
        lists.Add(2, c, loop, size);
        ++count;
      }
    });
  return count;
}

std::string DescribeSolids(vtkIdType solids, vtkIdType first, bool takesOutside, vtkIdType faces)
{
  return std::to_string(solids) + " cell(s) are solids, the first is cell " +
    std::to_string(first) + ": this filter is for surfaces and " +
    (takesOutside
        ? "takes their outside, " + std::to_string(faces) +
          " face(s). Use vtkMultiDimensionalSubdivision to subdivide solids."
        : "leaves them out, because blocks or ranks share them. Extract their surface first by "
          "vtkDataSetSurfaceFilter, or use vtkMultiDimensionalSubdivision.");
}

std::vector<std::string> DescribeUnused(const CellReader& reader, CheckedCells checked)
{
  for (CellState& state : InTurn(checked.States))
  {
    // Who reads the surface tells of these.
    state = state == CellState::PartlyRepeated ? CellState::Good : state;
  }
  return DescribePassedOver(reader, checked);
}

}

vtkSmartPointer<vtkPolyData> MakeSurface(vtkUnstructuredGrid* grid, bool takesOutside,
  bool originalIds, std::vector<std::string>& warnings)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(grid->GetPoints());
  surface->GetPointData()->ShallowCopy(grid->GetPointData());
  surface->GetFieldData()->ShallowCopy(grid->GetFieldData());
  if (!grid->GetPoints())
  {
    return surface;
  }
  const CellReader reader(grid);
  const CheckedCells checked = CheckCells(grid, reader);
  for (const std::string& warning : DescribeUnused(reader, checked))
  {
    warnings.push_back(warning);
  }
  Lists lists;
  vtkIdType first = -1;
  const vtkIdType solids = SortCells(grid, reader, checked, lists, first);
  if (solids > 0)
  {
    const vtkIdType faces = takesOutside ? AddOutside(grid, reader, checked, lists) : 0;
    warnings.push_back(DescribeSolids(solids, first, takesOutside, faces));
  }
  surface->SetVerts(lists.Cells[0]);
  surface->SetLines(lists.Cells[1]);
  surface->SetPolys(lists.Cells[2]);
  surface->SetStrips(lists.Cells[3]);
  std::vector<vtkIdType> parents;
  for (const auto& some : lists.Parents)
  {
    parents.insert(parents.end(), some.begin(), some.end());
  }
  const Row<vtkIdType> row = { parents.data(), parents.data() + parents.size() };
  vtkCellData* data = grid->GetCellData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (array->GetNumberOfTuples() >= grid->GetNumberOfCells())
    {
      AddLike(data, a, Gather(array, row), surface->GetCellData());
    }
  }
  if (originalIds)
  {
    const auto ids = MakeArray(VTK_ID_TYPE, 1, static_cast<vtkIdType>(parents.size()));
    std::copy(parents.begin(), parents.end(), static_cast<vtkIdType*>(ids->GetVoidPointer(0)));
    ids->SetName(SourceCellsName);
    surface->GetCellData()->AddArray(ids);
  }
  return surface;
}

vtkIdType FindFirstSolid(vtkUnstructuredGrid* grid)
{
  const CellReader reader(grid);
  const CheckedCells checked = CheckCells(grid, reader);
  Lists lists;
  vtkIdType first = -1;
  SortCells(grid, reader, checked, lists, first);
  return first;
}

void RestoreSourceCells(vtkDataObject* output)
{
  ChangeMeshes(output,
    [](vtkDataObject* mesh, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* surface = vtkPolyData::SafeDownCast(mesh);
      const vtkSmartPointer<vtkDataArray> ids =
        surface ? surface->GetCellData()->GetArray(SourceCellsName) : nullptr;
      if (ids)
      {
        surface->GetCellData()->RemoveArray(SourceCellsName);
        ids->SetName(OriginalCellIdsName);
        surface->GetCellData()->AddArray(ids);
      }
      return mesh;
    });
}

}
