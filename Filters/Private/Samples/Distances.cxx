// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/Distances.h"

#include "Private/Samples/SolidFaces.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

Distances::Distances(const std::vector<SampledMesh>& meshes, const SampleOptions& options)
  : Meshes(meshes)
  , Options(options)
{
  for (const SolidFace& face : InTurn(*options.Outside))
  {
    this->Parts.push_back({ { face.Mesh, &face.Triangle }, 2, true });
  }
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const auto pieces = ListPieces(meshes, dimension);
    for (const ListedPiece& piece : InTurn(pieces))
    {
      this->Parts.push_back({ piece, dimension, false });
    }
  }
  this->Lists =
    std::make_unique<SlabLists>(options.Grid, static_cast<vtkIdType>(this->Parts.size()),
      [&](vtkIdType i)
      {
        return FindReach(this->GetNodesOf(this->Parts[i]), this->Parts[i].Dimension, options.Band);
      });
}

std::array<Place, 10> Distances::GetNodesOf(const Part& part) const
{
  return GetNodes(this->Meshes[part.Piece.Mesh].Mesh, *part.Piece.Piece, part.Dimension);
}

void Distances::Approach(
  const Part& part, const SampleGrid& slab, std::vector<double>& squares) const
{
  const auto nodes = this->GetNodesOf(part);
  // Boxes around parts that are larger than the band have many samples that are far away.
  const int halvings =
    std::max(CountHalvings(FindBend(nodes, part.Dimension), this->Options.Tolerance, 4.),
      CountHalvings(
        FindSize(nodes, part.Dimension, { { 1., 1., 1. } }), 4. * this->Options.Band, 2.));
  ForSamplesNear(slab, nodes, part.Dimension, halvings, this->Options.Band,
    [&squares](int, int, int, vtkIdType sample, const StraightPart&, const NearestPoint& nearest)
    { squares[sample] = std::min(squares[sample], nearest.Square); });
}

void Distances::WriteSlab(vtkIdType number, float* distances) const
{
  const SampleGrid slab = GetSlab(this->Options.Grid, number);
  const double band = this->Options.Band;
  std::array<std::vector<double>, 2> squares; // from the outside of solids, and from others
  squares.fill(std::vector<double>(CountSamplesOf(slab), band * band));
  this->Lists->ForNumbers(number, [&](vtkIdType i)
    { this->Approach(this->Parts[i], slab, squares[this->Parts[i].IsOutside ? 0 : 1]); });
  const vtkIdType begin = GetBegin(this->Options.Grid, slab);
  for (std::size_t s = 0; s < squares[0].size(); ++s)
  {
    float& distance = distances[begin + static_cast<vtkIdType>(s)];
    const auto other = static_cast<float>(std::sqrt(squares[1][s]));
    distance = std::copysign(static_cast<float>(std::sqrt(squares[0][s])), distance);
    if (this->Options.Others)
    {
      (*this->Options.Others)[begin + s] = other;
    }
    else
    {
      distance = Unite(distance, other);
    }
  }
}

}
