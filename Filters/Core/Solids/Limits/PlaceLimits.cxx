// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PlaceLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/PairTable.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <type_traits>

namespace subdivision
{
namespace
{

/// How often a simplex is split that does not become regular: errors are a part of the square of
/// its size.
constexpr int MostSplits = 24;
/// The same inside a tetrahedron, where limits are smoother.
constexpr int SplitsInside = 8;

/// Which parts of a simplex have nothing but regular vertices inside, by the corners that a part
/// has, one bit for each.
using RegularParts = std::array<bool, 16>;

/// Finds RegularParts.
template <typename LevelType>
class RegularReader
{
public:
  using Id = typename LevelType::IdType;

  RegularReader(const LevelType& level, const std::vector<LimitPlace<Id>>& places)
    : Level(level)
    , Reader(level, None)
  {
    Buffer<unsigned char> isCorner(level.Complex.NumberOfVertices, 0);
    for (const LimitPlace<Id>& place : InTurn(places))
    {
      for (int i = 0; i <= place.Dimension; ++i)
      {
        isCorner[place.Corners[i]] = 1;
      }
    }
    ForEachInTurn(level.Complex.NumberOfEdges,
      [&](vtkIdType e)
      {
        const Id* ends = level.Complex.EdgeVertices.data() + 2 * e;
        if (isCorner[ends[0]] && isCorner[ends[1]])
        {
          this->Edges.FindOrAdd(ends[0], ends[1], static_cast<Id>(e));
        }
      });
    ForEachInTurn(level.Complex.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id* ids = level.Complex.FaceVertices.data() + 3 * f;
        if (isCorner[ids[0]] && isCorner[ids[1]] && isCorner[ids[2]])
        {
          std::array<Id, 3> corners{ { ids[0], ids[1], ids[2] } };
          std::sort(corners.begin(), corners.end());
          this->Faces.emplace(corners, static_cast<Id>(f));
        }
      });
  }

  const RegularParts& Find(const LimitPlace<Id>& place)
  {
    const auto [found, isNew] = this->Found.try_emplace(place.Corners, RegularParts{});
    RegularParts& parts = found->second;
    if (isNew && place.Dimension == 1)
    {
      this->ReadLine(place.Corners, parts);
    }
    if (isNew && place.Dimension == 2)
    {
      this->ReadTriangle(place.Corners, parts);
    }
    return parts;
  }

private:
  Rule GetRule(Id vertex) const { return this->Level.Strata.Vertices[vertex].GetRule(); }

  /// Whether a vertex between the ends of an edge is regular.
  bool IsRegularEdge(Id edge) const
  {
    if (edge < 0)
    {
      return false;
    }
    const Rule rule = this->Level.Strata.Edges[edge].GetRule();
    const Row<Id> faces = this->Level.Strata.EdgeRings.GetCarriers(edge);
    return rule == Rule::Curve ||
      (rule == Rule::Surface && faces.size() == 2 && faces.begin()[0] >= 0 &&
        faces.begin()[1] >= 0);
  }

  void ReadLine(const std::array<Id, 4>& corners, RegularParts& parts)
  {
    const Id edge = this->Edges.Find(corners[0], corners[1]);
    parts[3] = this->IsRegularEdge(edge);
    const bool isCurve = parts[3] && this->Level.Strata.Edges[edge].GetRule() == Rule::Curve;
    for (int i = 0; i < 2; ++i)
    {
      SheetPatch<Id> patch;
      const bool isRead = this->Reader.ReadVertex(corners[i], patch);
      const auto& columns = patch.Columns;
      parts[1 << i] = parts[3] && isRead &&
        (isCurve ? patch.Key.Places == SheetPlaces::CurveVertex &&
              (columns.size() == 1 ||
                std::find(columns.begin(), columns.end(), corners[1 - i]) != columns.end())
                 : columns.size() == 7);
    }
  }

  void ReadTriangle(const std::array<Id, 4>& corners, RegularParts& parts)
  {
    const std::array<Id, 3> ordered{ { corners[0], corners[1], corners[2] } };
    std::array<Id, 3> sorted = ordered;
    std::sort(sorted.begin(), sorted.end());
    const auto face = this->Faces.find(sorted);
    if (face == this->Faces.end() ||
      this->Level.Strata.Faces[face->second].GetRule() != Rule::Surface)
    {
      return;
    }
    parts[7] = true;
    for (int i = 0; i < 3; ++i)
    {
      const int k = (i + 1) % 3;
      parts[1 << i | 1 << k] = this->IsRegularEdge(this->Edges.Find(corners[i], corners[k]));
    }
    SheetPatch<Id> patch;
    const bool isSheet = this->Reader.ReadFace(face->second, ordered, patch);
    for (int i = 0; isSheet && i < 3; ++i)
    {
      const SheetFan& fan = patch.Key.Fans[i];
      parts[1 << i] = (fan.What == SheetFan::Kind::Closed && fan.After == 4) ||
        (fan.What == SheetFan::Kind::Open && fan.After + fan.Before == 2);
    }
  }

