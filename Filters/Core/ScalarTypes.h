// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScalarTypes.h
 * The types of values that operators are instantiated for.
 */
#ifndef SubdivisionObjects_ScalarTypes_h
#define SubdivisionObjects_ScalarTypes_h

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

#endif
