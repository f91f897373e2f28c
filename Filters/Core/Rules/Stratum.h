// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stratum.h
 * The stratum of a vertex or an edge of a solid, in one byte.
 */
#ifndef SubdivisionObjects_Stratum_h
#define SubdivisionObjects_Stratum_h

#include "Core/Rules/Rule.h"

namespace subdivision
{

/// The rule of a vertex or edge and its non-manifold type (0 manifold, else 1 to 3).
class Stratum
{
public:
  Stratum() = default;
  constexpr explicit Stratum(Rule rule, int type = 0)
    : Code(static_cast<unsigned char>(static_cast<int>(rule) | type << 4))
  {
  }
  constexpr Rule GetRule() const { return static_cast<Rule>(this->Code & 15); }
  constexpr int GetType() const { return this->Code >> 4; }

private:
  unsigned char Code;
};

}

#endif
