// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionEdit
 * @brief   moves selected points of a mesh, and paints arrays
 *
 * Moves the points of a selection by a translation, rotation and scale, with a falloff around them,
 * and sets arrays on the selected points or cells to a value. It stands in front of a filter that
 * subdivides, or between two of them: the cells and the stamp of the input stay, so that the next
 * filter goes on with the levels of the one before. With Frame = LOCAL a displacement turns and
 * stretches with the object, so that details of a fine level follow when a coarse level is changed.
 *
 * @par Algorithm
 * A point x of weight w goes to x + w (T(x) - x), where T scales about Centre, then turns about y,
 * x and z through it, as vtkProp3D does, and then translates. The weight is 1 at selected points
 * and 0 from FalloffRadius on (FalloffShape, FalloffAlong). Several edits are several filters in a
 * row.
 *
 * @par Local frames
 * D. Zorin, P. Schroeder and W. Sweldens, "Interactive Multiresolution Mesh Editing", keep details
 * in frames of the limit. Here the edit is made on the mesh at rest (input port 2): its points are
 * selected, weighed and transformed. Each displacement is then multiplied by the linear map that
 * takes the vectors of the limit at this point of the mesh at rest to those of the input: on
 * surfaces and boundaries of solids two tangents and a normal that is as long as they are in the
 * mean, on curves the tangent, the direction of the bend and the perpendicular of both, inside
 * solids the edges around the point, of which the map is the best in the sense of least squares. At
 * joints and corners, and where these vectors lie in a plane but for rounding, it is the identity,
 * on straight curves the smallest rotation that turns one tangent to the other. If the input is the
 * mesh at rest rotated and scaled, then so is the output, but for rounding, except at joints.
 *
 * Without a mesh at rest Rotation, Scale and Centre have no effect in LOCAL frames: Translation is
 * along the first tangent, across it, and along the normal (on curves the tangent, the bend and the
 * perpendicular), elsewhere along the axes, and all lengths, FalloffRadius too, are multiples of
 * the mean length of the edges at selected points.
 *
 * The vectors are the arrays `LimitTangent1`, `LimitTangent2` and `LimitNormals` if input and mesh
 * at rest have them, else those that vtkMultiDimensionalSubdivision makes with its defaults.
 *
 * @par Inputs
 *  - port 0: any vtkPointSet, or a composite data set of these.
 *  - port 1, not required: a vtkSelection of points or cells by ids, values, thresholds, places or
 * a frustum. Points of selected cells are selected, and so are cells all of whose points are.
 *    Without a selection everything is selected.
 *  - port 2, not required, for Frame = LOCAL: the mesh at rest, with as many points and cells in
 *    each block as the input.
 *
 * @par Output
 * The input with other points, of their type, and other values of painted arrays. Where a point
 * moves, active normals of points and cells, `LimitNormals`, `LimitTangent1` and `LimitTangent2`
 * are left out. All other arrays pass through.
 *
 * @par Complexity
 * Linear in the size of the mesh; n log n with a falloff. Local frames cost as much as vectors of
 * the limit at no level.
 *
 * @par Threads and ranks
 * The same bits for any number of threads. Each block, and each rank, is edited by itself: a
 * falloff does not see selected points of others.
 *
 * @par Errors
 * The output is the input, with an error, if the mesh at rest does not fit, if its selection has a
 * fault, or if a point or a painted value would be beyond what its array can hold. The filter warns
 * where nothing is selected, where an array has no numbers, and where a number is rounded.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSubdivisionDeformation vtkTransformFilter
 */
#ifndef vtkSubdivisionEdit_h
#define vtkSubdivisionEdit_h

