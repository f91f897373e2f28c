// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Steps/SurfaceSteps.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Dual/DualPlaces.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Lists the edges of level `step` that are still sharp. Control edge e has become the 2^step edges
/// from e * 2^step on.
template <typename Id>
std::vector<SharpEdge<Id>> ListEdgesSharpAfter(const EdgeSharpness& sharpness, int step)
{
  std::vector<SharpEdge<Id>> edges;
  for (const std::size_t e : InTurn(sharpness.size()))
  {
    const double left = sharpness[e] - step;
    const vtkIdType first = static_cast<vtkIdType>(e) << step;
    for (vtkIdType i = 0; left > 0. && i < vtkIdType(1) << step; ++i)
    {
      edges.push_back({ static_cast<Id>(first + i), left });
    }
  }
  return edges;
}

/// Flags the edges whose sharpness is at least `least` or, if `more`, larger.
std::vector<bool> GetSharp(const EdgeSharpness& sharpness, double least, bool more)
{
  std::vector<bool> sharp(sharpness.size());
  std::transform(sharpness.begin(), sharpness.end(), sharp.begin(),
    [least, more](double s) { return more ? s > least : s >= least; });
  return sharp;
}

/// The first step after `step` (but at most `most`) in which other edges are sharp, wholly or in
/// part, than in `step`.
int FindEndOfStage(const EdgeSharpness& sharpness, int step, int most)
{
  double end = most;
  for (const double s : InTurn(sharpness))
  {
    for (const double change : { std::floor(s), std::ceil(s) })
    {
      end = change > step ? std::min(end, change) : end;
    }
  }
  return static_cast<int>(end);
}

template <typename Id, typename Out>
void CopyIds(const Buffer<Id>& from, Out* to)
{
  ForEach(from.size(), [&](vtkIdType i) { to[i] = static_cast<Out>(from[i]); });
}

}

template <typename Id>
SurfaceSteps<Id>::SurfaceSteps(SurfaceLevel<Id>&& control,
  std::shared_ptr<const SurfaceScheme<Id>> scheme, int steps, LastLevel last,
  const std::function<bool(double)>& stop, const ClaimedLevel& claimed, CellSplits* splits,
  int firstLeft)
  : Left(static_cast<std::size_t>(steps) + 1)
  , Scheme(std::move(scheme))
  , Last(last)
{
  this->Levels.reserve(steps + 1);
  this->Levels.push_back(std::move(control));
  const SurfaceTags<Id>& given = this->Levels[0].Tags;
  this->GivenEdges = Buffer<EdgeTag>(given.Edges.size());
  this->GivenVertices = Buffer<VertexTag>(given.Vertices.size());
  std::copy(given.Edges.begin(), given.Edges.end(), this->GivenEdges.begin());
  std::copy(given.Vertices.begin(), given.Vertices.end(), this->GivenVertices.begin());
  this->Scheme->RestrictTags(this->Levels[0]);
  const auto isRight = [&](int level) { return !claimed.IsExceededBy(this->Levels[level], level); };
  for (int step = 0; step < steps && isRight(step) && !(stop && stop(0.5 * step / steps)); ++step)
  {
    if (splits && step > 0 && step <= static_cast<int>(splits->Flags.size()))
    {
      this->Leave(step, *splits, step >= firstLeft);
    }
    SurfaceLevel<Id>& level = this->Levels.back();
    if (!this->StartsFromSkipped(step))
    {
      this->Scheme->Prepare(level);
      this->ChooseSkipped(step, steps);
    }
    const bool isLast = step + 1 == steps;
    this->SkipsLast = isLast && !splits && this->SkipsLastAfter(step);
    const bool isWhole = last != LastLevel::ForCells && !this->SkipsLast;
    const Depth depth = isWhole          ? Depth::ForRefinement
      : step >= this->LastMade || isLast ? Depth::ForCounts
      : step + 2 < steps                 ? Depth::ForSteps
                                         : Depth::ForLastStep;
    this->Levels.push_back(this->Scheme->Refine(level, depth));
  }
  if (last != LastLevel::ForCells && !this->SkipsLast)
  {
    this->Scheme->Prepare(this->Levels.back());
  }
}

