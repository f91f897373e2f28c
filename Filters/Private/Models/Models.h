// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Models.h
 * The control meshes of vtkSubdivisionModelSource: the files in Data, which WriteTables.cmake turns
 * into tables while the library is built. The documentation of this class describes them.
 */
#ifndef SubdivisionObjects_Models_h
#define SubdivisionObjects_Models_h

#include "vtkType.h"

namespace subdivision
{

struct Model
{
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
  const double* Points; ///< three coordinates each
  const double* Tension;
  const vtkIdType* Connectivity;
  const vtkIdType* Offsets; ///< where each cell ends in Connectivity
  const unsigned char* Types;
  const int* MaterialId;
  const int* Singular;
};

extern const Model MixedDimensions;
extern const Model Screw;
extern const Model SpringAndValve;
extern const Model Ship;
extern const Model MechanicalPart;
extern const Model Character;
extern const Model MaterialBlock;
extern const Model Cylinder;

}

#endif
