// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexRow.h
 * A weighted sum over vertices of one level, whatever names them (BoxSplineLattice.h,
 * LocalLattice.h).
 */
#ifndef SubdivisionObjects_VertexRow_h
#define SubdivisionObjects_VertexRow_h

#include <vector>

namespace subdivision
{

template <typename VertexType>
struct VertexRow
{
  using Vertex = VertexType;

  std::vector<Vertex> Vertices;
  std::vector<double> Weights;

  void Clear()
  {
    this->Vertices.clear();
    this->Weights.clear();
  }
  void Add(const Vertex& vertex, double weight)
  {
    this->Vertices.push_back(vertex);
    this->Weights.push_back(weight);
  }
};

}

#endif
