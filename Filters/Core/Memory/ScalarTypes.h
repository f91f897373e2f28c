// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScalarTypes.h
 * The types of values that operators are instantiated for.
 */
#ifndef SubdivisionObjects_ScalarTypes_h
#define SubdivisionObjects_ScalarTypes_h

#include <type_traits>

/// instantiate(Id, T); for each type of values.
#define SUBDIVISION_FOR_SCALARS(instantiate, Id)                                                   \
  instantiate(Id, float);                                                                          \
  instantiate(Id, double);                                                                         \
  instantiate(Id, char);                                                                           \
  instantiate(Id, signed char);                                                                    \
  instantiate(Id, unsigned char);                                                                  \
  instantiate(Id, short);                                                                          \
  instantiate(Id, unsigned short);                                                                 \
  instantiate(Id, int);                                                                            \
  instantiate(Id, unsigned int);                                                                   \
  instantiate(Id, long);                                                                           \
  instantiate(Id, unsigned long);                                                                  \
  instantiate(Id, long long);                                                                      \
  instantiate(Id, unsigned long long)

namespace subdivision
{

/// Calls sum(N) with a std::integral_constant N. N is 1 or 3 for values of a frequent type with
/// that many components, so that the compiler unrolls loops over components. In all other cases N
/// is 0, and the number is known at run time only. More cases would cost compile time and gain
/// little.
template <typename T, typename Sum>
void ForComponents(int components, const Sum& sum)
{
  if constexpr (std::is_floating_point<T>::value || std::is_same<T, unsigned char>::value)
  {
    if (components == 1)
    {
      return sum(std::integral_constant<int, 1>());
    }
    if (components == 3)
    {
      return sum(std::integral_constant<int, 3>());
    }
  }
  sum(std::integral_constant<int, 0>());
}

}

#endif
