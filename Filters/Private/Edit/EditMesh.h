// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditMesh.h
 * Does the work of vtkSubdivisionEdit.
 */
#ifndef SubdivisionObjects_EditMesh_h
#define SubdivisionObjects_EditMesh_h

#include "Private/Reading/SelectedParts.h"
#include "Private/Run/RunOptions.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

enum class FalloffShapeKind
{
  Linear,
  Smooth,
  Sharp
};

struct EditOptions : RunOptions
{
  double Translation[3] = { 0., 0., 0. };
  double Rotation[3] = { 0., 0., 0. }; ///< in degrees
  double Scale[3] = { 1., 1., 1. };
  double Centre[3] = { 0., 0., 0. };
  bool IsLocal = false;
  double FalloffRadius = 0.;
  FalloffShapeKind Shape = FalloffShapeKind::Smooth;
  bool AlongEdges = false;
  std::vector<std::string> PaintedArrays;
  double PaintedValue = 1.;
  bool PaintsCells = false;
  bool AddsIds = false;

  bool MovesPoints() const;
};

/// One mesh of the input. `Readable` and `Rest` are made by MakeReadable.
struct EditedMesh
{
  vtkPointSet* Readable = nullptr;
  vtkPointSet* Rest = nullptr; ///< null: the edit is made on the input itself
  /// Points and cells of the mesh at rest, or else of the input; null: all.
  const SelectedParts* Selected = nullptr;

  vtkPointSet* GetBase() const { return this->Rest ? this->Rest : this->Readable; }
};

/// `input` is of any class, `output` of the same. Returns false after an error (passed to Fail) or
/// if Progress asks to stop.
bool EditMesh(
  vtkPointSet* input, const EditedMesh& mesh, const EditOptions& options, vtkPointSet* output);

}

#endif
