// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeSchemes.h
 * The list of volume schemes (SolidScheme.h). To add a scheme, include it and add it to the list
 * and to VolumeLevel.
 */
#ifndef SubdivisionObjects_VolumeSchemes_h
#define SubdivisionObjects_VolumeSchemes_h

#include "Core/Solids/BoxSpline/BoxSplineScheme.h"
#include "Core/Solids/Linear/LinearScheme.h"
#include "Core/Solids/TetOct/TetOctScheme.h"

#include <type_traits>
#include <variant>

/// ACT(scheme) for each scheme, to compile templates for it.
#define SUBDIVISION_FOR_VOLUME_SCHEMES(ACT)                                                        \
  ACT(BoxSplineScheme<int>);                                                                       \
  ACT(BoxSplineScheme<long long>);                                                                 \
  ACT(TetOctScheme<int>);                                                                          \
  ACT(TetOctScheme<long long>);                                                                    \
  ACT(LinearScheme<int>);                                                                          \
  ACT(LinearScheme<long long>)

namespace subdivision
{

/// A level of any scheme.
using VolumeLevel = std::variant<BoxSplineScheme<int>::Level, BoxSplineScheme<long long>::Level,
  TetOctScheme<int>::Level, TetOctScheme<long long>::Level, LinearScheme<int>::Level,
  LinearScheme<long long>::Level>;

/// act(scheme) for each scheme with ids of type Id; `scheme` has no values, only its type counts.
template <typename Id, typename Act>
void ForVolumeSchemes(const Act& act)
{
#define SUBDIVISION_ACT(Scheme)                                                                    \
  if constexpr (std::is_same<Id, Scheme::Id>::value)                                               \
  {                                                                                                \
    act(Scheme());                                                                                 \
  }
  SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_ACT);
#undef SUBDIVISION_ACT
}

/// The traits of the scheme with this number; null if there is none.
inline const SchemeTraits* FindSchemeTraits(int number)
{
  const SchemeTraits* found = nullptr;
  ForVolumeSchemes<int>([&](auto scheme)
    { found = decltype(scheme)::Traits.Number == number ? &decltype(scheme)::Traits : found; });
  return found;
}

}

#endif
