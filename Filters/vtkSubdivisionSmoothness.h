// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionSmoothness
 * @brief   shows where a subdivision scheme is smooth on a mesh, and where it is known not to be
 *
 * Examines one step of a scheme around each vertex, and around the vertices that steps make inside
 * each edge and face: the leading eigenvalues of the local matrix, whether the conditions for a
 * smooth limit hold, and whether the characteristic map is regular and injective. All this depends
 * on how cells hang together, and on the rules, not on the shape. Vertices, edges and faces that
 * fail can be seen, selected and refined. The filter subdivides nothing and moves no point.
 *
 * @par Theory
 * Let 1, l1, l2, ... be the moduli of the eigenvalues of the matrix that takes a vertex and its
 * ring to the vertex and its ring one level later. Y.-S. Chang and H. Qin, "A Framework for
 * Multi-dimensional Adaptive Subdivision Objects", section 3, have for surfaces condition (23), 1 >
 * l1 >= l2 > l3, and for solids condition (24), 1 > l1 >= l2 >= l3 > l4, which they call empirical.
 * The eigenvectors of l1, l2 (and l3) are the characteristic map. U. Reif (1995) proved for
 * surfaces that the limit is C^1 if the condition holds and this map is regular and injective. For
 * solids the answers are necessary, and no proof. `Failing` is 1 where a condition does not hold or
 * the map is not regular or not injective. Figures: Documentation/Analysis.
 *
 * @par Which matrix
 * The dimension d of a vertex's rule decides. d = 3: all neighbours, condition (24). d = 2: the
 * neighbours in the surface or the boundary, condition (23). d = 1: the neighbours on the curve, 1
 * > l1 > l2. d = 0, a vertex that stays: no condition. Blended joints have eigenvalues of all their
 * neighbours and no condition. Each sector of a surface or a boundary at a vertex with d = 0 or 1,
 * from one curve to the next, is a cell of its own: there (23) has to hold with the eigenvalue of
 * the curve (of both curves at a corner) among l1 and l2, else the surface folds. Of edges and
 * faces inside solids the vertices that steps make in them are examined. On surfaces this is asked
 * of faces in CATMULL_CLARK and FOUR_EIGHT alone: all others are regular. In DOO_SABIN and MIDEDGE,
 * which keep no vertex, a vertex with k faces, or a face of k corners, is examined as a face of k
 * corners; boundaries are not examined there.
 *
 * @par Sampling
 * With SampleMaps the characteristic map is looked at by all faces of two further levels between
 * the first ring of a regular mesh around one such vertex and the image of this ring by a step:
 * faces keep their orientation (regular), and the first ring goes around once (injective), or less
 * than once at a curve. Solids: by all tetrahedra of the next level between the tetrahedra that
 * touch the vertex and three times as far. Points between are not looked at. Nothing is sampled
 * where a condition fails, at joints, and at vertices with octahedra.
 *
 * @par Inputs
 * Port 0: one data set that is no collection of blocks. Ports 1 and 2: marks, see
 * vtkMarkedSubdivisionAlgorithm. All options of vtkSubdivisionAlgorithm that choose rules count;
 * surface schemes ignore the options that vtkSurfaceSubdivision ignores, and take the outside of
 * solids, with a warning. With BOX_SPLINE and TET_OCT corners have the plain rules here, whatever
 * their angle. A crease or surface that is sharp to a finite degree has the rules that it has when
 * it has become smooth. Output of a subdivision filter has the rules of its next level.
 *
 * @par Output
 * A vtkUnstructuredGrid. Points: all points of the input with their ids and arrays, then centres of
 * split cells; point array `Failing` (unsigned char): 1 where a cell of the output fails, for
 * instance to refine there, by vtkRedGreenRefinement with RefineByArrayRange. Cells: a VTK_VERTEX
 * for each vertex, followed by one for each of its sectors; then a VTK_LINE for each edge; then a
 * triangle, quad or polygon for each face. Cell arrays of the input do not pass. Cell arrays:
 *  - `SimplexDimension` (unsigned char): 0, 1 or 2.
 *  - `RuleDimension` (signed char): 0 stays, 1 curve, 2 surface, 3 solid, 4 blended; sectors
 * have 2.
 *  - `Sector` (int): the number of the sector at its vertex; -1: the simplex itself.
 *  - `Valence` (int): neighbours of a vertex; triangles of a sector, or at an edge; tetrahedra at a
 *    face, or in surface schemes its corners.
 *  - `Eigenvalues` (double, six components L0 to L5): moduli, the largest first, 0 where the matrix
 * is too small; all 0: not examined. Of two steps in SQRT_THREE, FOUR_EIGHT and MIDEDGE.
 *  - `Condition`, `Regular`, `Injective` (signed char): 1 yes, 0 no, -1 there is no answer.
 *  - `Samples` (int): the triangles or tetrahedra at which the map was looked at.
 *  - `Failing` (unsigned char): 1 if one of the three is 0.
 *
 * @par Characteristic map
 * With MapOfCell the output is the characteristic map of that cell: the shape of the limit, looked
 * at from near, at the vertex, sector, edge or face, but for a linear map. Its points are the
 * eigenvectors of l1 and l2, and l3 in solids, after MapLevels further levels (SQRT_THREE,
 * FOUR_EIGHT and MIDEDGE: of two steps each). Complex eigenvalues have the real and the imaginary
 * part of a vector. Of all linear images the one is chosen whose points have equal moments in all
 * directions, whose middle is the origin, and whose first edge lies on the x axis, as long as in
 * the star. Cells are triangles, quads or tetrahedra.
 *  - `Jacobian` (cells, double): the size of a cell divided by its size in the star. Negative: the
 *    map folds there, and is not regular.
 *  - `Ring` (points, double): how many rings of the star the point is away from the middle.
 *  - `Eigenvalues` (field data, double, six values).
 *
 * @par Complexity
 * Equal matrices and equal stars are solved once; but inside solids nearly every vertex is one of
 * its kind. Its eigenvalues take some tenths of a millisecond, and its characteristic map, which is
 * sampled only with SampleMaps, some milliseconds.
 * Time grows with the third power of a vertex's number of neighbours.
 * So vertices of 600 and more neighbours are not examined, maps are sampled where up to 200
 * tetrahedra touch a vertex, edges have up to 100 tetrahedra, and stars of surfaces up to 99
 * triangles or 39 quads; in DOO_SABIN and MIDEDGE faces have up to 59 corners (39 for MapOfCell).
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools inside solids; the output is the same, bit for bit, for any number of
 * threads. Hidden cells take no part. Ghost arrays of cells do not pass.
 *
 * @par Errors
 * The filter stops, with an error and an empty output, if the input consists of blocks or is shared
 * by ranks, if an array cannot be used, if there are more cells to output than
 * MaximumNumberOfCells, if MapOfCell is no cell of the output or has no unique map (vertices and
 * edges on curves, corners, joints, boundaries in dual schemes, vertices with octahedra, Condition
 * 0), or if memory runs out.
 *
 * @sa
 * vtkSimplicialComplexTopology vtkMultiDimensionalSubdivision vtkSurfaceSubdivision
 */
