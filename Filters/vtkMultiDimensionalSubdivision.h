// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMultiDimensionalSubdivision
 * @brief   smooth subdivision of curves, surfaces and solids in one mesh
 *
 * Subdivides a mesh of cells of any dimension uniformly and smoothly: curves become cubic
 * B-splines, triangles Loop surfaces, quads Catmull-Clark surfaces, solids become smooth inside,
 * each with smooth boundaries, and where objects of different dimension meet they are blended into
 * each other. A mesh with hexahedra, wedges, pyramids or quads keeps its types of cells; others,
 * and what VolumeScheme cuts, become vertices, lines, triangles and tetrahedra (see
 * vtkSubdivisionAlgorithm).
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
 * @par Cells that keep their type
 * VolumeScheme = HYBRID cuts nothing: a hexahedron or wedge becomes 8 of its type, a quad 4, a
 * pyramid 4 pyramids, 4 tetrahedra and an octahedron, a tetrahedron 4 tetrahedra and an octahedron
 * (in the output four tetrahedra with a common `OctahedronId`). Then points move to weighted means
 * of the cells around them, each inside its own stratum: hexahedra in a lattice become tricubic
 * B-splines, wedges Loop surfaces times a cubic B-spline, surfaces of quads Catmull-Clark surfaces;
 * tetrahedra, triangles and lines are as with TET_OCT. Boundaries, creases, features, interfaces
 * and joints are those of the other schemes. Cells with repeated points are the cells that they
 * are: a hexahedron with a collapsed side is a pyramid or wedge, a quad with a collapsed edge a
 * triangle. Polyhedra, prisms of five and six sides and other closed rests of collapsed cells get a
 * point in their middle, the mean of their corners, and become a pyramid on each quad and a
 * tetrahedron on each triangle, and larger sides are cut into triangles; a warning counts them.
 * Polygons are cut into triangles. Where a quad lies against two triangles, the cell with the quad
 * gives way, and no other, so that nothing hangs: a pyramid becomes two tetrahedra, a hexahedron or
 * wedge tetrahedra and pyramids around its middle, a quad two triangles. A warning counts these,
 * too. Non-linear cells are read as QuadraticCells says, voxels and pixels as hexahedra and quads,
 * and octahedra that TET_OCT or HYBRID wrote as octahedra. Limits and classification are those of
 * the last level, which takes memory as one level more would; so are normals where solids touch
 * other cells, or blend. Filters in a row equal one filter, unless the mesh is in blocks or on
 * several ranks, or the second one marks more, selects cells, or finds other values of an array
 * that chooses rules in some children of a cell: then its input is a new control mesh. A concave
 * angle of a corner has no flatness in sectors of quads (CornerAngleArray).
 *
 * @par Arrays
 * Floating point arrays, of any number of components, are smoothed like the points; so are colours
 * (unsigned char, 3 or 4 components), rounded after every level. Other integer, string and bit
 * point arrays keep their values at old points; a new point takes the value of the end of its edge,
 * or of the vertex of its octahedron, whose global id is smallest. Children take the cell arrays of
 * their cell, and its pedigree id. Global ids, and pedigree ids of points, are kept where no cell
 * or point is new; see GenerateOriginalIds. Field data pass through. Names, component names,
 * information keys, lookup tables and active attributes are kept, in each block its own. The filter
 * adds, with VolumeScheme = TET_OCT, the cell array `OctahedronId`; on request,
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
 * Three filters of one level give the output of one filter of three levels, bit for bit, in every
 * array, on several ranks too. Only the last of them may have ProjectToLimit on, or leave out cells
 * by OutputDimensions.
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

#include "vtkSubdivisionObjectsModule.h" // for export macro
#include "vtkUniformSubdivisionAlgorithm.h"

#include <utility> // for std::pair

