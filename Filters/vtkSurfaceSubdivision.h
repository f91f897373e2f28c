// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceSubdivision
 * @brief   classical subdivision surfaces on any polygon mesh
 *
 * Subdivides the polygons of a vtkPolyData by one of several schemes, piecewise smoothly: with
 * boundaries, creases that may fade out or be sharp for some levels only, and convex and concave
 * corners.
 *
 * @par Algorithm
 * D. Zorin, "Subdivision on Arbitrary Meshes: Algorithms and Theory", sections 3 and 4, and for
 * sqrt(3) L. Kobbelt, "sqrt(3)-Subdivision". Next to a boundary, crease or corner the rules depend
 * on the number of faces in the sector and, at corners, on its angle; at concave corners the points
 * around are also flattened, so that the surface does not fold (section 3.2); for SqrtThree and
 * FourEight these rules are the project's own. ModifiedBoundary off gives the plain rules. All
 * weights, limits and spectra, and the five differences between Loop here and in
 * vtkMultiDimensionalSubdivision: Documentation/Mathematics.md, sections 11 and 12.
 *
 * @par Modified Butterfly
 * Points stay, because the scheme interpolates, and are on the limit. Boundaries, creases and lines
 * have the four-point rule. Corners need no flatness and have it only if it is given. Vertices
 * where a crease ends count as extraordinary. ModifiedBoundary changes nothing. New points are
 * exact for cubic functions inside regular meshes, for quadratic ones at regular curves, and for
 * linear ones between two regular curves.
 *
 * @par Input and output
 * Polygons of any size, and strips, which become triangles in their place. Of the solids of a grid
 * the outside, after its polygons, with a warning: faces that no other solid and no polygon has;
 * where blocks or ranks share the mesh solids are left out. Loop, ModifiedButterfly,
 * SqrtThree and Linear split other polygons into triangles first. A line cell
 * that lies on an edge follows it; others are curves of their own, cubic B-splines. Poly lines
 * become lines, vertex cells stay. The output, a vtkPolyData unless OutputCells makes curved cells,
 * has vertices, lines and polygons, in this order, the children of a cell one after another and
 * oriented like it (dual schemes: see below). Points: the input's with their ids, unused ones too,
 * then the new ones level by level. Arrays and field data are treated as by
 * vtkMultiDimensionalSubdivision. Cells that cannot be used are left out with a warning.
 *
 * @par Cell data of cells that lie in several input cells
 * Odd steps of SqrtThree and FourEight and all steps of the dual schemes make cells that lie in
 * several cells of the level before. Each belongs to the input cell, or to the edge or vertex
 * between input cells, in which its centre lies in the parameters, and shows the data of the input
 * cell with the smallest id there. Children do not inherit this choice, so that regions keep their
 * areas but for one row of cells. Where an input cell has no cell of its own, the field array
 * `SubdivisionCarried:LEVEL:NAME` has its data for the next filter, as long as cells show no
 * others.
 *
 * @par Dual schemes
 * DooSabin makes a face inside each face, one along each edge and one around each vertex. Midedge
 * joins the midpoints of edges: it makes a face inside each face and one around each vertex; odd
 * steps keep boundary points, even ones do not. No input point is an output point: points are new,
 * in the order of the corners of faces, and vtkOriginalPointIds is -1. The faces inside faces come
 * first, then the others, oriented like the first face that they touch. Boundaries are quadratic
 * B-splines; sheets come apart at edges of three and more faces, and fans at vertices. Lines and
 * vertex cells get points of their own, also where they lie on the surface. The limit of a point
 * lies at the face which the next step makes around it; where several fans of faces meet, at the
 * face of the first one. DooSabin has two tangents inside and on boundaries; Midedge has two inside
 * at points of four and more faces, and one along boundaries. Points of Midedge, and of FourEight
 * on quads, that can be coloured with two colours have no control points for InterpolatePoints; a
 * warning says so.
 *
 * @par Creases and corners
 * Sharp are boundaries, edges of line cells that the array at index 0 flags, edges around flagged
 * polygons, with PreserveInterfaces edges between faces of different materials, with
 * DetectFeatures edges where the surface turns by more than FeatureAngle, and edges that do not
 * have two faces. A vertex with two sharp edges lies on a curve; with three or more, or
 * if it is a flagged vertex cell, it is a corner. A smooth boundary vertex with one face is a
 * corner too for CatmullClark, ModifiedButterfly and FourEight. The dual schemes, DooSabin and
 * Midedge, have no creases and corners: with a warning they ignore options and arrays that ask for
 * them. Corners are convex or concave by the sum of the face angles in each sector, measured on the
 * input and kept in [22.5, 157.5] and [202.5, 337.5] degrees. For floor(s) levels a crease of
 * sharpness s is one that is flagged, with its ends, crossings and all near it. In the next level
 * it is so in part, s - floor(s), between the rows without and with all creases that are left in
 * part. An infinite one is flagged.
 *
 * SqrtThree and FourEight leave curves alone in odd steps. They replace all other edges, so that
 * line cells are creases with any flag or sharpness, and an end of a crease is a corner. FourEight
 * has triangles on curves after odd steps.
 *
 * @par Non-manifold input
 * Edges with three and more faces, vertices where fans of faces or lines meet: Loop follows
 * Type1Rule to Type3Rule as the main filter does; the other schemes take such edges as sharp curves
 * and such vertices as corners. Surfaces need not be orientable. Equal faces count as two.
 *
 * @par Arrays read, by SetInputArrayToProcess
 * Besides flags and sharpness of lines (0 and 4, see vtkSubdivisionAlgorithm), and angles of
 * corners with one sector (10):
 *  - 6, flatness: point array of s in [0, 1]. Negative: 0 at convex corners, at concave ones the
 *    value that makes them tangent plane continuous. Unset: none.
 *  - 14, normals (property NormalArray): point array of vectors of any length. Control points move
 *    along each of them, as little as possible, until the limit of its point has this normal, on
 *    creases on the side of the first face; with InterpolatePoints the limit keeps to its points,
 *    too. Zero: the normal is free. Not on the output of a filter that made levels. Unset: none.
 *
 * @par Arrays written
 * On request `LimitNormals`, `LimitTangent1`, `LimitTangent2` (points, 3 components),
 * `vtkOriginalPointIds` and `vtkOriginalCellIds`; always field arrays `SubdivisionSurface...`, by
 * which this filter recognises its own output.
 *
 * @par Filters in a row
 * Three filters of one level and the same options give the output of one filter of three levels,
 * bit for bit, for every scheme; Midedge, FourEight and SqrtThree continue with the right parity,
 * the last two with the flags of the first input. Angles and flatness of corners come from the
 * first input. After ProjectToLimit, or if cells were changed in between, the next filter takes the
 * mesh for a new one. Only the first filter knows global ids. On several ranks filters of LOOP,
 * MODIFIED_BUTTERFLY, CATMULL_CLARK and LINEAR go on as long as the cells of each rank stay
 * together; else, and with the other schemes, the next one takes the mesh for a new one, and warns.
 * One filter with all levels has the same output on any number of ranks.
 *
 * @par Complexity
 * Time and memory are linear in the size of the output; incidences are searched on the input only.
 * But ModifiedButterfly takes k^2 steps around a vertex of k faces, about five times as many with
 * normals or tangents, and DooSabin in a polygon of k corners. Rows of the operator are made block
 * by block while they are applied and never stored.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools; the output is the same, bit for bit, for any number of threads. Hidden
 * cells are left out; ghost cells are subdivided like others.
 *
 * @par Other libraries
 * On closed meshes the points are the same as of VTK (Butterfly), OpenMesh (Butterfly,
 * Catmull-Clark, sqrt(3)) and CGAL (Catmull-Clark, Doo-Sabin, sqrt(3)), and with LoopWeights =
 * LOOP_WEIGHTS as of the Loop schemes of OpenSubdiv, OpenMesh, CGAL and VTK; by default Loop has
 * Warren's weights, which are the same at vertices of three and six faces only. With
 * ModifiedBoundary off the boundaries of Loop are the same as of OpenSubdiv, OpenMesh and CGAL,
 * too, and of Catmull-Clark as of CGAL.
 *
 * @par Errors
 * The filter stops, with an error and an empty output, if the output would have more than
 * MaximumNumberOfCells cells or take more memory than there is, or if ModifiedButterfly, DooSabin
 * or limits of FourEight would take more than 4 * 10^8 of the steps above (k = 20,000 for one
 * level, 6,000 with normals). Other topology is never an error.
 *
 * @sa
 * vtkAdaptiveSurfaceSubdivision vtkMultiDimensionalSubdivision vtkLoopSubdivisionFilter
 * vtkButterflySubdivisionFilter
 */