/// Whether limits of the level after a step can be told from the level before it. Where faces of
/// the control mesh have other orientations than their neighbours, sides of tangents need the
/// level.
template <typename Id>
bool SurfaceSteps<Id>::SkipsLastAfter(int step)
{
  const SurfaceLevel<Id>& level = this->Levels[step];
  const PolygonMesh<Id>& control = this->Levels[0].Mesh;
  if (this->Last == LastLevel::ForCells || this->Last == LastLevel::Whole ||
    !this->Scheme->HasLimitsOfNext(level, this->Last == LastLevel::ForTangents) ||
    !AreAll(control.GetNumberOfCorners(),
      [&control](vtkIdType corner)
      {
        const Id twin = control.Twins[corner];
        return twin < 0 || control.Vertices[twin] != control.Vertices[corner];
      }))
  {
    return false;
  }
  this->Irregular = FindIrregularVertices(level);
  return static_cast<double>(this->Irregular.size()) <=
    MostIrregularVertices * static_cast<double>(level.Mesh.NumberOfVertices);
}

/// Finds the lines and faces of a level that go on; if `crops`, leaves them and their neighbours.
template <typename Id>
void SurfaceSteps<Id>::Leave(int number, CellSplits& splits, bool crops)
{
  SurfaceLevel<Id>& level = this->Levels[number];
  const vtkIdType lines = level.Lines.size();
  std::vector<char> goesOn(static_cast<std::size_t>(lines + level.Mesh.NumberOfFaces), 1);
  const std::vector<char>& before = splits.Made;
  std::vector<vtkIdType> linesOfControl;
  for (const vtkIdType i : InTurn(static_cast<vtkIdType>(goesOn.size())))
  {
    const vtkIdType parent = i < lines ? i / 2 : lines / 2 + (i - lines) / 4;
    goesOn[i] = number == 1 || before[parent];
    if (i < lines)
    {
      linesOfControl.push_back(number == 1 ? parent : this->SplitLines[parent]);
    }
  }
  splits.Leave(number, goesOn);
  if (crops)
  {
    std::vector<Id> vertices;
    std::vector<Id> linesLeft;
    this->SplitLines.clear();
    for (const vtkIdType i : InTurn(static_cast<vtkIdType>(goesOn.size())))
    {
      if (goesOn[i] && i < lines)
      {
        const Id* ends = level.Mesh.EdgeVertices.data() + 2 * vtkIdType(level.Lines[i] / 2);
        vertices.insert(vertices.end(), ends, ends + 2);
        linesLeft.push_back(level.Lines[i]);
        this->SplitLines.push_back(linesOfControl[i]);
      }
      else if (goesOn[i])
      {
        AppendOfFace(level.Mesh, level.Mesh.Vertices, static_cast<Id>(i - lines), vertices);
      }
    }
    SortUnique(vertices);
    SurfacePatch<Id> patch(level, vertices);
    patch.Level.Lines = Buffer<Id>(static_cast<vtkIdType>(linesLeft.size()));
    std::transform(linesLeft.begin(), linesLeft.end(), patch.Level.Lines.begin(),
      [&](Id line) { return 2 * patch.Find(patch.Edges, line / 2) + line % 2; });
    std::vector<char> left(linesLeft.size(), 1);
    for (const Id face : InTurn(patch.Faces))
    {
      left.push_back(goesOn[lines + face]);
    }
    goesOn = std::move(left);
    level = std::move(patch.Level);
    this->Left[number] = { std::move(patch.Vertices), std::move(patch.Faces) };
  }
  else
  {
    this->SplitLines = std::move(linesOfControl);
  }
  splits.Made = std::move(goesOn);
}

