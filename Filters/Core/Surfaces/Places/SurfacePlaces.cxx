// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/SurfacePlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Surfaces/Places/PlaceDescent.h"

#include <algorithm>
#include <numeric>

namespace subdivision
{
namespace
{

/// The vertices from which a crease may be that is sharp for some steps more and counts for the
/// faces at them, ascending.
template <typename Id>
std::vector<Id> CollectNearSharpEdges(const PolygonMesh<Id>& mesh, const SharpCreases<Id>& creases)
{
  std::vector<Id> near;
  const auto sort = [&near]
  {
    StableSort(near, std::less<>());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  };
  for (const SharpEdge<Id>& edge : InTurn(creases.Edges))
  {
    const Id* ends = mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(edge.Edge);
    near.insert(near.end(), ends, ends + 2);
  }
  sort();
  // The faces at a corner of a face and at its neighbours are looked at (SurfacePatch.h).
  std::vector<Id> edges;
  for (int ring = 0; ring < 2; ++ring)
  {
    const std::vector<Id> last = near;
    for (const Id vertex : InTurn(last))
    {
      CollectEdges(mesh, vertex, [](Id) { return true; }, edges);
      for (const Id edge : edges)
      {
        near.push_back(mesh.GetOtherEnd(edge, vertex));
      }
      VisitFans(mesh, vertex,
        [&](Id corner)
        {
          VisitFan(mesh, corner,
            [&](const FanStep<Id>& step)
            {
              const Id face = mesh.GetFace(step.Corner);
              const Id* corners = mesh.Vertices.data() + mesh.GetFirst(face);
              near.insert(near.end(), corners, corners + mesh.GetSize(face));
            });
        });
    }
    sort();
  }
  return near;
}

/// What rows of the places of a vertex, edge or face are made of.
template <typename Id>
struct PartRows
{
  PatchColumns<Id> Regular;       ///< without columns if it is not regular,
  std::vector<PlaceRow<Id>> Rows; ///< and these are the rows of its places then
};

/// Finds what the rows of some places of a part are made of.
template <typename Id>
class PartReader
{
public:
  PartReader(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const SharpCreases<Id>& creases, const std::vector<Id>& nearSharpEdges)
    : Descent(scheme)
    , Level(level)
    , Creases(creases)
    , NearSharpEdges(nearSharpEdges)
    , Sides(scheme.NeedsTriangles() ? 3 : 4)
  {
  }

  /// `getPlace(i)` is one of `size` places.
  template <typename GetPlace>
  void Read(std::size_t size, const GetPlace& getPlace, PartRows<Id>& rows)
  {
    const SurfacePlace<Id>& first = getPlace(0);
    if (this->FindRegular(first.Dimension, first.Part))
    {
      rows.Regular = PatchColumns<Id>(this->Regular);
      return;
    }
    rows.Rows.resize(size);
    std::vector<MovingPlace<Id>> moving;
    for (std::size_t i = 0; i < size; ++i)
    {
      moving.push_back({ getPlace(i), &rows.Rows[i] });
    }
    this->Descent.Run(this->Level, this->Creases, moving);
    for (PlaceRow<Id>& row : rows.Rows)
    {
      row.RemoveZeros();
    }
  }

private:
  bool FindRegular(int dimension, Id part)
  {
    const PolygonMesh<Id>& mesh = this->Level.Mesh;
    const auto isFar = [this](Id vertex)
    {
      return !std::binary_search(this->NearSharpEdges.begin(), this->NearSharpEdges.end(), vertex);
    };
    switch (dimension)
    {
      case 0:
        return false;
      case 1:
      {
        const Id* ends = mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(part);
        return isFar(ends[0]) && isFar(ends[1]) && this->Regular.FindLine(this->Level, part);
      }
      default:
      {
        const Id* corners = mesh.Vertices.data() + mesh.GetFirst(part);
        const Id size = mesh.GetSize(part);
        return size == this->Sides && std::all_of(corners, corners + size, isFar) &&
          this->Regular.FindFace(this->Level, part);
      }
    }
  }

