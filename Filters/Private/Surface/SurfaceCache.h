// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCache.h
 * The data that a surface filter keeps between executions: the levels and the output's cells.
 */
#ifndef SubdivisionObjects_SurfaceCache_h
#define SubdivisionObjects_SurfaceCache_h

#include "Core/Surfaces/Steps/SurfaceSchemes.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Surface/SurfaceCells.h"

#include "vtkCellArray.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

namespace subdivision
{

/// The cells and options on which the levels depend. Keys are compared by content.
struct SurfaceKey
{
  SurfaceSchemeKind Scheme = SurfaceSchemeKind::Loop;
  bool ModifiedBoundary = true;
  LoopWeights Weights = LoopWeights::Warren;
  int Levels = 0;
  LastLevel Last = LastLevel::ForCells;
  bool Use32BitIds = false;
  int MadeLevels = 0;
  SurfaceCells Cells;

  bool operator==(const SurfaceKey& other) const
  {
    const SurfaceCells& a = this->Cells;
    const SurfaceCells& b = other.Cells;
    return this->Scheme == other.Scheme && this->ModifiedBoundary == other.ModifiedBoundary &&
      this->Weights == other.Weights && this->Levels == other.Levels && this->Last == other.Last &&
      this->Use32BitIds == other.Use32BitIds && this->MadeLevels == other.MadeLevels &&
      a.NumberOfPoints == b.NumberOfPoints && a.Vertices == b.Vertices &&
      a.Segments == b.Segments && a.FaceOffsets == b.FaceOffsets && a.Corners == b.Corners;
  }
};

/// The levels of one mesh.
template <typename Id>
struct KeptSurface : KeptEntry
{
  SurfaceKey Key;
  std::vector<std::string> Warnings;   ///< of open points
  vtkSmartPointer<vtkCellArray> Verts; ///< the cells of the output, once they are written
  vtkSmartPointer<vtkCellArray> Lines;
  vtkSmartPointer<vtkCellArray> Polys;
  SharedArrays Handed; ///< their arrays, which the output has
  std::unique_ptr<SurfaceSteps<Id>> Steps;
  std::unique_ptr<SurfaceSteps<Id>> Control; ///< the control level alone, if its limits are needed

  std::vector<vtkDataArray*> ListArrays() const
  {
    std::vector<vtkDataArray*> arrays;
    for (vtkCellArray* cells : { this->Verts.Get(), this->Lines.Get(), this->Polys.Get() })
    {
      arrays.push_back(cells->GetOffsetsArray());
      arrays.push_back(cells->GetConnectivityArray());
    }
    return arrays;
  }
  /// Whether there are cells, and nobody wrote into the output's ones.
  bool HasCells() const { return this->Polys && this->Handed.Hold(this->ListArrays()); }
  std::size_t GetMemorySize() const override
  {
    return (this->Steps ? this->Steps->GetMemorySize() : 0) +
      (this->Control ? this->Control->GetMemorySize() : 0) +
      sizeof(vtkIdType) * this->Key.Cells.Corners.size();
  }
};

}

#endif
