// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SheetReader.h
 * Reads off a level what the limit over a part of a curve or sheet depends on (SheetKey.h).
 */
#ifndef SubdivisionObjects_SheetReader_h
#define SubdivisionObjects_SheetReader_h

#include "Core/Rules/Rule.h"
#include "Core/Solids/Limits/SheetKey.h"
#include "Core/Solids/Strata/Strata.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace subdivision
{

/// A key, and the vertices of the level that are its columns.
template <typename Id>
struct SheetPatch
{
  SheetKey Key;
  std::vector<Id> Columns;
};

/// Whether the values at one vertex come before those at another. Where there are several patches,
/// or orders of corners, this chooses one whichever order cells have, unless values are equal.
inline bool AreValuesBefore(const double* values, vtkIdType components, vtkIdType a, vtkIdType b)
{
  const double* of = values + components * a;
  const double* other = values + components * b;
  return std::lexicographical_compare(of, of + components, other, other + components);
}

/// The places of two or three corners, sorted by isBefore(place, place). A loop of its own: g++ 14
/// takes std::sort of an array of three for one that reads beyond it.
template <typename IsBefore>
std::array<int, 3> SortCorners(int size, const IsBefore& isBefore)
{
  std::array<int, 3> order{ { 0, 1, 2 } };
  for (int k = 1; k < size; ++k)
  {
    for (int i = k; i > 0 && isBefore(order[i], order[i - 1]); --i)
    {
      std::swap(order[i], order[i - 1]);
    }
  }
  return order;
}

/// Each method returns false where limits depend on more than a sheet: at joints, inside solids,
/// where a crease ends in a dart, where too many triangles meet, and next to a sector with rules of
/// its own (SectorEdges.h).
template <typename LevelType>
class SheetReader
{
public:
  using Id = typename LevelType::IdType;

  explicit SheetReader(const LevelType& level)
    : Complex(level.Complex)
    , Strata(level.Strata)
  {
  }
  bool ReadVertex(Id vertex, SheetPatch<Id>& patch) const
  {
    const Rule rule = this->RuleOfVertex(vertex);
    const Row<Id> ring = this->Strata.VertexRings.GetMembers(vertex);
    const Row<Id> edges = this->Strata.VertexRings.GetCarriers(vertex);
    patch.Columns.assign(1, vertex);
    patch.Key = SheetKey();
    const auto size = static_cast<int>(std::min<vtkIdType>(ring.size(), SheetFan::Most + 3));
    if (rule == Rule::Corner)
    {
      patch.Key.Places = SheetPlaces::CurveVertex;
      patch.Key.Fans[0].What = SheetFan::Kind::OpenCorner;
      return true;
    }
    patch.Columns.insert(patch.Columns.end(), ring.begin(), ring.end());
    if (rule == Rule::Curve)
    {
      patch.Key.Places = SheetPlaces::CurveVertex;
      patch.Key.Fans[0].What = SheetFan::Kind::Open;
      return size == 2 &&
        std::all_of(edges.begin(), edges.end(),
          [this](Id edge) { return this->RuleOfEdge(edge) == Rule::Curve; });
    }
    patch.Key.Fans[0] = { SheetFan::Kind::Closed, size - 2, 0 };
    return rule == Rule::Surface && size > 2 && size - 2 <= SheetFan::Most &&
      std::all_of(edges.begin(), edges.end(), [this](Id edge) { return this->IsInside(edge); });
  }
  /// An edge of a curve from a to b.
  /// Both ends are on the curve, which goes on to the other member of the ring.
  bool ReadCurve(Id edge, Id a, Id b, SheetPatch<Id>& patch) const
  {
    patch.Key = SheetKey();
    patch.Key.Places = SheetPlaces::Curve;
    patch.Columns.assign({ a, b });
    if (this->RuleOfEdge(edge) != Rule::Curve)
    {
      return false;
    }
    for (int i = 0; i < 2; ++i)
    {
      const Id end = i == 0 ? a : b;
      const Id other = i == 0 ? b : a;
      const Rule rule = this->RuleOfVertex(end);
      if (rule == Rule::Corner)
      {
        patch.Key.Fans[i].What = SheetFan::Kind::OpenCorner;
        continue;
      }
      const Row<Id> ring = this->Strata.VertexRings.GetMembers(end);
      const Row<Id> edges = this->Strata.VertexRings.GetCarriers(end);
      const bool isFirst = ring.size() == 2 && ring.begin()[0] == other;
      if (rule != Rule::Curve || ring.size() != 2 || (!isFirst && ring.begin()[1] != other) ||
        this->RuleOfEdge(edges.begin()[isFirst ? 1 : 0]) != Rule::Curve)
      {
        return false;
      }
      patch.Key.Fans[i].What = SheetFan::Kind::Open;
      patch.Columns.push_back(ring.begin()[isFirst ? 1 : 0]);
    }
    return true;
  }
  /// The face at an edge inside a sheet, to which `third` becomes the third corner. isBefore(c, d)
  /// chooses between two by these. -1: the edge lies elsewhere.
  template <typename IsBefore>
  Id ChooseFace(Id edge, const IsBefore& isBefore, Id& third) const
  {
    if (!this->IsInside(edge))
    {
      return -1;
    }
    const Id* faces = this->Strata.EdgeRings.GetCarriers(edge).begin();
    const Id thirds[2] = { this->GetThird(faces[0], edge), this->GetThird(faces[1], edge) };
    const int taken = isBefore(thirds[1], thirds[0]) ? 1 : 0;
    third = thirds[taken];
    return faces[taken];
  }
  /// A face, with its corners in this order.
  bool ReadFace(Id face, const std::array<Id, 3>& corners, SheetPatch<Id>& patch) const
  {
    patch.Key = SheetKey();
    patch.Key.Places = SheetPlaces::Face;
    patch.Columns.assign(corners.begin(), corners.end());
    bool isSheet = true;
    for (int i = 0; isSheet && i < 3; ++i)
    {
      isSheet =
        this->ReadFan(face, corners[i], corners[(i + 1) % 3], patch.Key.Fans[i], patch.Columns);
    }
    return isSheet;
  }

  /// Whether an edge has a triangle of the sheet on both sides, and the plain rule.
  bool IsInside(Id edge) const
  {
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(edge);
    return this->RuleOfEdge(edge) == Rule::Surface && faces.size() == 2 && faces.begin()[0] >= 0 &&
      faces.begin()[1] >= 0 && FindSectorEdges(this->Strata.Sectors, edge).IsEmpty();
  }

private:
  Rule RuleOfVertex(Id vertex) const { return this->Strata.Vertices[vertex].GetRule(); }
  Rule RuleOfEdge(Id edge) const { return this->Strata.Edges[edge].GetRule(); }
  Id GetThird(Id face, Id edge) const
  {
    return this->Complex.FaceVertices[3 * vtkIdType(face) +
      triangle::VertexOpposite[this->Complex.EdgeInFace(face, edge)]];
  }
  bool ReadFan(Id face, Id vertex, Id next, SheetFan& fan, std::vector<Id>& columns) const
  {
    const Id* edges = this->Complex.FaceEdges.data() + 3 * vtkIdType(face);
    const int corner = this->Complex.VertexInFace(face, vertex);
    Id first = edges[triangle::EdgesAt[corner][0]];
    Id second = edges[triangle::EdgesAt[corner][1]];
    if (this->Complex.GetOtherEnd(first, vertex) != next)
    {
      std::swap(first, second);
    }
    const Rule rule = this->RuleOfVertex(vertex);
    const Row<Id> ring = this->Strata.VertexRings.GetMembers(vertex);
    bool returns = false;
    fan.After = this->Walk(face, vertex, second, columns, returns);
    if (fan.After < 0)
    {
      return false;
    }
    if (returns)
    {
      fan.What = rule == Rule::Corner ? SheetFan::Kind::ClosedCorner : SheetFan::Kind::Closed;
      return fan.After > 0 &&
        (rule == Rule::Corner || (rule == Rule::Surface && ring.size() == fan.After + 2));
    }
    fan.Before = this->Walk(face, vertex, first, columns, returns);
    if (fan.Before < 0 || returns)
    {
      return false;
    }
    fan.What = rule == Rule::Corner ? SheetFan::Kind::OpenCorner : SheetFan::Kind::Open;
    if (rule == Rule::Corner)
    {
      return true;
    }
    // The curve through the vertex is that on which the sheet ends.
    const Id a = this->Complex.GetOtherEnd(second, vertex);
    const Id b = this->Complex.GetOtherEnd(first, vertex);
    return rule == Rule::Curve && ring.size() == 2 &&
      ((ring.begin()[0] == a && ring.begin()[1] == b) ||
        (ring.begin()[0] == b && ring.begin()[1] == a));
  }

  /// Goes around a vertex from a face, across an edge of it, to the curve on which the vertex lies,
  /// or back to the face (then `returns`), and appends the far ends of the edges that it comes to,
  /// without the last one if it returns. `edge` becomes that on which it ends. Returns how many it
  /// appends, -1 where there is no sheet.
  int Walk(Id face, Id vertex, Id& edge, std::vector<Id>& columns, bool& returns) const
  {
    int count = 0;
    returns = false;
    for (Id at = face; count <= SheetFan::Most;)
    {
      if (this->Strata.Faces[at].GetRule() != Rule::Surface)
      {
        return -1;
      }
      if (this->RuleOfEdge(edge) == Rule::Curve)
      {
        return count;
      }
      const Id* faces = this->Strata.EdgeRings.GetCarriers(edge).begin();
      if (!this->IsInside(edge) || (faces[0] != at && faces[1] != at)) // of another surface
      {
        return -1;
      }
      at = faces[0] == at ? faces[1] : faces[0];
      if (at == face)
      {
        returns = true;
        if (count > 0)
        {
          columns.pop_back();
        }
        return count - 1;
      }
      edge = this->Complex.OtherEdge(at, edge, vertex);
      columns.push_back(this->Complex.GetOtherEnd(edge, vertex));
      ++count;
    }
    return -1;
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
};

}

#endif
