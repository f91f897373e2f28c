// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridTangents.h"

#include "Core/Cells/CellSigns.h"
#include "Core/Memory/Ids.h"
#include "Core/Solids/Hybrid/HybridShading.h"
#include "Core/Solids/Limits/SectorParts.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <unordered_map>

namespace subdivision
{
namespace
{

template <typename Id>
class HybridSectors
{
public:
  HybridSectors(const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls)
    : Here(level)
    , Complex(level.Complex)
    , Faces(level.Complex, controls)
    , Rows(level, HybridRules::Smooth)
  {
  }

  /// Appends the sectors of a vertex, and says how many they are.
  Id Append(Id vertex, SectorPart<Id>& part)
  {
    const Rule rule = this->Here.Strata.Vertices[vertex].Result.GetRule();
    HybridFan<Id> fan;
    if (rule == Rule::Surface)
    {
      return FindFan(this->Here, vertex, fan) && this->AppendSector(fan, part) ? 1 : 0;
    }
    return rule == Rule::Curve ? this->AppendAtCurve(vertex, fan, part) : Id(0);
  }

private:
  Id AppendAtCurve(Id vertex, HybridFan<Id>& fan, SectorPart<Id>& part)
  {
    const CurveVertex<Id>& curve = this->Here.Strata.GetCurve(vertex);
    const Id edges[2] = { this->Complex.FindEdge(vertex, curve.Ring[0]),
      this->Complex.FindEdge(vertex, curve.Ring[1]) };
    const Id first = std::min(edges[0], edges[1]);
    const Id last = std::max(edges[0], edges[1]);
    Id sectors = 0;
    for (const Id face : this->Complex.EdgeFaces[first])
    {
      // Each sector is found once, from its edge with the smaller number.
      if (this->Complex.FaceSolids[face].size() < 2 &&
        FollowFan(this->Here, vertex, first, face, fan) && !fan.IsClosed &&
        fan.Edges.back() == last && this->AppendSector(fan, part))
      {
        ++sectors;
      }
    }
    return sectors;
  }

  bool AppendSector(const HybridFan<Id>& fan, SectorPart<Id>& part)
  {
    const bool isOutside = std::all_of(fan.Faces.begin(), fan.Faces.end(),
      [this](Id face) { return this->Complex.FaceSolids[face].size() < 2; });
    const FanTangents& tangents = this->FindTangents(fan);
    if (!isOutside || tangents.First.empty())
    {
      return false;
    }
    const auto face = std::min_element(fan.Faces.begin(), fan.Faces.end(),
      [this](Id a, Id b) { return this->Faces.GetCell(a) < this->Faces.GetCell(b); });
    double sign = 1.;
    const std::size_t before = part.Sides.size();
    if (this->Faces.IsSide(*face))
    {
      part.Triangles.push_back(-1);
      for (std::size_t j = 0; j < fan.Faces.size(); ++j)
      {
        if (this->Faces.IsSide(fan.Faces[j]))
        {
          part.Sides.push_back(this->Faces.GetSide(fan.Faces[j], fan.Vertex, this->GetEnd(fan, j)));
        }
      }
    }
    else
    {
      part.Triangles.push_back(static_cast<Id>(this->Faces.GetControl(*face)));
      sign = this->Faces.GoesOn(*face, fan.Vertex,
               this->GetEnd(fan, static_cast<std::size_t>(face - fan.Faces.begin())))
        ? 1.
        : -1.;
    }
    part.SideSizes.push_back(static_cast<vtkIdType>(part.Sides.size() - before));
    this->AppendRows(fan, tangents, sign, part);
    return true;
  }
  Id GetEnd(const HybridFan<Id>& fan, std::size_t edge) const
  {
    return this->Complex.GetOtherEnd(fan.Edges[edge], fan.Vertex);
  }

  const FanTangents& FindTangents(const HybridFan<Id>& fan)
  {
    const bool isModified = !fan.IsClosed &&
      std::any_of(fan.Edges.begin(), fan.Edges.end(),
        [&](Id edge)
        {
          const auto sectors = FindSectorEdges(this->Here.Strata.Sectors, edge);
          return std::any_of(sectors.begin(), sectors.end(), [&](const SectorEdge<Id>& sector)
            { return this->Complex.EdgeVertices[2 * vtkIdType(edge) + sector.End] == fan.Vertex; });
        });
    Neighbourhood key = fan.GetKey(this->Complex);
    if (this->Known.size() > MostSolutions)
    {
      this->Known.clear();
    }
    key.push_back(isModified ? 1 : 0);
    const auto found = this->Known.find(key);
    if (found != this->Known.end())
    {
      return found->second;
    }
    const Neighbourhood sizes(key.begin(), key.end() - 1);
    return this->Known.emplace(key, FindFanTangents(sizes, this->Here.Strata.Weights, isModified))
      .first->second;
  }

