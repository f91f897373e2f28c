// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingSums.h
 * Sums the rows of rules and rings: a vertex or edge, and the members of its ring, which share a
 * weight. For ApplyRows.cxx.
 */
#ifndef SubdivisionObjects_RingSums_h
#define SubdivisionObjects_RingSums_h

#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/Sums.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Sums the values of one section of a ring.
template <int W, typename Id, typename In>
void SumSection(const Id* first, const Id* last, const In* in, vtkIdType stride, Sums<W>& section)
{
  section.Clear();
  for (const Id* member = first; member != last; ++member)
  {
    section.Add(in + static_cast<vtkIdType>(*member) * stride);
  }
}

/// Adds the weighted sum of a section of a size that the compiler knows.
template <int Size, int W, typename Id, typename In>
void AddSection(double weight, const Id* members, const In* in, vtkIdType stride, Sums<W>& sum)
{
  Sums<W> section;
  section.Clear();
  for (int i = 0; i < Size; ++i)
  {
    section.Add(in + static_cast<vtkIdType>(members[i]) * stride);
  }
  sum.Add(weight, section);
}

/// Adds the sections of a ring.
template <int W, typename Id, typename In>
void AddSections(
  const PartedMask& mask, const Id* members, const In* in, vtkIdType stride, Sums<W>& sum)
{
  for (int part = 0; part < mask.Parts; ++part)
  {
    const Id* last = members + mask.Sizes[part];
    const double weight = mask.Weights[part];
    if (weight != 0.) // 0 times a value that is not finite is not 0
    {
      Sums<W> section;
      SumSection(members, last, in, stride, section);
      sum.Add(weight, section);
    }
    members = last;
  }
}

/// A row whose plain sum overflows: terms are weighted first, so that finite values give a finite
/// mean. Edges have two values `first` and `second`, centres none. A call keeps loops around short.
template <typename Id, typename In>
[[gnu::noinline]] double SumTermByTerm(const PartedMask& mask, const In* first, const In* second,
  const Id* members, const In* in, vtkIdType stride)
{
  double sum = first ? mask.Own * static_cast<double>(*first) : 0.;
  sum += second ? mask.Own * static_cast<double>(*second) : 0.;
  for (int part = 0; part < mask.Parts; ++part)
  {
    const Id* last = members + mask.Sizes[part];
    for (; members != last; ++members)
    {
      sum += mask.Weights[part] == 0.
        ? 0.
        : mask.Weights[part] * static_cast<double>(in[static_cast<vtkIdType>(*members) * stride]);
    }
  }
  return sum;
}

/// Stores sums. Where one is not finite, instead(c) is stored.
template <int W, typename Out, typename Instead>
void StoreSums(const Sums<W>& sum, Out* result, const Instead& instead)
{
  if (sum.IsFinite())
  {
    sum.Write(result);
    return;
  }
  for (int c = 0; c < W; ++c)
  {
    result[c] = Store<Out>(std::isfinite(sum[c]) ? sum[c] : instead(c));
  }
}

template <int N, typename Id, typename In, typename Out>
void SumCounted(
  const RingRows<Id>& rows, vtkIdType i, const In* in, const In* own, Out* result, vtkIdType stride)
{
  constexpr int width = Width<N>;
  const Row<Id> ring = rows.GetRing(i);
  const Id* counts = rows.Counts + rows.Offsets[i];
  double all = 0.;
  for (vtkIdType k = 0; k < ring.size(); ++k)
  {
    all += static_cast<double>(counts[k]) / 3.;
  }
  Sums<width> sum;
  for (int first = 0; first < stride; first += width)
  {
    sum.Set(own + first);
    sum.Scale(rows.Masks->CountedOwn);
    for (vtkIdType k = 0; k < ring.size(); ++k)
    {
      const double weight = rows.Masks->CountedOther * static_cast<double>(counts[k]) / all;
      sum.Add(weight, in + static_cast<vtkIdType>(ring.begin()[k]) * stride + first);
    }
    sum.Write(result + first);
  }
}

