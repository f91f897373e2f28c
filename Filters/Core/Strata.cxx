// SPDX-License-Identifier: BSD-3-Clause
#include "Strata.h"

#include "Links.h"
#include "Simplices.h"

#include <iterator>
#include <limits>

namespace subdivision
{
namespace
{

/// Which edges at a vertex, or faces at an edge, make its ring.
enum class RingKind : unsigned char
{
  None,
  Creases,         ///< edges that are singular lines
  SingularFaces,   ///< singular faces, and the edges on them
  SharpJoints,     ///< edges that became d = 1 by the rule Sharp
  InDimensions,    ///< all edges or faces in one of the C_k of a set
  BoundaryOfSolid, ///< boundary faces of C_3 and their edges
  BoundaryOfSurface,
  Part             ///< lines or triangles of one part
};

struct Decision
{
  Stratum Result;
  RingKind Ring;
  unsigned char Dimensions;
  int Part;
};

constexpr Rule RuleOfDimension(int d)
{
  return static_cast<Rule>(d);
}

template <typename Id>
class StrataBuilder
{
public:
  StrataBuilder(const SimplicialComplex<Id>& complex, const SingularSimplices& singular,
    const StrataOptions& options)
    : Complex(complex)
    , Singular(singular)
    , Options(options)
    , Around(complex)
  {
  }

  Strata<Id> Build();
  void Describe(Decomposition<Id>& decomposition) const;

private:
  // Edges.
  Decision DecideEdge(Id edge) const;
  Decision DecideJointEdge(Id edge, int type, unsigned char dimensions, JointRule rule) const;
  Decision DecideEdgeIn(Id edge, int k, int type, bool follow) const;
  bool IsRegular(Id edge) const;
  bool IsInEdgeRing(Id face, const Decision& decision) const;
  // Vertices.
  Decision DecideVertex(Id vertex) const;
  bool DecideSingularVertex(Id vertex, int type, Decision& decision) const;
  Decision DecideJointVertex(Id vertex, int type, unsigned char dimensions, JointRule rule) const;
  Decision DecideVertexIn(Id vertex, int k, int type, bool follow) const;
  bool IsInVertexRing(Id edge, const Decision& decision) const;
  bool LiesOnBoundaryCurve(Id vertex) const;
  int FindPartAtVertex(Id vertex, int k) const;
  int FindPartAtEdge(Id edge) const;
  // Shared.
  int TypeOf(unsigned char dimensions, const Place places[4]) const;
  JointRule Choice(int type, unsigned char regional) const;
  Stratum DecideFace(Id face) const;
  int CountSingularFaces(Id edge) const;
  int PartOfEdge(Id e) const { return this->Options.EdgeParts.empty() ? -1 : this->Options.EdgeParts[e]; }
  int PartOfFace(Id f) const { return this->Options.FaceParts.empty() ? -1 : this->Options.FaceParts[f]; }
  bool IsSingularFace(Id face) const
  {
    return !this->Singular.Faces.empty() && this->Singular.Faces[face];
  }
  bool IsCrease(Id edge) const { return this->EdgeMarks[edge] & 1; }
  bool IsSharpJoint(Id edge) const { return this->EdgeMarks[edge] & 2; }
  std::vector<std::vector<Id>> CollectReliefs(const Buffer<Decision>& edges) const;
  void CollectRelief(Id edge, const Decision& decision, std::vector<Id>& relief) const;

