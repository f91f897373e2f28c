// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMultiDimensionalSubdivision
 * @brief   smooth subdivision of curves, surfaces and solids in one mesh
 *
 * Subdivides a mesh of vertices, lines, triangles and tetrahedra (and cells that can be split into
 * these, see vtkSubdivisionAlgorithm) uniformly and smoothly: curves become cubic B-splines,
 * surfaces Loop surfaces, solids box-spline solids, each with smooth boundaries, and where objects
 * of different dimension meet they are blended into each other.
 *
 * @par Algorithm
 * Y.-S. Chang and H. Qin, "A Framework for Multi-dimensional Adaptive Subdivision Objects". Every
 * level splits a line into 2, a triangle into 4 and a tetrahedron into 8, and moves the points:
 * each new value is a weighted mean of the values around it. Which weights (equations 13 to 18) and
 * which neighbours depends on the dimension of the rule that a vertex or edge follows: the
 * dimension of the manifold that it lies inside of, one less on a boundary, zero for the end of a
 * curve. By default non-manifold vertices and edges take the rule for solids with all their
 * neighbours (rule G-2).
 *
 * On surfaces this is Loop's scheme, as in vtkSurfaceSubdivision, next to boundaries and creases
 * with the rules of ModifiedBoundary; off, it chooses the paper's.
 *
 * @par Tet/oct scheme
 * VolumeScheme = TET_OCT: S. Schaefer, J. Hakenberg and J. Warren, "Smooth Subdivision of
 * Tetrahedral Meshes". A tetrahedron becomes four tetrahedra at its vertices and an octahedron
 * between them, an octahedron six octahedra and eight tetrahedra around a new point at its centre.
 * No diagonal is ever chosen, so that nothing depends on the order of a cell's points. After this
 * split, points of dimension 3 move to the mean over the cells around them of a weighted centroid
 * (figure 4). The limit is C2 in the interior and across the faces of control tetrahedra; along
 * their edges condition (24) holds for 3 to 10 tetrahedra and fails from 11 on. Points of lower
 * dimension, and blended ones, follow the same rules as in the box-spline scheme, so that
 * boundaries and creases are the same. In the output an octahedron is four tetrahedra around its
 * shortest diagonal (diagonals within a relative 1e-9, of single precision points 1e-5, tie; then
 * the smallest point id decides), one after another, with a common number in the cell array
 * `OctahedronId` (vtkIdTypeArray; -1 for all other cells). The next filter of the same scheme takes
 * the four as one octahedron again, even if points or that array were changed. Children of an
 * octahedron take cell data from the tetrahedron that they lie in, the first where they lie in
 * several. If flags or values that choose rules were changed in between, the next filter takes each
 * octahedron as four tetrahedra.
 *
 * @par Arrays
 * Floating point arrays, of any number of components, are smoothed like the points; so are colours
 * (unsigned char, 3 or 4 components), rounded after every level. Other integer, string and bit
 * point arrays keep their values at old points; a new point takes that of the end of its edge, or
 * of the vertex of its octahedron, whose global id is smallest. Children take the cell arrays of
 * their cell, and its pedigree id. Global ids, and pedigree ids of points, are kept where no cell
 * or point is new; see GenerateOriginalIds. Field data pass through. Names, component names,
 * information keys, lookup tables and active attributes are kept, in blocks those of each block.
 * The filter adds, with VolumeScheme = TET_OCT, the cell array `OctahedronId`; on request,
 * `vtkOriginalCellIds`, `vtkOriginalPointIds`, `LimitNormals`, and the arrays of
 * GenerateClassification and GenerateErrorBounds; always the field array `Subdivision` (and
 * `SubdivisionGlobalIds`, if the input had global ids, `SubdivisionInvertedCells`, if it had
 * inverted or flat solids, `SubdivisionInterpolated`, if values were interpolated), by which the
 * next filter recognises this output.
 *
 * @par Solids that are turned inside out
 * Smoothing may turn solids inside out where the control mesh is very thin. One warning says how
 * many of the output's solids have another orientation than the control cell they come from (of
 * fewer than one in 100,000 a line of VTK's log); GenerateClassification marks them. Make the
 * control mesh less flat there, or take fewer levels.
 *
 * @par Output
 * Points: all input points with their ids (unused ones too), then centres of split cells, then the
 * new points level by level. Cells: in the order of the input, the children of a cell one after
 * another and oriented like it. A cell that is a face of another, or equals an earlier one, is
 * split in its place, but changes no rule unless it is singular. OutputDimensions leaves cells out.
 *
 * @par Filters in a row
 * Three filters of one level give what one filter of three levels gives, bit for bit, in every
 * array, on several ranks too. Only the last of them may have ProjectToLimit on, or leave out
 * cells by OutputDimensions.
 *
 * @par Complexity
 * Time and memory are linear in the size of the output; links are examined on the input only. With
 * CacheOperator off the operators of the last two levels are not stored: the filter makes a few
 * rows at a time and applies them to points and all arrays in one pass. It stores them if there is
 * one level only, limits are asked for, cells are equal, or creases are still sharp then.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools; the output is the same, bit for bit, for any back end and any number of
 * threads. Ghosts: see vtkSubdivisionAlgorithm.
 *
 * @par Errors
 * The filter stops, with an error and an empty output, if the output would have more than
 * MaximumNumberOfCells cells or take more memory than there is. Topology is never an error.
 *
 * @sa
 * vtkSubdivisionModelSource vtkLoopSubdivisionFilter
 */
