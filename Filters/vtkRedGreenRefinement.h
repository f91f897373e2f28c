// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRedGreenRefinement
 * @brief   splits the cells of a mesh where detail is needed, and nowhere else
 *
 * The output is conforming: no hanging node and no T-junction, inside objects of any dimension and
 * between them.
 *
 * @par Algorithm
 * Y.-S. Chang and H. Qin, "A Framework for Multi-dimensional Adaptive Subdivision Objects", section
 * 4.2. In each round edges are marked by the criteria below, and the marks are closed: a triangle
 * with two marked edges marks its third, so that a tetrahedron has no, one, two opposite, the three
 * edges of one face, or all edges marked. Cells with all edges marked are split like by uniform
 * subdivision (red: a line into 2, a triangle into 4, a tetrahedron into 8), the others so that
 * they fit (green: a triangle into 2, a tetrahedron into 2 or 4). Before the next round all green
 * cells are undone, so that only red cells are ever refined: shapes do not get worse with the
 * number of rounds. The rounds end when no criterion marks anything, or at a limit.
 *
 * @par Criteria
 * The criteria of vtkRefinementAlgorithm, with its arrays (5 to 7). The arrays of
 * vtkSubdivisionAlgorithm (0 to 4) are used where Placement is LIMIT or a criterion asks for the
 * limit. RefineByGeometricError measures on edges of input cells the distance of the limit from the
 * edge, inside an input triangle its distance from the triangles there. A level is one halving of
 * edges, and the array `RefinementLevel` of the output has the level of each cell; filters in a row
 * halve an edge up to 255 times in all.
 *
 * @par Output
 * Points: the points of the input with their ids, then centres of split cells, then the new ones.
 * Cells: in the order of the input, children in the place of their parent and oriented like it.
 * Cells that are no simplices are split first, see vtkSubdivisionAlgorithm. Point arrays get values
 * at new points (by their type, as in vtkMultiDimensionalSubdivision), children take the cell
 * arrays of their cell (ghost types too), field arrays pass through. The filter adds the cell
 * arrays
 *  - `RefinementLevel` (unsigned char): how often the edges of an input cell were halved; a green
 *    cell has the level of the cell that it is a part of,
 *  - `RefinementKind` (unsigned char): 0 the cell as it was read, 1 red, 2 green by one edge, 3
 *    green by two opposite edges, 4 green by the three edges of a face,
 *  - `GreenParent` (vtkIdTypeArray): the tuple of `RedGreenLeaves` that a green cell is a part of,
 *    -1 for others,
 *  - `vtkOriginalCellIds` (vtkIdTypeArray): the cell of the input; if another filter of this kind
 *    made the input, the cell of its input, and levels and kinds count on from there,
 *
 * and the field arrays `RedGreenLeaves` (vtkIdTypeArray, ten components: the points of a cell that
 * was split green, and the points on its edges 01, 02, 03, 12, 13, 23; -1 for none) and
 * `Subdivision` (the stamp by which the next filter recognises this output).
 *
 * @par Filters in a row
 * A red-green filter that reads the output of another one replaces its green cells by the cells of
 * which they are parts, and refines these; MaximumLevel counts from there. It leaves green cells as
 * they are if cells were changed in between, if cell arrays have different values in the green
 * parts of one cell (a warning says so), and if Placement or a criterion asks for the limit, which
 * does not exist for a mesh with points inside edges.
 *
 * @par Complexity
 * Time and memory are linear in the size of the input and the output; a round costs in proportion
 * to the cells that it changes and, where the limit is asked for, to the cells around these on all
 * levels before.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools; the output is the same, bit for bit, for any number of threads. Ghost
 * types of cells go to the children. The partitions of several ranks (Controller) are refined as
 * one mesh, whatever their borders: cells, points and arrays are the same as one rank makes of the
 * whole, and a next filter on several ranks goes on from there. But at MaximumNumberOfCells, which
 * counts the cells of all ranks together, the last round leaves out all places below one error, and
 * so more of them. `GreenParent` and `RedGreenLeaves` count in each block by itself. Ranks exchange
 * split edges in each round, mostly two to four times, and number new points afterwards, in two
 * exchanges for each level.
 *
 * @par Errors
 * See vtkRefinementAlgorithm.
 *
 * @sa
 * vtkMultiDimensionalSubdivision vtkAdaptiveSurfaceSubdivision
 */
#ifndef vtkRedGreenRefinement_h
#define vtkRedGreenRefinement_h

