// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CurvedParts.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Curved/CurvedNodes.h"

#include <cmath>
#include <iterator>
#include <numeric>

namespace subdivision
{

namespace
{

/// The key of a node of a cell: faces and edges have the same, whichever cell asks.
NodeKey FindKey(const CurvedMesh& mesh, vtkIdType cell, int n, const std::vector<NodePoint>& points)
{
  const CurvedShape& shape = *mesh.Shapes[cell];
  const vtkIdType* nodes = mesh.GetNodes(cell);
  const auto weights = GetStraightWeights(shape, shape.Nodes[n]);
  std::uint64_t sum = 0;
  for (int k = 0; k < GetCellTable(shape.Shape).Corners; ++k)
  {
    const double parts = std::pow(static_cast<double>(shape.Order), 3);
    auto hash = static_cast<std::uint64_t>(std::lround(parts * weights[k]));
    const bool counts = hash > 0;
    for (const std::int64_t x : ToBits(points[nodes[k]]))
    {
      hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    sum += counts ? hash : 0;
  }
  const Bits at = ToBits(points[nodes[n]]);
  return { { at[0], at[1], at[2], static_cast<std::int64_t>(sum) } };
}

}

JoinedParts::JoinedParts(const std::vector<CurvedPart*>& parts)
{
  for (const CurvedPart* part : parts)
  {
    this->Add(*part);
  }
  this->Mesh.Offsets = this->Offsets.data();
  this->Mesh.Nodes = this->Nodes.data();
  this->Keys.resize(this->Points.size());
  std::vector<unsigned char> areKnown(this->Points.size(), 0);
  for (const vtkIdType c : InTurn(this->Mesh.GetNumberOfCells()))
  {
    for (int n = 0; n < this->Mesh.Shapes[c]->GetNumberOfNodes(); ++n)
    {
      const vtkIdType node = this->Mesh.GetNodes(c)[n];
      if (!areKnown[node])
      {
        areKnown[node] = 1;
        this->Keys[node] = FindKey(this->Mesh, c, n, this->Points);
      }
    }
  }
  this->Sorted.resize(this->Points.size());
  std::iota(this->Sorted.begin(), this->Sorted.end(), vtkIdType(0));
  StableSort(
    this->Sorted, [this](vtkIdType a, vtkIdType b) { return this->Keys[a] < this->Keys[b]; });
  this->Firsts.resize(this->Points.size());
  vtkIdType first = -1;
  for (const vtkIdType i : InTurn(this->Sorted))
  {
    first = first >= 0 && this->Keys[first] == this->Keys[i] ? first : i;
    this->Firsts[i] = first;
  }
  for (vtkIdType& node : InTurn(this->Nodes))
  {
    node = this->Firsts[node];
  }
}

void JoinedParts::Add(const CurvedPart& part)
{
  const auto start = static_cast<vtkIdType>(this->Points.size());
  for (const vtkIdType i : InTurn(part.Points->GetNumberOfTuples()))
  {
    NodePoint p = ReadPoint(part.Points, i);
    std::for_each(p.begin(), p.end(), [](double& x) { x += 0.; }); // no place has two zeros
    this->Points.push_back(p);
  }
  this->AreSingle.resize(this->Points.size(), part.Points->GetDataType() == VTK_FLOAT ? 1 : 0);
  const vtkIdType nodes = this->Offsets.back();
  for (const vtkIdType c : InTurn(part.Mesh.GetNumberOfCells()))
  {
    this->Mesh.Shapes.push_back(part.Mesh.Shapes[c]);
    this->Offsets.push_back(nodes + part.Mesh.Offsets[c + 1]);
    std::transform(part.Mesh.GetNodes(c), part.Mesh.GetNodes(c + 1),
      std::back_inserter(this->Nodes), [start](vtkIdType node) { return start + node; });
  }
  const CurvedProof& proof = part.Proof;
  this->Proof.Valid.insert(this->Proof.Valid.end(), proof.Valid.begin(), proof.Valid.end());
  this->Proof.Scaled.insert(this->Proof.Scaled.end(), proof.Scaled.begin(), proof.Scaled.end());
}

vtkIdType JoinedParts::Find(const NodeKey& key) const
{
  const auto found = std::lower_bound(this->Sorted.begin(), this->Sorted.end(), key,
    [this](vtkIdType i, const NodeKey& other) { return this->Keys[i] < other; });
  return found != this->Sorted.end() && this->Keys[*found] == key ? *found : -1;
}

Surroundings::Surroundings(const CurvedMesh& mesh, vtkIdType points)
  : Mesh(mesh)
  , Starts(points + 1, 0)
  , AreOther(points, 0)
{
  this->ForNodes([this](vtkIdType, vtkIdType node) { ++this->Starts[node + 1]; });
  for (const vtkIdType node : InTurn(points))
  {
    this->Starts[node + 1] += this->Starts[node];
  }
  this->Solids.resize(this->Starts[points]);
  std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
  this->ForNodes([&](vtkIdType cell, vtkIdType node) { this->Solids[next[node]++] = cell; });
}

template <typename Act>
void Surroundings::ForNodes(const Act& act)
{
  for (const vtkIdType c : InTurn(this->Mesh.GetNumberOfCells()))
  {
    const CurvedShape& shape = *this->Mesh.Shapes[c];
    const vtkIdType* nodes = this->Mesh.GetNodes(c);
    for (int n = 0; n < shape.GetNumberOfNodes(); ++n)
    {
      shape.Jacobian ? act(c, nodes[n]) : void(this->AreOther[nodes[n]] = 1);
    }
  }
}

bool Surroundings::IsOpen(vtkIdType solid, const CurvedShape::Face& face) const
{
  const vtkIdType* nodes = this->Mesh.GetNodes(solid);
  const auto hasAll = [&](vtkIdType other)
  {
    const vtkIdType* begin = this->Mesh.GetNodes(other);
    const vtkIdType* end = begin + GetCellTable(this->Mesh.Shapes[other]->Shape).Corners;
    return other != solid &&
      std::all_of(face.Nodes.begin(), face.Nodes.begin() + face.Corners,
        [&](int corner) { return std::find(begin, end, nodes[corner]) != end; });
  };
  const vtkIdType first = nodes[face.Nodes[0]];
  return std::none_of(this->Begin(first), this->End(first), hasAll);
}

}