  const SimplicialComplex<Id>& Complex;
  const SingularSimplices& Singular;
  const StrataOptions& Options;
  const Links<Id> Around;
  Buffer<Place> EdgePlaces; ///< in C_3
  Buffer<unsigned char> EdgeMarks;
};

/// Type 1: in C_k and C_l. Otherwise what the only C_k says.
template <typename Id>
int StrataBuilder<Id>::TypeOf(unsigned char dimensions, const Place places[4]) const
{
  if (dimensions & (dimensions - 1))
  {
    return 1;
  }
  for (int k = 1; k <= 3; ++k)
  {
    if (dimensions == DimensionBit(k))
    {
      return places[k] == Place::Type2 ? 2 : places[k] == Place::Type3 ? 3 : 0;
    }
  }
  return 0;
}

template <typename Id>
JointRule StrataBuilder<Id>::Choice(int type, unsigned char regional) const
{
  JointRule rule = type == 1 ? this->Options.Type1
    : type == 2              ? this->Options.Type2
                             : this->Options.Type3;
  if (regional)
  {
    rule = static_cast<JointRule>(regional - 1);
  }
  const bool follows = rule != JointRule::Blend && rule != JointRule::Sharp;
  const bool exists = !follows || (type == 1 && rule != JointRule::FollowPart) ||
    (type == 2 && rule == JointRule::FollowPart);
  return exists ? rule : JointRule::Blend;
}

template <typename Id>
int StrataBuilder<Id>::CountSingularFaces(Id edge) const
{
  int count = 0;
  if (!this->Singular.Faces.empty())
  {
    for (Id face : this->Around.EdgeFaces[edge])
    {
      count += this->IsSingularFace(face) ? 1 : 0;
    }
  }
  return count;
}

template <typename Id>
Stratum StrataBuilder<Id>::DecideFace(Id face) const
{
  const vtkIdType tets = this->Complex.FaceTets[face].size();
  const int type = tets > 2 ? 2 : 0;
  if (tets < 2 || this->IsSingularFace(face))
  {
    return Stratum(Rule::Surface, type);
  }
  if (tets == 2)
  {
    return Stratum(Rule::Solid);
  }
  return Stratum(
    this->Options.Type2 == JointRule::Sharp ? Rule::Curve : Rule::Blend, type);
}

// ------------------------------------------------------------------------------------------------
// Edges (SPEC 4)

template <typename Id>
Decision StrataBuilder<Id>::DecideEdge(Id edge) const
{
  const unsigned char dimensions = this->Around.EdgeDimensions(edge);
  Place places[4] = {};
  for (int k = 1; k <= 3; ++k)
  {
    places[k] = k == 3 ? this->EdgePlaces[edge] : this->Around.PlaceEdge(edge, k);
  }
  const int type = this->TypeOf(dimensions, places);
  const int singularFaces = this->CountSingularFaces(edge);
  const bool flagged = !this->Singular.Edges.empty() && this->Singular.Edges[edge];
  if (flagged || singularFaces == 1 || singularFaces > 2)
  {
    return { Stratum(Rule::Curve, type), RingKind::Creases, 0, 0 };
  }
  if (singularFaces == 2)
  {
    return { Stratum(Rule::Surface, type), RingKind::SingularFaces, 0, 0 };
  }
  if (type)
  {
    const unsigned char regional =
      this->Options.EdgeChoices.empty() ? 0 : this->Options.EdgeChoices[edge];
    return this->DecideJointEdge(edge, type, dimensions, this->Choice(type, regional));
  }
  return this->DecideEdgeIn(edge, dimensions == 1 ? 1 : dimensions == 2 ? 2 : 3, 0, false);
}

template <typename Id>
Decision StrataBuilder<Id>::DecideJointEdge(
  Id edge, int type, unsigned char dimensions, JointRule rule) const
{
  switch (rule)
  {
    case JointRule::Sharp:
      return { Stratum(Rule::Curve, type), RingKind::SharpJoints, 0, 0 };
    case JointRule::FollowDimension1:
    case JointRule::FollowDimension2:
    case JointRule::FollowDimension3:
    {
      const int k = 1 + static_cast<int>(rule) - static_cast<int>(JointRule::FollowDimension1);
      if (dimensions & DimensionBit(k))
      {
        return this->DecideEdgeIn(edge, k, type, true);
      }
      break;
    }
    case JointRule::FollowPart:
    {
      const int part = this->FindPartAtEdge(edge);
      if (part >= 0)
      {
        return { Stratum(Rule::Surface, type), RingKind::Part, DimensionBit(2), part };
      }
      break;
    }
    default:
      break;
  }
  return { Stratum(Rule::Blend, type), RingKind::InDimensions, AllDimensions, 0 };
}

/// The rule of an edge within one C_k; `follow`: the others are there and are ignored.
template <typename Id>
Decision StrataBuilder<Id>::DecideEdgeIn(Id edge, int k, int type, bool follow) const
{
  if (k == 1)
  {
    return { Stratum(Rule::Curve, type), RingKind::None, 0, 0 };
  }
  const Place place = k == 3 ? this->EdgePlaces[edge] : this->Around.PlaceEdge(edge, k);
  switch (place)
  {
    case Place::Boundary:
      return k == 3
        ? Decision{ Stratum(Rule::Surface, type), RingKind::BoundaryOfSolid, 0, 0 }
        : Decision{ Stratum(Rule::Curve, type), RingKind::BoundaryOfSurface, 0, 0 };
    case Place::Interior:
    {
      const Rule rule = k == 2 ? Rule::Surface
        : this->IsRegular(edge) ? Rule::RegularEdge
                                : Rule::Solid;
      return { Stratum(rule, type), RingKind::InDimensions, DimensionBit(k), 0 };
    }
    default:
      break;
  }
  const int inner = place == Place::Type2 ? 2 : 3;
  const unsigned char regional =
    follow && !this->Options.EdgeChoices.empty() ? this->Options.EdgeChoices[edge] : 0;
  Decision decision =
    this->DecideJointEdge(edge, type, DimensionBit(k), this->Choice(inner, regional));
  if (decision.Ring == RingKind::InDimensions)
  {
    decision.Dimensions = DimensionBit(k);
  }
  return decision;
}

/// An interior edge with exactly four tetrahedra that is marked in all four.
template <typename Id>
bool StrataBuilder<Id>::IsRegular(Id edge) const
{
  int faces = 0;
  for (Id face : this->Around.EdgeFaces[edge])
  {
    const Row<Id> tets = this->Complex.FaceTets[face];
    if (tets.size() == 0)
    {
      continue; // a maximal triangle, which an edge that follows C_3 ignores
    }
    ++faces;
    for (Id tet : tets)
    {
      if (!tetrahedron::IsMarked(this->Complex.EdgeInTet(tet, edge)))
      {
        return false;
      }
    }
  }
  return faces == 4;
}

template <typename Id>
bool StrataBuilder<Id>::IsInEdgeRing(Id face, const Decision& decision) const
{
  switch (decision.Ring)
  {
    case RingKind::SingularFaces:
      return this->IsSingularFace(face);
    case RingKind::InDimensions:
      return this->Around.FaceDimension(face) & decision.Dimensions;
    case RingKind::BoundaryOfSolid:
      return this->Complex.FaceTets[face].size() == 1;
    case RingKind::Part:
      return this->Complex.FaceTets[face].size() == 0 && this->PartOfFace(face) == decision.Part;
    default:
      return false;
  }
}

/// The part with the smallest id that has exactly two of the triangles at an edge, or -1.
template <typename Id>
int StrataBuilder<Id>::FindPartAtEdge(Id edge) const
{
  int best = std::numeric_limits<int>::max();
  for (Id face : this->Around.EdgeFaces[edge])
  {
    const int part = this->PartOfFace(face);
    if (part < 0 || part >= best || this->Complex.FaceTets[face].size() > 0)
    {
      continue;
    }
    int count = 0;
    for (Id other : this->Around.EdgeFaces[edge])
    {
      count += this->Complex.FaceTets[other].size() == 0 && this->PartOfFace(other) == part ? 1 : 0;
    }
    best = count == 2 ? part : best;
  }
  return best == std::numeric_limits<int>::max() ? -1 : best;
}

// ------------------------------------------------------------------------------------------------
// Vertices (SPEC 4)

template <typename Id>
Decision StrataBuilder<Id>::DecideVertex(Id vertex) const
{
  const unsigned char dimensions = this->Around.VertexDimensions(vertex);
  Place places[4] = {};
  for (int k = 1; k <= 3; ++k)
  {
    if (dimensions & DimensionBit(k))
    {
      places[k] = this->Around.PlaceVertex(vertex, k, this->EdgePlaces);
    }
  }
  const int type = this->TypeOf(dimensions, places);
  Decision decision;
  if (this->DecideSingularVertex(vertex, type, decision))
  {
    return decision;
  }
  if (dimensions == 0) // isolated
  {
    return { Stratum(Rule::Corner), RingKind::None, 0, 0 };
  }
  if (type)
  {
    const unsigned char regional =
      this->Options.VertexChoices.empty() ? 0 : this->Options.VertexChoices[vertex];
    return this->DecideJointVertex(vertex, type, dimensions, this->Choice(type, regional));
  }
  return this->DecideVertexIn(vertex, dimensions == 1 ? 1 : dimensions == 2 ? 2 : 3, 0, false);
}

/// Lines 1 to 3: singular vertices, creases, singular surfaces. False when none of them applies.
template <typename Id>
bool StrataBuilder<Id>::DecideSingularVertex(Id vertex, int type, Decision& decision) const
{
  const Decision corner = { Stratum(Rule::Corner, type), RingKind::None, 0, 0 };
  if (!this->Singular.Vertices.empty() && this->Singular.Vertices[vertex])
  {
    decision = corner;
    return true;
  }
  int creases = 0;
  bool onSingularFace = false;
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    creases += this->IsCrease(edge) ? 1 : 0;
    onSingularFace = onSingularFace || this->CountSingularFaces(edge) > 0;
  }
  if (creases == 2)
  {
    decision = { Stratum(Rule::Curve, type), RingKind::Creases, 0, 0 };
    return true;
  }
  if (creases > 2 ||
    (creases == 1 && (!this->Options.DartEnds || this->LiesOnBoundaryCurve(vertex))))
  {
    decision = corner;
    return true;
  }
  if (onSingularFace)
  {
    const bool closed = this->Around.IsClosedFan(
      vertex, [this](Id face) { return this->IsSingularFace(face); });
    decision =
      closed ? Decision{ Stratum(Rule::Surface, type), RingKind::SingularFaces, 0, 0 } : corner;
    return true;
  }
  return false;
}

template <typename Id>
bool StrataBuilder<Id>::LiesOnBoundaryCurve(Id vertex) const
{
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    if (this->Around.PlaceEdge(edge, 2) == Place::Boundary ||
      (this->CountSingularFaces(edge) == 1))
    {
      return true;
    }
  }
  return this->Around.PlaceVertex(vertex, 1, this->EdgePlaces) == Place::Boundary;
}

