// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StrataCurves.h
 * Strata where there is nothing but vertices and edges, none of them singular: the number of edges
 * at a vertex tells its rule, so that no links are needed.
 */
#ifndef SubdivisionObjects_StrataCurves_h
#define SubdivisionObjects_StrataCurves_h

#include "Core/Solids/Strata/Strata.h"

namespace subdivision
{

/// Finds the strata of such a complex. Returns false, and leaves `strata` as it is, if the complex
/// is another one, or if more than two edges meet somewhere and the options have another choice for
/// that than Blend.
template <typename Id>
bool FindStrataOfCurves(const SimplicialComplex<Id>& complex, const SingularSimplices& singular,
  const StrataOptions& options, Strata<Id>& strata);

}

#endif
