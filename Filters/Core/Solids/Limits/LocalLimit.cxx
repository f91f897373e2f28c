// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LocalLimit.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Selection.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LocalVertices.h"
#include "Core/Solids/Limits/Restriction.h"
#include "Core/Solids/Scheme/SharpSectors.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace subdivision
{

namespace
{

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

}

/**
 * Builds the steps of a LocalLimit. Forward it makes the levels, each from a part of the one
 * before, and the wanted limit rows on them; backward it finds the rows that these need.
 */
template <typename Id>
template <typename LevelType>
class LocalLimit<Id>::Builder
{
public:
  Builder(LocalVertices<Id>& vertices, const ControlSolids* solids)
    : Vertices(vertices)
    , Solids(solids)
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
    // These are empty where no normals are made:
    std::vector<vtkIdType> Solids; ///< the number of the control solid in which each solid lies
    ShadingCells<Id> Cells;
  };
  /// The kept part of a level: limit rows over its vertices, and the rows of the step that leads to
  /// it.
  struct Trace
  {
    SparseRows<Id> Limits;
    LimitTangents<Id> Tangents;
    // These are empty on the control level:
    Buffer<Id> Columns; ///< the vertices of the level before to which the operators' columns belong
    Stencils<Id> Smooth;
    Stencils<Id> Sharp;          ///< where creases are still sharp
    std::vector<double> Weights; ///< of the sharp rows; empty: all 0
    Buffer<unsigned char> Whole; ///< rows of which nothing is missing
  };

  void MakeLimits(const LevelType& level, const SemiSharpStages<Id>& creases, const Piece& piece,
    std::size_t number, Trace& trace) const;
  void FindControlParts(const LevelType& control, Piece& piece) const;
  void FollowParts(const Restriction<LevelType>& restriction, Piece& piece) const;
  static SemiSharpStages<Id> RefineCreases(Piece& part, const SimplicialComplex<Id>& children);
  static void TakeOperators(Piece& part, Trace& trace);
  static SparseRows<Id> MakeRows(const Trace& trace, const Buffer<Id>& vertices);
  static SparseRows<Id> MakeCopies(const Buffer<Id>& vertices);
  bool FollowBack(std::vector<Trace>& traces, Id columns, std::vector<Step>& steps) const;

  LocalVertices<Id>& Vertices;
  const ControlSolids* const Solids; ///< null: no normals are made
};

/// Makes the limit rows of the vertices of a level, and their tangents; `piece` knows where the
/// level's cells lie.
template <typename Id>
template <typename LevelType>
void LocalLimit<Id>::Builder<LevelType>::MakeLimits(const LevelType& level,
  const SemiSharpStages<Id>& creases, const Piece& piece, std::size_t number, Trace& trace) const
{
  const Buffer<Id> vertices = this->Vertices.FindWantedOnPart(number);
  trace.Limits = BuildLimitRows(level, creases, vertices);
  if (this->Solids)
  {
    const ControlSolids solids{ piece.Solids, 0, true };
    trace.Tangents = BuildLimitTangents(level, creases, solids, vertices);
    for (Id& triangle : trace.Tangents.Triangles)
    {
      triangle = triangle < 0 ? triangle : piece.Cells.Triangles[triangle];
    }
    const Buffer<unsigned char> missing = trace.Tangents.FindMissing();
    Buffer<Id> rows(level.Complex.NumberOfVertices, Id(-1));
    for (Id row = 0; row < static_cast<Id>(missing.size()); ++row)
    {
      rows[vertices[row]] = missing[row] ? row : Id(-1);
    }
    trace.Tangents.Shading = BuildShadingStars(
      level, creases, solids, piece.Cells, rows, this->Solids->Steps + static_cast<int>(number));
  }
}

