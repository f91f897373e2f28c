// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRedGreenRefinement
 * @brief   splits the cells of a mesh where detail is needed, and nowhere else
 *
 * The output is conforming: no hanging node and no T-junction, inside objects of any dimension and
 * between them.
 *
 * @par Algorithm
 * Y.-S. Chang and H. Qin, "A Framework for Multi-dimensional Adaptive Subdivision Objects", section
 * 4.2. In each round edges are marked by the criteria below, and the marks are closed: a triangle
 * with two marked edges marks its third, so that a tetrahedron has no, one, two opposite, the three
 * edges of one face, or all edges marked. Cells with all edges marked are split like by uniform
 * subdivision (red: a line into 2, a triangle into 4, a tetrahedron into 8), the others so that
 * they fit (green: a triangle into 2, a tetrahedron into 2 or 4). Before the next round all green
 * cells are undone, so that only red cells are ever refined: shapes do not get worse with the
 * number of rounds. The rounds end when no criterion marks anything, or at a limit.
 *
 * @par Criteria
 * An edge is marked where any criterion that is switched on asks for it; a criterion that asks for
 * a cell marks all of its edges. Each execution starts from the input, so that weaker criteria give
 * a coarser mesh.
 *
 * @par Arrays read, by SetInputArrayToProcess
 * Besides those of vtkSubdivisionAlgorithm (0 to 4, used where Placement is LIMIT or a criterion
 * asks for the limit):
 *  - 5, point array for RefineByAttributeError. Unset: the active scalars, else the first floating
 *    point array.
 *  - 6, cell or point array for RefineByArrayRange. Unset: the active scalars of the points, else
 *    those of the cells.
 *  - 7, integer cell array for RefineByWantedLevel. Unset: `WantedLevel` if there.
 *
 * @par Output
 * Points: those of the input with their ids, then centres of split cells, then the new ones. Cells:
 * in the order of the input, children in the place of their parent and oriented like it. Cells that
 * are no simplices are split first, see vtkSubdivisionAlgorithm. Point arrays get values at new
 * points (by their type, as in vtkMultiDimensionalSubdivision), children take the cell arrays of
 * their cell (ghost types too), field arrays pass through. The filter adds the cell arrays
 *  - `RefinementLevel` (unsigned char): how often the edges of an input cell were halved; a green
 *    cell has the level of the cell that it is a part of,
 *  - `RefinementKind` (unsigned char): 0 the cell as it was read, 1 red, 2 green by one edge, 3
 *    green by two opposite edges, 4 green by the three edges of a face,
 *  - `GreenParent` (vtkIdTypeArray): the tuple of `RedGreenLeaves` that a green cell is a part of,
 *    -1 for others,
 *  - `vtkOriginalCellIds` (vtkIdTypeArray): the cell of the input; if another filter of this kind
 *    made the input, that of its input, and levels and kinds count on from there,
 *
 * and the field arrays `RedGreenLeaves` (vtkIdTypeArray, ten components: the points of a cell that
 * was split green, and those on its edges 01, 02, 03, 12, 13, 23; -1 for none) and
 * `Subdivision` (the stamp by which the next filter recognises this output).
 *
 * @par Filters in a row
 * A red-green filter that reads the output of another one replaces its green cells by the cells of
 * which they are parts, and refines these; MaximumLevel counts from there. It leaves green cells as
 * they are if cells were changed in between, if cell arrays have different values in the green
 * parts of one cell (a warning says so), and if Placement or a criterion asks for the limit, which
 * does not exist for a mesh with points inside edges.
 *
 * @par Complexity
 * Time and memory are linear in the size of the input and the output; a round costs in proportion
 * to the cells that it changes and, where the limit is asked for, to the cells around these on all
 * levels before.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools; the output is the same, bit for bit, for any number of threads. Ghost
 * types of cells go to the children; marks do not cross the borders of partitions.
 *
 * @par Errors
 * An array that is named but cannot be used is an error. At MaximumNumberOfCells (here 50 million
 * by default), or where there is no more memory, refinement stops with a warning; the places with
 * the largest errors were refined first. It also stops with a warning where no number lies between
 * the ends of an edge. An empty selection and values that are not finite give warnings, too.
 *
 * @sa
 * vtkMultiDimensionalSubdivision
 */
#ifndef vtkRedGreenRefinement_h
#define vtkRedGreenRefinement_h

#include "vtkSmartPointer.h" // for vtkSmartPointer
#include "vtkSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <map>    // for std::map
#include <vector> // for std::vector

