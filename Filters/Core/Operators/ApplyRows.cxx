// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/ApplyRows.h"

#include "Core/Operators/PackedArrays.h"
#include "Core/Operators/RingSums.h"

#include "vtkSetGet.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace subdivision
{
namespace
{

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
        sums.Add(weights[k], in + static_cast<vtkIdType>(columns[k]) * stride + first);
      }
      if (skipsZeros && !sums.IsFinite()) // 0 times a value that is not finite is not 0
      {
        sums.Clear();
        for (vtkIdType k = begin; k < end; ++k)
        {
          if (weights[k] != 0.)
          {
            sums.Add(weights[k], in + static_cast<vtkIdType>(columns[k]) * stride + first);
          }
        }
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
      case 2:
        return SumEqualRows<N, 2>(rows, in, out, components);
      case 3:
        return SumEqualRows<N, 3>(rows, in, out, components);
      case 4:
        return SumEqualRows<N, 4>(rows, in, out, components);
      case 5:
        return SumEqualRows<N, 5>(rows, in, out, components);
      case 6:
        return SumEqualRows<N, 6>(rows, in, out, components);
      case 7:
        return SumEqualRows<N, 7>(rows, in, out, components);
      case 8:
        return SumEqualRows<N, 8>(rows, in, out, components);
      case 9:
        return SumEqualRows<N, 9>(rows, in, out, components);
      default:
        break;
    }
  }
  SumEqualRows<N, 0>(rows, in, out, components);
}

template <int N, typename Id, typename In, typename Out>
void SumBlock(const QuadRows<Id>& rows, const In* in, Out* out, int components)
{
  constexpr int width = Width<N>;
  const vtkIdType stride = N == 0 ? components : N;
  double weights[4];
  std::copy_n(rows.Weights, 4, weights);
  Out* result = out + rows.FirstRow * stride;
  Sums<width> sums;
  for (const Id* columns = rows.Columns; columns < rows.Columns + 4 * rows.Count; columns += 16)
  {
    const In* values[4];
    std::transform(columns, columns + 4, values,
      [&](Id column) { return in + stride * static_cast<vtkIdType>(column); });
    for (int row = 0; row < 4; ++row)
    {
      for (int first = 0; first < stride; first += width)
      {
        sums.Clear();
        for (int k = 0; k < 4; ++k)
        {
          sums.Add(weights[k], values[(row + k) % 4] + first);
        }
        sums.Write(result + first);
      }
      result += stride;
    }
  }
}

// ------------------------------------------------------------------------------------------------
// Types of values

/// Applies a block to values of given types. N is the number of components, 0: it is known at run
/// time only.
template <int N, typename In, typename Out>
void ApplyBlock(const RowsView& view, const void* in, void* out, int components)
{
  std::visit([&](const auto& rows)
    { SumBlock<N>(rows, static_cast<const In*>(in), static_cast<Out*>(out), components); }, view);
}
using Applier = void (*)(const RowsView& view, const void* in, void* out, int components);

/// 1 and 3 values of a frequent type, and 4 of packed arrays, have unrolled loops. More cases would
/// cost compile time.
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
    if (components == 4)
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
  PackedArrays packed;
  packed.Take(arrays, operation.GetNumberOfRows());
  packed.Start(arrays, operation.GetNumberOfRows(), false);
  ApplyToArrays(operation, packed, std::move(arrays), also);
}

void ApplyToArrays(const PointOperator& operation, PackedArrays& packed,
  std::vector<MovedArray> arrays, const PointOperator::User& also)
{
  arrays.erase(
    std::remove_if(arrays.begin(), arrays.end(), [](const MovedArray& array) { return !array.In; }),
    arrays.end());
  std::vector<Applier> appliers;
  std::transform(arrays.begin(), arrays.end(), std::back_inserter(appliers),
    [](const MovedArray& array) { return FindApplier(array); });
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
  packed.Finish();
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
