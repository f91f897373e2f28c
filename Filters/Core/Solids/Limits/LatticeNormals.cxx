// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LatticeNormals.h"

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Complex/Simplices.h"

namespace subdivision
{
namespace
{

/// The steps to the neighbours of a vertex in a face: to which corner, and from which. Cyclic;
/// those along the edge opposite to corner k are 5 + 2 k and 8 + 2 k.
constexpr int Ways[6][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 }, { 1, 0 }, { 2, 0 }, { 2, 1 } };

}

template <typename LevelType>
typename LatticeNormals<LevelType>::Neighbours LatticeNormals<LevelType>::FindNeighbours(
  const Vertex& vertex, Id face, const Lattice& lattice) const
{
  LatticeWeights own = vertex.Weights;
  int first = 0;
  int size = 6;
  if (vertex.Dimension == 1)
  {
    own = {};
    first = 5 + 2 * 3;
    size = 4;
    for (int end = 0; end < 2; ++end)
    {
      const Id corner = this->Complex.EdgeVertices[2 * vtkIdType(vertex.Simplex) + end];
      const int place = this->Complex.VertexInFace(face, corner);
      own[place] = vertex.Weights[end];
      first -= 2 * place; // of all corners the sum is 3
    }
  }
  Neighbours around;
  for (int k = 0; k < size; ++k)
  {
    LatticeWeights other = own;
    ++other[Ways[(first + k) % 6][0]];
    --other[Ways[(first + k) % 6][1]];
    LatticeWeights between{};
    std::transform(own.begin(), own.end(), other.begin(), between.begin(),
      [](long long a, long long b) { return a + b; });
    around.Add(
      lattice.GetCurved().Find(2, face, other), lattice.GetCurved().Find(2, face, between));
  }
  return around;
}

template <typename LevelType>
void LatticeNormals<LevelType>::AddSides(
  Id face, bool isTurned, std::vector<vtkIdType>& sides) const
{
  const Id* corners = this->GetCorners(face);
  this->Solids.ForSides(face, { corners[0], corners[1], corners[2] },
    [&](vtkIdType side) { sides.push_back(isTurned ? side ^ 1 : side); });
}

/// Appends the sectors of a vertex. False: a rule is unknown.
template <typename LevelType>
bool LatticeNormals<LevelType>::AddSectors(const Vertex& vertex, const Row<Id>& faces,
  const Lattice& lattice, LatticeNormal<Id>& normal) const
{
  bool isKnown = true;
  const auto add = [&](Id face, const Neighbours& around, const SectorTangents& tangents,
                     std::vector<vtkIdType>&& sides, double sign)
  {
    Sector& sector = normal.Sectors.emplace_back();
    sector.Sides = std::move(sides);
    sector.Triangle =
      this->Solids.Count(face) > 0 ? Id(-1) : static_cast<Id>(face >> 2 * this->Steps);
    isKnown = isKnown && WriteTangents(vertex, around, tangents, sign, lattice, sector);
  };
  std::vector<vtkIdType> sides;
  const bool isOnEdge = vertex.Dimension == 1;
  const Rule rule = lattice.GetCurved().GetRule(vertex);
  if (isOnEdge && rule == Rule::Surface)
  {
    const Row<Id> pair = this->Strata.EdgeRings.GetCarriers(vertex.Simplex);
    if (pair.size() == 2 &&
      std::all_of(
        pair.begin(), pair.end(), [this](Id face) { return face >= 0 && this->IsSmooth(face); }))
    {
      double sign = 1.;
      const Neighbours around = this->Close(vertex, pair, lattice, sides, sign);
      add(
        *std::min_element(pair.begin(), pair.end()), around, this->Closed, std::move(sides), sign);
    }
    return isKnown;
  }
  for (const Id face : !isOnEdge || rule == Rule::Curve ? faces : Row<Id>{ nullptr, nullptr })
  {
    if (this->IsSmooth(face))
    {
      this->AddSides(face, false, sides);
      add(face, this->FindNeighbours(vertex, face, lattice), isOnEdge ? this->Open : this->Closed,
        std::move(sides), 1.);
      sides.clear();
    }
  }
  return isKnown;
}

