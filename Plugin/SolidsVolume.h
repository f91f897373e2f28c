// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidsVolume.h
 * The Volume representation of grids that mix dimensions.
 */
#ifndef SubdivisionObjects_SolidsVolume_h
#define SubdivisionObjects_SolidsVolume_h

#include "vtkUnstructuredGridVolumeRepresentation.h"

/**
 * ParaView splits cells into tetrahedra before it renders a volume, and leaves out all others, but
 * takes a grid as it is if all its cells are simplices. Its renderer then refuses triangles and
 * lines. This representation takes the tetrahedra out of such grids. It has the name of its
 * superclass, in whose place it is made.
 */
class SolidsVolume : public vtkUnstructuredGridVolumeRepresentation
{
public:
  static SolidsVolume* New();

protected:
  SolidsVolume() = default;
  ~SolidsVolume() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

#endif
