// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OperatorCache.h"

#include "Private/ArrayNames.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace subdivision
{

std::size_t TopologyKey::GetMemorySize() const
{
  return this->Simplices.Dimensions.size() +
    sizeof(vtkIdType) * (this->Simplices.Connectivity.size() + this->Choices.size());
}

std::size_t KeptOperator::GetMemorySize() const
{
  return this->Key.GetMemorySize() + (this->Steps ? this->Steps->GetMemorySize() : 0) +
    this->ControlStrata.GetMemorySize() + this->ManifoldDimensions.GetMemorySize();
}

namespace
{

std::vector<vtkDataArray*> ListArrays(const UniformCells& cells)
{
  return { cells.Cells->GetConnectivityArray(), cells.Cells->GetOffsetsArray(), cells.Types,
    cells.Octahedra };
}

}

void KeptOperator::HandOut(const UniformCells& cells, vtkPointSet* output)
{
  if (cells.Cells != this->Cells.Cells)
  {
    this->Cells = cells;
    this->HandedCells.Set(ListArrays(cells));
  }
  vtkDataArray* const points = output->GetPoints()->GetData();
  if (points != this->PointsOut)
  {
    this->PointsOut = points;
    this->NormalsOut =
      this->HasNormals ? output->GetPointData()->GetArray(LimitNormalsName) : nullptr;
    this->HandedPoints.Set({ points, this->NormalsOut.Get() });
  }
}

bool KeptOperator::HasCells() const
{
  return this->Cells.Cells && this->HandedCells.Hold(ListArrays(this->Cells));
}

bool KeptOperator::HasPoints() const
{
  return this->PointsOut &&
    this->HandedPoints.Hold({ this->PointsOut.Get(), this->NormalsOut.Get() });
}

}
