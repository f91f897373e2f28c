// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTools.h"

namespace coretest
{

vtkIdType Mesh::AddPoint(double x, double y, double z)
{
  this->Points.push_back(x);
  this->Points.push_back(y);
  this->Points.push_back(z);
  return this->Cells.NumberOfPoints++;
}

void Mesh::AddPoints(std::initializer_list<std::array<double, 3>> points)
{
  for (const auto& p : points)
  {
    this->AddPoint(p[0], p[1], p[2]);
  }
}

void Mesh::AddCells(std::initializer_list<Tuple> cells)
{
  for (const Tuple& cell : cells)
  {
    this->AddCell(cell);
  }
}

std::vector<Tuple> GetCells(const SimplexList& list)
{
  std::vector<Tuple> cells;
  auto next = list.Connectivity.begin();
  for (unsigned char dimension : list.Dimensions)
  {
    cells.emplace_back(next, next + dimension + 1);
    next += dimension + 1;
  }
  return cells;
}

SimplexList WrittenCells::ToList(vtkIdType numberOfPoints) const
{
  SimplexList list;
  list.NumberOfPoints = numberOfPoints;
  for (std::size_t i = 0; i + 1 < this->Offsets.size(); ++i)
  {
    const auto corners = this->Offsets[i + 1] - this->Offsets[i];
    list.Dimensions.push_back(static_cast<unsigned char>(corners - 1));
  }
  list.Connectivity.assign(this->Connectivity.begin(), this->Connectivity.end());
  return list;
}

}
