// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitByLevels.h
 * The slow reference for LocalLimit: limits of some vertices by the levels themselves. It makes
 * only those parts of the levels that these limits depend on.
 *
 * In each step the current part of the level is restricted to the cells around *ancestors*, the
 * vertices between which later vertices arise (Restriction.h), and refined with the usual rules and
 * rings. The limit row of a vertex is taken on the level on which the vertex first exists. Then the
 * program goes back from the limits to the control level and keeps only the rows that are
 * ancestors. If the part was too small for one of these, so that the row lacks entries, all is
 * repeated with a larger distance.
 */
#ifndef SubdivisionObjects_LimitByLevels_h
#define SubdivisionObjects_LimitByLevels_h

#include "Core/Memory/Selection.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/Restriction.h"
#include "Core/Solids/Scheme/SharpSectors.h"
#include "LocalVertices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace coretest
{

using namespace subdivision;

/// Gives a level without solids the data that vertex rows need besides strata.
template <typename Id>
void TakeSpokes(const Level<Id>&, const SharpStage<Id>&, Level<Id>&)
{
}
template <typename Id>
void TakeSpokes(const TetOctLevel<Id>& from, const SharpStage<Id>& stage, TetOctLevel<Id>& sharp)
{
  sharp.NumberOfControlVertices = from.NumberOfControlVertices;
  sharp.TetsAtSpokes = stage.TetsAtSpokes;
}

/// One step, and the limits of the vertices that first exist on its level.
template <typename Id>
struct LevelStep
{
  SparseRows<Id> Rows;   ///< from values of the step before; the first ones copy control values
  SparseRows<Id> Limits; ///< from this step's values
  std::vector<Id> Vertices;
};

/**
 * Builds the steps of a LimitByLevels. Forward it makes the levels, each from a part of the one
 * before, and the limit rows on them; backward it finds the rows that these need.
 */
template <typename LevelType>
class LevelSteps
{
public:
  using Id = typename LevelType::IdType;
  using Step = LevelStep<Id>;

  explicit LevelSteps(LocalVertices<Id>& vertices)
    : Vertices(vertices)
  {
  }

  /// False: the parts were too small.
  bool Build(const LevelType& control, const SemiSharpStages<Id>& creases, int distance,
    std::vector<Step>& steps);

private:
  /// A level, or a part of one.
  struct Piece
  {
    LevelType Level;
    SemiSharpStages<Id> Creases;
    Buffer<unsigned char> Whole; ///< vertices at which nothing is missing
  };
  /// The kept part of a level: limit rows over its vertices, and the rows of the step that leads to
  /// it.
  struct Trace
  {
    SparseRows<Id> Limits;
    // These are empty on the control level:
    Buffer<Id> Columns; ///< the vertices of the level before to which the operators' columns belong
    Stencils<Id> Smooth;
    Stencils<Id> Sharp;          ///< where creases are still sharp
    std::vector<double> Weights; ///< of the sharp rows; empty: all 0
    Buffer<unsigned char> Whole; ///< rows of which nothing is missing
  };

  static SemiSharpStages<Id> Restrict(
    const Restriction<LevelType>& restriction, const SemiSharpStages<Id>& creases);
  static Buffer<unsigned char> FlagWhole(const Restriction<LevelType>& restriction,
    const Buffer<unsigned char>& at, const LevelType& part, const Buffer<unsigned char>& before);
  static SemiSharpStages<Id> RefineCreases(Piece& part, const SimplicialComplex<Id>& children);
  static void TakeOperators(Piece& part, Trace& trace);
  static SparseRows<Id> MakeRows(const Trace& trace, const Buffer<Id>& vertices);
  static SparseRows<Id> MakeCopies(const Buffer<Id>& vertices);
  bool FollowBack(std::vector<Trace>& traces, Id columns, std::vector<Step>& steps) const;

  LocalVertices<Id>& Vertices;
};

template <typename LevelType>
SemiSharpStages<typename LevelType::IdType> LevelSteps<LevelType>::Restrict(
  const Restriction<LevelType>& restriction, const SemiSharpStages<Id>& creases)
{
  SemiSharpStages<Id> part;
  const auto pick = [](const Buffer<double>& sharpness, const Buffer<Id>& old)
  {
    Buffer<double> picked(sharpness.empty() ? 0 : old.size());
    for (vtkIdType i = 0; i < picked.size(); ++i)
    {
      picked[i] = sharpness[old[i]];
    }
    return picked;
  };
  part.Sharpness = pick(creases.Sharpness, restriction.GetOldEdges());
  part.FaceSharpness = pick(creases.FaceSharpness, restriction.GetOldFaces());
  for (const SharpStage<Id>& stage : creases.Stages)
  {
    part.Stages.push_back({ stage.Until, restriction.Restrict(stage.Strata),
      restriction.RestrictSpokes(stage.Strata, stage.TetsAtSpokes) });
  }
  return part;
}

/// Flags the vertices that a part has when it is refined where nothing is missing. `at`: where all
/// of the level is kept; `before`: the vertices of the level at which nothing is missing.
template <typename LevelType>
Buffer<unsigned char> LevelSteps<LevelType>::FlagWhole(const Restriction<LevelType>& restriction,
  const Buffer<unsigned char>& at, const LevelType& part, const Buffer<unsigned char>& before)
{
  const Buffer<Id>& old = restriction.GetOldVertices();
  const vtkIdType edges = part.Complex.NumberOfEdges;
  Buffer<unsigned char> whole(
    old.size() + edges + SchemeOf<LevelType>::CountCentres(part), 1); // centres have all vertices
  for (vtkIdType v = 0; v < old.size(); ++v)
  {
    whole[v] = at[old[v]] && (before.empty() || before[old[v]]);
  }
  for (vtkIdType e = 0; e < edges; ++e)
  {
    const Id* ends = part.Complex.EdgeVertices.data() + 2 * e;
    whole[old.size() + e] = whole[ends[0]] || whole[ends[1]];
  }
  for (const SectorEdge<Id>& sector : part.Strata.Sectors)
  {
    whole[old.size() + sector.Edge] &= sector.IsComplete() ? 1 : 0;
  }
  return whole;
}

template <typename LevelType>
SemiSharpStages<typename LevelType::IdType> LevelSteps<LevelType>::RefineCreases(
  Piece& part, const SimplicialComplex<Id>& children)
{
  SemiSharpStages<Id> refined;
  const auto refine = [](const Buffer<double>& sharpness, int pieces, vtkIdType size)
  {
    Buffer<double> left;
    if (std::any_of(sharpness.begin(), sharpness.end(), [](double s) { return s > 1.; }))
    {
      left = Buffer<double>(size, 0.);
      for (vtkIdType i = 0; i < sharpness.size(); ++i)
      {
        std::fill_n(left.data() + pieces * i, pieces, std::max(0., sharpness[i] - 1.));
      }
    }
    return left;
  };
  refined.Sharpness = refine(part.Creases.Sharpness, 2, children.NumberOfEdges);
  refined.FaceSharpness = refine(part.Creases.FaceSharpness, 4, children.NumberOfFaces);
  if (refined.Sharpness.empty() && refined.FaceSharpness.empty())
  {
    return refined;
  }
  for (SharpStage<Id>& stage : part.Creases.Stages)
  {
    if (stage.Until > 1)
    {
      std::swap(part.Level.Strata, stage.Strata);
      refined.Stages.push_back(
        { stage.Until - 1, Refine(part.Level, Depth::ForRefinement).Strata, stage.TetsAtSpokes });
      std::swap(part.Level.Strata, stage.Strata);
    }
  }
  return refined;
}

/// Moves the operators out of a part that was refined, of which the trace has the whole vertices.
template <typename LevelType>
void LevelSteps<LevelType>::TakeOperators(Piece& part, Trace& trace)
{
  const SimplicialComplex<Id>& complex = part.Level.Complex;
  const vtkIdType vertices = complex.NumberOfVertices;
  const vtkIdType edges = complex.NumberOfEdges;
  const auto leaveOut = [&](const Strata<Id>& strata)
  {
    for (const SectorEdge<Id>& sector : strata.Sectors)
    {
      trace.Whole[vertices + sector.Edge] &= sector.IsComplete() ? 1 : 0;
    }
  };
  std::vector<SharpRow> rows =
    part.Creases.ListParts(complex, std::numeric_limits<double>::infinity()).GetRows();
  trace.Smooth = TakeStencils(part.Level);
  // Creases beyond the part count in rows of sectors, too, which then are not whole.
  const bool hasSectors = !part.Creases.Stages.empty() &&
    (!trace.Smooth.Explicit.Rows.empty() || !part.Creases.Stages.front().Strata.Sectors.empty());
  if (!rows.empty() || hasSectors)
  {
    LevelType sharp;
    TakeSpokes(part.Level, part.Creases.Stages.front(), sharp);
    const Buffer<Id>& edgeVertices = trace.Smooth.EdgeVertices;
    sharp.Complex.EdgeVertices = Buffer<Id>(2 * edges);
    CopyInThreads(edgeVertices.data(), 2 * edges, sharp.Complex.EdgeVertices.data());
    sharp.Strata = std::move(part.Creases.Stages.front().Strata);
    leaveOut(sharp.Strata);
    trace.Sharp = TakeStencils(sharp);
    // As BlendSemiSharp does.
    AddSharpSectors(
      trace.Smooth.Explicit.Rows, trace.Sharp.Explicit.Rows, edgeVertices, vertices, rows);
    trace.Weights.assign(trace.Whole.size(), 0.);
    for (const SharpRow& row : rows)
    {
      trace.Weights[row.Row] = std::min(1., row.Sharpness);
    }
    // The sharpness of all lines at both ends counts in rows of sectors.
    for (const Stencils<Id>* stencils : { &trace.Smooth, &trace.Sharp })
    {
      for (const Id row : stencils->Explicit.Rows)
      {
        const Id* ends = edgeVertices.data() + 2 * (row - vertices);
        trace.Whole[row] &= trace.Whole[ends[0]] && trace.Whole[ends[1]] ? 1 : 0;
      }
    }
  }
}

template <typename LevelType>
bool LevelSteps<LevelType>::Build(const LevelType& control, const SemiSharpStages<Id>& creases,
  int distance, std::vector<Step>& steps)
{
  this->Vertices.StartOnControl();
  const std::size_t levels = this->Vertices.GetNumberOfLevels();
  std::vector<Trace> traces(levels);
  const LevelType* level = &control;
  const SemiSharpStages<Id>* levelCreases = &creases;
  Piece current; // what the two point to from level 1 on
  for (std::size_t l = 0; l < levels; ++l)
  {
    traces[l].Limits = BuildLimitRows(*level, *levelCreases, this->Vertices.FindOnPart(l));
    if (l + 1 == levels)
    {
      break;
    }
    const Buffer<unsigned char> support = this->Vertices.FlagSupport(*level, l, distance);
    const Restriction<LevelType> restriction(*level, support);
    const Buffer<Id>& old = restriction.GetOldVertices();
    Piece part;
    part.Level = restriction.Restrict();
    part.Creases = Restrict(restriction, *levelCreases);
    this->Vertices.FollowToPart(part.Level, restriction.GetNewVertices(), l);
    current.Level = LevelType(); // nothing reads it any more
    Trace& next = traces[l + 1];
    next.Whole = FlagWhole(restriction, support, part.Level, current.Whole);
    next.Columns = Buffer<Id>(old.size());
    CopyInThreads(old.data(), old.size(), next.Columns.data());
    current.Level = Refine(part.Level, Depth::ForRefinement);
    current.Creases = RefineCreases(part, current.Level.Complex);
    TakeOperators(part, next);
    current.Whole = Buffer<unsigned char>(next.Whole.size());
    CopyInThreads(next.Whole.data(), next.Whole.size(), current.Whole.data());
    level = &current.Level;
    levelCreases = &current.Creases;
  }
  return this->FollowBack(traces, control.Complex.NumberOfVertices, steps);
}

/// The rows of some vertices of a level, with columns on the level before.
template <typename LevelType>
SparseRows<typename LevelType::IdType> LevelSteps<LevelType>::MakeRows(
  const Trace& trace, const Buffer<Id>& vertices)
{
  const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
  {
    ExplicitRows<Id> entries;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const Id row = vertices[i];
      const double sharp = trace.Weights.empty() ? 0. : trace.Weights[row];
      entries.Columns.clear();
      entries.Weights.clear();
      if (sharp < 1.)
      {
        trace.Smooth.AppendRow(row, 1. - sharp, entries);
      }
      if (sharp > 0.)
      {
        trace.Sharp.AppendRow(row, sharp, entries);
      }
      for (std::size_t k = 0; k < entries.Columns.size(); ++k)
      {
        rows.Add(trace.Columns[entries.Columns[k]], entries.Weights[k]);
      }
      rows.EndRow();
    }
  };
  return BlockOperator<Id>(0, vertices.size(), append).Store(); // FollowBack knows the columns
}

