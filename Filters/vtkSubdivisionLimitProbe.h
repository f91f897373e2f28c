// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionLimitProbe
 * @brief   the nearest places of a smooth object for given points
 *
 * Finds for each point the place of the limit that is nearest to it, with all values there. The
 * limit is the object that vtkMultiDimensionalSubdivision makes of the input after infinitely many
 * levels: curves, surfaces, and solids. A point inside a solid is its own nearest place: the filter
 * finds from where in the control mesh it comes. With Scheme = LOOP or CATMULL_CLARK the object is
 * the limit of the polygons and lines by vtkSurfaceSubdivision: by CATMULL_CLARK quads and other
 * polygons then keep their own parameters. With Scheme = HYBRID all cells do that stay whole.
 *
 * @par Inputs
 * Port 0: the control mesh, one data set that is no collection of blocks. Ports 1 and 2: marks, see
 * vtkMarkedSubdivisionAlgorithm. Port 3: the points, of any data set; its cells do not matter.
 *
 * @par Output
 * A vtkPolyData with a vertex for each point, where the nearest place is, in double precision
 * unless OutputPointsPrecision says otherwise. Point arrays: the arrays of the control mesh,
 * smoothed, as vtkMultiDimensionalSubdivision::EvaluateLimit has them; DerivativeU, DerivativeV,
 * DerivativeW, LimitNormals, MeanCurvature and GaussianCurvature, as there; `Distance` to the
 * place; `CellId`, the cell of the control mesh with the place; `CellParameters`, the parameters of
 * the place there as EvaluateLimit of the same scheme has them. In simplices they are the weights
 * of the second, third and fourth point, by HYBRID in other cells those of VTK. They are -1 in
 * cells that the scheme cuts: but for CATMULL_CLARK and HYBRID all that are no vertices, lines,
 * triangles or tetrahedra. The arrays of the points
 * at port 3 follow, with their ids; one whose name is taken gets OfPlace at the end of it. Field
 * arrays of both are there, the control mesh's where names are equal.
 *
 * @par Method
 * For a point that lies in a solid a fine level on the limit tells where to begin. For all others
 * curves, surfaces and the boundaries of solids are searched as a whole: the limit over parts of
 * cells as polynomials, parts of which are left out only where they are certainly not nearer than
 * a place that is known. Newton's method then makes the distance smaller, up to rounding, also
 * across the borders of cells; by CATMULL_CLARK it searches in quads, by HYBRID in simplices into
 * which it cuts parameters, not the limit. No place of the limit is
 * nearer by more than 1e-9 of the size of the mesh. Of equally near ones the place in the first
 * cell is found. Where the boundary of a solid passes through the solid itself, a place of the
 * boundary may be found that lies inside.
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

  enum Schemes
  {
    BOX_SPLINE,
    TET_OCT,
    LINEAR,
    LOOP,
    CATMULL_CLARK,
    HYBRID,
    AUTOMATIC
  };
  ///@{
  /**
   * Whose limit it is. The limit of vtkMultiDimensionalSubdivision, with curves, surfaces and
   * solids: BOX_SPLINE (0, the default), TET_OCT (1; no direction is preferred inside solids;
   * boundaries and creases are the same), LINEAR (2; the mesh itself), HYBRID (5; hexahedra,
   * wedges, pyramids and quads stay whole) or AUTOMATIC (6; HYBRID for a mesh with such cells, else
   * BOX_SPLINE). A place by HYBRID takes up to a second, so it is no default; the filter warns
   * where BOX_SPLINE cuts cells that vtkMultiDimensionalSubdivision keeps by default. Or the limit
   * of the polygons and lines by vtkSurfaceSubdivision, which measures angles of corners and joins
   * seams: LOOP (3) or CATMULL_CLARK (4); of solids the outside, with a warning.
   */
  vtkSetClampMacro(Scheme, int, BOX_SPLINE, AUTOMATIC);
  vtkGetMacro(Scheme, int);
  void SetSchemeToBoxSpline() { this->SetScheme(BOX_SPLINE); }
  void SetSchemeToTetOct() { this->SetScheme(TET_OCT); }
  void SetSchemeToLinear() { this->SetScheme(LINEAR); }
  void SetSchemeToLoop() { this->SetScheme(LOOP); }
  void SetSchemeToCatmullClark() { this->SetScheme(CATMULL_CLARK); }
  void SetSchemeToHybrid() { this->SetScheme(HYBRID); }
  void SetSchemeToAutomatic() { this->SetScheme(AUTOMATIC); }
  ///@}

protected:
  vtkSubdivisionLimitProbe();
  ~vtkSubdivisionLimitProbe() override;

  bool IsOfSurfaces() const override
  {
    return this->Scheme == LOOP || this->Scheme == CATMULL_CLARK;
  }
  bool HasOriginalCellIds() const override
  {
    return this->GenerateOriginalIds || this->IsOfSurfaces();
  }
  bool CanInterpolate() const override { return true; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Scheme = BOX_SPLINE;

private:
  vtkSubdivisionLimitProbe(const vtkSubdivisionLimitProbe&) = delete;
  void operator=(const vtkSubdivisionLimitProbe&) = delete;
};

#endif