template <typename Id>
Decision StrataBuilder<Id>::DecideJointVertex(
  Id vertex, int type, unsigned char dimensions, JointRule rule) const
{
  switch (rule)
  {
    case JointRule::Sharp:
    {
      int sharp = 0;
      for (Id edge : this->Around.VertexEdges[vertex])
      {
        sharp += this->IsSharpJoint(edge) ? 1 : 0;
      }
      return sharp == 2 ? Decision{ Stratum(Rule::Curve, type), RingKind::SharpJoints, 0, 0 }
                        : Decision{ Stratum(Rule::Corner, type), RingKind::None, 0, 0 };
    }
    case JointRule::FollowDimension1:
    case JointRule::FollowDimension2:
    case JointRule::FollowDimension3:
    {
      const int k = 1 + static_cast<int>(rule) - static_cast<int>(JointRule::FollowDimension1);
      if (dimensions & DimensionBit(k))
      {
        return this->DecideVertexIn(vertex, k, type, true);
      }
      break;
    }
    case JointRule::FollowPart:
    {
      const int k = dimensions & DimensionBit(1) ? 1 : 2;
      const int part = dimensions & DimensionBit(k) ? this->FindPartAtVertex(vertex, k) : -1;
      if (part >= 0)
      {
        return { Stratum(RuleOfDimension(k), type), RingKind::Part, DimensionBit(k), part };
      }
      break;
    }
    default:
      break;
  }
  return { Stratum(Rule::Blend, type), RingKind::InDimensions, AllDimensions, 0 };
}