#ifndef vtkMultiDimensionalSubdivision_h
#define vtkMultiDimensionalSubdivision_h

#include "vtkMarkedSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkDataArray;
class vtkIdTypeArray;
class vtkPolyData;

namespace subdivision
{
class BezierRounds;
class KeptEntries;
struct PlaceRequest;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkMultiDimensionalSubdivision
  : public vtkMarkedSubdivisionAlgorithm
{
public:
  static vtkMultiDimensionalSubdivision* New();
  vtkTypeMacro(vtkMultiDimensionalSubdivision, vtkMarkedSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkUnstructuredGrid* GetOutput() { return this->GetUnstructuredGridOutput(); }

  ///@{
  /**
   * Number of subdivision steps, 0 to 20, default 1. Each makes 8 times as many tetrahedra, 4 times
   * as many triangles, twice as many lines. 0 gives the simplices of the input, not smoothed
   * unless ProjectToLimit is on, with the control points of InterpolatePoints if that is on.
   */
  vtkSetClampMacro(NumberOfLevels, int, 0, 20);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * How solids are split and smoothed inside: BOX_SPLINE (0, the default; into tetrahedra,
   * smoothest in the interior of the control tetrahedra, with a direction preferred in each),
   * TET_OCT (1; into tetrahedra and octahedra without any preferred direction, see "Tet/oct scheme"
   * above) or LINEAR (2; the cells of BOX_SPLINE, not smoothed: points and values of all dimensions
   * stay, new ones are midpoints, and each level is its own limit). Curves, surfaces, boundaries,
   * creases and joints are the same in the first two.
   */
  vtkSetClampMacro(VolumeScheme, int, BOX_SPLINE, LINEAR);
  vtkGetMacro(VolumeScheme, int);
  void SetVolumeSchemeToBoxSpline() { this->SetVolumeScheme(BOX_SPLINE); }
  void SetVolumeSchemeToTetOct() { this->SetVolumeScheme(TET_OCT); }
  void SetVolumeSchemeToLinear() { this->SetVolumeScheme(LINEAR); }
  ///@}

  ///@{
  /**
   * Whether hexahedra, wedges, pyramids and quads are refined as such, with VolumeScheme = LINEAR:
   * a hexahedron, voxel or wedge into 8 of its type, a quad or pixel into 4, a pyramid into 6
   * pyramids and 4 tetrahedra; simplices as without the option, each tetrahedron of each level
   * around its shortest diagonal. New points are the means of the corners of edges, quads and
   * hexahedra; so cells that fit together fit after any level, and keep their volume together.
   * Options on rules and limits mean nothing then; of GenerateClassification,
   * GenerateLimitNormals and GenerateTangents a warning says so. Quads and polygons of three points
   * are read, larger polygons, prisms of more than three sides and polyhedra are errors. The output
   * has no stamp: filters in a row refine what they read. Off by default; without LINEAR it is
   * ignored with a warning.
   */
  vtkSetMacro(KeepCellTypes, bool);
  vtkGetMacro(KeepCellTypes, bool);
  vtkBooleanMacro(KeepCellTypes, bool);
  ///@}

  ///@{
  /**
   * Whether to output how the filter classified the mesh. Point arrays: `RuleDimension` (dimension
   * 0 to 3 of the rule that the next level would use for the vertex; 4 = blended) and
   * `NonManifoldType` (0: manifold; 1: objects of different dimension meet; 2: more than two
   * branches; 3: boundaries touch). Cell array: `ManifoldDimension` (0 to 3: the dimension of the
   * maximal simplex that the cell is, or is a face of; the largest, if several) and `Inverted` (1
   * for solids that smoothing turned inside out). All vtkUnsignedCharArray with one component. Off
   * by default.
   */
  vtkSetMacro(GenerateClassification, bool);
  vtkGetMacro(GenerateClassification, bool);
  vtkBooleanMacro(GenerateClassification, bool);
  ///@}

  ///@{
  /**
   * Whether the output's points and smoothed arrays are moved to where they would be after
   * infinitely many levels: the mesh then is inscribed into the smooth object, whatever
   * NumberOfLevels is, 0 included. Each value becomes a weighted mean of the neighbours' (the left
   * eigenvector of the local subdivision matrix for the eigenvalue 1), exact to rounding, with all
   * creases, joints and what is left of semi-sharp creases, and with either volume scheme. Cells
   * are those without the option, but octahedra are cut around the diagonal that is shortest then.
   * Needs, on the way, about as much time and memory as one more level. The points are no control
   * points any more: the next filter reads the output like any other mesh. Off by default.
   */
  vtkSetMacro(ProjectToLimit, bool);
  vtkGetMacro(ProjectToLimit, bool);
  vtkBooleanMacro(ProjectToLimit, bool);
  ///@}

  ///@{
  /**
   * Whether to output the point array `LimitNormals` (3 components, of the type of the points), the
   * active normals of the output: unit normals of the limit surface where each point ends up,
   * whether it is projected there or not. On surfaces they follow the orientation of the triangles
   * (of the first one of a part, if they differ; a part is what can be reached over edges of two
   * triangles), on the boundary of a solid they point out of it, as the control mesh says. A point
   * on a crease or on the border of a surface has the mean of the normals of its one or two sides.
   *
   * There is no tangent plane on curves, at corners, darts and non-manifold joints, on creases and
   * borders with seven and more triangles on a side (with ModifiedBoundary off), on surfaces inside
   * a solid, and on semi-sharp creases that are still sharp on the last level. So that nothing is
   * drawn black, points with triangles there (those of surfaces and of the boundaries of solids)
   * have the mean of the normals of the triangles in the limit, weighted by angle, the same on all
   * levels (Mathematics 8), points of curves a direction perpendicular to the curve, and single
   * points the z axis; where tangents are parallel but for rounding the normal is perpendicular to
   * them. A part of a surface has the side of its first triangle there, too. All this
   * depends on coordinates, not on numbers of points. Normals are zero only inside solids: no
   * surface is there that they would be perpendicular to. Filters that make one, by cutting or
   * clipping, have to make normals, too. Off by default.
   */
  vtkSetMacro(GenerateLimitNormals, bool);
  vtkGetMacro(GenerateLimitNormals, bool);
  vtkBooleanMacro(GenerateLimitNormals, bool);
  ///@}

  ///@{
  /**
   * Whether to output the point arrays `LimitTangent1` and `LimitTangent2` (3 components, of the
   * type of the points, not normalised): two tangents of the limit where each point ends up. On
   * surfaces and boundaries of solids they span the tangent plane, and their cross product has the
   * direction of the normal; on creases and borders the first one runs along the curve, and both
   * are those of one side. On curves the first one is the curve's tangent, in the direction of its
   * lines if these follow one another, and the second is zero. Both are zero where
   * GenerateLimitNormals says that there is no tangent plane, except on curves, borders and creases
   * with seven and more triangles on a side, and sharp joints, which have the first. Off by
   * default.
   */
  vtkSetMacro(GenerateTangents, bool);
  vtkGetMacro(GenerateTangents, bool);
  vtkBooleanMacro(GenerateTangents, bool);
  ///@}

  ///@{
  /**
   * Whether to output certified bounds on the distance from the limit. Cell arrays: `ErrorBound`,
   * which no distance exceeds between a place of the cell and the place of the limit with the same
   * parameters, and for each point array of floating point numbers, A, the array `AErrorBound`, the
   * same for the Euclidean norm of the difference of its values. Point arrays: `SmoothingDistance`,
   * how far a point of the input is away from its limit, and `ASmoothingDistance` for values; -1 at
   * all other points. All vtkDoubleArray with one component. The bounds hold for the points and
   * values of the output, whether they are projected to the limit or not, but for rounding in
   * double precision. They are less than 2.5 times the truth for 999 of 1,000 cells of random
   * meshes, but 9.1 times was met, and there is no limit where the truth is rounding, or less than
   * 1/160 of what is first found in tetrahedra (1/640 in triangles, 1/160000 in lines):
   * Mathematics 14.
   *
   * They are read off a mesh of 3 more levels, which counts for MaximumNumberOfCells and memory:
   * 512 times as many tetrahedra, 64 times as many triangles. Where they are more than 2.5 times
   * what the truth is at least, parts of cells are looked at up to 3 steps deeper (4 in triangles,
   * 8 in lines), some milliseconds for each part. With a warning the filter makes no bounds where
   * it has no proof: with KeepCellTypes, Bezier cells, creases that are sharp for more than one
   * level after the last, and InterfaceValues = DISCONTINUOUS_VALUES. With VolumeScheme = TET_OCT
   * each of the four tetrahedra that an octahedron is written as has a bound of its own. Off by
   * default.
   */
  vtkSetMacro(GenerateErrorBounds, bool);
  vtkGetMacro(GenerateErrorBounds, bool);
  vtkBooleanMacro(GenerateErrorBounds, bool);
  ///@}

  enum OutputCellTypes
  {
    LINEAR_CELLS,
    BEZIER_CELLS
  };
  ///@{
  /**
   * Which cells the output has: LINEAR_CELLS (0, the default) or BEZIER_CELLS (1), which are the
   * limit itself: VTK_BEZIER_CURVE of degree 3, VTK_BEZIER_TRIANGLE of degree 4 and
   * VTK_BEZIER_TETRAHEDRON of degree 5, exact where the limit of a cell is a polynomial, which is
   * where all is regular. Each cell of the input, as a simplex, becomes one of them if the limit
   * differs from it by no more than BezierTolerance; else its children do, at most NumberOfLevels
   * times, so that cells become smaller around extraordinary vertices, creases and joints. Cells of
   * the same size share the control points of their common edges and faces. All have one degree:
   * in a mesh with triangles lines have degree 4, too, and in one with tetrahedra all have 5.
   * Arrays of floating point numbers have control values as points have, all other point arrays the
   * values of a point nearby; values that are not finite split no cell. Points that no cell uses
   * are left out.
   *
   * The limit is read off a mesh of 3 more levels, of 4 if there are solids. Further levels of
   * NumberOfLevels cost what they split: they are made for these cells alone. But with blocks, on
   * several ranks, with GenerateLimitNormals, GenerateTangents, GenerateClassification,
   * OutputDimensions, values that jump or cells with equal points all of the mesh is made by each
   * level that some cell needs. MaximumNumberOfCells counts Bezier cells, on each rank its own.
   * There are no global ids and no ghost cells of the pipeline, and the next filter reads the
   * corners of the cells like any other mesh. Without effect on ComputeOperator. With VolumeScheme
   * = TET_OCT or KeepCellTypes a warning says that cells stay linear.
   */
  vtkSetClampMacro(OutputCells, int, LINEAR_CELLS, BEZIER_CELLS);
  vtkGetMacro(OutputCells, int);
  void SetOutputCellsToLinear() { this->SetOutputCells(LINEAR_CELLS); }
  void SetOutputCellsToBezier() { this->SetOutputCells(BEZIER_CELLS); }
  ///@}

  ///@{
  /**
   * What Bezier cells may leave out: the distance from the limit as a part of the diagonal of the
   * mesh, and the difference of each component of an array as a part of the array's range. Cells
   * that were split NumberOfLevels times may leave out more. The filter looks at the points of one
   * further level, where two thirds of this are allowed. 0 to 1, default 0.0001. 0 splits all cells
   * whose limit is no polynomial, but for rounding, NumberOfLevels times.
   */
  vtkSetClampMacro(BezierTolerance, double, 0., 1.);
  vtkGetMacro(BezierTolerance, double);
  ///@}

  enum OutputDimensionFlags
  {
    NO_DIMENSION = 0,
    VERTICES = 1,
    LINES = 2,
    TRIANGLES = 4,
    TETRAHEDRA = 8,
    ALL_DIMENSIONS = 15
  };
  ///@{
  /**
   * Which cells the output has, a sum of VERTICES (1), LINES (2), TRIANGLES (4) and TETRAHEDRA (8):
   * from NO_DIMENSION (0) to ALL_DIMENSIONS (15, the default). All cells have their effect on the
   * rules; those of other dimensions, and the points that only they use, are left out at the end.
   * TETRAHEDRA alone is what volume rendering needs. Ids of GenerateGlobalIds are those of the
   * output with all dimensions. A filter cannot go on with a part of the cells: if this is not
   * ALL_DIMENSIONS, the next filter reads the output like any other mesh.
   */
  vtkSetClampMacro(OutputDimensions, int, NO_DIMENSION, ALL_DIMENSIONS);
  vtkGetMacro(OutputDimensions, int);
  ///@}

  ///@{
  /**
   * The same by dimensions, 0 to 3.
   */
  void AddOutputDimension(int dimension);
  void ClearOutputDimensions() { this->SetOutputDimensions(NO_DIMENSION); }
  ///@}

  ///@{
  /**
   * Whether the operators of all levels and the output's cells are kept, so that an execution whose
   * cells and options have not changed (new coordinates or arrays, another time step) builds no
   * topology: connectivity, offsets and types are shared with the previous output, and so are the
   * points if the coordinates are the same. Cells are compared by content, with a kept copy.
   * Choices made from coordinates (diagonals, polygon cuts, features) are made again; where one
   * comes out differently, everything is built again: the output is always that of a fresh filter.
   * Where only rules changed, operators are made again but the cells stay shared. Kept for the
   * whole of a composite input, or for each block if JoinBlocks is off, until an update does not
   * need it. On by default.
   */
  void SetCacheOperator(bool cache);
  vtkGetMacro(CacheOperator, bool);
  vtkBooleanMacro(CacheOperator, bool);
  ///@}

  /**
   * Computes what the filter does to points, as a matrix, with the present options on the present
   * input, which is updated. Returns false after an error: the input must be a mesh in one piece,
   * without KeepCellTypes, InterpolatePoints, InterpolateArrays and InterfaceValues.
   * With CacheOperator an update before has made most of it, and the next one can use it. Points
   * are numbered as OutputDimensions = ALL_DIMENSIONS numbers them.
   */
  bool ComputeOperator(vtkSubdivisionOperator* result);

  /**
   * Evaluates the limit at places of cells of the present input, which is updated, by the present
   * rules; NumberOfLevels does not matter. Place i is in cell cells[i], a vertex, line, triangle or
   * tetrahedron, at parameters[i] (3 components, of which a cell of dimension d reads d): the
   * second point of the cell has the weight u, the third v, the fourth w, and the first 1 - u - v -
   * w; no weight is negative. In an output of TET_OCT it may be a piece of an octahedron. Cells
   * that the filter cuts, such as quads and hexahedra, have no places; vtkSurfaceSubdivision has
   * those of polygons.
   *
   * `result` has a point and a vertex for each place, in double, with all smoothed arrays there (an
   * array that is not smoothed has the value of the nearest corner), and the arrays DerivativeU,
   * DerivativeV and DerivativeW of the points by the parameters. On surfaces LimitNormals,
   * MeanCurvature and GaussianCurvature follow from the derivatives, with the normal as the points
   * of the cell turn; on curves MeanCurvature has the curvature of the curve. All others are 0.
   *
   * Values are exact but for rounding, 1e-12 of the size of the mesh and less. So are derivatives
   * of curves and surfaces, beside joints, creases and what is semi-sharp, too: down to 2^-48 of a
   * cell from an irregular vertex their error is at most 1e-12 of the weights of the largest
   * derivative there. These weights change as (2 lambda)^k at 2^-k of a cell, with the second
   * eigenvalue lambda of the vertex: with three to five triangles derivatives tend to 0, with seven
   * and more to infinity. Second derivatives are as exact, and their weights change as (4
   * lambda)^k; beside semi-sharp creases their error is larger by 2^(k - 54) of these weights.
   * Curvatures use the part across the surface only, which is smaller by (mu / lambda)^k, with the
   * third eigenvalue mu, so as many digits are lost. At irregular vertices curvatures are 0.
   *
   * In solids derivatives are as exact wherever they exist: inside of cells, on faces and on
   * boundaries, where they are those from the side of the cell, and beside joints. The limit has no
   * derivatives by these parameters AT edges and vertices that are not regular (by TET_OCT all of
   * the control mesh) and, by BOX_SPLINE, at faces whose two tetrahedra are not cut in the same
   * way; so there are none in lines and triangles inside of solids that go along these and are not
   * singular. There the arrays have the slope over a part of 2^-52 of the cell. By TET_OCT, and by
   * BOX_SPLINE very near to such faces, the limit is taken as linear over a part of this size, so
   * that 2^-k of a cell from what is not regular the error is 2^(k - 50) more.
   *
   * AT an extraordinary vertex of a surface the limit has no derivatives by these parameters
   * either. What the arrays have there is the slope over a part of 2^-52 of the cell. Its length
   * means nothing, and its direction comes near the tangent plane only (the normal is wrong by
   * 1e-12 with seven triangles, by 1e-5 with twelve, by 1e-9 with four). GenerateLimitNormals has
   * exact normals there, and vtkSurfaceSubdivision::EvaluateLimit exact tangent planes. Returns
   * false after an error.
   */
  bool EvaluateLimit(vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result);

  /**
   * How often this filter built topology while CacheOperator was on.
   */
  vtkIdType GetNumberOfTopologyBuilds() const;

  ///@{
  /**
   * Whether the output's cells are stored with 32-bit ids where they fit (vtkCellArray's narrower
   * storage). Off by default: vtkIdType.
   */
  vtkSetMacro(Use32BitIds, bool);
  vtkGetMacro(Use32BitIds, bool);
  vtkBooleanMacro(Use32BitIds, bool);
  ///@}

protected:
  vtkMultiDimensionalSubdivision();
  ~vtkMultiDimensionalSubdivision() override;

  bool CanInterpolate() const override { return true; }
  bool HasInterfaces() const override { return true; }
  /// Tet/oct limits need a third layer, because octahedra reach one edge farther.
  int GetLayersOfCells() const override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void Inspect(vtkDataObject* input, vtkDataObject* readable) override;
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made) override;
  bool HasGhostLayers() const override { return !this->WritesBezierCells(); }

  int NumberOfLevels = 1;
  int VolumeScheme = BOX_SPLINE;
  bool KeepCellTypes = false;
  bool GenerateClassification = false;
  bool ProjectToLimit = false;
  bool GenerateLimitNormals = false;
  bool GenerateTangents = false;
  bool GenerateErrorBounds = false;
  int OutputCells = LINEAR_CELLS;
  double BezierTolerance = 1e-4;
  int OutputDimensions = ALL_DIMENSIONS;
  bool CacheOperator = true;
  bool Use32BitIds = false;

private:
  /// Whether this execution has an output, and that has Bezier cells.
  bool WritesBezierCells() const;

  std::unique_ptr<subdivision::KeptEntries> Cache;
  std::unique_ptr<subdivision::BezierRounds> Bezier;
  const subdivision::PlaceRequest* Places = nullptr; ///< what EvaluateLimit wants

  vtkMultiDimensionalSubdivision(const vtkMultiDimensionalSubdivision&) = delete;
  void operator=(const vtkMultiDimensionalSubdivision&) = delete;
};

#endif
