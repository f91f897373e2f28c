// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeOutput.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

namespace subdivision
{

template <typename Id>
AdaptiveSqrtThreeOutput<Id>::AdaptiveSqrtThreeOutput(AdaptiveSqrtThree<Id>& mesh)
  : Mesh(mesh)
{
  this->NumberVertices();
  this->CountTriangles();
}

/// Numbers vertices level by level, and finds the carriers of faces.
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
  this->Carriers = Buffer<Carrier<Id>>(mesh.GetNumberOfFaces());
  std::vector<Id> faces(mesh.GetNumberOfControlFaces());
  for (const std::size_t f : InTurn(faces.size()))
  {
    faces[f] = static_cast<Id>(f);
    this->Carriers[f] = { faces[f], faces[f] };
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
          this->Carriers[child] = CarryAdaptiveSqrtThree(mesh, corner, this->Carriers);
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

/// The control face whose data the third of a split face at `corner` shows. This triangle of odd
/// generation is in the output while the face across the edge is not split.
template <typename Id>
Id AdaptiveSqrtThreeOutput<Id>::GetSourceOfHalf(Id face, int corner) const
{
  const Carrier<Id>& carrier = this->Carriers[face];
  const bool runsFromCentreToCentre = corner == 1;
  return runsFromCentreToCentre ? carrier.GetSmallest()
                                : PartSqrtThree(carrier, corner, false).First;
}

template <typename Id>
template <typename Value>
void AdaptiveSqrtThreeOutput<Id>::WriteTriangles(
  Value* vertices, unsigned char* generations, vtkIdType* faces) const
{
  const AdaptiveSqrtThree<Id>& mesh = this->Mesh;
  ForEach(mesh.GetNumberOfFaces(),
    [&](vtkIdType f)
    {
      const Id face = static_cast<Id>(f);
      const Id* corners = mesh.GetVertices(face);
      auto write = [&](Id at, Id a, Id b, Id c, int generation, Id source)
      {
        const Id triangle[3] = { a, b, c };
        std::copy(triangle, triangle + 3, vertices + 3 * static_cast<vtkIdType>(at));
        generations[at] = static_cast<unsigned char>(generation);
        faces[at] = source;
      };
      const int generation = 2 * mesh.GetLevel(face);
      if (mesh.IsThere(face) && !mesh.IsSplit(face))
      {
        write(this->Offsets[f], corners[0], corners[1], corners[2], generation,
          this->Carriers[f].GetSmallest());
        return;
      }
      for (int i = 0; i < 3 && mesh.IsSplit(face); ++i)
      {
        const Id corner = 3 * face + i;
        if (!mesh.IsThere(mesh.GetChild(corner)))
        {
          write(this->Offsets[mesh.GetChild(corner)], corners[i], corners[(i + 1) % 3],
            mesh.GetApex(corner), generation + 1, this->GetSourceOfHalf(face, i));
        }
      }
    });
}

template <typename Id>
Buffer<Id> AdaptiveSqrtThreeOutput<Id>::FindFaces() const
{
  const AdaptiveSqrtThree<Id>& mesh = this->Mesh;
  Buffer<Id> faces(this->Triangles);
  ForEachInTurn(mesh.GetNumberOfFaces(),
    [&](vtkIdType f)
    {
      const Id face = static_cast<Id>(f);
      if (mesh.IsThere(face) && !mesh.IsSplit(face))
      {
        faces[this->Offsets[face]] = face;
      }
      for (Id corner = 3 * face; mesh.IsSplit(face) && corner < 3 * face + 3; ++corner)
      {
        const Id child = mesh.GetChild(corner);
        if (!mesh.IsThere(child))
        {
          faces[this->Offsets[child]] = child;
        }
      }
    });
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
template void AdaptiveSqrtThreeOutput<int>::WriteTriangles(int*, unsigned char*, vtkIdType*) const;
template void AdaptiveSqrtThreeOutput<int>::WriteTriangles(
  vtkIdType*, unsigned char*, vtkIdType*) const;
template void AdaptiveSqrtThreeOutput<long long>::WriteTriangles(
  int*, unsigned char*, vtkIdType*) const;
template void AdaptiveSqrtThreeOutput<long long>::WriteTriangles(
  vtkIdType*, unsigned char*, vtkIdType*) const;

}