template <typename Id>
Decision StrataBuilder<Id>::DecideVertexIn(Id vertex, int k, int type, bool follow) const
{
  const Place place = this->Around.PlaceVertex(vertex, k, this->EdgePlaces);
  if (place == Place::Interior)
  {
    return { Stratum(RuleOfDimension(k), type), RingKind::InDimensions, DimensionBit(k), 0 };
  }
  if (place == Place::Boundary)
  {
    const RingKind rings[4] = { RingKind::None, RingKind::None, RingKind::BoundaryOfSurface,
      RingKind::BoundaryOfSolid };
    return { Stratum(RuleOfDimension(k - 1), type), rings[k], 0, 0 };
  }
  const int inner = place == Place::Type2 ? 2 : 3;
  const unsigned char regional =
    follow && !this->Options.VertexChoices.empty() ? this->Options.VertexChoices[vertex] : 0;
  Decision decision =
    this->DecideJointVertex(vertex, type, DimensionBit(k), this->Choice(inner, regional));
  if (decision.Ring == RingKind::InDimensions)
  {
    decision.Dimensions = DimensionBit(k);
  }
  return decision;
}

template <typename Id>
bool StrataBuilder<Id>::IsInVertexRing(Id edge, const Decision& decision) const
{
  switch (decision.Ring)
  {
    case RingKind::Creases:
      return this->IsCrease(edge);
    case RingKind::SharpJoints:
      return this->IsSharpJoint(edge);
    case RingKind::SingularFaces:
      return this->CountSingularFaces(edge) > 0;
    case RingKind::InDimensions:
      return this->Around.EdgeDimensions(edge) & decision.Dimensions;
    case RingKind::BoundaryOfSolid:
      return this->EdgePlaces[edge] == Place::Boundary;
    case RingKind::BoundaryOfSurface:
      return this->Around.PlaceEdge(edge, 2) == Place::Boundary;
    case RingKind::Part:
    {
      if (decision.Dimensions == DimensionBit(1))
      {
        return this->Around.EdgeFaces[edge].size() == 0 && this->PartOfEdge(edge) == decision.Part;
      }
      const Row<Id> faces = this->Around.EdgeFaces[edge];
      return std::any_of(faces.begin(), faces.end(),
        [&](Id face)
        {
          return this->Complex.FaceTets[face].size() == 0 &&
            this->PartOfFace(face) == decision.Part;
        });
    }
    default:
      return false;
  }
}

