// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/PatchMinimum.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace subdivision
{
namespace
{

using Parameters = std::array<double, 2>;

constexpr int MostHalvings = 4096; ///< where the value is nearly the same everywhere

Parameters Middle(const Parameters& a, const Parameters& b)
{
  return { { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) } };
}

constexpr int Number(int i, int j)
{
  return PatchSide * j + i;
}

struct Part
{
  PatchFactors Factors;
  PatchFrame Frame;
  double Bound;
};

class Halving
{
public:
  Halving(PatchKind kind, int degree)
    : Kind(kind)
    , Degree(degree)
  {
  }

  void SetBound(Part& part) const
  {
    part.Bound = std::numeric_limits<double>::infinity();
    for (int j = 0; j <= this->CountRows(); ++j)
    {
      const double* row = part.Factors.data() + Number(0, j);
      part.Bound = std::min(part.Bound, *std::min_element(row, row + this->GetSize(j) + 1));
    }
  }

  bool TakeCorners(const Part& part, PatchMinimum& least) const
  {
    const double before = least.Value;
    const auto take = [&](int i, int j, const Parameters& at)
    {
      if (part.Factors[Number(i, j)] < least.Value)
      {
        least = { part.Factors[Number(i, j)], at };
      }
    };
    const PatchFrame& frame = part.Frame;
    take(0, 0, frame[0]);
    take(this->Degree, 0, frame[1]);
    this->Kind != PatchKind::Line ? take(0, this->Degree, frame[2]) : void();
    if (this->Kind == PatchKind::Quad)
    {
      take(this->Degree, this->Degree,
        { { frame[1][0] + frame[2][0] - frame[0][0], frame[1][1] + frame[2][1] - frame[0][1] } });
    }
    return least.Value < before;
  }

  /// Halves the first axis. The axes of the halves are in such an order that all get their turn.
  void Halve(const Part& part, Part& first, Part& second) const
  {
    for (int j = 0; j <= this->CountRows(); ++j)
    {
      std::array<double, PatchSide> row;
      const int size = this->GetSize(j);
      std::copy_n(part.Factors.data() + Number(0, j), size + 1, row.begin());
      for (int t = 0; t <= size; ++t)
      {
        // Steps of de Casteljau: row[t] is the middle of all up to t, row[size] of the rest.
        this->Put(first, true, size - t, t, j, row[0]);
        this->Put(second, false, t, size - t, j, row[size - t]);
        for (int i = 0; i + t < size; ++i)
        {
          row[i] = 0.5 * (row[i] + row[i + 1]);
        }
      }
    }
    const PatchFrame& frame = part.Frame;
    const Parameters middle = Middle(frame[0], frame[1]);
    switch (this->Kind)
    {
      case PatchKind::Line:
        first.Frame = { { frame[0], middle, frame[2] } };
        second.Frame = { { middle, frame[1], frame[2] } };
        break;
      case PatchKind::Triangle:
        first.Frame = { { frame[2], frame[0], middle } };
        second.Frame = { { frame[1], frame[2], middle } };
        break;
      default:
      {
        const Parameters beside{ { middle[0] + frame[2][0] - frame[0][0],
          middle[1] + frame[2][1] - frame[0][1] } };
        first.Frame = { { frame[0], frame[2], middle } };
        second.Frame = { { middle, beside, frame[1] } };
      }
    }
    this->SetBound(first);
    this->SetBound(second);
  }

private:
  int CountRows() const { return this->Kind == PatchKind::Line ? 0 : this->Degree; }
  int GetSize(int j) const
  {
    return this->Kind == PatchKind::Triangle ? this->Degree - j : this->Degree;
  }
  /// Sets the factor of a half, by its powers at both ends of the halved axis and along the other.
  void Put(Part& half, bool isFirst, int low, int high, int j, double factor) const
  {
    int i = high;
    int row = 0;
    switch (this->Kind)
    {
      case PatchKind::Line:
        break;
      case PatchKind::Triangle: // the corners of a half are the third one, an old one, the middle
        i = isFirst ? low : j;
        row = isFirst ? high : low;
        break;
      default:
        i = j;
        row = high;
    }
    half.Factors[Number(i, row)] = factor;
  }

  const PatchKind Kind;
  const int Degree;
};

}

bool LowerToPatch(PatchKind kind, int degree, const PatchFactors& factors, const PatchFrame& frame,
  double tolerance, PatchMinimum& least)
{
  const Halving halving(kind, degree);
  std::vector<Part> parts(1);
  parts[0].Factors = factors;
  parts[0].Frame = frame;
  halving.SetBound(parts[0]);
  bool isLower = false;
  Part first;
  Part second;
  for (int count = 0; !parts.empty() && count < MostHalvings; ++count)
  {
    if (!(parts.back().Bound < least.Value - tolerance))
    {
      parts.pop_back();
      continue;
    }
    isLower = halving.TakeCorners(parts.back(), least) || isLower;
    if (!(parts.back().Bound < least.Value - tolerance))
    {
      parts.pop_back();
      continue;
    }
    halving.Halve(parts.back(), first, second);
    const bool isSwapped = first.Bound < second.Bound; // the smaller one is looked at next
    parts.back() = isSwapped ? second : first;
    parts.push_back(isSwapped ? first : second);
  }
  return isLower;
}

}