/// Rows that copy some vertices.
template <typename LevelType>
SparseRows<typename LevelType::IdType> LevelSteps<LevelType>::MakeCopies(const Buffer<Id>& vertices)
{
  SparseRows<Id> rows;
  rows.Offsets = Buffer<Id>(vertices.size() + 1);
  ForEach(rows.Offsets.size(), [&](vtkIdType i) { rows.Offsets[i] = static_cast<Id>(i); });
  rows.Columns = Buffer<Id>(vertices.size());
  CopyInThreads(vertices.data(), vertices.size(), rows.Columns.data());
  rows.Weights = Buffer<double>(vertices.size(), 1.);
  return rows;
}

/// Keeps the rows that the limits need, level by level. Returns false if one of them lacks entries.
template <typename LevelType>
bool LevelSteps<LevelType>::FollowBack(
  std::vector<Trace>& traces, Id columns, std::vector<Step>& steps) const
{
  steps.clear();
  steps.resize(traces.size());
  for (std::size_t l = traces.size(); l-- > 0;)
  {
    // The vertices that are read on this level, in ascending order, and their new numbers.
    SparseRows<Id>& limits = traces[l].Limits;
    Buffer<unsigned char> isRead(limits.NumberOfColumns, 0);
    const bool isLast = l + 1 == traces.size();
    const auto takeRows = [&isRead](const SparseRows<Id>& rows)
    { ForEachInTurn(rows.Columns.size(), [&](vtkIdType k) { isRead[rows.Columns[k]] = 1; }); };
    takeRows(limits);
    isLast ? void() : takeRows(steps[l + 1].Rows);
    const Selection<Id> kept(isRead);
    const auto lacks = [&](Id vertex) { return !traces[l].Whole[vertex]; };
    if (l > 0 && std::any_of(kept.Old.begin(), kept.Old.end(), lacks))
    {
      return false;
    }
    const auto renumber = [&](SparseRows<Id>& to)
    {
      to.NumberOfColumns = static_cast<Id>(kept.Old.size());
      ForEach(to.Columns.size(), [&](vtkIdType k) { to.Columns[k] = kept.New[to.Columns[k]]; });
    };
    renumber(limits);
    if (!isLast)
    {
      renumber(steps[l + 1].Rows);
    }
    steps[l].Rows = l == 0 ? MakeCopies(kept.Old) : MakeRows(traces[l], kept.Old);
    // Final for level 0; renumber() sets it for the others in the next pass.
    steps[l].Rows.NumberOfColumns = columns;
    steps[l].Limits = std::move(limits);
    steps[l].Vertices = this->Vertices.GetBorn(l);
    traces[l] = Trace();
  }
  return true;
}

