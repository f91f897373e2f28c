// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Hybrid/HybridFans.h"
#include "Core/Solids/Hybrid/HybridLocal.h"
#include "Core/Solids/Hybrid/HybridRowSum.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <memory>
#include <unordered_map>

namespace subdivision
{
namespace
{

/// The weights of the items of a limit.
struct LimitWeights
{
  std::vector<double> Weights;
  std::vector<std::array<int, 2>> Points; ///< LocalItems::Points
};

/// Makes limit rows in one thread.
template <typename Id>
class HybridLimitMaker
{
public:
  HybridLimitMaker(const HybridLevel<Id>& level, const HybridRows<Id>& rows)
    : Here(level)
    , Reader(rows.StartRows())
    , Star(level)
    , Fans(level.Strata.Weights)
  {
  }

  void AddRow(vtkIdType row, RowBlock<Id>& rows)
  {
    const Id vertex = static_cast<Id>(row);
    const bool isSharp = this->Here.Sharpness.GetMost(this->Here.Complex, vertex) > 0.;
    switch (isSharp ? Rule::Blend : this->Here.Strata.Vertices[vertex].Result.GetRule())
    {
      case Rule::Corner:
        rows.Add(vertex, 1.);
        break;
      case Rule::Curve:
        this->AddCurve(vertex, rows);
        break;
      case Rule::Surface:
        FindFan(this->Here, vertex, this->Fan) && IsPlainFan(this->Here, this->Fan)
          ? this->AddFan(rows)
          : this->AddStar(vertex, rows);
        break;
      default:
        this->AddStar(vertex, rows);
        break;
    }
    rows.EndRow();
  }

private:
  void AddCurve(Id vertex, RowBlock<Id>& rows)
  {
    const CurveVertex<Id>& curve = this->Here.Strata.GetCurve(vertex);
    const bool isCurve = std::all_of(curve.Ring, curve.Ring + 2,
      [&](Id end)
      {
        const Id edge = this->Here.Complex.FindEdge(vertex, end);
        return this->Here.Strata.Edges[edge].Result.GetRule() <= Rule::Curve;
      });
    if (!isCurve)
    {
      this->AddStar(vertex, rows);
      return;
    }
    rows.Add(vertex, 2. / 3.);
    rows.Add(curve.Ring[0], 1. / 6.);
    rows.Add(curve.Ring[1], 1. / 6.);
  }

  void AddFan(RowBlock<Id>& rows)
  {
    const std::vector<double>& weights = this->Fans.Find(this->Fan.GetKey(this->Here.Complex));
    this->Fan.ForItems(this->Here.Complex,
      [&](std::size_t item, Id vertex, vtkIdType) { rows.Add(vertex, weights[item]); });
  }

  void AddStar(Id vertex, RowBlock<Id>& rows)
  {
    this->Star.ReadStar(vertex);
    if (this->Solved.size() > MostSolutions)
    {
      this->Solved.clear();
    }
    LimitWeights& known = this->Solved[this->Star.IsPlain() ? this->Star.Key : Neighbourhood()];
    if (!this->Star.IsPlain() || known.Weights.empty())
    {
      LocalItems items = ReadLocalItems(this->Star, this->Reader);
      known = { items.StepBack(items.Rows.FindLimit()), std::move(items.Points) };
    }
    this->Reader.AddItems(this->Star, known.Points, known.Weights.data(), known.Weights.size(),
      [&](Id column, double weight) { this->Sum.Add(column, weight); });
    this->Sum.AddTo(rows);
  }

  const HybridLevel<Id>& Here;
  LocalReader<Id> Reader;
  HybridPatch<Id> Star;
  HybridFan<Id> Fan;
  FanLimits Fans;
  HybridRowSum<Id> Sum;
  std::unordered_map<Neighbourhood, LimitWeights, HashNeighbourhood> Solved;
};

}

template <typename Id>
typename HybridRows<Id>::AddRow StartLimits(
  const HybridLevel<Id>& level, const HybridRows<Id>& rows)
{
  const auto maker = std::make_shared<HybridLimitMaker<Id>>(level, rows);
  return [maker](vtkIdType vertex, RowBlock<Id>& block) { maker->AddRow(vertex, block); };
}

template <typename Id>
BlockOperator<Id> MakeLimitOperator(const HybridLevel<Id>& level)
{
  const auto rows = std::make_shared<HybridRows<Id>>(level, HybridRules::Smooth);
  using Makers = vtkSMPThreadLocal<typename HybridRows<Id>::AddRow>;
  const auto makers = std::make_shared<Makers>(); // each keeps its solutions
  const vtkIdType size = level.Complex.NumberOfVertices;
  return BlockOperator<Id>(size, size,
    [&level, rows, makers](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    {
      auto& addRow = makers->Local();
      addRow = addRow ? addRow : StartLimits(level, *rows);
      for (vtkIdType v = begin; v < end; ++v)
      {
        addRow(v, block);
      }
    });
}

SUBDIVISION_COMPILE_FUNCTION(StartLimits);
SUBDIVISION_COMPILE_FUNCTION(MakeLimitOperator);

}
