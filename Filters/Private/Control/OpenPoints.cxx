// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/OpenPoints.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Control/HangingPoints.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <sstream>

namespace subdivision
{
namespace
{

/// How often each item is named: 0, 1, or 2 for more.
template <typename Id>
Buffer<unsigned char> CountUses(const Buffer<Id>& named, vtkIdType size)
{
  Buffer<unsigned char> uses(size, 0);
  for (const Id item : InTurn(named))
  {
    uses[item] = static_cast<unsigned char>(uses[item] + (uses[item] < 2 ? 1 : 0));
  }
  return uses;
}

/// Calls use(vertices, size, owner) for each open part of the border; `owner` is the face of an
/// edge or the tetrahedron of a face, the part itself where there is none.
template <typename Id, typename Use>
void ForOpenParts(const SimplicialComplex<Id>& complex, const Use& use)
{
  if (complex.NumberOfTets > 0)
  {
    ForEachInTurn(complex.NumberOfFaces,
      [&](vtkIdType face)
      {
        if (complex.FaceTets[face].size() < 2)
        {
          const bool isAlone = complex.FaceTets[face].size() == 0;
          use(complex.FaceVertices.data() + 3 * face, 3,
            isAlone ? Owner{ 2, face } : Owner{ 3, complex.FaceTets[face].begin()[0] });
        }
      });
    ForEachInTurn(complex.NumberOfLineCells,
      [&](vtkIdType line) { use(complex.EdgeVertices.data() + 2 * line, 2, Owner{ 1, line }); });
  }
  else if (complex.NumberOfFaces > 0)
  {
    const Buffer<unsigned char> uses = CountUses(complex.FaceEdges, complex.NumberOfEdges);
    ForEachInTurn(complex.FaceEdges.size(),
      [&](vtkIdType corner)
      {
        const Id edge = complex.FaceEdges[corner];
        if (uses[edge] == 1)
        {
          use(complex.EdgeVertices.data() + 2 * vtkIdType(edge), 2, Owner{ 2, corner / 3 });
        }
      });
    ForEachInTurn(complex.NumberOfEdges,
      [&](vtkIdType edge)
      {
        if (uses[edge] == 0)
        {
          use(complex.EdgeVertices.data() + 2 * edge, 2, Owner{ 1, edge });
        }
      });
  }
  else
  {
    const Buffer<unsigned char> uses = CountUses(complex.EdgeVertices, complex.NumberOfVertices);
    ForEachInTurn(complex.NumberOfVertices,
      [&](vtkIdType vertex)
      {
        const Id end = static_cast<Id>(vertex);
        if (uses[vertex] == 1)
        {
          use(&end, 1, Owner{ 0, vertex });
        }
      });
  }
}

/// The same for cells that are not cut.
template <typename Id, typename Use>
void ForOpenParts(const CellComplex<Id>& complex, const Use& use)
{
  const auto forLines = [&](const auto& isOpen)
  {
    ForEachInTurn(complex.NumberOfEdges,
      [&](vtkIdType edge)
      {
        if (isOpen(static_cast<Id>(edge)))
        {
          use(complex.EdgeVertices.data() + 2 * edge, 2, Owner{ 1, edge });
        }
      });
  };
  if (complex.NumberOfTets > 0)
  {
    ForEachInTurn(complex.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Row<Id> solids = complex.FaceSolids[f];
        if (solids.size() < 2)
        {
          const auto face = static_cast<Id>(f);
          use(complex.GetVertices(face).begin(), complex.GetSize(face),
            solids.size() == 0 ? Owner{ 2, f } : Owner{ 3, *solids.begin() });
        }
      });
    Buffer<unsigned char> areLines(complex.NumberOfEdges, 0);
    ForEachInTurn(complex.NumberOfLineCells > 0 ? complex.Cells.GetNumberOfCells() : 0,
      [&](vtkIdType c)
      {
        if (complex.Cells.GetTable(c).Dimension == 1)
        {
          areLines[*complex.CellEdges[c].begin()] = 1;
        }
      });
    forLines([&](Id edge) { return areLines[edge] != 0; });
  }
  else if (complex.NumberOfFaces > 0)
  {
    ForEachInTurn(complex.NumberOfEdges,
      [&](vtkIdType edge)
      {
        const Row<Id> faces = complex.EdgeFaces[edge];
        if (faces.size() == 1)
        {
          use(complex.EdgeVertices.data() + 2 * edge, 2, Owner{ 2, *faces.begin() });
        }
      });
    forLines([&](Id edge) { return complex.EdgeFaces[edge].size() == 0; });
  }
  else
  {
    ForEachInTurn(complex.NumberOfVertices,
      [&](vtkIdType vertex)
      {
        const Id end = static_cast<Id>(vertex);
        if (complex.VertexEdges[vertex].size() == 1)
        {
          use(&end, 1, Owner{ 0, vertex });
        }
      });
  }
}

/// The vertices of an owner, an edge or a face.
template <typename Id>
struct Part
{
  const Id* Ids;
  int Size;

