// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzMesh.h
 * Small data sets that the bytes of a fuzzer describe: cells of any type with any ids, and arrays
 * with the names that filters look for, of any type and length.
 */
#ifndef SubdivisionObjects_FuzzMesh_h
#define SubdivisionObjects_FuzzMesh_h

#include "Bytes.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>

namespace fuzz
{

/// An unstructured grid, polygonal data, an image, or blocks of these.
vtkSmartPointer<vtkDataObject> MakeData(Bytes& bytes);

/// The name of an array that MakeData may have added, or "None".
const char* ChooseArray(Bytes& bytes);

}

#endif
