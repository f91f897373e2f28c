// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OperatorCache.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

namespace subdivision
{

template <typename Id>
template <typename Level>
bool LimitOperators<Id>::FindFrames(const Level& level, const ControlSolids& solids, int steps)
{
  return BuildSkinTangents(level, solids, steps, this->Frames);
}

template <typename Id>
template <typename Level>
void LimitOperators<Id>::FindFrames(
  const Level& level, const SemiSharpStages<Id>& creases, const ControlSolids& solids)
{
  this->Frames = {};
  this->Frames.Tangents = BuildLimitTangents(level, creases, solids);
}

template <typename Id>
void LimitOperators<Id>::Apply(PointArrays& arrays, const std::vector<vtkIdType>& inverted,
  const Buffer<unsigned char>& turned) const
{
  const vtkIdType size = arrays.GetPoints()->GetNumberOfTuples();
  if (this->HasTangents)
  {
    Buffer<double> values[2];
    this->Frames.ComputeTangents(arrays.GetCoordinates(), size, inverted, turned, values);
    arrays.SetLimitTangents(values);
  }
  if (this->HasNormals && !arrays.HasLimitNormals())
  {
    arrays.SetLimitNormals(
      this->Frames.ComputeNormals(arrays.GetCoordinates(), size, inverted, turned));
  }
  arrays.Project(this->Rows);
}

SUBDIVISION_COMPILE(struct LimitOperators);

#define SUBDIVISION_LIMIT_OPERATORS(Scheme)                                                        \
  template bool LimitOperators<Scheme::Id>::FindFrames(                                            \
    const Scheme::Level&, const ControlSolids&, int);                                              \
  template void LimitOperators<Scheme::Id>::FindFrames(                                            \
    const Scheme::Level&, const SemiSharpStages<Scheme::Id>&, const ControlSolids&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_LIMIT_OPERATORS);

}