/// The neighbours of a vertex on an edge around it, from the side of its first end over the first
/// of two faces, as on levels: where solids contradict each other, this chooses the side. `sign`:
/// -1 if a surface has the other one.
template <typename LevelType>
typename LatticeNormals<LevelType>::Neighbours LatticeNormals<LevelType>::Close(
  const Vertex& vertex, const Row<Id>& pair, const Lattice& lattice, std::vector<vtkIdType>& sides,
  double& sign) const
{
  const auto [first, second] = std::make_pair(pair.begin()[0], pair.begin()[1]);
  const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(vertex.Simplex);
  const bool isTurned = (this->Complex.VertexInFace(first, ends[0]) + 1) % 3 ==
    this->Complex.VertexInFace(first, ends[1]);
  Neighbours around = this->FindNeighbours(vertex, first, lattice);
  if (isTurned)
  {
    std::reverse(around.Items.begin(), around.Items.end());
    std::reverse(around.Next.begin(), around.Next.end());
  }
  const Neighbours other = this->FindNeighbours(vertex, second, lattice);
  const bool goesOn = other.Items.front() == around.Items.back();
  for (const std::size_t k : { goesOn ? 1 : 2, goesOn ? 2 : 1 })
  {
    around.Add(other.Items[k], other.Next[k]);
  }
  this->AddSides(first, isTurned, sides);
  this->AddSides(second, !goesOn, sides);
  sign = sides.empty() && (first < second ? isTurned : !goesOn) ? -1. : 1.;
  return around;
}

/// The tangents where all rules stay the same, or else those of the next level times the rows of
/// the step to it.
template <typename LevelType>
bool LatticeNormals<LevelType>::WriteTangents(const Vertex& vertex, const Neighbours& around,
  const SectorTangents& tangents, double sign, const Lattice& lattice, Sector& sector)
{
  const bool isOther = lattice.IsNextOther(vertex);
  bool isKnown = true;
  LatticeRow<Id> row;
  const auto add = [&](const Vertex& at, const Vertex& next, const std::array<double, 2>& weights)
  {
    if (!isOther)
    {
      sector.First.Add(at, weights[0]);
      sector.Second.push_back(sign * weights[1]);
      return;
    }
    isKnown = isKnown && lattice.ReadRow(next, row);
    for (std::size_t k = 0; k < row.Vertices.size(); ++k)
    {
      sector.First.Add(row.Vertices[k], weights[0] * row.Weights[k]);
      sector.Second.push_back(sign * weights[1] * row.Weights[k]);
    }
  };
  for (std::size_t j = 0; j < around.Items.size(); ++j)
  {
    add(around.Items[j], around.Next[j], tangents.Edges[j]);
  }
  tangents.Own[1] != 0. ? add(vertex, vertex.Double(), tangents.Own) : void();
  return isKnown;
}

