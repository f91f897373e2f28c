// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LimitRowMaker.h"

#include "Core/Rules/Masks.h"
#include "Core/Solids/Complex/Simplices.h"

namespace subdivision
{
namespace
{

/// The star of a vertex of a Level (LimitRowMaker.h): its items are its edges.
template <typename Id>
class LevelStar
{
public:
  using IdType = Id;
  using LevelType = Level<Id>;

  explicit LevelStar(const Level<Id>& level)
    : Here(level)
  {
  }
  StarRules<Id> GetRules() const { return { this->Here.Strata, nullptr }; }
  Id GetFarEnd(Id vertex, Id edge) const { return this->Here.Complex.OtherEnd(edge, vertex); }

  /// The numbers of a row are the rule, the size of the ring, and the ring.
  template <typename Number>
  bool ReadRow(const StarRules<Id>& rules, Id vertex, Id edge, bool first, Neighbourhood& rows,
    const Number& number) const
  {
    const auto& strata = rules.Strata;
    const Stratum stratum = edge < 0 ? strata.Vertices[vertex] : strata.Edges[edge];
    rows.push_back(static_cast<int>(stratum.GetRule()));
    const std::size_t size = rows.size();
    rows.push_back(0);
    bool all = true;
    if (edge < 0)
    {
      for (Id spoke : strata.VertexRings.GetCarriers(vertex))
      {
        rows.push_back(number(spoke, this->GetFarEnd(vertex, spoke)));
      }
    }
    else
    {
      const Id* member = strata.EdgeRings.GetMembers(edge).begin();
      for (Id face : strata.EdgeRings.GetCarriers(edge))
      {
        if (face >= 0 || first)
        {
          rows.push_back(
            number(face < 0 ? Id(-1) : this->Here.Complex.OtherEdge(face, edge, vertex), *member));
        }
        all = all && (face >= 0 || first);
        ++member;
      }
    }
    rows[size] = static_cast<int>(rows.size() - size - 1);
    return all;
  }

  template <typename Add>
  static void Weigh(const int*& row, int item, const Add& add)
  {
    const Rule rule = static_cast<Rule>(row[0]);
    const int size = row[1];
    const Mask mask = item == 0 ? VertexMask(rule, size) : EdgeMask(rule, size);
    add(0, item == 0 && size == 0 ? 1. : mask.Own);
    if (item > 0)
    {
      add(item, mask.Own);
    }
    row += 2;
    for (int k = 0; k < size; ++k)
    {
      add(*row++, mask.Ring);
    }
  }

private:
  const Level<Id>& Here;
};

}

template <typename Id>
SparseRows<Id> BuildLimitRows(const Level<Id>& level, const SemiSharpStages<Id>& creases)
{
  return MakeLimitRows<LevelStar<Id>>(
    level, creases, level.Complex.NumberOfVertices, [](vtkIdType i) { return static_cast<Id>(i); });
}

template <typename Id>
SparseRows<Id> BuildLimitRows(
  const Level<Id>& level, const SemiSharpStages<Id>& creases, const Buffer<Id>& vertices)
{
  return MakeLimitRows<LevelStar<Id>>(
    level, creases, vertices.size(), [&vertices](vtkIdType i) { return vertices[i]; });
}

#define SUBDIVISION_LIMIT(Id)                                                                      \
  template SparseRows<Id> BuildLimitRows(const Level<Id>&, const SemiSharpStages<Id>&);            \
  template SparseRows<Id> BuildLimitRows(                                                          \
    const Level<Id>&, const SemiSharpStages<Id>&, const Buffer<Id>&)
SUBDIVISION_LIMIT(int);
SUBDIVISION_LIMIT(long long);

}
