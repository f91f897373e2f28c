// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Carriers.h
 * The *carrier* of a cell of a refined surface: the face, edge or vertex of the control mesh in
 * which its parametric centre lies (Mathematics 1).
 *
 * Some schemes make cells that span several control faces. The output chooses one face at the
 * carrier, whose cell data the cell shows. No child inherits this choice, so that regions of equal
 * data keep their areas.
 */
#ifndef SubdivisionObjects_Carriers_h
#define SubdivisionObjects_Carriers_h

#include "Core/Memory/Buffer.h"

#include <algorithm>

namespace subdivision
{

/// A face (twice its number), an edge (the numbers of its two faces), or a vertex (the smallest
/// number of the faces that were compared, then -1).
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

/// The carrier of a cell at the common edge or vertex of other cells, whose carriers are added: the
/// carrier of highest dimension. If several have this dimension it is their common edge or vertex:
/// an edge of two faces, otherwise a vertex.
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
