// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThree.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

namespace subdivision
{

// ------------------------------------------------------------------------------------------------
// The control mesh

template <typename Id>
AdaptiveSqrtThree<Id>::AdaptiveSqrtThree(const SurfaceLevel<Id>& control)
  : ControlVertices(control.Mesh.NumberOfVertices)
  , ControlFaces(control.Mesh.NumberOfFaces)
  , Cells(control.Mesh.NumberOfFaces + control.Lines.size())
  , Vertices(control.Mesh.Vertices.begin(), control.Mesh.Vertices.end())
  , Twins(control.Mesh.Twins.begin(), control.Mesh.Twins.end())
  , Children(control.Mesh.NumberOfFaces, Id(-1))
  , Levels(control.Mesh.NumberOfFaces, 0)
{
  this->AddSegments(control);
}

template <typename Id>
void AdaptiveSqrtThree<Id>::AddSegments(const SurfaceLevel<Id>& control)
{
  const PolygonMesh<Id>& mesh = control.Mesh;
  const vtkIdType edges = mesh.GetNumberOfEdges();
  this->EdgeSegments.assign(edges, Id(-1));
  auto sheaf = mesh.Sheaves.begin();
  for (const vtkIdType e : InTurn(edges))
  {
    const bool isSheaf = sheaf != mesh.Sheaves.end() && sheaf->Edge == e;
    if (IsSharp(control.Tags.Edges[e]))
    {
      this->EdgeSegments[e] = static_cast<Id>(this->Segments.size());
      Segment segment;
      std::copy_n(mesh.EdgeVertices.data() + 2 * e, 2, segment.Ends);
      segment.FirstSide = static_cast<Id>(this->Sides.size());
      const Id corner = mesh.EdgeCorners[e];
      if (isSheaf)
      {
        this->Sides.insert(this->Sides.end(), sheaf->Corners.begin(), sheaf->Corners.end());
      }
      else if (corner >= 0)
      {
        this->Sides.push_back(corner);
        if (mesh.Twins[corner] >= 0)
        {
          this->Sides.push_back(mesh.Twins[corner]);
        }
      }
      segment.NumberOfSides = static_cast<Id>(this->Sides.size()) - segment.FirstSide;
      this->SideSegments.resize(this->Sides.size(), this->EdgeSegments[e]);
      this->Segments.push_back(segment);
    }
    sheaf += isSheaf ? 1 : 0;
  }
  for (std::size_t side = 0; side < this->Sides.size(); ++side)
  {
    this->Twins[this->Sides[side]] = static_cast<Id>(-2 - static_cast<vtkIdType>(side));
  }
  for (const Id line : InTurn(control.Lines))
  {
    ++this->Segments[this->EdgeSegments[line / 2]].NumberOfLines;
  }
}

// ------------------------------------------------------------------------------------------------
// Where children are: as in SqrtThreeTopology.h

template <typename Id>
bool AdaptiveSqrtThree<Id>::IsBefore(Id face, Id other) const
{
  while (face >= this->ControlFaces && this->GetParent(face) != this->GetParent(other))
  {
    face = this->GetParent(face);
    other = this->GetParent(other);
  }
  return other > face; // control faces, or children of one face
}

template <typename Id>
Id AdaptiveSqrtThree<Id>::GetThirdAcross(Id corner, bool& isSecond) const
{
  const Id cut = corner - corner % 3; // the edge that is cut
  const Id segment = this->GetSegment(cut);
  const Id near = this->Vertices[corner % 3 == 1 ? corner : cut];
  isSecond = this->Segments[segment].Ends[0] != near;
  return segment;
}

template <typename Id>
Id AdaptiveSqrtThree<Id>::GetApex(Id corner) const
{
  const Id face = corner / 3;
  const Id centre = this->Centres[this->GetTriple(this->Children[face])];
  if (centre >= 0)
  {
    return centre;
  }
  bool isSecond = false;
  const Id segment = this->GetThirdAcross(corner, isSecond);
  return this->Segments[segment].Thirds + (isSecond ? 1 : 0);
}

/// The half-edge of the next level between the apex and the beginning of a corner's edge, in the
/// child across that edge. It belongs to a vacant number if this child does not exist.
template <typename Id>
Id AdaptiveSqrtThree<Id>::GetSideAtBegin(Id corner) const
{
  const Id twin = this->Twins[corner];
  const bool isSecond = twin >= 0 && this->IsSplit(twin / 3) && this->RunsWith(corner, twin) &&
    this->IsBefore(twin / 3, corner / 3);
  return isSecond ? this->GetBase(twin) : this->GetBase(corner) + 2;
}

template <typename Id>
Id AdaptiveSqrtThree<Id>::GetSideAtEnd(Id corner) const
{
  const Id twin = this->Twins[corner];
  if (twin < 0 || !this->IsSplit(twin / 3))
  {
    return this->GetBase(corner) + 1;
  }
  if (!this->RunsWith(corner, twin))
  {
    return this->GetBase(twin);
  }
  const bool isFirst = this->IsBefore(corner / 3, twin / 3);
  return isFirst ? this->GetBase(twin) + 2 : this->GetBase(corner);
}

/// An edge of a child may lack its twin only if it lies inside one of the faces that the child was
/// made of. The twin belongs to the child across the other edge of this face at the same old
/// vertex.
template <typename Id>
Id AdaptiveSqrtThree<Id>::FindMissing(Id corner) const
{
  const Id face = corner / 3;
  const Id across = 3 * this->GetParent(face) + (face - static_cast<Id>(this->ControlFaces)) % 3;
  const Id twin = this->Twins[across];
  if (twin < 0)
  {
    return corner % 3 == 1 ? Next(across) : Previous(across);
  }
  const Id vertex = this->Vertices[3 * face];
  const bool isSecond = this->RunsWith(across, twin) && this->IsBefore(twin / 3, across / 3);
  const Id edge = (corner % 3 == 0) == isSecond ? across : twin;
  return this->Vertices[edge] == vertex ? Previous(edge) : Next(edge);
}

// ------------------------------------------------------------------------------------------------
// Faces that have to be split before

template <typename Id>
void AdaptiveSqrtThree<Id>::PushMissing(Id face, std::vector<Id>& stack) const
{
  for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
  {
    if (this->Twins[corner] == -1)
    {
      stack.push_back(this->Twins[this->FindMissing(corner)] / 3);
    }
  }
}

/// The missing face lies at an end of the parent segment. One of its two parents was cut there; the
/// other one lies across an edge of that parent and must be split.
template <typename Id>
Id AdaptiveSqrtThree<Id>::FindMissingSide(const Segment& segment, Id i) const
{
  const Segment& parent = this->Segments[segment.Parent];
  const Id cut = 3 * this->GetChild(this->Sides[parent.FirstSide + i]);
  const bool isFirst = &segment == &this->Segments[parent.Children];
  const bool atBegin = this->Vertices[cut] == parent.Ends[isFirst ? 0 : 1];
  return this->Twins[atBegin ? Previous(cut) : Next(cut)] / 3;
}

template <typename Id>
void AdaptiveSqrtThree<Id>::PushMissingSides(const Segment& segment, std::vector<Id>& stack) const
{
  for (Id i = 0; i < segment.NumberOfSides; ++i)
  {
    const Id side = this->Sides[segment.FirstSide + i];
    if (side < 0)
    {
      stack.push_back(this->FindMissingSide(segment, i));
    }
    else if (!this->IsSplit(side / 3))
    {
      stack.push_back(side / 3);
    }
    else
    {
      this->PushMissing(this->GetChild(side), stack);
    }
  }
}

template <typename Id>
bool AdaptiveSqrtThree<Id>::Split(Id face, vtkIdType mostCells)
{
  std::vector<Id> stack{ face };
  while (!stack.empty())
  {
    const Id at = stack.back();
    if (this->IsSplit(at))
    {
      stack.pop_back();
      continue;
    }
    const std::size_t before = stack.size();
    vtkIdType more = 2;
    if (this->IsCut(at))
    {
      const Segment& segment = this->Segments[this->GetSegment(3 * at)];
      this->PushMissingSides(segment, stack);
      more = 2 * (vtkIdType(segment.NumberOfSides) + segment.NumberOfLines);
    }
    else
    {
      this->PushMissing(at, stack);
    }
    if (stack.size() > before)
    {
      continue;
    }
    if (this->Cells + more > mostCells)
    {
      return false;
    }
    stack.pop_back();
    if (this->IsCut(at))
    {
      this->CutSides(this->GetSegment(3 * at));
    }
    else
    {
      this->SplitAtCentre(at);
    }
  }
  return true;
}

template <typename Id>
bool AdaptiveSqrtThree<Id>::Cut(Id segment, vtkIdType mostCells)
{
  if (this->Segments[segment].Thirds >= 0)
  {
    return true;
  }
  if (this->Cells + 2 * vtkIdType(this->Segments[segment].NumberOfLines) > mostCells)
  {
    return false;
  }
  this->CutSides(segment);
  return true;
}

// ------------------------------------------------------------------------------------------------
// Splits

template <typename Id>
void AdaptiveSqrtThree<Id>::MakeTriple(Id face, Id centre)
{
  const std::size_t size = this->Levels.size() + 3;
  this->Children[face] = static_cast<Id>(size - 3);
  this->Parents.push_back(face);
  this->Centres.push_back(centre);
  this->Vertices.resize(3 * size, Id(-1));
  this->Twins.resize(3 * size, Id(-1));
  this->Children.resize(size, Id(-1));
  this->Levels.resize(size, static_cast<unsigned char>(this->Levels[face] + 1));
  this->Cells += 2;
}

template <typename Id>
void AdaptiveSqrtThree<Id>::MakeChild(Id corner, Id a, Id b, Id c)
{
  const Id child = this->GetChild(corner);
  Id* vertices = this->Vertices.data() + 3 * vtkIdType(child);
  vertices[0] = a;
  vertices[1] = b;
  vertices[2] = c;
  this->NewFaces.push_back(child);
}

template <typename Id>
void AdaptiveSqrtThree<Id>::SplitAtCentre(Id face)
{
  const Id centre = static_cast<Id>(this->GetNumberOfVertices());
  this->Added.push_back({ face, static_cast<unsigned char>(this->Levels[face] + 1), false });
  this->MakeTriple(face, centre);
  this->MakeChildren(face);
}

template <typename Id>
void AdaptiveSqrtThree<Id>::CutSides(Id segment)
{
  const Segment parent = this->Segments[segment];
  const unsigned char level = static_cast<unsigned char>(parent.Level + 2);
  const Id thirds = static_cast<Id>(this->GetNumberOfVertices());
  this->Added.push_back({ -1 - segment, level, false });
  this->Added.push_back({ -1 - segment, level, true });
  this->Segments[segment].Thirds = thirds;
  this->Segments[segment].Children = static_cast<Id>(this->Segments.size());
  this->Cells += 2 * vtkIdType(parent.NumberOfLines);
  const Id ends[3][2] = { { parent.Ends[0], thirds }, { thirds + 1, parent.Ends[1] },
    { thirds, thirds + 1 } };
  for (const auto& piece : ends)
  {
    Segment child = parent;
    std::copy_n(piece, 2, child.Ends);
    child.FirstSide = static_cast<Id>(this->Sides.size());
    child.Parent = segment;
    child.Level = level;
    this->Sides.resize(this->Sides.size() + child.NumberOfSides, Id(-1));
    this->SideSegments.resize(this->Sides.size(), static_cast<Id>(this->Segments.size()));
    this->Segments.push_back(child);
  }
  std::vector<Id> faces;
  for (Id i = 0; i < parent.NumberOfSides; ++i)
  {
    faces.push_back(this->GetChild(this->Sides[parent.FirstSide + i]));
    this->MakeTriple(faces.back(), -1);
  }
  for (Id face : faces)
  {
    this->MakeChildren(face);
  }
}

/// Children across fixed edges, and between the face and its neighbours that are split.
template <typename Id>
void AdaptiveSqrtThree<Id>::MakeChildren(Id face)
{
  const bool isCut = this->IsCut(face);
  for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
  {
    const Id a = this->Vertices[corner];
    const Id b = this->Vertices[Next(corner)];
    const Id twin = this->Twins[corner];
    if (this->IsFixed(corner))
    {
      const Id side = -2 - twin;
      const Id base = this->GetBase(corner);
      if (isCut)
      {
        const Segment& segment = this->Segments[this->SideSegments[side]];
        const bool turned = segment.Ends[0] != a;
        this->MakeChild(corner, segment.Thirds + (turned ? 1 : 0),
          segment.Thirds + (turned ? 0 : 1), this->Vertices[Previous(corner)]);
        this->SetOuterSide(base, segment.Children + 2, side - segment.FirstSide);
      }
      else
      {
        this->MakeChild(corner, a, b, this->GetApex(corner));
        this->Twins[base] = twin;
      }
      continue;
    }
    if (twin < 0 || !this->IsSplit(twin / 3) || !this->IsVacant(this->GetBase(corner)))
    {
      continue;
    }
    const Id own = this->GetApex(corner);
    const Id other = this->GetApex(twin);
    if (!this->RunsWith(corner, twin))
    {
      this->MakeChild(corner, a, other, own);
      this->MakeChild(twin, b, own, other);
    }
    else if (this->IsBefore(face, twin / 3))
    {
      this->MakeChild(corner, a, other, own);
      this->MakeChild(twin, b, other, own);
    }
    else
    {
      this->MakeChild(corner, b, own, other);
      this->MakeChild(twin, a, own, other);
    }
    this->Join(this->GetBase(corner) + 1, this->GetBase(twin) + 1);
    this->JoinInside(twin / 3);
  }
  this->JoinInside(face);
}

template <typename Id>
void AdaptiveSqrtThree<Id>::Join(Id a, Id b)
{
  if (!this->IsVacant(a) && !this->IsVacant(b))
  {
    this->Twins[a] = b;
    this->Twins[b] = a;
  }
}

/// Joins a half-edge of a child and a segment, of which it becomes side `index`.
template <typename Id>
void AdaptiveSqrtThree<Id>::SetOuterSide(Id corner, Id segment, Id index)
{
  if (!this->IsVacant(corner))
  {
    const Id side = this->Segments[segment].FirstSide + index;
    this->Twins[corner] = -2 - side;
    this->Sides[side] = corner;
  }
}

/// Edges between children inside a face that is split, as far as they are there.
template <typename Id>
void AdaptiveSqrtThree<Id>::JoinInside(Id face)
{
  const Id cut = 3 * face;
  if (!this->IsCut(face))
  {
    for (Id corner = cut; corner < cut + 3; ++corner)
    {
      this->Join(this->GetSideAtBegin(corner), this->GetSideAtEnd(Previous(corner)));
    }
    return;
  }
  this->Join(this->GetBase(cut) + 2, this->GetSideAtBegin(Previous(cut)));
  this->Join(this->GetBase(cut) + 1, this->GetSideAtEnd(Next(cut)));
  const Segment& segment = this->Segments[this->GetSegment(cut)];
  const Id index = -2 - this->Twins[cut] - segment.FirstSide;
  const bool turned = segment.Ends[0] != this->Vertices[cut];
  this->SetOuterSide(this->GetSideAtEnd(Previous(cut)), segment.Children + (turned ? 1 : 0), index);
  this->SetOuterSide(this->GetSideAtBegin(Next(cut)), segment.Children + (turned ? 0 : 1), index);
}

template <typename Id>
void AdaptiveSqrtThree<Id>::Renumber(const Buffer<Id>& numbers)
{
  ForEach(static_cast<vtkIdType>(this->Vertices.size()),
    [&](vtkIdType c)
    {
      Id& vertex = this->Vertices[c];
      vertex = vertex < 0 ? vertex : numbers[vertex];
    });
  for (Id& centre : InTurn(this->Centres))
  {
    centre = centre < 0 ? centre : numbers[centre];
  }
  for (Segment& segment : InTurn(this->Segments))
  {
    segment.Ends[0] = numbers[segment.Ends[0]];
    segment.Ends[1] = numbers[segment.Ends[1]];
    segment.Thirds = segment.Thirds < 0 ? segment.Thirds : numbers[segment.Thirds];
  }
  std::vector<Vertex> added(this->Added.size());
  for (const std::size_t i : InTurn(added.size()))
  {
    added[numbers[this->ControlVertices + i] - this->ControlVertices] = this->Added[i];
  }
  this->Added = std::move(added);
}

SUBDIVISION_COMPILE(class AdaptiveSqrtThree);

}
