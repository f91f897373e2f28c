// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitRowMaker.h
 * Makes limit rows (LimitStencils.h) for levels of both volume schemes. A template parameter, the
 * *star*, reads the rows of a vertex and of what lies around it, its *items*.
 *
 * Item 0 is the vertex itself. The other items are the edges at it, and in a tet/oct level its
 * octahedra; each is named by a key and stands for the vertex at its far end. A star has
 *  - IdType, LevelType, and a constructor from a level;
 *  - GetRules(), those of the level; GetOppositeEnd(vertex, key);
 *  - ReadRow(rules, vertex, key, first, rows, number): appends the row of an item (of the vertex if
 *    the key is negative) to `rows` as numbers, among them number(key of member, member) for each
 *    member of the ring. Members without face, which only the first step reads, have a negative
 *    key; they are left out unless `first`, and then ReadRow returns false;
 *  - Weigh(row, item, add): calls add(number of member, weight) for each entry of such a row, and
 *    moves `row` to the next one.
 */
#ifndef SubdivisionObjects_LimitRowMaker_h
#define SubdivisionObjects_LimitRowMaker_h

#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/LocalRows.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Scheme/SharpSectors.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <utility>

namespace subdivision
{

/// The strata of a level, or of a SharpStage of it.
template <typename Id>
struct StarRules
{
  const subdivision::Strata<Id>& Strata;
  const Buffer<Id>* TetsAtSpokes; ///< of a tet/oct level
};

/// The local matrix of a neighbourhood.
template <typename Star>
LocalRows ReadLocalRows(const Star& star, const Neighbourhood& rows, std::size_t items)
{
  LocalRows local;
  const int* row = rows.data();
  for (std::size_t i = 0; i < items; ++i)
  {
    star.Weigh(row, static_cast<int>(i), [&](int item, double weight) { local.Add(item, weight); });
    local.EndRow();
  }
  return local;
}

/// The limits of regular vertices inside a surface and on a curve.
inline constexpr std::array<double, 7> RegularSurfaceLimit{ 1. / 2., 1. / 12., 1. / 12., 1. / 12.,
  1. / 12., 1. / 12., 1. / 12. };
inline constexpr std::array<double, 3> RegularCurveLimit{ 2. / 3., 1. / 6., 1. / 6. };

/// Gives weights that are these up to rounding their exact values, whatever the order of items was.
template <std::size_t N>
void RoundWeights(const std::array<double, N>& exact, std::vector<double>& weights)
{
  if (weights.size() == N &&
    std::equal(exact.begin(), exact.end(), weights.begin(),
      [](double a, double b) { return std::abs(a - b) < 1e-14; }))
  {
    std::copy(exact.begin(), exact.end(), weights.begin());
  }
}

/// A row that is being made.
template <typename Id>
struct LimitRow
{
  std::vector<Id> Columns;
  std::vector<double> Weights;
};

template <typename Star>
class LimitRowMaker
{
public:
  using Id = typename Star::IdType;

  LimitRowMaker(const typename Star::LevelType& level, const SemiSharpStages<Id>& creases,
    const SharpParts& sharp)
    : Here(level)
    , Creases(creases)
    , Sharp(sharp)
    , NumberOfVertices(level.Complex.NumberOfVertices)
    , NumberOfEdges(level.Complex.NumberOfEdges)
  {
  }

  void Make(Id vertex, LimitRow<Id>& row);
  /// The rows of a star (ShadingNormals.h), of which `corners` names edges by their order, from 1
  /// on: for each edge at the vertex where its far end lies, seen from there.
  std::vector<LimitRow<Id>> MakeStar(Id vertex, const std::vector<Id>& edges,
    const std::vector<std::array<int, 2>>& corners, int made);

private:
  /// A vertex that a row reads: the far end of an item, or a vertex that belongs to no item.
  struct Member
  {
    Id Key; ///< of the item; negative: the current vertex, or no item
    Id Vertex;
  };

