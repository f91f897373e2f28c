// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArraysOfAllKinds.h
 * Arrays with everything that vtkDataSetAttributes copies.
 */
#ifndef SubdivisionObjects_ArraysOfAllKinds_h
#define SubdivisionObjects_ArraysOfAllKinds_h

#include "vtkType.h"

#include <string>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace all_kinds
{

/// Gives an array a name, names of components, information and a lookup table.
void Decorate(vtkAbstractArray* array, const std::string& name);

/// Adds one array of each type, and one for each attribute.
void AddAll(vtkDataSetAttributes* data, vtkIdType size);

}

#endif
