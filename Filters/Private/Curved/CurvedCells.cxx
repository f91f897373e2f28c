// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CurvedCells.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/TetOct/TetOctCells.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Curved/CurvedMesh.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Roots/SplitRoots.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <deque>

namespace subdivision
{
namespace
{

/// Gathers all arrays but some.
void GatherData(vtkDataSetAttributes* from, const std::vector<vtkIdType>& sources,
  const std::vector<std::string>& left, vtkDataSetAttributes* to)
{
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    const bool isLeft =
      array->GetName() && std::find(left.begin(), left.end(), array->GetName()) != left.end();
    if (!isLeft)
    {
      const auto gathered = Gather(array, { sources.data(), sources.data() + sources.size() });
      CopyLooks(array, gathered);
      AddLike(from, a, gathered, to);
    }
  }
}

class CurvedWriter
{
public:
  CurvedWriter(vtkPointSet* mesh, unsigned int block, const CurvedOptions& options)
    : From(mesh)
    , Options(options)
    , PointsFrom(mesh)
  {
    this->Part.Block = block;
  }
  vtkSmartPointer<vtkUnstructuredGrid> Write()
  {
    if (this->From->GetPoints() &&
      (this->Options.Kept         ? this->TakeKept()
          : this->Options.AreMade ? this->TakeMade()
                                  : this->FindRoots()))
    {
      this->WritePoints();
      this->WriteCells();
      this->Part.Points = this->Output->GetPoints()->GetData();
    }
    return this->Output;
  }
  /// The part to be proved, with points if there is one.
  CurvedPart& GetPart() { return this->Part; }
  void WriteProof()
  {
    if (this->Part.Points != this->Output->GetPoints()->GetData()) // which the level has, too
    {
      vtkNew<vtkPoints> moved;
      moved->SetData(this->Part.Points);
      this->Output->SetPoints(moved);
    }
    const auto add = [this](const auto& values, auto* array, const char* name)
    {
      array->SetName(name);
      Allocate(array, 1, this->Mesh.GetNumberOfCells());
      std::copy(values.begin(), values.end(), array->GetPointer(0));
      this->Output->GetCellData()->AddArray(array);
    };
    add(this->Part.Proof.Scaled, vtkNew<vtkDoubleArray>().Get(), "ScaledJacobian");
    add(this->Part.Proof.Valid, vtkNew<vtkUnsignedCharArray>().Get(), "Valid");
  }

private:
  /// Names a cell of the last level that belongs to no curved cell.
  bool Fails(vtkIdType cell) const
  {
    this->Options.Fail("Cell " + std::to_string(cell) + " of the level with the nodes, of type " +
      std::to_string(this->From->GetCellType(cell)) +
      ", is part of no cell that VTK has as a curved one: there is no output. This is a fault of "
      "the filter, not of the input: report it, and set OutputCells to Linear.");
    return false;
  }
  /// Takes the cells of a mesh whose nodes were kept.
  bool TakeKept()
  {
    const auto* which =
      vtkIdTypeArray::SafeDownCast(this->From->GetCellData()->GetArray(CurvedCellName));
    const vtkIdType size = this->From->GetNumberOfCells();
    if (!which || size == 0) // without cells there are no nodes
    {
      return false;
    }
    const CurvedNodes& kept = (*this->Options.Kept)[which->GetTypedComponent(0, 0)];
    this->PointsFrom = kept.Points;
    for (const vtkIdType c : InTurn(size))
    {
      this->Mesh.Shapes.push_back(kept.Shapes[which->GetTypedComponent(c, 1)]);
      this->Sources.push_back(c);
    }
    this->AddNodes(
      [&](vtkIdType c, vtkIdType* to)
      {
        const vtkIdType cell = which->GetTypedComponent(c, 1);
        std::copy(
          kept.Nodes.begin() + kept.Starts[cell], kept.Nodes.begin() + kept.Starts[cell + 1], to);
      });
    return true;
  }

