// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreenFew.h"

namespace redgreen_reference
{

SimplexList MakeList(vtkIdType points, const std::vector<Tuple>& cells)
{
  SimplexList list;
  list.NumberOfPoints = points;
  for (const Tuple& cell : cells)
  {
    list.Dimensions.push_back(static_cast<unsigned char>(cell.size() - 1));
    list.Connectivity.insert(list.Connectivity.end(), cell.begin(), cell.end());
  }
  return list;
}

Few::Few(vtkIdType points, const std::vector<Tuple>& cells)
  : List(MakeList(points, cells))
  , State(SimplexView(this->List))
  , Points(3 * static_cast<std::size_t>(points))
{
}

std::vector<int> Few::Count()
{
  const auto written = Write(this->State, this->Points);
  std::vector<int> counts(5);
  for (const unsigned char kind : written.Kinds)
  {
    ++counts[kind];
  }
  EXPECT_EQ(this->State.GetNumberOfCells(), static_cast<vtkIdType>(written.Kinds.size()));
  return counts;
}

int Few::FindMiddle(int a, int b) const
{
  for (int v = this->State.GetNumberOfInputVertices(); v < this->State.GetNumberOfVertices(); ++v)
  {
    const auto ends = this->State.GetEnds(v);
    if (std::minmax(ends[0], ends[1]) == std::minmax(a, b))
    {
      return v;
    }
  }
  return -1;
}

int Few::CountStored()
{
  const int size = static_cast<int>(this->State.GetNumberOfInputCells());
  this->State.MarkCell({ size - 1, -1 });
  this->State.MarkCell({ size - 1, 0 });
  for (int stored = 0; stored < 200; ++stored)
  {
    const int first = size + stored + 1; // the triangle itself is stored in front of its children
    bool isThere = true;
    for (int child = 0; child < 4 && isThere; ++child)
    {
      const auto cell = this->State.GetCell(first + child);
      isThere = cell.Parent == size - 1 && cell.Child == child && cell.Level == 1;
    }
    if (isThere)
    {
      return stored;
    }
  }
  return -1;
}

int CountHalvings(const RedGreen<int>& state, int vertex)
{
  if (vertex < state.GetNumberOfInputVertices())
  {
    return 0;
  }
  const auto ends = state.GetEnds(vertex);
  return 1 + std::max(CountHalvings(state, ends[0]), CountHalvings(state, ends[1]));
}

}