/// The arguments are those of LocalLimit, whose levels it has; edges that do not exist are noticed,
/// too. `distance`: at first a part has all vertices within this number of edges of its ancestors.
template <typename LevelType>
class LimitByLevels
{
public:
  using Id = typename LevelType::IdType;

  LimitByLevels(const LevelType& control, const SemiSharpStages<Id>& creases,
    const std::vector<std::array<Id, 2>>& midpoints, int distance = 1)
    : NumberOfColumns(control.Complex.NumberOfVertices)
    , NumberOfRows(NumberOfColumns + static_cast<vtkIdType>(midpoints.size()))
  {
    LocalVertices<Id> vertices(control.Complex.NumberOfVertices, midpoints);
    LevelSteps<LevelType> builder(vertices);
    while (!builder.Build(control, creases, distance, this->Steps))
    {
      ++distance;
    }
  }
  vtkIdType GetNumberOfRows() const { return this->NumberOfRows; }
  vtkIdType GetNumberOfColumns() const { return this->NumberOfColumns; }
  int GetNumberOfLevels() const { return static_cast<int>(this->Steps.size()); }
  const std::vector<Id>& GetVertices(int level) const { return this->Steps[level].Vertices; }
  const SparseRows<Id>& GetLimitsOnLevel(int level) const { return this->Steps[level].Limits; }
  const SparseRows<Id>& GetRowsOfLevel(int level) const { return this->Steps[level].Rows; }

private:
  const vtkIdType NumberOfColumns;
  const vtkIdType NumberOfRows;
  std::vector<LevelStep<Id>> Steps;
};

}

#endif
