// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/KeptNumbers.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Control/StampFields.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{

KeptNumbers::KeptNumbers(vtkPointSet* input, Partners& partners)
  : With(partners)
  , Places(PlaceCells(input, partners))
{
  SharedKeys given;
  given.Keys = partners.GetPointIds();
  given.Own.assign(given.Keys.size(), 1);
  SharedNumbers numbers = NumberTogether(given, partners);
  this->Points = std::move(numbers.First);
  this->Total = numbers.Totals[0];
}

void KeptNumbers::Add(const RedStep& step, const ShapedCells& before, const Ids& sources)
{
  const auto& offsets = step.Rows.Offsets;
  const vtkIdType rows = offsets.size() - 1;
  std::vector<char> own(static_cast<std::size_t>(rows), 0);
  const long long* corner = step.Children.Corners.data();
  for (std::size_t c = 0; c < step.Children.Shapes.size(); ++c)
  {
    const bool isOwn = this->With.IsOwn(sources[static_cast<std::size_t>(step.Parents[c])]);
    const int corners = GetNumberOfCorners(step.Children.Shapes[c]);
    for (int k = 0; k < corners; ++k, ++corner)
    {
      own[static_cast<std::size_t>(*corner)] |= isOwn ? 1 : 0;
    }
  }
  // Middles of edges, then of quads, then of hexahedra.
  auto row = static_cast<vtkIdType>(this->Points.size());
  for (const int corners : { 2, 4 })
  {
    const vtkIdType first = row;
    while (row < rows && offsets[row + 1] - offsets[row] == corners)
    {
      ++row;
    }
    this->AddMeans(step, first, row, corners, own);
  }
  this->AddCentres(before, sources);
}

void KeptNumbers::AddMeans(
  const RedStep& step, vtkIdType first, vtkIdType last, int corners, const std::vector<char>& own)
{
  SharedKeys means;
  means.Width = corners;
  Ids key(static_cast<std::size_t>(corners));
  for (vtkIdType row = first; row < last; ++row)
  {
    const long long* columns = step.Rows.Columns.data() + step.Rows.Offsets[row];
    std::transform(columns, columns + corners, key.begin(),
      [this](long long point) { return this->Points[static_cast<std::size_t>(point)]; });
    std::sort(key.begin(), key.end());
    means.Own.push_back(own[static_cast<std::size_t>(row)] && key[0] >= 0);
    std::replace(key.begin(), key.end(), vtkIdType(-1), vtkIdType(0));
    means.Keys.insert(means.Keys.end(), key.begin(), key.end());
  }
  this->Take(NumberTogether(means, this->With));
}

void KeptNumbers::AddCentres(const ShapedCells& before, const Ids& sources)
{
  Ids hexes;
  for (std::size_t c = 0; c < before.Shapes.size(); ++c)
  {
    if (before.Shapes[c] == CellShape::Hex)
    {
      hexes.push_back(sources[c]);
    }
  }
  this->Take(NumberTogether(MakeKeysOfPieces(hexes, this->Places, this->With), this->With));
}

void KeptNumbers::Take(const SharedNumbers& numbers)
{
  for (const vtkIdType number : InTurn(numbers.First))
  {
    this->Points.push_back(number < 0 ? -1 : this->Total + number);
  }
  this->Total += numbers.Totals[0];
}

void KeptNumbers::Write(const Ids& sources, vtkUnstructuredGrid* output) const
{
  // The cells of an input cell follow one another.
  SharedKeys inputs;
  Ids starts;
  for (std::size_t c = 0; c < sources.size(); ++c)
  {
    if (c == 0 || sources[c] != sources[c - 1])
    {
      inputs.Keys.push_back(this->Places[static_cast<std::size_t>(sources[c])]);
      inputs.Own.push_back(this->With.IsOwn(sources[c]));
      inputs.Sizes.push_back(0);
      starts.push_back(static_cast<vtkIdType>(c));
    }
    ++inputs.Sizes.back();
  }
  const SharedNumbers numbers = NumberTogether(inputs, this->With);
  Ids cells(sources.size(), -1);
  for (const std::size_t i : InTurn(starts.size()))
  {
    for (vtkIdType k = 0; k < inputs.Sizes[i] && numbers.First[i] >= 0; ++k)
    {
      cells[static_cast<std::size_t>(starts[i] + k)] = numbers.First[i] + k;
    }
  }
  output->GetPointData()->AddArray(MakeField<vtkIdTypeArray>(PointNumbersName, this->Points));
  output->GetCellData()->AddArray(MakeField<vtkIdTypeArray>(CellNumbersName, cells));
}

}