/// The part with the smallest id that goes on through a vertex: two of its lines, or triangles of
/// it that close around the vertex; -1 if there is none.
template <typename Id>
int StrataBuilder<Id>::FindPartAtVertex(Id vertex, int k) const
{
  std::vector<int> parts;
  for (Id edge : this->Around.VertexEdges[vertex])
  {
    if (k == 1 && this->Around.EdgeFaces[edge].size() == 0)
    {
      parts.push_back(this->PartOfEdge(edge));
    }
    for (Id face : this->Around.EdgeFaces[edge])
    {
      if (k == 2 && this->Complex.FaceTets[face].size() == 0)
      {
        parts.push_back(this->PartOfFace(face));
      }
    }
  }
  std::sort(parts.begin(), parts.end());
  for (auto part = parts.begin(); part != parts.end();)
  {
    const auto next = std::upper_bound(part, parts.end(), *part);
    const bool goesOn = *part >= 0 &&
      (k == 1 ? next - part == 2
              : this->Around.IsClosedFan(vertex,
                  [&](Id face)
                  {
                    return this->Complex.FaceTets[face].size() == 0 &&
                      this->PartOfFace(face) == *part;
                  }));
    if (goesOn)
    {
      return *part;
    }
    part = next;
  }
  return -1;
}

