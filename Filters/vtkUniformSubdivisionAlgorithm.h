// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkUniformSubdivisionAlgorithm
 * @brief   base class of the filters that subdivide all cells a number of times
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkSurfaceSubdivision
 */
#ifndef vtkUniformSubdivisionAlgorithm_h
#define vtkUniformSubdivisionAlgorithm_h

#include "vtkMarkedSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <functional> // for std::function
#include <memory>     // for std::unique_ptr
#include <vector>

class vtkDataArray;
class vtkIdTypeArray;
class vtkPolyData;

namespace subdivision
{
class BezierRounds;
class KeptEntries;
class Prolongation;
enum class CurvedKind;
struct CurvedNodes;
struct LevelOptions;
struct PlaceRequest;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkUniformSubdivisionAlgorithm
  : public vtkMarkedSubdivisionAlgorithm
{
public:
  vtkTypeMacro(vtkUniformSubdivisionAlgorithm, vtkMarkedSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of subdivision steps, 0 to 20, default 1. In vtkMultiDimensionalSubdivision each makes 8
   * times as many solids, 4 times as many faces, twice as many lines. There 0 gives the cells or
   * simplices of the input, not smoothed unless ProjectToLimit is on, with the control points of
   * InterpolatePoints if that is on.
   */
  vtkSetClampMacro(NumberOfLevels, int, 0, 20);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * Whether the output's points and smoothed arrays are moved to where they would be after
   * infinitely many levels: the mesh then is inscribed into the smooth object, whatever
   * NumberOfLevels is, 0 included. Each value becomes a weighted mean of the neighbours' (the left
   * eigenvector of the local subdivision matrix for the eigenvalue 1), exact to rounding, with all
   * creases, joints and semi-sharp creases that are left, and with any scheme. Cells are the same
   * as without the option, but octahedra are cut around the diagonal that is shortest then. Needs,
   * on the way, about as much time and memory as one more level. The points are no control points
   * any more: the next filter reads the output like any other mesh. Off by default.
   */
  vtkSetMacro(ProjectToLimit, bool);
  vtkGetMacro(ProjectToLimit, bool);
  vtkBooleanMacro(ProjectToLimit, bool);
  ///@}

  ///@{
  /**
   * Whether to output the point array `LimitNormals` (3 components, of the type of the points), the
   * active normals of the output: unit normals of the limit surface where each point ends up,
   * whether it is projected there or not. On surfaces they follow the orientation of the faces (of
   * the first one of a part, if they differ; a part is a set of faces connected over edges of two
   * faces), on the boundary of a solid they point out of it, as the control mesh says. A point on a
   * crease or on the border of a surface has the mean of the normals of its one or two sides, in
   * vtkSurfaceSubdivision the normal of one side. There points of a part with one side only, like a
   * Moebius band, have the side of a face at the point, which with SQRT_THREE and FOUR_EIGHT may be
   * another one on another level; a crease that is sharp for more than 26 levels counts as if it
   * were for 26.
   *
   * There is no tangent plane on curves, at corners, ends of creases and non-manifold joints, on
   * creases and borders with seven and more triangles on a side (with ModifiedBoundary off), on
   * surfaces inside a solid, and in vtkMultiDimensionalSubdivision on semi-sharp creases that are
   * still sharp on the last level. So that nothing is drawn black, points with faces there (of
   * surfaces and of the boundaries of solids) have the mean of the normals of the faces in the
   * limit, weighted by angle (where these cancel, see Mathematics 8), the same on all levels and
   * with ProjectToLimit, points of curves a direction perpendicular to the curve, and single points
   * the z axis; where tangents are parallel but for rounding the normal is perpendicular to them.
   * DOO_SABIN and MIDEDGE, which keep no points, take the faces of the level. All this depends on
   * coordinates, not on numbers of points. Normals are zero only inside solids: no surface is there
   * that they would be perpendicular to. Filters that make one, by cutting or clipping, have to
   * make normals, too. A point has one normal for all faces there, so a picture is blended along
   * creases and joints. Off by default.
   */
  vtkSetMacro(GenerateLimitNormals, bool);
  vtkGetMacro(GenerateLimitNormals, bool);
  vtkBooleanMacro(GenerateLimitNormals, bool);
  ///@}

  ///@{
  /**
   * Whether surfaces, and the outsides of solids, are shaded smoothly at once: without
   * GenerateLimitNormals, too, the output has `LimitNormals` where a picture is right by them, and
   * silently none elsewhere. A picture is right where nothing is sharp: from one level on all cells
   * are faces or all are solids, surfaces have two sides, there are no creases, corners and joints,
   * and one partition has the whole. This is for LOOP and CATMULL_CLARK of vtkSurfaceSubdivision,
   * and for all but LINEAR of vtkMultiDimensionalSubdivision, whose normals are cheap. Where memory
   * is short there are none. On by default.
   */
  vtkSetMacro(SmoothShading, bool);
  vtkGetMacro(SmoothShading, bool);
  vtkBooleanMacro(SmoothShading, bool);
  ///@}

  ///@{
  /**
   * Whether to output the point arrays `LimitTangent1` and `LimitTangent2` (3 components, of the
   * type of the points, not normalised): two tangents of the limit where each point ends up. On
   * surfaces and boundaries of solids they span the tangent plane, and their cross product has the
   * direction of the normal; on creases and borders the first one runs along the curve, and both
   * belong to one side. On curves of vtkMultiDimensionalSubdivision the first one is the curve's
   * tangent, in the direction of its lines if these follow one another, and the second is zero.
   * There both are zero where GenerateLimitNormals says that there is no tangent plane, except on
   * curves, borders and creases with seven and more triangles on a side, and sharp joints, which
   * have the first. Off by default.
   */
  vtkSetMacro(GenerateTangents, bool);
  vtkGetMacro(GenerateTangents, bool);
  vtkBooleanMacro(GenerateTangents, bool);
  ///@}

  ///@{
  /**
   * Whether to output certified bounds on the distance from the limit. Cell arrays: `ErrorBound`,
   * which no distance exceeds between a place of the cell (of a quad: of the bilinear surface) and
   * the place of the limit with the same parameters, and for each point array of floating point
   * numbers, A, the array `AErrorBound`, the same for the Euclidean norm of the difference of its
   * values. Point arrays: `SmoothingDistance`, how far a point of the input is away from its limit,
   * and `ASmoothingDistance` for values; -1 at all other points. All vtkDoubleArray with one
   * component. The bounds hold for the points and values of the output, whether they are projected
   * to the limit or not, but for rounding in double precision. They are less than 2.5 times the
   * truth for 999 of 1,000 cells of random meshes, but 9.1 times was met, and there is no limit
   * where the truth is rounding, or less than 1/160 of the first bound in tetrahedra (1/640 in
   * faces; in lines 1/160000, of vtkSurfaceSubdivision 1/140000): Mathematics 14.
   *
   * They are read off a mesh of 3 more levels, which counts for MaximumNumberOfCells and memory:
   * 512 times as many tetrahedra, 64 times as many faces (SQRT_THREE: 4 more, 81 times). In
   * vtkMultiDimensionalSubdivision parts of cells are looked at up to 3 steps deeper (4 in
   * triangles, 8 in lines) where bounds are more than 2.5 times the least possible truth, some
   * milliseconds for each part. With a warning the filter makes no bounds where it has no proof:
   * with Bezier cells, KeepCellTypes, VolumeScheme = HYBRID, creases that are sharp for more than
   * one level after the last, and InterfaceValues = DISCONTINUOUS_VALUES; of surface schemes only
   * for LOOP, CATMULL_CLARK, SQRT_THREE and LINEAR, without negative weights (flatness at corners),
   * seams that are joined, faces that are no quads if NumberOfLevels = 0 (CATMULL_CLARK), borders
   * and creases after an odd NumberOfLevels (SQRT_THREE), and on one rank. With VolumeScheme =
   * TET_OCT each of the four tetrahedra that an octahedron is written as has a bound of its own.
   * Off by default.
   */
  vtkSetMacro(GenerateErrorBounds, bool);
  vtkGetMacro(GenerateErrorBounds, bool);
  vtkBooleanMacro(GenerateErrorBounds, bool);
  ///@}

  enum OutputCellTypes
  {
    LINEAR_CELLS,
    BEZIER_CELLS,
    QUADRATIC_CELLS,
    LAGRANGE_CELLS
  };
  ///@{
  /**
   * Which cells the output has: LINEAR_CELLS (0, the default), BEZIER_CELLS (1), QUADRATIC_CELLS
   * (2) or LAGRANGE_CELLS (3).
   *
   * BEZIER_CELLS are the limit itself: VTK_BEZIER_CURVE of degree 3, VTK_BEZIER_TRIANGLE of degree
   * 4, VTK_BEZIER_TETRAHEDRON of degree 5 and, for CATMULL_CLARK, VTK_BEZIER_QUADRILATERAL of
   * degree 3, exact where the limit of a cell is a polynomial, which is where all is regular. The
   * output of vtkSurfaceSubdivision then is a vtkUnstructuredGrid (GetUnstructuredGridOutput). Each
   * cell of the input, as a simplex, becomes one of them if the limit differs from it by no more
   * than BezierTolerance; else its children do, at most NumberOfLevels times, so that cells become
   * smaller around extraordinary vertices, creases and joints. A face that is no quad is split by
   * CATMULL_CLARK in any case. Cells of the same size share the control points of their common
   * edges and faces. All have one degree: in a mesh with triangles lines have degree 4, too, and in
   * one with tetrahedra all have 5. Arrays of floating point numbers have control values as points
   * have, all other point arrays the values of a point nearby; values that are not finite split no
   * cell. Points that no cell uses are left out.
   *
   * The limit is read off a mesh of 3 more levels, of 4 if there are solids, or if CATMULL_CLARK
   * has faces that are no quads. Further levels of NumberOfLevels cost time for the cells that they
   * split: they are made for these cells alone. But with blocks, on several ranks, with
   * GenerateLimitNormals, GenerateTangents, GenerateClassification, OutputDimensions, seams that
   * are joined, values that jump or cells with equal points all of the mesh is made by each level
   * that some cell needs. MaximumNumberOfCells counts Bezier cells, on each rank its own. There are
   * no global ids and no ghost cells of the pipeline, and the next filter reads the corners of the
   * cells like any other mesh. Without effect on ComputeOperator. With VolumeScheme = TET_OCT or
   * HYBRID or KeepCellTypes, and with surface schemes other than LOOP, CATMULL_CLARK and LINEAR, a
   * warning says that cells stay linear.
   *
   * QUADRATIC_CELLS and LAGRANGE_CELLS are for solvers: each cell of the level NumberOfLevels
   * becomes one curved cell, whose nodes are on the limit, where the parameters divide the cell
   * evenly, as EvaluateLimit has them. QUADRATIC_CELLS have nodes at corners and edges
   * (VTK_QUADRATIC_EDGE, _TRIANGLE, _QUAD, _TETRA, _PYRAMID, _WEDGE, _HEXAHEDRON), LAGRANGE_CELLS
   * all nodes of CellOrder (VTK_LAGRANGE_CURVE and so on; VTK has no such pyramids, which are an
   * error). Cells that share an edge or face, of any dimension, share its nodes; values of all
   * arrays are those at the nodes, and nodes are doubled where values jump. An octahedron is four
   * tetrahedra, and there is no `OctahedronId`. Points that are no nodes are left out; cells have
   * no global ids. The nodes are the points of one or two more levels, which take their time and
   * memory. With all volume schemes, and of surface schemes with LOOP, CATMULL_CLARK (for which 0
   * levels are 1 if a face is no quad) and LINEAR.
   *
   * Each solid is proved to be nowhere inside out: the Bernstein coefficients of the determinant of
   * its Jacobian are bounds on it, and the cell is halved until they decide (Johnen, Remacle and
   * Geuzaine 2013). Cell arrays: `ScaledJacobian` (vtkDoubleArray; a lower bound on the
   * determinant, divided by its mean; 1 for cells that are no solids) and `Valid`
   * (vtkUnsignedCharArray, 0 or 1). Where a solid is not valid, its nodes go back towards the
   * straight cell by the smallest part, in steps of 1/32, that makes it valid; nodes on the
   * boundary go last. A warning tells how many and how far. Blocks, ranks and materials that share
   * a node move it alike. A solid that is inside out even if it is straight is an error that names
   * it; the output then has it, with 0 in `Valid`.
   */
  vtkSetClampMacro(OutputCells, int, LINEAR_CELLS, LAGRANGE_CELLS);
  vtkGetMacro(OutputCells, int);
  void SetOutputCellsToLinear() { this->SetOutputCells(LINEAR_CELLS); }
  void SetOutputCellsToBezier() { this->SetOutputCells(BEZIER_CELLS); }
  void SetOutputCellsToQuadratic() { this->SetOutputCells(QUADRATIC_CELLS); }
  void SetOutputCellsToLagrange() { this->SetOutputCells(LAGRANGE_CELLS); }
  ///@}

  ///@{
  /**
   * The order of the cells of OutputCells = LAGRANGE_CELLS, 1 to 6, default 2. QUADRATIC_CELLS have
   * 2. Nodes of the orders 3, 5 and 6 are no points of levels: each is evaluated by itself, as
   * EvaluateLimit does, in the first cell that has it. That takes far longer. It is an error on
   * several ranks and with values that jump; with VolumeScheme = LINEAR and KeepCellTypes, and by
   * LINEAR of vtkSurfaceSubdivision, a warning says that cells stay linear.
   */
  vtkSetClampMacro(CellOrder, int, 1, 6);
  vtkGetMacro(CellOrder, int);
  ///@}

  ///@{
  /**
   * The distance from the limit that Bezier cells may have: as a part of the diagonal of the mesh,
   * and the difference of each component of an array as a part of the array's range. Cells that
   * were split NumberOfLevels times may leave out more. The filter looks at the points of one
   * further level, where two thirds of this are allowed. 0 to 1, default 0.0001. 0 splits all cells
   * whose limit is no polynomial, but for rounding, NumberOfLevels times.
   */
  vtkSetClampMacro(BezierTolerance, double, 0., 1.);
  vtkGetMacro(BezierTolerance, double);
  ///@}

  ///@{
  /**
   * Whether the operators or levels and the output's cells are kept, so that an execution whose
   * cells and options have not changed (new coordinates or arrays, another time step) builds no
   * topology: connectivity, offsets and types are shared with the previous output, and in
   * vtkMultiDimensionalSubdivision so are the points if the coordinates are the same. Cells are
   * compared by content, with a kept copy. Choices made from coordinates (diagonals, polygon cuts,
   * features) are made again; where one comes out differently, everything is built again: the
   * output always equals the output of a fresh filter. Where only rules changed, operators are made
   * again but the cells of vtkMultiDimensionalSubdivision stay shared. Kept for the whole of a
   * composite input, or for each block if JoinBlocks is off, until an update does not need it. On
   * by default.
   */
  void SetCacheOperator(bool cache);
  vtkGetMacro(CacheOperator, bool);
  vtkBooleanMacro(CacheOperator, bool);
  ///@}

  /**
   * Computes the matrix by which the filter moves points, with the present options on the present
   * input, which is updated. Returns false after an error: the input must be a mesh in one piece,
   * without InterpolatePoints, InterpolateArrays and InterfaceValues. With CacheOperator an update
   * before has made most of it, and the next one can use it. Points are numbered as
   * OutputDimensions = ALL_DIMENSIONS numbers them. With JoinSeams it is the operator of the
   * points, and arrays have another at seams.
   */
  virtual bool ComputeOperator(vtkSubdivisionOperator* result);

  /**
   * Computes the matrix from values at the nodes of the output of one level less to values at the
   * nodes of the output, with OutputCells = QUADRATIC_CELLS or LAGRANGE_CELLS: the prolongation of
   * a solver on nested levels. A node lies at a place of a cell of the level before; its row has
   * the shape functions of that cell there. So polynomials of the order of the cells, in their
   * parameters, stay what they are; but the four cells of an octahedron are no parts of such ones.
   * Needs an input as ComputeOperator does; it makes both outputs. Returns false after an error.
   */
  bool ComputeProlongation(vtkSubdivisionOperator* result);

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
  vtkUniformSubdivisionAlgorithm();
  ~vtkUniformSubdivisionAlgorithm() override;

  bool CanInterpolate() const override { return true; }
  bool HasGhostLayers() const override { return !this->WritesCurvedCells(); }
  void Inspect(vtkDataObject* input, vtkDataObject* readable) override;
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made) override;

