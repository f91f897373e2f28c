// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionLimitProbe
 * @brief   the nearest places of a smooth object for given points
 *
 * Finds for each point the place of the limit that is nearest to it, with all values there. The
 * limit is what vtkMultiDimensionalSubdivision makes of the input after infinitely many levels:
 * curves, surfaces, and solids by the same VolumeScheme. A point inside a solid is its own nearest
 * place: the filter finds from where in the control mesh it comes. With another SurfaceScheme it is
 * what vtkSurfaceSubdivision makes of the polygons and lines: quads and other polygons then keep
 * their own parameters.
 *
 * @par Inputs
 * Port 0: the control mesh, one data set that is no collection of blocks. Ports 1 and 2: marks, see
 * vtkMarkedSubdivisionAlgorithm. Port 3: the points, of any data set; its cells do not matter.
 *
 * @par Output
 * A vtkPolyData with a vertex for each point, where the nearest place is, in double precision
 * unless OutputPointsPrecision says otherwise. Point arrays: those of the control mesh, smoothed,
 * as vtkMultiDimensionalSubdivision::EvaluateLimit has them; DerivativeU, DerivativeV, DerivativeW,
 * LimitNormals, MeanCurvature and GaussianCurvature, as there; `Distance` to the place; `CellId`,
 * the cell of the control mesh with the place; `CellParameters`, the parameters of the place there
 * as EvaluateLimit of the same scheme has them. In simplices they are the weights of the second,
 * third and fourth point. They are -1 in cells that the scheme cuts: for LOOP all that are no
 * vertices, lines, triangles or tetrahedra. The arrays of the points at port 3 follow, with their
 * ids; one whose name is taken gets OfPlace at the end of it. Field arrays of both are there, those
 * of the control mesh where names are equal.
 *
 * @par Arrays read, by SetInputArrayToProcess
 * Besides those of vtkMarkedSubdivisionAlgorithm:
 *  - 10, point array of angles of corners for ModifiedBoundary (property CornerAngleArray):
 *    numbers, in degrees, each of all sectors at the corner. Negative or not a number: the plain
 *    rule. Unset: none. With another SurfaceScheme than LOOP it is array 5 of
 *    vtkSurfaceSubdivision.
 *
 * @par Method
 * For a point that lies in a solid a fine level on the limit tells where to begin. For all others
 * curves, surfaces and the boundaries of solids are searched as a whole: the limit over parts of
 * cells as polynomials, parts of which are left out only where they are certainly not nearer than
 * a place that is known. Newton's method then makes the distance smaller, up to rounding, also
 * across the borders of cells; by CATMULL_CLARK it searches in quads. No place of the limit is
 * nearer by more than 1e-9 of the size of the mesh. Of equally near ones that in the first cell is
 * found. Where the boundary of a solid passes through the solid itself, a place of the boundary
 * may be found that lies inside.
 *
 * @par Points that are not finite
 * They have no place: their results are not a number, 0 in arrays of integers, `CellId` is -1, and
 * a warning counts them. Distances of points that are very far away do not overflow.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkProbeFilter
 */
#ifndef vtkSubdivisionLimitProbe_h
#define vtkSubdivisionLimitProbe_h

#include "vtkMarkedSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class vtkAlgorithmOutput;
class vtkPolyData;

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionLimitProbe : public vtkMarkedSubdivisionAlgorithm
{
public:
  static vtkSubdivisionLimitProbe* New();
  vtkTypeMacro(vtkSubdivisionLimitProbe, vtkMarkedSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkPolyData* GetOutput() { return this->GetPolyDataOutput(); }

  /// Connects the points, at port 3.
  void SetPlacesConnection(vtkAlgorithmOutput* output);

  ///@{
  /**
   * How the limit of solids is smoothed inside: BOX_SPLINE (0, the default) or TET_OCT (1; no
   * direction is preferred), see vtkMultiDimensionalSubdivision. Boundaries and creases are the
   * same. With another SurfaceScheme than LOOP there are no solids.
   */
  vtkSetClampMacro(VolumeScheme, int, BOX_SPLINE, TET_OCT);
  vtkGetMacro(VolumeScheme, int);
  void SetVolumeSchemeToBoxSpline() { this->SetVolumeScheme(BOX_SPLINE); }
  void SetVolumeSchemeToTetOct() { this->SetVolumeScheme(TET_OCT); }
  ///@}

  enum SurfaceSchemes
  {
    LOOP,
    CATMULL_CLARK,
    LOOP_OF_SURFACES
  };
  ///@{
  /**
   * Whose limit it is: LOOP (0, the default; that of vtkMultiDimensionalSubdivision, which has
   * solids, too), CATMULL_CLARK (1; that of vtkSurfaceSubdivision with Scheme = CATMULL_CLARK) or
   * LOOP_OF_SURFACES (2; that of vtkSurfaceSubdivision with Scheme = LOOP, which is flat in concave
   * sectors and joins seams). The latter two leave solids out with a warning, and their limit is
   * that of vtkSurfaceSubdivision with the same ModifiedBoundary.
   */
  vtkSetClampMacro(SurfaceScheme, int, LOOP, LOOP_OF_SURFACES);
  vtkGetMacro(SurfaceScheme, int);
  void SetSurfaceSchemeToLoop() { this->SetSurfaceScheme(LOOP); }
  void SetSurfaceSchemeToCatmullClark() { this->SetSurfaceScheme(CATMULL_CLARK); }
  void SetSurfaceSchemeToLoopOfSurfaces() { this->SetSurfaceScheme(LOOP_OF_SURFACES); }
  ///@}

  ///@{
  /**
   * Whether the rules of surfaces and of the boundaries of solids next to borders, creases and
   * corners are those of vtkMultiDimensionalSubdivision with the same option, so that the limit is
   * the one that it has. Off by default.
   */
  vtkSetMacro(ModifiedBoundary, bool);
  vtkGetMacro(ModifiedBoundary, bool);
  vtkBooleanMacro(ModifiedBoundary, bool);
  ///@}

protected:
  vtkSubdivisionLimitProbe();
  ~vtkSubdivisionLimitProbe() override;

  bool IsOfSurfaces() const override { return this->SurfaceScheme != LOOP; }
  bool HasOriginalCellIds() const override
  {
    return this->GenerateOriginalIds || this->IsOfSurfaces();
  }
  bool CanInterpolate() const override { return true; }
  bool ReadFeatureOptions(vtkPointSet* input, subdivision::RunOptions& options) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int VolumeScheme = BOX_SPLINE;
  int SurfaceScheme = LOOP;
  bool ModifiedBoundary = false;

private:
  vtkSubdivisionLimitProbe(const vtkSubdivisionLimitProbe&) = delete;
  void operator=(const vtkSubdivisionLimitProbe&) = delete;
};

#endif
