// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedNodes.h
 * Nodes of curved cells that are no points of a level: where they are, and which cells have them.
 */
#ifndef SubdivisionObjects_CurvedNodes_h
#define SubdivisionObjects_CurvedNodes_h

#include "Core/Operators/VertexRow.h"
#include "Private/Curved/CurvedShapes.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace subdivision
{

/// The curved cells of a mesh of linear cells. Their nodes are points of another mesh, with arrays.
struct CurvedNodes
{
  std::vector<const CurvedShape*> Shapes; ///< of each cell
  std::vector<vtkIdType> Starts;          ///< of its nodes, and one more
  std::vector<vtkIdType> Nodes;
  vtkSmartPointer<vtkPointSet> Points;
};

/// Places in cells of a mesh, by the parameters of VTK.
struct NodePlaces
{
  vtkNew<vtkIdTypeArray> Cells;
  vtkNew<vtkDoubleArray> Parameters;
};

/**
 * Lists the nodes of curved cells with the corners of the cells of a mesh, which are the places of
 * an order. Cells that share corners share the nodes between these, and the place of a node is in
 * the first cell that has it. So each node is one place, whichever cell asks. Returns false after
 * an error.
 */
bool ListNodes(vtkPointSet* mesh, CurvedKind kind, int order,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes, NodePlaces& places);

/// The same for the orders 1, 2 and 4 of simplices: nodes are points of the mesh, which has
/// `points`, or after these the middles of two earlier ones each, in the order of their ends. Cells
/// that share corners ask for the same middles.
bool ListMiddles(vtkPointSet* mesh, CurvedKind kind, int order, vtkIdType points,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes,
  std::vector<std::array<vtkIdType, 2>>& middles);

/// The same for all orders, where nodes after the points are means of some, in the order of these.
bool ListMeans(vtkPointSet* mesh, CurvedKind kind, int order, vtkIdType points,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes,
  std::vector<WeightedVertices>& means);

/// Inserts into the first `size` vertices, which ascend.
inline void Insert(
  const std::pair<vtkIdType, int>& vertex, std::size_t size, WeightedVertices& vertices)
{
  for (; size > 0 && vertex.first < vertices[size - 1].first; --size)
  {
    vertices[size] = vertices[size - 1];
  }
  vertices[size] = vertex;
}

/// Gives a mesh such cells in the place of its own, one for each.
void SetCells(const CurvedNodes& nodes, vtkUnstructuredGrid* mesh);

/// Keeps nodes for MakeCurvedCells, which comes after cells were left out or given to blocks: a
/// cell array of the mesh says which cell each of them was.
void KeepNodes(CurvedNodes&& nodes, vtkPointSet* mesh, std::vector<CurvedNodes>& kept);

/// That array: the number of the nodes among the kept ones, and the cell.
constexpr const char* CurvedCellName = "SubdivisionCurvedCell";

/// The weights of the corners of a straight cell at a node.
std::array<double, 8> GetStraightWeights(const CurvedShape& shape, const FrameNode& node);

}

#endif
