// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridKept.h"

#include "Core/Memory/Ids.h"

#include <algorithm>

namespace subdivision
{

namespace
{

template <typename Id>
std::vector<vtkDataArray*> ListArrays(const HybridOutput<Id>& output)
{
  return { output.Cells->GetConnectivityArray(), output.Cells->GetOffsetsArray(), output.Types,
    output.Octahedra };
}

}

template <typename Id>
bool KeptHybrid<Id>::HasCells(const CellList<Id>& cells) const
{
  const CellList<Id>& own = this->Levels.front().Complex.Cells;
  return own.NumberOfPoints == cells.NumberOfPoints && own.Corners.size() == cells.Corners.size() &&
    std::equal(own.Shapes.begin(), own.Shapes.end(), cells.Shapes.begin(), cells.Shapes.end()) &&
    std::equal(own.Corners.begin(), own.Corners.end(), cells.Corners.begin()) &&
    (!this->Output.Cells || this->Handed.Hold(ListArrays(this->Output)));
}

template <typename Id>
void KeptHybrid<Id>::TakeOutput(HybridOutput<Id> output)
{
  const auto& shapes = this->Levels.back().Complex.Cells.Shapes;
  const bool hasOctahedra = std::any_of(shapes.begin(), shapes.end(),
    [](CellShape shape)
    {
      const auto& children = GetCellTable(shape).Children;
      return std::any_of(children.begin(), children.end(),
        [](const CellChild& child) { return child.Shape == CellShape::Octahedron; });
    });
  if (!hasOctahedra)
  {
    this->Output = std::move(output);
    this->Output.AreInverted = Buffer<unsigned char>();
    this->Handed.Set(ListArrays(this->Output));
  }
}

template <typename Id>
CellComplex<Id> KeptHybrid<Id>::CopyLast() const
{
  const CellComplex<Id>& last = this->Levels.back().Complex;
  const auto copy = [](const auto& from, auto& to)
  {
    to = std::decay_t<decltype(to)>(from.size());
    CopyInThreads(from.data(), from.size(), to.data());
  };
  CellComplex<Id> copied;
  copied.NumberOfVertices = last.NumberOfVertices;
  copied.NumberOfEdges = last.NumberOfEdges;
  copied.NumberOfFaces = last.NumberOfFaces;
  copied.NumberOfQuads = last.NumberOfQuads;
  copied.NumberOfCentres = last.NumberOfCentres;
  copied.Cells.NumberOfPoints = last.Cells.NumberOfPoints;
  copy(last.Cells.Shapes, copied.Cells.Shapes);
  copy(last.Cells.Offsets, copied.Cells.Offsets);
  copy(last.Cells.Corners, copied.Cells.Corners);
  copy(last.CellEdges.Offsets, copied.CellEdges.Offsets);
  copy(last.CellEdges.Items, copied.CellEdges.Items);
  copy(last.CellFaces.Offsets, copied.CellFaces.Offsets);
  copy(last.CellFaces.Items, copied.CellFaces.Items);
  copy(last.Centres, copied.Centres);
  return copied;
}

namespace
{

template <typename Id>
std::size_t GetMemorySizeOf(const CellComplex<Id>& complex)
{
  std::size_t bytes = 0;
  for (const Rows<Id>* rows : { &complex.CellEdges, &complex.CellFaces, &complex.FaceSolids,
         &complex.EdgeFaces, &complex.EdgeSolids, &complex.VertexEdges, &complex.VertexSolids })
  {
    bytes += rows->GetMemorySize();
  }
  for (const Buffer<Id>* ids : { &complex.Cells.Offsets, &complex.Cells.Corners, &complex.Centres,
         &complex.CentreCells, &complex.Twins, &complex.EdgeVertices, &complex.FaceVertices,
         &complex.FaceEdges, &complex.EdgeFirsts, &complex.FaceFirsts })
  {
    bytes += ids->GetMemorySize();
  }
  return bytes + complex.Cells.Shapes.GetMemorySize();
}

template <typename Id>
std::size_t GetMemorySizeOf(const HybridStrata<Id>& strata)
{
  return strata.Vertices.GetMemorySize() + strata.Edges.GetMemorySize() +
    strata.Faces.GetMemorySize() + strata.SingularFaces.GetMemorySize() +
    strata.Curves.GetMemorySize();
}

}

template <typename Id>
std::size_t KeptHybrid<Id>::GetMemorySize() const
{
  std::size_t bytes = this->Output.First.GetMemorySize() + this->Limit.GetMemorySize();
  for (const HybridLevel<Id>& level : this->Levels)
  {
    bytes += GetMemorySizeOf(level.Complex) + GetMemorySizeOf(level.Strata);
    for (const auto& stage : level.Sharpness.Stages)
    {
      bytes += GetMemorySizeOf(stage.Strata);
    }
  }
  return bytes;
}

SUBDIVISION_COMPILE(struct KeptHybrid);

}
