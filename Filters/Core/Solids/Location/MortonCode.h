// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MortonCode.h
 * The cells of a lattice in the order of a space-filling curve.
 */
#ifndef SubdivisionObjects_MortonCode_h
#define SubdivisionObjects_MortonCode_h

#include <cstdint>

namespace subdivision
{

/// The Morton code of a cell: it interleaves the bits of its three places, each of up to 21 bits.
inline std::uint64_t GetMortonCode(const std::uint64_t places[3])
{
  std::uint64_t code = 0;
  for (int c = 0; c < 3; ++c)
  {
    std::uint64_t bits = places[c];
    bits = (bits | bits << 32) & 0x001f00000000ffffULL;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
    bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
    bits = (bits | bits << 2) & 0x1249249249249249ULL;
    code |= bits << c;
  }
  return code;
}

}

#endif