  const Buffer<unsigned char> None;
  const LevelType& Level;
  const SheetReader<LevelType> Reader;
  PairTable<Id> Edges;
  std::map<std::array<Id, 3>, Id> Faces;
  std::map<std::array<Id, 4>, RegularParts> Found;
};

/// The numbers of vertices as LocalLimit has them.
template <typename Id>
class VertexNames
{
public:
  explicit VertexNames(Id vertices)
    : First(vertices)
  {
  }
  Id GetMidpoint(Id a, Id b)
  {
    const Id next = this->First + static_cast<Id>(this->Midpoints.size());
    const Id found = this->Numbers.FindOrAdd(a, b, next);
    if (found == next)
    {
      this->Midpoints.push_back({ { a, b } });
    }
    return found;
  }
  const std::vector<std::array<Id, 2>>& GetMidpoints() const { return this->Midpoints; }

private:
  const Id First;
  PairTable<Id> Numbers;
  std::vector<std::array<Id, 2>> Midpoints;
};

/// A part of the simplex of a place.
template <typename Id>
struct PlacePart
{
  std::array<Id, 4> Corners;
  std::array<int, 4> Carriers; ///< the corners of the simplex between which each lies, as bits
  CornerWeights At;            ///< the place
  std::array<CornerWeights, 3> Directions; ///< how it changes with the parameters
};

template <typename Id>
PlacePart<Id> StartPart(const LimitPlace<Id>& place)
{
  PlacePart<Id> part{ place.Corners, { { 1, 2, 4, 8 } }, {}, {} };
  const int first = place.Order[0];
  part.At[first] = 1.;
  for (int k = 1; k <= place.Dimension; ++k)
  {
    const int corner = place.Order[k];
    part.At[corner] += place.Parameters[k - 1];
    part.At[first] -= place.Parameters[k - 1];
    part.Directions[k - 1][corner] = 1.;
    part.Directions[k - 1][first] = -1.;
  }
  return part;
}

/// Goes on to the child with the place.
template <typename Id>
PlacePart<Id> SplitPart(const PlacePart<Id>& part, int dimension, VertexNames<Id>& names)
{
  const SimplexChild* best = nullptr;
  double most = 0.;
  for (const SimplexChild& child : ListChildren(dimension))
  {
    const CornerWeights at = Multiply(child.ToChild, part.At);
    const double least = *std::min_element(at.begin(), at.begin() + dimension + 1);
    if (!best || least > most)
    {
      best = &child;
      most = least;
    }
  }
  PlacePart<Id> child = part;
  child.At = Multiply(best->ToChild, part.At);
  for (CornerWeights& direction : child.Directions)
  {
    direction = Multiply(best->ToChild, direction);
  }
  for (int i = 0; i <= dimension; ++i)
  {
    const int point = best->Corners[i];
    if (point <= dimension)
    {
      child.Corners[i] = part.Corners[point];
      child.Carriers[i] = part.Carriers[point];
      continue;
    }
    const int* ends = GetEdgeEnds(dimension, point - dimension - 1);
    child.Corners[i] = names.GetMidpoint(part.Corners[ends[0]], part.Corners[ends[1]]);
    child.Carriers[i] = part.Carriers[ends[0]] | part.Carriers[ends[1]];
  }
  return child;
}

/// Whether the limit over a part is a polynomial, at least but for rounding.
template <typename Id>
bool IsSmall(const PlacePart<Id>& part, int dimension, int splits, const RegularParts& regular)
{
  const auto first = part.Carriers.begin();
  if (dimension == 3)
  {
    return splits >= SplitsInside &&
      std::all_of(first, first + 4, [](int carrier) { return carrier == 15; });
  }
  return std::all_of(first, first + dimension + 1, [&](int carrier) { return regular[carrier]; });
}

/// The vertex at a node of the polynomial over a part: on the level after the next.
template <typename Id>
Id FindNode(const PlacePart<Id>& part, const PlaceNode& node, VertexNames<Id>& names)
{
  const auto findEven = [&](const PlaceNode& point)
  {
    int ends[2] = { -1, -1 };
    for (int i = 0; i < 4; ++i)
    {
      if (point[i] > 0)
      {
        ends[ends[0] < 0 ? 0 : 1] = i;
      }
    }
    return ends[1] < 0 ? part.Corners[ends[0]]
                       : names.GetMidpoint(part.Corners[ends[0]], part.Corners[ends[1]]);
  };
  std::vector<int> odd;
  for (int i = 0; i < 4; ++i)
  {
    if (node[i] % 2 != 0)
    {
      odd.push_back(i);
    }
  }
  if (odd.empty())
  {
    return findEven(node);
  }
  PlaceNode a = node;
  PlaceNode b = node;
  if (odd.size() == 4) // in the middle of the diagonal between the edges 02 and 13
  {
    a = { { 2, 0, 2, 0 } };
    b = { { 0, 2, 0, 2 } };
  }
  else
  {
    ++a[odd[0]];
    --a[odd[1]];
    --b[odd[0]];
    ++b[odd[1]];
  }
  const Id first = findEven(a);
  const Id second = findEven(b);
  return names.GetMidpoint(first, second);
}

/// The nodes of a place, and their weights.
template <typename Id>
struct PlaceNodes
{
  std::vector<Id> Vertices;
  std::vector<std::array<double, PlaceParts::Count>> Weights;
};

/// Steps after which no semi-sharp crease is left.
template <typename Id>
int CountSharpSteps(const SemiSharpStages<Id>& creases)
{
  double most = 0.;
  for (const auto* sharpness : { &creases.Sharpness, &creases.FaceSharpness })
  {
    for (const double s : InTurn(*sharpness))
    {
      most = std::max(most, s);
    }
  }
  return static_cast<int>(std::ceil(std::min<double>(most, MostSplits)));
}

template <typename LevelType, typename Id>
std::vector<PlaceNodes<Id>> FindNodes(const LevelType& level, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places, VertexNames<Id>& names)
{
  constexpr bool isLinear = std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value;
  RegularReader<LevelType> reader(level, places);
  const int sharpSteps = CountSharpSteps(creases);
  std::vector<PlaceNodes<Id>> all;
  for (const LimitPlace<Id>& place : InTurn(places))
  {
    PlacePart<Id> part = StartPart(place);
    const int dimension = place.Dimension;
    PlaceNodes<Id> nodes;
    if (isLinear)
    {
      for (int i = 0; i <= dimension; ++i)
      {
        nodes.Vertices.push_back(place.Corners[i]);
        nodes.Weights.push_back(
          { { part.At[i], part.Directions[0][i], part.Directions[1][i], part.Directions[2][i] } });
      }
      all.push_back(std::move(nodes));
      continue;
    }
    if (dimension == 3 && SchemeOf<LevelType>::Traits.HasPieces)
    {
      throw std::invalid_argument("this scheme has solids that are no tetrahedra");
    }
    const RegularParts& regular = reader.Find(place);
    for (int splits = 0; dimension > 0 && splits < MostSplits &&
      (splits < sharpSteps || !IsSmall(part, dimension, splits, regular));
      ++splits)
    {
      part = SplitPart(part, dimension, names);
    }
    nodes.Weights = WeightLattice(dimension, part.At, part.Directions);
    for (const PlaceNode& node : ListLattice(dimension))
    {
      nodes.Vertices.push_back(FindNode(part, node, names));
    }
    all.push_back(std::move(nodes));
  }
  return all;
}

/// The rows of some nodes as a dense matrix over the columns that they have.
template <typename Id>
struct NodeRows
{
  std::vector<Id> Nodes;
  std::vector<Id> Columns;     ///< ascending
  std::vector<double> Weights; ///< of all columns for the first node, for the second, ...