class vtkAlgorithmOutput;
class vtkImplicitFunction;
namespace subdivision
{
struct RedGreenOptions;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkRedGreenRefinement : public vtkSubdivisionAlgorithm
{
public:
  static vtkRedGreenRefinement* New();
  vtkTypeMacro(vtkRedGreenRefinement, vtkSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether edges are split along which the point array at index 5 has an error
   * (AttributeErrorKind) above AttributeTolerance. Several components are taken as a vector. An
   * edge with a value that is not finite is not split for this reason; a warning says how many
   * there are. On by default.
   */
  vtkSetMacro(RefineByAttributeError, bool);
  vtkGetMacro(RefineByAttributeError, bool);
  vtkBooleanMacro(RefineByAttributeError, bool);
  ///@}

  ///@{
  /**
   * The error that an edge may have, as a part of the array's range (of several components: the
   * diagonal of the box of their ranges), 0 or more. Default 0.1. With 0 every edge is split that
   * has any error.
   */
  vtkSetClampMacro(AttributeTolerance, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(AttributeTolerance, double);
  ///@}

  enum AttributeErrorKinds
  {
    JUMP,
    LIMIT_DIFFERENCE
  };
  ///@{
  /**
   * The error of an edge: JUMP (0, the default), the change of the values from one end to the
   * other, or LIMIT_DIFFERENCE (1), the largest difference between limit values along the edge and
   * the straight line between those of its ends, the limit being that of smooth subdivision.
   */
  vtkSetClampMacro(AttributeErrorKind, int, JUMP, LIMIT_DIFFERENCE);
  vtkGetMacro(AttributeErrorKind, int);
  void SetAttributeErrorKindToJump() { this->SetAttributeErrorKind(JUMP); }
  void SetAttributeErrorKindToLimitDifference() { this->SetAttributeErrorKind(LIMIT_DIFFERENCE); }
  ///@}

  ///@{
  /**
   * Whether cells are split whose value in the array at index 6 lies in ArrayRange (its ends
   * included): of a point array, that of any of the cell's points; of several components, their
   * Euclidean norm. Off by default.
   */
  vtkSetMacro(RefineByArrayRange, bool);
  vtkGetMacro(RefineByArrayRange, bool);
  vtkBooleanMacro(RefineByArrayRange, bool);
  ///@}

  ///@{
  /**
   * The values that RefineByArrayRange looks for. Default 0 to 1.
   */
  vtkSetVector2Macro(ArrayRange, double);
  vtkGetVector2Macro(ArrayRange, double);
  ///@}

  ///@{
  /**
   * Whether cells are split that the selection at input port 1 has, or that have a selected point.
   * Nodes of any kind that vtkExtractSelection knows, and an expression of them; of a composite
   * input, of some block or of all. Off by default; a warning says so if nothing is selected, or if
   * the selection cannot be evaluated.
   */
  vtkSetMacro(RefineBySelection, bool);
  vtkGetMacro(RefineBySelection, bool);
  vtkBooleanMacro(RefineBySelection, bool);
  ///@}

  /**
   * Connects a vtkSelection, for RefineBySelection.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* output);

  ///@{
  /**
   * Whether cells are split whose centroid lies inside the ImplicitFunction (where it is negative
   * or 0). Off by default.
   */
  vtkSetMacro(RefineByFunction, bool);
  vtkGetMacro(RefineByFunction, bool);
  vtkBooleanMacro(RefineByFunction, bool);
  ///@}

  ///@{
  /**
   * The function for RefineByFunction; none by default. Changes of it count as changes of the
   * filter.
   */
  virtual void SetImplicitFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetImplicitFunction() const;
  ///@}

  ///@{
  /**
   * Whether edges are split that are longer than MaximumEdgeLength. Off by default.
   */
  vtkSetMacro(RefineByEdgeLength, bool);
  vtkGetMacro(RefineByEdgeLength, bool);
  vtkBooleanMacro(RefineByEdgeLength, bool);
  ///@}

  ///@{
  /**
   * The length for RefineByEdgeLength, in the units of the coordinates, 0 or more. Default 1.
   */
  vtkSetClampMacro(MaximumEdgeLength, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * Whether edges of curves, surfaces, and boundaries or singular surfaces of solids are split
   * where they, or triangles at them, are farther than GeometricTolerance from the limit of smooth
   * subdivision. The distance is measured in several places of each edge and triangle: an estimate
   * and no bound. On edges of input cells it is the distance of the limit from the edge, inside an
   * input triangle that from the triangles there. Off by default.
   */
  vtkSetMacro(RefineByGeometricError, bool);
  vtkGetMacro(RefineByGeometricError, bool);
  vtkBooleanMacro(RefineByGeometricError, bool);
  ///@}

  ///@{
  /**
   * The distance that RefineByGeometricError allows, 0 or more. Default 0.001.
   */
  vtkSetClampMacro(GeometricTolerance, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(GeometricTolerance, double);
  ///@}

  ///@{
  /**
   * Whether GeometricTolerance is a part of the diagonal of the input's bounding box; else it is in
   * the units of the coordinates. On by default.
   */
  vtkSetMacro(RelativeTolerance, bool);
  vtkGetMacro(RelativeTolerance, bool);
  vtkBooleanMacro(RelativeTolerance, bool);
  ///@}

  ///@{
  /**
   * Whether edges of curves, surfaces, and boundaries or singular surfaces of solids are split over
   * which the limit of smooth subdivision turns by more than MaximumAngle. Off by default.
   */
  vtkSetMacro(RefineByCurvature, bool);
  vtkGetMacro(RefineByCurvature, bool);
  vtkBooleanMacro(RefineByCurvature, bool);
  ///@}

  ///@{
  /**
   * The angle that RefineByCurvature allows: that of the circle's arc which is as far from its
   * chord as the limit from the edge. It does not depend on the size of the mesh. In degrees, 0 to
   * 360. Default 10.
   */
  vtkSetClampMacro(MaximumAngle, double, 0., 360.);
  vtkGetMacro(MaximumAngle, double);
  ///@}

  ///@{
  /**
   * Whether cells are split whose level (the array `RefinementLevel` of the output) is below the
   * value of the array at index 7. Off by default.
   */
  vtkSetMacro(RefineByWantedLevel, bool);
  vtkGetMacro(RefineByWantedLevel, bool);
  vtkBooleanMacro(RefineByWantedLevel, bool);
  ///@}

  ///@{
  /**
   * How often the edges of an input cell may be halved, 0 to 60. Default 3. Filters in a row: up to
   * 255 times in all.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 60);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  enum Placements
  {
    LINEAR,
    LIMIT
  };
  ///@{
  /**
   * Where points are, and what values they have: LINEAR (0, the default): new ones in the middle of
   * their edge, the others stay: the shape does not change. LIMIT (1): all of them on the limit of
   * smooth subdivision, with all options of vtkSubdivisionAlgorithm, exact to rounding: where
   * levels 0 to infinity of vtkMultiDimensionalSubdivision end. The green cells of an earlier
   * filter stay what they are then.
   */
  vtkSetClampMacro(Placement, int, LINEAR, LIMIT);
  vtkGetMacro(Placement, int);
  void SetPlacementToLinear() { this->SetPlacement(LINEAR); }
  void SetPlacementToLimit() { this->SetPlacement(LIMIT); }
  ///@}

  /// The time of the last change, also of the implicit function.
  vtkMTimeType GetMTime() override;

protected:
  vtkRedGreenRefinement();
  ~vtkRedGreenRefinement() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool RefineByAttributeError = true;
  double AttributeTolerance = 0.1;
  int AttributeErrorKind = JUMP;
  bool RefineByArrayRange = false;
  double ArrayRange[2] = { 0., 1. };
  bool RefineBySelection = false;
  bool RefineByFunction = false;
  vtkSmartPointer<vtkImplicitFunction> ImplicitFunction;
  bool RefineByEdgeLength = false;
  double MaximumEdgeLength = 1.;
  bool RefineByGeometricError = false;
  double GeometricTolerance = 0.001;
  bool RelativeTolerance = true;
  bool RefineByCurvature = false;
  double MaximumAngle = 10.;
  bool RefineByWantedLevel = false;
  int MaximumLevel = 3;
  int Placement = LINEAR;

private:
  enum ArrayIndicesHere
  {
    ATTRIBUTE_ARRAY = 5,
    RANGE_ARRAY,
    LEVEL_ARRAY
  };
  /// Reads the criteria. Returns false, after an error message, if an array cannot be used.
  bool ReadCriteria(vtkPointSet* input, subdivision::RedGreenOptions& run);

  /// Counts nested updates: a composite input starts one update, each of its blocks another in it.
  void OnStart();
  void OnEnd();
  void FindSelected(vtkDataObject* input);

  int UpdateDepth = 0;
  bool IsComposite = false;
  /// Flags of the cells of each mesh where any are selected.
  std::map<vtkDataObject*, std::vector<unsigned char>> SelectedCells;

  vtkRedGreenRefinement(const vtkRedGreenRefinement&) = delete;
  void operator=(const vtkRedGreenRefinement&) = delete;
};

#endif
