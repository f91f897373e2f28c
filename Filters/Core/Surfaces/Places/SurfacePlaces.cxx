// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/SurfacePlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Surfaces/Places/PlaceDescent.h"

#include <algorithm>
#include <memory>
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

/// The data for the rows of places of a vertex, edge or face.
template <typename Id>
struct PartRows
{
  /// Of a part that is not inside of a regular surface.
  struct Others
  {
    PatchColumns<Id> Regular;       ///< without columns if it is not regular,
    std::vector<PlaceRow<Id>> Rows; ///< and these are the rows of its places then
  };

  std::size_t CountColumns(std::size_t place) const
  {
    return !this->Other           ? static_cast<std::size_t>(this->Inner.GetSize())
      : this->Other->Rows.empty() ? this->Other->Regular.Vertices.size()
                                  : this->Other->Rows[place].Columns.size();
  }

  SplineColumns<Id> Inner;
  std::unique_ptr<Others> Other; ///< null: the part is an inner one
};

/// Finds the data for the rows of some places of a part.
template <typename Id>
class PartReader
{
public:
  PartReader(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const SharpCreases<Id>& creases, const std::vector<Id>& nearSharpEdges,
    PlaceDerivatives derivatives)
    : Descent(scheme, derivatives)
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
    const bool isFar = this->IsFar(first.Dimension, first.Part);
    if (isFar && first.Dimension == 2 && FindSplineColumns(this->Level, first.Part, rows.Inner))
    {
      return;
    }
    rows.Other = std::make_unique<typename PartRows<Id>::Others>();
    if (isFar && this->FindRegular(first.Dimension, first.Part))
    {
      rows.Other->Regular = PatchColumns<Id>(this->Regular);
      return;
    }
    rows.Other->Rows.resize(size);
    std::vector<MovingPlace<Id>> moving;
    for (std::size_t i = 0; i < size; ++i)
    {
      moving.push_back({ getPlace(i), &rows.Other->Rows[i] });
    }
    this->Descent.Run(this->Level, this->Creases, moving);
    for (PlaceRow<Id>& row : rows.Other->Rows)
    {
      row.RemoveZeros();
    }
  }

