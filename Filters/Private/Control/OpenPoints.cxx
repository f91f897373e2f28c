// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/OpenPoints.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Reading/FlatPart.h"
#include "Private/Reading/NearPoints.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>
#include <tuple>

namespace subdivision
{
namespace
{

/// A simplex of the complex, or a face (2) or an edge (1) of a surface.
struct Owner
{
  int Dimension;
  vtkIdType Index;
};

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

/// Whether a vertex is one of an owner.
template <typename Id>
bool HasVertex(const SimplicialComplex<Id>& complex, const Owner& owner, vtkIdType vertex)
{
  const int size = owner.Dimension + 1;
  const Id* vertices = owner.Dimension == 3 ? complex.TetVertices.data()
    : owner.Dimension == 2                  ? complex.FaceVertices.data()
                                            : complex.EdgeVertices.data();
  const Id* first = vertices + size * owner.Index;
  return std::find(first, first + size, static_cast<Id>(vertex)) != first + size;
}

template <typename Id>
bool HasVertex(const PolygonMesh<Id>& mesh, const Owner& owner, vtkIdType vertex)
{
  const vtkIdType first =
    owner.Dimension == 2 ? vtkIdType(mesh.GetFirst(static_cast<Id>(owner.Index))) : 0;
  const Id* begin = owner.Dimension == 2 ? mesh.Vertices.data() + first
                                         : mesh.EdgeVertices.data() + 2 * owner.Index;
  const vtkIdType size =
    owner.Dimension == 2 ? vtkIdType(mesh.GetSize(static_cast<Id>(owner.Index))) : 2;
  return std::find(begin, begin + size, static_cast<Id>(vertex)) != begin + size;
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

double GetLength(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
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
    std::array<vtkIdType, 3> places = { -1, -2, -3 };
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
  std::set<std::array<vtkIdType, 3>> Parts; ///< by their places, until two are equal
  bool Joins = false;
};

/// An open part, or another edge of a mesh of lines: what points may hang on.
struct Host
{
  std::array<int, 3> Points = { -1, -1, -1 }; ///< among the open ones
  int Size = 0;
  Owner Of = { 0, 0 };

  bool Has(int point) const
  {
    return std::find(this->Points.begin(), this->Points.end(), point) != this->Points.end();
  }
};

/// The open points that hang.
class Hanging
{
public:
  Hanging(const std::vector<vtkIdType>& open, const double* coordinates, vtkIdType points)
    : Open(open)
    , Numbers(points, -1)
    , X(3 * open.size())
    , Ids(static_cast<vtkIdType>(open.size()))
    , Hangs(open.size())
  {
    Box box;
    for (const std::size_t i : InTurn(open.size()))
    {
      box.Add(coordinates + 3 * open[i]);
      this->Numbers[open[i]] = static_cast<int>(i);
      this->Ids[static_cast<vtkIdType>(i)] = static_cast<int>(i);
    }
    // Products of very large and very small numbers do not fit.
    const double size = GetDiagonal(box);
    for (const std::size_t i : InTurn(this->X.size()))
    {
      this->X[i] = (coordinates[3 * open[i / 3] + static_cast<vtkIdType>(i % 3)] / size) -
        box.Low[i % 3] / size;
    }
    this->Tree = SimplexTree(this->X.data(), 1, this->Ids);
  }
  template <typename Id>
  void AddHost(const Id* vertices, int size, const Owner& owner)
  {
    Host host;
    host.Size = size;
    host.Of = owner;
    std::transform(vertices, vertices + size, host.Points.begin(),
      [this](Id vertex) { return this->Numbers[vertex]; });
    this->Hosts.push_back(host);
  }
  /// `isOfCell(owner, vertex)`; `isSingle`: what hangs needs no edges along the host.
  template <typename IsOfCell>
  void Find(bool isSingle, const IsOfCell& isOfCell)
  {
    const auto points = static_cast<vtkIdType>(this->Open.size());
    const auto at = [this](vtkIdType i) { return this->Hosts[i / 3].Points[i % 3]; };
    const Rows<int> hostsAt = ListByRow<int>(
      points + 1, 3 * this->Hosts.size(), [&](vtkIdType i) { return at(i) < 0 ? points : at(i); },
      [](vtkIdType i) { return static_cast<int>(i / 3); });
    this->Held = Buffer<int>(static_cast<vtkIdType>(this->Hosts.size()), -1);
    ForEach(this->Held.size(),
      [&](vtkIdType h)
      {
        const Host& host = this->Hosts[h];
        const double* corners[3];
        std::transform(host.Points.begin(), host.Points.begin() + host.Size, corners,
          [this](int point) { return this->GetPoint(point); });
        const FlatPart part(corners, host.Size);
        const auto hasAlong = [&](int point, const Row<int>& around)
        { return this->HasAlong(host, part, this->GetPoint(point), around); };
        this->Tree.ForEachWhere([&](const Box& box) { return part.Meets(box); },
          [&](vtkIdType i)
          {
            const auto point = static_cast<int>(i);
            const Row<int> around = hostsAt[point];
            if (!host.Has(point) && part.Find(this->GetPoint(point)) == FlatPart::Inside &&
              !isOfCell(host.Of, this->Open[i]) && (isSingle || hasAlong(point, around)))
            {
              this->Hangs[i].store(1, std::memory_order_relaxed);
              this->Held[h] = this->Held[h] < 0 ? point : std::min(this->Held[h], point);
            }
          });
      });
  }
  std::string Describe(const OpenPointOptions& options) const
  {
    const auto count = std::count(this->Hangs.begin(), this->Hangs.end(), 1);
    std::pair<vtkIdType, vtkIdType> first(VTK_ID_MAX, -1); // cell and point
    for (const vtkIdType h : InTurn(this->Held.size()))
    {
      if (this->Held[h] >= 0)
      {
        const Owner& owner = this->Hosts[h].Of;
        first = std::min(
          first, { options.FindCell(owner.Dimension, owner.Index), this->Open[this->Held[h]] });
      }
    }
    return count == 0
      ? std::string()
      : std::to_string(count) + (count == 1 ? " point hangs: it lies" : " points hang: they lie") +
        " inside an edge or a face of another cell (the first cell is " +
        std::to_string(first.first) + ", with point " + std::to_string(first.second) +
        "), as in adaptive meshes, and cells come apart there. Switch CloseHangingNodes on to have "
        "cells cut so that they fit.";
  }

private:
  /// Whether edges of other cells leave a point along the host on two sides. One that is hardly
  /// longer than the tolerance may have any direction.
  bool HasAlong(
    const Host& host, const FlatPart& part, const double* x, const Row<int>& around) const
  {
    std::vector<std::array<double, 3>> along;
    for (const int other : around)
    {
      const Host& edge = this->Hosts[other];
      const bool isOwn =
        std::tie(edge.Of.Dimension, edge.Of.Index) == std::tie(host.Of.Dimension, host.Of.Index);
      for (int i = 0; !isOwn && i < edge.Size; ++i)
      {
        const double* end = this->GetPoint(edge.Points[i]);
        std::array<double, 3> step;
        std::array<double, 3> at;
        for (int k = 0; k < 3; ++k)
        {
          step[k] = 0.25 * (end[k] - x[k]); // it may end beyond the host
          at[k] = x[k] + step[k];
        }
        if (GetLength(x, at.data()) > part.GetTolerance() && part.Find(at.data()) != FlatPart::Off)
        {
          along.push_back(step);
        }
      }
    }
    return std::any_of(along.begin(), along.end(), [&](const auto& a)
      { return a[0] * along[0][0] + a[1] * along[0][1] + a[2] * along[0][2] < 0.; });
  }
  const double* GetPoint(int i) const { return this->X.data() + 3 * static_cast<std::size_t>(i); }

  const std::vector<vtkIdType>& Open;
  Buffer<int> Numbers; ///< of points among the open ones
  std::vector<double> X;
  Buffer<int> Ids;
  SimplexTree Tree;
  std::vector<Host> Hosts;
  std::vector<std::atomic<unsigned char>> Hangs;
  Buffer<int> Held; ///< the first point that hangs on each host
};

/// The edges of a mesh of lines in whose boxes the end of another line is: mostly none. Boxes of
/// many edges tell that first.
template <typename Mesh>
std::vector<vtkIdType> FindEdgesNear(
  const std::vector<vtkIdType>& ends, const Mesh& mesh, const double* coordinates)
{
  std::vector<double> x;
  for (const vtkIdType end : ends)
  {
    x.insert(x.end(), coordinates + 3 * end, coordinates + 3 * end + 3);
  }
  Buffer<int> ids(static_cast<vtkIdType>(ends.size()));
  std::iota(ids.begin(), ids.end(), 0);
  const SimplexTree tree(x.data(), 1, ids);
  const auto* corners = mesh.EdgeVertices.data();
  const auto hasEnd = [&](vtkIdType first, vtkIdType last)
  {
    Box box;
    std::for_each(corners + 2 * first, corners + 2 * last,
      [&](vtkIdType corner) { box.Add(coordinates + 3 * corner); });
    const double most = FlatPart::Tolerance * GetDiagonal(box);
    std::transform(box.Low, box.Low + 3, box.Low, [=](double low) { return low - most; });
    std::transform(box.High, box.High + 3, box.High, [=](double high) { return high + most; });
    bool has = false;
    tree.ForEachWhere([&](const Box& other) { return !has && box.Meets(other); },
      [&](vtkIdType i)
      {
        const bool isOwn =
          last == first + 1 && (ends[i] == corners[2 * first] || ends[i] == corners[2 * first + 1]);
        has = has || (!isOwn && box.Holds(x.data() + 3 * i));
      });
    return has;
  };
  std::vector<vtkIdType> edges;
  constexpr vtkIdType together = 32;
  const vtkIdType count = mesh.EdgeVertices.size() / 2;
  bool isNear = false;
  for (const vtkIdType edge : InTurn(count))
  {
    isNear = edge % together == 0 ? hasEnd(edge, std::min(edge + together, count)) : isNear;
    if (isNear && hasEnd(edge, edge + 1))
    {
      edges.push_back(edge);
    }
  }
  return edges;
}

/// Tells which open points of a mesh of lines are ends of them that hang on others.
template <typename Mesh>
std::string DescribeHangingEnds(const Mesh& mesh, std::vector<vtkIdType> points,
  const Coordinates& coordinates, const OpenPointOptions& options)
{
  const auto uses = CountUses(mesh.EdgeVertices, mesh.NumberOfVertices);
  const auto isNoEnd = [&uses](vtkIdType point) { return uses[point] != 1; };
  points.erase(std::remove_if(points.begin(), points.end(), isNoEnd), points.end());
  const std::vector<vtkIdType> edges = FindEdgesNear(points, mesh, coordinates);
  if (edges.empty())
  {
    return {};
  }
  for (const vtkIdType edge : edges)
  {
    points.push_back(mesh.EdgeVertices[2 * edge]);
    points.push_back(mesh.EdgeVertices[2 * edge + 1]);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Hanging hanging(points, coordinates, mesh.NumberOfVertices);
  for (const vtkIdType edge : edges)
  {
    hanging.AddHost(mesh.EdgeVertices.data() + 2 * edge, 2, Owner{ 1, edge });
  }
  hanging.Find(true, [&](const Owner& owner, vtkIdType vertex)
    { return isNoEnd(vertex) || HasVertex(mesh, owner, vertex); });
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
  if (finds && hasLinesAlone)
  {
    warnings.push_back(DescribeHangingEnds(mesh, points, coordinates, options));
  }
  else if (finds)
  {
    Hanging hanging(points, coordinates, mesh.NumberOfVertices);
    ForOpenParts(mesh, [&](const auto* vertices, int size, const Owner& owner)
      { hanging.AddHost(vertices, size, owner); });
    hanging.Find(false,
      [&mesh](const Owner& owner, vtkIdType vertex) { return HasVertex(mesh, owner, vertex); });
    warnings.push_back(hanging.Describe(options));
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

SUBDIVISION_COMPILE_FUNCTION(DescribeOpenPoints);
SUBDIVISION_COMPILE_FUNCTION(DescribeOpenPointsOfSurface);

}