  void ReadNeighbourhood(const std::vector<Id>& edges = {});
  int CountSteps() const { return static_cast<int>(std::ceil(this->MostSharpness)); }
  void FinishRow(int steps, LimitRow<Id>& row);
  void StepBack(int step);
  void TakeFirstStep();
  StarRules<Id> GetStage(int step) const;
  double GetSharpness(int item, int step) const;
  bool IsOfSector(Id edge, int step) const;
  template <typename Emit>
  void ForEachEntry(const StarRules<Id>& rules, int item, bool first, const Emit& emit);
  template <typename Emit>
  void ForEachBlendedEntry(int item, int step, const Emit& emit);

  const Star Here;
  const SemiSharpStages<Id>& Creases;
  const SharpParts& Sharp;
  const vtkIdType NumberOfVertices;
  const vtkIdType NumberOfEdges;
  using Solutions = std::unordered_map<Neighbourhood, std::vector<double>, HashNeighbourhood>;
  Solutions Solved;
  Solutions Stars;
  // Of the current vertex:
  Id Vertex = 0;
  VertexNumbers<Id> Keys; ///< item i is key i - 1
  Neighbourhood Local;
  bool HasRelief = false;
  double MostSharpness = 0.;
  std::vector<double> Weights; ///< of the items
  std::vector<double> NextWeights;
  VertexNumbers<Id> Vertices; ///< of the row
  // Of one row:
  Neighbourhood Numbers;
  std::vector<Member> Members;
};

template <typename Star>
void LimitRowMaker<Star>::Make(Id vertex, LimitRow<Id>& row)
{
  this->Vertex = vertex;
  row.Columns.clear();
  row.Weights.clear();
  this->MostSharpness = this->Sharp.GetMostSharpness(vertex);
  if (this->MostSharpness <= 0. &&
    this->Here.GetRules().Strata.Vertices[vertex].GetRule() == Rule::Corner)
  {
    row.Columns.push_back(vertex);
    row.Weights.push_back(1.);
    return;
  }
  this->ReadNeighbourhood();
  std::vector<double>& solved = this->Solved[this->Local];
  if (solved.empty())
  {
    solved = ReadLocalRows(this->Here, this->Local, this->Keys.Vertices.size() + 1).FindLimit();
    RoundWeights(RegularSurfaceLimit, solved);
    RoundWeights(RegularCurveLimit, solved);
  }
  this->Weights = solved;
  if (this->Solved.size() > MostSolutions)
  {
    this->Solved.clear();
  }
  this->FinishRow(this->CountSteps(), row);
}

/// Makes the row over the level from Weights, which are the weights after so many steps that have
/// other rules.
template <typename Star>
void LimitRowMaker<Star>::FinishRow(int steps, LimitRow<Id>& row)
{
  if (steps == 0 && !this->HasRelief)
  {
    row.Columns.push_back(this->Vertex);
    for (Id key : this->Keys.Vertices)
    {
      row.Columns.push_back(this->Here.GetOppositeEnd(this->Vertex, key));
    }
    row.Weights = this->Weights;
    return;
  }
  for (int step = steps - 1; step > 0; --step)
  {
    this->StepBack(step);
  }
  this->TakeFirstStep();
  row.Columns = this->Vertices.Vertices;
  row.Weights = this->NextWeights;
}

template <typename Star>
std::vector<LimitRow<typename Star::IdType>> LimitRowMaker<Star>::MakeStar(
  Id vertex, const std::vector<Id>& edges, const std::vector<std::array<int, 2>>& corners, int made)
{
  this->Vertex = vertex;
  this->MostSharpness = this->Sharp.GetMostSharpness(vertex);
  this->ReadNeighbourhood(edges);
  const int steps = std::min(this->CountSteps(), std::max(1, MostStepsOfStars - made));
  made += steps == 0 ? static_cast<int>(this->HasRelief) : steps;
  const std::size_t size = this->Keys.Vertices.size() + 1;
  Neighbourhood key = this->Local;
  key.insert(key.end(), { -1, made, static_cast<int>(edges.size()) });
  for (const std::array<int, 2>& corner : corners)
  {
    key.insert(key.end(), corner.begin(), corner.end());
  }
  if (this->Stars.size() > MostSolutions / 16)
  {
    this->Stars.clear();
  }
  std::vector<double>& star = this->Stars[key];
  if (star.empty())
  {
    star = FindStarRows(ReadLocalRows(this->Here, this->Local, size).Fill(), size, corners, made);
  }
  std::vector<LimitRow<Id>> rows(edges.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto first = star.begin() + static_cast<std::ptrdiff_t>(i * size);
    this->Weights.assign(first, first + static_cast<std::ptrdiff_t>(size));
    this->FinishRow(steps, rows[i]);
  }
  return rows;
}

/// Reads the smooth rows of all items, without members that only the first step reads, and before
/// these some edges. HasRelief: whether the first step differs, also by what is still sharp at far
/// ends.
template <typename Star>
void LimitRowMaker<Star>::ReadNeighbourhood(const std::vector<Id>& edges)
{
  this->Keys.Clear();
  std::for_each(edges.begin(), edges.end(), [this](Id edge) { this->Keys.GetNumber(edge); });
  this->Local.clear();
  this->HasRelief = false;
  const StarRules<Id> rules = this->Here.GetRules();
  auto number = [this](Id key, Id) { return 1 + static_cast<int>(this->Keys.GetNumber(key)); };
  this->Here.ReadRow(rules, this->Vertex, Id(-1), false, this->Local, number);
  for (std::size_t i = 0; i < this->Keys.Vertices.size(); ++i) // the list grows meanwhile
  {
    const bool all =
      this->Here.ReadRow(rules, this->Vertex, this->Keys.Vertices[i], false, this->Local, number);
    this->HasRelief =
      this->HasRelief || !all || this->GetSharpness(static_cast<int>(i) + 1, 0) > 0.;
  }
}

template <typename Star>
StarRules<typename Star::IdType> LimitRowMaker<Star>::GetStage(int step) const
{
  const auto& stages = this->Creases.Stages;
  const auto found = std::find_if(stages.begin(), stages.end(),
    [step](const SharpStage<Id>& stage) { return stage.Until > step; });
  const SharpStage<Id>& stage = found == stages.end() ? stages.back() : *found;
  return { stage.Strata, stage.TetsAtSpokes.get() };
}

/// The weight of the sharp row of an item (SemiSharp.h, SharpSectors.h).
template <typename Star>
double LimitRowMaker<Star>::GetSharpness(int item, int step) const
{
  const Id edge = item > 0 ? this->Keys.Vertices[item - 1] : 0;
  if (this->Creases.Stages.empty() || edge >= this->NumberOfEdges || this->MostSharpness < step)
  {
    return 0.; // the second: an octahedron
  }
  const double own =
    this->Sharp.GetSharpness(item > 0 ? this->NumberOfVertices + edge : this->Vertex, step);
  if (own > 0. || item == 0 || !this->IsOfSector(edge, step))
  {
    return std::min(1., own);
  }
  const Id ends[2] = { this->Vertex, this->Here.GetOppositeEnd(this->Vertex, edge) };
  return std::min(1.,
    GetMeanOfEnds(ends,
      [&](Id end)
      {
        const bool isFar = end != this->Vertex;
        return isFar && step > 0 ? 0. : this->Sharp.GetSharpness(end, step);
      }));
}

/// Whether the smooth or the sharp rule of an edge depends on sectors.
template <typename Star>
bool LimitRowMaker<Star>::IsOfSector(Id edge, int step) const
{
  return !FindSectorEdges(this->Here.GetRules().Strata.Sectors, edge).IsEmpty() ||
    !FindSectorEdges(this->GetStage(step).Strata.Sectors, edge).IsEmpty();
}

/// Calls emit(key, vertex, weight) for each entry of an item's row. The key is negative for the
/// current vertex and for reliefs, which only the `first` step reads.
template <typename Star>
template <typename Emit>
void LimitRowMaker<Star>::ForEachEntry(
  const StarRules<Id>& rules, int item, bool first, const Emit& emit)
{
  const Id own = item == 0 ? Id(-1) : this->Keys.Vertices[item - 1];
  this->Numbers.clear();
  this->Members.assign(1, { Id(-1), this->Vertex });
  if (item > 0)
  {
    this->Members.push_back({ own, this->Here.GetOppositeEnd(this->Vertex, own) });
  }
  this->Here.ReadRow(rules, this->Vertex, own, first, this->Numbers,
    [this](Id key, Id vertex)
    {
      this->Members.push_back({ key, vertex });
      return static_cast<int>(this->Members.size()) - 1;
    });
  const int* row = this->Numbers.data();
  this->Here.Weigh(row, item == 0 ? 0 : 1, [&](int member, double weight)
    { emit(this->Members[member].Key, this->Members[member].Vertex, weight); });
}

/// Calls emit for the blended row of an item in a step: (1 - weight) * smooth row + weight * sharp
/// row.
template <typename Star>
template <typename Emit>
void LimitRowMaker<Star>::ForEachBlendedEntry(int item, int step, const Emit& emit)
{
  const double sharp = this->GetSharpness(item, step);
  auto scaled = [&](double factor)
  {
    return [&emit, factor](Id key, Id vertex, double weight)
    { emit(key, vertex, factor * weight); };
  };
  if (sharp < 1.)
  {
    this->ForEachEntry(this->Here.GetRules(), item, step == 0, scaled(1. - sharp));
  }
  if (sharp > 0.)
  {
    this->ForEachEntry(this->GetStage(step), item, step == 0, scaled(sharp));
  }
}

/// Replaces Weights by Weights A, where A is the matrix of `step` > 0. Sharp rings may add items.
template <typename Star>
void LimitRowMaker<Star>::StepBack(int step)
{
  this->NextWeights.assign(this->Weights.size(), 0.);
  for (std::size_t i = 0; i < this->Weights.size(); ++i)
  {
    this->ForEachBlendedEntry(static_cast<int>(i), step,
      [&](Id key, Id, double weight)
      {
        const std::size_t item = key < 0 ? 0 : 1 + this->Keys.GetNumber(key);
        if (item >= this->NextWeights.size())
        {
          this->NextWeights.resize(item + 1, 0.);
        }
        this->NextWeights[item] += this->Weights[i] * weight;
      });
  }
  this->Weights.swap(this->NextWeights);
}

/// Sets NextWeights to Weights S, where S is the operator of the first step. Its columns are
/// Vertices.
template <typename Star>
void LimitRowMaker<Star>::TakeFirstStep()
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

/// The limit rows of the vertices vertex(0) to vertex(size - 1).
template <typename Star, typename Id, typename Vertex>
SparseRows<Id> MakeLimitRows(const typename Star::LevelType& level,
  const SemiSharpStages<Id>& creases, vtkIdType size, const Vertex& vertex)
{
  const SharpParts sharp = creases.ListParts(level.Complex);
  vtkSMPThreadLocal<std::shared_ptr<LimitRowMaker<Star>>> makers; // each keeps its solutions
  const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
  {
    auto& maker = makers.Local();
    if (!maker)
    {
      maker = std::make_shared<LimitRowMaker<Star>>(level, creases, sharp);
    }
    LimitRow<Id> row;
    for (vtkIdType i = begin; i < end; ++i)
    {
      maker->Make(vertex(i), row);
      for (std::size_t k = 0; k < row.Columns.size(); ++k)
      {
        rows.Add(row.Columns[k], row.Weights[k]);
      }
      rows.EndRow();
    }
  };
  return BlockOperator<Id>(level.Complex.NumberOfVertices, size, append).Store();
}

}

#endif
