// SPDX-License-Identifier: BSD-3-Clause
#include "HangingTools.h"

namespace hanging_tools
{

vtkIdType Builder::Find(const Point& place)
{
  const auto found = this->Ids.emplace(place, static_cast<vtkIdType>(this->Places.size()));
  if (found.second)
  {
    this->Places.push_back(place);
  }
  return found.first->second;
}

void Builder::Add(int type, const std::vector<Point>& places)
{
  Cell cell{ type, {} };
  for (const Point& place : places)
  {
    cell.Points.push_back(this->Find(place));
  }
  this->Cells.push_back(cell);
}

void Builder::AddBox(int type, const Point& low, double side)
{
  static const int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  std::vector<Point> places;
  for (int i = 0; i < (type == VTK_QUAD ? 4 : 8); ++i)
  {
    const int* c = corners[type == VTK_VOXEL && i % 4 > 1 ? i ^ 1 : i];
    places.push_back({ low[0] + side * c[0], low[1] + side * c[1], low[2] + side * c[2] });
  }
  this->Add(type, places);
}

Grid MakeTree(int type, int depth)
{
  Builder builder;
  const int planes = type == VTK_QUAD ? 1 : 2;
  double side = 1.;
  for (int level = 0; level <= depth; ++level, side /= 2.)
  {
    for (int i = 0; i < 4 * planes; ++i)
    {
      const int at[3] = { i % 2, i / 2 % 2, i / 4 };
      if (i > 0 || level == depth)
      {
        builder.AddBox(type, { side * at[0], side * at[1], side * at[2] }, side);
      }
    }
  }
  return builder.Make();
}

Grid MakeTJunction(int size)
{
  std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0.2 } };
  std::vector<Cell> cells = { { VTK_TRIANGLE, { 0, 1, 2 } } };
  vtkIdType last = 0;
  for (int i = 1; i <= size; ++i)
  {
    points.push_back({ static_cast<double>(i) / (size + 1), 0, 0 });
    cells.push_back({ VTK_TRIANGLE, { 3 + i, last, 3 } });
    last = 3 + i;
  }
  cells.push_back({ VTK_TRIANGLE, { 1, last, 3 } });
  return MakeGrid(points, cells);
}

std::vector<std::string> Tell(vtkDataObject* input, int levels, const Configure& configure)
{
  vtkNew<Messages> messages;
  Execute(input, levels, configure, messages);
  return messages->Warnings;
}

bool Has(const std::vector<std::string>& warnings, const std::string& part)
{
  return warnings.size() == 1 && warnings[0].find(part) != std::string::npos;
}

}
