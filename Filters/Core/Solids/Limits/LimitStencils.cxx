// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LevelStar.h"

namespace subdivision
{

template <typename Level>
SparseRows<typename Level::IdType> BuildLimitRows(
  const Level& level, const SemiSharpStages<typename Level::IdType>& creases)
{
  using Id = typename Level::IdType;
  return MakeLimitRows<LevelStar<SchemeOf<Level>>>(
    level, creases, level.Complex.NumberOfVertices, [](vtkIdType i) { return static_cast<Id>(i); });
}

template <typename Level>
SparseRows<typename Level::IdType> BuildLimitRows(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases,
  const Buffer<typename Level::IdType>& vertices)
{
  return MakeLimitRows<LevelStar<SchemeOf<Level>>>(
    level, creases, vertices.size(), [&vertices](vtkIdType i) { return vertices[i]; });
}

#define SUBDIVISION_LIMIT(Scheme)                                                                  \
  template SparseRows<Scheme::Id> BuildLimitRows(                                                  \
    const Scheme::Level&, const SemiSharpStages<Scheme::Id>&);                                     \
  template SparseRows<Scheme::Id> BuildLimitRows(                                                  \
    const Scheme::Level&, const SemiSharpStages<Scheme::Id>&, const Buffer<Scheme::Id>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_LIMIT);

}
