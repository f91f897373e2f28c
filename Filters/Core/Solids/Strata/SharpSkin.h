// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpSkin.h
 * Whether one normal for all faces at a point would blur what is sharp in a picture.
 */
#ifndef SubdivisionObjects_SharpSkin_h
#define SubdivisionObjects_SharpSkin_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"
#include "Core/Rules/Stratum.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// Whether a complex has joints, creases or corners; all its cells are faces, or all are solids.
/// `edgeVertices`: two of each edge; hasOneFace(edge): the edge is the border of a surface, which
/// is not sharp. Points without edges do not count.
template <typename Id, typename OfVertex, typename OfEdge, typename HasOneFace>
bool HasSharpSkin(const Buffer<Id>& edgeVertices, vtkIdType vertices, const OfVertex& ofVertex,
  const OfEdge& ofEdge, const HasOneFace& hasOneFace)
{
  const auto isJoint = [](Stratum stratum)
  { return stratum.GetType() > 0 || stratum.GetRule() == Rule::Blend; };
  const auto isCurve = [](Stratum stratum)
  { return stratum.GetRule() == Rule::Curve || stratum.GetRule() == Rule::Corner; };
  std::vector<unsigned char> isUsed(static_cast<std::size_t>(vertices), 0);
  std::vector<unsigned char> borders(isUsed); // up to 3 at each vertex
  for (const vtkIdType e : InTurn(edgeVertices.size() / 2))
  {
    const Stratum stratum = ofEdge(static_cast<Id>(e));
    const bool isBorder = isCurve(stratum) && hasOneFace(static_cast<Id>(e));
    if (isJoint(stratum) || (isCurve(stratum) && !isBorder))
    {
      return true;
    }
    for (const Id end : { edgeVertices[2 * e], edgeVertices[2 * e + 1] })
    {
      isUsed[end] = 1;
      borders[end] = static_cast<unsigned char>(std::min(borders[end] + (isBorder ? 1 : 0), 3));
    }
  }
  for (const vtkIdType v : InTurn(vertices))
  {
    const Stratum stratum = ofVertex(static_cast<Id>(v));
    if (isUsed[v] && (isJoint(stratum) || (isCurve(stratum) && borders[v] != 2)))
    {
      return true;
    }
  }
  return false;
}

}

#endif
