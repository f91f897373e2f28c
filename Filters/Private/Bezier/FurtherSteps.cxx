// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/BezierCells.h"

#include "Core/Memory/Loops.h"
#include "Private/Bezier/PatchShape.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{
namespace
{

/// Four points in a loop, which stay four when repeated ones are dropped.
bool IsQuad(int type, const CellIds& cell)
{
  if (type == VTK_TRIANGLE_STRIP || cell.Size != 4)
  {
    return false;
  }
  std::array<vtkIdType, 4> points;
  std::copy_n(cell.Ids, 4, points.begin());
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) == points.end();
}

/// Whether a mesh has solids or, with `toQuads`, faces that are no quads.
bool HasCellsOfMoreSteps(vtkPointSet* mesh, bool toQuads)
{
  const CellReader reader(mesh);
  constexpr signed char unknown = -2;
  std::array<signed char, 256> dimensions;
  dimensions.fill(unknown);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const int type = reader.GetCellType(c);
    signed char& dimension = dimensions[type];
    if (dimension == unknown)
    {
      dimension = static_cast<signed char>(GetDimensionOfType(type));
    }
    if (dimension == 3 || (toQuads && dimension == 2 && !IsQuad(type, reader.GetCell(c, scratch))))
    {
      return true;
    }
  }
  return false;
}

}

bool HasOtherCells(vtkDataObject* input, bool toQuads)
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
  return needsMore;
}

int CountFurtherSteps(vtkDataObject* input, bool toQuads)
{
  // The first step makes quads of other faces, and cells of the next level need the same steps.
  return HasOtherCells(input, toQuads) ? PatchShape::Get(PatchShape::Tetrahedron).SampleLevels
                                       : PatchShape::Get(PatchShape::Quad).SampleLevels;
}

}
