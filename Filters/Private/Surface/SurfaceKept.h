// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceKept.h
 * What a surface filter keeps for its next execution, and the key by which it finds it.
 */
#ifndef SubdivisionObjects_SurfaceKept_h
#define SubdivisionObjects_SurfaceKept_h

#include "Core/Surfaces/Steps/SurfaceSteps.h"
#include "Private/Surface/SurfaceCells.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkCellArray.h"
#include "vtkSmartPointer.h"

#include <memory>

namespace subdivision
{

/// The cells and options on which the levels depend. Keys are compared by content.
struct SurfaceKey
{
  SurfaceSchemeKind Scheme;
  bool ModifiedBoundary;
  int Levels;
  bool Whole;
  bool Use32BitIds;
  int MadeLevels;
  SurfaceCells Cells;

  bool operator==(const SurfaceKey& other) const
  {
    const SurfaceCells& a = this->Cells;
    const SurfaceCells& b = other.Cells;
    return this->Scheme == other.Scheme && this->ModifiedBoundary == other.ModifiedBoundary &&
      this->Levels == other.Levels && this->Whole == other.Whole &&
      this->Use32BitIds == other.Use32BitIds && this->MadeLevels == other.MadeLevels &&
      a.NumberOfPoints == b.NumberOfPoints && a.Vertices == b.Vertices &&
      a.Segments == b.Segments && a.FaceOffsets == b.FaceOffsets && a.Corners == b.Corners;
  }
};

template <typename Id>
struct KeptSurface : SurfaceCache::Kept
{
  explicit KeptSurface(SurfaceKey&& key)
    : Key(std::move(key))
  {
  }
  std::size_t GetMemorySize() const override
  {
    return (this->Steps ? this->Steps->GetMemorySize() : 0) +
      sizeof(vtkIdType) * this->Key.Cells.Corners.size();
  }
  SurfaceKey Key;
  std::unique_ptr<SurfaceSteps<Id>> Steps;
  vtkSmartPointer<vtkCellArray> Verts;
  vtkSmartPointer<vtkCellArray> Lines;
  vtkSmartPointer<vtkCellArray> Polys;
};

}

#endif
