// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularParts.h
 * Where the limit over a simplex of a curve or surface is a polynomial: which vertices, at its
 * corners and inside of it, are regular.
 */
#ifndef SubdivisionObjects_RegularParts_h
#define SubdivisionObjects_RegularParts_h

#include "Core/Memory/PairTable.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Solids/Limits/SheetReader.h"

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
  RegularParts Parts{};
  /// Whether it is a part of a curve, or of a sheet, inside of which all is regular. Then this is
  /// what the limit over it depends on; the places of the key are a lattice in the whole simplex.
  bool IsPatch = false;
  SheetPatch<Id> Patch;
};

/// Finds what is regular in the simplices of places.
template <typename LevelType>
class RegularReader
{
public:
  using Id = typename LevelType::IdType;

  RegularReader(const LevelType& level, const std::vector<LimitPlace<Id>>& places)
    : Level(level)
    , Reader(level, None)
  {
    Buffer<unsigned char> isCorner(level.Complex.NumberOfVertices, 0);
    for (const LimitPlace<Id>& place : InTurn(places))
    {
      for (int i = 0; i <= place.Dimension; ++i)
      {
        isCorner[place.Corners[i]] = 1;
      }
    }
    ForEachInTurn(level.Complex.NumberOfEdges,
      [&](vtkIdType e)
      {
        const Id* ends = level.Complex.EdgeVertices.data() + 2 * e;
        if (isCorner[ends[0]] && isCorner[ends[1]])
        {
          this->Edges.FindOrAdd(ends[0], ends[1], static_cast<Id>(e));
        }
      });
    ForEachInTurn(level.Complex.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id* ids = level.Complex.FaceVertices.data() + 3 * f;
        if (isCorner[ids[0]] && isCorner[ids[1]] && isCorner[ids[2]])
        {
          std::array<Id, 3> corners{ { ids[0], ids[1], ids[2] } };
          std::sort(corners.begin(), corners.end());
          this->Faces.emplace_back(corners, static_cast<Id>(f));
        }
      });
    std::sort(this->Faces.begin(), this->Faces.end());
  }

  const RegularSimplex<Id>& Find(const LimitPlace<Id>& place)
  {
    if (this->Last && this->Last->first == place.Corners)
    {
      return this->Last->second;
    }
    const auto [found, isNew] = this->Found.try_emplace(place.Corners);
    this->Last = &*found;
    if (isNew && place.Dimension == 1)
    {
      this->ReadLine(place.Corners, found->second);
    }
    if (isNew && place.Dimension == 2)
    {
      this->ReadTriangle(place.Corners, found->second);
    }
    return found->second;
  }
  LoopWeights GetWeights() const { return this->Level.Strata.Weights; }

private:
  Id FindFace(std::array<Id, 3> corners) const
  {
    std::sort(corners.begin(), corners.end());
    const auto face = std::lower_bound(this->Faces.begin(), this->Faces.end(), corners,
      [](const auto& listed, const auto& wanted) { return listed.first < wanted; });
    return face == this->Faces.end() || face->first != corners ? Id(-1) : face->second;
  }
  Rule GetRule(Id vertex) const { return this->Level.Strata.Vertices[vertex].GetRule(); }

  /// Whether a vertex between the ends of an edge is regular.
  bool IsRegularEdge(Id edge) const
  {
    if (edge < 0)
    {
      return false;
    }
    const Rule rule = this->Level.Strata.Edges[edge].GetRule();
    const Row<Id> faces = this->Level.Strata.EdgeRings.GetCarriers(edge);
    return rule == Rule::Curve ||
      (rule == Rule::Surface && faces.size() == 2 && faces.begin()[0] >= 0 &&
        faces.begin()[1] >= 0);
  }

  void ReadLine(const std::array<Id, 4>& corners, RegularSimplex<Id>& simplex)
  {
    RegularParts& parts = simplex.Parts;
    const Id edge = this->Edges.Find(corners[0], corners[1]);
    parts[3] = this->IsRegularEdge(edge);
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
      const auto takesFirst = [](Id, Id) { return false; };
      this->Reader.ReadEdge(edge, corners[0], corners[1], takesFirst, simplex.Patch);
      simplex.Patch.Key.Places = SheetPlaces::CurveLattice;
    }
  }

  void ReadTriangle(const std::array<Id, 4>& corners, RegularSimplex<Id>& simplex)
  {
    RegularParts& parts = simplex.Parts;
    const std::array<Id, 3> ordered{ { corners[0], corners[1], corners[2] } };
    const Id face = this->FindFace(ordered);
    if (face < 0 || this->Level.Strata.Faces[face].GetRule() != Rule::Surface)
    {
      return;
    }
    parts[7] = true;
    for (int i = 0; i < 3; ++i)
    {
      const int k = (i + 1) % 3;
      parts[1 << i | 1 << k] = this->IsRegularEdge(this->Edges.Find(corners[i], corners[k]));
    }
    const bool isSheet = this->Reader.ReadFace(face, ordered, simplex.Patch);
    for (int i = 0; isSheet && i < 3; ++i)
    {
      const SheetFan& fan = simplex.Patch.Key.Fans[i];
      parts[1 << i] = (fan.What == SheetFan::Kind::Closed && fan.After == 4) ||
        (fan.What == SheetFan::Kind::Open && fan.After + fan.Before == 2);
    }
    simplex.IsPatch = isSheet && parts[3] && parts[5] && parts[6];
    simplex.Patch.Key.Places = SheetPlaces::FaceLattice;
  }

  const Buffer<unsigned char> None;
  const LevelType& Level;
  const SheetReader<LevelType> Reader;
  PairTable<Id> Edges;
  std::vector<std::pair<std::array<Id, 3>, Id>> Faces; ///< by their corners, ascending
  std::map<std::array<Id, 4>, RegularSimplex<Id>> Found;
  const std::pair<const std::array<Id, 4>, RegularSimplex<Id>>* Last = nullptr; ///< that was found
};

}

#endif
