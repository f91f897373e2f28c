// SPDX-License-Identifier: BSD-3-Clause
// What a LocalLimit does with its steps when they are made: values, normals, rows.
#include "Core/Solids/Limits/LocalLimit.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace subdivision
{

/// How many values the even levels, and how many the odd levels have at most. Levels of one kind
/// use the same memory, as no two of them are needed at a time.
template <typename Id>
std::array<vtkIdType, 2> LocalLimit<Id>::GetSizesBetween() const
{
  std::array<vtkIdType, 2> sizes{ { 0, 0 } };
  for (std::size_t l = 0; l < this->Steps.size(); ++l)
  {
    sizes[l % 2] = std::max(sizes[l % 2], this->Steps[l].Rows.GetNumberOfRows());
  }
  return sizes;
}

template <typename Id>
vtkIdType LocalLimit<Id>::GetNumberBetween() const
{
  const auto sizes = this->GetSizesBetween();
  return sizes[0] + sizes[1];
}

template <typename Id>
void LocalLimit<Id>::ForEachBlock(const User& use) const
{
  const vtkIdType starts[2] = { 0, this->GetSizesBetween()[0] };
  for (std::size_t l = 0; l < this->Steps.size(); ++l)
  {
    const Step& step = this->Steps[l];
    ForBlocksInThreads(step.Rows.GetNumberOfRows(),
      [&](vtkIdType begin, vtkIdType end)
      {
        WeightedRows<Id> rows = step.Rows.GetRows(begin, end);
        rows.FirstRow += starts[l % 2];
        rows.ToBetween = true;
        rows.FromBetween = !step.IsFirst;
        rows.FirstColumn = step.IsFirst ? 0 : starts[(l - 1) % 2];
        use(rows);
      });
    ForBlocksInThreads(step.Limits.GetNumberOfRows(),
      [&](vtkIdType begin, vtkIdType end)
      {
        WeightedRows<Id> rows = step.Limits.GetRows(begin, end);
        rows.Numbers = step.Vertices.data() + begin;
        rows.FromBetween = true;
        rows.FirstColumn = starts[l % 2];
        use(rows);
      });
  }
}

template <typename Id>
SparseRows<Id> LocalLimit<Id>::BuildRows() const
{
  std::vector<SparseRows<Id>> parts;
  SparseRows<Id> product;
  const SparseRows<Id>* before = nullptr; // the rows of the step before over control values
  for (const Step& step : this->Steps)
  {
    if (!step.IsFirst)
    {
      product = Multiply(step.Rows, *before);
    }
    before = step.IsFirst ? &step.Rows : &product;
    parts.push_back(Multiply(step.Limits, *before));
  }
  SparseRows<Id> rows;
  rows.NumberOfColumns = this->NumberOfColumns;
  rows.Offsets = Buffer<Id>(this->NumberOfRows + 1, 0);
  auto forRows = [&](const auto& act)
  {
    for (std::size_t l = 0; l < parts.size(); ++l)
    {
      const std::vector<Id>& vertices = this->Steps[l].Vertices;
      ForEach(static_cast<vtkIdType>(vertices.size()), [&](vtkIdType i)
        { act(vertices[i], parts[l], parts[l].Offsets[i], parts[l].Offsets[i + 1]); });
    }
  };
  forRows(
    [&](Id row, const SparseRows<Id>&, Id begin, Id end) { rows.Offsets[row] = end - begin; });
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<Id>(rows.Offsets[this->NumberOfRows]);
  rows.Weights = Buffer<double>(rows.Offsets[this->NumberOfRows]);
  forRows(
    [&](Id row, const SparseRows<Id>& part, Id begin, Id end)
    {
      const Id first = rows.Offsets[row];
      std::copy(
        part.Columns.begin() + begin, part.Columns.begin() + end, rows.Columns.begin() + first);
      std::copy(
        part.Weights.begin() + begin, part.Weights.begin() + end, rows.Weights.begin() + first);
    });
  return rows;
}

template <typename Id>
void LocalLimit<Id>::Append(LocalLimit&& others)
{
  std::move(others.Steps.begin(), others.Steps.end(), std::back_inserter(this->Steps));
}

template <typename Id>
vtkIdType LocalLimit<Id>::GetNumberOfSupportValues() const
{
  vtkIdType values = 0;
  for (const Step& step : this->Steps)
  {
    values += step.Rows.GetNumberOfRows();
  }
  return values;
}

template <typename Id>
void LocalLimit<Id>::ComputeNormals(const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned,
  double* normals) const
{
  Buffer<double> values;
  const double* before = points;
  for (const Step& step : this->Steps)
  {
    Buffer<double> next(3 * step.Rows.GetNumberOfRows());
    step.Rows.Apply(before, next.data(), 3);
    values = std::move(next);
    before = values.data();
    const auto size = static_cast<vtkIdType>(step.Vertices.size());
    Buffer<double> own(3 * size);
    ComputeLimitNormals(step.Tangents, { before, points.Tie }, inverted, turned, own.data());
    ForEach(size, [&](vtkIdType i)
      { std::copy_n(own.data() + 3 * i, 3, normals + 3 * vtkIdType(step.Vertices[i])); });
  }
}

SUBDIVISION_COMPILE(class LocalLimit);

}