/// Decides whether a step skips the level after it, if this is the last one but one.
template <typename Id>
void SurfaceSteps<Id>::ChooseSkipped(int step, int steps)
{
  const SurfaceLevel<Id>& level = this->Levels[step];
  if (this->Last != LastLevel::ForCells || step + 2 != steps || !this->Scheme->SkipsNext(level))
  {
    return;
  }
  this->Irregular = FindIrregularVertices(level);
  if (static_cast<double>(this->Irregular.size()) <=
    MostIrregularVertices * static_cast<double>(level.Mesh.NumberOfVertices))
  {
    this->LastMade = step;
  }
}

template <typename Id>
vtkIdType SurfaceSteps<Id>::GetNumberOfCorners(int level) const
{
  const PolygonMesh<Id>& mesh = this->Levels[level].Mesh;
  return mesh.GetFirstOfCounted(mesh.NumberOfFaces);
}

template <typename Id>
void SurfaceSteps<Id>::WriteFaces(int level, IdsOut ids) const
{
  const Buffer<Id>& vertices = this->Levels[level].Mesh.Vertices;
  if (vertices.empty() && this->GetNumberOfCorners(level) > 0)
  {
    return this->StartsFromSkipped(level - 1)
      ? this->Scheme->WriteFacesOfNext(this->Levels[this->LastMade], ids)
      : this->Scheme->WriteFaces(this->Levels[level - 1], ids);
  }
  std::visit([&vertices](auto* to) { CopyIds(vertices, to); }, ids);
}

template <typename Id>
void SurfaceSteps<Id>::GetParents(int step, vtkIdType row, std::vector<vtkIdType>& parents) const
{
  if (!this->StartsFromSkipped(step))
  {
    const std::vector<Id>& left = this->GetLeft(step + 1);
    return this->Scheme->GetParents(
      this->Levels[step], left.empty() ? row : vtkIdType(left[row]), parents);
  }
  this->Scheme->GetParentsOfNext(this->Levels[this->LastMade], row, parents);
}

template <typename Id>
Buffer<Carrier<Id>> SurfaceSteps<Id>::FindCarriers(int first, int last) const
{
  const int period = this->Scheme->GetCarrierPeriod();
  auto carriers = MakeCarriers<Id>(this->Levels[first].Mesh.NumberOfFaces);
  for (int step = first; step < last; ++step)
  {
    const bool areWhole = period > 0 && (step - first) % period == 0;
    Buffer<Carrier<Id>> children;
    this->Scheme->CarryFaces(this->Levels[step], carriers, areWhole, children);
    carriers = std::move(children);
    const std::vector<Id>& left = this->Left[step + 1].Faces;
    if (!left.empty())
    {
      Buffer<Carrier<Id>> ofLeft(static_cast<vtkIdType>(left.size()));
      std::transform(
        left.begin(), left.end(), ofLeft.begin(), [&](Id face) { return carriers[face]; });
      carriers = std::move(ofLeft);
    }
  }
  return carriers;
}

template <typename Id>
bool SurfaceSteps<Id>::ReplaceSectors(const SurfaceTags<Id>& control)
{
  const bool same = this->GivenEdges.size() == control.Edges.size() &&
    this->GivenVertices.size() == control.Vertices.size() &&
    this->Levels[0].Tags.Sectors.size() == control.Sectors.size() &&
    std::equal(control.Edges.begin(), control.Edges.end(), this->GivenEdges.begin()) &&
    std::equal(control.Vertices.begin(), control.Vertices.end(), this->GivenVertices.begin());
  for (SurfaceLevel<Id>& level : this->Levels)
  {
    std::vector<Sector<Id>>& sectors = level.Tags.Sectors; // in the same order on all levels
    for (std::size_t s = 0; same && s < sectors.size(); ++s)
    {
      sectors[s].Angle = control.Sectors[s].Angle;
      sectors[s].Flatness = control.Sectors[s].Flatness;
    }
  }
  return same;
}