  bool Has(vtkIdType vertex) const
  {
    return std::find(this->Ids, this->Ids + this->Size, static_cast<Id>(vertex)) !=
      this->Ids + this->Size;
  }
};

template <typename Id>
Part<Id> GetPart(const SimplicialComplex<Id>& complex, const Owner& owner)
{
  const int size = owner.Dimension + 1;
  const Id* vertices = owner.Dimension == 3 ? complex.TetVertices.data()
    : owner.Dimension == 2                  ? complex.FaceVertices.data()
                                            : complex.EdgeVertices.data();
  return { vertices + size * owner.Index, size };
}

template <typename Id>
Part<Id> GetPart(const PolygonMesh<Id>& mesh, const Owner& owner)
{
  const Id id = static_cast<Id>(owner.Index);
  return owner.Dimension == 2
    ? Part<Id>{ mesh.Vertices.data() + mesh.GetFirst(id), static_cast<int>(mesh.GetSize(id)) }
    : Part<Id>{ mesh.EdgeVertices.data() + 2 * owner.Index, 2 };
}

template <typename Id>
Part<Id> GetPart(const CellComplex<Id>& complex, const Owner& owner)
{
  const Row<Id> face =
    owner.Dimension == 2 ? complex.GetVertices(static_cast<Id>(owner.Index)) : Row<Id>();
  return owner.Dimension == 3
    ? Part<Id>{ complex.Cells.GetCorners(owner.Index), complex.Cells.GetTable(owner.Index).Corners }
    : owner.Dimension == 2 ? Part<Id>{ face.begin(), static_cast<int>(face.size()) }
                           : Part<Id>{ complex.EdgeVertices.data() + 2 * owner.Index, 2 };
}

template <typename Id, typename Use>
void ForOpenParts(const PolygonMesh<Id>& mesh, const Use& use)
{
  ForEachInTurn(mesh.EdgeCorners.size(),
    [&](vtkIdType edge)
    {
      const Id corner = mesh.EdgeCorners[edge];
      if (corner < 0 || mesh.Twins[corner] < 0) // edges of three faces, too, which are few
      {
        use(mesh.EdgeVertices.data() + 2 * edge, 2,
          corner < 0 ? Owner{ 1, edge } : Owner{ 2, mesh.GetFace(corner) });
      }
    });
}

/// How far points may be apart to be told: a part of the diagonal of all.
constexpr double NearPart = 1e-6;

/// The points of a border, and which of them are at one place, or nearly.
class Border
{
public:
  Border(vtkIdType points, const double* coordinates)
    : Points(coordinates)
    , Places(points, -1)
    , Shared(points, 0)
  {
  }
  template <typename Id>
  void AddPoints(const Id* vertices, int size)
  {
    std::for_each(vertices, vertices + size, [this](Id vertex) { this->Places[vertex] = vertex; });
  }
  /// Finds the points at one place. Returns whether there are any to be told.
  bool FindPlaces(bool mergesEqual)
  {
    Box box;
    for (const vtkIdType point : InTurn(this->Places.size()))
    {
      if (this->Places[point] >= 0)
      {
        this->Open.push_back(point);
        box.Add(this->Points + 3 * point);
      }
    }
    const Buffer<vtkIdType> firsts =
      FindFirstOfNear(this->Points, this->Open, NearPart * GetDiagonal(box), PointOrder{});
    for (const vtkIdType i : InTurn(firsts.size()))
    {
      const vtkIdType point = this->Open[i];
      if (firsts[i] != point)
      {
        const double distance = this->GetDistance(firsts[i], point);
        this->Pair = this->Count++ == 0 || (this->Gap == 0. && distance > 0.)
          ? std::array<vtkIdType, 2>{ firsts[i], point }
          : this->Pair;
        this->Gap = std::max(this->Gap, distance);
        this->Places[point] = firsts[i];
        this->Shared[point] = this->Shared[firsts[i]] = 1;
      }
    }
    return this->Count > 0 && !(mergesEqual && this->Gap == 0.);
  }
  /// Adds a part of the border; `isSingle`: whether it needs no other part to be joined with.
  template <typename Id>
  void AddPart(const Id* vertices, int size, bool isSingle)
  {
    const auto isShared = [this](Id vertex) { return this->Shared[vertex] != 0; };
    const bool mayJoin = isSingle ? std::all_of(vertices, vertices + size, isShared)
                                  : std::any_of(vertices, vertices + size, isShared);
    if (this->Joins || !mayJoin)
    {
      return;
    }
    std::array<vtkIdType, 4> places = { -1, -2, -3, -4 };
    std::transform(vertices, vertices + size, places.begin(),
      [this](Id vertex) { return this->Places[vertex]; });
    std::sort(places.begin(), places.end());
    const bool hasSize = std::adjacent_find(places.begin(), places.end()) == places.end();
    this->Joins = hasSize && (isSingle || !this->Parts.insert(places).second);
  }
  std::string Describe(const std::string& cure) const
  {
    if (!this->Joins)
    {
      return {};
    }
    std::ostringstream text;
    const bool isNear = this->Gap > 0.;
    text << this->Count
         << (this->Count == 1 ? " point where cells end is" : " points where cells end are")
         << (isNear ? " not farther than 1e-06 times the size of the mesh from another"
                    : " at the place of another")
         << " (for instance points " << this->Pair[0] << " and " << this->Pair[1];
    if (isNear)
    {
      text << ", " << this->GetDistance(this->Pair[0], this->Pair[1]) << " apart";
    }
    const char* const tolerance = isNear ? " with MergeTolerance = 1e-06" : "";
    text << "), and cells that do not share points come apart there. If they should be joined, ";
    isNear || cure.empty()
      ? text << "switch MergePoints on" << tolerance
             << ", or apply vtkStaticCleanUnstructuredGrid (surfaces: vtkCleanPolyData) first."
      : text << cure;
    return text.str();
  }
  const std::vector<vtkIdType>& GetOpen() const { return this->Open; }

private:
  double GetDistance(vtkIdType a, vtkIdType b) const
  {
    return GetLength(this->Points + 3 * a, this->Points + 3 * b);
  }