/// Finds where the cells of the level lie from which the steps start.
template <typename Id>
template <typename LevelType>
void LocalLimit<Id>::Builder<LevelType>::FindControlParts(
  const LevelType& control, Piece& piece) const
{
  if (this->Solids)
  {
    const typename SchemeOf<LevelType>::ControlTets tets(control, this->Solids->Steps);
    const vtkIdType size =
      vtkIdType(control.Complex.NumberOfTets) + SchemeOf<LevelType>::CountCentres(control);
    for (vtkIdType solid = 0; solid < size; ++solid)
    {
      const vtkIdType tet = tets.Find(static_cast<Id>(solid));
      piece.Solids.push_back(this->Solids->Numbers.empty() ? tet : this->Solids->Numbers[tet]);
    }
    piece.Cells = FindShadingCells(control, this->Solids->Steps);
  }
}

/// The same after one step, in which the level before was restricted.
template <typename Id>
template <typename LevelType>
void LocalLimit<Id>::Builder<LevelType>::FollowParts(
  const Restriction<LevelType>& restriction, Piece& piece) const
{
  if (!this->Solids)
  {
    return;
  }
  // What each tetrahedron and each octahedron becomes.
  constexpr bool hasPieces = SchemeOf<LevelType>::Traits.HasPieces;
  constexpr std::size_t children[2][2] = { { hasPieces ? 4 : 8, 8 }, { hasPieces ? 1 : 0, 6 } };
  const vtkIdType tets = restriction.GetNumberOfTets();
  std::vector<vtkIdType> solids;
  for (const auto& ofKind : children)
  {
    for (const Id old : restriction.GetOldTets())
    {
      solids.insert(solids.end(), ofKind[0], piece.Solids[old]);
    }
    for (const Id old : restriction.GetOldOcts())
    {
      solids.insert(solids.end(), ofKind[1], piece.Solids[tets + old]);
    }
  }
  ShadingCells<Id> cells; // new vertices are no cells
  for (const Id old : restriction.GetOldFaces())
  {
    const auto face = static_cast<std::size_t>(old);
    cells.Triangles.insert(cells.Triangles.end(), 4,
      face < piece.Cells.Triangles.size() ? piece.Cells.Triangles[face] : Id(-1));
  }
  for (const Id old : restriction.GetOldEdges())
  {
    const auto edge = static_cast<std::size_t>(old);
    cells.Lines.insert(
      cells.Lines.end(), 2, edge < piece.Cells.Lines.size() ? piece.Cells.Lines[edge] : char(0));
  }
  piece.Solids = std::move(solids);
  piece.Cells = std::move(cells);
}

