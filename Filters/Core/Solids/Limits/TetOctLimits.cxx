// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LimitRowMaker.h"

#include "Core/Rules/Masks.h"
#include "Core/Solids/TetOct/TetOctRingEmitter.h"

namespace subdivision
{
namespace
{

/// Numbers beyond Rule for rows of two kinds: of the centres of octahedra, and of control vertices
/// with d = 3. The latter have behind the ring the number of tetrahedra at the edge to each member.
constexpr int CentreRow = 16;
constexpr int ControlRow = 17;

/// The star of a vertex of a TetOctLevel (LimitRowMaker.h): its items are its edges and octahedra.
/// The key of octahedron o is NumberOfEdges + o.
template <typename Id>
class TetOctStar
{
public:
  using IdType = Id;
  using LevelType = TetOctLevel<Id>;

  explicit TetOctStar(const TetOctLevel<Id>& level)
    : Here(level)
  {
  }
  StarRules<Id> GetRules() const { return { this->Here.Strata, this->Here.TetsAtSpokes.get() }; }
  Id GetFarEnd(Id vertex, Id key) const
  {
    const Id oct = key - this->Here.Complex.NumberOfEdges;
    return oct < 0 ? this->Here.Complex.OtherEnd(key, vertex) : this->GetOpposite(oct, vertex);
  }

  /// The numbers of a row are the rule, or one of the two above, the size of the ring, and the
  /// ring.
  template <typename Number>
  bool ReadRow(const StarRules<Id>& rules, Id vertex, Id key, bool first, Neighbourhood& rows,
    const Number& number) const
  {
    const std::size_t start = rows.size();
    rows.resize(start + 2);
    auto add = [&](Id member) { rows.push_back(number(member, this->GetFarEnd(vertex, member))); };
    bool all = true;
    if (key < 0)
    {
      this->ReadVertexRow(rules, vertex, rows, add);
      return true;
    }
    if (key >= this->Here.Complex.NumberOfEdges)
    {
      rows[start] = CentreRow;
      const Id oct = key - this->Here.Complex.NumberOfEdges;
      const int own = VertexInOct(this->Here, oct, vertex);
      for (int other = 0; other < 6; ++other)
      {
        if (other / 2 != own / 2)
        {
          add(this->EdgeInOct(oct, own, other));
        }
      }
    }
    else
    {
      rows[start] = static_cast<int>(rules.Strata.Edges[key].GetRule());
      all = this->ReadEdgeRow(rules.Strata, vertex, key, first, rows, number, add);
    }
    rows[start + 1] = static_cast<int>(rows.size() - start) - 2;
    return all;
  }

  template <typename Add>
  static void Weigh(const int*& row, int item, const Add& add)
  {
    const int kind = row[0];
    const int size = row[1];
    const int* ring = row + 2;
    row = ring + size;
    if (kind == CentreRow)
    {
      add(0, 1. / 6.);
      add(item, 1. / 6.);
      std::for_each(ring, row, [&](int member) { add(member, 1. / 6.); });
      return;
    }
    if (kind == ControlRow)
    {
      const int* tets = row;
      row += size;
      const double all = std::accumulate(tets, row, 0.) / 3.;
      add(0, tetoct::TetVertexOwn);
      for (int k = 0; k < size; ++k)
      {
        add(ring[k], tetoct::TetVertexOther * static_cast<double>(tets[k]) / all);
      }
      return;
    }
    const Rule rule = static_cast<Rule>(kind);
    const PartedMask mask = item == 0 ? TetOctVertexMask(rule, size) : TetOctEdgeMask(rule, size);
    add(0, mask.Own);
    if (item > 0)
    {
      add(item, mask.Own);
    }
    for (int part = 0; part < mask.Parts; ++part)
    {
      for (vtkIdType k = 0; k < mask.Sizes[part]; ++k)
      {
        add(*ring++, mask.Weights[part]);
      }
    }
  }

private:
  Id GetOpposite(Id oct, Id vertex) const
  {
    const int own = VertexInOct(this->Here, oct, vertex);
    return this->Here.OctVertices[6 * vtkIdType(oct) + octahedron::Opposite(own)];
  }
  Id EdgeInOct(Id oct, int a, int b) const
  {
    return this->Here.OctEdges[12 * vtkIdType(oct) + octahedron::EdgeOf[a][b]];
  }

  /// Appends the row of the vertex itself: members at edges, then members in octahedra.
  template <typename Add>
  void ReadVertexRow(
    const StarRules<Id>& rules, Id vertex, Neighbourhood& rows, const Add& add) const
  {
    const std::size_t start = rows.size() - 2;
    const Rule rule = rules.Strata.Vertices[vertex].GetRule();
    const Row<Id> ring = rules.Strata.VertexRings.GetCarriers(vertex);
    const bool isControl = vertex < this->Here.NumberOfControlVertices;
    const Id* firstOct = ring.end() - CountOpposites(rule, ring.size(), isControl);
    std::for_each(ring.begin(), firstOct, add);
    std::for_each(
      firstOct, ring.end(), [&](Id oct) { add(this->Here.Complex.NumberOfEdges + oct); });
    rows[start] = static_cast<int>(rule);
    rows[start + 1] = static_cast<int>(ring.size());
    if (isControl && rule == Rule::Solid)
    {
      rows[start] = ControlRow;
      const Id* tets = rules.TetsAtSpokes->data() + rules.Strata.VertexRings.Offsets[vertex];
      std::transform(tets, tets + ring.size(), std::back_inserter(rows),
        [](Id count) { return static_cast<int>(count); });
    }
  }

  /// Appends the row of an edge: one member on each face, then, if it is regular, in each
  /// octahedron the opposites of its two ends.
  template <typename Number, typename Add>
  bool ReadEdgeRow(const subdivision::Strata<Id>& strata, Id vertex, Id edge, bool first,
    Neighbourhood& rows, const Number& number, const Add& add) const
  {
    const Row<Id> carriers = strata.EdgeRings.GetCarriers(edge);
    const Id* member = strata.EdgeRings.GetMembers(edge).begin();
    const bool regular = strata.Edges[edge].GetRule() == Rule::RegularEdge;
    const Id* firstOct = regular ? carriers.begin() + RegularFaces : carriers.end();
    bool all = true;
    for (const Id* face = carriers.begin(); face != firstOct; ++face, ++member)
    {
      if (*face >= 0)
      {
        add(this->Here.Complex.OtherEdge(*face, edge, vertex));
      }
      else if (first)
      {
        rows.push_back(number(Id(-1), *member));
      }
      all = all && (*face >= 0 || first);
    }
    const Id far = this->Here.Complex.OtherEnd(edge, vertex);
    for (const Id* oct = firstOct; oct != carriers.end(); oct += 2)
    {
      add(this->Here.Complex.NumberOfEdges + *oct);
      add(this->EdgeInOct(*oct, VertexInOct(this->Here, *oct, vertex),
        octahedron::Opposite(VertexInOct(this->Here, *oct, far))));
    }
    return all;
  }

  const TetOctLevel<Id>& Here;
};

}

template <typename Id>
SparseRows<Id> BuildLimitRows(const TetOctLevel<Id>& level, const SemiSharpStages<Id>& creases)
{
  return MakeLimitRows<TetOctStar<Id>>(
    level, creases, level.Complex.NumberOfVertices, [](vtkIdType i) { return static_cast<Id>(i); });
}

template SparseRows<int> BuildLimitRows(const TetOctLevel<int>&, const SemiSharpStages<int>&);
template SparseRows<long long> BuildLimitRows(
  const TetOctLevel<long long>&, const SemiSharpStages<long long>&);

}
