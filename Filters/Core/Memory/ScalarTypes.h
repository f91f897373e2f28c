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

/// Calls sum(N), with N a std::integral_constant: the number of components where values are of a
/// usual type and have 1 or 3, so that the compiler unrolls the loops over them; else 0, which
/// stands for a number that is known at run time only. More would take longer to compile than it
/// could save.
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