  PlaceDescent<Id> Descent;
  RegularPatch<Id> Regular;
  const SurfaceLevel<Id>& Level;
  const SharpCreases<Id>& Creases;
  const std::vector<Id>& NearSharpEdges;
  const Id Sides;
};

/// Writes the rows of places.
template <typename Id>
class PlaceWriter
{
public:
  explicit PlaceWriter(PlaceRows<Id>& rows)
    : Rows(rows)
  {
  }
  void Write(vtkIdType place, const PlaceRow<Id>& row) const
  {
    std::copy(row.Columns.begin(), row.Columns.end(), this->GetColumns(place));
    const auto weights = this->Rows.GetWeights(place);
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      std::copy(row.Weights[p].begin(), row.Weights[p].end(), weights[p]);
    }
  }
  void Write(vtkIdType i, const PatchColumns<Id>& columns, const SurfacePlace<Id>& place) const
  {
    std::copy(columns.Vertices.begin(), columns.Vertices.end(), this->GetColumns(i));
    const PatchParts ofPoints = WeightControlPoints(columns.Domain, place.At, place.Directions);
    const auto weights = this->Rows.GetWeights(i);
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      std::fill_n(weights[p], columns.Vertices.size(), 0.);
      for (const auto& entry : columns.Entries)
      {
        weights[p][entry.Column] += entry.Weight * ofPoints[p][entry.Point];
      }
    }
  }

private:
  Id* GetColumns(vtkIdType place) const
  {
    return this->Rows.Columns.data() + this->Rows.Offsets[place];
  }
  PlaceRows<Id>& Rows;
};

/// The places of each part, one part after the other.
template <typename Id>
struct PlacesOfParts
{
  std::vector<std::size_t> Order;  ///< of all places
  std::vector<std::size_t> Starts; ///< of the places of a part in that order; one more than parts

  explicit PlacesOfParts(const std::vector<SurfacePlace<Id>>& places)
    : Order(places.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    const auto isBefore = [&places](std::size_t a, std::size_t b)
    {
      return places[a].Dimension != places[b].Dimension ? places[a].Dimension < places[b].Dimension
                                                        : places[a].Part < places[b].Part;
    };
    StableSort(this->Order, isBefore);
    for (const std::size_t i : InTurn(this->Order.size()))
    {
      if (i == 0 || isBefore(this->Order[i - 1], this->Order[i]))
      {
        this->Starts.push_back(i);
      }
    }
    this->Starts.push_back(this->Order.size());
  }
  vtkIdType GetNumberOfParts() const { return static_cast<vtkIdType>(this->Starts.size()) - 1; }
};

}

template <typename Id>
PlaceRows<Id> FindSurfacePlaces(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const std::vector<SurfacePlace<Id>>& places)
{
  const PlacesOfParts<Id> parts(places);
  const std::vector<Id> near = CollectNearSharpEdges(level.Mesh, creases);
  std::vector<PartRows<Id>> made(static_cast<std::size_t>(parts.GetNumberOfParts()));
  Buffer<Id> offsets(static_cast<vtkIdType>(places.size()) + 1);
  const auto forParts = [&](const auto& act)
  {
    ForRangesOfBlocks(parts.GetNumberOfParts(),
      [&](vtkIdType begin, vtkIdType end)
      {
        PartReader<Id> reader(scheme, level, creases, near);
        for (vtkIdType part = begin; part < end; ++part)
        {
          const std::size_t* first = parts.Order.data() + parts.Starts[part];
          act(reader, first, parts.Starts[part + 1] - parts.Starts[part], made[part]);
        }
      });
  };
  forParts(
    [&](PartReader<Id>& reader, const std::size_t* first, std::size_t size, PartRows<Id>& part)
    {
      reader.Read(size, [&](std::size_t i) -> const auto& { return places[first[i]]; }, part);
      for (std::size_t i = 0; i < size; ++i)
      {
        offsets[first[i]] = static_cast<Id>(
          part.Rows.empty() ? part.Regular.Vertices.size() : part.Rows[i].Columns.size());
      }
    });
  CountsToOffsets(offsets);
  PlaceRows<Id> rows(level.Mesh.NumberOfVertices, std::move(offsets));
  const PlaceWriter<Id> writer(rows);
  forParts(
    [&](PartReader<Id>&, const std::size_t* first, std::size_t size, const PartRows<Id>& part)
    {
      for (std::size_t i = 0; i < size; ++i)
      {
        const auto place = static_cast<vtkIdType>(first[i]);
        part.Rows.empty() ? writer.Write(place, part.Regular, places[first[i]])
                          : writer.Write(place, part.Rows[i]);
      }
    });
  return rows;
}

SUBDIVISION_COMPILE_FUNCTION(FindSurfacePlaces);

}
