// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WholeInput.h
 * What filters ask of an input that they need whole, whatever part of their output is wanted.
 */
#ifndef SubdivisionObjects_WholeInput_h
#define SubdivisionObjects_WholeInput_h

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace subdivision
{

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
