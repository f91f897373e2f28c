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

/// Takes pairs of vectors and scalars of a type from `arrays`.
template <typename T>
std::vector<VectorsAndScalars<T>> TakePairs(int type, std::vector<MovedArray>& arrays)
{
  const auto find = [&](int components)
  {
    return std::find_if(arrays.begin(), arrays.end(), [=](const MovedArray& array)
      { return array.Components == components && array.InType == type && array.OutType == type; });
  };
  std::vector<VectorsAndScalars<T>> pairs;
  for (auto a = find(3), b = find(1); a != arrays.end() && b != arrays.end();
    a = find(3), b = find(1))
  {
    const auto in = [](const MovedArray& array) { return static_cast<const T*>(array.In); };
    const auto out = [](const MovedArray& array) { return static_cast<T*>(array.Out); };
    pairs.push_back({ in(*a), in(*b), out(*a), out(*b) });
    arrays.erase(std::max(a, b));
    arrays.erase(std::min(a, b));
  }
  return pairs;
}

/// Sums the chains of pairs.
template <typename T>
void SumPairs(const ChainOperator::ChainsView& view, const std::vector<VectorsAndScalars<T>>& pairs)
{
  for (const VectorsAndScalars<T>& pair : pairs)
  {
    SumChains(view, pair);
  }
}

}

void ApplyChains(const ChainOperator& operation, const std::vector<MovedArray>& arrays)
{
  std::vector<MovedArray> single = arrays;
  const auto doubles = TakePairs<double>(VTK_DOUBLE, single);
  const auto floats = TakePairs<float>(VTK_FLOAT, single);
  const Appliers<ChainBlocks> appliers(single);
  operation.ForEachChains(
    [&](const ChainOperator::ChainsView& view)
    {
      SumPairs(view, doubles);
      SumPairs(view, floats);
      appliers.Apply(view);
    });
}

}
