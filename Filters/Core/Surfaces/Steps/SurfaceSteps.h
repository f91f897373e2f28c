// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSteps.h
 * The levels of a surface and the operators between them; creases that are sharp for some levels.
 */
#ifndef SubdivisionObjects_SurfaceSteps_h
#define SubdivisionObjects_SurfaceSteps_h

#include "Core/Operators/BlockOperator.h"
#include "Core/Rules/Sharpness.h"
#include "Core/Surfaces/Scheme/SharpLimits.h"
#include "Core/Surfaces/Scheme/SurfaceTags.h"

#include <functional>

namespace subdivision
{

template <typename Id>
class SurfaceSteps
{
public:
  /// `control` with tags. The last level has what its cells need, or with `lastIsWhole` all.
  /// `stop(part)`: true to give up; then there are too few levels.
  SurfaceSteps(SurfaceLevel<Id>&& control, std::shared_ptr<const SurfaceScheme<Id>> scheme,
    int steps, bool lastIsWhole, const std::function<bool(double)>& stop);

  /// The same levels with other angles and flatness of corners. False if the tags differ otherwise.
  bool ReplaceSectors(const SurfaceTags<Id>& control);

  /// Creases that are sharp for some levels: one value for each control edge, or nothing;
  /// `classify` gives the control level's tags with other edges sharp too.
  void SetSharpness(const EdgeSharpness& sharpness,
    const std::function<SurfaceTags<Id>(const std::vector<bool>& sharpEdges)>& classify);

  int GetNumberOfSteps() const { return static_cast<int>(this->Levels.size()) - 1; }
  const SurfaceLevel<Id>& GetLevel(int level) const { return this->Levels[level]; }
  /// The vertices of a level's faces, one face after the other: the last level may have none.
  vtkIdType GetNumberOfCorners(int level) const;
  template <typename Out>
  void WriteFaces(int level, Out* ids) const;
  const SurfaceScheme<Id>& GetScheme() const { return *this->Scheme; }

  BlockOperator<Id> GetStep(int step) const;
  /// Of the vertices of the last level, which is to be whole.
  BlockOperator<Id> GetLimit(LimitKind kind) const;

  std::size_t GetMemorySize() const;

private:
  using Classify = std::function<SurfaceTags<Id>(const std::vector<bool>& sharpEdges)>;
  SharpTagPair<Id> FindSharpTags(
    const EdgeSharpness& sharpness, int step, int level, const Classify& classify) const;

  std::vector<SurfaceLevel<Id>> Levels;
  std::vector<SharpRows<Id>> SharpSteps; ///< as long as something is sharp
  SharpLimits<Id> Limits;                ///< where something still is after the last step
  std::shared_ptr<const SurfaceScheme<Id>> Scheme;
  bool LastIsWhole;
  /// The control level's tags as they were given.
  Buffer<EdgeTag> GivenEdges;
  Buffer<VertexTag> GivenVertices;
};

}

#endif
