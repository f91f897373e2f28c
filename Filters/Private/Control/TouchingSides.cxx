// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/TouchingSides.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellFaces.h"
#include "Private/Reading/NearPoints.h"
#include "Private/Values/MergedValues.h"

#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

Vector GetPoint(vtkPointSet* mesh, vtkIdType point)
{
  Vector x;
  mesh->GetPoint(point, x.data());
  return x;
}

bool HasSolids(vtkPointSet* mesh)
{
  const CellReader cells(mesh);
  const unsigned char* const types = cells.GetTypes();
  const vtkIdType size = types ? cells.GetNumberOfCells() : 0;
  int known = VTK_EMPTY_CELL; // mostly all cells have one type
  return std::any_of(types, types + size,
    [&known](int type)
    {
      const bool isNew = type != known;
      known = type;
      return isNew && GetDimensionOfType(type) == 3;
    });
}

/// Of each point the first one at its place. Empty if no two have equal coordinates.
Buffer<vtkIdType> FindPlaces(vtkPointSet* mesh)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  Buffer<double> x(3 * size);
  ForEach(size, [&](vtkIdType i) { mesh->GetPoint(i, x.data() + 3 * i); });
  std::vector<vtkIdType> all(static_cast<std::size_t>(size));
  std::iota(all.begin(), all.end(), vtkIdType(0));
  Buffer<vtkIdType> places = FindFirstOfNear(x.data(), all, 0., PointOrder{});
  return std::equal(places.begin(), places.end(), all.begin()) ? Buffer<vtkIdType>()
                                                               : std::move(places);
}

/// An edge of a face: its points, the one with the smaller place first.
struct Edge
{
  std::array<vtkIdType, 2> Places;
  std::array<vtkIdType, 2> Points;
  Vector Inwards; ///< of unit length in the plane of the face; 0 where it has none
};

class Sides
{
public:
  Sides(vtkPointSet* mesh, Buffer<vtkIdType> places)
    : Mesh(mesh)
    , Places(std::move(places))
    , Pieces(mesh->GetNumberOfPoints())
    , Objects(mesh->GetNumberOfPoints())
    , Faces(mesh->GetNumberOfPoints(), 0)
    , IsOpen(mesh->GetNumberOfPoints(), 0)
    , IsLeft(mesh->GetNumberOfPoints(), 0)
  {
  }

  PointPairs FindPairs(bool* isOpen, bool closedOnly)
  {
    this->ForEachFace(
      [&](const vtkIdType* loop, vtkIdType size)
      {
        std::for_each(
          loop, loop + size, [&](vtkIdType point) { this->Pieces.Join(loop[0], point); });
      });
    if (!this->FindMeeting())
    {
      return {};
    }
    this->ForEachEdge(
      [this](const Edge* first, const Edge* last) { this->PairEdges(first, last); });
    return this->TakeObjects(isOpen, closedOnly);
  }

