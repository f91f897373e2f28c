// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ports.h
 * The types that filters take at ports and make there, and how they ask for a whole input,
 * whatever part of their output is wanted.
 */
#ifndef SubdivisionObjects_Ports_h
#define SubdivisionObjects_Ports_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <initializer_list>

namespace subdivision
{

/// For FillInputPortInformation: a port takes data of these types.
inline int TakeTypes(
  vtkInformation* info, std::initializer_list<const char*> types, bool isOptional = false)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* type : types)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
  isOptional ? info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1) : void();
  return 1;
}

/// For RequestDataObject: makes an output of one type, unless there is one.
template <typename Data>
int MakeOutput(vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!Data::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT())))
  {
    info->Set(vtkDataObject::DATA_OBJECT(), vtkNew<Data>());
  }
  return 1;
}

/// Asks for a piece without ghost layers, and of images for all; on one process piece 0 of 1.
inline void AskForWhole(vtkInformation* info, int piece = 0, int pieces = 1)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    int whole[6];
    info->Get(Pipeline::WHOLE_EXTENT(), whole);
    info->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
  }
}

}

#endif