#include "vtkRefinementAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class VTKSUBDIVISIONOBJECTS_EXPORT vtkRedGreenRefinement : public vtkRefinementAlgorithm
{
public:
  static vtkRedGreenRefinement* New();
  vtkTypeMacro(vtkRedGreenRefinement, vtkRefinementAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkUnstructuredGrid* GetOutput() { return this->GetUnstructuredGridOutput(); }

  enum Placements
  {
    LINEAR,
    LIMIT
  };
  ///@{
  /**
   * The place of points, and their values: LINEAR (0, the default): new ones in the middle of their
   * edge, the others stay: the shape does not change. LIMIT (1): all of them on the limit of smooth
   * subdivision, with all options of vtkSubdivisionAlgorithm, exact to rounding: where levels 0 to
   * infinity of vtkMultiDimensionalSubdivision end, with InterpolatePoints and InterpolateArrays at
   * the points and values of the input. The green cells of an earlier filter stay as they are then.
   */
  vtkSetClampMacro(Placement, int, LINEAR, LIMIT);
  vtkGetMacro(Placement, int);
  void SetPlacementToLinear() { this->SetPlacement(LINEAR); }
  void SetPlacementToLimit() { this->SetPlacement(LIMIT); }
  ///@}

  ///@{
  /**
   * Which limit solids have, where Placement is LIMIT or a criterion asks for it: BOX_SPLINE (0,
   * the default) or TET_OCT (1), see vtkMultiDimensionalSubdivision. Cells are tetrahedra with
   * either. The scheme's octahedra are the four tetrahedra around a diagonal that refinement makes
   * in the middle of another, or that an earlier filter has cut them into: the middle of this
   * diagonal is the centre of the octahedron.
   */
  vtkSetClampMacro(VolumeScheme, int, BOX_SPLINE, TET_OCT);
  vtkGetMacro(VolumeScheme, int);
  void SetVolumeSchemeToBoxSpline() { this->SetVolumeScheme(BOX_SPLINE); }
  void SetVolumeSchemeToTetOct() { this->SetVolumeScheme(TET_OCT); }
  ///@}

  ///@{
  /**
   * Whether to output the point array `LimitNormals` (3 components, of the type of the points), the
   * active normals of the output: unit normals of the limit surface, where Placement is LIMIT. They
   * follow the rules of vtkMultiDimensionalSubdivision, also where there is no tangent plane;
   * triangles there are taken from the level on which the point first exists. With Placement =
   * LINEAR there are none, and a warning says so. Off by default.
   */
  vtkSetMacro(GenerateLimitNormals, bool);
  vtkGetMacro(GenerateLimitNormals, bool);
  vtkBooleanMacro(GenerateLimitNormals, bool);
  ///@}

  enum OutputCellTypes
  {
    LINEAR_CELLS,
    QUADRATIC_CELLS,
    LAGRANGE_CELLS
  };
  ///@{
  /**
   * Which cells the output has: LINEAR_CELLS (0, the default), or curved ones for solvers,
   * QUADRATIC_CELLS (1) and LAGRANGE_CELLS (2) of CellOrder, with the nodes, the proof and the
   * repair of vtkUniformSubdivisionAlgorithm: each cell of the refined mesh becomes one, green ones
   * too, and cells that share an edge or face share its nodes. With Placement = LIMIT nodes and
   * their values are on the limit, at places that divide cells evenly by parameters; with LINEAR
   * cells are straight. The next filter reads their corners like any other mesh.
   */
  vtkSetClampMacro(OutputCells, int, LINEAR_CELLS, LAGRANGE_CELLS);
  vtkGetMacro(OutputCells, int);
  void SetOutputCellsToLinear() { this->SetOutputCells(LINEAR_CELLS); }
  void SetOutputCellsToQuadratic() { this->SetOutputCells(QUADRATIC_CELLS); }
  void SetOutputCellsToLagrange() { this->SetOutputCells(LAGRANGE_CELLS); }
  ///@}

  ///@{
  /**
   * The order of LAGRANGE_CELLS, 1 to 6; default 2. Nodes of 3, 5 and 6 on the limit take longer,
   * as they are no vertices of a level, and have no normals, as a warning says.
   */
  vtkSetClampMacro(CellOrder, int, 1, 6);
  vtkGetMacro(CellOrder, int);
  ///@}

protected:
  vtkRedGreenRefinement();
  ~vtkRedGreenRefinement() override;

  bool CanInterpolate() const override { return this->Placement == LIMIT; }
  bool HasInterfaces() const override { return true; }
  bool TearsSeams() const override
  {
    return this->OutputCells == LINEAR_CELLS && this->InterfaceValues == CONTINUOUS_VALUES &&
      !this->CloseHangingNodes;
  }
  int GetLayersOfCells() const override { return this->VolumeScheme == TET_OCT ? 3 : 2; }
  bool HasGhostLayers() const override { return this->OutputCells == LINEAR_CELLS; }
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  vtkSmartPointer<vtkDataObject> Finish(vtkDataObject* made) override;

  int Placement = LINEAR;
  int VolumeScheme = BOX_SPLINE;
  bool GenerateLimitNormals = false;
  int OutputCells = LINEAR_CELLS;
  int CellOrder = 2;

private:
  vtkRedGreenRefinement(const vtkRedGreenRefinement&) = delete;
  void operator=(const vtkRedGreenRefinement&) = delete;
};

#endif
