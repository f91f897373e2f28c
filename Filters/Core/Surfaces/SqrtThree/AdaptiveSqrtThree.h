// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSqrtThree.h
 * Adaptive sqrt(3) refinement (Mathematics 11; Kobbelt, section 4): splits the wanted faces, and
 * the faces that must be split before. The result is a part of the uniform hierarchy.
 *
 * A face of level k is a face of the uniform mesh after k steps; its *generation*, which the paper
 * calls index, is 2k. If a face is split and the face across one of its edges is not, the third of
 * the split face at this edge is a triangle of generation 2k + 1. Only the output has it, as it is
 * no face here. A face of level k + 1 exists if both faces of level k between which it lies are
 * split; at a fixed edge it exists as soon as its one parent is split (SqrtThreeTopology.h says
 * where children lie). So the mesh follows from the set of split faces. The recursion of the paper
 * is the closure of this set:
 *  - before a face is split, its neighbours across edges that are not fixed must exist (in the
 *    paper, odd neighbours of smaller index are split first);
 *  - before a face of an odd level cuts its fixed edge, the faces on the other sides of this edge
 *    must exist too, and all of them cut it at once.
 * The set does not depend on the order in which splits are asked for.
 */
#ifndef SubdivisionObjects_AdaptiveSqrtThree_h
#define SubdivisionObjects_AdaptiveSqrtThree_h

#include "Core/Memory/Loops.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeTopology.h"

#include <limits>
#include <vector>

namespace subdivision
{

template <typename Id>
class AdaptiveSqrtThree
{
public:
  /// `control` is a level of triangles after an even number of steps, with the tags of FixEdges.
  explicit AdaptiveSqrtThree(const SurfaceLevel<Id>& control);

  /// A fixed edge of an even level: a control edge, or a third of a segment of two levels before.
  struct Segment
  {
    Id Ends[2];
    Id Thirds = -1;   ///< the first of the two points that cut it; -1: it is whole
    Id Children = -1; ///< the first of three: at Ends[0], at Ends[1], between
    Id FirstSide = 0; ///< its half-edges, one for each face at it, start here in Sides
    Id NumberOfSides = 0;
    Id Parent = -1;
    int NumberOfLines = 0; ///< line cells on it
    unsigned char Level = 0;
  };
  struct Vertex
  {
    Id Source;           ///< the face whose centre it is; -1 - segment, which it cuts
    unsigned char Level; ///< on which it came into being
    bool IsSecond;       ///< of the two on a segment
  };

  // Corners are 3 face + i. The three children of a split face, one across each of its edges, have
  // consecutive numbers. Numbers whose child does not exist yet are vacant.
  vtkIdType GetNumberOfFaces() const { return static_cast<vtkIdType>(this->Levels.size()); }
  bool IsThere(Id face) const { return this->Vertices[3 * static_cast<vtkIdType>(face)] >= 0; }
  bool IsSplit(Id face) const { return this->Children[face] >= 0; }
  Id GetChild(Id corner) const { return this->Children[corner / 3] + corner % 3; }
  Id GetParent(Id face) const { return this->Parents[this->GetTriple(face)]; }
  /// The control face from which a face has its orientation.
  Id GetControlFace(Id face) const
  {
    while (face >= this->ControlFaces)
    {
      face = this->GetParent(face);
    }
    return face;
  }
  int GetLevel(Id face) const { return this->Levels[face]; }
  const Id* GetVertices(Id face) const { return this->Vertices.data() + 3 * vtkIdType(face); }
  Id GetVertex(Id corner) const { return this->Vertices[corner]; }
  /// The other half-edge on the edge of a corner; -1: its face does not exist yet; less: the edge
  /// is fixed.
  Id GetTwin(Id corner) const { return this->Twins[corner]; }
  bool IsFixed(Id corner) const { return this->Twins[corner] < -1; }
  Id GetSegment(Id corner) const { return this->SideSegments[-2 - this->Twins[corner]]; }
  /// Whether the split of a face cuts its first edge, which is fixed, instead of making a centre.
  bool IsCut(Id face) const { return this->Levels[face] % 2 == 1 && this->IsFixed(3 * face); }
  /// The apex of a cut face across the edge of a corner, as a segment and whether it is the second
  /// point on it.
  Id GetThirdAcross(Id corner, bool& isSecond) const;
  /// The apex of a split face across the edge of a corner (SqrtThreeTopology.h).
  Id GetApex(Id corner) const;
  /// For a corner whose twin does not exist yet, the half-edge on the parents' level across which
  /// lies the face that must be split for it.
  Id FindMissing(Id corner) const;