// ------------------------------------------------------------------------------------------------

/// Rings of those carriers in `around` that `accept` takes, and after them the `reliefs`.
template <typename Id, typename Accept, typename Member>
Rings<Id> MakeRings(const Rows<Id>& around, const Accept& accept, const Member& member,
  const std::vector<std::vector<Id>>& reliefs)
{
  const vtkIdType size = around.GetNumberOfRows();
  Rings<Id> rings;
  rings.Offsets = Buffer<Id>(size + 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      const Row<Id> row = around[i];
      const auto count =
        std::count_if(row.begin(), row.end(), [&](Id carrier) { return accept(i, carrier); });
      rings.Offsets[i] = static_cast<Id>(count + (reliefs.empty() ? 0 : reliefs[i].size()));
    });
  CountsToOffsets(rings.Offsets);
  rings.Members = Buffer<Id>(rings.Offsets[size]);
  rings.Carriers = Buffer<Id>(rings.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      Id out = rings.Offsets[i];
      for (Id carrier : around[i])
      {
        if (accept(i, carrier))
        {
          rings.Members[out] = member(i, carrier);
          rings.Carriers[out++] = carrier;
        }
      }
      if (!reliefs.empty())
      {
        for (Id vertex : reliefs[i])
        {
          rings.Members[out] = vertex;
          rings.Carriers[out++] = -1;
        }
      }
    });
  return rings;
}

/// Common neighbours of the ends of a Blend edge that lie on no face with it.
template <typename Id>
void StrataBuilder<Id>::CollectRelief(
  Id edge, const Decision& decision, std::vector<Id>& relief) const
{
  std::vector<Id> neighbours[2];
  for (int end = 0; end < 2; ++end)
  {
    const Id vertex = this->Complex.EdgeVertices[2 * edge + end];
    for (Id other : this->Around.VertexEdges[vertex])
    {
      if (this->Around.EdgeDimensions(other) & decision.Dimensions)
      {
        neighbours[end].push_back(this->Complex.OtherEnd(other, vertex));
      }
    }
    std::sort(neighbours[end].begin(), neighbours[end].end());
  }
  std::vector<Id> common;
  std::set_intersection(neighbours[0].begin(), neighbours[0].end(), neighbours[1].begin(),
    neighbours[1].end(), std::back_inserter(common));
  std::vector<Id> spanned;
  for (Id face : this->Around.EdgeFaces[edge])
  {
    if (this->IsInEdgeRing(face, decision))
    {
      spanned.push_back(this->Complex.VertexOpposite(face, edge));
    }
  }
  std::sort(spanned.begin(), spanned.end());
  std::set_difference(common.begin(), common.end(), spanned.begin(), spanned.end(),
    std::back_inserter(relief));
}

/// The reliefs of all edges; empty where no edge has one.
template <typename Id>
std::vector<std::vector<Id>> StrataBuilder<Id>::CollectReliefs(
  const Buffer<Decision>& edges) const
{
  std::vector<std::vector<Id>> reliefs(edges.size());
  ForEach(edges.size(),
    [&](vtkIdType e)
    {
      if (edges[e].Result.GetRule() == Rule::Blend)
      {
        this->CollectRelief(static_cast<Id>(e), edges[e], reliefs[e]);
      }
    });
  if (std::all_of(reliefs.begin(), reliefs.end(), [](const auto& r) { return r.empty(); }))
  {
    reliefs.clear();
  }
  return reliefs;
}

