// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/ApplyRows.h"

#include "Core/Memory/Store.h"
#include "Core/Operators/PackedArrays.h"
#include "Core/Operators/Sums.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace subdivision
{
namespace
{

/// How many components are summed together. If their number N is 0, which means that it is known at
/// run time only, one after another: loops of unknown length are slow for few components.
template <int N>
constexpr int Width = N == 0 ? 1 : N;

template <typename In, typename Out>
Out* CopyValues(const In* from, vtkIdType size, Out* to)
{
  if constexpr (std::is_same<In, Out>::value)
  {
    return std::copy(from, from + size, to);
  }
  else
  {
    return std::transform(
      from, from + size, to, [](In value) { return Store<Out>(static_cast<double>(value)); });
  }
}

// ------------------------------------------------------------------------------------------------
// Rows that copy, and rows with a weight for each entry

template <int N, typename In, typename Out>
void SumBlock(const CopiedRows& rows, const In* in, Out* out, int components)
{
  CopyValues(
    in + rows.FirstColumn * components, rows.Count * components, out + rows.FirstRow * components);
}

template <int N, typename In, typename Out>
void SumBlock(const RowsOfFour& rows, const In* in, Out* out, int components)
{
  const vtkIdType stride = N == 0 ? components : N;
  const CornerRow* row = rows.Rows;
  Out* to = out + rows.FirstRow * stride;
  constexpr int width = Width<N>;
  Sums<width> sums;
  for (vtkIdType i = 0; i < rows.Count; ++i, ++row)
  {
    for (int first = 0; first < stride; first += width)
    {
      sums.Clear();
      for (int k = 0; k < 4; ++k)
      {
        sums.Add(row->Weights[k], in + stride * static_cast<vtkIdType>(row->Columns[k]) + first);
      }
      sums.Write(to);
      to += width;
    }
  }
}

template <int N, typename Id, typename In, typename Out>
void SumBlock(const WeightedRows<Id>& rows, const In* in, Out* out, int components)
{
  constexpr int width = Width<N>;
  const vtkIdType stride = N == 0 ? components : N;
  const Id* columns = rows.Columns;
  const double* weights = rows.Weights;
  const bool skipsZeros = rows.SkipsZeros;
  in += rows.FirstColumn * stride;
  Sums<width> sums;
  for (vtkIdType row = 0; row < rows.Count; ++row)
  {
    const vtkIdType begin = rows.Offsets[row];
    const vtkIdType end = rows.Offsets[row + 1];
    Out* result = out +
      (rows.Numbers ? static_cast<vtkIdType>(rows.Numbers[row]) : rows.FirstRow + row) * stride;
    if (end - begin == 1 && weights[begin] == 1. && rows.CopiesOnes)
    {
      CopyValues(in + static_cast<vtkIdType>(columns[begin]) * stride, stride, result);
      continue;
    }
    for (int first = 0; first < stride; first += width)
    {
      sums.Clear();
      for (vtkIdType k = begin; k < end; ++k)
      {
        const double weight = weights[k];
        if (weight == 0. && skipsZeros) // 0 times a value that is not finite is not 0
        {
          continue;
        }
        sums.Add(weight, in + static_cast<vtkIdType>(columns[k]) * stride + first);
      }
      sums.Write(result + first);
    }
  }
}

/// `KnownSize`: the size of a row; 0: it is known at run time only.
template <int N, int KnownSize, typename Id, typename In, typename Out>
void SumEqualRows(const EqualRows<Id>& rows, const In* in, Out* out, int components)
{
  constexpr int width = Width<N>;
  const vtkIdType stride = N == 0 ? components : N;
  const int size = KnownSize == 0 ? rows.Size : KnownSize;
  const Id* columns = rows.Columns;
  double known[KnownSize + 1]; // they stay in registers: compilers see that no result changes them
  std::copy_n(rows.Weights, KnownSize, known);
  const double* weights = KnownSize == 0 ? rows.Weights : known;
  Out* result = out + rows.FirstRow * stride;
  Sums<width> sums;
  for (vtkIdType row = 0; row < rows.Count; ++row)
  {
    for (int first = 0; first < stride; first += width)
    {
      sums.Clear();
      for (int k = 0; k < size; ++k)
      {
        sums.Add(weights[k], in + static_cast<vtkIdType>(columns[k]) * stride + first);
      }
      sums.Write(result + first);
    }
    columns += size;
    result += stride;
  }
}

template <int N, typename Id, typename In, typename Out>
void SumBlock(const EqualRows<Id>& rows, const In* in, Out* out, int components)
{
  if constexpr (N > 0 && std::is_floating_point<In>::value)
  {
    switch (rows.Size) // loops of known length for the masks of regular vertices, edges and faces
    {
      case 4:
        return SumEqualRows<N, 4>(rows, in, out, components);
      case 6:
        return SumEqualRows<N, 6>(rows, in, out, components);
      case 7:
        return SumEqualRows<N, 7>(rows, in, out, components);
      case 9:
        return SumEqualRows<N, 9>(rows, in, out, components);
      default:
        break;
    }
  }
  SumEqualRows<N, 0>(rows, in, out, components);
}

// ------------------------------------------------------------------------------------------------
// Rows of rules and rings

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

/// The values of a row besides its ring: those of a vertex, or of both ends of an edge.
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

/// Rows of vertices or edges whose rings have one section each.
template <int N, bool OfEdges, typename Id, typename In, typename Out>
void SumRings(
  const RingRows<Id>& rows, const MaskTable<Mask>& masks, const In* in, Out* out, int components)
{
  constexpr int width = Width<N>;
  const vtkIdType stride = N == 0 ? components : N;
  Sums<width> sum;
  Sums<width> section;
  for (vtkIdType i = 0; i < rows.Count; ++i)
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

/// The same for rings of several sections. Those of a regular vertex or edge, most by farSize, have
/// loops of known length.
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

// ------------------------------------------------------------------------------------------------
// Types of values

/// Applies a block to values of given types.
using Applier = void (*)(const RowsView& view, const void* in, void* out, int components);

template <int N, typename In, typename Out>
void ApplyBlock(const RowsView& view, const void* in, void* out, int components)
{
  std::visit([&](const auto& rows)
    { SumBlock<N>(rows, static_cast<const In*>(in), static_cast<Out*>(out), components); }, view);
}

/// 1 and 3 values of a frequent type have unrolled loops. More cases would cost compile time.
template <typename In, typename Out = In>
Applier FindApplier(int components)
{
  if constexpr (std::is_floating_point<In>::value || std::is_same<In, unsigned char>::value)
  {
    if (components == 1)
    {
      return ApplyBlock<1, In, Out>;
    }
    if (components == 3)
    {
      return ApplyBlock<3, In, Out>;
    }
  }
  if constexpr (std::is_same<In, double>::value && std::is_same<Out, double>::value)
  {
    if (components == 4) // of packed arrays
    {
      return ApplyBlock<4, In, Out>;
    }
  }
  return ApplyBlock<0, In, Out>;
}

Applier FindApplier(const MovedArray& array)
{
  if (array.InType == VTK_DOUBLE && array.OutType == VTK_FLOAT)
  {
    return FindApplier<double, float>(array.Components);
  }
  if (array.InType == array.OutType)
  {
    switch (array.InType)
    {
      vtkTemplateMacro(return FindApplier<VTK_TT>(array.Components));
    }
  }
  throw std::invalid_argument("operators do not know this type of values");
}

template <typename From, typename To>
void ConvertValues(const From* from, To* to, vtkIdType size)
{
  ForRanges(size,
    [=](vtkIdType begin, vtkIdType end) { CopyValues(from + begin, end - begin, to + begin); });
}

template <typename Rows>
bool ReadsBetween(const Rows&)
{
  return false;
}
template <typename Id>
bool ReadsBetween(const WeightedRows<Id>& rows)
{
  return rows.FromBetween;
}
template <typename Rows>
bool WritesBetween(const Rows&)
{
  return false;
}
template <typename Id>
bool WritesBetween(const WeightedRows<Id>& rows)
{
  return rows.ToBetween;
}

/// Applies an operator that has values between.
void ApplyInStages(const PointOperator& operation, const MovedArray& array)
{
  Buffer<double> converted;
  const double* in = ReadDoubles(
    array.In, array.InType, operation.GetNumberOfColumns() * array.Components, converted);
  const bool isDouble = array.OutType == VTK_DOUBLE;
  Buffer<double> results(isDouble ? 0 : operation.GetNumberOfRows() * array.Components);
  double* out = isDouble ? static_cast<double*>(array.Out) : results.data();
  Buffer<double> between(operation.GetNumberBetween() * array.Components);
  const Applier apply = FindApplier<double>(array.Components);
  operation.ForEachBlock(
    [&](const RowsView& view)
    {
      const bool reads = std::visit([](const auto& rows) { return ReadsBetween(rows); }, view);
      const bool writes = std::visit([](const auto& rows) { return WritesBetween(rows); }, view);
      apply(view, reads ? between.data() : in, writes ? between.data() : out, array.Components);
    });
  StoreDoubles(results.data(), array.Out, array.OutType, results.size());
}

}

const double* ReadDoubles(const void* in, int type, vtkIdType size, Buffer<double>& converted)
{
  if (type == VTK_DOUBLE)
  {
    return static_cast<const double*>(in);
  }
  converted = Buffer<double>(size);
  switch (type)
  {
    vtkTemplateMacro(ConvertValues(static_cast<const VTK_TT*>(in), converted.data(), size));
  }
  return converted.data();
}

void StoreDoubles(const double* in, void* out, int type, vtkIdType size)
{
  switch (type)
  {
    vtkTemplateMacro(ConvertValues(in, static_cast<VTK_TT*>(out), size));
  }
}

void ApplyToArrays(
  const PointOperator& operation, std::vector<MovedArray> arrays, const PointOperator::User& also)
{
  if (operation.GetNumberBetween() > 0)
  {
    for (const MovedArray& array : arrays)
    {
      ApplyInStages(operation, array);
    }
    return;
  }
  if (arrays.empty() && !also)
  {
    return;
  }
  const PackedArrays packed(operation, arrays);
  std::vector<Applier> appliers;
  for (const MovedArray& array : arrays)
  {
    appliers.push_back(FindApplier(array));
  }
  operation.ForEachBlock(
    [&](const RowsView& view)
    {
      packed.Apply(view);
      for (std::size_t i = 0; i < arrays.size(); ++i)
      {
        appliers[i](view, arrays[i].In, arrays[i].Out, arrays[i].Components);
      }
      if (also)
      {
        also(view);
      }
    });
}

void SumRows(const RowsView& rows, const double* in, double* out, int components)
{
  FindApplier<double>(components)(rows, in, out, components);
}

void PointOperator::ApplyTo(
  const void* in, int inType, void* out, int outType, int components) const
{
  ApplyToArrays(*this, { { in, inType, out, outType, components } });
}

}