/// The tags that hold in `step`, with the edges of level `level`.
template <typename Id>
SharpTagPair<Id> SurfaceSteps<Id>::FindSharpTags(
  const EdgeSharpness& sharpness, int step, int level, const Classify& classify) const
{
  SharpTagPair<Id> tags = { classify(GetSharp(sharpness, step + 1, false)),
    classify(GetSharp(sharpness, step, true)) };
  for (SurfaceTags<Id>* both : { &tags.Whole, &tags.All })
  {
    for (int i = 0; i < level; ++i)
    {
      *both = this->Scheme->RefineTags(this->Levels[i], *both);
    }
  }
  return tags;
}

template <typename Id>
void SurfaceSteps<Id>::SetSharpness(const EdgeSharpness& sharpness,
  const std::function<SurfaceTags<Id>(const std::vector<bool>& sharpEdges)>& classify)
{
  this->SharpSteps.clear();
  this->Limits = SharpLimits<Id>();
  this->Creases = SharpCreases<Id>();
  const int steps = this->GetNumberOfSteps();
  if (this->LastMade == steps - 2 && IsSharpAfter(sharpness, steps - 1))
  {
    this->Levels[steps - 1] = this->Scheme->Refine(this->Levels[steps - 2], Depth::ForLastStep);
    this->Scheme->Prepare(this->Levels[steps - 1]);
    this->LastMade = std::numeric_limits<int>::max();
  }
  for (int step = 0; step < steps && IsSharpAfter(sharpness, step); ++step)
  {
    this->SharpSteps.emplace_back(this->Levels[step],
      this->FindSharpTags(sharpness, step, step, classify),
      ListEdgesSharpAfter<Id>(sharpness, step));
  }
  if (this->Last == LastLevel::ForCells || !IsSharpAfter(sharpness, steps))
  {
    return;
  }
  if (this->SkipsLast)
  {
    this->Levels[steps] = this->Scheme->Refine(this->Levels[steps - 1], Depth::ForRefinement);
    this->Scheme->Prepare(this->Levels[steps]);
    this->SkipsLast = false;
  }
  // One stage for each range of steps in which the same edges are sharp, wholly or in part.
  this->Creases.Edges = ListEdgesSharpAfter<Id>(sharpness, steps);
  std::vector<SharpTags<Id>>& stages = this->Creases.Stages;
  const int most = steps + SharpLimits<Id>::MostSteps;
  for (int step = steps; IsSharpAfter(sharpness, step) && step < most;
    step = steps + stages.back().Until)
  {
    stages.push_back({ FindEndOfStage(sharpness, step, most) - steps,
      this->FindSharpTags(sharpness, step, steps, classify) });
  }
  this->Limits = SharpLimits<Id>(this->Levels.back(), *this->Scheme, this->Creases);
}

