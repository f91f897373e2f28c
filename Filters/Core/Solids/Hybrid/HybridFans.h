// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridFans.h
 * Triangles and quads around a vertex of a surface, or in a sector from one sharp edge to the next:
 * the limit there depends on their types in cyclic order only.
 */
#ifndef SubdivisionObjects_HybridFans_h
#define SubdivisionObjects_HybridFans_h

#include "Core/Operators/LocalRows.h"
#include "Core/Solids/Hybrid/HybridLevel.h"

#include <unordered_map>
#include <vector>

namespace subdivision
{

/// Edges at a vertex, and the faces from one to the next.
template <typename Id>
struct HybridFan
{
  Id Vertex = 0;
  std::vector<Id> Edges;
  std::vector<Id> Faces;
  bool IsClosed = false;

  /// The sizes of the faces, and at last whether they close.
  Neighbourhood GetKey(const CellComplex<Id>& complex) const
  {
    Neighbourhood key;
    for (const Id face : this->Faces)
    {
      key.push_back(complex.GetSize(face));
    }
    key.push_back(this->IsClosed ? 1 : 0);
    return key;
  }
  /// Calls act(item, vertex, new point) for each item: the vertex, the far ends of edges, the far
  /// corners of quads.
  template <typename Act>
  void ForItems(const CellComplex<Id>& complex, const Act& act) const
  {
    std::size_t item = 0;
    const vtkIdType edges = complex.NumberOfVertices;
    act(item++, this->Vertex, vtkIdType(this->Vertex));
    for (const Id edge : this->Edges)
    {
      act(item++, complex.GetOtherEnd(edge, this->Vertex), edges + edge);
    }
    for (const Id face : this->Faces)
    {
      const Row<Id> corners = complex.GetVertices(face);
      if (corners.size() == 4)
      {
        const auto place = std::find(corners.begin(), corners.end(), this->Vertex);
        act(item++, corners.begin()[(place - corners.begin() + 2) % 4],
          edges + complex.NumberOfEdges + face);
      }
    }
  }
};

/// Finds the fan of a vertex with d = 2 inside a surface. False: there is none that closes, or
/// other rules take part.
template <typename Id>
bool FindFan(const HybridLevel<Id>& level, Id vertex, HybridFan<Id>& fan);

/// Walks from an edge over a face and further smooth edges back to the first edge, or to the next
/// sharp one. False: faces on the way do not go on.
template <typename Id>
bool FollowFan(const HybridLevel<Id>& level, Id vertex, Id edge, Id face, HybridFan<Id>& fan);

/// Whether neither ends of sectors at other vertices nor semi-sharp edges and faces change the
/// rules of a fan.
template <typename Id>
bool IsPlainFan(const HybridLevel<Id>& level, const HybridFan<Id>& fan);

/// The rows of a fan of these sizes, in a mesh of its own.
LocalRows MakeFanRows(const Neighbourhood& key, LoopWeights weights);

/// Limits of closed fans.
class FanLimits
{
public:
  explicit FanLimits(LoopWeights weights)
    : Weights(weights)
  {
  }
  /// One weight for each item.
  const std::vector<double>& Find(const Neighbourhood& key);

private:
  const LoopWeights Weights;
  std::unordered_map<Neighbourhood, std::vector<double>, HashNeighbourhood> Solved;
};

}

#endif
