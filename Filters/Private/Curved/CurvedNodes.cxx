// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CurvedNodes.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/PairTable.h"
#include "Core/Memory/Sorting.h"
#include "Core/Operators/VertexRow.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

/// A node by the corners of the face or edge on which it lies, and their weights. One inside of a
/// cell with more corners has the cell and its number there.
struct NodeName
{
  WeightedVertices Corners;

  bool operator==(const NodeName& other) const { return this->Corners == other.Corners; }
  std::uint64_t GetHash() const
  {
    std::uint64_t hash = 0;
    for (const auto& [corner, weight] : this->Corners)
    {
      hash = (hash ^ static_cast<std::uint64_t>(corner)) * 0x9e3779b97f4a7c15u;
      hash = (hash ^ hash >> 32 ^ static_cast<std::uint64_t>(weight)) * 0xd6e8feb86659fd93u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// `weights`: of the corners of the cell with these points, in parts of one.
NodeName NameNode(const CurvedShape& shape, const std::array<double, 8>& weights,
  const vtkIdType* points, vtkIdType cell, int number)
{
  constexpr vtkIdType none = -1;
  NodeName name;
  name.Corners.fill({ none, 0 });
  const double parts = std::pow(static_cast<double>(shape.Order), 3);
  std::size_t size = 0;
  for (int k = 0; k < GetCellTable(shape.Shape).Corners; ++k)
  {
    const auto weight = static_cast<int>(std::lround(parts * weights[k]));
    if (weight > 0 && size == name.Corners.size())
    {
      name.Corners.fill({ none - 1 - cell, number });
      return name;
    }
    if (weight > 0)
    {
      Insert({ points[k], weight }, size++, name.Corners);
    }
  }
  return name;
}

/// Adds the curved cells with the corners of cells: add(cell, shape, corners) adds their nodes.
/// Returns false after an error.
template <typename Add>
bool AddCells(vtkPointSet* mesh, CurvedKind kind, int order,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes, const Add& add)
{
  const CellReader cells(mesh);
  std::vector<vtkIdType> scratch;
  nodes.Starts.push_back(0);
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    const int type = cells.GetGridType(c, cell.Size);
    const auto* found = std::find(TypesOfShapes.begin(), TypesOfShapes.end(), type);
    const CurvedShape* shape = found == TypesOfShapes.end()
      ? nullptr
      : CurvedShape::Get(static_cast<CellShape>(found - TypesOfShapes.begin()), kind, order);
    if (!shape)
    {
      fail("Cell " + std::to_string(c) + " of type " + std::to_string(type) +
        " has no curved cell of order " + std::to_string(order) +
        " in VTK. Set OutputCells to Quadratic, which has pyramids; polygons need a level more.");
      return false;
    }
    add(c, *shape, cell.Ids);
    nodes.Shapes.push_back(shape);
    nodes.Starts.push_back(static_cast<vtkIdType>(nodes.Nodes.size()));
  }
  return true;
}

/// A node of a simplex by the weights of its corners, whose sum is the order, 2 or 4: a corner, or
/// the middle of two others, find(a, b). Where two weights are odd it is in the middle of their
/// edge of the finest lattice; so it is the same for all simplices that have these corners.
template <typename Find>
vtkIdType FindMiddle(
  const std::array<int, 4>& weights, int order, const vtkIdType* corners, const Find& find)
{
  const auto corner = std::find(weights.begin(), weights.end(), order);
  if (corner != weights.end())
  {
    return corners[corner - weights.begin()];
  }
  const bool hasOdd = std::any_of(weights.begin(), weights.end(), [](int w) { return w % 2 != 0; });
  std::array<int, 4> ends[2] = { weights, weights };
  int sign = 1;
  for (std::size_t k = 0; k < 4; ++k)
  {
    if (hasOdd ? weights[k] % 2 != 0 : weights[k] != 0)
    {
      ends[0][k] += sign * (hasOdd ? 1 : 2);
      ends[1][k] -= sign * (hasOdd ? 1 : 2);
      sign = -sign;
    }
  }
  const vtkIdType first = FindMiddle(ends[0], order, corners, find);
  return find(first, FindMiddle(ends[1], order, corners, find));
}

/// Numbers middles in the order of their ends, those of `points` first.
void SortMiddles(
  vtkIdType points, std::vector<vtkIdType>& nodes, std::vector<std::array<vtkIdType, 2>>& middles)
{
  std::vector<vtkIdType> order(middles.size());
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::vector<vtkIdType> numbers(middles.size());
  std::vector<std::array<vtkIdType, 2>> sorted;
  const auto second = std::stable_partition(order.begin(), order.end(),
    [&](vtkIdType i) { return middles[i][0] < points && middles[i][1] < points; });
  const auto renumber = [&](vtkIdType& node)
  { node = node < points ? node : points + numbers[node - points]; };
  for (auto begin = order.begin(); begin != order.end();)
  {
    const auto end = begin == order.begin() && begin != second ? second : order.end();
    std::vector<std::array<vtkIdType, 3>> keys; // of a middle, its ends, and its number until now
    for (const vtkIdType i : ItemsInTurn<decltype(begin)>(begin, end))
    {
      renumber(middles[i][0]);
      renumber(middles[i][1]);
      const auto [least, most] = std::minmax(middles[i][0], middles[i][1]);
      keys.push_back({ { least, most, i } });
    }
    StableSort(keys, std::less<>());
    for (const auto& key : InTurn(keys))
    {
      numbers[key[2]] = static_cast<vtkIdType>(sorted.size());
      sorted.push_back({ { key[0], key[1] } });
    }
    begin = end;
  }
  middles = std::move(sorted);
  for (vtkIdType& node : InTurn(nodes))
  {
    renumber(node);
  }
}

}

std::array<double, 8> GetStraightWeights(const CurvedShape& shape, const FrameNode& node)
{
  double x = static_cast<double>(node[0]) / shape.Order;
  double y = static_cast<double>(node[1]) / shape.Order;
  const double z = static_cast<double>(node[2]) / shape.Order;
  if (shape.Shape == CellShape::Wedge)
  {
    const double first = 1. - x - y;
    return { { first * (1. - z), x * (1. - z), y * (1. - z), first * z, x * z, y * z } };
  }
  const int dimension = GetCellTable(shape.Shape).Dimension;
  if (GetCellTable(shape.Shape).Corners == dimension + 1)
  {
    return { { 1. - x - y - z, x, y, z } };
  }
  const bool isPyramid = shape.Shape == CellShape::Pyramid;
  const double size = isPyramid && z < 1. ? 1. - z : 1.;
  x /= size;
  y /= size;
  const double square[4] = { (1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y };
  std::array<double, 8> weights{};
  for (int k = 0; k < 4; ++k)
  {
    weights[k] = square[k] * (1. - z);
    weights[k + 4] = !isPyramid ? square[k] * z : k == 0 ? z : 0.;
  }
  return weights;
}

bool ListNodes(vtkPointSet* mesh, CurvedKind kind, int order,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes, NodePlaces& places)
{
  VertexNumbers<NodeName> names;
  places.Parameters->SetNumberOfComponents(3);
  const auto add = [&](vtkIdType c, const CurvedShape& shape, const vtkIdType* points)
  {
    const double* at = shape.Cell->GetParametricCoords();
    for (int n = 0; n < shape.GetNumberOfNodes(); ++n, at += 3)
    {
      const NodeName name =
        NameNode(shape, GetStraightWeights(shape, shape.Nodes[n]), points, c, n);
      const auto number = static_cast<vtkIdType>(names.GetNumber(name));
      nodes.Nodes.push_back(number);
      if (number == places.Cells->GetNumberOfTuples())
      {
        places.Cells->InsertNextValue(c);
        places.Parameters->InsertNextTuple(at);
      }
    }
  };
  return AddCells(mesh, kind, order, fail, nodes, add);
}

bool ListMiddles(vtkPointSet* mesh, CurvedKind kind, int order, vtkIdType points,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes,
  std::vector<std::array<vtkIdType, 2>>& middles)
{
  PairTable<vtkIdType> table;
  const auto add = [&](vtkIdType, const CurvedShape& shape, const vtkIdType* corners)
  {
    for (const FrameNode& node : shape.Nodes)
    {
      nodes.Nodes.push_back(FindMiddle(
        { { order - node[0] - node[1] - node[2], node[0], node[1], node[2] } }, order, corners,
        [&](vtkIdType a, vtkIdType b)
        {
          const auto next = points + static_cast<vtkIdType>(middles.size());
          const vtkIdType found = table.FindOrAdd(a, b, next);
          found == next ? middles.push_back({ { a, b } }) : void();
          return found;
        }));
    }
  };
  const bool isDone = AddCells(mesh, kind, order, fail, nodes, add);
  SortMiddles(points, nodes.Nodes, middles);
  return isDone;
}

bool ListMeans(vtkPointSet* mesh, CurvedKind kind, int order, vtkIdType points,
  const std::function<void(const std::string&)>& fail, CurvedNodes& nodes,
  std::vector<WeightedVertices>& means)
{
  VertexNumbers<NodeName> names;
  const auto add = [&](vtkIdType c, const CurvedShape& shape, const vtkIdType* corners)
  {
    for (int n = 0; n < shape.GetNumberOfNodes(); ++n)
    {
      const NodeName name =
        NameNode(shape, GetStraightWeights(shape, shape.Nodes[n]), corners, c, n);
      nodes.Nodes.push_back(name.Corners[1].first < 0
          ? name.Corners[0].first
          : points + static_cast<vtkIdType>(names.GetNumber(name)));
    }
  };
  const bool isDone = AddCells(mesh, kind, order, fail, nodes, add);
  std::vector<std::pair<WeightedVertices, vtkIdType>> sorted;
  for (const NodeName& name : InTurn(names.Vertices))
  {
    sorted.emplace_back(name.Corners, static_cast<vtkIdType>(sorted.size()));
  }
  StableSort(sorted, std::less<>());
  std::vector<vtkIdType> numbers(sorted.size());
  for (const auto& [name, number] : InTurn(sorted))
  {
    numbers[number] = static_cast<vtkIdType>(means.size());
    means.push_back(name);
  }
  for (vtkIdType& node : InTurn(nodes.Nodes))
  {
    node = node < points ? node : points + numbers[node - points];
  }
  return isDone;
}

void SetCells(const CurvedNodes& nodes, vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  Allocate(types, 1, static_cast<vtkIdType>(nodes.Shapes.size()));
  Allocate(offsets, 1, static_cast<vtkIdType>(nodes.Starts.size()));
  Allocate(ids, 1, static_cast<vtkIdType>(nodes.Nodes.size()));
  std::transform(nodes.Shapes.begin(), nodes.Shapes.end(), types->GetPointer(0),
    [](const CurvedShape* shape) { return static_cast<unsigned char>(shape->CellType); });
  std::copy(nodes.Starts.begin(), nodes.Starts.end(), offsets->GetPointer(0));
  std::copy(nodes.Nodes.begin(), nodes.Nodes.end(), ids->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  mesh->SetCells(types, cells);
}

void KeepNodes(CurvedNodes&& nodes, vtkPointSet* mesh, std::vector<CurvedNodes>& kept)
{
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName(CurvedCellName);
  cells->SetNumberOfComponents(2);
  cells->SetNumberOfTuples(mesh->GetNumberOfCells());
  const auto number = static_cast<vtkIdType>(kept.size());
  for (const vtkIdType c : InTurn(mesh->GetNumberOfCells()))
  {
    cells->SetTypedComponent(c, 0, number);
    cells->SetTypedComponent(c, 1, c);
  }
  mesh->GetCellData()->AddArray(cells);
  kept.push_back(std::move(nodes));
}

}
