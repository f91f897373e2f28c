// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSchemes.h"

#include "ButterflyScheme.h"
#include "CatmullClarkScheme.h"
#include "DooSabinScheme.h"
#include "FourEightScheme.h"
#include "LoopScheme.h"
#include "MidedgeScheme.h"
#include "SqrtThreeScheme.h"

namespace subdivision
{

template <typename Id>
std::shared_ptr<const SurfaceScheme<Id>> MakeSurfaceScheme(
  SurfaceSchemeKind kind, bool modifiedBoundary)
{
  switch (kind)
  {
    case SurfaceSchemeKind::Loop:
      return MakeLoopScheme<Id>(modifiedBoundary);
    case SurfaceSchemeKind::CatmullClark:
      return MakeCatmullClarkScheme<Id>(modifiedBoundary);
    case SurfaceSchemeKind::ModifiedButterfly:
      return MakeButterflyScheme<Id>();
    case SurfaceSchemeKind::FourEight:
      return MakeFourEightScheme<Id>();
    case SurfaceSchemeKind::SqrtThree:
      return MakeSqrtThreeScheme<Id>();
    case SurfaceSchemeKind::DooSabin:
      return MakeDooSabinScheme<Id>();
    case SurfaceSchemeKind::Midedge:
      return MakeMidedgeScheme<Id>();
    default:
      return nullptr;
  }
}

template std::shared_ptr<const SurfaceScheme<int>> MakeSurfaceScheme(SurfaceSchemeKind, bool);
template std::shared_ptr<const SurfaceScheme<long long>> MakeSurfaceScheme(SurfaceSchemeKind, bool);

}
