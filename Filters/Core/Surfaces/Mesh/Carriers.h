// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Carriers.h
 * Where the cells of a refined surface lie on the mesh that it came from (Mathematics 1).
 *
 * Some schemes make cells that span several of those before. Such a cell belongs to the face, edge
 * or vertex of that mesh in which its parametric centre lies: its carrier. Only the output chooses
 * one of the faces there, whose cell data it shows; nothing inherits that choice, so that regions
 * keep their areas.
 */
#ifndef SubdivisionObjects_Carriers_h
#define SubdivisionObjects_Carriers_h

#include "Core/Memory/Buffer.h"

#include <algorithm>

namespace subdivision
{

/// A face (twice the same), an edge (its two faces), or a vertex (its first face, then -1).
template <typename Id>
struct Carrier
{
  Id First;
  Id Second;

  bool IsFace() const { return this->First == this->Second; }
  /// The face there with the smallest number.
  Id GetSmallest() const
  {
    return this->Second < 0 ? this->First : std::min(this->First, this->Second);
  }
  int GetDimension() const { return this->Second < 0 ? 0 : this->IsFace() ? 2 : 1; }
  bool operator==(const Carrier& other) const
  {
    return this->First == other.First && this->Second == other.Second;
  }
};

/// Each face is its own carrier.
template <typename Id>
Buffer<Carrier<Id>> MakeCarriers(vtkIdType faces)
{
  Buffer<Carrier<Id>> carriers(faces);
  ForEach(
    faces, [&carriers](vtkIdType f) { carriers[f] = { static_cast<Id>(f), static_cast<Id>(f) }; });
  return carriers;
}

/// The carrier of a cell at the common edge or vertex of others: the one of highest dimension.
/// Where several have that, what they share: two faces an edge, all else a vertex.
template <typename Id>
class CommonCarrier
{
public:
  void Add(const Carrier<Id>& carrier)
  {
    const int dimension = carrier.GetDimension();
    if (dimension > this->Dimension)
    {
      this->Dimension = dimension;
      this->Common = carrier;
    }
    else if (dimension == this->Dimension)
    {
      this->Share(carrier);
    }
  }
  const Carrier<Id>& Get() const { return this->Common; }

private:
  void Share(const Carrier<Id>& carrier)
  {
    Carrier<Id>& common = this->Common;
    if (common == carrier ||
      (this->Dimension == 2 && common.Second >= 0 &&
        (carrier.First == common.First || carrier.First == common.Second)))
    {
      return;
    }
    const bool areTwoFaces = this->Dimension == 2 && common.IsFace();
    common = { std::min(common.First, carrier.First),
      areTwoFaces ? std::max(common.First, carrier.First) : static_cast<Id>(-1) };
  }

  int Dimension = -1;
  Carrier<Id> Common{ -1, -1 };
};

}

#endif
