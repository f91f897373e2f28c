// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/FaceCounts.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/SolidCells.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <vector>

namespace subdivision
{
namespace
{

void CountSolid(int type, const CellIds& cell, std::vector<vtkIdType>& loop, FaceCounts& counts)
{
  const auto count = [&counts](const vtkIdType*, vtkIdType size) { ++counts[size == 3 ? 2 : 3]; };
  if (IsPolyhedron(type))
  {
    ForEachFaceLoop(type, cell, loop, count);
    return;
  }
  const SolidFaces& table = *GetFaceTable(type);
  for (int face = 0; face < table.NumberOfFaces; ++face)
  {
    count(nullptr, table.Faces[face][3] < 0 ? 3 : 4);
  }
}

void CountPolygon(int type, vtkIdType size, FaceCounts& counts)
{
  if (type == VTK_TRIANGLE_STRIP)
  {
    counts[0] += static_cast<double>(size - 2);
  }
  else
  {
    ++counts[size == 3 ? 0 : 1];
  }
}

void CountFacesOf(vtkPointSet* mesh, FaceCounts& counts)
{
  if (!mesh->GetPoints())
  {
    return;
  }
  const CellReader reader(mesh);
  const CheckedCells checked = CheckCells(mesh, reader);
  const unsigned char* ghosts = GetGhosts(mesh, reader.GetNumberOfCells());
  std::vector<vtkIdType> scratch;
  std::vector<vtkIdType> loop;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const int type = reader.GetCellType(c);
    const int dimension = GetDimensionOfType(type);
    const bool isCounted = TakesPart(checked.States[c]) &&
      !(ghosts && (ghosts[c] & vtkDataSetAttributes::DUPLICATECELL));
    const CellIds cell = isCounted && dimension > 1 ? reader.GetCell(c, scratch) : CellIds();
    const CornerCell corners =
      IsNonLinear(type) ? GetCornerCell(type, cell.Size) : CornerCell{ type, cell.Size };
    if (corners.Size >= 3)
    {
      dimension == 3 ? CountSolid(corners.Type, cell, loop, counts)
                     : CountPolygon(corners.Type, corners.Size, counts);
    }
  }
}

}

bool HasMostlyQuads(const FaceCounts& counts)
{
  const bool hasPolygons = counts[0] + counts[1] > 0.;
  return hasPolygons ? counts[1] > counts[0] : counts[3] > counts[2];
}

FaceCounts CountFaces(vtkDataObject* readable)
{
  FaceCounts counts = {};
  ChangeMeshes(readable,
    [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      if (auto* mesh = vtkPointSet::SafeDownCast(object))
      {
        CountFacesOf(mesh, counts);
      }
      return object;
    });
  return counts;
}

}