template <typename Id>
BlockOperator<Id> SurfaceSteps<Id>::GetStep(int step) const
{
  const vtkIdType columns = this->Levels[step].Mesh.NumberOfVertices;
  const vtkIdType rows = this->Levels[step + 1].Mesh.NumberOfVertices;
  const std::vector<Id>& left = this->GetLeft(step + 1);
  const auto append = this->MakeStep(step);
  if (left.empty())
  {
    return BlockOperator<Id>(columns, rows, append);
  }
  return BlockOperator<Id>(columns, rows,
    [append, &left](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    {
      for (; begin < end; ++begin)
      {
        append(left[begin], left[begin] + 1, block);
      }
    });
}

/// The rows of all that a step makes.
template <typename Id>
typename BlockOperator<Id>::Append SurfaceSteps<Id>::MakeStep(int step) const
{
  const SurfaceLevel<Id>& level = this->Levels[step];
  if (step < static_cast<int>(this->SharpSteps.size()))
  {
    return [this, step, &level](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { this->SharpSteps[step].Append(*this->Scheme, level, begin, end, block); };
  }
  if (this->StartsFromSkipped(step))
  {
    const SurfaceLevel<Id>& before = this->Levels[this->LastMade];
    const auto others =
      std::make_shared<const IrregularRows<Id>>(*this->Scheme, before, this->Irregular, true);
    return [this, &before, others](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { this->Scheme->AppendRowsOfNext(before, *others, begin, end, block); };
  }
  return [this, &level](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
  { this->Scheme->AppendRows(level, level.Tags, begin, end, block); };
}

template <typename Id>
BlockOperator<Id> SurfaceSteps<Id>::GetLimit(LimitKind kind) const
{
  const vtkIdType vertices = this->Levels.back().Mesh.NumberOfVertices;
  return BlockOperator<Id>(vertices, vertices,
    [append = this->MakeLimits(), kind](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { append(kind, begin, end, block); });
}

template <typename Id>
typename SurfaceSteps<Id>::AppendLimits SurfaceSteps<Id>::MakeLimits() const
{
  if (this->SkipsLast)
  {
    const SurfaceLevel<Id>& before = *this->GetLevelOfLimits();
    const auto others =
      std::make_shared<const IrregularRows<Id>>(*this->Scheme, before, this->Irregular, false);
    return
      [this, &before, others](LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
    { this->Scheme->AppendLimitRowsOfNext(before, *others, kind, begin, end, rows); };
  }
  const SurfaceLevel<Id>& level = this->Levels.back();
  return [this, &level](LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
  {
    this->Limits.ForEachOther(
      begin, end, [&](vtkIdType first, vtkIdType last)
      { this->Scheme->AppendLimitRows(level, level.Tags, kind, first, last, rows); },
      [&](vtkIdType at) { this->Limits.Append(at, kind, rows); });
  };
}

template <typename Id>
void SurfaceSteps<Id>::ForgetBefore(int level)
{
  // The step from a level that was skipped begins at the one before.
  const int end = std::min(level, this->LastMade);
  for (int i = 0; i < end; ++i)
  {
    SurfaceLevel<Id> counts;
    counts.Step = this->Levels[i].Step;
    counts.Mesh.NumberOfVertices = this->Levels[i].Mesh.NumberOfVertices;
    counts.Mesh.NumberOfFaces = this->Levels[i].Mesh.NumberOfFaces;
    counts.Mesh.Arity = this->Levels[i].Mesh.Arity;
    this->Levels[i] = std::move(counts);
  }
}

template <typename Id>
SurfaceSegments SurfaceSteps<Id>::ListSegments() const
{
  using Kinds = SurfaceSegments;
  const SurfaceLevel<Id>& control = this->Levels[0];
  SurfaceSegments segments;
  segments.Sizes = { control.Mesh.NumberOfVertices, control.Mesh.GetNumberOfEdges(),
    control.Mesh.NumberOfFaces, control.Lines.size() };
  segments.Vertices = { { Kinds::Vertex, 1, {} } };
  segments.Edges = { { Kinds::Edge, 1, {} } };
  segments.Faces = { { Kinds::Face, 1, {} } };
  segments.Lines = { { Kinds::Line, 1, {} } };
  if (this->Scheme->NeedsTriangles())
  {
    segments.Corners = { { Kinds::Face, 3, {} } };
  }
  else // faces of other parts may have other sizes
  {
    AppendVariedChildren(
      segments.Faces, segments.Sizes, [&control](vtkIdType face)
      { return control.Mesh.GetFirst(static_cast<Id>(face)); }, segments.Corners);
  }
  for (int step = 0; step < this->GetNumberOfSteps(); ++step)
  {
    SurfaceSegments children;
    children.Sizes = segments.Sizes;
    this->Scheme->ListChildren(this->Levels[step], segments, children);
    segments = std::move(children);
  }
  return segments;
}

template <typename Id>
std::size_t SurfaceSteps<Id>::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const SurfaceLevel<Id>& level : this->Levels)
  {
    bytes += level.Mesh.GetMemorySize() + level.Tags.Edges.GetMemorySize() +
      level.Tags.Vertices.GetMemorySize() + level.Lines.GetMemorySize() +
      level.Places.GetMemorySize() + (level.Dual ? level.Dual->GetMemorySize() : 0);
  }
  return bytes;
}

SUBDIVISION_COMPILE(class SurfaceSteps);

}