  const double* Points;
  Buffer<vtkIdType> Places; ///< the first point at the place of each open one; -1 of others
  std::vector<vtkIdType> Open;
  Buffer<unsigned char> Shared; ///< whether another is near
  vtkIdType Count = 0;
  std::array<vtkIdType, 2> Pair = { -1, -1 };
  double Gap = 0.;                          ///< the largest distance of points at a place
  std::set<std::array<vtkIdType, 4>> Parts; ///< by their places, until two are equal
  bool Joins = false;
};

/// The parts 0, 1, ... `count` - 1 in whose boxes some of the points are that are no corners of
/// them: mostly none. Boxes of many parts tell that first.
template <typename GetPart>
std::vector<vtkIdType> FindPartsNear(const std::vector<vtkIdType>& points, vtkIdType count,
  const double* coordinates, const GetPart& getPart)
{
  std::vector<double> x;
  for (const vtkIdType point : points)
  {
    x.insert(x.end(), coordinates + 3 * point, coordinates + 3 * point + 3);
  }
  Buffer<int> ids(static_cast<vtkIdType>(points.size()));
  std::iota(ids.begin(), ids.end(), 0);
  const SimplexTree tree(x.data(), 1, ids);
  const auto hasPoint = [&](vtkIdType first, vtkIdType last)
  {
    Box box;
    for (vtkIdType i = first; i < last; ++i)
    {
      const auto part = getPart(i);
      std::for_each(
        part.Ids, part.Ids + part.Size, [&](auto corner) { box.Add(coordinates + 3 * corner); });
    }
    Grow(box, FlatPart::Tolerance);
    bool has = false;
    const auto part = getPart(first);
    const auto* const end = part.Ids + part.Size;
    tree.ForEachWhere([&](const Box& other) { return !has && box.Meets(other); },
      [&](vtkIdType i)
      {
        const bool isOwn = last == first + 1 && std::find(part.Ids, end, points[i]) != end;
        has = has || (!isOwn && box.Holds(x.data() + 3 * i));
      });
    return has;
  };
  constexpr vtkIdType together = 32;
  Buffer<unsigned char> isNear(count, 0);
  ForEach((count + together - 1) / together,
    [&](vtkIdType group)
    {
      const vtkIdType first = together * group;
      const vtkIdType last = std::min(first + together, count);
      const bool isAnyNear = hasPoint(first, last);
      for (vtkIdType i = first; isAnyNear && i < last; ++i)
      {
        isNear[i] = hasPoint(i, i + 1) ? 1 : 0;
      }
    });
  std::vector<vtkIdType> parts;
  for (const vtkIdType i : InTurn(count))
  {
    isNear[i] ? parts.push_back(i) : void();
  }
  return parts;
}

/// Tells which open points hang: of a mesh of lines their ends, on any of their edges; on
/// surfaces, on any of their faces; on open parts.
template <typename Mesh>
std::string DescribeHanging(const Mesh& mesh, std::vector<vtkIdType> points,
  const Coordinates& coordinates, int dimension, const OpenPointOptions& options)
{
  if (dimension == 1)
  {
    const auto uses = CountUses(mesh.EdgeVertices, mesh.NumberOfVertices);
    const auto isNoEnd = [&uses](vtkIdType point) { return uses[point] != 1; };
    points.erase(std::remove_if(points.begin(), points.end(), isNoEnd), points.end());
  }
  Buffer<unsigned char> isOpen(mesh.NumberOfVertices, 0);
  std::for_each(points.begin(), points.end(), [&](vtkIdType point) { isOpen[point] = 1; });
  const auto getPart = [&](vtkIdType i) { return GetPart(mesh, Owner{ dimension, i }); };
  const vtkIdType count = dimension == 1 ? mesh.EdgeVertices.size() / 2
    : dimension == 2                     ? vtkIdType(mesh.NumberOfFaces)
                                         : 0;
  const std::vector<vtkIdType> near = FindPartsNear(points, count, coordinates, getPart);
  if (near.empty() && dimension < 3)
  {
    return {};
  }
  for (const vtkIdType i : near)
  {
    const auto part = getPart(i);
    points.insert(points.end(), part.Ids, part.Ids + part.Size);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  HangingPoints hanging(points, coordinates, mesh.NumberOfVertices);
  for (const vtkIdType i : near)
  {
    const auto part = getPart(i);
    hanging.AddHost(part.Ids, part.Size, Owner{ dimension, i }, false);
  }
  if (dimension > 1)
  {
    ForOpenParts(mesh, [&](const auto* vertices, int size, const Owner& owner)
      { hanging.AddHost(vertices, size, owner, true); });
  }
  // Cells that share a face, or triangles that share an edge, fit, also if one of them is flat.
  const auto fit = [&](const Owner& a, const Owner& b)
  {
    const auto part = GetPart(mesh, a);
    const auto other = GetPart(mesh, b);
    return std::min(a.Dimension, b.Dimension) > 1 &&
      std::count_if(part.Ids, part.Ids + part.Size,
        [&other](auto vertex) { return other.Has(vertex); }) >= std::min(a.Dimension, b.Dimension);
  };
  hanging.Find(
    dimension == 1, [&](const Owner& owner, vtkIdType vertex)
    { return isOpen[vertex] && !GetPart(mesh, owner).Has(vertex); }, fit);
  return hanging.Describe(options);
}

template <typename Mesh>
std::vector<std::string> Describe(const Mesh& mesh, bool hasSolids, bool hasLinesAlone,
  const Coordinates& coordinates, const OpenPointOptions& options)
{
  std::vector<std::string> warnings;
  Border border(mesh.NumberOfVertices, coordinates);
  ForOpenParts(
    mesh, [&](const auto* vertices, int size, const Owner&) { border.AddPoints(vertices, size); });
  if (border.FindPlaces(options.MergesPoints))
  {
    ForOpenParts(mesh, [&](const auto* vertices, int size, const Owner&)
      { border.AddPart(vertices, size, hasSolids && size == 2); });
  }
  warnings.push_back(border.Describe(options.Cure));
  const std::vector<vtkIdType>& points = border.GetOpen();
  const bool finds = !options.ClosesNodes && !points.empty() && points.size() < VTK_INT_MAX;
  if (finds)
  {
    const int dimension = hasSolids ? 3 : hasLinesAlone ? 1 : 2;
    warnings.push_back(DescribeHanging(mesh, points, coordinates, dimension, options));
  }
  warnings.erase(std::remove(warnings.begin(), warnings.end(), std::string()), warnings.end());
  return warnings;
}

}

template <typename Id>
std::vector<std::string> DescribeOpenPoints(const SimplicialComplex<Id>& complex,
  const Coordinates& coordinates, const OpenPointOptions& options)
{
  return Describe(complex, complex.NumberOfTets > 0, complex.HasEdgesAlone(), coordinates, options);
}

template <typename Id>
std::vector<std::string> DescribeOpenPointsOfSurface(
  const PolygonMesh<Id>& mesh, const Coordinates& coordinates, const OpenPointOptions& options)
{
  return Describe(mesh, false, mesh.NumberOfFaces == 0, coordinates, options);
}

template <typename Id>
std::vector<std::string> DescribeOpenPoints(
  const CellComplex<Id>& complex, const Coordinates& coordinates, const OpenPointOptions& options)
{
  return Describe(
    complex, complex.NumberOfTets > 0, complex.NumberOfFaces == 0, coordinates, options);
}

#define SUBDIVISION_DESCRIBE(Complex)                                                              \
  template std::vector<std::string> DescribeOpenPoints(                                            \
    const Complex&, const Coordinates&, const OpenPointOptions&)
SUBDIVISION_DESCRIBE(SimplicialComplex<int>);
SUBDIVISION_DESCRIBE(SimplicialComplex<long long>);
SUBDIVISION_DESCRIBE(CellComplex<int>);
SUBDIVISION_DESCRIBE(CellComplex<long long>);
SUBDIVISION_COMPILE_FUNCTION(DescribeOpenPointsOfSurface);

}
