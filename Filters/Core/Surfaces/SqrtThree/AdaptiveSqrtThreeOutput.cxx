// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeOutput.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

namespace subdivision
{

template <typename Id>
AdaptiveSqrtThreeOutput<Id>::AdaptiveSqrtThreeOutput(AdaptiveSqrtThree<Id>& mesh)
  : Mesh(mesh)
  , Carriers(mesh)
{
  this->Carriers.Continue();
  this->NumberVertices();
  this->CountTriangles();
}

/// Numbers vertices level by level.
template <typename Id>
void AdaptiveSqrtThreeOutput<Id>::NumberVertices()
{
  AdaptiveSqrtThree<Id>& mesh = this->Mesh;
  const Id given = static_cast<Id>(mesh.GetNumberOfControlVertices());
  Buffer<Id> numbers(mesh.GetNumberOfVertices());
  for (const Id v : InTurn(given))
  {
    numbers[v] = v;
  }
  this->VertexLevels = { 0, given };
  std::vector<Id> faces(mesh.GetNumberOfControlFaces());
  for (const std::size_t f : InTurn(faces.size()))
  {
    faces[f] = static_cast<Id>(f);
  }
  std::vector<Id> segments;
  for (const vtkIdType s : InTurn(mesh.GetNumberOfSegments()))
  {
    if (mesh.GetSegmentAt(static_cast<Id>(s)).Parent < 0)
    {
      segments.push_back(static_cast<Id>(s));
    }
  }
  Id next = given;
  for (int level = 0; !faces.empty() || !segments.empty(); ++level)
  {
    std::vector<Id> children;
    Turns turns;
    for (const Id face : faces)
    {
      turns.Next();
      if (!mesh.IsSplit(face))
      {
        continue;
      }
      if (!mesh.IsCut(face))
      {
        numbers[mesh.GetApex(3 * face)] = next++;
      }
      for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
      {
        const Id child = mesh.GetChild(corner);
        if (mesh.IsThere(child))
        {
          children.push_back(child);
        }
      }
    }
    if (level % 2 == 1)
    {
      this->NumberThirds(segments, numbers, next);
    }
    faces = std::move(children);
    if (next > this->VertexLevels.back())
    {
      this->VertexLevels.push_back(next);
    }
  }
  mesh.Renumber(numbers);
}

/// Numbers the points that cut the segments of a level, and replaces the segments by their
/// children.
template <typename Id>
void AdaptiveSqrtThreeOutput<Id>::NumberThirds(
  std::vector<Id>& segments, Buffer<Id>& numbers, Id& next) const
{
  std::vector<Id> children;
  std::vector<Id> outer;
  for (const Id segment : InTurn(segments))
  {
    const auto& piece = this->Mesh.GetSegmentAt(segment);
    if (piece.Thirds >= 0)
    {
      numbers[piece.Thirds] = next++;
      numbers[piece.Thirds + 1] = next++;
      children.push_back(piece.Children + 2);
      outer.insert(outer.end(), { piece.Children, piece.Children + 1 });
    }
  }
  children.insert(children.end(), outer.begin(), outer.end());
  segments = std::move(children);
}

/// Children have larger numbers than their parent. So counting goes from the last face to the
/// first, and offsets go from the first to the last.
template <typename Id>
void AdaptiveSqrtThreeOutput<Id>::CountTriangles()
{
  const AdaptiveSqrtThree<Id>& mesh = this->Mesh;
  const vtkIdType size = mesh.GetNumberOfFaces();
  this->Counts = Buffer<Id>(size);
  this->Offsets = Buffer<Id>(size);
  ForEachInTurn(size,
    [&](vtkIdType fromLast)
    {
      const Id face = static_cast<Id>(size - 1 - fromLast);
      this->Counts[face] = 1;
      if (mesh.IsSplit(face))
      {
        const Id child = mesh.GetChild(3 * face);
        this->Counts[face] =
          this->Counts[child] + this->Counts[child + 1] + this->Counts[child + 2];
      }
    });
  Id next = 0;
  ForEachInTurn(size,
    [&](vtkIdType f)
    {
      const Id face = static_cast<Id>(f);
      if (f < mesh.GetNumberOfControlFaces())
      {
        this->Offsets[f] = next;
        next += this->Counts[f];
      }
      if (mesh.IsSplit(face))
      {
        const Id child = mesh.GetChild(3 * face);
        this->Offsets[child] = this->Offsets[f];
        this->Offsets[child + 1] = this->Offsets[child] + this->Counts[child];
        this->Offsets[child + 2] = this->Offsets[child + 1] + this->Counts[child + 1];
      }
    });
  this->Triangles = next;
}

/// Calls act(triangle, face, corner) for each triangle: of a face that is not split, with corner
/// -1, or of odd generation, which is in the output while the face across that corner's edge is not
/// split.
template <typename Id>
template <typename Act>
void AdaptiveSqrtThreeOutput<Id>::ForTriangles(const Act& act) const
{
  const AdaptiveSqrtThree<Id>& mesh = this->Mesh;
  ForEach(mesh.GetNumberOfFaces(),
    [&](vtkIdType f)
    {
      const Id face = static_cast<Id>(f);
      if (mesh.IsThere(face) && !mesh.IsSplit(face))
      {
        act(this->Offsets[face], face, Id(-1));
      }
      for (Id corner = 3 * face; mesh.IsSplit(face) && corner < 3 * face + 3; ++corner)
      {
        if (!mesh.IsThere(mesh.GetChild(corner)))
        {
          act(this->Offsets[mesh.GetChild(corner)], face, corner);
        }
      }
    });
}

template <typename Id>
void AdaptiveSqrtThreeOutput<Id>::WriteTriangles(
  Id* vertices, unsigned char* generations, vtkIdType* faces) const
{
  const AdaptiveSqrtThree<Id>& mesh = this->Mesh;
  this->ForTriangles(
    [&](Id at, Id face, Id corner)
    {
      const bool isWhole = corner < 0;
      Id* to = vertices + 3 * static_cast<vtkIdType>(at);
      std::copy_n(mesh.GetVertices(face), isWhole ? 3 : 0, to);
      if (!isWhole)
      {
        to[0] = mesh.GetVertex(corner);
        to[1] = mesh.GetVertex(mesh.Next(corner));
        to[2] = mesh.GetApex(corner);
      }
      // The second third of a face runs from centre to centre.
      const Carrier<Id>& carrier = this->Carriers[face];
      generations[at] = static_cast<unsigned char>(2 * mesh.GetLevel(face) + (isWhole ? 0 : 1));
      faces[at] = isWhole || corner % 3 == 1
        ? carrier.GetSmallest()
        : PartSqrtThree(carrier, static_cast<int>(corner % 3), false).First;
    });
}

template <typename Id>
Buffer<Id> AdaptiveSqrtThreeOutput<Id>::FindFaces() const
{
  Buffer<Id> faces(this->Triangles);
  this->ForTriangles([&](Id at, Id face, Id corner)
    { faces[at] = corner < 0 ? face : this->Mesh.GetChild(corner); });
  return faces;
}

template <typename Id>
void AdaptiveSqrtThreeOutput<Id>::AppendPieces(Id line, std::vector<Piece>& pieces) const
{
  const bool against = line % 2 == 1;
  std::vector<Id> stack{ this->Mesh.GetSegmentOfEdge(line / 2) };
  while (!stack.empty())
  {
    const auto& segment = this->Mesh.GetSegmentAt(stack.back());
    stack.pop_back();
    if (segment.Children < 0)
    {
      pieces.push_back(
        { { segment.Ends[against ? 1 : 0], segment.Ends[against ? 0 : 1] }, 2 * segment.Level });
      continue;
    }
    const Id first = segment.Children + (against ? 1 : 0);
    const Id last = segment.Children + (against ? 0 : 1);
    stack.insert(stack.end(), { last, segment.Children + 2, first });
  }
}

SUBDIVISION_COMPILE(class AdaptiveSqrtThreeOutput);

}