private:
  /// Whether an edge or a face has the size that the scheme has, and no crease near it that is
  /// sharp for some steps more.
  bool IsFar(int dimension, Id part) const
  {
    const PolygonMesh<Id>& mesh = this->Level.Mesh;
    const Id size = dimension == 2 ? mesh.GetSize(part) : Id(2);
    if (dimension == 0 || (dimension == 2 && size != this->Sides))
    {
      return false;
    }
    const Id* ids = dimension == 2 ? mesh.Vertices.data() + mesh.GetFirst(part)
                                   : mesh.EdgeVertices.data() + 2 * static_cast<vtkIdType>(part);
    const auto& near = this->NearSharpEdges;
    return std::none_of(ids, ids + size,
      [&near](Id vertex) { return std::binary_search(near.begin(), near.end(), vertex); });
  }
  bool FindRegular(int dimension, Id part)
  {
    return dimension == 1 ? this->Regular.FindLine(this->Level, part)
                          : this->Regular.FindFace(this->Level, part);
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
  PlaceWriter(PlaceRows<Id>& rows, PlaceDerivatives derivatives)
    : Rows(rows)
    , Derivatives(derivatives)
  {
  }
  /// Place i of all, which is one of `part`: number `own`.
  void Write(
    vtkIdType i, const SurfacePlace<Id>& place, const PartRows<Id>& part, std::size_t own) const
  {
    if (!part.Other)
    {
      std::copy(part.Inner.begin(), part.Inner.end(), this->GetColumns(i));
      part.Inner.Weight(place.At[0], place.At[1], place.Directions, this->Rows.GetWeights(i));
    }
    else if (part.Other->Rows.empty())
    {
      this->WriteRegular(i, place, part.Other->Regular);
    }
    else
    {
      this->WriteRow(i, part.Other->Rows[own]);
    }
  }

private:
  void WriteRegular(
    vtkIdType i, const SurfacePlace<Id>& place, const PatchColumns<Id>& columns) const
  {
    std::copy(columns.Vertices.begin(), columns.Vertices.end(), this->GetColumns(i));
    PatchParts ofPoints;
    WeightControlPoints(columns.Domain, place.At, place.Directions, this->Derivatives, ofPoints);
    this->ForParts(i,
      [&](int p, double* weights)
      {
        std::fill_n(weights, columns.Vertices.size(), 0.);
        for (const auto& entry : columns.Entries)
        {
          weights[entry.Column] += entry.Weight * ofPoints[p][entry.Point];
        }
      });
  }
  void WriteRow(vtkIdType i, const PlaceRow<Id>& row) const
  {
    std::copy(row.Columns.begin(), row.Columns.end(), this->GetColumns(i));
    this->ForParts(i, [&](int p, double* weights)
      { std::copy(row.Weights[p].begin(), row.Weights[p].end(), weights); });
  }

  /// Calls act(part, weights of place i) for the parts that there are.
  template <typename Act>
  void ForParts(vtkIdType i, const Act& act) const
  {
    const PlaceSums weights = this->Rows.GetWeights(i);
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      weights[p] ? act(p, weights[p]) : void();
    }
  }
  Id* GetColumns(vtkIdType place) const
  {
    return this->Rows.Columns.data() + this->Rows.Offsets[place];
  }

  PlaceRows<Id>& Rows;
  const PlaceDerivatives Derivatives;
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
    if (!std::is_sorted(this->Order.begin(), this->Order.end(), isBefore)) // often it is
    {
      StableSort(this->Order, isBefore);
    }
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
  std::size_t CountPlaces(vtkIdType part) const
  {
    return this->Starts[part + 1] - this->Starts[part];
  }
  /// The number of place i of a part among all places.
  std::size_t GetPlace(vtkIdType part, std::size_t i) const
  {
    return this->Order[this->Starts[part] + i];
  }
};

}

template <typename Id>
PlaceRows<Id> FindSurfacePlaces(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const std::vector<SurfacePlace<Id>>& places,
  PlaceDerivatives derivatives)
{
  const PlacesOfParts<Id> parts(places);
  const std::vector<Id> near = CollectNearSharpEdges(level.Mesh, creases);
  std::vector<PartRows<Id>> made(static_cast<std::size_t>(parts.GetNumberOfParts()));
  Buffer<Id> offsets(static_cast<vtkIdType>(places.size()) + 1);
  ForRangesOfBlocks(parts.GetNumberOfParts(),
    [&](vtkIdType begin, vtkIdType end)
    {
      PartReader<Id> reader(scheme, level, creases, near, derivatives);
      for (vtkIdType part = begin; part < end; ++part)
      {
        const std::size_t size = parts.CountPlaces(part);
        reader.Read(
          size, [&](std::size_t i) -> const auto& { return places[parts.GetPlace(part, i)]; },
          made[part]);
        for (std::size_t i = 0; i < size; ++i)
        {
          offsets[parts.GetPlace(part, i)] = static_cast<Id>(made[part].CountColumns(i));
        }
      }
    });
  CountsToOffsets(offsets);
  PlaceRows<Id> rows(level.Mesh.NumberOfVertices, std::move(offsets), 2, derivatives);
  const PlaceWriter<Id> writer(rows, derivatives);
  ForRangesOfBlocks(parts.GetNumberOfParts(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType part = begin; part < end; ++part)
      {
        for (std::size_t i = 0; i < parts.CountPlaces(part); ++i)
        {
          const std::size_t place = parts.GetPlace(part, i);
          writer.Write(static_cast<vtkIdType>(place), places[place], made[part], i);
        }
      }
    });
  return rows;
}

SUBDIVISION_COMPILE_FUNCTION(FindSurfacePlaces);

}
