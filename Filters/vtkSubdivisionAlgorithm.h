// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSubdivisionAlgorithm
 * @brief   common base of all filters that subdivide
 *
 * The input is a vtkUnstructuredGrid, a vtkPolyData, structured data (vtkImageData,
 * vtkRectilinearGrid, vtkStructuredGrid, vtkExplicitStructuredGrid), or a composite of these, seen
 * as a simplicial complex whose cells may
 * have any dimension from 0 to 3 (Chang & Qin, "A Framework for Multi-dimensional Adaptive
 * Subdivision Objects", section 2). The output is a vtkUnstructuredGrid of VTK_VERTEX, VTK_LINE,
 * VTK_TRIANGLE and VTK_TETRA cells; of vtkMultiDimensionalSubdivision also of quads, hexahedra,
 * wedges and pyramids, which it does not split as this class says (VolumeScheme = AUTOMATIC).
 *
 * @par Surface filters
 * vtkSurfaceSubdivision and vtkAdaptiveSurfaceSubdivision have these options, too. They read and
 * write vtkPolyData, and their own documentation tells of cells and creases. Of structured data and
 * grids they take the vertices, lines and surfaces, in the order of vtkPolyData, and leave solids
 * out with a warning. With a warning they ignore options that they have no rules for:
 * EmbeddedCells, rules for joints other than Blend and Sharp, and the arrays at the indices 2 and
 * 3.
 *
 * @par Cells
 * The filters read VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE, VTK_TRIANGLE,
 * VTK_TRIANGLE_STRIP, VTK_PIXEL, VTK_QUAD, VTK_POLYGON, VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON,
 * VTK_WEDGE, VTK_PYRAMID, VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_POLYHEDRON, and all
 * quadratic, cubic, Lagrange and Bezier cells that VTK has a class of (QuadraticCells). Cells that
 * are no simplices are split conformingly: two cells that
 * share a quad take the same diagonal, which is the one that triangles of a neighbour have already,
 * else the one through the smallest global id (the point id where the input has no global ids).
 * Polygons are cut by ears in their mean plane. A centre point is added only to a solid cell whose
 * face diagonals allow no other split, and to each prism and polyhedron, whose faces are split like
 * polygons. Structured data are voxels, pixels, hexahedra, quads or lines, however many axes have
 * more than one point; blanked cells, and cells with a blanked point, are hidden.
 *
 * @par Normals
 * The active normals of points and cells of the input hold only where nothing moves. Where points
 * move they are left out, also if an earlier filter made them; GenerateLimitNormals makes new ones,
 * which are the active normals of the output. Where cells are split and their points stay
 * (VolumeScheme = LINEAR, Placement = LINEAR), children have the normals of their cell, and the
 * normals of points are left out. Deformation turns normals instead.
 *
 * @par Bad cells
 * The filters leave out cells of another type, with point ids out of range, with a point that is
 * not finite, or with repeated point ids (of a solid, polygon, poly line or strip only the
 * degenerate pieces). One warning for each of these faults counts the cells and names the first.
 * Cells that are left out have no effect on their neighbours. Cells that are inverted or have no
 * size are kept, and so are unused points.
 *
 * @par Singular simplices
 * The following simplices are singular, together: the vertex, line and triangle cells that the
 * array at index 0 flags; cells embedded in others, by EmbeddedCells; with PreserveInterfaces the
 * interfaces between materials; with DetectFeatures the edges with a large angle; and the marks of
 * filters that derive from vtkMarkedSubdivisionAlgorithm. A singular vertex does not move, singular
 * lines become smooth curves (creases), and singular triangles become smooth surfaces inside the
 * solid. Where more than two singular lines meet there is a corner.
 *
 * @par Cell arrays read, by SetInputArrayToProcess
 * A name that is empty or "None" means unset; a named array that is missing, or has the wrong type,
 * is an error. All have one component. Integers may be stored as floating point numbers, as Exodus
 * does.
 *  - 0, singular flags: integers, non-zero = singular; unset: `Singular` if there. Flags of
 *    poly lines, strips and polygons count for their pieces; flags of 3D cells are ignored with a
 *    warning.
 *  - 1, materials: any type but strings; unset: `MaterialId` if there.
 *  - 2, parts for FollowPart: integers, negative = no part; unset: none.
 *  - 3, rules of regions: integers; 0 = the options Type1Rule to Type3Rule, 1 = Blend, 2 = Sharp,
 *    3 to 5 = FollowDimension1 to FollowDimension3, 6 = FollowPart. At a joint the maximal cell
 *    with the smallest id that has a non-zero value decides. Unset: none.
 *  - 4, sharpness of lines and, except on the surfaces of vtkSurfaceSubdivision, of faces: numbers;
 *    a crease or surface of sharpness s stays sharp for s levels, the last, if s is no whole
 * number, in part; infinite = flagged. With PreserveInterfaces a triangle of sharpness above 0 says
 * how long the interface is kept there. Unset: none.
 *
 * @par Arrays read, by SetInputArrayToProcess
 *  - 10, point array of angles of corners (property CornerAngleArray) for ModifiedBoundary, in
 *    degrees, each of all sectors at the corner. Negative or not a number: the plain rule, in the
 *    surface filters the angle that is measured. Unset: none.
 *  - 13, point array of weights or flags (property InterpolationArray) for InterpolatePoints and
 *    InterpolateArrays, 0 to 1: which part of the way from its smoothed place to its datum the
 * limit of a point goes. Points of weight 0 are free: their control points and values stay as they
 *    are. Unset: 1 everywhere.
 *
 * @par Ghosts
 * Hidden cells, cells that finer levels of AMR replace, and cells at hidden points have no effect
 * and are not in the output. On several ranks, and in composite data sets, duplicate cells of the
 * input are left out: with JoinBlocks filters get the cells around a partition from other ranks, so
 * that results at its border are the same as of the whole mesh. The output has as many layers of
 * duplicate cells as the filter downstream asks for. In a single mesh of a single process, children
 * take the ghost type of their cell, ghost types of points are derived from the cells, and a
 * warning says where there are too few layers for results to be the same as of the whole.
 */
#ifndef vtkSubdivisionAlgorithm_h
#define vtkSubdivisionAlgorithm_h

#include "vtkPointSetAlgorithm.h"
#include "vtkSmartPointer.h"             // for vtkSmartPointer
#include "vtkSubdivisionObjectsModule.h" // for export macro

#include <array>      // for std::array
#include <functional> // for std::function
#include <memory>     // for std::unique_ptr
#include <string>     // for std::string
#include <vector>     // for std::vector

class vtkMultiProcessController;
class vtkPointSet;
class vtkSubdivisionOperator;
namespace subdivision
{
class KeptParts;
class MatrixFactors;
class ToldWarnings;
struct RunOptions;
}

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSubdivisionAlgorithm : public vtkPointSetAlgorithm
{
public:
  vtkTypeMacro(vtkSubdivisionAlgorithm, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How solids are split and smoothed, in all filters with VolumeScheme.
  enum VolumeSchemes
  {
    BOX_SPLINE,
    TET_OCT,
    LINEAR,
    HYBRID,
    AUTOMATIC
  };

  ///@{
  /**
   * Whether integer point arrays are smoothed and rounded, like colours, too. Off by default: a new
   * point takes the value of the edge's end whose global id is smaller, so that labels stay labels.
   */
  vtkSetMacro(InterpolateIntegers, bool);
  vtkGetMacro(InterpolateIntegers, bool);
  vtkBooleanMacro(InterpolateIntegers, bool);
  ///@}

  ///@{
  /**
   * Whether to output the cell array `vtkOriginalCellIds` and the point array `vtkOriginalPointIds`
   * (vtkIdTypeArray, one component): the cell or point of this filter's input that each came from,
   * -1 for new points. On the output of another filter of this kind they are carried on, and where
   * this is off the ids of any input, whatever wrote them: new points have -1. With the first of
   * them go the global ids of cells, if there are any, for instance numbers of elements: by their
   * own name, as an array that is not marked as global ids, because cells share them. Off by
   * default.
   */
  vtkSetMacro(GenerateOriginalIds, bool);
  vtkGetMacro(GenerateOriginalIds, bool);
  vtkBooleanMacro(GenerateOriginalIds, bool);
  ///@}

  ///@{
  /**
   * Whether to give points and cells global ids (the active attributes `GlobalPointIds` and
   * `GlobalCellIds`, vtkIdTypeArray, one component): their indices in the output of the whole mesh,
   * however it is distributed over blocks and ranks; but see InterfaceValues. If JoinBlocks is off,
   * they count in each block. No effect in vtkSubdivisionDeformation. Off by default.
   */
  vtkSetMacro(GenerateGlobalIds, bool);
  vtkGetMacro(GenerateGlobalIds, bool);
  vtkBooleanMacro(GenerateGlobalIds, bool);
  ///@}

  ///@{
  /**
   * Whether the limit passes through the points of the input. The filter then does not take these
   * for control points, but solves for control points whose limits they are: a smooth object does
   * not shrink. Rules and diagonals are chosen for the points of the input. For
   * vtkMultiDimensionalSubdivision, vtkSurfaceSubdivision (with schemes that have limits) and
   * vtkRedGreenRefinement (with Placement LIMIT); other filters warn and ignore it. Ranks that have
   * parts of a mesh solve together, and find the control points that one process finds. In a row of
   * filters switch it on in all or in the first: later ones leave values as they are that are
   * solved already. Where 40 products with the limit operator do not reach an error of 1e-10 of the
   * range (single precision: of its rounding), the filter factorises the matrix; a warning says so
   * if there is no solution, or the factors take more than the memory or half a minute. Off by
   * default.
   */
  vtkSetMacro(InterpolatePoints, bool);
  vtkGetMacro(InterpolatePoints, bool);
  vtkBooleanMacro(InterpolatePoints, bool);
  ///@}

  ///@{
  /**
   * The same for the values of floating point arrays at points: arrays of AddInterpolatedArray, or
   * all if there are none. Between the points values may exceed the range of the input's; a warning
   * says by how much. Values that are not finite are missing: they, and values whose limits they
   * take part in, stay as they are, and all others are solved for without them. With
   * InterfaceValues DISCONTINUOUS errors are parts of the range of each material. Off by default.
   */
  vtkSetMacro(InterpolateArrays, bool);
  vtkGetMacro(InterpolateArrays, bool);
  vtkBooleanMacro(InterpolateArrays, bool);
  ///@}

  ///@{
  /**
   * The names of the point arrays for InterpolateArrays; none: all of floating point numbers. A
   * warning tells of a name that the input does not have.
   */
  void AddInterpolatedArray(const char* name);
  void RemoveAllInterpolatedArrays();
  ///@}

  ///@{
  /**
   * How far control points and values are moved: from the input's own (0, plain smoothing) to
   * control values that interpolate (1), 0 to 1. Default 1.
   */
  vtkSetClampMacro(InterpolationWeight, double, 0., 1.);
  vtkGetMacro(InterpolationWeight, double);
  ///@}

  ///@{
  /**
   * Precision of the output points, as in vtkAlgorithm: SINGLE_PRECISION (0), DOUBLE_PRECISION (1)
   * or DEFAULT_PRECISION (2, the default; the input's own).
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * The filter stops with an error, before it takes any memory for them, if the output would have
   * more cells than this, 1 or more. Default 500 million. The panels of ParaView, which show no
   * numbers of 64 bits, set it as a double, cut to a whole number.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  void SetMaximumNumberOfCellsAsDouble(double cells);
  ///@}

  enum CreaseEnds
  {
    CORNER,
    DART
  };
  ///@{
  /**
   * Where exactly one singular line ends at a vertex: CORNER (0, the default; the vertex does not
   * move: the end of a curve) or DART (1; as if the crease were not there, so that it fades out; a
   * corner all the same on a boundary curve).
   */
  vtkSetClampMacro(CreaseEnd, int, CORNER, DART);
  vtkGetMacro(CreaseEnd, int);
  void SetCreaseEndToCorner() { this->SetCreaseEnd(CORNER); }
  void SetCreaseEndToDart() { this->SetCreaseEnd(DART); }
  ///@}

  enum LoopWeightsRules
  {
    WARREN_WEIGHTS,
    LOOP_WEIGHTS
  };
  ///@{
  /**
   * The weights of vertices inside surfaces and inside the boundaries of solids, where Loop's
   * scheme holds: WARREN_WEIGHTS (0, the default; equation 16 of Chang & Qin) or LOOP_WEIGHTS (1;
   * the weights of Loop's thesis, which OpenSubdiv, CGAL, OpenMesh and VTK have). The two are equal
   * at vertices of three and of six triangles. Limits, tangents and normals follow the choice. No
   * effect where another scheme moves the points.
   */
  vtkSetClampMacro(LoopWeights, int, WARREN_WEIGHTS, LOOP_WEIGHTS);
  vtkGetMacro(LoopWeights, int);
  void SetLoopWeightsToWarren() { this->SetLoopWeights(WARREN_WEIGHTS); }
  void SetLoopWeightsToLoop() { this->SetLoopWeights(LOOP_WEIGHTS); }
  ///@}

  ///@{
  /**
   * Whether the rules of surfaces and of the boundaries of solids next to borders, creases and
   * corners depend on the number of faces there (D. Zorin, survey in "Subdivision for Modeling and
   * Animation"): a new point on an edge that ends on a border or crease has the weights of that
   * sector, which is bounded by two edges that are not smooth. By the plain rules a surface is not
   * smooth there from seven triangles on, and folds at concave corners. With three triangles both
   * are the same, and on closed surfaces without creases. At corners the weights depend on the
   * angle too, and from 180 degrees on new points move towards the plane of the two edges that
   * bound the sector. The surface filters measure the angles or take them from the array at index
   * 10; in all others a corner without an angle in this array has the plain rules. Limits, normals
   * and tangents follow. For the schemes Loop, Catmull-Clark, sqrt(3) and 4-8, and solids, whose
   * surfaces are Loop's; no effect where others move the points. On by default.
   */
  vtkSetMacro(ModifiedBoundary, bool);
  vtkGetMacro(ModifiedBoundary, bool);
  vtkBooleanMacro(ModifiedBoundary, bool);
  ///@}

  enum EmbeddedCellRules
  {
    FOLLOW,
    SINGULAR_INSIDE,
    SINGULAR
  };
  ///@{
  /**
   * The role of vertex, line and triangle cells that are faces of other cells: FOLLOW (0, the
   * default; only carried along), SINGULAR_INSIDE (1; cells inside a solid, surface or curve are
   * singular, for example fractures and wells in rock; cells on a boundary or a non-manifold joint
   * follow) or SINGULAR (2; all of them).
   */
  vtkSetClampMacro(EmbeddedCells, int, FOLLOW, SINGULAR);
  vtkGetMacro(EmbeddedCells, int);
  void SetEmbeddedCellsToFollow() { this->SetEmbeddedCells(FOLLOW); }
  void SetEmbeddedCellsToSingularInside() { this->SetEmbeddedCells(SINGULAR_INSIDE); }
  void SetEmbeddedCellsToSingular() { this->SetEmbeddedCells(SINGULAR); }
  ///@}

  ///@{
  /**
   * Whether interior faces between different values of the material array (index 1) are singular
   * surfaces, and edges between two faces of a surface of different values creases. Off by default;
   * an error if there is no material array.
   */
  vtkSetMacro(PreserveInterfaces, bool);
  vtkGetMacro(PreserveInterfaces, bool);
  vtkBooleanMacro(PreserveInterfaces, bool);
  ///@}

  enum InterfaceValuesRules
  {
    CONTINUOUS_VALUES,
    DISCONTINUOUS_VALUES
  };
  ///@{
  /**
   * Values at points where materials meet: CONTINUOUS_VALUES (0, the default; one field over all
   * materials) or DISCONTINUOUS_VALUES (1; each material has a field of its own, smoothed with its
   * own values only). Then a point at which several materials meet has a copy for each of them, at
   * the same place: copies follow after all other points, each cell names the copies of its
   * material (cells that are faces of others: of a material that all of their points have), and the
   * point array `MaterialPointIds` (vtkIdType) says which point each is. Another filter with the
   * same option, or whoever joins equal ids, gets the mesh without copies back. Values of blocks at
   * points that they share belong to the cells of each block. On several ranks MaterialPointIds has
   * the ids of points in the whole output, and global ids belong to points, equal for copies.
   * Arrays of floating point numbers and AddFieldOfCells become fields; all others, and
   * coordinates, are equal for copies. Ignored with a warning without PreserveInterfaces, and in
   * filters that have no interfaces. Needs memory for each array as often as there are materials
   * that must be told apart, as a simplex has points of both; an error if these are more than 32.
   * With InterpolateArrays the limit of each field passes through the values of its material; after
   * a level a warning counts points where it does not, as the material touches others in edges or
   * points only.
   */
  vtkSetClampMacro(InterfaceValues, int, CONTINUOUS_VALUES, DISCONTINUOUS_VALUES);
  vtkGetMacro(InterfaceValues, int);
  void SetInterfaceValuesToContinuous() { this->SetInterfaceValues(CONTINUOUS_VALUES); }
  void SetInterfaceValuesToDiscontinuous() { this->SetInterfaceValues(DISCONTINUOUS_VALUES); }
  ///@}

  ///@{
  /**
   * The names of cell arrays that become point arrays with InterfaceValues = DISCONTINUOUS_VALUES:
   * the value of a material at a point is the mean of its cells there. They stay cell arrays, too.
   * None by default. A warning tells of a name that the input does not have, or that a point array
   * has.
   */
  void AddFieldOfCells(const char* name);
  void RemoveAllFieldsOfCells();
  ///@}

  ///@{
  /**
   * Whether edges of the input are creases where the boundary of a solid, or a surface, turns by
   * more than FeatureAngle. Off by default.
   */
  vtkSetMacro(DetectFeatures, bool);
  vtkGetMacro(DetectFeatures, bool);
  vtkBooleanMacro(DetectFeatures, bool);
  ///@}

  ///@{
  /**
   * The angle between the planes of two triangles (flat: 0) above which their common edge is a
   * feature; an angle that differs by no more than rounding is not above. In degrees, 0 to 180.
   * Default 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0., 180.);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  enum Type1Rules
  {
    TYPE1_BLEND,
    TYPE1_SHARP,
    TYPE1_FOLLOW_DIMENSION1,
    TYPE1_FOLLOW_DIMENSION2,
    TYPE1_FOLLOW_DIMENSION3
  };
  ///@{
  /**
   * The rule of vertices and edges where objects of different dimension meet: blend (0, the
   * default: rule G-2, the weights of solids with all neighbours), stay sharp (1: rule G-1), or
   * follow the object of dimension 1, 2 or 3 (2 to 4) as if the others were not there.
   */
  vtkSetClampMacro(Type1Rule, int, TYPE1_BLEND, TYPE1_FOLLOW_DIMENSION3);
  vtkGetMacro(Type1Rule, int);
  void SetType1RuleToBlend() { this->SetType1Rule(TYPE1_BLEND); }
  void SetType1RuleToSharp() { this->SetType1Rule(TYPE1_SHARP); }
  void SetType1RuleToFollowDimension1() { this->SetType1Rule(TYPE1_FOLLOW_DIMENSION1); }
  void SetType1RuleToFollowDimension2() { this->SetType1Rule(TYPE1_FOLLOW_DIMENSION2); }
  void SetType1RuleToFollowDimension3() { this->SetType1Rule(TYPE1_FOLLOW_DIMENSION3); }
  ///@}

  enum Type2Rules
  {
    TYPE2_BLEND,
    TYPE2_SHARP,
    TYPE2_FOLLOW_PART
  };
  ///@{
  /**
   * Their rule where more than two branches of one object meet: blend (0, the default), stay sharp
   * (1), or follow a part (2): of the parts (array index 2) that go on through the joint with
   * exactly two branches the one with the smallest id does, and the others are ignored.
   */
  vtkSetClampMacro(Type2Rule, int, TYPE2_BLEND, TYPE2_FOLLOW_PART);
  vtkGetMacro(Type2Rule, int);
  void SetType2RuleToBlend() { this->SetType2Rule(TYPE2_BLEND); }
  void SetType2RuleToSharp() { this->SetType2Rule(TYPE2_SHARP); }
  void SetType2RuleToFollowPart() { this->SetType2Rule(TYPE2_FOLLOW_PART); }
  ///@}

  enum Type3Rules
  {
    TYPE3_BLEND,
    TYPE3_SHARP
  };
  ///@{
  /**
   * Their rule where boundaries of one object touch: blend (0, the default) or stay sharp (1).
   */
  vtkSetClampMacro(Type3Rule, int, TYPE3_BLEND, TYPE3_SHARP);
  vtkGetMacro(Type3Rule, int);
  void SetType3RuleToBlend() { this->SetType3Rule(TYPE3_BLEND); }
  void SetType3RuleToSharp() { this->SetType3Rule(TYPE3_SHARP); }
  ///@}

  enum QuadraticCellsRules
  {
    CORNERS,
    PIECES
  };
  ///@{
  /**
   * The linear cells in place of quadratic, cubic, Lagrange and Bezier cells: CORNERS (0, the
   * default; one linear cell at the corners of each; nodes that no cell uses any more become plain
   * points, of which a warning tells) or PIECES (1; they are cut along their nodes, an element of
   * order n with all nodes of its lattice into n, n x n or n x n x n linear cells; of Bezier cells
   * along their control points).
   */
  vtkSetClampMacro(QuadraticCells, int, CORNERS, PIECES);
  vtkGetMacro(QuadraticCells, int);
  void SetQuadraticCellsToCorners() { this->SetQuadraticCells(CORNERS); }
  void SetQuadraticCellsToPieces() { this->SetQuadraticCells(PIECES); }
  ///@}

  ///@{
  /**
   * Whether cells whose points have equal coordinates, or nearly (MergeTolerance), share one point:
   * the point with the smallest global id (index, where there are none). The others are not in the
   * output; original ids stay as in the input, and points without cells stay as they are. Cells
   * that become degenerate are left out with a warning, which tells that MergePoints did it. It
   * also joins parts that only touch, and points that were doubled on purpose. Where values of
   * points that become one differ, a warning names the arrays, and MergedValues decides; normals,
   * which a filter makes anew, do not count. Takes n log n steps for n points. Off by default:
   * parts are joined where they share points, and a warning counts the points that cells would
   * share with this option, and names two of them, also along cracks whose points are doubled on
   * purpose; they may be 1e-6 of the size of the mesh apart. vtkRedGreenRefinement, which works
   * where it refines only, does not look for them.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /**
   * Whether pieces of a surface that touch along their edges share points there, if together they
   * are one closed surface, or if each is one face: the sides of vtkCubeSource, the caps of
   * vtkCylinderSource, the triangles of STL files, which have points of their own at equal
   * coordinates. All others stay apart, and the warning of MergePoints tells of them: cracks inside
   * a piece, edges that three faces would have, sheets that lie on each other (at an angle below 1
   * degree), other open sheets, faces with two points at one place, and meshes with solids.
   *
   * All pieces that touch are joined, or none: coordinates and cells decide, values do not. A piece
   * meets itself at a seam only where texture coordinates differ. The first point gives the values,
   * with a warning where they differ; with MergedValues = AVERAGE_VALUE there are means. Texture
   * coordinates that differ are left out; vtkMultiDimensionalSubdivision, and vtkRedGreenRefinement
   * linearly in each control triangle, keep both sides of closed surfaces, if OutputCells are
   * linear and nothing is closed, bounded or jumps. vtkAdaptiveSurfaceSubdivision cannot: it flips
   * edges, so that its triangles lie across seams. JoinSeams of vtkSurfaceSubdivision comes first:
   * it keeps them, and joins all equal points of the mesh. On several ranks surfaces that are
   * closed on a rank are joined; a warning tells of others. Without effect with MergePoints, on
   * vtkSubdivisionDeformation, on meshes with global ids that ranks or blocks share, and where
   * values jump already (InterfaceValues). On by default.
   */
  vtkSetMacro(JoinSides, bool);
  vtkGetMacro(JoinSides, bool);
  vtkBooleanMacro(JoinSides, bool);
  ///@}

  ///@{
  /**
   * How far points may be apart that MergePoints joins. Where there is a chain of points, each near
   * to the next one, all are joined. All get the least coordinates of any of them, x first. On
   * several ranks it is ignored with a warning. A part of the diagonal of the bounding box of all
   * points, 0 to 0.1. Default 0.
   */
  vtkSetClampMacro(MergeTolerance, double, 0., 0.1);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  enum MergedValuesRules
  {
    FIRST_VALUE,
    AVERAGE_VALUE,
    KEEP_VALUES
  };
  ///@{
  /**
   * The values that MergePoints gives to points that become one: FIRST_VALUE (0, the default; the
   * values of the point with the smallest id, with a warning where they differ; texture coordinates
   * that differ are left out), AVERAGE_VALUE (1; the mean of floating point numbers, with
   * InterpolateIntegers of integers too) or KEEP_VALUES (2; all of them: coordinates come from one
   * point, and values jump). Values jump at seams as JoinSeams has them in vtkSurfaceSubdivision
   * with a scheme that has these, in other filters, as with InterfaceValues, between parts of the
   * mesh which are connected by points of equal values. With JoinSeams texture coordinates are kept
   * in any case. Without MergePoints no effect; on several ranks KEEP_VALUES needs seams.
   */
  vtkSetClampMacro(MergedValues, int, FIRST_VALUE, KEEP_VALUES);
  vtkGetMacro(MergedValues, int);
  void SetMergedValuesToFirst() { this->SetMergedValues(FIRST_VALUE); }
  void SetMergedValuesToAverage() { this->SetMergedValues(AVERAGE_VALUE); }
  void SetMergedValuesToKeep() { this->SetMergedValues(KEEP_VALUES); }
  ///@}

  ///@{
  /**
   * Whether cells are cut where points of others lie inside their edges and faces (hanging nodes,
   * as adaptive meshes, quadtrees and octrees have, and meshes of two sizes beside each other), so
   * that cells fit: a line gets the points on it, a polygon the points on its edges, and a solid
   * becomes a polyhedron that has the faces of its neighbours. The distance of such a point may be
   * 1e-5 of the edge. A warning counts cells that cannot be cut so: strips, non-linear cells, and
   * cells whose faces no others cover whole. On several ranks, cells fit if the ones that touch
   * share a point. Off by default: a warning counts the points that hang, and names the first cell.
   */
  vtkSetMacro(CloseHangingNodes, bool);
  vtkGetMacro(CloseHangingNodes, bool);
  vtkBooleanMacro(CloseHangingNodes, bool);
  ///@}

  ///@{
  /**
   * Whether the blocks of a composite input that share points are one mesh, and likewise the
   * partitions that the ranks of the Controller have. Points of the same global id and place are
   * one point, and without global ids points of the same coordinates. Blocks with cells between the
   * same points (of the highest dimension that there is) are cases or time steps of one mesh, if
   * these are half of the cells of one of them or values differ there; so are blocks that others
   * connect. They are the first, second and so on, and blocks are joined with the blocks of the
   * same number only. Where blocks of one case have different values at a point that they share,
   * each keeps its own, and floating point numbers jump as with InterfaceValues. Warnings tell of
   * both. If off, every block of every rank is worked on by itself, and its border is a boundary.
   * On by default.
   */
  vtkSetMacro(JoinBlocks, bool);
  vtkGetMacro(JoinBlocks, bool);
  vtkBooleanMacro(JoinBlocks, bool);
  ///@}

  ///@{
  /**
   * The ranks that have partitions of the input; all of them have to update the filter. Null: this
   * process has the whole input. The default is the global controller when the filter is made.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  /**
   * Vertices, lines, triangles and tetrahedra that the cells of the input are before the first
   * level, corners of its polygons, and its cells; then its faces, pyramids and other solids where
   * cells keep their types: for programs that tell how much the filter would make. All are 0 while
   * the input has no data; on ranks they are those of this one. Polyhedra and cells of higher order
   * count as if they were hexahedra and polygons.
   */
  double* GetControlCounts() VTK_SIZEHINT(9);

protected:
  vtkSubdivisionAlgorithm();
  ~vtkSubdivisionAlgorithm() override;

  /// Whether the filter works on vtkPolyData and writes that. Others work on vtkUnstructuredGrid
  /// too, and write that.
  virtual bool IsOfSurfaces() const { return false; }
  /// Whether a filter of surfaces writes vtkPolyData, and not a vtkUnstructuredGrid that Finish
  /// makes of it.
  virtual bool WritesSurfaces() const { return this->IsOfSurfaces(); }
  /// Whether the output gets the ghost cells that the pipeline asks for.
  virtual bool HasGhostLayers() const { return true; }
  /// Whether cells of the output have the ids of the input's cells.
  virtual bool HasOriginalCellIds() const { return this->GenerateOriginalIds; }
  /// Whether it has rules for InterpolatePoints and InterpolateArrays.
  virtual bool CanInterpolate() const { return false; }
  /// Whether it keeps interfaces between materials, at which values may jump.
  virtual bool HasInterfaces() const { return false; }
  /// Whether it keeps values at points of equal coordinates (MergedValues) by seams, and whether
  /// seams of texture coordinates are seams in any case.
  virtual bool HasSeams() const { return false; }
  virtual bool JoinsSeams() const { return false; }
  /// Whether JoinSides has an effect.
  virtual bool CanJoinSides() const { return true; }
  /// Whether the filter gives sides that JoinSides joins their texture coordinates again.
  virtual bool TearsSeams() const { return false; }
  /// How many layers of the cells of others a rank needs around its own.
  virtual int GetLayersOfCells() const { return 2; }
  /// Whether an execution is for its output, and not for an operator.
  bool HasOutput() const { return this->Factors == nullptr; }
  /// Whether several ranks have partitions of one mesh.
  bool SharesRanks() const;
  /// Adds the knowledge of a filter about a block of the input to `copy`, which is joined with
  /// other blocks.
  virtual void Prepare(vtkPointSet*, vtkPointSet*) {}
  /// Called with the input of the pipeline and with the mesh that is read of it, before the work.
  /// Cells and points have the same ids in both.
  virtual void Inspect(vtkDataObject*, vtkDataObject*) {}
  /// Called with the input of the pipeline before anything else, on all ranks together.
  virtual void PrepareRun(vtkDataObject*) {}
  /// Called on all ranks together after Inspect, also where that was not reached: their findings
  /// become one choice.
  virtual void Agree() {}
  /// Called after Inspect with the same. Returns the input of the work: the readable meshes, or
  /// copies with more arrays.
  virtual vtkSmartPointer<vtkDataObject> Mark(vtkDataObject*, vtkDataObject* readable);
  /// Called with the result of the work. Returns the output of the pipeline.
  virtual vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made);
  /// Runs the filter on its input, for something else than its output. Returns false after an
  /// error: the input must be a mesh in one piece.
  bool RunAside();
  /// The same for the operator. Returns false after an error.
  bool FindOperator(vtkSubdivisionOperator* found);
  /// Makes the unstructured grids or vtkPolyData that are read of an input of any kind.
  vtkSmartPointer<vtkDataObject> ReadInput(
    vtkDataObject* input, std::vector<std::string>& warnings);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int ComputeInputUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Indices of SetInputArrayToProcess that mean the same in every filter.
  enum ArrayIndices
  {
    SINGULAR_ARRAY,
    MATERIAL_ARRAY,
    PART_ARRAY,
    RULE_ARRAY,
    SHARPNESS_ARRAY,
    ANGLE_ARRAY = 10,
    INTERPOLATION_ARRAY = 13
  };
  /// Sets options.Features from the options above and the arrays of `input`. Returns false, after
  /// an error (passed to Fail), if an array cannot be used.
  virtual bool ReadFeatureOptions(vtkPointSet* input, subdivision::RunOptions& options);
  /// The common part of RequestData in all filters: sets the shared options, and the functions of
  /// `options` for messages and progress; calls `run`, which returns whether it finished; empties
  /// the output if it did not. `ghosts`: the effect of duplicate cells on the result, empty where
  /// they have none, null where that depends on their layers (FilterTraits); `memory`: the work for
  /// which memory is short, and the cure.
  int Run(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    subdivision::RunOptions& options, const char* ghosts, const std::string& memory,
    const std::function<bool(vtkPointSet*, vtkPointSet*)>& run);

  bool InterpolateIntegers = false;
  bool GenerateOriginalIds = false;
  bool GenerateGlobalIds = false;
  bool InterpolatePoints = false;
  bool InterpolateArrays = false;
  std::vector<std::string> InterpolatedArrays;
  std::vector<std::string> FieldsOfCells;
  double InterpolationWeight = 1.;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  vtkIdType MaximumNumberOfCells = 500000000;
  int CreaseEnd = CORNER;
  int LoopWeights = WARREN_WEIGHTS;
  bool ModifiedBoundary = true;
  int EmbeddedCells = FOLLOW;
  bool PreserveInterfaces = false;
  int InterfaceValues = CONTINUOUS_VALUES;
  bool DetectFeatures = false;
  double FeatureAngle = 30.;
  int Type1Rule = TYPE1_BLEND;
  int Type2Rule = TYPE2_BLEND;
  int Type3Rule = TYPE3_BLEND;
  int QuadraticCells = CORNERS;
  bool MergePoints = false;
  bool JoinSides = true;
  double MergeTolerance = 0.;
  int MergedValues = FIRST_VALUE;
  bool CloseHangingNodes = false;
  bool JoinBlocks = true;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  /// During an execution: the mesh before JoinSides, if its texture coordinates keep both sides.
  vtkSmartPointer<vtkPointSet> Torn;

private:
  /// Whether copies of points keep values that MergePoints finds.
  bool KeepsCopies() const;
  vtkSmartPointer<vtkDataObject> MergeIn(
    vtkDataObject* readable, std::vector<std::string>& warnings);
  vtkSmartPointer<vtkDataObject> JoinIn(
    vtkDataObject* readable, std::vector<std::string>& warnings);
  /// Reads InterpolatePoints and the other options of it.
  void ReadInterpolation(
    subdivision::RunOptions& options, std::vector<std::string>& warnings) const;
  /// Reads which points are interpolated. Returns false after an error.
  bool ReadChosenPoints(vtkPointSet* input, subdivision::RunOptions& options);
  /// Makes vtkPolyData of unstructured grids.
  vtkSmartPointer<vtkDataObject> MakeSurfaces(
    vtkDataObject* input, std::vector<std::string>& warnings);

  std::unique_ptr<subdivision::KeptParts> Kept;  ///< of other ranks
  subdivision::MatrixFactors* Factors = nullptr; ///< where FindOperator wants the operator
  std::unique_ptr<subdivision::ToldWarnings> Told;
  std::array<double, 9> Counts = {}; ///< ControlCounts
  vtkMTimeType TimeOfCounts = 0;     ///< of their input

  vtkSubdivisionAlgorithm(const vtkSubdivisionAlgorithm&) = delete;
  void operator=(const vtkSubdivisionAlgorithm&) = delete;
};

#endif
