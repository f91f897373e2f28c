// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformSubdivision.h
 * Does the work of vtkMultiDimensionalSubdivision.
 */
#ifndef SubdivisionObjects_UniformSubdivision_h
#define SubdivisionObjects_UniformSubdivision_h

#include "Private/Run/RunOptions.h"
#include "Private/Uniform/OperatorCache.h"

class vtkDataArray;
class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct UniformOptions : LevelOptions
{
  StampScheme Scheme = StampScheme::BoxSpline; ///< of solids
  bool GenerateClassification = false;
  bool MovesPoints() const
  {
    return this->ProjectToLimit || (this->Levels > 0 && this->Scheme != StampScheme::Linear);
  }
  bool KeepsCopies = false;   ///< all cells of a part, also of others, are made to the end
  bool KeepCellTypes = false; ///< smooth unless with StampScheme::Linear
  /// Whether to do so where a cell would be cut, and neither an option nor a cell forbids it.
  bool KeepsTypesIfPossible = false;
  /// The name of a wish that needs cut cells; null: there is none.
  const char* NeedsCuts = nullptr;
};

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool SubdivideUniformly(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output);
/// The same of a mesh whose sides are joined, with the texture coordinates of the mesh before,
/// `torn`: they are subdivided there, with corners by FindSeamCorners (UniformSeams.cxx). Both
/// meshes have their cells in the same order. Points on seams get copies, which come after all
/// others.
bool SubdivideWithSeams(vtkPointSet* joined, vtkPointSet* torn, const UniformOptions& options,
  vtkUnstructuredGrid* output);
/// The same with KeepCellTypes: every cell keeps its type, linear or, by another scheme, smooth
/// (HybridRun.cxx).
bool RefineKeepingTypes(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output);
/// Whether a mesh has cells that keep their types there, and are cut elsewhere.
bool HasUncutCells(vtkPointSet* input);

/// The arrays of a finished output that say what is still sharp, marked or of others.
void FinishArrays(vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output);

/// The operators of the steps from one mesh, and the mesh after them.
struct UniformOperators
{
  SimplicesOfCells Control;             ///< the cells of the mesh as simplices
  std::unique_ptr<KeptSteps> Steps;     ///< null for no step
  UniformCells Cells;                   ///< after the steps
  vtkSmartPointer<vtkDataArray> Points; ///< of these; for no step maybe of the mesh
};

/// Finds the operators without an output. Returns false after an error (passed to Fail) or if
/// Progress asks to stop.
bool FindUniformOperators(
  vtkPointSet* input, const UniformOptions& options, UniformOperators& operators);

}

#endif