  /// Takes cells that are curved.
  bool TakeMade()
  {
    std::array<const CurvedShape*, 256> shapes{};
    for (int s = 0; s < NumberOfShapes; ++s)
    {
      const CurvedShape* shape =
        CurvedShape::Get(static_cast<CellShape>(s), this->Options.Kind, this->Options.Order);
      shape ? void(shapes[static_cast<std::size_t>(shape->CellType)] = shape) : void();
    }
    const CellReader cells(this->From);
    const vtkIdType size = this->From->GetNumberOfCells();
    for (const vtkIdType c : InTurn(size))
    {
      this->Mesh.Shapes.push_back(shapes[static_cast<std::size_t>(this->From->GetCellType(c))]);
      this->Sources.push_back(c);
    }
    this->AddNodes(
      [&](vtkIdType c, vtkIdType* to)
      {
        std::vector<vtkIdType> scratch;
        const CellIds cell = cells.GetCell(c, scratch);
        std::copy_n(cell.Ids, cell.Size, to);
      });
    return size > 0;
  }
  /// Finds the cells of the level and their nodes. Returns false after an error.
  bool FindRoots()
  {
    const int steps = CountStepsOfNodes(this->Options.Order);
    const SplitRoots roots(
      this->From, steps, [steps](const Root& root) { return root.Steps == steps; });
    if (!this->ListCells(roots))
    {
      return false;
    }
    this->AddNodes([&](vtkIdType c, vtkIdType* to) { this->FindNodes(roots, c, to); });
    const vtkIdType* const begin = this->Mesh.Nodes;
    const vtkIdType* const offsets = this->Mesh.Offsets;
    const vtkIdType size = this->Mesh.GetNumberOfCells();
    const auto missing = std::find(begin, begin + offsets[size], -1) - begin;
    const auto cell = std::upper_bound(offsets, offsets + size, missing) - offsets - 1;
    return missing == offsets[size] || this->Fails(this->Sources[cell]);
  }
  bool ListCells(const SplitRoots& roots)
  {
    for (const vtkIdType r : InTurn(roots.GetNumberOfRoots()))
    {
      const Root& root = roots.GetRoot(r);
      if (!root.Lattice)
      {
        return this->Fails(root.First);
      }
      const CurvedShape* shape =
        CurvedShape::Get(root.Shape == CellShape::Octahedron ? CellShape::Tet : root.Shape,
          this->Options.Kind, this->Options.Order);
      if (!shape)
      {
        this->Options.Fail("Cell " + std::to_string(r) +
          " is a pyramid: VTK has no Lagrange pyramids. Set OutputCells to Quadratic.");
        return false;
      }
      this->Mesh.Shapes.push_back(shape);
      this->Sources.push_back(root.First);
    }
    return true;
  }

  /// Adds the nodes of all cells: find(cell, to) writes them.
  template <typename FindNodes>
  void AddNodes(const FindNodes& find)
  {
    const vtkIdType size = this->Mesh.GetNumberOfCells();
    Allocate(this->Offsets, 1, size + 1);
    vtkIdType* const offsets = this->Offsets->GetPointer(0);
    offsets[0] = 0;
    for (const vtkIdType c : InTurn(size))
    {
      offsets[c + 1] = offsets[c] + this->Mesh.Shapes[c]->GetNumberOfNodes();
    }
    Allocate(this->Nodes, 1, offsets[size]);
    this->Mesh.Offsets = offsets;
    this->Mesh.Nodes = this->Nodes->GetPointer(0);
    ForEach(size, [&](vtkIdType c) { find(c, this->Nodes->GetPointer(offsets[c])); });
  }
  void FindNodes(const SplitRoots& roots, vtkIdType c, vtkIdType* to) const
  {
    const Root& root = roots.GetRoot(c);
    const CurvedShape& shape = *this->Mesh.Shapes[c];
    if (root.Shape != CellShape::Octahedron)
    {
      std::transform(shape.Nodes.begin(), shape.Nodes.end(), to,
        [&](const FrameNode& node) { return roots.GetPoint(root, node); });
      return;
    }
    // Lengths of a piece's edges are multiples of the order, so that its nodes are on the lattice.
    const std::array<FrameNode, 4> piece = this->CutOutPiece(roots, root, shape.Order);
    for (const FrameNode& node : shape.Nodes)
    {
      FrameNode at = piece[0];
      for (int i = 0; i < 9; ++i)
      {
        at[i % 3] += node[i / 3] * (piece[i / 3 + 1][i % 3] - piece[0][i % 3]) / shape.Order;
      }
      *to++ = roots.GetPoint(root, at);
    }
  }
  /// Where the corners are of the tetrahedron that is this quarter of an octahedron in linear
  /// cells, too.
  std::array<FrameNode, 4> CutOutPiece(const SplitRoots& roots, const Root& root, int order) const
  {
    const auto nodes = GetCornerNodes(CellShape::Octahedron, order);
    std::array<vtkIdType, 6> corners{};
    std::transform(nodes.begin(), nodes.begin() + 6, corners.begin(),
      [&](const FrameNode& node) { return roots.GetPoint(root, node); });
    std::array<FrameNode, 4> piece{};
    if (std::find(corners.begin(), corners.end(), -1) != corners.end())
    {
      return piece;
    }
    std::array<vtkIdType, 6> sorted = corners;
    SortOctahedron(sorted.data());
    constexpr int own[6] = { 0, 1, 2, 3, 4, 5 };
    std::array<double, 18> points{};
    for (std::size_t k = 0; k < 6; ++k)
    {
      this->From->GetPoint(sorted[k], points.data() + 3 * k);
    }
    const bool isSingle = this->From->GetPoints()->GetDataType() == VTK_FLOAT;
    std::array<vtkIdType, 16> tets{};
    CutOctahedron(sorted.data(),
      FindShortestDiagonal(own, points.data(), isSingle ? SingleTie : DoubleTie), tets.data());
    const auto first = tets.begin() + 4 * root.Quarter;
    std::transform(first, first + 4, piece.begin(), [&](vtkIdType id)
      { return nodes[std::find(corners.begin(), corners.end(), id) - corners.begin()]; });
    return piece;
  }