/// The values of a row besides its ring: of the vertex, or of both ends of the edge.
template <bool OfEdges, typename In>
struct OwnValues
{
  template <typename Id>
  OwnValues(const RingRows<Id>& rows, vtkIdType i, const In* in, vtkIdType stride)
    : First(in + (OfEdges ? static_cast<vtkIdType>(rows.Ends[2 * i]) : rows.GetColumn(i)) * stride)
    , Second(OfEdges ? in + static_cast<vtkIdType>(rows.Ends[2 * i + 1]) * stride : nullptr)
  {
  }
  /// Sets `sum` to the values from component `first` on, times a weight.
  template <int W>
  void Get(int first, double weight, Sums<W>& sum) const
  {
    sum.Set(this->First + first);
    if constexpr (OfEdges)
    {
      sum.Add(this->Second + first);
    }
    sum.Scale(weight);
  }
  template <typename Id>
  double SumRow(const PartedMask& mask, const Id* ring, const In* in, int c, vtkIdType stride) const
  {
    return SumTermByTerm(
      mask, this->First + c, OfEdges ? this->Second + c : nullptr, ring, in + c, stride);
  }

  const In* First;
  const In* Second;
};

/// act(first) for each group of components that are summed together; a single group is no loop.
template <int N, typename Act>
void ForGroups(vtkIdType components, const Act& act)
{
  if constexpr (N > 0)
  {
    act(0);
  }
  else
  {
    for (int first = 0; first < components; ++first)
    {
      act(first);
    }
  }
}

/// Sums the first rows, as long as they are of edges without rings or of vertices on curves.
/// Returns how many these are; in meshes of lines nearly all.
template <int N, bool OfEdges, typename Id, typename In, typename Out>
vtkIdType SumAlongCurves(
  const RingRows<Id>& rows, const MaskTable<Mask>& masks, const In* in, Out* out, vtkIdType stride)
{
  constexpr int size = OfEdges ? 0 : 2;
  Mask scratch;
  const Mask mask = masks.Get(Rule::Curve, size, scratch);
  const Id* offsets = rows.Offsets;
  const Stratum* strata = rows.Strata;
  const vtkIdType count = rows.Count;
  Out* result = out + rows.FirstRow * stride;
  Sums<Width<N>> sum;
  vtkIdType i = 0;
  for (; i < count && offsets[i + 1] - offsets[i] == size &&
    (OfEdges || strata[i].GetRule() == Rule::Curve);
    ++i)
  {
    const Id* ring = rows.Members + offsets[i];
    const OwnValues<OfEdges, In> own(rows, i, in, stride);
    ForGroups<N>(stride,
      [&](int first)
      {
        own.Get(first, mask.Own, sum);
        AddSection<size>(mask.Ring, ring, in + first, stride, sum);
        StoreSums(sum, result + first,
          [&](int c) { return own.SumRow(MakeParted(mask, size), ring, in, first + c, stride); });
      });
    result += stride;
  }
  return i;
}

/// Rows of vertices or edges whose rings have one section each.
template <int N, bool OfEdges, typename Id, typename In, typename Out>
void SumRings(
  const RingRows<Id>& rows, const MaskTable<Mask>& masks, const In* in, Out* out, int components)
{
  constexpr int width = Width<N>;
  const vtkIdType stride = N == 0 ? components : N;
  Sums<width> sum;
  Sums<width> section;
  for (vtkIdType i = SumAlongCurves<N, OfEdges>(rows, masks, in, out, stride); i < rows.Count; ++i)
  {
    const Id* ring = rows.Members + rows.Offsets[i];
    const Id* last = rows.Members + rows.Offsets[i + 1];
    Mask scratch;
    const Mask& mask = masks.Get(rows.Strata[i].GetRule(), last - ring, scratch);
    const double ownWeight = mask.Own;
    const double ringWeight = mask.Ring;
    const OwnValues<OfEdges, In> own(rows, i, in, stride);
    Out* result = out + (rows.FirstRow + i) * stride;
    if (!OfEdges && ringWeight == 0.) // do not read the ring: 0 times infinity is not 0
    {
      CopyValues(own.First, stride, result);
      continue;
    }
    ForGroups<N>(stride,
      [&](int first)
      {
        SumSection(ring, last, in + first, stride, section);
        own.Get(first, ownWeight, sum);
        sum.Add(ringWeight, section);
        StoreSums(sum, result + first,
          [&](int c)
          {
            const PartedMask parted = MakeParted({ ownWeight, ringWeight }, last - ring);
            return own.SumRow(parted, ring, in, first + c, stride);
          });
      });
  }
}

