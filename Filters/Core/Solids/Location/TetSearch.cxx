// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/TetSearch.h"

#include "Core/Operators/CornerRows.h"
#include "Core/Solids/Location/BinnedPoints.h"
#include "Core/Solids/Location/PointGroups.h"
#include "Core/Solids/Location/TetFrame.h"

#include "vtkSMPThreadLocal.h"

#include <array>
#include <cmath>
#include <memory>

namespace subdivision
{
namespace
{

/// By which tolerance a tetrahedron is known to hold a point.
enum class Hold : unsigned char
{
  None,
  Loose,
  Tight
};

/// Tells fast which points may be in a tetrahedron.
class WeightBounds
{
public:
  /// `box` holds the tetrahedron and all points that are asked for. A point may be inside if its
  /// least weight is `least` or more.
  WeightBounds(const TetFrame& tet, const Box& box, const BinnedPoints& points, double least)
  {
    double gradients[4][3] = {};
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < 3; ++i)
      {
        gradients[i + 1][c] = tet.Normals[i][c] / tet.Volume;
        gradients[0][c] -= gradients[i + 1][c];
      }
    }
    const double margin = GetMargin(tet, box);
    this->SetLinear(tet, gradients, points.GetBox(), least - margin);
    this->SetSingles(tet, gradients, points, least - margin);
  }

  /// Functions that are not negative at points in the tetrahedron.
  LinearBounds Linear;

  /// Lists the points of rows that may be inside.
  int List(
    const BinnedPoints& points, const std::vector<std::pair<int, int>>& rows, int* list) const
  {
    const WeightBounds self = *this; // a copy, which no write can change
    const float* x = points.Singles[0].data();
    const float* y = points.Singles[1].data();
    const float* z = points.Singles[2].data();
    float least[MostAtATime];
    int found = 0;
    for (auto [begin, end] : rows)
    {
      for (; begin < end; begin += MostAtATime)
      {
        const int size = std::min(MostAtATime, end - begin);
        self.Compute(x + begin, y + begin, z + begin, size, least);
        for (int i = 0; i < size; ++i) // without jumps, which could not be foretold
        {
          list[found] = begin + i;
          found += least[i] >= self.Threshold;
        }
      }
    }
    return found;
  }

private:
  /// By how much weights that are computed from gradients may be too small. The weights of TetFrame
  /// differ from these by the rounding of the normals and the volume, relative to the volume, and
  /// by a step more: some 5e-15 times the square of `flatness`.
  static double GetMargin(const TetFrame& tet, const Box& box)
  {
    double reach = 0.;
    for (int c = 0; c < 3; ++c)
    {
      reach += box.High[c] - box.Low[c];
    }
    const double flatness = reach * reach * reach / std::abs(tet.Volume);
    return 1e-13 * flatness * flatness;
  }

  void SetLinear(
    const TetFrame& tet, const double (&gradients)[4][3], const Box& whole, double least)
  {
    constexpr double rounding = 1e-14;
    double sum = 1.; // of all that is added
    for (int i = 0; i < 4; ++i)
    {
      double value = i == 0 ? 1. : 0.;
      for (int c = 0; c < 3; ++c)
      {
        const double toLow = whole.Low[c] - tet.First[c];
        this->Linear.Slopes[c][i] = gradients[i][c];
        value += gradients[i][c] * toLow;
        sum += std::abs(gradients[i][c]) * (std::abs(toLow) + whole.High[c] - whole.Low[c]);
      }
      this->Linear.AtLow[i] = value - least;
    }
    const double more = rounding * sum;
    const bool isBound = more < 1e100 && least > -1e100;
    for (int i = 0; i < 4; ++i)
    {
      if (isBound)
      {
        this->Linear.AtLow[i] += more;
        continue;
      }
      this->Linear.AtLow[i] = 1.; // there is no bound
      for (auto& slopes : this->Linear.Slopes)
      {
        slopes[i] = 0.;
      }
    }
  }

  void SetSingles(
    const TetFrame& tet, const double (&gradients)[4][3], const BinnedPoints& points, double least)
  {
    constexpr double rounding = 1e-6; // twice that of such sums in single precision
    double sum = 1.;
    for (int i = 0; i < 3; ++i)
    {
      double value = 0.;
      for (int c = 0; c < 3; ++c)
      {
        const double slope = gradients[i + 1][c] * points.HalfWidth;
        this->Slopes[i][c] = static_cast<float>(slope);
        value += gradients[i + 1][c] * (points.Middle[c] - tet.First[c]);
        sum += std::abs(slope);
      }
      this->Values[i] = static_cast<float>(value);
      sum += std::abs(value);
    }
    const bool isBound = points.HasSingles() && sum < 1e30 && least > -1e30;
    this->Threshold = isBound ? static_cast<float>(least - rounding * sum) : -1.F;
    if (!isBound) // all points whose coordinates are numbers
    {
      std::fill(this->Values, this->Values + 3, 0.F);
      for (auto& slopes : this->Slopes)
      {
        std::fill(slopes, slopes + 3, 0.F);
      }
    }
  }

