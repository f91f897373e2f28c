// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceSides.h
 * The upper side of each part of a surface: which faces have the opposite orientation to the rest.
 */
#ifndef SubdivisionObjects_FaceSides_h
#define SubdivisionObjects_FaceSides_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"

#include <atomic>
#include <cstddef>
#include <vector>

namespace subdivision
{

/// Whether neighbouring faces are oriented differently anywhere. forLinks(face, visit) calls
/// visit(other, contradicts) for each neighbour of a face.
template <typename ForLinks>
bool HaveContradictions(vtkIdType faces, const ForLinks& forLinks)
{
  std::atomic<bool> found(false);
  ForEach(faces,
    [&](vtkIdType face)
    {
      forLinks(face,
        [&found](vtkIdType, bool contradicts)
        {
          if (contradicts)
          {
            found.store(true, std::memory_order_relaxed);
          }
        });
    });
  return found;
}

/// A *part* is all faces that reach each other over links.
struct FaceSides
{
  std::vector<vtkIdType> PartOf;      ///< of each face
  std::vector<unsigned char> Turned;  ///< 1: against the first face of its part
  std::vector<vtkIdType> First;       ///< face of each part
  std::vector<unsigned char> Twisted; ///< 1 for a part that is not orientable

  bool Contradict = false; ///< whether any link does

  /// Turned, but 0 in parts that are not orientable; empty if no link contradicts.
  Buffer<unsigned char> ListTurned() const
  {
    if (!this->Contradict)
    {
      return Buffer<unsigned char>();
    }
    Buffer<unsigned char> turned(static_cast<vtkIdType>(this->Turned.size()));
    ForEach(turned.size(),
      [&](vtkIdType f)
      {
        turned[f] =
          this->Twisted[this->PartOf[f]] ? static_cast<unsigned char>(0) : this->Turned[f];
      });
    return turned;
  }
};

/// Finds the parts of faces, and their sides, in the order of the faces. forLinks: as above, from
/// both faces of each link.
template <typename ForLinks>
FaceSides FindSides(vtkIdType faces, const ForLinks& forLinks)
{
  FaceSides sides;
  sides.PartOf.assign(static_cast<std::size_t>(faces), -1);
  sides.Turned.assign(static_cast<std::size_t>(faces), 0);
  std::vector<vtkIdType> reached;
  for (vtkIdType start = 0; start < faces; ++start)
  {
    if (sides.PartOf[start] >= 0)
    {
      continue;
    }
    const auto part = static_cast<vtkIdType>(sides.First.size());
    sides.First.push_back(start);
    sides.Twisted.push_back(0);
    sides.PartOf[start] = part;
    reached.assign(1, start);
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      const vtkIdType face = reached[i];
      forLinks(face,
        [&](vtkIdType other, bool contradicts)
        {
          sides.Contradict = sides.Contradict || contradicts;
          const auto side = static_cast<unsigned char>(sides.Turned[face] ^ (contradicts ? 1 : 0));
          if (sides.PartOf[other] < 0)
          {
            sides.PartOf[other] = part;
            sides.Turned[other] = side;
            reached.push_back(other);
          }
          else if (sides.Turned[other] != side)
          {
            sides.Twisted[part] = 1;
          }
        });
    }
  }
  return sides;
}

/// Of faces that each were split into 4 so many times, in order: whether the first child of each is
/// turned.
inline Buffer<unsigned char> TakeParents(const Buffer<unsigned char>& turned, int steps)
{
  Buffer<unsigned char> parents(turned.size() >> 2 * steps);
  ForEach(parents.size(), [&](vtkIdType f) { parents[f] = turned[f << 2 * steps]; });
  return parents;
}

}

#endif
