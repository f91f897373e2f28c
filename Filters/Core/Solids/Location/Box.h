// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Box.h
 * A box with sides along the axes.
 */
#ifndef SubdivisionObjects_Box_h
#define SubdivisionObjects_Box_h

#include <algorithm>
#include <limits>

namespace subdivision
{

/// An empty one until something is added.
struct Box
{
  double Low[3] = { Infinity, Infinity, Infinity };
  double High[3] = { -Infinity, -Infinity, -Infinity };

  void Add(const double x[3])
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], x[c]);
      this->High[c] = std::max(this->High[c], x[c]);
    }
  }
  void Add(const Box& other)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], other.Low[c]);
      this->High[c] = std::max(this->High[c], other.High[c]);
    }
  }
  bool Holds(const double x[3]) const
  {
    return x[0] >= this->Low[0] && x[0] <= this->High[0] && x[1] >= this->Low[1] &&
      x[1] <= this->High[1] && x[2] >= this->Low[2] && x[2] <= this->High[2];
  }
  bool Meets(const Box& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
};

}

#endif
