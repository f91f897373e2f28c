// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSimplicialComplexTopology
 * @brief   shows how the subdivision filters understand a mesh
 *
 * Outputs every vertex, edge and triangle of the simplicial complex of a mesh, with facts about it:
 * in which manifolds it lies, whether it is boundary, non-manifold or singular, and which rule the
 * subdivision filters use for it. The filter subdivides nothing and moves no point. It helps to see
 * why a mesh is subdivided as it is.
 *
 * @par Algorithm
 * Y.-S. Chang and H. Qin, "A Framework for Multi-dimensional Adaptive Subdivision Objects",
 * sections 2 and 3. The complex C is made of the cells and all their faces. A cell is maximal if it
 * is a face of no other; C_k is made of the maximal k-simplices and their faces. Links inside each
 * C_k tell the interior, the boundary and non-manifold places; the rules follow from this, from
 * singular simplices and from the options. vtkMultiDimensionalSubdivision runs the same code: with
 * the same options it takes these rules on its first level. If that filter made the mesh, rules and
 * singular simplices belong to its next level.
 *
 * @par Input
 * vtkUnstructuredGrid, vtkPolyData or structured data; cells, bad cells and the cell arrays that
 * are read: see vtkSubdivisionAlgorithm. All its options count. Of an edge that is sharp to a
 * finite degree (array index 4) the rule is that which it has when it has become smooth.
 *
 * @par Output
 * A vtkUnstructuredGrid. Points: all input points with their ids (unused ones too), then centres of
 * split cells. Cells: VTK_VERTEX for each vertex that a cell has, by id; then VTK_LINE for each
 * edge, then VTK_TRIANGLE for each triangle. The vertices of a cell are sorted, and so are the
 * cells (lexicographic). Each simplex is there once, however many cells have it.
 *
 * @par Arrays
 * Point arrays pass through as in the other subdivision filters; centres get means (or the value of
 * the point with the smallest global id). Field data pass through. Cell arrays of the input do not.
 * Cell arrays, all with one component:
 *  - `SimplexDimension` (vtkUnsignedCharArray): 0, 1 or 2.
 *  - `ManifoldDimensions` (vtkUnsignedCharArray): the sum of 1, 2 and 4 for lying in C_1, C_2 and
 *    C_3. 0: an isolated vertex.
 *  - `Boundary` (vtkUnsignedCharArray): 1 if the simplex lies on the boundary of a C_k that is a
 *    manifold there: a vertex with one line; a vertex whose link in a surface is a path, an edge
 *    with one triangle; a vertex whose link in a solid is a disk, an edge whose link there is a
 *    path, a triangle with one tetrahedron. Else 0.
 *  - `NonManifoldType` (vtkUnsignedCharArray): 0 manifold; 1: in more than one C_k; 2: more than
 *    two branches of one C_k meet (a vertex of such an edge too; a triangle with more than two
 *    tetrahedra); 3: boundaries of one C_k touch. The first that holds.
 *  - `Singular` (vtkUnsignedCharArray): 1 if the simplex itself was flagged, or follows from
 *    EmbeddedCells, PreserveInterfaces or DetectFeatures. The faces of a singular simplex are not
 *    singular for that; their RuleDimension tells their rule.
 *  - `Valence` (vtkIntArray): the number of vertices in the link. Vertices: neighbours; edges: the
 *    size of the ring, that is the number of triangles at it. Triangles: number of tetrahedra.
 *  - `RuleDimension` (vtkSignedCharArray): 0 stays, 1 curve, 2 surface, 3 solid, 4 blended;
 *    triangles have no rule: -1.
 *
 * With GenerateOriginalIds also `vtkOriginalCellIds`: the first input cell that the simplex is, or
 * is a piece of; -1 for others.
 *
 * Field arrays (vtkIdTypeArray, one component), of the whole complex whatever is output; where
 * several ranks have partitions of the mesh (Controller), each rank with cells has the numbers of
 * all together:
 *  - `SimplexCounts` (4 values): vertices, edges, triangles, tetrahedra. Unused points and equal
 *    cells do not count.
 *  - `EulerCharacteristic` (1 value): vertices - edges + triangles - tetrahedra.
 *  - `ManifoldComponents` (4 values): connected components of C_0 to C_3. Parts that share a vertex
 *    are connected.
 *
 * @par Complexity
 * Time and memory are linear in the size of the complex, but for sorting around each vertex. Of a
 * mesh that a subdivision filter made, its control mesh is examined and refined.
 *
 * @par Threads and ghosts
 * Threaded by vtkSMPTools, but for counting components; the output is the same, bit for bit, for
 * any back end and any number of threads. Hidden cells take no part. A simplex all of whose cells
 * are duplicates is a duplicate. In a single mesh of a single process only its own simplices count;
 * a warning says so where there are duplicate cells.
 *
 * @par Errors
 * The filter stops, with an error and an empty output, if an array cannot be used, if there are
 * more simplices to output than MaximumNumberOfCells, or if memory runs out. Topology is never an
 * error; an empty input gives an empty output.
 *
 * @sa
 * vtkMultiDimensionalSubdivision
 */
#ifndef vtkSimplicialComplexTopology_h
#define vtkSimplicialComplexTopology_h

#include "vtkMarkedSubdivisionAlgorithm.h"
#include "vtkSubdivisionObjectsModule.h" // for export macro

class VTKSUBDIVISIONOBJECTS_EXPORT vtkSimplicialComplexTopology
  : public vtkMarkedSubdivisionAlgorithm
{
public:
  static vtkSimplicialComplexTopology* New();
  vtkTypeMacro(vtkSimplicialComplexTopology, vtkMarkedSubdivisionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The output.
  vtkUnstructuredGrid* GetOutput() { return this->GetUnstructuredGridOutput(); }

  ///@{
  /**
   * Whether only special simplices are output: that are non-manifold, on a boundary or singular,
   * and vertices and edges whose rule for another reason differs from the rule of the manifold that
   * they are inside of (the edges of a singular triangle, the end of a crease). A simplex that is
   * left out lies inside one C_k and follows the rule of dimension k, isolated vertices included.
   * Off by default.
   */
  vtkSetMacro(SpecialOnly, bool);
  vtkGetMacro(SpecialOnly, bool);
  vtkBooleanMacro(SpecialOnly, bool);
  ///@}

protected:
  vtkSimplicialComplexTopology();
  ~vtkSimplicialComplexTopology() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool SpecialOnly = false;

private:
  vtkSimplicialComplexTopology(const vtkSimplicialComplexTopology&) = delete;
  void operator=(const vtkSimplicialComplexTopology&) = delete;
};

#endif
