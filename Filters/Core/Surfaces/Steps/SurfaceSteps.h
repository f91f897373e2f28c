// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSteps.h
 * The levels of a surface and the operators between them, with semi-sharp creases.
 */
#ifndef SubdivisionObjects_SurfaceSteps_h
#define SubdivisionObjects_SurfaceSteps_h

#include "Core/Memory/CellSplits.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Rules/Sharpness.h"
#include "Core/Surfaces/Scheme/SharpLimits.h"
#include "Core/Surfaces/Scheme/SurfaceTags.h"

#include <functional>
#include <limits>

namespace subdivision
{

/// How many faces and lines a level is said to have. No level before it has more, because a step
/// makes one or more of each.
struct ClaimedLevel
{
  int Level = -1; ///< nothing is claimed
  vtkIdType Faces = 0;
  vtkIdType Lines = 0;

  template <typename Id>
  bool IsExceededBy(const SurfaceLevel<Id>& level, int number) const
  {
    return number <= this->Level &&
      (level.Mesh.NumberOfFaces > this->Faces || level.Lines.size() > this->Lines);
  }
};

/// How much there is of the last level: what its cells need, or what limits and their tangents
/// need, too, or all.
enum class LastLevel
{
  ForCells,
  ForPositions,
  ForTangents,
  Whole
};

template <typename Id>
class SurfaceSteps
{
public:
  /// Makes the levels. `control` is level 0 with its tags. `stop(part)` receives
  /// the progress and returns true to stop; then there are fewer levels than asked for, as where a
  /// level exceeds `claimed`. Where `splits` say which lines and faces go on, levels from
  /// `firstLeft` on have only these, and faces on which they depend.
  SurfaceSteps(SurfaceLevel<Id>&& control, std::shared_ptr<const SurfaceScheme<Id>> scheme,
    int steps, LastLevel last, const std::function<bool(double)>& stop,
    const ClaimedLevel& claimed = ClaimedLevel(), CellSplits* splits = nullptr, int firstLeft = 1);

  /// Replaces angles and flatness of the sectors by the values of `control` on all levels. Returns
  /// false, and changes nothing, if other tags differ.
  bool ReplaceSectors(const SurfaceTags<Id>& control);

  /// Sets the semi-sharp creases: one sharpness for each control edge, or none at all.
  /// classify(edges) returns the tags of the control level with these edges as creases too.
  void SetSharpness(const EdgeSharpness& sharpness,
    const std::function<SurfaceTags<Id>(const std::vector<bool>& sharpEdges)>& classify);

  int GetNumberOfSteps() const { return static_cast<int>(this->Levels.size()) - 1; }
  /// The number of the first steps in which edges are semi-sharp.
  int GetNumberOfSharpSteps() const { return static_cast<int>(this->SharpSteps.size()); }
  const SurfaceLevel<Id>& GetLevel(int level) const { return this->Levels[level]; }
  /// The number of corners of a level, and the vertex of each. The last level may not store them
  /// (Depth::ForCounts); WriteFaces then computes them.
  vtkIdType GetNumberOfCorners(int level) const;
  void WriteFaces(int level, IdsOut ids) const;
  const SurfaceScheme<Id>& GetScheme() const { return *this->Scheme; }
  /// The vertices that are left after a step to a level, by their numbers before; empty: all.
  const std::vector<Id>& GetLeft(int level) const { return this->Left[level].Vertices; }
  /// The control line of each line of the level where `splits` end.
  const std::vector<vtkIdType>& GetSplitLines() const { return this->SplitLines; }
  /// SurfaceScheme::GetParents for a step.
  void GetParents(int step, vtkIdType row, std::vector<vtkIdType>& parents) const;

  /// For each face of level `last` its carrier on level `first`.
  Buffer<Carrier<Id>> FindCarriers(int first, int last) const;

  BlockOperator<Id> GetStep(int step) const;
  /// The limits of the vertices of the last level, which must be there for limits.
  BlockOperator<Id> GetLimit(LimitKind kind) const;
  /// Appends rows [begin, end) of this operator, as long as this object lives.
  using AppendLimits =
    std::function<void(LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)>;
  AppendLimits MakeLimits() const;
  /// The level before the last one, if of this one only counts are there, although limits are.
  const SurfaceLevel<Id>* GetLevelOfLimits() const
  {
    return this->SkipsLast ? &this->Levels[this->Levels.size() - 2] : nullptr;
  }
  /// The creases of that level which are still sharp.
  const SharpCreases<Id>& GetSharpCreases() const { return this->Creases; }

  /// Lets go of all levels before this one, where no later level needs them; their counts stay.
  /// Then nobody may ask for more of them.
  void ForgetBefore(int level);

  /// The order of the ids of the last level.
  SurfaceSegments ListSegments() const;

  std::size_t GetMemorySize() const;

private:
  using Classify = std::function<SurfaceTags<Id>(const std::vector<bool>& sharpEdges)>;
  SharpTagPair<Id> FindSharpTags(
    const EdgeSharpness& sharpness, int step, int level, const Classify& classify) const;

  void Leave(int level, CellSplits& splits, bool crops);
  typename BlockOperator<Id>::Append MakeStep(int step) const;
  void ChooseSkipped(int step, int steps);
  bool SkipsLastAfter(int step);
  /// Whether the level before a step has only its counts and lines (SkippedLevel.h).
  bool StartsFromSkipped(int step) const { return step > this->LastMade; }

  struct LeftParts
  {
    std::vector<Id> Vertices;
    std::vector<Id> Faces;
  };

  std::vector<SurfaceLevel<Id>> Levels;
  std::vector<LeftParts> Left; ///< of each level; empty: all
  std::vector<vtkIdType> SplitLines;
  std::vector<SharpRows<Id>> SharpSteps; ///< the first steps, in which edges are still sharp
  SharpCreases<Id> Creases; ///< that are still sharp after the last step, where limits are known
  SharpLimits<Id> Limits;   ///< at vertices near these
  std::shared_ptr<const SurfaceScheme<Id>> Scheme;
  LastLevel Last;
  bool SkipsLast = false; ///< limits come from the level before
  /// If the last level but one is skipped, the one before it.
  int LastMade = std::numeric_limits<int>::max();
  std::vector<Id> Irregular; ///< FindIrregularVertices of that level, or of the one before the last
  /// The control level's tags as they were given.
  Buffer<EdgeTag> GivenEdges;
  Buffer<VertexTag> GivenVertices;
};

}

#endif