#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <string> // for std::string
#include <vector> // for std::vector

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionEdit : public vtkPassInputTypeAlgorithm
{
public:
  static vtkSubdivisionEdit* New();
  vtkTypeMacro(vtkSubdivisionEdit, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Connects the selection.
  void SetSelectionConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  /// Connects the mesh at rest.
  void SetRestMeshConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }

  ///@{
  /**
   * How far selected points move along the axes of the frame. Default 0.
   */
  vtkSetVector3Macro(Translation, double);
  vtkGetVector3Macro(Translation, double);
  ///@}

  ///@{
  /**
   * By which angles selected points turn about the axes x, y and z, in degrees: first about y, then
   * about x, then about z. Default 0.
   */
  vtkSetVector3Macro(Rotation, double);
  vtkGetVector3Macro(Rotation, double);
  ///@}

  ///@{
  /**
   * The factors by which distances of selected points from the centre grow along the axes. Default
   * 1.
   */
  vtkSetVector3Macro(Scale, double);
  vtkGetVector3Macro(Scale, double);
  ///@}

  ///@{
  /**
   * The point about which Rotation and Scale act. Default 0.
   */
  vtkSetVector3Macro(Centre, double);
  vtkGetVector3Macro(Centre, double);
  ///@}

  enum Frames
  {
    WORLD,
    LOCAL
  };
  ///@{
  /**
   * In which axes displacements are kept: WORLD (0, the default) or LOCAL (1; those of the limit at
   * each point, see above).
   */
  vtkSetClampMacro(Frame, int, WORLD, LOCAL);
  vtkGetMacro(Frame, int);
  void SetFrameToWorld() { this->SetFrame(WORLD); }
  void SetFrameToLocal() { this->SetFrame(LOCAL); }
  ///@}

  ///@{
  /**
   * The distance from selected points at which others stay where they are, 0 or more. Default 0:
   * only selected points move.
   */
  vtkSetClampMacro(FalloffRadius, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(FalloffRadius, double);
  ///@}

  enum FalloffShapes
  {
    LINEAR,
    SMOOTH,
    SHARP
  };
  ///@{
  /**
   * The weight at the part t of FalloffRadius, with s = 1 - t: LINEAR (0; s), SMOOTH (1, the
   * default; 3 s s - 2 s s s, smooth at both ends) or SHARP (2; s s).
   */
  vtkSetClampMacro(FalloffShape, int, LINEAR, SHARP);
  vtkGetMacro(FalloffShape, int);
  void SetFalloffShapeToLinear() { this->SetFalloffShape(LINEAR); }
  void SetFalloffShapeToSmooth() { this->SetFalloffShape(SMOOTH); }
  void SetFalloffShapeToSharp() { this->SetFalloffShape(SHARP); }
  ///@}

  enum FalloffPaths
  {
    SPACE,
    EDGES
  };
  ///@{
  /**
   * Along what the distance from selected points is measured: SPACE (0, the default; straight) or
   * EDGES (1; along edges of cells and of the simplices that they are cut into, so that parts which
   * are only near stay).
   */
  vtkSetClampMacro(FalloffAlong, int, SPACE, EDGES);
  vtkGetMacro(FalloffAlong, int);
  void SetFalloffAlongToSpace() { this->SetFalloffAlong(SPACE); }
  void SetFalloffAlongToEdges() { this->SetFalloffAlong(EDGES); }
  ///@}

  ///@{
  /**
   * The names of the arrays that are painted; none: nothing is painted. An array that the input
   * does not have is added, with zeros elsewhere. All components get the value.
   */
  void AddPaintedArray(const char* name);
  void RemoveAllPaintedArrays();
  ///@}

  ///@{
  /**
   * The value that painted arrays get at selected points or cells. Floating point numbers are
   * blended with it by the weights of the falloff, in cells by the mean of their points; integers
   * get it where they are selected. Default 1.
   */
  vtkSetMacro(PaintedValue, double);
  vtkGetMacro(PaintedValue, double);
  ///@}

  enum PaintedParts
  {
    PAINT_POINTS,
    PAINT_CELLS
  };
  ///@{
  /**
   * Whose arrays are painted: PAINT_POINTS (0, the default) or PAINT_CELLS (1).
   */
  vtkSetClampMacro(Painted, int, PAINT_POINTS, PAINT_CELLS);
  vtkGetMacro(Painted, int);
  void SetPaintedToPoints() { this->SetPainted(PAINT_POINTS); }
  void SetPaintedToCells() { this->SetPainted(PAINT_CELLS); }
  ///@}

  enum AddedArrayTypes
  {
    ADD_NUMBERS,
    ADD_IDS
  };
  ///@{
  /**
   * What an array holds that is added: ADD_NUMBERS (0, the default; double, for values and
   * sharpness) or ADD_IDS (1; int, for materials, parts and flags).
   */
  vtkSetClampMacro(AddedArrays, int, ADD_NUMBERS, ADD_IDS);
  vtkGetMacro(AddedArrays, int);
  void SetAddedArraysToNumbers() { this->SetAddedArrays(ADD_NUMBERS); }
  void SetAddedArraysToIds() { this->SetAddedArrays(ADD_IDS); }
  ///@}

protected:
  vtkSubdivisionEdit();
  ~vtkSubdivisionEdit() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Translation[3] = { 0., 0., 0. };
  double Rotation[3] = { 0., 0., 0. };
  double Scale[3] = { 1., 1., 1. };
  double Centre[3] = { 0., 0., 0. };
  int Frame = WORLD;
  double FalloffRadius = 0.;
  int FalloffShape = SMOOTH;
  int FalloffAlong = SPACE;
  std::vector<std::string> PaintedArrays;
  double PaintedValue = 1.;
  int Painted = PAINT_POINTS;
  int AddedArrays = ADD_NUMBERS;

private:
  vtkSubdivisionEdit(const vtkSubdivisionEdit&) = delete;
  void operator=(const vtkSubdivisionEdit&) = delete;
};

#endif
