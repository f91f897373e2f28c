// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/BezierCells.h"

#include "Core/Memory/Loops.h"
#include "Private/Bezier/PatchShape.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkPointSet.h"

#include <array>
#include <vector>

namespace subdivision
{
namespace
{

/// Whether a mesh has solids or, with `toQuads`, faces that are no quads.
bool HasCellsOfMoreSteps(vtkPointSet* mesh, bool toQuads)
{
  const CellReader reader(mesh);
  std::array<signed char, 256> dimensions;
  dimensions.fill(-1);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const int type = reader.GetCellType(c);
    if (dimensions[type] < 0)
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      dimensions[type] = static_cast<signed char>(cell ? cell->GetCellDimension() : 0);
    }
    if (dimensions[type] == 3 ||
      (toQuads && dimensions[type] == 2 && reader.GetCell(c, scratch).Size != 4))
    {
      return true;
    }
  }
  return false;
}

}

int CountFurtherSteps(vtkDataObject* input, bool toQuads)
{
  bool needsMore = !input;
  ChangeMeshes(input,
    [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(object);
      if (mesh)
      {
        needsMore = needsMore || HasCellsOfMoreSteps(mesh, toQuads);
      }
      return object;
    });
  // The first step makes quads of other faces, and cells of the next level need the same steps.
  return needsMore ? PatchShape::Get(PatchShape::Tetrahedron).SampleLevels
                   : PatchShape::Get(PatchShape::Quad).SampleLevels;
}

}
