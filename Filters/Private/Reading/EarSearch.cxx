// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/EarSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{

// ------------------------------------------------------------------------------------------------

void FirstOfLeast::Reset(vtkIdType size)
{
  for (this->Leaves = 1; this->Leaves < size;)
  {
    this->Leaves *= 2;
  }
  this->Least.assign(2 * this->Leaves, std::numeric_limits<double>::infinity());
}

void FirstOfLeast::Set(vtkIdType place, double value)
{
  vtkIdType node = this->Leaves + place;
  this->Least[node] = value;
  for (node /= 2; node > 0; node /= 2)
  {
    this->Least[node] = std::min(this->Least[2 * node], this->Least[2 * node + 1]);
  }
}

vtkIdType FirstOfLeast::FindFirst(double value, vtkIdType from) const
{
  // Up to the first subtree from `from` on that has such a value, then down to its first leaf.
  vtkIdType node = from < this->Leaves ? this->Leaves + from : 0;
  while (node > 0 && this->Least[node] > value)
  {
    while (node % 2 == 1)
    {
      node /= 2;
    }
    node += node > 0 ? 1 : 0;
  }
  if (node == 0)
  {
    return -1;
  }
  while (node < this->Leaves)
  {
    node = this->Least[2 * node] <= value ? 2 * node : 2 * node + 1;
  }
  return node - this->Leaves;
}

// ------------------------------------------------------------------------------------------------

EarTriangle::EarTriangle(const double* a, const double* b, const double* c, double leastSine)
  : Sides{ { a, b, Distance2(a, b) }, { b, c, Distance2(b, c) }, { c, a, Distance2(c, a) } }
  , LeastSine(leastSine)
{
}

void EarTriangle::Bound()
{
  double longest2 = 0.;
  double smallest = 1.; // sine
  for (int i = 0; i < 3; ++i)
  {
    const Side& side = this->Sides[i];
    const Side& before = this->Sides[(i + 2) % 3];
    smallest = std::min(
      smallest, Cross2(before.From, side.From, side.To) / std::sqrt(before.Length2 * side.Length2));
    longest2 = std::max(longest2, side.Length2);
  }
  // A contained point outside is near the extension of a side: seen from the ends of the side it
  // is up to this sine beyond it, and from another one at least `smallest` less that sine.
  this->HasBox = smallest > 3. * this->LeastSine;
  const double margin = this->HasBox
    ? 2. * std::sqrt(longest2) * this->LeastSine / (smallest - 2. * this->LeastSine)
    : 0.;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double x[] = { this->Sides[0].From[axis], this->Sides[1].From[axis],
      this->Sides[2].From[axis] };
    this->Low[axis] = std::min({ x[0], x[1], x[2] }) - margin;
    this->High[axis] = std::max({ x[0], x[1], x[2] }) + margin;
  }
}

bool EarTriangle::Contains(const double* point) const
{
  for (const Side& side : this->Sides)
  {
    const double toPoint2 = Distance2(side.From, point);
    if (toPoint2 == 0. ||
      -Cross2(side.From, side.To, point) > this->LeastSine * std::sqrt(side.Length2 * toPoint2))
    {
      return false;
    }
  }
  return true;
}

bool EarTriangle::IsBeyond(const double* low, const double* high) const
{
  if (this->HasBox &&
    (low[0] > this->High[0] || high[0] < this->Low[0] || low[1] > this->High[1] ||
      high[1] < this->Low[1]))
  {
    return true;
  }
  constexpr double certain = 1.0001; // more than what rounding can change
  for (const Side& side : this->Sides)
  {
    double nearest = -std::numeric_limits<double>::infinity();
    double farthest2 = 0.;
    for (const double x : { low[0], high[0] })
    {
      for (const double y : { low[1], high[1] })
      {
        const double corner[2] = { x, y };
        nearest = std::max(nearest, Cross2(side.From, side.To, corner));
        farthest2 = std::max(farthest2, Distance2(side.From, corner));
      }
    }
    if (-nearest > certain * this->LeastSine * std::sqrt(side.Length2 * farthest2))
    {
      return true;
    }
  }
  return false;
}

// ------------------------------------------------------------------------------------------------

void PlanePoints::Reset(std::vector<std::array<double, 2>> points)
{
  this->Points = std::move(points);
  const auto size = static_cast<vtkIdType>(this->Points.size());
  this->Order.resize(this->Points.size());
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Order[i] = i;
  }
  this->Leaf.resize(this->Points.size());
  this->Nodes.clear();
  this->Build(0, size, -1);
}

/// Appends the node of a range of Order, and its children. Returns its number.
vtkIdType PlanePoints::Build(vtkIdType begin, vtkIdType end, vtkIdType parent)
{
  constexpr vtkIdType most = 8; // points in a leaf
  const auto number = static_cast<vtkIdType>(this->Nodes.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Node node{ { infinity, infinity }, { -infinity, -infinity }, begin, end, end - begin, parent, 0 };
  for (vtkIdType i = begin; i < end; ++i)
  {
    const std::array<double, 2>& x = this->Points[this->Order[i]];
    for (int axis = 0; axis < 2; ++axis)
    {
      node.Low[axis] = std::min(node.Low[axis], x[axis]);
      node.High[axis] = std::max(node.High[axis], x[axis]);
    }
    this->Leaf[this->Order[i]] = number; // those of leaves are set last
  }
  this->Nodes.push_back(node);
  if (end - begin > most)
  {
    const int axis = node.High[0] - node.Low[0] < node.High[1] - node.Low[1] ? 1 : 0;
    const vtkIdType middle = begin + (end - begin) / 2;
    std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle,
      this->Order.begin() + end, [this, axis](vtkIdType a, vtkIdType b)
      { return this->Points[a][axis] < this->Points[b][axis]; });
    this->Build(begin, middle, number);
    const vtkIdType second = this->Build(middle, end, number);
    this->Nodes[number].Second = second;
  }
  return number;
}

void PlanePoints::Remove(vtkIdType point)
{
  vtkIdType node = this->Leaf[point];
  const auto begin = this->Order.begin() + this->Nodes[node].Begin;
  const auto end = this->Order.begin() + this->Nodes[node].End;
  *std::find(begin, end, point) = -1;
  for (; node >= 0; node = this->Nodes[node].Parent)
  {
    --this->Nodes[node].Left;
  }
}

bool PlanePoints::HasAnyIn(
  const EarTriangle& triangle, const std::array<vtkIdType, 3>& corners) const
{
  vtkIdType waiting[64]; // second children: the depth is the logarithm of the number of points
  int depth = 0;
  waiting[depth++] = 0;
  while (depth > 0)
  {
    const vtkIdType number = waiting[--depth];
    const Node& node = this->Nodes[number];
    if (node.Left == 0 || triangle.IsBeyond(node.Low, node.High))
    {
      continue;
    }
    if (node.Second > 0)
    {
      waiting[depth++] = node.Second;
      waiting[depth++] = number + 1;
      continue;
    }
    for (vtkIdType i = node.Begin; i < node.End; ++i)
    {
      const vtkIdType point = this->Order[i];
      if (point >= 0 && point != corners[0] && point != corners[1] && point != corners[2] &&
        triangle.Contains(this->Points[point].data()))
      {
        return true;
      }
    }
  }
  return false;
}

}
