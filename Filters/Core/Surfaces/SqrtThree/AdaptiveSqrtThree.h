// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSqrtThree.h
 * The sqrt(3) split where it is asked for, and only there (Mathematics 11; Kobbelt, section 4): a
 * part of the uniform hierarchy.
 *
 * A face of level k is one of the uniform mesh after k steps. The paper's index of it is 2k; the
 * three parts of a face that is split, as long as the face across their edge is not, are triangles
 * of index 2k + 1, which are no faces here. A face of level k + 1 comes into being when the two
 * faces of level k between which it lies are both split, or at once at a fixed edge
 * (SqrtThreeTopology.h says where each child is). So what there is follows from the set of faces
 * that are split, and the recursion of the paper is the closure of this set:
 *  - before a face is split, its neighbours across edges that are not fixed have to be there (the
 *    rule for smoothing: older odd neighbours first);
 *  - before a face of an odd level with a fixed edge is cut, those on the other sides of this edge
 *    have to be there, too, and all of them are cut at once.
 * The set does not depend on the order in which splits are asked for.
 */
#ifndef SubdivisionObjects_AdaptiveSqrtThree_h
#define SubdivisionObjects_AdaptiveSqrtThree_h

#include "Core/Surfaces/SqrtThree/SqrtThreeTopology.h"

#include <limits>
#include <vector>

namespace subdivision
{

template <typename Id>
class AdaptiveSqrtThree
{
public:
  /// `control`: triangles, with the tags of FixEdges; it is at an even level.
  explicit AdaptiveSqrtThree(const SurfaceLevel<Id>& control);

  /// A piece of a fixed edge, on an even level.
  struct Segment
  {
    Id Ends[2];
    Id Thirds = -1;   ///< the first of the two points that cut it; -1: it is whole
    Id Children = -1; ///< the first of three: at Ends[0], at Ends[1], between
    Id FirstSide = 0; ///< its faces on even levels: Sides
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

  // Corners are 3 face + i. Faces come in threes, the places of the children of a face: one across
  // each of its edges. A place may be vacant.
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
  /// The other corner on an edge; -1: it is not there yet; less: the edge is fixed.
  Id GetTwin(Id corner) const { return this->Twins[corner]; }
  bool IsFixed(Id corner) const { return this->Twins[corner] < -1; }
  Id GetSegment(Id corner) const { return this->SideSegments[-2 - this->Twins[corner]]; }
  /// Whether a split cuts the first edge of a face instead of making a centre.
  bool IsCut(Id face) const { return this->Levels[face] % 2 == 1 && this->IsFixed(3 * face); }
  /// The segment and which of its points stands, in a face that is cut, across an edge that is not.
  Id GetThirdAcross(Id corner, bool& isSecond) const;
  /// The point across an edge in a face that is split.
  Id GetApex(Id corner) const;
  /// The corner on the parents' level across whose edge lies the face that has to be split for the
  /// twin of a corner to be there.
  Id FindMissing(Id corner) const;

  static Id Next(Id corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static Id Previous(Id corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

  vtkIdType GetNumberOfSegments() const { return static_cast<vtkIdType>(this->Segments.size()); }
  const Segment& GetSegmentAt(Id segment) const { return this->Segments[segment]; }
  /// The i-th face on a segment, on its level, as a corner; -1: it is not there yet.
  /// FindMissingSide: the face that has to be split for it.
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
  /// Of those that were added.
  const Vertex& GetAdded(Id vertex) const { return this->Added[vertex - this->ControlVertices]; }
  /// Triangles, those of odd index too, and pieces of line cells.
  vtkIdType GetNumberOfCells() const { return this->Cells; }

  /// Splits a face, or cuts a segment without faces, and before this what has to be. False: there
  /// would be more than `mostCells`, so only a part of that was done.
  bool Split(Id face, vtkIdType mostCells = std::numeric_limits<vtkIdType>::max());
  bool Cut(Id segment, vtkIdType mostCells = std::numeric_limits<vtkIdType>::max());

  /// Faces in the order in which they came into being, without those of the control mesh.
  const std::vector<Id>& GetNewFaces() const { return this->NewFaces; }

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
  std::vector<Id> Twins;    ///< of corners; less than -1: -2 - side
  std::vector<Id> Children; ///< of faces: the first
  std::vector<unsigned char> Levels;
  std::vector<Id> Parents; ///< of triples
  std::vector<Id> Centres; ///< of triples: the vertex; -1: the face was cut
  std::vector<Segment> Segments;
  std::vector<Id> EdgeSegments; ///< of control edges
  std::vector<Id> Sides;        ///< corners on even levels; -1: not there yet
  std::vector<Id> SideSegments;
  std::vector<Vertex> Added;
  std::vector<Id> NewFaces;
};

/// Where the child across an edge lies, from where the faces of its level do.
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

}

#endif
