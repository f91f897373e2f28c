// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedParts.h
 * Parts of a mesh of curved cells as one mesh, and what is around its nodes.
 */
#ifndef SubdivisionObjects_CurvedParts_h
#define SubdivisionObjects_CurvedParts_h

#include "Private/Curved/CurvedMesh.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace subdivision
{

using NodePoint = std::array<double, 3>;

/// May be called by several threads.
inline NodePoint ReadPoint(vtkDataArray* points, vtkIdType i)
{
  NodePoint p;
  points->GetTuple(i, p.data());
  return p;
}

/// Coordinates, bit by bit.
using Bits = std::array<std::int64_t, 3>;

inline Bits ToBits(const NodePoint& p)
{
  Bits bits;
  std::memcpy(bits.data(), p.data(), sizeof(bits));
  return bits;
}

/// By this parts and ranks know each other's nodes: where one is, and a number for the corners of
/// its face or edge, where they are.
using NodeKey = std::array<std::int64_t, 4>;

/// All parts of this rank as one mesh. Nodes with the same key are one node, the first of them.
class JoinedParts
{
public:
  explicit JoinedParts(const std::vector<CurvedPart*>& parts);
  /// The node with a key, -1 if there is none.
  vtkIdType Find(const NodeKey& key) const;

  CurvedMesh Mesh; ///< of Offsets and Nodes
  std::vector<NodePoint> Points;
  std::vector<unsigned char> AreSingle; ///< of each point, whether it is in single precision
  std::vector<vtkIdType> Firsts;        ///< of each point, the node
  std::vector<NodeKey> Keys;            ///< of each point
  CurvedProof Proof;

private:
  void Add(const CurvedPart& part);

  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Nodes;
  std::vector<vtkIdType> Sorted; ///< points by their keys
};

/// The solids at each node, and what tells that nodes are on the boundary: other cells, and faces
/// of one solid only. These are looked up for few nodes, next to solids that have to be repaired.
class Surroundings
{
public:
  Surroundings(const CurvedMesh& mesh, vtkIdType points);
  const vtkIdType* Begin(vtkIdType node) const { return this->Solids.data() + this->Starts[node]; }
  const vtkIdType* End(vtkIdType node) const
  {
    return this->Solids.data() + this->Starts[node + 1];
  }
  bool IsOnOther(vtkIdType node) const { return this->AreOther[node] != 0; }
  /// act(corners): the faces at a node that no other solid has.
  template <typename Act>
  void ForOpenFaces(vtkIdType node, const Act& act) const
  {
    for (const vtkIdType* solid = this->Begin(node); solid != this->End(node); ++solid)
    {
      const vtkIdType* nodes = this->Mesh.GetNodes(*solid);
      for (const CurvedShape::Face& face : this->Mesh.Shapes[*solid]->Faces)
      {
        if (this->IsOpen(*solid, face) &&
          std::any_of(
            face.Nodes.begin(), face.Nodes.end(), [&](int n) { return nodes[n] == node; }))
        {
          std::vector<vtkIdType> corners(face.Nodes.begin(), face.Nodes.begin() + face.Corners);
          std::for_each(
            corners.begin(), corners.end(), [nodes](vtkIdType& corner) { corner = nodes[corner]; });
          act(corners);
        }
      }
    }
  }

private:
  /// act(cell, node) for all solids; nodes of other cells are on the boundary.
  template <typename Act>
  void ForNodes(const Act& act);
  /// Whether no other solid has all corners of a face.
  bool IsOpen(vtkIdType solid, const CurvedShape::Face& face) const;

  const CurvedMesh& Mesh;
  std::vector<vtkIdType> Starts;
  std::vector<vtkIdType> Solids;
  std::vector<unsigned char> AreOther;
};

}

#endif
