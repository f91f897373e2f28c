// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexOrigins.h
 * The input points whose values new vertices take in arrays that are not smoothed.
 */
#ifndef SubdivisionObjects_VertexOrigins_h
#define SubdivisionObjects_VertexOrigins_h

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Solids/RedGreen/RedGreen.h"
#include "Private/Arrays/PointArrays.h"

#include <algorithm>

namespace subdivision
{

/**
 * A new vertex has the origin of one end of its edge: of the one that fewer halvings made, or else
 * of the one whose origin is earlier. So it does not depend on the order in which edges were split.
 */
class VertexOrigins
{
public:
  explicit VertexOrigins(const PointArrays& order)
    : Order(order)
  {
  }

  /// Continues to the vertices that the state has by now.
  template <typename Id>
  void Continue(const RedGreen<Id>& state)
  {
    this->Continue(state.GetNumberOfInputVertices(), state.GetNumberOfVertices(),
      [&state](vtkIdType v) { return state.GetEnds(static_cast<Id>(v)); });
  }
  /// The same to `size` vertices, of which `given` are no midpoints.
  template <typename GetEnds>
  void Continue(vtkIdType given, vtkIdType size, const GetEnds& getEnds)
  {
    this->Given = given;
    vtkIdType v = this->Given + this->Added.size();
    Vertex* added = this->Added.Extend(size - v);
    for (; v < size; ++v) // both ends come before their midpoint
    {
      const auto ends = getEnds(v);
      const vtkIdType first = this->IsFirst(ends[0], ends[1]) ? ends[0] : ends[1];
      *added++ = { (*this)(first),
        static_cast<unsigned char>(
          1 + std::max(this->GetDepth(ends[0]), this->GetDepth(ends[1]))) };
    }
  }
  vtkIdType operator()(vtkIdType vertex) const
  {
    return vertex < this->Given ? vertex : this->Added[vertex - this->Given].Origin;
  }
  /// Whether a vertex between a and b takes the values of a.
  bool IsFirst(vtkIdType a, vtkIdType b) const
  {
    const int depths[2] = { this->GetDepth(a), this->GetDepth(b) };
    return depths[0] != depths[1] ? depths[0] < depths[1]
                                  : this->Order.IsEarlier((*this)(a), (*this)(b));
  }

private:
  struct Vertex
  {
    vtkIdType Origin;
    unsigned char Depth;
  };
  int GetDepth(vtkIdType vertex) const
  {
    return vertex < this->Given ? 0 : this->Added[vertex - this->Given].Depth;
  }

  const PointArrays& Order;
  vtkIdType Given = 0;
  GrowingBuffer<Vertex> Added;
};

}

#endif
