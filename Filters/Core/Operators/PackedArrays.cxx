// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/PackedArrays.h"

#include "Core/Memory/Store.h"
#include "Core/Operators/ForBlocks.h"

#include "vtkType.h"

#include <algorithm>
#include <type_traits>

namespace subdivision
{
namespace
{

/// act(a value of the type) for the types that are packed: they are exact in double.
template <typename Act>
void WithType(int type, const Act& act)
{
  switch (type)
  {
    case VTK_DOUBLE:
      act(double());
      break;
    case VTK_FLOAT:
      act(float());
      break;
    default:
      act(static_cast<unsigned char>(0));
      break;
  }
}

/// act(components), a number that the compiler knows.
template <typename Act>
void WithComponents(int components, const Act& act)
{
  switch (components)
  {
    case 1:
      act(std::integral_constant<int, 1>());
      break;
    case 2:
      act(std::integral_constant<int, 2>());
      break;
    case 3:
      act(std::integral_constant<int, 3>());
      break;
    default:
      act(std::integral_constant<int, 4>());
      break;
  }
}

/// Rows [begin, begin + count) of a block. Their results have the numbers from 0 on.
CopiedRows Cut(const CopiedRows& rows, vtkIdType begin, vtkIdType count)
{
  return { 0, count, rows.FirstColumn + begin };
}
RowsOfFour Cut(const RowsOfFour& rows, vtkIdType begin, vtkIdType count)
{
  return { 0, count, rows.Rows + begin };
}
template <typename Id>
WeightedRows<Id> Cut(const WeightedRows<Id>& rows, vtkIdType begin, vtkIdType count)
{
  WeightedRows<Id> part = rows;
  part.FirstRow = 0;
  part.Count = count;
  part.Offsets += begin;
  part.Numbers = nullptr;
  return part;
}
template <typename Id>
EqualRows<Id> Cut(const EqualRows<Id>& rows, vtkIdType begin, vtkIdType count)
{
  return { 0, count, rows.Size, rows.Columns + rows.Size * begin, rows.Weights };
}
template <typename Id>
RingRows<Id> Cut(const RingRows<Id>& rows, vtkIdType begin, vtkIdType count)
{
  RingRows<Id> part = rows;
  part.FirstRow = 0;
  part.RowsBefore += rows.FirstRow + begin;
  part.Count = count;
  if (rows.OfCentres)
  {
    part.Members += RingRows<Id>::CentreSize * begin;
    return part;
  }
  part.Strata += begin;
  part.Ends += rows.OfEdges ? 2 * begin : 0;
  part.Offsets += begin;
  part.NumberOfCounted = std::max<vtkIdType>(0, rows.NumberOfCounted - begin);
  part.Columns += rows.Columns ? begin : 0;
  return part;
}

template <typename Rows>
const int* GetNumbers(const Rows&)
{
  return nullptr;
}
template <typename Id>
const Id* GetNumbers(const WeightedRows<Id>& rows)
{
  return rows.Numbers;
}

}

bool PackedArrays::CanBePacked(const MovedArray& array, vtkIdType rows)
{
  constexpr vtkIdType rowsOfColumn = 3; // below, copies cost more than they save
  const auto isExact = [](int type)
  { return type == VTK_DOUBLE || type == VTK_FLOAT || type == VTK_UNSIGNED_CHAR; };
  return array.Tuples > 0 && rowsOfColumn * array.Tuples <= rows && array.Components <= Lanes &&
    isExact(array.InType) && isExact(array.OutType);
}

PackedArrays::PackedArrays(const PointOperator& operation, std::vector<MovedArray>& arrays)
{
  std::vector<MovedArray> left;
  for (const MovedArray& array : arrays)
  {
    if (!CanBePacked(array, operation.GetNumberOfRows()))
    {
      left.push_back(array);
      continue;
    }
    const auto pack = std::find_if(this->Packs.begin(), this->Packs.end(), [&](const Pack& p)
      { return p.Size + array.Components <= Lanes && p.Arrays[0].Tuples == array.Tuples; });
    Pack& fitting = pack == this->Packs.end() ? this->Packs.emplace_back() : *pack;
    fitting.Arrays.push_back(array);
    fitting.Size += array.Components;
  }
  const auto isSingle = [](const Pack& pack) { return pack.Arrays.size() < 2; };
  for (const Pack& pack : this->Packs)
  {
    if (isSingle(pack))
    {
      left.push_back(pack.Arrays[0]);
    }
  }
  this->Packs.erase(
    std::remove_if(this->Packs.begin(), this->Packs.end(), isSingle), this->Packs.end());
  for (Pack& pack : this->Packs)
  {
    Fill(pack);
    for (MovedArray& array : pack.Arrays)
    {
      array.In = nullptr;
      array.Owner = nullptr;
    }
  }
  arrays = std::move(left); // which lets go of the others
}

void PackedArrays::Fill(Pack& pack)
{
  const vtkIdType columns = pack.Arrays[0].Tuples;
  pack.Values = Buffer<double>(Lanes * columns);
  ForRanges(columns,
    [&pack](vtkIdType begin, vtkIdType end)
    {
      int lane = 0;
      for (const MovedArray& array : pack.Arrays)
      {
        WithType(array.InType,
          [&](auto value)
          {
            const int components = array.Components;
            const auto* in = static_cast<const decltype(value)*>(array.In) + components * begin;
            for (vtkIdType i = begin; i < end; ++i)
            {
              for (int c = 0; c < components; ++c)
              {
                pack.Values[Lanes * i + lane + c] = static_cast<double>(*in++);
              }
            }
          });
        lane += array.Components;
      }
      for (vtkIdType i = begin; i < end && lane < Lanes; ++i)
      {
        std::fill_n(pack.Values.data() + Lanes * i + lane, Lanes - lane, 0.);
      }
    });
}

/// Stores sums as values of rows `numbers`, or of those from `first` on.
template <typename Id>
void PackedArrays::Store(
  const Pack& pack, const double* sums, vtkIdType first, const Id* numbers, vtkIdType count)
{
  for (const MovedArray& array : pack.Arrays)
  {
    WithType(array.OutType,
      [&](auto value)
      {
        using Out = decltype(value);
        WithComponents(array.Components,
          [&](auto components)
          {
            constexpr int size = decltype(components)::value;
            Out* out = static_cast<Out*>(array.Out);
            for (vtkIdType i = 0; i < count; ++i)
            {
              const vtkIdType row = numbers ? static_cast<vtkIdType>(numbers[i]) : first + i;
              for (int c = 0; c < size; ++c)
              {
                out[size * row + c] = subdivision::Store<Out>(sums[Lanes * i + c]);
              }
            }
          });
      });
    sums += array.Components;
  }
}

void PackedArrays::Apply(const RowsView& view) const
{
  if (this->Packs.empty())
  {
    return;
  }
  std::visit(
    [this](const auto& rows)
    {
      ForBlocks(0, rows.Count,
        [&](vtkIdType begin, vtkIdType end)
        {
          double sums[Lanes * BlockSize];
          const auto* numbers = GetNumbers(rows);
          for (const Pack& pack : this->Packs)
          {
            SumRows(Cut(rows, begin, end - begin), pack.Values.data(), sums, Lanes);
            Store(
              pack, sums, rows.FirstRow + begin, numbers ? numbers + begin : nullptr, end - begin);
          }
        });
    },
    view);
}

}
