// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Deformation.h
 * Does the work of vtkSubdivisionDeformation, and keeps its data between executions.
 */
#ifndef SubdivisionObjects_Deformation_h
#define SubdivisionObjects_Deformation_h

#include "Private/Deformation/EmbeddedPoints.h"

namespace subdivision
{

class Deformation
{
public:
  /// `output` has the type of `input`. Returns false after an error (passed to Fail) or if Progress
  /// asks to stop; the output then means nothing.
  bool Run(vtkPointSet* input, vtkPointSet* rest, vtkPointSet* deformed,
    const DeformationOptions& options, vtkPointSet* output);

  /// Forgets the points that were not used since the last call.
  void ForgetUnused() { this->Embedded.ForgetUnused(); }
  void Clear();

  vtkIdType GetNumberOfTopologyBuilds() const { return this->Rest.NumberOfBuilds; }
  /// How often the cells of points were searched.
  vtkIdType GetNumberOfLocationBuilds() const { return this->Embedded.NumberOfBuilds; }
  /// In all executions of the last update.
  vtkIdType NumberOfOutsidePoints = 0;

  std::size_t GetMemorySize() const;

private:
  bool Deform(vtkPointSet* input, vtkPointSet* rest, vtkPointSet* deformed,
    const DeformationOptions& options, vtkPointSet* output);
  bool Prepare(vtkPointSet* rest, vtkPointSet* deformed, const DeformationOptions& options);
  EmbeddedPoints* GuessEmbedded(vtkDataArray* points, const DeformationOptions& options) const;
  EmbeddedPoints* FindEmbedded(
    vtkDataArray* points, bool slopes, const DeformationOptions& options);
  void Use(EmbeddedPoints& embedded);

  RestMesh Rest;
  KeptEntries Embedded;
};

}

#endif