  Buffer<unsigned char> FindCorners()
  {
    this->Meets = Buffer<unsigned char>(this->Places.size(), 1);
    Buffer<int> seams(this->Places.size(), 0); // by place
    Buffer<int> ends(this->Places.size(), 0);  // of edges of faces, by point
    this->ForEachEdge(
      [&](const Edge* first, const Edge* last)
      {
        const bool isSeam = !IsShared(first, last);
        for (const vtkIdType place : first->Places)
        {
          seams[place] += isSeam ? 1 : 0;
          this->IsOpen[place] |= last - first == 1 ? 1 : 0;
        }
        std::for_each(first, last,
          [&ends](const Edge& edge) { ++ends[edge.Points[0]], ++ends[edge.Points[1]]; });
      });
    Buffer<unsigned char> corners(this->Places.size(), 0);
    for (const vtkIdType i : InTurn(this->Places.size()))
    {
      const vtkIdType place = this->Places[i];
      const bool goesOn = place >= 0 && seams[place] == 2 && !this->IsOpen[place] && ends[i] > 2;
      corners[i] = place >= 0 && seams[place] > 0 && !goesOn ? 1 : 0;
    }
    return corners;
  }

private:
  /// Calls visit(loop, size) for all faces.
  template <typename Visit>
  void ForEachFace(const Visit& visit) const
  {
    const CellReader cells(this->Mesh);
    const CheckedCells checked = CheckCells(this->Mesh, cells);
    CellFaces faces(this->Mesh, cells);
    std::vector<vtkIdType> scratch;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      const bool takesPart = TakesPart(checked.States[static_cast<std::size_t>(c)]);
      if (takesPart && GetDimensionOfType(cells.GetCellType(c)) == 2)
      {
        faces.ForEach(c, cells.GetCell(c, scratch), visit);
      }
    }
  }

  /// Finds the pieces that others touch, also by seams: edges of the others need no look.
  bool FindMeeting()
  {
    bool isAny = false;
    this->Meets = Buffer<unsigned char>(this->Places.size(), 0);
    for (const vtkIdType i : InTurn(this->Places.size()))
    {
      const vtkIdType first = this->Pieces.Find(this->Places[i]);
      const vtkIdType piece = this->Pieces.Find(i);
      if (this->Places[i] != i && (piece != first || this->Mesh->GetPointData()->GetTCoords()))
      {
        this->Meets[piece] = this->Meets[first] = 1;
        isAny = true;
      }
    }
    return isAny;
  }

  void AddFace(const vtkIdType* loop, vtkIdType size)
  {
    const vtkIdType piece = this->Pieces.Find(loop[0]);
    if (!this->Meets[piece])
    {
      return;
    }
    this->Faces[piece] = static_cast<unsigned char>(std::min(this->Faces[piece] + 1, 2));
    Vector normal = {};
    for (vtkIdType i = 0; i < size; ++i)
    {
      const Vector from = this->GetStep(loop[0], loop[i]);
      const Vector to = this->GetStep(loop[0], loop[(i + 1) % size]);
      Vector part;
      vtkMath::Cross(from.data(), to.data(), part.data());
      vtkMath::Add(normal.data(), part.data(), normal.data());
    }
    vtkMath::Normalize(normal.data());
    for (vtkIdType i = 0; i < size; ++i)
    {
      Edge edge = { {}, { loop[i], loop[(i + 1) % size] }, {} };
      const Vector along = this->GetStep(edge.Points[0], edge.Points[1]);
      vtkMath::Cross(normal.data(), along.data(), edge.Inwards.data());
      vtkMath::Normalize(edge.Inwards.data());
      edge.Places = { this->Places[edge.Points[0]], this->Places[edge.Points[1]] };
      if (edge.Places[0] > edge.Places[1])
      {
        std::swap(edge.Places[0], edge.Places[1]);
        std::swap(edge.Points[0], edge.Points[1]);
      }
      this->Edges.push_back(edge);
    }
    this->Ring.assign(loop, loop + size);
    const auto key = [this](vtkIdType point) { return std::pair(this->Places[point], point); };
    std::sort(this->Ring.begin(), this->Ring.end(),
      [&](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < this->Ring.size(); ++i)
    {
      const vtkIdType a = this->Ring[i - 1];
      const vtkIdType b = this->Ring[i];
      this->IsLeft[piece] |= this->Places[a] == this->Places[b] && a != b ? 1 : 0;
    }
  }

  /// Calls visit(first, last) for the edges of faces at each pair of places.
  template <typename Visit>
  void ForEachEdge(const Visit& visit)
  {
    this->ForEachFace([&](const vtkIdType* loop, vtkIdType size) { this->AddFace(loop, size); });
    StableSort(this->Edges, [](const Edge& a, const Edge& b) { return a.Places < b.Places; });
    const Edge* const end = this->Edges.data() + this->Edges.size();
    Turns turns;
    for (const Edge* first = this->Edges.data(); first != end; turns.Next())
    {
      const Edge* last =
        std::find_if(first, end, [&](const Edge& edge) { return edge.Places != first->Places; });
      visit(first, last);
      first = last;
    }
  }

  static bool IsShared(const Edge* first, const Edge* last)
  {
    return std::all_of(first, last, [&](const Edge& edge) { return edge.Points == first->Points; });
  }

  void PairEdges(const Edge* first, const Edge* last)
  {
    const bool isShared = IsShared(first, last);
    if (last - first == 1)
    {
      this->IsOpen[this->GetPiece(*first)] = 1;
    }
    else if (!isShared && last - first == 2 && this->Fit(first[0], first[1]))
    {
      this->Objects.Join(this->GetPiece(first[0]), this->GetPiece(first[1]));
      this->Pairs.emplace_back(first[0].Points[0], first[1].Points[0]);
      this->Pairs.emplace_back(first[0].Points[1], first[1].Points[1]);
    }
    else if (!isShared)
    {
      std::for_each(
        first, last, [this](const Edge& edge) { this->IsLeft[this->GetPiece(edge)] = 1; });
    }
  }

  /// Whether two faces that would share an edge are sides of an object there.
  bool Fit(const Edge& a, const Edge& b)
  {
    constexpr double NearOne = 0.99985; // the cosine of 1 degree
    vtkDataArray* texture = this->Mesh->GetPointData()->GetTCoords();
    const bool isSeam = texture &&
      (GetDifference(texture, a.Points[0], b.Points[0]) > 0. ||
        GetDifference(texture, a.Points[1], b.Points[1]) > 0.);
    return (isSeam || this->GetPiece(a) != this->GetPiece(b)) &&
      vtkMath::Dot(a.Inwards.data(), b.Inwards.data()) < NearOne;
  }

  PointPairs TakeObjects(bool* hasOpen, bool closedOnly)
  {
    const vtkIdType size = this->Places.size();
    Buffer<unsigned char> isOpen(size, 0);
    Buffer<unsigned char> hasPieces(size, 0);
    Buffer<unsigned char> isLeft(size, 0);
    for (const vtkIdType i : InTurn(size))
    {
      const vtkIdType object = this->Objects.Find(this->Pieces.Find(i));
      isOpen[object] |= this->IsOpen[i];
      hasPieces[object] |= this->Faces[i] > 1 ? 1 : 0;
      isLeft[object] |= this->IsLeft[i];
    }
    PointPairs taken;
    for (const auto& pair : this->Pairs)
    {
      const vtkIdType object = this->Objects.Find(this->Pieces.Find(pair.first));
      const bool canBe = pair.first != pair.second && !isLeft[object];
      const bool isTaken = canBe && !(isOpen[object] && (hasPieces[object] || closedOnly));
      if (isTaken)
      {
        taken.push_back(pair);
      }
      if (hasOpen && canBe && isOpen[object] && (isTaken || closedOnly))
      {
        *hasOpen = true;
      }
    }
    return taken;
  }

  vtkIdType GetPiece(const Edge& edge) { return this->Pieces.Find(edge.Points[0]); }
  Vector GetStep(vtkIdType from, vtkIdType to) const
  {
    Vector step = GetPoint(this->Mesh, to);
    const Vector start = GetPoint(this->Mesh, from);
    vtkMath::Subtract(step.data(), start.data(), step.data());
    return step;
  }

  vtkPointSet* Mesh;
  Buffer<vtkIdType> Places;
  Sets Pieces; ///< of points
  Sets Objects;
  // Of the first point of each piece.
  Buffer<unsigned char> Meets;
  Buffer<unsigned char> Faces; ///< how many it has: 0, 1, or 2 for more
  Buffer<unsigned char> IsOpen;
  Buffer<unsigned char> IsLeft;
  std::vector<Edge> Edges;
  std::vector<vtkIdType> Ring;
  PointPairs Pairs; ///< of all objects
};

}

PointPairs FindTouchingSides(vtkPointSet* readable, bool* isOpen, bool closedOnly)
{
  Buffer<vtkIdType> places = HasSolids(readable) ? Buffer<vtkIdType>() : FindPlaces(readable);
  return places.empty() ? PointPairs()
                        : Sides(readable, std::move(places)).FindPairs(isOpen, closedOnly);
}

Buffer<unsigned char> FindSeamCorners(vtkPointSet* sides, Buffer<vtkIdType> places)
{
  return Sides(sides, std::move(places)).FindCorners();
}

}
