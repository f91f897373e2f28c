// SPDX-License-Identifier: BSD-3-Clause
// A file of its own: for all types of values it takes as long to compile as ApplyRows.cxx.
#include "Core/Operators/Appliers.h"
#include "Core/Operators/ChainSums.h"

namespace subdivision
{
namespace
{

struct ChainBlocks
{
  using View = ChainOperator::ChainsView;
  static constexpr int MostKnown = 3;

  template <int N, typename In, typename Out>
  static void Apply(const View& view, const void* in, void* out, int components)
  {
    std::visit([&](const auto& chains)
      { SumChains<N>(chains, static_cast<const In*>(in), static_cast<Out*>(out), components); },
      view);
  }
};

}

void ApplyChains(const ChainOperator& operation, const std::vector<MovedArray>& arrays)
{
  const Appliers<ChainBlocks> appliers(arrays);
  operation.ForEachChains([&](const ChainOperator::ChainsView& view) { appliers.Apply(view); });
}

}
