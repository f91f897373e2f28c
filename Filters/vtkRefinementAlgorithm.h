// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRefinementAlgorithm
 * @brief   common base of filters that refine a mesh locally: the criteria
 *
 * Refinement goes in rounds: in each one the criteria are asked where the mesh is too coarse, and
 * it is split there. The rounds end when no criterion asks for anything, or at a limit. How cells
 * are split, and how their neighbours are made to fit, is the filter's own.
 *
 * @par Criteria
 * Each has a switch RefineBy...; all that are on are asked together, and one is enough. A criterion
 * asks for edges or for cells; a cell that is asked for has all of its edges asked for.
 * vtkRedGreenRefinement splits these edges. vtkAdaptiveSurfaceSubdivision splits the triangles at
 * them; "an edge is split" below means these triangles there, and lines. Switch
 * RefineByAttributeError off, where it is on by default, if only the shape is to count. Each
 * execution starts from the input, so that weaker criteria give a coarser mesh. A new criterion is
 * added here, for all filters.
 *
 * @par Arrays read, by SetInputArrayToProcess
 * Besides the arrays of vtkSubdivisionAlgorithm (0 to 4):
 *  - 5, point array for RefineByAttributeError. Unset: the active scalars, else the first floating
 *    point array.
 *  - 6, cell or point array for RefineByArrayRange. Unset: the active scalars of the points, else
 *    of the cells.
 *  - 7, integer cell array for RefineByWantedLevel. Unset: `WantedLevel` if there.
 *
 * @par Errors
 * An array that is named but cannot be used is an error. At MaximumNumberOfCells, or where there
 * is no more memory, refinement stops with a warning; the places with the largest errors were
 * refined first. It also stops with a warning where no number lies between the ends of an edge. An
 * empty selection and values that are not finite give warnings, too.
 *
 * @sa
 * vtkRedGreenRefinement vtkAdaptiveSurfaceSubdivision
 */
#ifndef vtkRefinementAlgorithm_h
#define vtkRefinementAlgorithm_h

#include "vtkSmartPointer.h" // for vtkSmartPointer
#include "vtkSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <map>    // for std::map
#include <vector> // for std::vector

class vtkAlgorithmOutput;
class vtkImplicitFunction;
namespace subdivision
{
struct RefinementOptions;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkRefinementAlgorithm : public vtkSubdivisionAlgorithm
{
public:
  vtkTypeMacro(vtkRefinementAlgorithm, vtkSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether edges are split along which the point array at index 5 has a larger error
   * (AttributeErrorKind; of a vector) than AttributeTolerance; not if a value is not finite, which
   * a warning counts. Where there is no array, and nothing else is asked for, edges are split as by
   * RefineByGeometricError, and where default options ask for nothing, all edges are split, once.
   * On by default.
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
   * other, or LIMIT_DIFFERENCE (1), the largest difference between limit values in some places of
   * the edge and the straight line between the limits of its ends, by the rules of smooth
   * subdivision.
   */
  vtkSetClampMacro(AttributeErrorKind, int, JUMP, LIMIT_DIFFERENCE);
  vtkGetMacro(AttributeErrorKind, int);
  void SetAttributeErrorKindToJump() { this->SetAttributeErrorKind(JUMP); }
  void SetAttributeErrorKindToLimitDifference() { this->SetAttributeErrorKind(LIMIT_DIFFERENCE); }
  ///@}

  ///@{
  /**
   * Whether cells are split whose value in the array at index 6 lies in ArrayRange (its ends
   * included): of a point array, the value of any of the cell's points; of several components,
   * their Euclidean norm. Off by default.
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
   * and no bound. Off by default.
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
   * The angle that RefineByCurvature allows: the angle of the circle's arc which is as far from its
   * chord as the limit from the edge. It does not depend on the size of the mesh. In degrees, 0 to
   * 360. Default 10.
   */
  vtkSetClampMacro(MaximumAngle, double, 0., 360.);
  vtkGetMacro(MaximumAngle, double);
  ///@}

  ///@{
  /**
   * Whether cells are split whose level is below the value that the array at index 7 gives to their
   * input cell. Off by default.
   */
  vtkSetMacro(RefineByWantedLevel, bool);
  vtkGetMacro(RefineByWantedLevel, bool);
  vtkBooleanMacro(RefineByWantedLevel, bool);
  ///@}

  ///@{
  /**
   * How many levels an input cell may be refined, 0 to 60. Default 3. The filter says how a level
   * splits a cell.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 60);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  /// The time of the last change, also of the implicit function.
  vtkMTimeType GetMTime() override;

protected:
  vtkRefinementAlgorithm();
  ~vtkRefinementAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Prepare(vtkPointSet* block, vtkPointSet* copy) override;
  void Inspect(vtkDataObject* input, vtkDataObject* readable) override;

  /// The common part of RequestData in these filters: reads the criteria into `criteria`, then
  /// calls `refine`; all else as Run of the superclass.
  int RunRounds(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    subdivision::RunOptions& options, subdivision::RefinementOptions& criteria,
    const std::function<bool(vtkPointSet*, vtkPointSet*)>& refine);

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

private:
  enum ArrayIndicesHere
  {
    ATTRIBUTE_ARRAY = 5,
    RANGE_ARRAY,
    LEVEL_ARRAY
  };
  /// These return false, after an error message, if an array or function cannot be used.
  bool ReadCriteria(vtkPointSet* input, const subdivision::RunOptions& options,
    subdivision::RefinementOptions& criteria);
  bool ReadArrays(vtkPointSet* input, const subdivision::RunOptions& options,
    subdivision::RefinementOptions& criteria);
  void ReadSelection(vtkPointSet* input, subdivision::RefinementOptions& criteria);

  /// Flags of the cells of each mesh where any are selected.
  std::map<vtkDataObject*, std::vector<unsigned char>> SelectedCells;

  vtkRefinementAlgorithm(const vtkRefinementAlgorithm&) = delete;
  void operator=(const vtkRefinementAlgorithm&) = delete;
};

#endif
