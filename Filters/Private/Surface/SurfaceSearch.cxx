// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceSearch.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Places/QuadParts.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
SurfaceSearch<Id>::SurfaceSearch(
  const SurfaceCells& cells, const SurfaceLevel<Id>& level, bool needsTriangles)
  : Cells(cells)
  , Level(level)
  , HasQuads(!needsTriangles)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  for (const vtkIdType f : InTurn(mesh.NumberOfFaces))
  {
    this->IsSplit = this->IsSplit || mesh.GetSize(static_cast<Id>(f)) != (needsTriangles ? 3 : 4);
  }
  const auto middle = [&](Id edge) { return static_cast<Id>(mesh.NumberOfVertices + edge); };
  for (const std::size_t i : InTurn(cells.Vertices.size()))
  {
    this->AddCell(0, { static_cast<vtkIdType>(i), -1 }, { static_cast<Id>(cells.Vertices[i]) });
  }
  for (const vtkIdType i : InTurn(level.Lines.size()))
  {
    const Id edge = level.Lines[i] / 2;
    const Id* ends = mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(edge);
    const int first = level.Lines[i] % 2 == 0 ? 0 : 1;
    if (!this->IsSplit)
    {
      this->AddCell(1, { i, -1 }, { ends[first], ends[1 - first] });
      continue;
    }
    this->AddCell(1, { i, 0 }, { ends[first], middle(edge) });
    this->AddCell(1, { i, 1 }, { middle(edge), ends[1 - first] });
  }
  for (const vtkIdType f : InTurn(mesh.NumberOfFaces))
  {
    const Id first = mesh.GetFirst(static_cast<Id>(f));
    const Id size = mesh.GetSize(static_cast<Id>(f));
    const Id* ids = mesh.Vertices.data() + first;
    if (this->IsSplit)
    {
      const auto centre = static_cast<Id>(mesh.NumberOfVertices + mesh.GetNumberOfEdges() + f);
      for (Id k = 0; k < size; ++k)
      {
        this->AddCell(2, { f, static_cast<int>(k) },
          { ids[k], middle(mesh.Edges[first + k]), centre,
            middle(mesh.Edges[first + (k + size - 1) % size]) });
      }
    }
    else if (this->HasQuads)
    {
      this->AddCell(2, { f, -1 }, { ids[0], ids[1], ids[2], ids[3] });
    }
    else
    {
      this->AddCell(2, { f, -1 }, { ids[0], ids[1], ids[2] });
    }
  }
}

template <typename Id>
void SurfaceSearch<Id>::AddCell(int dimension, const Part& part, std::initializer_list<Id> corners)
{
  this->Dimensions.push_back(static_cast<unsigned char>(dimension));
  this->Connectivity.insert(this->Connectivity.end(), corners.begin(), corners.end());
  this->Parts.push_back(part);
}

template <typename Id>
vtkIdType SurfaceSearch<Id>::FindOwner(const NearestPlace& place) const
{
  const std::vector<vtkIdType>* owners[3] = { &this->Cells.VertexCells, &this->Cells.SegmentCells,
    &this->Cells.FaceCells };
  return (*owners[this->Dimensions[place.Cell]])[this->Parts[place.Cell].Number];
}

template <typename Id>
SurfacePlace<Id> SurfaceSearch<Id>::MakePlace(const NearestPlace& place) const
{
  const Part& part = this->Parts[place.Cell];
  SurfacePlace<Id> made;
  made.Dimension = this->Dimensions[place.Cell];
  made.Part = static_cast<Id>(part.Number);
  if (made.Dimension == 0)
  {
    made.Part = static_cast<Id>(this->Cells.Vertices[part.Number]);
  }
  else if (made.Dimension == 1)
  {
    const Id line = this->Level.Lines[part.Number];
    const bool isTurned = line % 2 != 0;
    const double along = this->GetPlaceOnLine(place);
    const double slope = part.Corner < 0 ? 1. : 0.5;
    made.Part = line / 2;
    made.At[0] = isTurned ? 1. - along : along;
    made.Directions = { { { { isTurned ? -slope : slope, 0. } }, { { 0., 0. } } } };
  }
  else if (!this->HasQuads)
  {
    made.At = { { place.Weights[1], place.Weights[2] } };
  }
  else
  {
    made.At = { { place.Weights[0], place.Weights[1] } };
    if (this->IsSplit && this->Level.Mesh.GetSize(made.Part) == 4)
    {
      LeaveCornerOfQuad(part.Corner, made);
    }
    else if (this->IsSplit)
    {
      made.Corner = part.Corner;
    }
  }
  return made;
}

template <typename Id>
Id SurfaceSearch<Id>::FindNearestVertex(const NearestPlace& place) const
{
  const SurfacePlace<Id> made = this->MakePlace(place);
  const PolygonMesh<Id>& mesh = this->Level.Mesh;
  const auto [x, y] = made.At;
  if (made.Dimension == 0)
  {
    return made.Part;
  }
  if (made.Dimension == 1)
  {
    return mesh.EdgeVertices[2 * static_cast<vtkIdType>(made.Part) + (x > 0.5 ? 1 : 0)];
  }
  int corner = made.Corner;
  if (corner < 0)
  {
    const double first = 1. - x - y;
    corner = this->HasQuads     ? (y <= 0.5 ? (x <= 0.5 ? 0 : 1) : (x <= 0.5 ? 3 : 2))
      : first >= std::max(x, y) ? 0
      : x >= y                  ? 1
                                : 2;
  }
  return mesh.Vertices[mesh.GetFirst(made.Part) + corner];
}

SUBDIVISION_COMPILE(class SurfaceSearch);

}