  static Id Next(Id corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Id Previous(Id corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

  vtkIdType GetNumberOfSegments() const { return static_cast<vtkIdType>(this->Segments.size()); }
  const Segment& GetSegmentAt(Id segment) const { return this->Segments[segment]; }
  /// The half-edge of the i-th face at a segment, on the segment's level; -1: this face does not
  /// exist yet. FindMissingSide then returns the face that must be split for it.
  Id GetSide(const Segment& segment, Id i) const { return this->Sides[segment.FirstSide + i]; }
  Id FindMissingSide(const Segment& segment, Id i) const;
  /// Of a control edge; -1: it is not fixed.
  Id GetSegmentOfEdge(Id edge) const { return this->EdgeSegments[edge]; }

  vtkIdType GetNumberOfControlVertices() const { return this->ControlVertices; }
  vtkIdType GetNumberOfControlFaces() const { return this->ControlFaces; }
  vtkIdType GetNumberOfVertices() const
  {
    return this->ControlVertices + static_cast<vtkIdType>(this->Added.size());
  }
  /// The record of a vertex that was added.
  const Vertex& GetAdded(Id vertex) const { return this->Added[vertex - this->ControlVertices]; }
  /// The first one, by an order, of the vertices between which a vertex was added.
  template <typename Less>
  Id FindFirstParent(Id vertex, const Less& less) const
  {
    const Id source = this->GetAdded(vertex).Source;
    const Id* parents = source >= 0 ? this->GetVertices(source) : this->Segments[-1 - source].Ends;
    return *std::min_element(parents, parents + (source >= 0 ? 3 : 2), less);
  }
  /// The number of triangles, also of odd generation, and of pieces of line cells.
  vtkIdType GetNumberOfCells() const { return this->Cells; }

  /// Splits a face, and before it all faces that must be split first; Cut cuts a segment without
  /// faces. They return false if there would be more than `mostCells` cells; then they have stopped
  /// halfway.
  bool Split(Id face, vtkIdType mostCells = std::numeric_limits<vtkIdType>::max());
  bool Cut(Id segment, vtkIdType mostCells = std::numeric_limits<vtkIdType>::max());

  /// All faces but the control faces, in the order in which they were made.
  const std::vector<Id>& GetNewFaces() const { return this->NewFaces; }

  /// The faces that were split, in the order of splits. Faces that cut one segment come together.
  vtkIdType GetNumberOfSplits() const { return static_cast<vtkIdType>(this->Parents.size()); }
  Id GetSplit(vtkIdType i) const { return this->Parents[i]; }

  /// Whether a face comes before another of the same level in the order of the uniform mesh.
  bool IsBefore(Id face, Id other) const;
  /// Whether the child across an edge has its apexes exchanged (SqrtThreeTopology.h).
  bool IsExchanged(Id corner) const
  {
    const Id twin = this->Twins[corner];
    return twin >= 0 && this->RunsWith(corner, twin) && this->IsBefore(twin / 3, corner / 3);
  }

  /// Gives the added vertices new numbers: vertex v becomes numbers[v].
  void Renumber(const Buffer<Id>& numbers);

private:
  Id GetTriple(Id face) const { return (face - static_cast<Id>(this->ControlFaces)) / 3; }
  bool IsVacant(Id corner) const { return !this->IsThere(corner / 3); }
  bool RunsWith(Id corner, Id twin) const { return this->Vertices[corner] == this->Vertices[twin]; }
  Id GetBase(Id corner) const { return 3 * this->GetChild(corner); }
  Id GetSideAtBegin(Id corner) const;
  Id GetSideAtEnd(Id corner) const;

  void AddSegments(const SurfaceLevel<Id>& control);
  void PushMissing(Id face, std::vector<Id>& stack) const;
  void PushMissingSides(const Segment& segment, std::vector<Id>& stack) const;
  void SplitAtCentre(Id face);
  void CutSides(Id segment);
  void MakeTriple(Id face, Id centre);
  void MakeChildren(Id face);
  void MakeChild(Id corner, Id a, Id b, Id c);
  void JoinInside(Id face);
  void Join(Id a, Id b);
  void SetOuterSide(Id side, Id segment, Id index);

  vtkIdType ControlVertices;
  vtkIdType ControlFaces;
  vtkIdType Cells;
  std::vector<Id> Vertices; ///< of corners
  std::vector<Id> Twins;    ///< of corners; on a fixed edge -2 - the position in Sides
  std::vector<Id> Children; ///< of faces: the first
  std::vector<unsigned char> Levels;
  std::vector<Id> Parents; ///< of triples
  std::vector<Id> Centres; ///< of triples: the centre of the parent; -1: the parent was cut
  std::vector<Segment> Segments;
  std::vector<Id> EdgeSegments; ///< of control edges
  std::vector<Id> Sides;        ///< of segments: half-edges on even levels; -1: does not exist yet
  std::vector<Id> SideSegments;
  std::vector<Vertex> Added;
  std::vector<Id> NewFaces;
};

/// The carrier of the child across the edge of a corner, from the carriers of the faces at the
/// edge.
template <typename Id, typename Carriers>
Carrier<Id> CarryAdaptiveSqrtThree(
  const AdaptiveSqrtThree<Id>& mesh, Id corner, const Carriers& carriers)
{
  const Id face = corner / 3;
  const Id twin = mesh.GetTwin(corner);
  const bool isExchanged = mesh.IsExchanged(corner);
  return mesh.GetLevel(face) % 2 == 1
    ? PartSqrtThree(carriers[face], corner % 3, isExchanged)
    : JoinSqrtThree(carriers[face], carriers[twin < 0 ? face : twin / 3], isExchanged);
}

/// The carriers of the faces of a mesh that grows.
template <typename Id>
class AdaptiveSqrtThreeCarriers
{
public:
  explicit AdaptiveSqrtThreeCarriers(const AdaptiveSqrtThree<Id>& mesh)
    : Mesh(mesh)
  {
  }
  const Carrier<Id>& operator[](Id face) const { return this->Carriers[face]; }

  /// Forgets them: the mesh is another one.
  void Restart()
  {
    this->Carriers.clear();
    this->Known = 0;
  }
  /// Continues to the faces that there are by now.
  void Continue()
  {
    const AdaptiveSqrtThree<Id>& mesh = this->Mesh;
    for (auto f = static_cast<Id>(this->Carriers.size()); f < mesh.GetNumberOfControlFaces(); ++f)
    {
      this->Carriers.push_back({ f, f });
    }
    this->Carriers.resize(mesh.GetNumberOfFaces());
    const std::vector<Id>& made = mesh.GetNewFaces();
    Turns turns;
    for (; this->Known < made.size(); ++this->Known)
    {
      turns.Next();
      const Id face = made[this->Known];
      const Id parent = mesh.GetParent(face);
      const Id corner = 3 * parent + (face - mesh.GetChild(3 * parent));
      this->Carriers[face] = CarryAdaptiveSqrtThree(mesh, corner, this->Carriers);
    }
  }

private:
  const AdaptiveSqrtThree<Id>& Mesh;
  std::vector<Carrier<Id>> Carriers;
  std::size_t Known = 0; ///< how many of the new faces have theirs
};

}

#endif