  /// The needs of Bezier cells, if they cannot be made with the present options; else null.
  virtual const char* DescribeBezierNeeds() const = 0;
  /// Whether the first level has quads where faces are none.
  virtual bool MakesQuads() const { return false; }
  /// Whether this execution has an output, and that has Bezier cells.
  bool WritesBezierCells() const;
  /// The same of cells with nodes on the limit, and of any of both.
  virtual const char* DescribeCurvedNeeds() const { return nullptr; }
  bool WritesNodes() const;
  /// Whether nodes that are asked for are no points of levels.
  bool HasNodesBetweenLevels() const;
  bool WritesCurvedCells() const { return this->WritesBezierCells() || this->WritesNodes(); }
  /// Makes curved cells of an output; `isWhole`: no cells were left out.
  vtkSmartPointer<vtkDataObject> MakeCurvedCells(vtkDataObject* made, bool isWhole);
  /// Whether this execution has an output with error bounds.
  bool AddsBounds() const;
  /// Evaluates the limit at places in an execution of its own. Returns false after an error.
  bool FindLimit(vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result);

  /// Reads the options above, and warns where they are ignored.
  void ReadLevelOptions(subdivision::LevelOptions& options);
  /// Asks for normals where SmoothShading wants them, if they are cheap.
  void AskForShading(subdivision::LevelOptions& options, bool areCheap) const;
  using Work = std::function<bool(vtkPointSet*, vtkPointSet*)>;
  /// Run of vtkSubdivisionAlgorithm with these options, as often as Bezier cells need it: calls
  /// `subdivide`, and then `addBounds` if AddsBounds.
  int RunLevels(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    subdivision::LevelOptions& options, bool isLocal, const Work& subdivide, const Work& addBounds);