#ifndef vtkSurfaceSubdivision_h
#define vtkSurfaceSubdivision_h

#include "vtkSubdivisionObjectsModule.h" // for export macro
#include "vtkUniformSubdivisionAlgorithm.h"

#include <array> // for std::array

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSurfaceSubdivision : public vtkUniformSubdivisionAlgorithm
{
public:
  static vtkSurfaceSubdivision* New();
  vtkTypeMacro(vtkSurfaceSubdivision, vtkUniformSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output; null if it has curved cells (OutputCells). Then GetOutputDataObject(0) has it, a
  /// vtkUnstructuredGrid.
  vtkPolyData* GetOutput() { return this->GetPolyDataOutput(); }

  enum Schemes
  {
    LOOP,
    MODIFIED_BUTTERFLY,
    CATMULL_CLARK,
    DOO_SABIN,
    MIDEDGE,
    FOUR_EIGHT,
    SQRT_THREE,
    LINEAR,
    AUTOMATIC
  };
  ///@{
  /**
   * The scheme: AUTOMATIC (8, the default; CATMULL_CLARK where quads and larger polygons are more
   * than the triangles, else LOOP; one scheme for all blocks, and for the ranks that share a mesh;
   * of a mesh with solids alone their faces count), LOOP (0; triangles to 4), MODIFIED_BUTTERFLY
   * (1; triangles to 4, interpolates the points), CATMULL_CLARK (2; polygons to quads), DOO_SABIN
   * (3; dual), MIDEDGE (4; dual), FOUR_EIGHT (5; two steps split a quad into 4), SQRT_THREE (6;
   * triangles to 3) or LINEAR (7; triangles to 4, not smoothed: points stay, new ones are
   * midpoints).
   */
  vtkSetClampMacro(Scheme, int, LOOP, AUTOMATIC);
  vtkGetMacro(Scheme, int);
  void SetSchemeToLoop() { this->SetScheme(LOOP); }
  void SetSchemeToModifiedButterfly() { this->SetScheme(MODIFIED_BUTTERFLY); }
  void SetSchemeToCatmullClark() { this->SetScheme(CATMULL_CLARK); }
  void SetSchemeToDooSabin() { this->SetScheme(DOO_SABIN); }
  void SetSchemeToMidedge() { this->SetScheme(MIDEDGE); }
  void SetSchemeToFourEight() { this->SetScheme(FOUR_EIGHT); }
  void SetSchemeToSqrtThree() { this->SetScheme(SQRT_THREE); }
  void SetSchemeToLinear() { this->SetScheme(LINEAR); }
  void SetSchemeToAutomatic() { this->SetScheme(AUTOMATIC); }
  ///@}

  /**
   * The scheme itself: of AUTOMATIC what the last update took, LOOP or CATMULL_CLARK (before the
   * first update LOOP).
   */
  int GetSchemeInUse() const { return this->Scheme == AUTOMATIC ? this->Automatic : this->Scheme; }

  ///@{
  /**
   * Whether points of equal coordinates are one point for the surface, if there are texture
   * coordinates (the active ones of the point data). At seams of a texture a vtkPolyData has points
   * several times, once for each side. The points then follow the joined surface, which stays
   * smooth and closed across seams; texture coordinates, and all other arrays, treat a seam as a
   * boundary, which is sharp. On by default; for LOOP, MODIFIED_BUTTERFLY, CATMULL_CLARK and
   * LINEAR. With the other schemes a warning of points at one place names these. Filters in a row
   * are then filters of their own.
   */
  vtkSetMacro(JoinSeams, bool);
  vtkGetMacro(JoinSeams, bool);
  vtkBooleanMacro(JoinSeams, bool);
  ///@}

  ///@{
  /**
   * Whether points on creases, joints and corners are doubled in an output with LimitNormals of
   * LOOP or CATMULL_CLARK: a point, with the normal there, for each side; joints that are blended
   * keep one. So a picture is smooth up to sharp edges and sharp at them, as with the Splitting of
   * vtkPolyDataNormals, and SmoothShading adds normals where something is sharp, too. Such an
   * output is for pictures: its cells come apart at sharp edges, it has no global ids, and further
   * filters take it as any other mesh. Off by default; no effect where several partitions share
   * the surface.
   */
  vtkSetMacro(SplitSharpEdges, bool);
  vtkGetMacro(SplitSharpEdges, bool);
  vtkBooleanMacro(SplitSharpEdges, bool);
  ///@}

  /**
   * Evaluates the limit at places of cells of the present input, a vtkPolyData, which is updated,
   * by the present rules of Scheme = LOOP, CATMULL_CLARK or AUTOMATIC; NumberOfLevels does not
   * matter. Place i is in cell cells[i], at parameters[i], which has 3 components, of which a
   * vertex reads none and a line one:
   *  - a line: the second point has the weight u, the first 1 - u;
   *  - a triangle by LOOP: the second point has the weight u, the third v, the first 1 - u - v;
   *  - a quad by CATMULL_CLARK: u in [0, 1] goes from the first point to the second, v from the
   * first to the fourth, bilinearly;
   *  - any other polygon by CATMULL_CLARK: w is the number k = 0, 1, ... of one of its points, and
   * u and v belong to the quad that the first step makes there: u along the edge to the next point,
   * v along the edge to the point before, and the centre at (1, 1).
   *
   * Polygons that LOOP cuts into triangles have no places, nor have strips, poly lines and poly
   * vertices of several cells.
   *
   * `result` has a point and a vertex for each place, in double unless OutputPointsPrecision says
   * otherwise, with all smoothed arrays there (an array that is not smoothed has the value of the
   * nearest corner), and the arrays DerivativeU, DerivativeV
   * and DerivativeW of the points by the parameters, the last one zero. In polygons LimitNormals,
   * MeanCurvature and GaussianCurvature follow from the derivatives, with the normal as the points
   * of the cell turn; on lines MeanCurvature has the curvature of the curve. All others are 0.
   *
   * Values are exact but for rounding, 1e-12 of the size of the mesh and less, also near
   * extraordinary vertices, curves and creases; a sharpness above 52 counts as 52. So are
   * derivatives, relative to the derivatives of the part of the cell around the place that is
   * regular. At an extraordinary vertex itself they tend to 0 or to infinity: there the first ones
   * belong to a part of 2^-26, turned into the tangent plane, with about the directions of the two
   * edges. This plane and LimitNormals are exact, the lengths mean nothing. The second ones are
   * 0. A cell takes a few local steps if not all is regular around it, and a place 2^-k from an
   * extraordinary vertex k of them; memory per thread is quadratic in the number of points around a
   * cell. With JoinSeams points and derivatives follow the joined mesh. Returns false after an
   * error.
   */
  bool EvaluateLimit(vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result);

protected:
  vtkSurfaceSubdivision();
  ~vtkSurfaceSubdivision() override;

  bool IsOfSurfaces() const override { return true; }
  bool WritesSurfaces() const override { return !this->WritesCurvedCells(); }
  bool HasOriginalCellIds() const override { return this->GenerateOriginalIds || this->Places; }
  enum SurfaceArrayIndices
  {
    FLATNESS_ARRAY = 6,
    NORMAL_ARRAY = 14
  };
  /// Reads the array of normals. Returns false after an error.
  bool ReadNormals(
    vtkPointSet* input, const subdivision::RunOptions& options, vtkDataArray*& normals);
  int GetLayersOfCells() const override;
  bool HasInterfaces() const override
  {
    return this->Scheme != DOO_SABIN && this->Scheme != MIDEDGE;
  }
  void Inspect(vtkDataObject* input, vtkDataObject* readable) override;
  void Agree() override;
  bool HasSeams() const override
  {
    return this->HasInterfaces() && this->Scheme != FOUR_EIGHT && this->Scheme != SQRT_THREE;
  }
  bool JoinsSeams() const override { return this->JoinSeams; }
  const char* DescribeBezierNeeds() const override;
  const char* DescribeCurvedNeeds() const override;
  bool MakesQuads() const override { return this->GetSchemeInUse() == CATMULL_CLARK; }
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Scheme = AUTOMATIC;
  bool JoinSeams = true;
  bool SplitSharpEdges = false;

private:
  std::array<double, 4> FacesOfRank = {}; ///< FaceCounts
  int Automatic = LOOP;

  vtkSurfaceSubdivision(const vtkSurfaceSubdivision&) = delete;
  void operator=(const vtkSurfaceSubdivision&) = delete;
};

#endif
