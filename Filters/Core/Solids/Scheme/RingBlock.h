// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingBlock.h
 * Makes rows block by block for operators that are not stored.
 */
#ifndef SubdivisionObjects_RingBlock_h
#define SubdivisionObjects_RingBlock_h

#include "Core/Operators/ForBlocks.h"
#include "Core/Operators/PointOperator.h"
#include "Core/Solids/Scheme/RingEmitter.h"

#include <algorithm>

namespace subdivision
{

/// A block of at most `capacity` rows that is filled row by row: Reserve, Open, write the members,
/// Close. `hasColumns`: the vertices of rows have other numbers than the rows, set by SetColumn.
template <typename Id>
class RingBlock
{
public:
  RingBlock(const RingMasks& masks, bool ofEdges, vtkIdType capacity, bool hasColumns = false)
    : Masks(masks)
    , OfEdges(ofEdges)
    , Strata(capacity)
    , Ends(ofEdges ? 2 * capacity : 0)
    , Columns(hasColumns ? capacity : 0)
    , Offsets(capacity + 1, Id(0))
  {
  }
  void Start(vtkIdType firstRow)
  {
    this->FirstRow = firstRow;
    this->Count = 0;
  }
  /// Makes room for `members` further members, in all rings together that are opened before the
  /// next call.
  void Reserve(Id members)
  {
    const vtkIdType wanted = vtkIdType(this->Offsets[this->Count]) + members;
    if (this->Members.size() < wanted)
    {
      Buffer<Id> larger(2 * wanted);
      std::copy_n(this->Members.begin(), this->Offsets[this->Count], larger.begin());
      this->Members = std::move(larger);
    }
  }
  /// Opens a ring behind the closed ones and behind `before` members of rings that are still open.
  MemberWriter<Id> Open(Id before = 0)
  {
    return { this->Members.data() + this->Offsets[this->Count] + before };
  }
  void Close(const MemberWriter<Id>& ring, Stratum stratum)
  {
    this->Strata[this->Count++] = stratum;
    this->Offsets[this->Count] = static_cast<Id>(ring.Members - this->Members.data());
  }
  /// The ends of the edge whose row is closed next.
  Id* GetEnds() { return this->Ends.data() + 2 * this->Count; }

  /// The column of the vertex whose row is closed next.
  void SetColumn(Id column)
  {
    if (this->Columns.size() > 0)
    {
      this->Columns[this->Count] = column;
    }
  }

  RingRows<Id> Get() const
  {
    RingRows<Id> rows{ &this->Masks, this->OfEdges, this->FirstRow, this->Count,
      this->Strata.data(), this->Ends.data(), this->Offsets.data(), this->Members.data() };
    rows.Columns = this->Columns.size() > 0 ? this->Columns.data() : nullptr;
    return rows;
  }

private:
  const RingMasks& Masks;
  const bool OfEdges;
  vtkIdType FirstRow = 0;
  vtkIdType Count = 0;
  Buffer<Stratum> Strata;
  Buffer<Id> Ends;
  Buffer<Id> Columns;
  Buffer<Id> Offsets;
  Buffer<Id> Members;
};

/// The rows of the three edges inside a face, as RingEmitter::EmitInFace takes their rings.
template <typename Split>
class InFaceRows
{
public:
  using Id = typename Split::Id;

  InFaceRows(const RingEmitter<Split>& emitter, Id face, RingBlock<Id>& rows)
    : Emitter(emitter)
    , Face(face)
    , Rows(rows)
  {
  }
  MemberWriter<Id> Open(int, Id size)
  {
    const Id before = this->Opened;
    this->Opened += size;
    return this->Rows.Open(before);
  }
  void Close(int corner, const MemberWriter<Id>& ring)
  {
    this->Opened = 0;
    this->Emitter.GetInFaceEnds(this->Face, corner, this->Rows.GetEnds());
    this->Rows.Close(ring, this->Emitter.InFaceStratum(this->Face, corner));
  }

private:
  const RingEmitter<Split>& Emitter;
  const Id Face;
  RingBlock<Id>& Rows;
  Id Opened = 0; ///< room of rings that are open
};

}

#endif
