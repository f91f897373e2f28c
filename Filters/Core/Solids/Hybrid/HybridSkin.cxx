// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridSkin.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Hybrid/HybridPatch.h"
#include "Core/Solids/Hybrid/HybridShading.h"
#include "Core/Solids/Hybrid/HybridTangents.h"
#include "Core/Solids/Strata/SharpSkin.h"

#include <algorithm>

namespace subdivision
{
namespace
{

template <typename Id>
bool HasDimension(const CellList<Id>& cells, int dimension)
{
  return std::all_of(cells.Shapes.begin(), cells.Shapes.end(),
    [dimension](CellShape shape) { return GetCellTable(shape).Dimension == dimension; });
}

template <typename Id>
bool IsSharpAfter(const HybridLevel<Id>& level, int steps)
{
  const auto& stages = level.Sharpness.Stages;
  return !stages.empty() && stages.back().Steps > steps;
}

bool IsCurve(const Decision& decision)
{
  const Rule rule = decision.Result.GetRule();
  return rule == Rule::Curve || rule == Rule::Corner;
}

template <typename Id, typename IsRight>
bool AreAll(Id size, const IsRight& isRight)
{
  bool areAll = true;
  ForEachInTurn(size, [&](vtkIdType i) { areAll = areAll && isRight(static_cast<Id>(i)); });
  return areAll;
}

/// What lies on a skin, and which rules read nothing that does not.
template <typename Id>
class SkinRules
{
public:
  explicit SkinRules(const HybridLevel<Id>& level)
    : Complex(level.Complex)
    , Strata(level.Strata)
  {
  }
  bool HasFace(Id face) const { return this->Complex.FaceSolids[face].size() == 1; }
  bool HasAny(Row<Id> edges) const
  {
    return std::any_of(edges.begin(), edges.end(),
      [this](Id edge)
      {
        const Row<Id> faces = this->Complex.EdgeFaces[edge];
        return std::any_of(faces.begin(), faces.end(), [this](Id f) { return this->HasFace(f); });
      });
  }
  /// `edges`: an edge, or those at a vertex.
  bool IsClosed(const Decision& decision, Row<Id> edges) const
  {
    const bool isOnFaces = decision.Result.GetRule() == Rule::Surface &&
      (decision.Ring == RingKind::BoundaryOfSolid || decision.Ring == RingKind::SingularFaces);
    return IsCurve(decision) ||
      (isOnFaces &&
        std::all_of(
          edges.begin(), edges.end(), [&](Id edge) { return this->HasRing(decision, edge); }));
  }
  bool HasCurve(Id vertex) const
  {
    const Id* ring = this->Strata.GetCurve(vertex).Ring;
    return std::all_of(ring, ring + 2,
      [&](Id end)
      {
        const Id edge = this->Complex.FindEdge(vertex, end);
        return this->HasAny({ &edge, &edge + 1 });
      });
  }

private:
  bool HasRing(const Decision& decision, Id edge) const
  {
    const Row<Id> faces = this->Complex.EdgeFaces[edge];
    return std::all_of(faces.begin(), faces.end(), [&](Id face)
      { return this->HasFace(face) || !IsInRing(this->Complex, this->Strata, face, decision); });
  }

