// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RestMesh.h
 * The control mesh of a deformation. It is subdivided once, at rest, by the steps of the main
 * filter or of a surface scheme; its operators then apply to the deformed mesh as often as this
 * changes.
 */
#ifndef SubdivisionObjects_RestMesh_h
#define SubdivisionObjects_RestMesh_h

#include "Core/Operators/OperatorSequence.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Deformation/DeformationOptions.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

struct PlaceRequest;

/// Says in a sentence where the cells of two meshes first differ; empty if they are equal.
std::string CompareCells(vtkPointSet* rest, vtkPointSet* deformed);

class RestMesh
{
public:
  /// Subdivides the mesh, unless an equal one is kept. Returns false after an error (passed to
  /// Fail).
  bool Update(vtkPointSet* mesh, const DeformationOptions& options);

  /// The control points of the deformed mesh: its points, then the centres of split cells.
  vtkSmartPointer<vtkDataArray> MoveControlPoints(vtkPointSet* deformed) const;
  /// The points of the subdivided deformed mesh, from its control points by the operators of the
  /// rest mesh. Valid until the next call, and as long as `control` is.
  const double* MovePoints(vtkDataArray* control);

  /// Warns of input cells whose volume in the deformed mesh has another sign than at rest;
  /// `control` as MoveControlPoints gives it. Null: warns of cells that are inverted or flat at
  /// rest.
  void WarnOfInvertedCells(vtkDataArray* control, const DeformationOptions& options) const;

  /// Points of the subdivided mesh at rest, and its cells.
  vtkIdType GetNumberOfPoints() const;
  const double* GetPoints() const;
  bool HasCells() const { return !this->TetCorners.empty() || !this->OtherCorners.empty(); }
  /// Whether numbers of points and cells are too large to bind points to them.
  bool IsTooLarge() const { return this->TooLarge; }
  /// Whether the mesh has points in single precision.
  bool IsSingle() const;
  /// Which tetrahedra hold points or are nearest, and their corners.
  const SimplexTree& GetTets() const { return this->Tets; }
  const int* GetTetCorners() const { return this->TetCorners.data(); }
  /// Which triangles, lines and vertices are nearest to points. Made when first asked for.
  const SimplexTree& GetOthers();

  /// Finds places of the limit at rest. Returns false after an error (passed to Fail).
  bool FindPlaces(const PlaceRequest& request, const DeformationOptions& options);
  /// The control points at rest, as MoveControlPoints gives them.
  const double* GetControlPoints() const
  {
    return static_cast<const double*>(this->ControlPoints->GetVoidPointer(0));
  }

  /// Turns rows over the subdivided mesh into rows over the control points (of MoveControlPoints).
  /// Not for level 0, which has no operators.
  SparseRows<int> Compose(const SparseRows<int>& rows) const;
  /// Bytes that MovePoints reads of operators.
  std::size_t GetOperatorSize() const;

  void Clear();
  /// How often a mesh was subdivided anew.
  vtkIdType NumberOfBuilds = 0;

private:
  bool Build(vtkPointSet* control, const DeformationOptions& options);
  bool BuildUniform(vtkPointSet* control, const RunOptions& run, const DeformationOptions& options);
  bool BuildHybrid(vtkPointSet* control, const RunOptions& run, const DeformationOptions& options);
  void TakeCells(const SimplicesOfCells& cells);
  bool BuildSurface(vtkPointSet* control, const RunOptions& run, const DeformationOptions& options,
    const PlaceRequest* places = nullptr);

  vtkSmartPointer<vtkPointSet> Kept; ///< a copy of all that the operators depend on
  std::vector<double> Choices;
  SimplicesOfCells Control;                    ///< the mesh in simplices; of a surface its points
  vtkSmartPointer<vtkDataArray> ControlPoints; ///< at rest
  std::unique_ptr<OperatorSequence> Steps;     ///< null for no step
  vtkSmartPointer<vtkDataArray> Points;        ///< after the steps; without steps maybe at rest
  Buffer<double> MovedPoints;
  bool TooLarge = false;
  Buffer<int> TetCorners;
  Buffer<int> OtherCorners; ///< 3 for each other cell
  SimplexTree Tets;
  SimplexTree Others;
};

}

#endif
