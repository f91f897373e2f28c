// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/SmoothnessFacts.h"

#include <cmath>
#include <cstddef>

namespace subdivision
{
namespace
{

double Get(const std::vector<double>& moduli, std::size_t i)
{
  return i < moduli.size() ? moduli[i] : 0.;
}

}

void SmoothnessFacts::SetEigenvalues(const std::vector<double>& moduli)
{
  for (std::size_t i = 0; i < this->Eigenvalues.size(); ++i)
  {
    this->Eigenvalues[i] = Get(moduli, i);
  }
}

Answer HoldsInside(const std::vector<double>& moduli, int dimension)
{
  const auto d = static_cast<std::size_t>(dimension);
  const bool shrinks = Get(moduli, 1) < 1. - EqualEigenvalues;
  const bool hasGap = Get(moduli, d) > Get(moduli, d + 1) + EqualEigenvalues;
  return moduli.empty() ? Answer::None : shrinks && hasGap ? Answer::Yes : Answer::No;
}

Answer HoldsBesideCurves(const std::vector<double>& moduli, double along, int curves)
{
  int found = 0;
  for (std::size_t i = 1; i <= 2; ++i)
  {
    found += std::abs(Get(moduli, i) - along) < EqualEigenvalues ? 1 : 0;
  }
  return HoldsInside(moduli, 2) == Answer::Yes && found < curves ? Answer::No
                                                                 : HoldsInside(moduli, 2);
}

}
