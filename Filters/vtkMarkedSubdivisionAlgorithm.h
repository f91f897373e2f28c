// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMarkedSubdivisionAlgorithm
 * @brief   common base of filters in which a user marks corners, creases and surfaces
 *
 * A mark makes a vertex, edge or triangle of the input singular, as if it were a cell that the
 * array at index 0 flags (see vtkSubdivisionAlgorithm), but no cell has to be there: points and
 * arrays of the output are, bit for bit, the same as of the input with such cells at its end. There
 * are four ways to mark, which may be used together: a point array, a selection, an implicit
 * function, and other geometry.
 *
 * @par Marked points
 * An array, a selection and a function mark points. MarkCorners, MarkCreases and MarkSurfaces say
 * which simplices become singular by them: the points themselves, edges between two of them, and
 * faces all of whose points are marked. Edges and faces belong to the input's cells; cuts through
 * cells that are split first do not count (of cells that are cut along their nodes, QuadraticCells,
 * all edges of the pieces do).
 *
 * @par Arrays read, by SetInputArrayToProcess
 * Besides the arrays of vtkSubdivisionAlgorithm (0 to 4):
 *  - 8, point array of marks: numbers, not 0 = marked. Unset: none. The output has zeros there,
 *    because the marks go on without it (see below).
 *  - 9, point array of the number of levels for which creases and surfaces between marked points
 *    stay sharp (see index 4; surfaces: only inside of solids): each has the smallest value of its
 *    points; infinite = for ever, 0 or less = not singular. Unset: none, and all stay for ever.
 *
 * @par Selection
 * Input port 1, optional: a vtkSelection of points or of cells of the input. Selected points are
 * marked points. Selected cells are singular as they are: vertices, lines and faces; a warning
 * tells of solids, which cannot be singular.
 *
 * @par Geometry
 * Input port 2, optional: a vtkPolyData or vtkUnstructuredGrid whose vertices, lines and polygons
 * are singular vertices, edges and triangles of the input. Its points have to be points of the
 * input (CreasePoints); a warning counts the cells that lie on none. Its cell array `Sharpness`, if
 * there is one, has the sharpness of lines and triangles.
 *
 * @par Filters in a row, blocks and ranks
 * As all singular simplices that no cell flags, marks go on to the next filter in field data of the
 * output. The next filter may mark more: then its input becomes the control mesh. Give a function
 * to the first filter only, because it marks new points, too. Blocks and ranks need no more than
 * their own part of the marks, and of the geometry.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSurfaceSubdivision vtkSimplicialComplexTopology
 */
#ifndef vtkMarkedSubdivisionAlgorithm_h
#define vtkMarkedSubdivisionAlgorithm_h

#include "vtkSmartPointer.h" // for vtkSmartPointer
#include "vtkSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class vtkAlgorithmOutput;
class vtkImplicitFunction;

class VTKSUBDIVISIONOBJECTS_EXPORT vtkMarkedSubdivisionAlgorithm : public vtkSubdivisionAlgorithm
{
public:
  vtkTypeMacro(vtkMarkedSubdivisionAlgorithm, vtkSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether marked points are corners, which do not move. On by default.
   */
  vtkSetMacro(MarkCorners, bool);
  vtkGetMacro(MarkCorners, bool);
  vtkBooleanMacro(MarkCorners, bool);
  ///@}

  ///@{
  /**
   * Whether edges between two marked points are creases. Off by default.
   */
  vtkSetMacro(MarkCreases, bool);
  vtkGetMacro(MarkCreases, bool);
  vtkBooleanMacro(MarkCreases, bool);
  ///@}

  ///@{
  /**
   * Whether faces all of whose points are marked are singular: smooth surfaces inside a solid; in a
   * surface the edges around them are creases. Off by default.
   */
  vtkSetMacro(MarkSurfaces, bool);
  vtkGetMacro(MarkSurfaces, bool);
  vtkBooleanMacro(MarkSurfaces, bool);
  ///@}

  ///@{
  /**
   * Whether points are marked at which MarkFunction is not positive. An error without a function.
   * Off by default.
   */
  vtkSetMacro(MarkByFunction, bool);
  vtkGetMacro(MarkByFunction, bool);
  vtkBooleanMacro(MarkByFunction, bool);
  ///@}

  ///@{
  /**
   * The function for MarkByFunction: a point is marked where it is 0 or negative, that is, inside a
   * box or sphere. None by default.
   */
  virtual void SetMarkFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetMarkFunction() const;
  ///@}

  enum CreasePointRules
  {
    COINCIDENT,
    SAME_ID
  };
  ///@{
  /**
   * Which point of the input a point of the geometry at port 2 is: COINCIDENT (0, the default; the
   * one at the same place, but for a millionth of the input's diagonal) or SAME_ID (1; the one of
   * the same global id, or of the same index where a mesh has no global ids; blocks and ranks need
   * them).
   */
  vtkSetClampMacro(CreasePoints, int, COINCIDENT, SAME_ID);
  vtkGetMacro(CreasePoints, int);
  void SetCreasePointsToCoincident() { this->SetCreasePoints(COINCIDENT); }
  void SetCreasePointsToSameId() { this->SetCreasePoints(SAME_ID); }
  ///@}

  /// Connects the selection.
  void SetMarkSelectionConnection(vtkAlgorithmOutput* output);
  /// Connects the geometry.
  void SetCreaseConnection(vtkAlgorithmOutput* output);

  /// Includes changes of the function.
  vtkMTimeType GetMTime() override;

protected:
  vtkMarkedSubdivisionAlgorithm();
  ~vtkMarkedSubdivisionAlgorithm() override;

  enum MarkArrayIndices
  {
    MARKS_ARRAY = 8,
    LEVELS_ARRAY = 9
  };
  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkSmartPointer<vtkDataObject> Mark(vtkDataObject* input, vtkDataObject* readable) override;
  bool ReadFeatureOptions(vtkPointSet* input, subdivision::RunOptions& options) override;
  void PrepareRun(vtkDataObject* input) override;

  bool MarkCorners = true;
  bool MarkCreases = false;
  bool MarkSurfaces = false;
  bool MarkByFunction = false;
  vtkSmartPointer<vtkImplicitFunction> MarkFunction;
  int CreasePoints = COINCIDENT;

private:
  vtkSmartPointer<vtkPointSet> Geometry; ///< of one execution, whole on each rank
  bool HasWholeInput = true;             ///< if not, the geometry may lie elsewhere

  vtkMarkedSubdivisionAlgorithm(const vtkMarkedSubdivisionAlgorithm&) = delete;
  void operator=(const vtkMarkedSubdivisionAlgorithm&) = delete;
};

#endif