#ifndef vtkSubdivisionSmoothness_h
#define vtkSubdivisionSmoothness_h

#include "vtkMarkedSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionSmoothness : public vtkMarkedSubdivisionAlgorithm
{
public:
  static vtkSubdivisionSmoothness* New();
  vtkTypeMacro(vtkSubdivisionSmoothness, vtkMarkedSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkUnstructuredGrid* GetOutput() { return this->GetUnstructuredGridOutput(); }

  /// The surface schemes in the order of vtkSurfaceSubdivision.
  enum Schemes
  {
    BOX_SPLINE,
    TET_OCT,
    LOOP,
    MODIFIED_BUTTERFLY,
    CATMULL_CLARK,
    DOO_SABIN,
    MIDEDGE,
    FOUR_EIGHT,
    SQRT_THREE,
    LINEAR
  };
  ///@{
  /**
   * The scheme that is examined: BOX_SPLINE (0, the default) and TET_OCT (1) of
   * vtkMultiDimensionalSubdivision, with curves and surfaces, or LOOP (2), MODIFIED_BUTTERFLY (3),
   * CATMULL_CLARK (4), DOO_SABIN (5), MIDEDGE (6), FOUR_EIGHT (7), SQRT_THREE (8), LINEAR (9; fails
   * at edges) of vtkSurfaceSubdivision.
   */
  vtkSetClampMacro(Scheme, int, BOX_SPLINE, LINEAR);
  vtkGetMacro(Scheme, int);
  void SetSchemeToBoxSpline() { this->SetScheme(BOX_SPLINE); }
  void SetSchemeToTetOct() { this->SetScheme(TET_OCT); }
  void SetSchemeToLinear() { this->SetScheme(LINEAR); }
  void SetSchemeToLoop() { this->SetScheme(LOOP); }
  void SetSchemeToCatmullClark() { this->SetScheme(CATMULL_CLARK); }
  void SetSchemeToModifiedButterfly() { this->SetScheme(MODIFIED_BUTTERFLY); }
  void SetSchemeToDooSabin() { this->SetScheme(DOO_SABIN); }
  void SetSchemeToMidedge() { this->SetScheme(MIDEDGE); }
  void SetSchemeToFourEight() { this->SetScheme(FOUR_EIGHT); }
  void SetSchemeToSqrtThree() { this->SetScheme(SQRT_THREE); }
  ///@}

  ///@{
  /**
   * Whether characteristic maps are sampled. If off, `Regular` and `Injective` are -1, and large
   * solids take a small part of the time. Off by default.
   */
  vtkSetMacro(SampleMaps, bool);
  vtkGetMacro(SampleMaps, bool);
  vtkBooleanMacro(SampleMaps, bool);
  ///@}

  ///@{
  /**
   * Whether only the cells are output at which something fails. Off by default.
   */
  vtkSetMacro(FailingOnly, bool);
  vtkGetMacro(FailingOnly, bool);
  vtkBooleanMacro(FailingOnly, bool);
  ///@}

  ///@{
  /**
   * The cell of the output whose characteristic map is output instead of all cells: its id as it is
   * with MapOfCell = -1 and the same FailingOnly. See "Characteristic map" above. Negative: all
   * cells are output; default -1.
   */
  vtkSetMacro(MapOfCell, vtkIdType);
  vtkGetMacro(MapOfCell, vtkIdType);
  ///@}

  ///@{
  /**
   * How often the characteristic map is subdivided further. 1 to 4, default 2.
   */
  vtkSetClampMacro(MapLevels, int, 1, 4);
  vtkGetMacro(MapLevels, int);
  ///@}

protected:
  vtkSubdivisionSmoothness();
  ~vtkSubdivisionSmoothness() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Scheme = BOX_SPLINE;
  bool SampleMaps = false;
  bool FailingOnly = false;
  vtkIdType MapOfCell = -1;
  int MapLevels = 2;

private:
  vtkSubdivisionSmoothness(const vtkSubdivisionSmoothness&) = delete;
  void operator=(const vtkSubdivisionSmoothness&) = delete;
};

#endif
