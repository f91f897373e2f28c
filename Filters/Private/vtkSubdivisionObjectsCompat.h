// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSubdivisionObjectsCompat.h
 * Every difference between the VTK versions that are supported (9.1 and later), in one place.
 */
#ifndef vtkSubdivisionObjectsCompat_h
#define vtkSubdivisionObjectsCompat_h

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
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

/// Forgets that an earlier execution was stopped, as VTK does before it executes an algorithm.
inline void ForgetStop([[maybe_unused]] vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER > VTK_VERSION_CHECK(9, 2, 20221231)
  algorithm->SetAbortOutput(false);
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

/// The faces of a polyhedron: their number, then the number of points and the points of each.
/// GetFaceStream does not check its arrays. Returns false, with an empty list, where locations or
/// counts lead out of the arrays, for instance in a damaged file.
inline bool ReadFaceStream(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* stream)
{
  stream->Reset();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  // Calls add(id) for the entries of a list, after start(number of them).
  auto read = [](vtkCellArray* lists, vtkIdType list, const auto& start, const auto& add)
  {
    if (!lists || list < 0 || list >= lists->GetNumberOfCells())
    {
      return false;
    }
    auto get = [](vtkDataArray* array, vtkIdType i)
    { return static_cast<vtkIdType>(array->GetComponent(i, 0)); };
    const vtkIdType begin = get(lists->GetOffsetsArray(), list);
    const vtkIdType end = get(lists->GetOffsetsArray(), list + 1);
    vtkDataArray* ids = lists->GetConnectivityArray();
    if (begin < 0 || end < begin || end > ids->GetNumberOfTuples())
    {
      return false;
    }
    start(end - begin);
    bool good = true;
    for (vtkIdType i = begin; good && i < end; ++i)
    {
      good = add(get(ids, i));
    }
    return good;
  };
  auto addId = [stream](vtkIdType id)
  {
    stream->InsertNextId(id);
    return true;
  };
  vtkCellArray* faces = grid->GetPolyhedronFaces();
  const bool good = read(grid->GetPolyhedronFaceLocations(), cell, addId,
    [&](vtkIdType face) { return read(faces, face, addId, addId); });
  if (!good)
  {
    stream->Reset();
  }
  return good;
#else
  vtkIdTypeArray* faces = grid->GetFaces();
  vtkIdTypeArray* locations = grid->GetFaceLocations();
  const vtkIdType size = faces ? faces->GetNumberOfValues() : 0;
  vtkIdType at =
    locations && cell < locations->GetNumberOfValues() ? locations->GetValue(cell) : -1;
  if (at < 0 || at >= size)
  {
    return false;
  }
  const vtkIdType* const values = faces->GetPointer(0);
  const vtkIdType begin = at;
  vtkIdType left = values[at++];
  bool good = left >= 0;
  for (; good && left > 0; --left)
  {
    good = at < size && values[at] >= 0 && values[at] < size - at;
    at += good ? values[at] + 1 : 0;
  }
  for (vtkIdType i = begin; good && i < at; ++i)
  {
    stream->InsertNextId(values[i]);
  }
  return good;
#endif
}

}

#endif
