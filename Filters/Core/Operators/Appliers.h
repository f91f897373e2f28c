// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Appliers.h
 * Finds the function that applies blocks to values of given types, for ApplyRows.cxx.
 *
 * `Blocks` is a struct with
 *  - View: the blocks;
 *  - MostKnown: number of components up to which loops of known length are worth their code;
 *  - Apply<N, In, Out>(view, in, out, components): applies a block. N is the number of components,
 *    0: it is known at run time only.
 */
#ifndef SubdivisionObjects_Appliers_h
#define SubdivisionObjects_Appliers_h

#include "Core/Operators/ApplyRows.h"

#include "vtkSetGet.h"

#include <stdexcept>
#include <type_traits>
#include <vector>

namespace subdivision
{

/// Applies a block to values of given types.
template <typename Blocks>
using Applier = void (*)(
  const typename Blocks::View& view, const void* in, void* out, int components);

/// 1 and 3 values of a frequent type have unrolled loops. More cases would cost compile time.
template <typename Blocks, typename In, typename Out = In>
Applier<Blocks> FindApplier(int components)
{
  if constexpr (std::is_floating_point<In>::value || std::is_same<In, unsigned char>::value)
  {
    if (components == 1)
    {
      return Blocks::template Apply<1, In, Out>;
    }
    if (components == 3)
    {
      return Blocks::template Apply<3, In, Out>;
    }
  }
  if constexpr (Blocks::MostKnown == 4 && std::is_same<In, double>::value &&
    std::is_same<Out, double>::value)
  {
    if (components == 4) // of packed arrays
    {
      return Blocks::template Apply<4, In, Out>;
    }
  }
  return Blocks::template Apply<0, In, Out>;
}

template <typename Blocks>
Applier<Blocks> FindApplier(const MovedArray& array)
{
  if (array.InType == VTK_DOUBLE && array.OutType == VTK_FLOAT)
  {
    return FindApplier<Blocks, double, float>(array.Components);
  }
  if (array.InType == array.OutType)
  {
    switch (array.InType)
    {
      vtkTemplateMacro(return (FindApplier<Blocks, VTK_TT>(array.Components)));
    }
  }
  throw std::invalid_argument("operators do not know this type of values");
}

/// The appliers of several arrays.
template <typename Blocks>
class Appliers
{
public:
  explicit Appliers(const std::vector<MovedArray>& arrays)
    : Arrays(arrays)
  {
    for (const MovedArray& array : arrays)
    {
      this->OfArrays.push_back(FindApplier<Blocks>(array));
    }
  }
  void Apply(const typename Blocks::View& view) const
  {
    for (std::size_t i = 0; i < this->Arrays.size(); ++i)
    {
      const MovedArray& array = this->Arrays[i];
      this->OfArrays[i](view, array.In, array.Out, array.Components);
    }
  }

private:
  const std::vector<MovedArray>& Arrays;
  std::vector<Applier<Blocks>> OfArrays;
};

}

#endif