/// The neighbours on cells and boundaries, each once, and then those in solids, which rows may
/// read. Sets the corners, or else the lines, of the star.
template <typename LevelType>
typename LatticeNormals<LevelType>::Neighbours LatticeNormals<LevelType>::FindStar(
  const Vertex& vertex, const Row<Id>& faces, const Lattice& lattice,
  LatticeNormal<Id>& normal) const
{
  VertexNumbers<Vertex> numbers;
  Neighbours star;
  const auto add = [&](const Vertex& item, const Vertex& next)
  {
    const std::size_t number = numbers.GetNumber(item);
    number == star.Items.size() ? star.Add(item, next) : void();
    return static_cast<Id>(number) - 1; // that of the vertex is not counted
  };
  add(vertex, vertex.Double());
  normal.Corners.clear();
  for (const Id face : faces)
  {
    if (this->IsCell(face) || this->Solids.Count(face) < 2)
    {
      std::vector<vtkIdType> sides;
      this->AddSides(face, false, sides);
      const vtkIdType side = sides.size() == 1 ? sides[0] : -1;
      const Id parent = side < 0 && this->IsCell(face) ? face >> 2 * this->Steps : Id(-1);
      const Neighbours around = this->FindNeighbours(vertex, face, lattice);
      const std::size_t size = around.Items.size();
      for (std::size_t k = vertex.Dimension == 1 ? 1 : 0; k < size; ++k)
      {
        const std::size_t before = k > 0 ? k - 1 : size - 1;
        const Id first = add(around.Items[before], around.Next[before]);
        normal.Corners.push_back({ { first, add(around.Items[k], around.Next[k]) }, parent, side });
      }
    }
  }
  if (normal.Corners.empty() && vertex.Dimension == 1 &&
    vertex.Simplex < this->Complex.NumberOfLineCells)
  {
    for (int end = 0; end < 2; ++end)
    {
      LatticeWeights other = vertex.Weights;
      LatticeWeights between = vertex.Double().Weights;
      ++other[end];
      --other[1 - end];
      ++between[end];
      --between[1 - end];
      const BoxSplineLattice<Id>& curved = lattice.GetCurved();
      add(curved.Find(1, vertex.Simplex, other), curved.Find(1, vertex.Simplex, between));
    }
    normal.Lines = { 0, 1 };
  }
  normal.Rows.resize(star.Items.size() - 1);
  Neighbours inSolids;
  for (const Id face : normal.Rows.empty() ? Row<Id>{ nullptr, nullptr } : faces)
  {
    for (const Id solid : this->Complex.FaceTets[face])
    {
      lattice.GetSmooth().AddStarInSolid(vertex, solid, inSolids);
    }
  }
  for (std::size_t i = 0; i < inSolids.Items.size(); ++i)
  {
    add(inSolids.Items[i], inSolids.Next[i]);
  }
  return star;
}

/// Makes the star of a vertex without sector. Where a curve goes through and no triangle is, its
/// rows are those of the level: their chord is that of the limit. False: a rule is unknown.
template <typename LevelType>
bool LatticeNormals<LevelType>::AddStar(const Vertex& vertex, const Row<Id>& faces, bool isSharp,
  Lattice& lattice, LatticeNormal<Id>& normal) const
{
  Neighbours star = this->FindStar(vertex, faces, lattice, normal);
  const std::size_t size = normal.Rows.size();
  if (size == 0)
  {
    return true;
  }
  const bool isCurve =
    !normal.Lines.empty() && !isSharp && lattice.GetCurved().GetRule(vertex) == Rule::Curve;
  if (isCurve || size > MostEdgesOfStars)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      normal.Rows[i].Add(vertex, -1.);
      normal.Rows[i].Add(star.Items[i + 1], 1.);
    }
    return true;
  }
  const bool isOther = lattice.IsNextOther(vertex);
  star = isOther ? this->FindStar(vertex.Double(), faces, lattice, normal) : std::move(star);
  std::vector<std::array<int, 2>> corners;
  for (const auto& corner : normal.Corners)
  {
    corners.push_back(
      { { static_cast<int>(corner.Ends[0]) + 1, static_cast<int>(corner.Ends[1]) + 1 } });
  }
  const int made = this->Steps + Lattice::CountLevels(star.Items[0]);
  bool isKnown = lattice.ReadStar(star, size, corners, made, normal.Rows);
  for (std::size_t i = 0; isOther && isKnown && i < size; ++i)
  {
    isKnown = lattice.StepBack(normal.Rows[i]);
  }
  return isKnown;
}

template class LatticeNormals<Level<int>>;
template class LatticeNormals<Level<long long>>;
template class LatticeNormals<TetOctLevel<int>>;
template class LatticeNormals<TetOctLevel<long long>>;

}
