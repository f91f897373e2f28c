// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularParts.h
 * Where the limit over a simplex of a curve or surface is a polynomial: which vertices, at its
 * corners and inside of it, are regular.
 */
#ifndef SubdivisionObjects_RegularParts_h
#define SubdivisionObjects_RegularParts_h

#include "Core/Operators/SplineColumns.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Solids/Limits/SheetReader.h"
#include "Core/Solids/Limits/SimplexTable.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace subdivision
{

/// Which parts of a simplex have nothing but regular vertices inside, by the corners that a part
/// has, one bit for each.
using RegularParts = std::array<bool, 16>;

template <typename Id>
struct RegularSimplex
{
  /// The corners in the order in which all below counts them: those of a triangle are turned, so
  /// that fewer different neighbourhoods serve a mesh. The first one is corner Turn of a place.
  std::array<Id, 4> Corners;
  int Turn = 0;
  Id Number = -1; ///< of the vertex, edge or face
  RegularParts Parts{};
  /// Whether it is a part of a curve, or of a sheet, inside of which all is regular. Then this is
  /// what the limit over it depends on.
  bool IsPatch = false;
  SheetPatch<Id> Patch;    ///< not set where there is Inner
  SplineColumns<Id> Inner; ///< of a triangle in which and around which all is regular
};

/// A place in a simplex with its corners in their order there.
template <typename Id>
PlaceInPart StartPart(const LimitPlace<Id>& place, const RegularSimplex<Id>& simplex)
{
  PlaceInPart part = StartPart(place);
  const auto turn = [&simplex](CornerWeights& weights)
  { std::rotate(weights.begin(), weights.begin() + simplex.Turn, weights.begin() + 3); };
  if (simplex.Turn > 0)
  {
    turn(part.At);
    std::for_each(part.Directions.begin(), part.Directions.end(), turn);
  }
  return part;
}

/// Finds what is regular in the simplices of places.
template <typename LevelType>
class RegularReader
{
public:
  using Id = typename LevelType::IdType;

  RegularReader(const LevelType& level, const std::vector<LimitPlace<Id>>& places)
    : Level(level)
    , Reader(level)
  {
    const SimplicialComplex<Id>& complex = level.Complex;
    const auto isCorner = FlagCorners(complex.NumberOfVertices, places, false);
    this->Edges = { complex.NumberOfEdges, isCorner, complex.EdgeVertices };
    this->Faces = { complex.NumberOfFaces, isCorner, complex.FaceVertices };
  }

  const RegularSimplex<Id>& Find(const LimitPlace<Id>& place)
  {
    if (this->Last && this->Last->first == place.Corners)
    {
      return this->Last->second;
    }
    const auto [found, isNew] = this->Found.try_emplace(place.Corners);
    this->Last = &*found;
    if (isNew)
    {
      found->second.Corners = place.Corners;
      found->second.Number = place.Dimension == 0 ? place.Corners[0] : Id(-1);
    }
    if (isNew && place.Dimension == 1)
    {
      this->ReadLine(place.Corners, found->second);
    }
    if (isNew && place.Dimension == 2)
    {
      this->ReadTriangle(found->second);
    }
    return found->second;
  }
  LoopWeights GetWeights() const { return this->Level.Strata.Weights; }

private:
  Rule GetRule(Id vertex) const { return this->Level.Strata.Vertices[vertex].GetRule(); }

  /// Whether a vertex between the ends of an edge is regular.
  bool IsRegularEdge(Id edge) const
  {
    return this->Level.Strata.Edges[edge].GetRule() == Rule::Curve || this->Reader.IsInside(edge);
  }

  void ReadLine(const std::array<Id, 4>& corners, RegularSimplex<Id>& simplex)
  {
    RegularParts& parts = simplex.Parts;
    const Id edge = this->Edges.Find(corners.data());
    simplex.Number = edge;
    parts[3] = edge >= 0 && this->IsRegularEdge(edge);
    const bool isCurve = parts[3] && this->Level.Strata.Edges[edge].GetRule() == Rule::Curve;
    for (int i = 0; i < 2; ++i)
    {
      SheetPatch<Id> patch;
      const bool isRead = this->Reader.ReadVertex(corners[i], patch);
      const auto& columns = patch.Columns;
      parts[1 << i] = parts[3] && isRead &&
        (isCurve ? patch.Key.Places == SheetPlaces::CurveVertex &&
              (columns.size() == 1 ||
                std::find(columns.begin(), columns.end(), corners[1 - i]) != columns.end())
                 : columns.size() == 7);
    }
    simplex.IsPatch = isCurve && parts[1] && parts[2];
    if (simplex.IsPatch)
    {
      this->Reader.ReadCurve(edge, corners[0], corners[1], simplex.Patch);
    }
  }

  /// Whether a corner of a triangle has six triangles, all around it.
  bool IsRegularCorner(Id vertex) const
  {
    constexpr vtkIdType regular = 6;
    return this->GetRule(vertex) == Rule::Surface &&
      this->Level.Strata.VertexRings.GetMembers(vertex).size() == regular;
  }
  /// Makes a corner that is not regular, behind one that is, the first of all.
  void Turn(RegularSimplex<Id>& simplex) const
  {
    auto& corners = simplex.Corners;
    std::array<bool, 3> isRegular{};
    std::transform(corners.begin(), corners.begin() + 3, isRegular.begin(),
      [this](Id vertex) { return this->IsRegularCorner(vertex); });
    for (int k = 1; k < 3; ++k)
    {
      if (!isRegular[k] && isRegular[k - 1])
      {
        simplex.Turn = k;
      }
    }
    std::rotate(corners.begin(), corners.begin() + simplex.Turn, corners.begin() + 3);
  }
  void ReadTriangle(RegularSimplex<Id>& simplex)
  {
    this->Turn(simplex);
    RegularParts& parts = simplex.Parts;
    const auto& corners = simplex.Corners;
    const std::array<Id, 3> ordered{ { corners[0], corners[1], corners[2] } };
    const Id face = this->Faces.Find(ordered.data());
    simplex.Number = face;
    if (face < 0 || this->Level.Strata.Faces[face].GetRule() != Rule::Surface)
    {
      return;
    }
    parts[7] = true;
    const SimplicialComplex<Id>& complex = this->Level.Complex;
    for (int i = 0; i < 3; ++i)
    {
      const int k = (i + 1) % 3;
      const int opposite = complex.VertexInFace(face, corners[(i + 2) % 3]);
      parts[1 << i | 1 << k] = this->IsRegularEdge(
        complex.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[opposite]]);
    }
    SheetPatch<Id>& patch = this->Patch;
    const bool isSheet = this->Reader.ReadFace(face, ordered, patch);
    for (int i = 0; isSheet && i < 3; ++i)
    {
      const SheetFan& fan = patch.Key.Fans[i];
      parts[1 << i] = (fan.What == SheetFan::Kind::Closed && fan.After == 4) ||
        (fan.What == SheetFan::Kind::Open && fan.After + fan.Before == 2);
    }
    simplex.IsPatch = isSheet && parts[3] && parts[5] && parts[6];
    if (simplex.IsPatch && (simplex.Turn > 0 || !SetInner(patch, simplex.Inner)))
    {
      simplex.Patch = patch;
    }
  }

  /// Finds the control points of the spline among the columns (SheetKey). False: it needs others.
  static bool SetInner(const SheetPatch<Id>& patch, SplineColumns<Id>& inner)
  {
    constexpr int regular = 4;
    const auto& fans = patch.Key.Fans;
    const auto isInner = [](const SheetFan& fan)
    { return fan.What == SheetFan::Kind::Closed && fan.After == regular; };
    if (!std::all_of(fans.begin(), fans.end(), isInner))
    {
      return false;
    }
    std::array<Id, BicubicPoints> points{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id* fan = patch.Columns.data() + 3 + regular * k;
      points[k] = patch.Columns[k];
      points[3 + k] = fan[3];
      points[6 + 2 * k] = fan[2];
      points[7 + 2 * k] = fan[1];
    }
    return inner.Set(points, BoxSplinePoints);
  }

  const LevelType& Level;
  const SheetReader<LevelType> Reader;
  SimplexTable<Id, 2> Edges;
  SimplexTable<Id, 3> Faces;
  SheetPatch<Id> Patch; ///< that was read last
  std::map<std::array<Id, 4>, RegularSimplex<Id>> Found;
  const std::pair<const std::array<Id, 4>, RegularSimplex<Id>>* Last = nullptr; ///< that was found
};

}

#endif
