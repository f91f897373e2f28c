// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreenReference.h"

namespace redgreen_reference
{

Key Middle(const Key& a, const Key& b)
{
  std::map<vtkIdType, double> sum;
  for (const Key* key : { &a, &b })
  {
    for (const auto& entry : *key)
    {
      sum[entry.first] += 0.5 * entry.second;
    }
  }
  return Key(sum.begin(), sum.end());
}

Tuple Support(const std::vector<Key>& points)
{
  std::set<vtkIdType> support;
  for (const Key& point : points)
  {
    for (const auto& entry : point)
    {
      support.insert(entry.first);
    }
  }
  return Tuple(support.begin(), support.end());
}

std::vector<Cell> RedChildren(const Cell& c)
{
  auto m = [&c](int i, int j) { return Middle(c[i], c[j]); };
  if (c.size() == 2)
  {
    return { { c[0], m(0, 1) }, { m(0, 1), c[1] } };
  }
  if (c.size() == 3)
  {
    return { { c[0], m(0, 1), m(0, 2) }, { m(0, 1), c[1], m(1, 2) }, { m(0, 2), m(1, 2), c[2] },
      { m(0, 1), m(1, 2), m(0, 2) } };
  }
  return { { c[0], m(0, 1), m(0, 2), m(0, 3) }, { m(0, 1), c[1], m(1, 2), m(1, 3) },
    { m(0, 2), m(1, 2), c[2], m(2, 3) }, { m(0, 3), m(1, 3), m(2, 3), c[3] },
    { m(0, 1), m(0, 2), m(0, 3), m(1, 3) }, { m(1, 2), m(0, 2), m(0, 1), m(1, 3) },
    { m(0, 2), m(0, 3), m(1, 3), m(2, 3) }, { m(1, 3), m(1, 2), m(0, 2), m(2, 3) } };
}

NaiveRedGreen::NaiveRedGreen(const SimplexList& input)
{
  vtkIdType i = 0;
  for (const Tuple& cell : GetCells(input))
  {
    NaiveLeaf leaf{ i++, 0, {} };
    for (vtkIdType v : cell)
    {
      leaf.Points.push_back({ { v, 1. } });
    }
    this->Leaves.insert(leaf);
  }
}

void NaiveRedGreen::MarkCell(const NaiveLeaf& leaf)
{
  for (const Pair& edge : EdgesOf(leaf.Points))
  {
    this->Splits.insert(edge);
  }
}

void NaiveRedGreen::MarkLater(const Cell& cell)
{
  for (const Pair& edge : EdgesOf(cell))
  {
    this->Pending.push_back(edge);
  }
}

void NaiveRedGreen::MarkEdge(const NaiveLeaf& leaf, const Pair& edge)
{
  for (const NaiveLeaf& other : this->Leaves)
  {
    if (EdgesOf(other.Points).count(edge))
    {
      this->Splits.insert(edge);
      return;
    }
  }
  this->MarkCell(leaf);
  this->Pending.push_back(edge);
}

void NaiveRedGreen::Close()
{
  for (bool again = true; again;)
  {
    while (this->Sweep())
    {
    }
    again = false;
    std::set<Pair> edges;
    for (const NaiveLeaf& leaf : this->Leaves)
    {
      const auto own = EdgesOf(leaf.Points);
      edges.insert(own.begin(), own.end());
    }
    for (const Pair& edge : this->Pending)
    {
      again = (edges.count(edge) && this->Splits.insert(edge).second) || again;
    }
    this->Pending.clear();
  }
}

std::set<Pair> NaiveRedGreen::EdgesOf(const Cell& cell)
{
  std::set<Pair> edges;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      edges.insert(MakePair(cell[i], cell[j]));
    }
  }
  return edges;
}

bool NaiveRedGreen::Sweep()
{
  bool changed = false;
  std::vector<NaiveLeaf> red;
  for (const NaiveLeaf& leaf : this->Leaves)
  {
    const auto edges = EdgesOf(leaf.Points);
    bool all = !edges.empty();
    bool must = false;
    for (const Pair& edge : edges)
    {
      all = all && this->Splits.count(edge) > 0;
      const Key m = Middle(edge.first, edge.second);
      must = must ||
        (this->Splits.count(edge) &&
          (this->IsSplit(edge.first, m) || this->IsSplit(edge.second, m)));
    }
    const Cell& p = leaf.Points;
    const int size = static_cast<int>(p.size());
    for (int i = 0; i < size; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        for (int k = 0; k < j; ++k)
        {
          const int split =
            this->IsSplit(p[i], p[j]) + this->IsSplit(p[j], p[k]) + this->IsSplit(p[i], p[k]);
          if (split == 2)
          {
            this->Splits.insert(MakePair(p[i], p[j]));
            this->Splits.insert(MakePair(p[j], p[k]));
            this->Splits.insert(MakePair(p[i], p[k]));
            changed = true;
          }
          const Key a = Middle(p[i], p[j]);
          const Key b = Middle(p[j], p[k]);
          const Key c = Middle(p[i], p[k]);
          must = must ||
            (split == 3 && (this->IsSplit(a, b) || this->IsSplit(b, c) || this->IsSplit(a, c)));
        }
      }
    }
    if (must && !all)
    {
      this->Splits.insert(edges.begin(), edges.end());
      changed = true;
    }
    if (all)
    {
      red.push_back(leaf);
    }
  }
  for (const NaiveLeaf& leaf : red)
  {
    this->Leaves.erase(leaf);
    for (const Cell& child : RedChildren(leaf.Points))
    {
      this->Leaves.insert({ leaf.Input, leaf.Level + 1, child });
    }
  }
  return changed || !red.empty();
}

double Determinant(const Matrix4& m, int size, int row, unsigned int used)
{
  if (row >= std::min(size, 4))
  {
    return 1.;
  }
  double sum = 0.;
  double sign = 1.;
  for (int column = 0; column < size; ++column)
  {
    if ((used >> column & 1u) == 0)
    {
      if (m[row][column] != 0.)
      {
        sum += sign * m[row][column] * Determinant(m, size, row + 1, used | 1u << column);
      }
      sign = -sign;
    }
  }
  return sum;
}

Matrix4 Coordinates(const Cell& points, const Tuple& simplex)
{
  Matrix4 rows{};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (const auto& entry : points[i])
    {
      rows[i][std::find(simplex.begin(), simplex.end(), entry.first) - simplex.begin()] +=
        entry.second;
    }
  }
  return rows;
}

}