  void Read(const SparseRows<Id>& limits, const std::vector<Id>& nodes)
  {
    this->Nodes = nodes;
    this->Columns.clear();
    const auto forEntries = [&](const auto& use)
    {
      for (std::size_t n = 0; n < nodes.size(); ++n)
      {
        for (vtkIdType k = limits.Offsets[nodes[n]]; k < limits.Offsets[nodes[n] + 1]; ++k)
        {
          use(n, k);
        }
      }
    };
    forEntries([&](std::size_t, vtkIdType k) { this->Columns.push_back(limits.Columns[k]); });
    std::sort(this->Columns.begin(), this->Columns.end());
    this->Columns.erase(
      std::unique(this->Columns.begin(), this->Columns.end()), this->Columns.end());
    this->Weights.assign(nodes.size() * this->Columns.size(), 0.);
    forEntries(
      [&](std::size_t n, vtkIdType k)
      {
        const auto place =
          std::lower_bound(this->Columns.begin(), this->Columns.end(), limits.Columns[k]);
        this->Weights[n * this->Columns.size() +
          static_cast<std::size_t>(place - this->Columns.begin())] += limits.Weights[k];
      });
  }
};

/// Adds the rows of the nodes of each place, in threads. Consecutive places often have the same
/// nodes, whose rows are read once then.
template <typename Id>
void Combine(
  const SparseRows<Id>& limits, const std::vector<PlaceNodes<Id>>& places, PlaceRows<Id>& rows)
{
  const auto size = static_cast<vtkIdType>(places.size());
  const auto forPlaces = [&](const auto& act)
  {
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        NodeRows<Id> read;
        for (vtkIdType i = begin; i < end; ++i)
        {
          if (i == begin || read.Nodes != places[i].Vertices)
          {
            read.Read(limits, places[i].Vertices);
          }
          act(i, read);
        }
      });
  };
  Buffer<Id> offsets(size + 1);
  forPlaces([&](vtkIdType i, const NodeRows<Id>& read)
    { offsets[i] = static_cast<Id>(read.Columns.size()); });
  CountsToOffsets(offsets);
  for (SparseRows<Id>& part : rows)
  {
    part.NumberOfColumns = limits.NumberOfColumns;
    part.Offsets = Buffer<Id>(size + 1);
    CopyInThreads(offsets.data(), size + 1, part.Offsets.data());
    part.Columns = Buffer<Id>(offsets[size]);
    part.Weights = Buffer<double>(offsets[size]);
  }
  forPlaces(
    [&](vtkIdType i, const NodeRows<Id>& read)
    {
      const std::size_t columns = read.Columns.size();
      for (int p = 0; p < PlaceParts::Count; ++p)
      {
        std::copy(read.Columns.begin(), read.Columns.end(), rows[p].Columns.begin() + offsets[i]);
        double* sums = rows[p].Weights.data() + offsets[i];
        std::fill_n(sums, columns, 0.);
        for (std::size_t n = 0; n < places[i].Weights.size(); ++n)
        {
          const double weight = places[i].Weights[n][p];
          const double* from = read.Weights.data() + n * columns;
          for (std::size_t c = 0; c < columns; ++c)
          {
            sums[c] += weight * from[c];
          }
        }
      }
    });
}