template <typename Id>
Strata<Id> StrataBuilder<Id>::Build()
{
  const vtkIdType edges = this->Complex.NumberOfEdges;
  const vtkIdType vertices = this->Complex.NumberOfVertices;
  Strata<Id> strata;
  this->EdgePlaces = Buffer<Place>(edges);
  ForEach(edges,
    [&](vtkIdType e) { this->EdgePlaces[e] = this->Around.PlaceEdge(static_cast<Id>(e), 3); });

  Buffer<Decision> edgeDecisions(edges);
  this->EdgeMarks = Buffer<unsigned char>(edges);
  strata.Edges = Buffer<Stratum>(edges);
  ForEach(edges,
    [&](vtkIdType e)
    {
      const Decision decision = this->DecideEdge(static_cast<Id>(e));
      edgeDecisions[e] = decision;
      strata.Edges[e] = decision.Result;
      this->EdgeMarks[e] = decision.Ring == RingKind::Creases ? 1
        : decision.Ring == RingKind::SharpJoints              ? 2
                                                              : 0;
    });
  Buffer<Decision> vertexDecisions(vertices);
  strata.Vertices = Buffer<Stratum>(vertices);
  ForEach(vertices,
    [&](vtkIdType v)
    {
      vertexDecisions[v] = this->DecideVertex(static_cast<Id>(v));
      strata.Vertices[v] = vertexDecisions[v].Result;
    });
  strata.Faces = Buffer<Stratum>(this->Complex.NumberOfFaces);
  ForEach(this->Complex.NumberOfFaces,
    [&](vtkIdType f) { strata.Faces[f] = this->DecideFace(static_cast<Id>(f)); });

  strata.EdgeRings = MakeRings(
    this->Around.EdgeFaces,
    [&](vtkIdType e, Id face) { return this->IsInEdgeRing(face, edgeDecisions[e]); },
    [&](vtkIdType e, Id face) { return this->Complex.VertexOpposite(face, static_cast<Id>(e)); },
    this->CollectReliefs(edgeDecisions));
  strata.VertexRings = MakeRings(
    this->Around.VertexEdges,
    [&](vtkIdType v, Id edge) { return this->IsInVertexRing(edge, vertexDecisions[v]); },
    [&](vtkIdType v, Id edge) { return this->Complex.OtherEnd(edge, static_cast<Id>(v)); },
    std::vector<std::vector<Id>>());
  return strata;
}

template <typename Id>
void StrataBuilder<Id>::Describe(Decomposition<Id>& decomposition) const
{
  const vtkIdType edges = this->Complex.NumberOfEdges;
  const vtkIdType vertices = this->Complex.NumberOfVertices;
  decomposition.EdgeDimensions = Buffer<unsigned char>(edges);
  decomposition.EdgeBoundary = Buffer<unsigned char>(edges);
  decomposition.VertexDimensions = Buffer<unsigned char>(vertices);
  decomposition.VertexBoundary = Buffer<unsigned char>(vertices);
  ForEach(edges,
    [&](vtkIdType i)
    {
      const Id e = static_cast<Id>(i);
      decomposition.EdgeDimensions[i] = this->Around.EdgeDimensions(e);
      decomposition.EdgeBoundary[i] = this->EdgePlaces[i] == Place::Boundary ||
        this->Around.PlaceEdge(e, 2) == Place::Boundary;
    });
  ForEach(vertices,
    [&](vtkIdType i)
    {
      const Id v = static_cast<Id>(i);
      decomposition.VertexDimensions[i] = this->Around.VertexDimensions(v);
      bool boundary = false;
      for (int k = 1; k <= 3; ++k)
      {
        boundary =
          boundary || this->Around.PlaceVertex(v, k, this->EdgePlaces) == Place::Boundary;
      }
      decomposition.VertexBoundary[i] = boundary;
    });
}

}

template <typename Id>
Strata<Id> BuildStrata(const SimplicialComplex<Id>& complex, const SingularSimplices& singular,
  const StrataOptions& options, Decomposition<Id>* decomposition)
{
  StrataBuilder<Id> builder(complex, singular, options);
  Strata<Id> strata = builder.Build();
  if (decomposition)
  {
    builder.Describe(*decomposition);
  }
  return strata;
}

template Strata<int> BuildStrata(const SimplicialComplex<int>&, const SingularSimplices&,
  const StrataOptions&, Decomposition<int>*);
template Strata<long long> BuildStrata(const SimplicialComplex<long long>&,
  const SingularSimplices&, const StrataOptions&, Decomposition<long long>*);

}
