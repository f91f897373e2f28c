// SPDX-License-Identifier: BSD-3-Clause
#include "LimitStencils.h"

#include "Simplices.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace subdivision
{
namespace
{

/// Numbers ids in the order in which they come. A hub may have very many.
template <typename Id>
class Numbering
{
public:
  int GetNumber(Id id)
  {
    if (2 * (this->Ids.size() + 1) > this->Slots.size())
    {
      this->Slots.assign(2 * this->Slots.size(), -1);
      for (std::size_t i = 0; i < this->Ids.size(); ++i)
      {
        this->Find(this->Ids[i]) = static_cast<int>(i);
      }
    }
    int& slot = this->Find(id);
    if (slot < 0)
    {
      slot = static_cast<int>(this->Ids.size());
      this->Ids.push_back(id);
    }
    return slot;
  }
  void Clear()
  {
    this->Ids.clear();
    this->Slots.assign(64, -1);
  }

  std::vector<Id> Ids;

private:
  int& Find(Id id)
  {
    std::size_t at = (static_cast<std::uint64_t>(id) * 0x9e3779b97f4a7c15u) >> 32;
    for (;; ++at)
    {
      int& slot = this->Slots[at & (this->Slots.size() - 1)];
      if (slot < 0 || this->Ids[slot] == id)
      {
        return slot;
      }
    }
  }

  std::vector<int> Slots = std::vector<int>(64, -1);
};

/// The rows of a vertex (item 0) and its edges (items 1, 2, ...), as numbers: for each its rule,
/// the size of its ring and the ring as items.
using Neighbourhood = std::vector<int>;

struct HashNeighbourhood
{
  std::size_t operator()(const Neighbourhood& neighbourhood) const
  {
    std::uint64_t hash = 14695981039346656037u;
    for (int value : neighbourhood)
    {
      hash = (hash ^ static_cast<std::uint64_t>(value)) * 1099511628211u;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// Weight after weight of an item's row: add(item, weight). `row` is moved to the next one.
template <typename Add>
void ReadRow(const int*& row, int item, const Add& add)
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

/// w of a neighbourhood by elimination of one item after the other, in the way of W. Grassmann,
/// M. Taksar and D. Heyman (1985), which subtracts nothing: exact to rounding.
std::vector<double> EliminateItems(const Neighbourhood& rows, int items)
{
  std::vector<double> a(static_cast<std::size_t>(items) * items, 0.);
  const int* row = rows.data();
  for (int i = 0; i < items; ++i)
  {
    ReadRow(row, i, [&](int item, double weight) { a[i * items + item] += weight; });
  }
  for (int k = items - 1; k > 0; --k)
  {
    const double* last = a.data() + k * items;
    const double sum = std::accumulate(last, last + k, 0.);
    for (int i = 0; i < k; ++i)
    {
      const double factor = a[i * items + k] /= sum;
      for (int j = 0; factor != 0. && j < k; ++j)
      {
        a[i * items + j] += factor * last[j];
      }
    }
  }
  std::vector<double> w(items, 0.);
  w[0] = 1.;
  for (int k = 1; k < items; ++k)
  {
    for (int i = 0; i < k; ++i)
    {
      w[k] += w[i] * a[i * items + k];
    }
  }
  return w;
}

/// w of a neighbourhood by the series.
std::vector<double> SumSeries(const Neighbourhood& rows, int items)
{
  std::vector<double> sum(items, 0.);
  std::vector<double> term(items, 0.);
  std::vector<double> next(items);
  const int* row = rows.data();
  ReadRow(row, 0, [&](int item, double weight) { term[item] += weight; });
  const int* const edges = row;
  double total = 1.;
  for (double left = 1.; left > 1e-20 * total; total += left)
  {
    row = edges;
    left = 0.;
    std::fill(next.begin(), next.end(), 0.);
    for (int i = 1; i < items; ++i)
    {
      sum[i] += term[i];
      left += term[i];
      ReadRow(row, i, [&](int item, double weight) { next[item] += term[i] * weight; });
    }
    term.swap(next);
  }
  sum[0] = 1.;
  return sum;
}

/// w of a neighbourhood, one weight for each item. A hub of many spokes has too many for a matrix.
std::vector<double> SolveLimit(const Neighbourhood& rows, std::size_t items)
{
  const int size = static_cast<int>(items);
  std::vector<double> w = size <= 48 ? EliminateItems(rows, size) : SumSeries(rows, size);
  const double total = std::accumulate(w.begin(), w.end(), 0.);
  for (double& weight : w)
  {
    weight /= total;
  }
  return w;
}

/// A row under way.
template <typename Id>
struct LimitRow
{
  std::vector<Id> Columns;
  std::vector<double> Weights;
};

template <typename Id>
class LimitRowMaker
{
public:
  LimitRowMaker(const Level<Id>& level, const SemiSharpStages<Id>& creases,
    const std::vector<std::pair<Id, Id>>& sharpEdges)
    : Here(level)
    , Creases(creases)
    , SharpEdges(sharpEdges)
  {
  }

  void Make(Id vertex, LimitRow<Id>& row);

private:
  void ReadNeighbourhood();
  void FindSharpEdges();
  void StepBack(int step);
  void TakeFirstStep();
  const subdivision::Strata<Id>& GetStage(int step) const;
  double GetSharpness(int item, int step) const;
  template <typename Emit>
  void ForEachEntry(
    const subdivision::Strata<Id>& strata, int item, bool first, const Emit& emit) const;
  template <typename Emit>
  void ForEachBlendedEntry(int item, int step, const Emit& emit) const;

  /// The other edge at the vertex of a face at it.
  Id EdgeAcross(Id face, Id edge) const
  {
    const auto& complex = this->Here.Complex;
    const Id* edges = complex.FaceEdges.data() + 3 * vtkIdType(face);
    const int* local = triangle::EdgesAt[complex.VertexInFace(face, this->Vertex)];
    return edges[edges[local[0]] == edge ? local[1] : local[0]];
  }

  const Level<Id>& Here;
  const SemiSharpStages<Id>& Creases;
  const std::vector<std::pair<Id, Id>>& SharpEdges; ///< (vertex, edge), sorted
  std::unordered_map<Neighbourhood, std::vector<double>, HashNeighbourhood> Solved;
  // Of the vertex that is looked at:
  Id Vertex = 0;
  Numbering<Id> Edges; ///< item i is edge i - 1
  Neighbourhood Local;
  bool HasRelief = false;
  double MostSharpness = 0.;
  std::vector<double> Weights; ///< of the items
  std::vector<double> NextWeights;
  Numbering<Id> Vertices; ///< of the row
};

template <typename Id>
void LimitRowMaker<Id>::Make(Id vertex, LimitRow<Id>& row)
{
  this->Vertex = vertex;
  row.Columns.clear();
  row.Weights.clear();
  this->FindSharpEdges();
  if (this->MostSharpness <= 0. && this->Here.Strata.Vertices[vertex].GetRule() == Rule::Corner)
  {
    row.Columns.push_back(vertex);
    row.Weights.push_back(1.);
    return;
  }
  this->ReadNeighbourhood();
  std::vector<double>& solved = this->Solved[this->Local];
  if (solved.empty())
  {
    solved = SolveLimit(this->Local, this->Edges.Ids.size() + 1);
  }
  this->Weights = solved;
  if (this->Solved.size() > 4096) // none of a mesh's refined parts has that many kinds
  {
    this->Solved.clear();
  }
  if (this->MostSharpness <= 0. && !this->HasRelief)
  {
    row.Columns.push_back(vertex);
    for (Id edge : this->Edges.Ids)
    {
      row.Columns.push_back(this->Here.Complex.OtherEnd(edge, vertex));
    }
    row.Weights = this->Weights;
    return;
  }
  const int steps =
    static_cast<int>(std::ceil(std::min<double>(this->MostSharpness, SharpForever)));
  for (int step = steps - 1; step > 0; --step)
  {
    this->StepBack(step);
  }
  this->TakeFirstStep();
  row.Columns = this->Vertices.Ids;
  row.Weights = this->NextWeights;
}

/// The rows that repeat: without reliefs, and smooth.
template <typename Id>
void LimitRowMaker<Id>::ReadNeighbourhood()
{
  const auto& strata = this->Here.Strata;
  this->Edges.Clear();
  this->Local.clear();
  this->HasRelief = false;
  const Row<Id> ring = strata.VertexRings.GetCarriers(this->Vertex);
  this->Local.push_back(static_cast<int>(strata.Vertices[this->Vertex].GetRule()));
  this->Local.push_back(static_cast<int>(ring.size()));
  for (Id edge : ring)
  {
    this->Local.push_back(1 + this->Edges.GetNumber(edge));
  }
  for (std::size_t i = 0; i < this->Edges.Ids.size(); ++i) // grows
  {
    const Id edge = this->Edges.Ids[i];
    this->Local.push_back(static_cast<int>(strata.Edges[edge].GetRule()));
    const std::size_t size = this->Local.size();
    this->Local.push_back(0);
    for (Id face : strata.EdgeRings.GetCarriers(edge))
    {
      if (face >= 0)
      {
        this->Local.push_back(1 + this->Edges.GetNumber(this->EdgeAcross(face, edge)));
      }
      this->HasRelief = this->HasRelief || face < 0;
    }
    this->Local[size] = static_cast<int>(this->Local.size() - size - 1);
  }
}

template <typename Id>
void LimitRowMaker<Id>::FindSharpEdges()
{
  this->MostSharpness = 0.;
  for (auto at = std::lower_bound(
         this->SharpEdges.begin(), this->SharpEdges.end(), std::make_pair(this->Vertex, Id(0)));
       at != this->SharpEdges.end() && at->first == this->Vertex; ++at)
  {
    this->MostSharpness = std::max(this->MostSharpness, this->Creases.Sharpness[at->second]);
  }
}

template <typename Id>
const Strata<Id>& LimitRowMaker<Id>::GetStage(int step) const
{
  const auto& stages = this->Creases.Stages;
  const auto found = std::find_if(stages.begin(), stages.end(),
    [step](const SharpStage<Id>& stage) { return stage.Until > step; });
  return found == stages.end() ? stages.back().Strata : found->Strata;
}

/// The weight of the sharp row of an item (SemiSharp.h).
template <typename Id>
double LimitRowMaker<Id>::GetSharpness(int item, int step) const
{
  if (this->MostSharpness <= step)
  {
    return 0.;
  }
  auto left = [&](Id edge)
  { return std::min<double>(this->Creases.Sharpness[edge], SharpForever) - step; };
  if (item > 0)
  {
    return std::max(0., std::min(1., left(this->Edges.Ids[item - 1])));
  }
  double sum = 0.;
  int count = 0;
  for (auto at = std::lower_bound(
         this->SharpEdges.begin(), this->SharpEdges.end(), std::make_pair(this->Vertex, Id(0)));
       at != this->SharpEdges.end() && at->first == this->Vertex; ++at)
  {
    const double sharpness = left(at->second);
    if (sharpness > 0.)
    {
      sum += sharpness;
      ++count;
    }
  }
  return std::min(1., sum / count);
}

/// emit(edge, vertex, weight) for each entry of an item's row; the edge joins it to the vertex, or
/// is -1 where there is none: for the vertex itself and for reliefs, which only the `first` step
/// has.
template <typename Id>
template <typename Emit>
void LimitRowMaker<Id>::ForEachEntry(
  const subdivision::Strata<Id>& strata, int item, bool first, const Emit& emit) const
{
  const auto& complex = this->Here.Complex;
  if (item == 0)
  {
    const Row<Id> ring = strata.VertexRings.GetCarriers(this->Vertex);
    const Mask mask = VertexMask(strata.Vertices[this->Vertex].GetRule(), ring.size());
    emit(Id(-1), this->Vertex, ring.size() == 0 ? 1. : mask.Own);
    for (Id edge : ring)
    {
      emit(edge, complex.OtherEnd(edge, this->Vertex), mask.Ring);
    }
    return;
  }
  const Id edge = this->Edges.Ids[item - 1];
  const Row<Id> carriers = strata.EdgeRings.GetCarriers(edge);
  const Row<Id> members = strata.EdgeRings.GetMembers(edge);
  const auto reliefs = std::count(carriers.begin(), carriers.end(), Id(-1));
  const Mask mask = EdgeMask(strata.Edges[edge].GetRule(), carriers.size() - (first ? 0 : reliefs));
  emit(Id(-1), this->Vertex, mask.Own);
  emit(edge, complex.OtherEnd(edge, this->Vertex), mask.Own);
  for (vtkIdType k = 0; k < carriers.size(); ++k)
  {
    const Id face = carriers.begin()[k];
    if (face >= 0)
    {
      emit(this->EdgeAcross(face, edge), members.begin()[k], mask.Ring);
    }
    else if (first)
    {
      emit(Id(-1), members.begin()[k], mask.Ring);
    }
  }
}

/// The row of an item as it is while creases are sharp.
template <typename Id>
template <typename Emit>
void LimitRowMaker<Id>::ForEachBlendedEntry(int item, int step, const Emit& emit) const
{
  const double sharp = this->GetSharpness(item, step);
  auto scaled = [&](double factor)
  {
    return [&emit, factor](Id edge, Id vertex, double weight)
    { emit(edge, vertex, factor * weight); };
  };
  if (sharp < 1.)
  {
    this->ForEachEntry(this->Here.Strata, item, step == 0, scaled(1. - sharp));
  }
  if (sharp > 0.)
  {
    this->ForEachEntry(this->GetStage(step), item, step == 0, scaled(sharp));
  }
}

/// Weights <- Weights A, with the A of a later step. Sharp rings may bring further edges.
template <typename Id>
void LimitRowMaker<Id>::StepBack(int step)
{
  this->NextWeights.assign(this->Weights.size(), 0.);
  for (std::size_t i = 0; i < this->Weights.size(); ++i)
  {
    this->ForEachBlendedEntry(static_cast<int>(i), step,
      [&](Id edge, Id, double weight)
      {
        const std::size_t item = edge < 0 ? 0 : 1 + this->Edges.GetNumber(edge);
        if (item >= this->NextWeights.size())
        {
          this->NextWeights.resize(item + 1, 0.);
        }
        this->NextWeights[item] += this->Weights[i] * weight;
      });
  }
  this->Weights.swap(this->NextWeights);
}

/// NextWeights <- Weights S, over Vertices.
template <typename Id>
void LimitRowMaker<Id>::TakeFirstStep()
{
  this->Vertices.Clear();
  this->NextWeights.clear();
  for (std::size_t i = 0; i < this->Weights.size(); ++i)
  {
    this->ForEachBlendedEntry(static_cast<int>(i), 0,
      [&](Id, Id vertex, double weight)
      {
        const std::size_t column = this->Vertices.GetNumber(vertex);
        if (column >= this->NextWeights.size())
        {
          this->NextWeights.resize(column + 1, 0.);
        }
        this->NextWeights[column] += this->Weights[i] * weight;
      });
  }
}

/// Sharp edges at each of their ends.
template <typename Id>
std::vector<std::pair<Id, Id>> FindSharpEdges(
  const Level<Id>& level, const SemiSharpStages<Id>& creases)
{
  std::vector<std::pair<Id, Id>> found;
  for (vtkIdType e = 0; e < creases.Sharpness.size(); ++e)
  {
    if (creases.Sharpness[e] > 0.)
    {
      found.emplace_back(level.Complex.EdgeVertices[2 * e], static_cast<Id>(e));
      found.emplace_back(level.Complex.EdgeVertices[2 * e + 1], static_cast<Id>(e));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Rows of `size` vertices, which `vertex` names; blocks of them are made one by one and then put
/// together.
template <typename Id, typename Vertex>
SparseRows<Id> MakeRows(
  const Level<Id>& level, const SemiSharpStages<Id>& creases, vtkIdType size, const Vertex& vertex)
{
  const std::vector<std::pair<Id, Id>> sharpEdges = FindSharpEdges(level, creases);
  constexpr vtkIdType block = 4096;
  const vtkIdType blocks = (size + block - 1) / block;
  std::vector<LimitRow<Id>> parts(blocks);
  SparseRows<Id> rows;
  rows.NumberOfColumns = level.Complex.NumberOfVertices;
  rows.Offsets = Buffer<Id>(size + 1);
  vtkSMPThreadLocal<std::shared_ptr<LimitRowMaker<Id>>> makers; // what is solved is solved
  auto makeBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    auto& maker = makers.Local();
    if (!maker)
    {
      maker = std::make_shared<LimitRowMaker<Id>>(level, creases, sharpEdges);
    }
    LimitRow<Id> row;
    for (vtkIdType b = begin; b < end; ++b)
    {
      for (vtkIdType i = b * block; i < std::min(size, (b + 1) * block); ++i)
      {
        maker->Make(vertex(i), row);
        rows.Offsets[i] = static_cast<Id>(row.Columns.size());
        LimitRow<Id>& part = parts[b];
        part.Columns.insert(part.Columns.end(), row.Columns.begin(), row.Columns.end());
        part.Weights.insert(part.Weights.end(), row.Weights.begin(), row.Weights.end());
      }
    }
  };
  if (blocks > 2)
  {
    vtkSMPTools::For(0, blocks, 1, makeBlocks);
  }
  else
  {
    makeBlocks(0, blocks);
  }
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<Id>(rows.Offsets[size]);
  rows.Weights = Buffer<double>(rows.Offsets[size]);
  for (vtkIdType b = 0; b < blocks; ++b)
  {
    const vtkIdType first = rows.Offsets[b * block];
    std::copy(parts[b].Columns.begin(), parts[b].Columns.end(), rows.Columns.begin() + first);
    std::copy(parts[b].Weights.begin(), parts[b].Weights.end(), rows.Weights.begin() + first);
    parts[b] = LimitRow<Id>();
  }
  return rows;
}

}

template <typename Id>
SparseRows<Id> BuildLimitRows(const Level<Id>& level, const SemiSharpStages<Id>& creases)
{
  return MakeRows(
    level, creases, level.Complex.NumberOfVertices, [](vtkIdType i) { return static_cast<Id>(i); });
}

template <typename Id>
SparseRows<Id> BuildLimitRows(
  const Level<Id>& level, const SemiSharpStages<Id>& creases, const Buffer<Id>& vertices)
{
  return MakeRows(
    level, creases, vertices.size(), [&vertices](vtkIdType i) { return vertices[i]; });
}

#define SUBDIVISION_LIMIT(Id)                                                                      \
  template SparseRows<Id> BuildLimitRows(const Level<Id>&, const SemiSharpStages<Id>&);            \
  template SparseRows<Id> BuildLimitRows(                                                          \
    const Level<Id>&, const SemiSharpStages<Id>&, const Buffer<Id>&)
SUBDIVISION_LIMIT(int);
SUBDIVISION_LIMIT(long long);

}
