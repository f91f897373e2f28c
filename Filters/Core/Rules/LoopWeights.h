// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopWeights.h
 * The choice between the weights that Loop's scheme is known with (Mathematics 5).
 */
#ifndef SubdivisionObjects_LoopWeights_h
#define SubdivisionObjects_LoopWeights_h

namespace subdivision
{

/// The weights of vertices inside a surface (d = 2). They are equal at three and six neighbours.
enum class LoopWeights : unsigned char
{
  Warren, ///< eq. 16
  Loop    ///< the weights of Loop's thesis, which other libraries have
};

}

#endif