  int NumberOfLevels = 1;
  bool ProjectToLimit = false;
  bool GenerateLimitNormals = false;
  bool SmoothShading = true;
  bool GenerateTangents = false;
  bool GenerateErrorBounds = false;
  int OutputCells = LINEAR_CELLS;
  int CellOrder = 2;
  double BezierTolerance = 1e-4;
  bool CacheOperator = true;
  bool Use32BitIds = false;
  const subdivision::PlaceRequest* Places = nullptr; ///< what EvaluateLimit wants

private:
  subdivision::CurvedKind GetKindOfNodes() const;
  int GetOrderOfNodes() const;
  void SetLevelsOfNodes(subdivision::LevelOptions& options) const;
  bool EvaluatesNodes() const { return this->WritesNodes() && this->HasNodesBetweenLevels(); }
  bool EvaluateNodes(vtkPointSet* made, subdivision::LevelOptions& options, const Work& subdivide);

  std::unique_ptr<subdivision::KeptEntries> Cache;
  std::unique_ptr<subdivision::BezierRounds> Bezier;
  int LeastLevels = 0;                           ///< that cells with nodes need
  subdivision::Prolongation* Prolongs = nullptr; ///< what gets the cells
  /// Of the cells that this execution made, where they are no points of levels.
  std::unique_ptr<std::vector<subdivision::CurvedNodes>> Nodes;

  vtkUniformSubdivisionAlgorithm(const vtkUniformSubdivisionAlgorithm&) = delete;
  void operator=(const vtkUniformSubdivisionAlgorithm&) = delete;
};

#endif