/// The same for rings of several sections. Regular vertices and edges, most by farSize, have loops
/// of known length.
template <int N, bool OfEdges, typename Id, typename In, typename Out>
void SumRings(const RingRows<Id>& rows, const MaskTable<PartedMask>& masks, const In* in, Out* out,
  int components)
{
  constexpr int nearSize = OfEdges ? 4 : 12;
  constexpr int farSize = OfEdges ? 4 : 6;
  constexpr int width = Width<N>;
  const vtkIdType stride = N == 0 ? components : N;
  PartedMask scratch;
  const PartedMask regular = masks.Get(Rule::RegularEdge, nearSize + farSize, scratch);
  const bool hasRegular =
    regular.Parts == 2 && regular.Sizes[0] == nearSize && regular.Sizes[1] == farSize;
  Sums<width> sum;
  for (vtkIdType i = 0; i < rows.Count; ++i)
  {
    const Id* ring = rows.Members + rows.Offsets[i];
    const vtkIdType ringSize = rows.Members + rows.Offsets[i + 1] - ring;
    const Rule rule = rows.Strata[i].GetRule();
    const OwnValues<OfEdges, In> own(rows, i, in, stride);
    Out* result = out + (rows.FirstRow + i) * stride;
    if (!OfEdges && rows.HasCounts(i))
    {
      SumCounted<N>(rows, i, in, own.First, result, stride);
      continue;
    }
    const bool isRegular =
      hasRegular && rule == Rule::RegularEdge && ringSize == nearSize + farSize;
    const PartedMask& mask = isRegular ? regular : masks.Get(rule, ringSize, scratch);
    const double ownWeight = mask.Own;
    if (!OfEdges && ownWeight == 1.) // do not read the ring: 0 times infinity is not 0
    {
      CopyValues(own.First, stride, result);
      continue;
    }
    ForGroups<N>(stride,
      [&](int first)
      {
        own.Get(first, ownWeight, sum);
        if (isRegular)
        {
          AddSection<nearSize>(regular.Weights[0], ring, in + first, stride, sum);
          AddSection<farSize>(regular.Weights[1], ring + nearSize, in + first, stride, sum);
        }
        else
        {
          AddSections(mask, ring, in + first, stride, sum);
        }
        StoreSums(sum, result + first,
          [&](int c) { return own.SumRow(mask, ring, in, first + c, stride); });
      });
  }
}

template <int N, typename Id, typename In, typename Out>
void SumCentres(const RingRows<Id>& rows, const In* in, Out* out, int components)
{
  constexpr int width = Width<N>;
  constexpr int members = RingRows<Id>::CentreSize;
  const PartedMask mask{ 0., 1, { members, 0, 0 }, { 1. / members, 0., 0. } };
  const In* none = nullptr;
  const vtkIdType stride = N == 0 ? components : N;
  for (vtkIdType i = 0; i < rows.Count; ++i)
  {
    const Id* ring = rows.Members + members * i;
    Out* result = out + (rows.FirstRow + i) * stride;
    ForGroups<N>(stride,
      [&](int first)
      {
        Sums<width> sum;
        sum.Clear();
        AddSection<members>(mask.Weights[0], ring, in + first, stride, sum);
        StoreSums(sum, result + first,
          [&](int c) { return SumTermByTerm(mask, none, none, ring, in + first + c, stride); });
      });
  }
}

template <int N, typename Id, typename In, typename Out>
void SumBlock(const RingRows<Id>& rows, const In* in, Out* out, int components)
{
  if (rows.OfCentres)
  {
    SumCentres<N>(rows, in, out, components);
    return;
  }
  std::visit(
    [&](const auto& tables)
    {
      rows.OfEdges ? SumRings<N, true>(rows, tables.Edges, in, out, components)
                   : SumRings<N, false>(rows, tables.Vertices, in, out, components);
    },
    rows.Masks->Tables);
}

}

}

#endif