class VTKSUBDIVISIONOBJECTS_EXPORT vtkMultiDimensionalSubdivision
  : public vtkUniformSubdivisionAlgorithm
{
public:
  static vtkMultiDimensionalSubdivision* New();
  vtkTypeMacro(vtkMultiDimensionalSubdivision, vtkUniformSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkUnstructuredGrid* GetOutput() { return this->GetUnstructuredGridOutput(); }

  ///@{
  /**
   * How solids are split and smoothed inside: BOX_SPLINE (0; into tetrahedra, smoothest in the
   * interior of the control tetrahedra, with a direction preferred in each), TET_OCT (1; into
   * tetrahedra and octahedra without any preferred direction, see "Tet/oct scheme" above), LINEAR
   * (2; the cells of BOX_SPLINE, not smoothed: points and values of all dimensions stay, new ones
   * are midpoints, and each level is its own limit), HYBRID (3; every cell keeps its type, see
   * "Cells that keep their type" above) or AUTOMATIC (4, the default; HYBRID for a mesh with
   * hexahedra, voxels, wedges, pyramids, quads or pixels, else BOX_SPLINE). Where HYBRID has an
   * option or a cell not yet, AUTOMATIC takes BOX_SPLINE, too, with a warning that says which one
   * decided; with JoinBlocks off each block has its own scheme. Curves, surfaces, boundaries,
   * creases and joints are the same in the first two, and in HYBRID where no cell would be cut.
   */
  vtkSetClampMacro(VolumeScheme, int, BOX_SPLINE, AUTOMATIC);
  vtkGetMacro(VolumeScheme, int);
  void SetVolumeSchemeToBoxSpline() { this->SetVolumeScheme(BOX_SPLINE); }
  void SetVolumeSchemeToTetOct() { this->SetVolumeScheme(TET_OCT); }
  void SetVolumeSchemeToLinear() { this->SetVolumeScheme(LINEAR); }
  void SetVolumeSchemeToHybrid() { this->SetVolumeScheme(HYBRID); }
  void SetVolumeSchemeToAutomatic() { this->SetVolumeScheme(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Whether VolumeScheme = LINEAR refines hexahedra, wedges, pyramids and quads as such, with the
   * cells of HYBRID, which are not smoothed here. New points are the means of the corners of edges,
   * quads, hexahedra and octahedra; so cells that fit together fit after any level, and keep their
   * volume together. Options on rules and limits mean nothing then; of GenerateClassification,
   * GenerateLimitNormals and GenerateTangents a warning says so. Cells are read as with HYBRID, and
   * the output has no stamp: filters in a row refine the mesh that they read, and give the same
   * points as one filter, but maybe pieces of octahedra in another order. Off by default; without
   * LINEAR it is ignored with a warning.
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
   * rules; cells of other dimensions, and the points that only they use, are left out at the end.
   * Volume rendering needs TETRAHEDRA alone. Ids of GenerateGlobalIds are the same as in the output
   * with all dimensions. A filter cannot go on with a part of the cells: if this is not
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

  /**
   * Evaluates the limit at places of cells of the present input, which is updated, by the present
   * rules; NumberOfLevels does not matter. Place i is in cell cells[i], a vertex, line, triangle or
   * tetrahedron, at parameters[i] (3 components, of which a cell of dimension d reads d): the
   * second point of the cell has the weight u, the third v, the fourth w, and the first 1 - u - v -
   * w; no weight is negative. In an output of TET_OCT it may be a piece of an octahedron. By HYBRID
   * it may also be a quad, pyramid, wedge or hexahedron that the filter does not cut, with the
   * parameters that VTK has there. Cells that the filter cuts, by the other schemes also these,
   * have no places; vtkSurfaceSubdivision has places in polygons.
   *
   * `result` has a point and a vertex for each place, in double, with all smoothed arrays there (an
   * array that is not smoothed has the value of the nearest corner), and the arrays DerivativeU,
   * DerivativeV and DerivativeW of the points by the parameters. On surfaces LimitNormals,
   * MeanCurvature and GaussianCurvature follow from the derivatives, with the normal as the points
   * of the cell turn; on curves MeanCurvature has the curvature of the curve. All others are 0.
   *
   * Values are exact but for rounding, 1e-12 of the size of the mesh and less. So are derivatives
   * of curves and surfaces, beside joints, creases and semi-sharp ones, too: down to 2^-48 of a
   * cell from an irregular vertex their error is at most 1e-12 of the weights of the largest
   * derivative there. These weights change as (2 lambda)^k at 2^-k of a cell, with the second
   * eigenvalue lambda of the vertex: with three to five triangles derivatives tend to 0, with seven
   * and more to infinity. Second derivatives are as exact, and their weights change as (4
   * lambda)^k; beside semi-sharp creases their error is larger by 2^(k - 54) of these weights.
   * Curvatures use the part across the surface only, which is smaller by (mu / lambda)^k, with the
   * third eigenvalue mu, so as many digits are lost. At irregular vertices curvatures are 0.
   *
   * In solids derivatives are as exact wherever they exist: inside of cells, on faces and on
   * boundaries, where they are taken from the side of the cell, and beside joints. The limit has no
   * derivatives by these parameters AT edges and vertices that are not regular (by TET_OCT all of
   * the control mesh) and, by BOX_SPLINE, at faces whose two tetrahedra are not cut in the same
   * way; so there are none in lines and triangles inside of solids that go along these and are not
   * singular. There the arrays have the slope over a part of 2^-52 of the cell. By TET_OCT, and by
   * BOX_SPLINE very near to such faces, the limit is taken as linear over a part of this size, so
   * that 2^-k of a cell from an irregular vertex or edge the error is 2^(k - 50) more.
   *
   * By HYBRID the part that is taken as linear is 2^-44 of a cell, in solids of all types, also
   * inside of regular ones, and in cells of dimension 1 and 2 beside what is not regular: there
   * second derivatives are 0, and the error is 2^(k - 42) of the weights of the largest derivative.
   *
   * AT an extraordinary vertex of a surface the limit has no derivatives by these parameters
   * either. There the arrays have the slope over a part of 2^-52 of the cell. Its length means
   * nothing, and its direction comes near the tangent plane only (the normal is wrong by 1e-12 with
   * seven triangles, by 1e-5 with twelve, by 1e-9 with four). GenerateLimitNormals has exact
   * normals there, and vtkSurfaceSubdivision::EvaluateLimit exact tangent planes. Returns false
   * after an error.
   */
  bool EvaluateLimit(vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result);

protected:
  vtkMultiDimensionalSubdivision();
  ~vtkMultiDimensionalSubdivision() override;

  bool HasInterfaces() const override { return true; }
  bool TearsSeams() const override
  {
    return this->OutputCells == LINEAR_CELLS && !this->GenerateErrorBounds && !this->Places &&
      this->InterfaceValues == CONTINUOUS_VALUES && !this->CloseHangingNodes;
  }
  /// Tet/oct limits need a third layer, because octahedra reach one edge farther.
  int GetLayersOfCells() const override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made) override;
  const char* DescribeBezierNeeds() const override;
  /// For filters that write something else than a mesh: makes a level of straight cells in double
  /// precision, with all points on the limit and OriginalCellIds, and calls Finish with it; -1: the
  /// cells of the control mesh. The first of an update has `isFirst`, so that none repeats the
  /// warnings of those before. It is `part` of the work. With an operator it is found instead.
  /// Returns false after an error.
  bool MakeLevelAside(int level, bool isFirst, const std::pair<double, double>& part,
    vtkInformationVector** inputVector, vtkSubdivisionOperator* found = nullptr);
  /// Whether the user has stopped this rank or another one: what MakeLevelAside made is empty then,
  /// and the next level may be whole. All ranks have to ask.
  bool IsStopped();
  const char* DescribeCurvedNeeds() const override;

  int VolumeScheme = AUTOMATIC;
  bool KeepCellTypes = false;
  bool GenerateClassification = false;
  int OutputDimensions = ALL_DIMENSIONS;

private:
  double NumberOfRunsAside = 0.; ///< since the filter was made

  vtkMultiDimensionalSubdivision(const vtkMultiDimensionalSubdivision&) = delete;
  void operator=(const vtkMultiDimensionalSubdivision&) = delete;
};

#endif