  /// Sets the least weight of each point, and of some more.
  void Compute(const float* x, const float* y, const float* z, int size, float* least) const
  {
    const auto& g = this->Slopes;
    const auto& v = this->Values;
    constexpr int lanes = BinnedPoints::AtATime;
    const int whole = (size + lanes - 1) / lanes * lanes;
    for (int i = 0; i < whole; ++i)
    {
      const float a = x[i] * g[0][0] + y[i] * g[0][1] + z[i] * g[0][2] + v[0];
      const float b = x[i] * g[1][0] + y[i] * g[1][1] + z[i] * g[1][2] + v[1];
      const float c = x[i] * g[2][0] + y[i] * g[2][1] + z[i] * g[2][2] + v[2];
      const float rest = 1.F - a - b - c;
      const float ab = a < b ? a : b;
      const float cr = c < rest ? c : rest;
      least[i] = ab < cr ? ab : cr;
    }
  }

  static constexpr int MostAtATime = 64;
  // Weights of the corners 1 to 3 as functions of BinnedPoints::Singles.
  float Slopes[3][3];
  float Values[3];
  float Threshold;
};

/// Weights of some points.
struct WeightsOfSome
{
  static constexpr int Most = 64;
  double Numbers[3][Most]; ///< coordinates, then the weights of the corners 1 to 3
  double Least[Most];      ///< of all four weights

  void Load(const BinnedPoints& points, const int* list, int size, const double* first)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < size; ++i)
      {
        this->Numbers[c][i] = points.GetCoordinate(c, list[i]) - first[c];
      }
    }
  }
  void Find(const TetFrame& tet, int size)
  {
    const TetFrame frame = tet; // a copy, which no write to the numbers can change
    auto& n = this->Numbers;
    for (int i = 0; i < size; ++i)
    {
      const vectors::Vector found = frame.FindWeights({ n[0][i], n[1][i], n[2][i] });
      const std::array<double, 4> weights = CompleteWeights(found.data());
      double least = weights[0];
      for (int k = 1; k < 4; ++k)
      {
        n[k - 1][i] = weights[k];
        least = weights[k] < least ? weights[k] : least;
      }
      this->Least[i] = least;
    }
  }
};

/// The corners of a tetrahedron. Such functions are no members, which compilers would not put in
/// line in a shared library.
struct CornersOfTet
{
  CornersOfTet(const double* points, const int* corners, int tet)
  {
    const int* ids = corners + 4 * static_cast<vtkIdType>(tet);
    for (int i = 0; i < 4; ++i)
    {
      this->Places[i] = points + 3 * static_cast<vtkIdType>(ids[i]);
    }
  }
  void AddTo(Box& box) const
  {
    const auto& x = this->Places;
    for (int c = 0; c < 3; ++c)
    {
      const double low = std::min(std::min(x[0][c], x[1][c]), std::min(x[2][c], x[3][c]));
      const double high = std::max(std::max(x[0][c], x[1][c]), std::max(x[2][c], x[3][c]));
      box.Low[c] = std::min(box.Low[c], low);
      box.High[c] = std::max(box.High[c], high);
    }
  }

  const double* Places[4];
};

/// Makes the box of tetrahedra a little wider than each of their boxes must be.
Box Widen(Box box)
{
  double most = 0.;
  for (int c = 0; c < 3; ++c)
  {
    most = std::max(most, box.High[c] - box.Low[c]);
  }
  for (int c = 0; c < 3; ++c)
  {
    const double more = 1e-3 * (box.High[c] - box.Low[c]) + 1e-10 * most;
    box.Low[c] -= more;
    box.High[c] += more;
  }
  return box;
}

}

struct TetSearch::Group
{
  BinnedPoints Points;
  std::vector<Hold> Holds; ///< of each point
  std::vector<int> Listed; ///< points that may be in a tetrahedron
  HoldTolerances Tolerances{ 0., 0. };
  int* Tets = nullptr;
  double* Weights = nullptr;

  void Load(const double* points, const int* ids, int size)
  {
    this->Points.Load(points, ids, size);
    this->Holds.assign(size, Hold::None);
    this->Listed.resize(size + 1);
  }