  /// The rows of the fan, or, where the next steps have other rules, of a later level times these
  /// steps.
  void AppendRows(
    const HybridFan<Id>& fan, const FanTangents& tangents, double sign, SectorPart<Id>& part)
  {
    const std::size_t before = part.Columns.size();
    const auto add = [&](Id column, double first, double second)
    {
      part.Columns.push_back(column);
      part.First.push_back(first);
      part.Second.push_back(sign * second);
    };
    if (IsPlainFan(this->Here, fan))
    {
      fan.ForItems(this->Complex,
        [&](std::size_t item, Id vertex, vtkIdType)
        {
          if (tangents.First[item] != 0. || tangents.Second[item] != 0.)
          {
            add(vertex, tangents.First[item], tangents.Second[item]);
          }
        });
    }
    else
    {
      HybridPatch<Id> star(this->Here);
      star.ReadStar(fan.Vertex);
      const LocalItems items = ReadLaterItems(star);
      std::vector<double> weights[2];
      for (int i = 0; i < 2; ++i)
      {
        weights[i].assign(items.Rows.GetNumberOfItems(), 0.);
        const std::vector<double>& of = i == 0 ? tangents.First : tangents.Second;
        fan.ForItems(this->Complex,
          [&](std::size_t item, Id vertex, vtkIdType row)
          {
            const int found = LocalReader<Id>::FindItem(star, items.Points, vertex, row);
            weights[i][static_cast<std::size_t>(found)] = of[item];
          });
        weights[i] = items.StepBack(weights[i]);
        LocalReader<Id>(this->Rows.StartRows())
          .AddItems(star, items.Points, weights[i].data(), weights[i].size(),
            [&](Id column, double weight)
            { add(column, i == 0 ? weight : 0., i == 0 ? 0. : weight); });
      }
    }
    part.Sizes.push_back(static_cast<Id>(part.Columns.size() - before));
  }

  const HybridLevel<Id>& Here;
  const CellComplex<Id>& Complex;
  const FacesOfControl<Id> Faces;
  const HybridRows<Id> Rows;
  std::unordered_map<Neighbourhood, FanTangents, HashNeighbourhood> Known;
};

/// LimitTangents::AlongCurves: lines go on as their cells do, other curves to the larger number.
template <typename Id>
Buffer<Id> FindCurves(const HybridLevel<Id>& level, const Buffer<unsigned char>& missing)
{
  const CellComplex<Id>& complex = level.Complex;
  Buffer<Id> along(2 * missing.size(), Id(-1));
  ForEach(missing.size(),
    [&](vtkIdType v)
    {
      if (!missing[v] || level.Strata.Vertices[v].Result.GetRule() != Rule::Curve)
      {
        return;
      }
      const Id vertex = static_cast<Id>(v);
      std::array<Id, 2> ends{ { level.Strata.GetCurve(vertex).Ring[0],
        level.Strata.GetCurve(vertex).Ring[1] } };
      std::sort(ends.begin(), ends.end());
      const Id edge = complex.FindEdge(vertex, ends[0]);
      const vtkIdType cell = FindOwner(complex.CellEdges, complex.EdgeFirsts[edge]);
      const bool isTurned = complex.Cells.Shapes[cell] == CellShape::Line &&
        complex.Cells.GetCorners(cell)[0] == vertex;
      along[2 * v] = ends[isTurned ? 1 : 0];
      along[2 * v + 1] = ends[isTurned ? 0 : 1];
    });
  return along;
}

}

template <typename Id>
LimitTangents<Id> BuildHybridTangents(
  const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls, int steps)
{
  using Sectors = HybridSectors<Id>;
  const vtkIdType size = level.Complex.NumberOfVertices;
  vtkSMPThreadLocal<std::shared_ptr<Sectors>> sectors; // each keeps its solutions
  LimitTangents<Id> tangents = CollectSectors<Id>(size, size,
    [&](vtkIdType v, SectorPart<Id>& part)
    {
      auto& own = sectors.Local();
      if (!own)
      {
        own = std::make_shared<Sectors>(level, controls);
      }
      return own->Append(static_cast<Id>(v), part);
    });
  const Buffer<unsigned char> missing = tangents.FindMissing();
  tangents.AlongCurves = FindCurves(level, missing);
  tangents.Shading = BuildHybridShading(level, controls, missing, steps);
  return tangents;
}

template <typename Id>
FaceSides FindPolygonSides(const HybridLevel<Id>& level)
{
  const CellComplex<Id>& complex = level.Complex;
  std::vector<vtkIdType> cells(static_cast<std::size_t>(complex.Cells.GetNumberOfCells()));
  std::iota(cells.begin(), cells.end(), vtkIdType(0));
  const FacesOfControl<Id> faces(complex, cells);
  const auto isSurface = [&complex](Id face) { return complex.FaceSolids[face].size() == 0; };
  const auto forLinks = [&](vtkIdType cell, const auto& visit)
  {
    const bool isPolygon = complex.Cells.GetTable(cell).Dimension == 2;
    const Id face = isPolygon ? *complex.CellFaces[cell].begin() : Id(-1);
    if (!isPolygon || !isSurface(face) || faces.GetCell(face) != cell)
    {
      return;
    }
    for (const Id edge : complex.GetEdges(face))
    {
      const Decision& decision = level.Strata.Edges[edge];
      const Rule rule = decision.Result.GetRule();
      std::vector<Id> pair;
      for (const Id other : complex.EdgeFaces[edge])
      {
        const bool isIn = rule == Rule::Surface
          ? IsInRing(complex, level.Strata, other, decision)
          : rule == Rule::Curve && complex.FaceSolids[other].size() < 2;
        isIn ? pair.push_back(other) : void();
      }
      if (pair.size() == 2 && isSurface(pair[0]) && isSurface(pair[1]) &&
        (pair[0] == face || pair[1] == face))
      {
        const Id* ends = complex.EdgeVertices.data() + 2 * vtkIdType(edge);
        visit(faces.GetCell(pair[pair[0] == face ? 1 : 0]),
          faces.GoesOn(pair[0], ends[0], ends[1]) == faces.GoesOn(pair[1], ends[0], ends[1]));
      }
    }
  };
  return FindSides(complex.Cells.GetNumberOfCells(), forLinks);
}

SUBDIVISION_COMPILE_FUNCTION(BuildHybridTangents);
SUBDIVISION_COMPILE_FUNCTION(FindPolygonSides);

}
