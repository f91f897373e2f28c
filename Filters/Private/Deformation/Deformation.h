// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Deformation.h
 * What vtkSubdivisionDeformation does, and what it keeps between executions.
 */
#ifndef SubdivisionObjects_Deformation_h
#define SubdivisionObjects_Deformation_h

#include "Private/Deformation/EmbeddedPoints.h"

namespace subdivision
{

class Deformation
{
public:
  /// `output` has the type of `input`. False: stopped by an error (told to Fail); the output is
  /// then the input as it is.
  bool Run(vtkPointSet* input, vtkPointSet* rest, vtkPointSet* deformed,
    const DeformationOptions& options, vtkPointSet* output);

  /// An update is over: forget the points that it did not use.
  void ForgetUnused();
  void Clear();

  vtkIdType GetNumberOfTopologyBuilds() const { return this->Rest.NumberOfBuilds; }
  /// How often points were looked up.
  vtkIdType NumberOfLocations = 0;
  /// In all executions of the last update.
  vtkIdType NumberOfOutsidePoints = 0;

  std::size_t GetMemorySize() const;

private:
  bool Prepare(vtkPointSet* rest, vtkPointSet* deformed, const DeformationOptions& options);
  EmbeddedPoints* FindEmbedded(vtkDataArray* points, const DeformationOptions& options);

  RestMesh Rest;
  std::vector<std::unique_ptr<EmbeddedPoints>> Embedded;
};

}

#endif