template <typename Id>
template <typename LevelType>
SemiSharpStages<Id> LocalLimit<Id>::Builder<LevelType>::RefineCreases(
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
template <typename Id>
template <typename LevelType>
void LocalLimit<Id>::Builder<LevelType>::TakeOperators(Piece& part, Trace& trace)
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

template <typename Id>
template <typename LevelType>
bool LocalLimit<Id>::Builder<LevelType>::Build(const LevelType& control,
  const SemiSharpStages<Id>& creases, int distance, std::vector<Step>& steps)
{
  this->Vertices.StartOnControl();
  const std::size_t levels = this->Vertices.GetNumberOfLevels();
  std::vector<Trace> traces(levels);
  const LevelType* level = &control;
  const SemiSharpStages<Id>* levelCreases = &creases;
  Piece current; // what the two point to from level 1 on
  this->FindControlParts(control, current);
  for (std::size_t l = 0; l < levels; ++l)
  {
    this->MakeLimits(*level, *levelCreases, current, l, traces[l]);
    if (l + 1 == levels)
    {
      break;
    }
    const Buffer<unsigned char> support = this->Vertices.FlagSupport(*level, l, distance);
    const Restriction<LevelType> restriction(*level, support);
    const Buffer<Id>& old = restriction.GetOldVertices();
    Piece part;
    part.Level = restriction.Restrict();
    part.Creases = restriction.Restrict(*levelCreases);
    this->Vertices.FollowToPart(part.Level, restriction.GetNewVertices(), l);
    current.Level = LevelType(); // nothing reads it any more
    Trace& next = traces[l + 1];
    next.Whole = restriction.FlagWhole(part.Level, current.Whole);
    next.Columns = Buffer<Id>(old.size());
    CopyInThreads(old.data(), old.size(), next.Columns.data());
    current.Level = Refine(part.Level, Depth::ForRefinement);
    current.Creases = RefineCreases(part, current.Level.Complex);
    this->FollowParts(restriction, current);
    TakeOperators(part, next);
    current.Whole = Buffer<unsigned char>(next.Whole.size());
    CopyInThreads(next.Whole.data(), next.Whole.size(), current.Whole.data());
    level = &current.Level;
    levelCreases = &current.Creases;
  }
  return this->FollowBack(traces, control.Complex.NumberOfVertices, steps);
}

/// The rows of some vertices of a level, with columns on the level before.
template <typename Id>
template <typename LevelType>
SparseRows<Id> LocalLimit<Id>::Builder<LevelType>::MakeRows(
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
template <typename Id>
template <typename LevelType>
SparseRows<Id> LocalLimit<Id>::Builder<LevelType>::MakeCopies(const Buffer<Id>& vertices)
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
template <typename Id>
template <typename LevelType>
bool LocalLimit<Id>::Builder<LevelType>::FollowBack(
  std::vector<Trace>& traces, Id columns, std::vector<Step>& steps) const
{
  steps.clear();
  steps.resize(traces.size());
  for (std::size_t l = traces.size(); l-- > 0;)
  {
    // The vertices that are read on this level, in ascending order, and their new numbers.
    SparseRows<Id>& limits = traces[l].Limits;
    Buffer<unsigned char> isRead(limits.NumberOfColumns, 0);
    LimitTangents<Id>& tangents = traces[l].Tangents;
    const bool isLast = l + 1 == traces.size();
    const auto takeRows = [&isRead](const SparseRows<Id>& rows)
    { ForEachInTurn(rows.Columns.size(), [&](vtkIdType k) { isRead[rows.Columns[k]] = 1; }); };
    takeRows(limits);
    takeRows(tangents.First);
    takeRows(tangents.Second);
    takeRows(tangents.Shading.Rows);
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
    renumber(tangents.First);
    renumber(tangents.Second);
    renumber(tangents.Shading.Rows);
    if (!isLast)
    {
      renumber(steps[l + 1].Rows);
    }
    steps[l].Rows = l == 0 ? MakeCopies(kept.Old) : MakeRows(traces[l], kept.Old);
    // Final for level 0; renumber() sets it for the others in the next pass.
    steps[l].Rows.NumberOfColumns = columns;
    steps[l].Limits = std::move(limits);
    steps[l].Tangents = std::move(tangents);
    steps[l].Vertices = this->Vertices.GetWanted(l);
    traces[l] = Trace();
  }
  return true;
}

template <typename Id>
template <typename LevelType>
LocalLimit<Id>::LocalLimit(const LevelType& control, const SemiSharpStages<Id>& creases,
  const std::vector<std::array<Id, 2>>& midpoints, const Buffer<unsigned char>& wanted,
  int distance, const ControlSolids* solids)
  : NumberOfRows(control.Complex.NumberOfVertices + static_cast<vtkIdType>(midpoints.size()))
  , NumberOfColumns(control.Complex.NumberOfVertices)
{
  LocalVertices<Id> vertices(control.Complex.NumberOfVertices, midpoints, wanted);
  Builder<LevelType> builder(vertices, solids);
  while (!builder.Build(control, creases, distance, this->Steps))
  {
    ++distance;
  }
}

SUBDIVISION_COMPILE(class LocalLimit);
#define SUBDIVISION_LOCAL(Level)                                                                   \
  template LocalLimit<Level::IdType>::LocalLimit(const Level&,                                     \
    const SemiSharpStages<Level::IdType>&, const std::vector<std::array<Level::IdType, 2>>&,       \
    const Buffer<unsigned char>&, int, const ControlSolids*)
SUBDIVISION_LOCAL(Level<int>);
SUBDIVISION_LOCAL(Level<long long>);
SUBDIVISION_LOCAL(TetOctLevel<int>);
SUBDIVISION_LOCAL(TetOctLevel<long long>);

}