  const CellComplex<Id>& Complex;
  const HybridStrata<Id>& Strata;
};

/// Makes a patch the skin of its level: each face in the first cell at it.
template <typename Id>
void ReadSkin(const HybridLevel<Id>& level, HybridPatch<Id>& patch)
{
  const CellComplex<Id>& complex = level.Complex;
  const SkinRules<Id> skin(level);
  for (const Id v : InTurn(complex.NumberOfVertices))
  {
    skin.HasAny(complex.VertexEdges[v]) ? void(patch.Numbers.GetNumber(v)) : void();
  }
  patch.Known = patch.Numbers.Vertices.size();
  for (const Id f : InTurn(complex.NumberOfFaces))
  {
    if (skin.HasFace(f))
    {
      patch.Cells.push_back({ complex.GetSize(f) == 3 ? CellShape::Triangle : CellShape::Quad, 0,
        complex.GetVertices(f).begin(), complex.GetEdges(f).begin(),
        complex.CellFaces.Items.data() + complex.FaceFirsts[f], Id(-1) });
    }
  }
}

/// On a skin all faces are surfaces.
void TurnIntoSurfaces(Buffer<Decision>& decisions)
{
  ForEach(decisions.size(),
    [&](vtkIdType i)
    {
      const Decision decision = decisions[i];
      decisions[i] = decision.Ring == RingKind::BoundaryOfSolid
        ? DecideIn(decision.Result.GetRule(), decision.Result.GetType(), DimensionBit(2))
        : decision;
    });
}

/// The numbers of the vertices of a skin one step later, in the whole.
template <typename Id>
Buffer<Id> FindVertices(const HybridPatch<Id>& patch, const CellComplex<Id>& skin)
{
  const Id edges = patch.GetComplex().NumberOfVertices;
  const Id quads = edges + patch.GetComplex().NumberOfEdges;
  Buffer<Id> vertices(skin.GetNumberOfNewPoints());
  std::copy(patch.Numbers.Vertices.begin(), patch.Numbers.Vertices.end(), vertices.begin());
  for (const std::size_t c : InTurn(patch.Cells.size()))
  {
    const Id* whole = patch.Cells[c].Edges;
    for (const Id edge : skin.CellEdges[static_cast<vtkIdType>(c)])
    {
      vertices[skin.NumberOfVertices + edge] = edges + *whole++;
    }
    if (patch.Cells[c].Shape == CellShape::Quad)
    {
      vertices[skin.NumberOfVertices + skin.NumberOfEdges +
        *skin.CellFaces[static_cast<vtkIdType>(c)].begin()] = quads + *patch.Cells[c].Faces;
    }
  }
  return vertices;
}

template <typename Id>
LimitTangents<Id> BuildNextTangents(
  const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls, int steps)
{
  return BuildHybridTangents(RefineHybrid(level, HybridRules::Smooth),
    GiveTo(FindFirstChildren(level.Complex.Cells), controls), steps);
}

}

template <typename Id>
bool HasClosedSkin(const HybridLevel<Id>& level, int steps, bool wantsCurves)
{
  const CellComplex<Id>& complex = level.Complex;
  const HybridStrata<Id>& strata = level.Strata;
  const SkinRules<Id> skin(level);
  const auto isClosed = [&](const Decision& decision, Row<Id> edges)
  {
    return skin.HasAny(edges) ? skin.IsClosed(decision, edges)
                              : !wantsCurves || decision.Result.GetRule() != Rule::Curve;
  };
  const auto isClosedAtVertex = [&](Id vertex)
  {
    const Decision& decision = strata.Vertices[vertex];
    const Row<Id> edges = complex.VertexEdges[vertex];
    return isClosed(decision, edges) &&
      (decision.Result.GetRule() != Rule::Curve || !skin.HasAny(edges) || skin.HasCurve(vertex));
  };
  return complex.NumberOfTets == 0 ||
    (HasDimension(complex.Cells, 3) && !IsSharpAfter(level, steps) &&
      AreAll(complex.NumberOfFaces,
        [&](Id face)
        {
          const Rule rule = strata.Faces[face].GetRule();
          return skin.HasFace(face) ? rule == Rule::Surface : !wantsCurves || rule != Rule::Curve;
        }) &&
      AreAll(complex.NumberOfEdges,
        [&](Id edge) { return isClosed(strata.Edges[edge], { &edge, &edge + 1 }); }) &&
      AreAll(complex.NumberOfVertices, isClosedAtVertex));
}

template <typename Id>
SkinTangents<Id> BuildHybridSkinTangents(
  const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls, int steps)
{
  SkinTangents<Id> tangents;
  if (level.Complex.NumberOfTets == 0)
  {
    tangents.Tangents = BuildNextTangents(level, controls, steps);
    return tangents;
  }
  HybridPatch<Id> patch(level);
  ReadSkin(level, patch);
  HybridLevel<Id> skin = patch.MakeLevel();
  TurnIntoSurfaces(skin.Strata.Vertices);
  TurnIntoSurfaces(skin.Strata.Edges);
  std::vector<SectorEdge<Id>>& sectors = skin.Strata.Sectors;
  const auto isInside = [](const SectorEdge<Id>& sector) { return sector.Edge < 0; };
  sectors.erase(std::remove_if(sectors.begin(), sectors.end(), isInside), sectors.end());
  const FacesOfControl<Id> faces(level.Complex, controls);
  std::vector<vtkIdType> sides;
  for (const StarCell<Id>& cell : InTurn(patch.Cells))
  {
    sides.push_back(~faces.GetSide(*cell.Faces, cell.Corners[0], cell.Corners[1]));
  }
  tangents.HasAll = false;
  tangents.Vertices = FindVertices(patch, skin.Complex);
  tangents.Tangents = BuildNextTangents(skin, sides, steps);
  return tangents;
}

template <typename Id>
bool LooksSmooth(const HybridLevel<Id>& control, int steps)
{
  const CellComplex<Id>& complex = control.Complex;
  const HybridStrata<Id>& strata = control.Strata;
  const bool hasSolids = complex.NumberOfTets > 0;
  if (!HasDimension(complex.Cells, hasSolids ? 3 : 2) || IsSharpAfter(control, steps) ||
    HasSharpSkin(
      complex.EdgeVertices, complex.NumberOfVertices,
      [&strata](Id vertex) { return strata.Vertices[vertex].Result; },
      [&strata](Id edge) { return strata.Edges[edge].Result; },
      [&](Id edge) { return !hasSolids && complex.EdgeFaces[edge].size() == 1; }))
  {
    return false;
  }
  const FaceSides sides = hasSolids ? FaceSides() : FindPolygonSides(control);
  return std::count(sides.Twisted.begin(), sides.Twisted.end(), 1) == 0;
}

#define SUBDIVISION_SKIN(Id)                                                                       \
  template bool HasClosedSkin(const HybridLevel<Id>&, int, bool);                                  \
  template SkinTangents<Id> BuildHybridSkinTangents(                                               \
    const HybridLevel<Id>&, const std::vector<vtkIdType>&, int);                                   \
  template bool LooksSmooth(const HybridLevel<Id>&, int)
SUBDIVISION_SKIN(int);
SUBDIVISION_SKIN(long long);

}
