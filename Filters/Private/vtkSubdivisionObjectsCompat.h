// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSubdivisionObjectsCompat.h
 * Every difference between the VTK versions that are supported (9.1 and later), in one place.
 */
#ifndef vtkSubdivisionObjectsCompat_h
#define vtkSubdivisionObjectsCompat_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#ifndef VTK_VERSION_NUMBER
#define VTK_VERSION_NUMBER                                                                         \
  VTK_VERSION_CHECK(VTK_MAJOR_VERSION, VTK_MINOR_VERSION, VTK_BUILD_VERSION)
#endif

namespace subdivision
{

/// Whether the user wants the execution to stop. CheckAbort came with the builds of 2023.
inline bool IsAborted(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER > VTK_VERSION_CHECK(9, 2, 20221231)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/// The types of all cells as plain values; null in a grid without any. From 9.6 on VTK may keep
/// them in an array of another kind, one number for all for instance: then they are a copy.
inline vtkSmartPointer<vtkUnsignedCharArray> GetCellTypes(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  vtkDataArray* stored = grid->GetCellTypes();
  vtkSmartPointer<vtkUnsignedCharArray> types = vtkUnsignedCharArray::SafeDownCast(stored);
  if (stored && !types)
  {
    types = vtkSmartPointer<vtkUnsignedCharArray>::New();
    types->DeepCopy(stored);
  }
  return types;
#else
  return grid->GetCellTypesArray();
#endif
}

}

#endif