  /// Leaves out points that are no nodes.
  void WritePoints()
  {
    const vtkIdType entries = this->Mesh.Offsets[this->Mesh.GetNumberOfCells()];
    std::vector<unsigned char> areNodes(this->PointsFrom->GetNumberOfPoints(), 0);
    for (const vtkIdType i : InTurn(entries))
    {
      areNodes[this->Mesh.Nodes[i]] = 1;
    }
    if (this->PointsFrom == this->From &&
      std::find(areNodes.begin(), areNodes.end(), 0) == areNodes.end())
    {
      this->Output->SetPoints(this->PointsFrom->GetPoints());
      this->Output->GetPointData()->ShallowCopy(this->PointsFrom->GetPointData());
      return;
    }
    std::vector<vtkIdType> numbers(areNodes.size(), -1);
    std::vector<vtkIdType> sources;
    for (const vtkIdType point : InTurn(this->PointsFrom->GetNumberOfPoints()))
    {
      if (areNodes[point])
      {
        numbers[point] = static_cast<vtkIdType>(sources.size());
        sources.push_back(point);
      }
    }
    vtkIdType* const nodes = this->Nodes->GetPointer(0);
    ForEach(entries, [&](vtkIdType i) { nodes[i] = numbers[nodes[i]]; });
    vtkNew<vtkPoints> points;
    points->SetData(vtkDataArray::SafeDownCast(Gather(this->PointsFrom->GetPoints()->GetData(),
      { sources.data(), sources.data() + sources.size() })));
    this->Output->SetPoints(points);
    const bool areOwn = this->PointsFrom == this->From; // else ids count in all blocks
    GatherData(this->PointsFrom->GetPointData(), sources,
      areOwn ? std::vector<std::string>() : std::vector<std::string>{ OriginalPointIdsName },
      this->Output->GetPointData());
  }
  void WriteCells()
  {
    const vtkIdType size = this->Mesh.GetNumberOfCells();
    vtkNew<vtkUnsignedCharArray> types;
    Allocate(types, 1, size);
    ForEach(size, [&](vtkIdType c)
      { types->SetValue(c, static_cast<unsigned char>(this->Mesh.Shapes[c]->CellType)); });
    vtkNew<vtkCellArray> cells;
    cells->SetData(this->Offsets, this->Nodes);
    if (this->Options.Use32BitIds)
    {
      cells->ConvertTo32BitStorage();
    }
    this->Output->SetCells(types, cells);
    std::vector<std::string> left{ OctahedraName, CurvedCellName, "ScaledJacobian", "Valid" };
    if (vtkDataArray* ids = this->From->GetCellData()->GetGlobalIds())
    {
      left.emplace_back(ids->GetName() ? ids->GetName() : "");
    }
    GatherData(this->From->GetCellData(), this->Sources, left, this->Output->GetCellData());
  }
  vtkPointSet* From;
  const CurvedOptions& Options;
  vtkPointSet* PointsFrom;
  std::vector<vtkIdType> Sources; ///< the cell of the mesh that has a cell's data
  vtkNew<vtkIdTypeArray> Offsets;
  vtkNew<vtkIdTypeArray> Nodes;
  CurvedPart Part;
  CurvedMesh& Mesh = this->Part.Mesh; ///< of these
  vtkSmartPointer<vtkUnstructuredGrid> Output = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

}

vtkSmartPointer<vtkDataObject> MakeCurvedCells(vtkDataObject* data, const CurvedOptions& options)
{
  std::deque<CurvedWriter> writers;
  const auto made = ChangeMeshes(data,
    [&](vtkDataObject* object, unsigned int block) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(object);
      if (!mesh)
      {
        return object;
      }
      const auto grid = writers.emplace_back(mesh, block, options).Write();
      vtkFieldData* fields = mesh->GetFieldData();
      for (int a = 0; a < fields->GetNumberOfArrays(); ++a)
      {
        if (!BelongsToStamp(fields->GetAbstractArray(a)->GetName()))
        {
          grid->GetFieldData()->AddArray(fields->GetAbstractArray(a));
        }
      }
      return grid;
    });
  std::vector<CurvedPart*> parts;
  for (CurvedWriter& writer : writers)
  {
    writer.GetPart().Points ? parts.push_back(&writer.GetPart()) : void();
  }
  if (options.Ranks)
  {
    ProveAndRepair(parts, *options.Ranks, options.Warn, options.Fail);
    for (CurvedWriter& writer : writers)
    {
      writer.GetPart().Points ? writer.WriteProof() : void();
    }
  }
  return made;
}

}
