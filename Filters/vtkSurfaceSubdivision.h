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
 * around are also flattened, so that the surface does not fold (section 3.2). ModifiedBoundary off
 * gives the plain rules. Loop is that of vtkMultiDimensionalSubdivision, also where parts meet, but
 * that here a boundary counts like a crease where creases meet it, flagged polygons at boundaries
 * and joints do not replace these, equal faces count as two, the angles of corners are measured
 * (there they are those of the array at index 10 alone), and the last level of a sharpness that is
 * no whole number has other weights.
 *
 * @par Modified Butterfly
 * Section 4 of the survey. Points stay, because the scheme interpolates, and are on the limit. New
 * points have the eight-point rule on edges between vertices of six faces, and the rules of the
 * survey's table at other vertices inside and next to curves (the mean of two if both ends are
 * extraordinary). On boundaries, creases and lines they have the four-point rule, which continues a
 * curve straight beyond its end; a crease is a boundary for both its sides. Corners have a rule of
 * the same kind, which halves functions that are linear in the sector: they need no flatness and
 * have it only if it is given. Vertices where a crease ends count as extraordinary.
 * ModifiedBoundary changes nothing. The new weights are exact for cubic functions inside regular
 * meshes, for quadratic ones at regular curves, and for linear ones between two regular curves. On
 * closed surfaces the points are those of vtkButterflySubdivisionFilter for vertices of three and
 * more faces.
 *
 * @par Input and output
 * Polygons of any size, and strips, which become triangles in their place. Loop, ModifiedButterfly,
 * SqrtThree and Linear split other polygons into triangles first. A line cell
 * that lies on an edge follows it; others are curves of their own, cubic B-splines. Poly lines
 * become lines, vertex cells stay. The output, a vtkPolyData unless OutputCells = BEZIER_CELLS, has
 * vertices, lines and polygons, in this order, the children of a cell one after another and
 * oriented like it (dual schemes: see below). Points: those of the input with their ids, unused
 * ones too, then the new ones level by level. Arrays and field data are treated as by
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
 * steps keep boundary points, even ones do not. It is not smooth at faces of three sides,
 * vertices of three faces and boundaries. No input point is an output point: points are new, in the
 * order of the corners of faces, and vtkOriginalPointIds is -1. The faces inside faces come first,
 * then the others, oriented like the first face that they touch. Boundaries are uniform quadratic
 * B-splines (Chaikin's scheme; for Midedge two steps of it are one of Chaikin's). Sheets come apart
 * at edges of three and more faces, and fans at vertices. A closed fan of two faces makes no face:
 * its two edges become one. Lines and vertex cells get points of their own, also where they lie on
 * the surface: lines are cubic B-splines whose ends and joints stay, as do vertex cells and points
 * that no cell uses. The limit surface goes through the mean of the corners of each face of any
 * level. The limit of a point is that at the face which the next step makes around it, on a
 * boundary in the middle of the side which it makes there, and of lines that of the cubic B-spline;
 * where several fans of faces meet it is that of the first one. Exact but for Midedge at a point
 * between two faces that share more than three edges in a row, and not all. DooSabin has two
 * tangents at points inside and on boundaries, but not between two faces; Midedge has two inside at
 * points of four and more faces, and one along boundaries. Points of Midedge that can be coloured
 * black and white, neighbours differently, as those of quads mostly can, have no control points for
 * InterpolatePoints, nor do those of FourEight on quads; a warning says so. DooSabin takes time
 * quadratic in the number of corners of a face.
 *
 * @par Creases and corners
 * Sharp are boundaries, edges of line cells that the array at index 0 flags, edges around flagged
 * polygons, with PreserveInterfaces edges between faces of different materials, with
 * DetectFeatures edges where the surface turns by more than FeatureAngle, and edges that do not
 * have two faces. A vertex with two sharp edges lies on a curve; with three or more, or
 * if it is a flagged vertex cell, it is a corner. A smooth boundary vertex with one face is a
 * corner too for CatmullClark, ModifiedButterfly and FourEight. The dual schemes, DooSabin and
 * Midedge, have no creases and corners: with a warning they ignore what asks for them. Corners
 * are convex or concave by the sum of the face angles in each sector, measured on the input and
 * kept in [22.5, 157.5] and [202.5, 337.5] degrees. For floor(s) levels a crease of sharpness s is
 * one that is flagged, with its ends, crossings and all near it. In the next level it is so in
 * part, s - floor(s), between the rows without and with all creases that are left in part. An
 * infinite one is flagged.
 *
 * SqrtThree and FourEight leave curves alone in odd steps; in even ones SqrtThree cuts them into
 * thirds and FourEight in halves, by the rules of the cubic B-spline. They replace all other edges,
 * so that line cells are creases with any flag or sharpness, and an end of a crease is a corner.
 * FourEight has triangles on curves after odd steps. A limit of FourEight reads all faces that
 * touch those of a point; where the points of these are not inside, with four quads each, its row
 * is made by up to four steps around it, in some 20 microseconds. These two have no rules for the
 * number of faces on a curve, and ModifiedBoundary changes nothing: tangent planes exist on curves
 * for two to five (SqrtThree) and for two and three faces (FourEight), at corners for up to two and
 * for one.
 *
 * @par Non-manifold input
 * Edges with three and more faces, vertices where fans of faces or lines meet: Loop follows
 * Type1Rule to Type3Rule as the main filter does; the other schemes take such edges as sharp curves
 * and such vertices as corners. Surfaces need not be orientable. Equal faces count as two.
 *
 * @par Arrays read, by SetInputArrayToProcess
 * Besides flags and sharpness of lines (0 and 4, see vtkSubdivisionAlgorithm), and angles of
 * corners with one sector (10):
 *  - 6, flatness: point array of s in [0, 1]. Negative: 0 at convex corners, at concave ones what
 *    makes them tangent plane continuous. Unset: none.
 *
 * @par Arrays written
 * On request `LimitNormals`, `LimitTangent1`, `LimitTangent2` (points, 3 components),
 * `vtkOriginalPointIds` and `vtkOriginalCellIds`; always field arrays `SubdivisionSurface...`, by
 * which this filter recognises its own output.
 *
 * @par Filters in a row
 * Three filters of one level and the same options give what one filter of three levels gives, bit
 * for bit, for every scheme; Midedge, FourEight and SqrtThree continue with the right parity, the
 * last two with the flags of the first input. Angles and flatness of corners are those of the first
 * input. After ProjectToLimit, or if cells were changed in between, the next filter takes the mesh
 * for a new one. Only the first filter knows global ids. On several ranks filters of LOOP,
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
 * On closed meshes the points are those of VTK (Butterfly), OpenMesh (Butterfly, Catmull-Clark,
 * sqrt(3)) and CGAL (Catmull-Clark, Doo-Sabin, sqrt(3)), and with LoopWeights = LOOP_WEIGHTS those
 * of the Loop schemes of OpenSubdiv, OpenMesh, CGAL and VTK; by default Loop has Warren's weights,
 * which are the same at vertices of three and six faces only. With ModifiedBoundary off the
 * boundaries of Loop are those of OpenSubdiv, OpenMesh and CGAL, too, and those of Catmull-Clark
 * CGAL's.
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

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSurfaceSubdivision : public vtkUniformSubdivisionAlgorithm
{
public:
  static vtkSurfaceSubdivision* New();
  vtkTypeMacro(vtkSurfaceSubdivision, vtkUniformSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output; null if it has Bezier cells (OutputCells). Then GetOutputDataObject(0) has it, a
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
    LINEAR
  };
  ///@{
  /**
   * The scheme: LOOP (0, the default; triangles to 4), MODIFIED_BUTTERFLY (1; triangles to 4,
   * interpolates the points), CATMULL_CLARK (2; polygons to quads), DOO_SABIN (3; dual), MIDEDGE
   * (4; dual), FOUR_EIGHT (5; two steps split a quad into 4), SQRT_THREE (6; triangles to 3) or
   * LINEAR (7; triangles to 4, not smoothed: points stay, new ones are midpoints).
   */
  vtkSetClampMacro(Scheme, int, LOOP, LINEAR);
  vtkGetMacro(Scheme, int);
  void SetSchemeToLoop() { this->SetScheme(LOOP); }
  void SetSchemeToModifiedButterfly() { this->SetScheme(MODIFIED_BUTTERFLY); }
  void SetSchemeToCatmullClark() { this->SetScheme(CATMULL_CLARK); }
  void SetSchemeToDooSabin() { this->SetScheme(DOO_SABIN); }
  void SetSchemeToMidedge() { this->SetScheme(MIDEDGE); }
  void SetSchemeToFourEight() { this->SetScheme(FOUR_EIGHT); }
  void SetSchemeToSqrtThree() { this->SetScheme(SQRT_THREE); }
  void SetSchemeToLinear() { this->SetScheme(LINEAR); }
  ///@}

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

  /**
   * Evaluates the limit at places of cells of the present input, a vtkPolyData, which is updated,
   * by the present rules of Scheme = LOOP or CATMULL_CLARK; NumberOfLevels does not matter. Place i
   * is in cell cells[i], at parameters[i], which has 3 components, of which a vertex reads none and
   * a line one:
   *  - a line: the second point has the weight u, the first 1 - u;
   *  - a triangle by LOOP: the second point has the weight u, the third v, the first 1 - u - v;
   *  - a quad by CATMULL_CLARK: u in [0, 1] goes from the first point to the second, v from the
   * first to the fourth, bilinearly;
   *  - any other polygon by CATMULL_CLARK: w is the number k = 0, 1, ... of one of its points, and
   * u and v are those of the quad that the first step makes there: u along the edge to the next
   *    point, v along the edge to the point before, and the centre at (1, 1).
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
   * derivatives, relative to those of the part of the cell around the place that is regular. At an
   * extraordinary vertex itself they tend to 0 or to infinity: there the first ones are those of a
   * part of 2^-26, turned into the tangent plane, with about the directions of the two edges. This
   * plane and LimitNormals are exact, the lengths mean nothing. The second ones are 0. A cell takes
   * a few local steps if not all is regular around it, and a place 2^-k from an extraordinary
   * vertex k of them; memory per thread is quadratic in the number of points around a cell. With
   * JoinSeams points and derivatives follow the joined mesh. Returns false after an error.
   */
  bool EvaluateLimit(vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result);

protected:
  vtkSurfaceSubdivision();
  ~vtkSurfaceSubdivision() override;

  bool IsOfSurfaces() const override { return true; }
  bool WritesSurfaces() const override { return !this->WritesBezierCells(); }
  bool HasOriginalCellIds() const override { return this->GenerateOriginalIds || this->Places; }
  enum SurfaceArrayIndices
  {
    FLATNESS_ARRAY = 6
  };
  int GetLayersOfCells() const override;
  bool HasInterfaces() const override
  {
    return this->Scheme != DOO_SABIN && this->Scheme != MIDEDGE;
  }
  bool HasSeams() const override
  {
    return this->HasInterfaces() && this->Scheme != FOUR_EIGHT && this->Scheme != SQRT_THREE;
  }
  bool JoinsSeams() const override { return this->JoinSeams; }
  const char* DescribeBezierNeeds() const override;
  bool MakesQuads() const override { return this->Scheme == CATMULL_CLARK; }
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Scheme = LOOP;
  bool JoinSeams = true;

private:
  vtkSurfaceSubdivision(const vtkSurfaceSubdivision&) = delete;
  void operator=(const vtkSurfaceSubdivision&) = delete;
};

#endif
