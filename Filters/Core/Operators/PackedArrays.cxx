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
QuadRows<Id> Cut(const QuadRows<Id>& rows, vtkIdType begin, vtkIdType count)
{
  static_assert(BlockSize % 4 == 0, "a block has whole quads");
  return { 0, count, rows.Columns + 4 * begin, rows.Weights };
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

bool PackedArrays::CanBePacked(const MovedArray& array)
{
  const auto isExact = [](int type)
  { return type == VTK_DOUBLE || type == VTK_FLOAT || type == VTK_UNSIGNED_CHAR; };
  return array.Tuples > 0 && array.Components <= Lanes && isExact(array.InType) &&
    isExact(array.OutType);
}

void PackedArrays::Take(std::vector<MovedArray>& arrays, vtkIdType rows)
{
  if (!this->IsEmpty())
  {
    return;
  }
  constexpr vtkIdType rowsOfColumn = 3; // below, copies cost more than they save
  for (std::size_t place = 0; place < arrays.size(); ++place)
  {
    const MovedArray& array = arrays[place];
    if (!CanBePacked(array) || rows < rowsOfColumn * array.Tuples)
    {
      continue;
    }
    const auto pack = std::find_if(this->Packs.begin(), this->Packs.end(), [&](const Pack& p)
      { return p.Size + array.Components <= Lanes && p.Arrays[0].Tuples == array.Tuples; });
    Pack& fitting = pack == this->Packs.end() ? this->Packs.emplace_back() : *pack;
    fitting.Arrays.push_back(array);
    fitting.Places.push_back(place);
    fitting.Size += array.Components;
  }
  const auto isSingle = [](const Pack& pack) { return pack.Arrays.size() < 2; };
  this->Packs.erase(
    std::remove_if(this->Packs.begin(), this->Packs.end(), isSingle), this->Packs.end());
  for (Pack& pack : this->Packs)
  {
    Fill(pack);
    for (std::size_t k = 0; k < pack.Arrays.size(); ++k)
    {
      for (MovedArray* array : { &pack.Arrays[k], &arrays[pack.Places[k]] })
      {
        array->In = nullptr;
        array->Owner = nullptr;
      }
    }
  }
}

bool PackedArrays::Has(std::size_t place) const
{
  return std::any_of(this->Packs.begin(), this->Packs.end(), [place](const Pack& pack)
    { return std::find(pack.Places.begin(), pack.Places.end(), place) != pack.Places.end(); });
}

void PackedArrays::Start(const std::vector<MovedArray>& arrays, vtkIdType rows, bool staying)
{
  for (Pack& pack : this->Packs)
  {
    for (std::size_t k = 0; k < pack.Arrays.size(); ++k)
    {
      pack.Arrays[k].Out = arrays[pack.Places[k]].Out;
    }
    pack.Results = Buffer<double>(staying ? Lanes * rows : 0);
  }
}

void PackedArrays::Finish()
{
  const bool areDone = !this->IsEmpty() && this->Packs[0].Results.empty();
  for (Pack& pack : this->Packs)
  {
    pack.Values = std::move(pack.Results);
  }
  if (areDone)
  {
    this->Packs.clear();
  }
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

/// Stores sums as values of rows `numbers`, or of rows from `first` on.
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

/// Rounds results that stay as they would be in their arrays.
template <typename Rows>
void PackedArrays::Round(Pack& pack, const Rows& rows)
{
  double* results = pack.Results.data();
  const auto* numbers = GetNumbers(rows);
  for (const MovedArray& array : pack.Arrays)
  {
    if (array.OutType != VTK_DOUBLE)
    {
      WithType(array.OutType,
        [&](auto value)
        {
          using Out = decltype(value);
          for (vtkIdType i = 0; i < rows.Count; ++i)
          {
            double* row =
              results + Lanes * (numbers ? static_cast<vtkIdType>(numbers[i]) : rows.FirstRow + i);
            std::transform(row, row + array.Components, row,
              [](double sum) { return static_cast<double>(subdivision::Store<Out>(sum)); });
          }
        });
    }
    results += array.Components;
  }
}

template <typename Rows>
void PackedArrays::SumAndStore(const Pack& pack, const Rows& rows)
{
  ForBlocks(0, rows.Count,
    [&](vtkIdType begin, vtkIdType end)
    {
      double sums[Lanes * BlockSize];
      const auto* numbers = GetNumbers(rows);
      SumRows(Cut(rows, begin, end - begin), pack.Values.data(), sums, Lanes);
      Store(pack, sums, rows.FirstRow + begin, numbers ? numbers + begin : nullptr, end - begin);
    });
}

void PackedArrays::Apply(const RowsView& view)
{
  for (Pack& pack : this->Packs)
  {
    if (pack.Results.empty())
    {
      std::visit([&pack](const auto& rows) { SumAndStore(pack, rows); }, view);
      continue;
    }
    SumRows(view, pack.Values.data(), pack.Results.data(), Lanes);
    std::visit([&pack](const auto& rows) { Round(pack, rows); }, view);
  }
}

}