  /// Decides which of the listed points a tetrahedron holds.
  void Decide(int tet, const TetFrame& frame, int size)
  {
    WeightsOfSome some;
    for (int first = 0; first < size; first += WeightsOfSome::Most)
    {
      const int* list = this->Listed.data() + first;
      const int count = std::min(WeightsOfSome::Most, size - first);
      some.Load(this->Points, list, count, frame.First);
      some.Find(frame, count);
      for (int i = 0; i < count; ++i)
      {
        const bool isTight = some.Least[i] >= -this->Tolerances.Tight;
        Hold& hold = this->Holds[list[i]];
        if (!isTight && (!(some.Least[i] >= -this->Tolerances.Loose) || hold != Hold::None))
        {
          continue;
        }
        hold = isTight ? Hold::Tight : Hold::Loose;
        if (isTight)
        {
          this->Points.Remove(list[i]);
        }
        const auto point = static_cast<vtkIdType>(this->Points.GetId(list[i]));
        this->Tets[point] = tet;
        for (int c = 0; c < 3; ++c)
        {
          this->Weights[3 * point + c] = some.Numbers[c][i];
        }
      }
    }
  }
};

TetSearch::TetSearch(const double* points, const Buffer<int>& corners)
  : Points(points)
  , Corners(corners.data())
  , Size(static_cast<int>(corners.size() / 4))
{
  int size = this->Size;
  while (size > 0 && (this->Levels.empty() || size > 1))
  {
    const int below = size;
    const Buffer<Box>* children = this->Levels.empty() ? nullptr : &this->Levels.back();
    size = (size + Width - 1) / Width;
    Buffer<Box> boxes(size);
    ForEach(size,
      [&](vtkIdType node)
      {
        Box box;
        const int first = static_cast<int>(node) * Width;
        const int end = std::min(below, first + Width);
        for (int i = first; i < end; ++i)
        {
          children ? box.Add((*children)[i])
                   : CornersOfTet(this->Points, this->Corners, i).AddTo(box);
        }
        boxes[node] = children ? box : Widen(box);
      });
    this->Levels.push_back(std::move(boxes));
  }
}

void TetSearch::Find(const double* points, int size, const HoldTolerances& tolerances, int* tets,
  double* weights) const
{
  Fill(tets, size, -1);
  const Box nowhere;
  const int most = std::clamp(size / 64, 1024, 16384); // for a core's own cache
  const PointGroups groups(points, size, this->Size > 0 ? this->Levels.back()[0] : nowhere, most);
  vtkSMPThreadLocal<std::shared_ptr<Group>> ofThreads; // memory that is used again
  ForRangesOfBlocks(groups.GetNumberOfGroups(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::shared_ptr<Group>& group = ofThreads.Local();
      if (!group)
      {
        group = std::make_shared<Group>();
        group->Tolerances = tolerances;
        group->Tets = tets;
        group->Weights = weights;
      }
      for (vtkIdType g = begin; g < end; ++g)
      {
        const int first = groups.Starts[g];
        group->Load(points, groups.Order.data() + first, groups.Starts[g + 1] - first);
        this->Visit(this->Levels.size() - 1, 0, *group);
      }
    });
}

/// Visits the tetrahedra in ascending order.
void TetSearch::Visit(std::size_t level, int node, Group& group) const
{
  if (!group.Points.GetBox().Meets(this->Levels[level][node]))
  {
    return;
  }
  const int below = level > 0 ? static_cast<int>(this->Levels[level - 1].size()) : this->Size;
  const int first = node * Width;
  for (int i = first; i < below && i < first + Width; ++i)
  {
    level > 0 ? this->Visit(level - 1, i, group) : this->FindInTet(i, group);
  }
}

void TetSearch::FindInTet(int tet, Group& group) const
{
  BinnedPoints& points = group.Points;
  const CornersOfTet corners(this->Points, this->Corners, tet);
  Box box;
  corners.AddTo(box);
  box = Widen(box);
  if (!points.GetBox().Meets(box))
  {
    return;
  }
  constexpr int most = 16; // bounds cost more than the weights of so many points
  const int few = points.ListFew(box, most, group.Listed.data());
  if (few == 0)
  {
    return;
  }
  const TetFrame frame(corners.Places);
  if (frame.IsFlat())
  {
    return;
  }
  if (few > 0)
  {
    group.Decide(tet, frame, few);
    return;
  }
  const WeightBounds bounds(frame, box, points, -group.Tolerances.Loose);
  const auto& rows = points.FindRows(box, bounds.Linear);
  group.Decide(tet, frame, bounds.List(points, rows, group.Listed.data()));
}

}