/// The limits of all vertices of a level where nothing moves.
template <typename Id>
SparseRows<Id> MakeRowsThatStay(Id vertices)
{
  SparseRows<Id> rows;
  rows.NumberOfColumns = vertices;
  rows.Offsets = Buffer<Id>(vtkIdType(vertices) + 1);
  rows.Columns = Buffer<Id>(vertices);
  rows.Weights = Buffer<double>(vertices, 1.);
  ForEach(vertices, [&](vtkIdType v) { rows.Offsets[v] = rows.Columns[v] = static_cast<Id>(v); });
  rows.Offsets[vertices] = vertices;
  return rows;
}

}

template <typename Id>
template <typename LevelType>
PlaceLimits<Id>::PlaceLimits(const LevelType& level, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places)
{
  const Id vertices = level.Complex.NumberOfVertices;
  VertexNames<Id> names(vertices);
  const std::vector<PlaceNodes<Id>> nodes = FindNodes(level, creases, places, names);
  if constexpr (std::is_same<SchemeOf<LevelType>, LinearScheme<Id>>::value)
  {
    Combine(MakeRowsThatStay(vertices), nodes, this->Rows);
  }
  else
  {
    Buffer<unsigned char> wanted(vertices + static_cast<vtkIdType>(names.GetMidpoints().size()), 0);
    for (const PlaceNodes<Id>& place : InTurn(nodes))
    {
      for (const Id vertex : place.Vertices)
      {
        wanted[vertex] = 1;
      }
    }
    Combine(
      LocalLimit<Id>(level, creases, names.GetMidpoints(), wanted).BuildRows(), nodes, this->Rows);
  }
}

SUBDIVISION_COMPILE(struct PlaceLimits);
#define SUBDIVISION_PLACES(Scheme)                                                                 \
  template PlaceLimits<Scheme::Id>::PlaceLimits(const Scheme::Level&,                              \
    const SemiSharpStages<Scheme::Id>&, const std::vector<LimitPlace<Scheme::Id>>&)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_PLACES);

}
