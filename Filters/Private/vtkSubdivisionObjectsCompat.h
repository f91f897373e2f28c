// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSubdivisionObjectsCompat.h
 * Every difference between the VTK versions that are supported (9.1 and later), in one place.
 */
#ifndef vtkSubdivisionObjectsCompat_h
#define vtkSubdivisionObjectsCompat_h

#include "vtkAlgorithm.h"
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

}

#endif
