// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Steps/SurfaceSchemes.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Butterfly/ButterflyScheme.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkScheme.h"
#include "Core/Surfaces/Dual/DooSabinScheme.h"
#include "Core/Surfaces/Dual/MidedgeScheme.h"
#include "Core/Surfaces/FourEight/FourEightScheme.h"
#include "Core/Surfaces/Linear/LinearScheme.h"
#include "Core/Surfaces/Loop/LoopScheme.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeScheme.h"

namespace subdivision
{

template <typename Id>
std::shared_ptr<const SurfaceScheme<Id>> MakeSurfaceScheme(
  SurfaceSchemeKind kind, bool modifiedBoundary, LoopWeights weights)
{
  switch (kind)
  {
    case SurfaceSchemeKind::Loop:
      return MakeLoopScheme<Id>(modifiedBoundary, weights);
    case SurfaceSchemeKind::CatmullClark:
      return MakeCatmullClarkScheme<Id>(modifiedBoundary);
    case SurfaceSchemeKind::ModifiedButterfly:
      return MakeButterflyScheme<Id>();
    case SurfaceSchemeKind::FourEight:
      return MakeFourEightScheme<Id>(modifiedBoundary);
    case SurfaceSchemeKind::SqrtThree:
      return MakeSqrtThreeScheme<Id>(modifiedBoundary);
    case SurfaceSchemeKind::DooSabin:
      return MakeDooSabinScheme<Id>();
    case SurfaceSchemeKind::Midedge:
      return MakeMidedgeScheme<Id>();
    case SurfaceSchemeKind::Linear:
      return MakeLinearScheme<Id>();
    default:
      return nullptr;
  }
}

SUBDIVISION_COMPILE_FUNCTION(MakeSurfaceScheme);

}
