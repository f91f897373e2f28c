// SPDX-License-Identifier: BSD-3-Clause
// A file of its own: for all types of values it takes as long to compile as ApplyRows.cxx.
#include "Core/Operators/Appliers.h"
#include "Core/Operators/ChainSums.h"

#include <algorithm>

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
    SumChains(
      view, OneArray<N, In, Out>{ static_cast<const In*>(in), static_cast<Out*>(out), components });
  }
};

/// Takes pairs of vectors and scalars from `arrays`.
std::vector<VectorsAndScalars> TakePairs(std::vector<MovedArray>& arrays)
{
  const auto take = [&arrays](int components)
  {
    std::vector<MovedArray> taken;
    for (const MovedArray& array : arrays)
    {
      if (array.Components == components && array.InType == VTK_DOUBLE &&
        array.OutType == VTK_DOUBLE)
      {
        taken.push_back(array);
      }
    }
    return taken;
  };
  const std::vector<MovedArray> vectors = take(3);
  const std::vector<MovedArray> scalars = take(1);
  std::vector<VectorsAndScalars> pairs;
  for (std::size_t i = 0; i < std::min(vectors.size(), scalars.size()); ++i)
  {
    const auto in = [](const MovedArray& array) { return static_cast<const double*>(array.In); };
    const auto out = [](const MovedArray& array) { return static_cast<double*>(array.Out); };
    pairs.push_back({ in(vectors[i]), in(scalars[i]), out(vectors[i]), out(scalars[i]) });
    const auto isOfPair = [&](const MovedArray& array)
    { return array.Out == vectors[i].Out || array.Out == scalars[i].Out; };
    arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isOfPair), arrays.end());
  }
  return pairs;
}

}

void ApplyChains(const ChainOperator& operation, const std::vector<MovedArray>& arrays)
{
  std::vector<MovedArray> single = arrays;
  const std::vector<VectorsAndScalars> pairs = TakePairs(single);
  const Appliers<ChainBlocks> appliers(single);
  operation.ForEachChains(
    [&](const ChainOperator::ChainsView& view)
    {
      for (const VectorsAndScalars& pair : pairs)
      {
        SumChains(view, pair);
      }
      appliers.Apply(view);
    });
}

}
