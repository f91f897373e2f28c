// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Strata/Singularities.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/Links.h"
#include "Core/Solids/Complex/RunSimplices.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

template <typename Id>
void AddTuple(const Buffer<Id>& vertices, int size, vtkIdType index, SimplexTuples& derived)
{
  derived.Tuples[size - 1].insert(derived.Tuples[size - 1].end(), vertices.data() + size * index,
    vertices.data() + size * (index + 1));
}

bool HoldsOneDimension(unsigned char dimensions)
{
  return dimensions && !(dimensions & (dimensions - 1));
}

}

SimplexList AddTuples(const SimplexList& simplices, const SimplexTuples& tuples)
{
  SimplexList all = simplices;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const auto& ids = tuples.Tuples[dimension];
    all.Connectivity.insert(all.Connectivity.end(), ids.begin(), ids.end());
    all.Dimensions.insert(
      all.Dimensions.end(), ids.size() / (dimension + 1), static_cast<unsigned char>(dimension));
  }
  return all;
}

void SortTuples(SimplexTuples& tuples, int dimension)
{
  std::vector<vtkIdType>& ids = tuples.Tuples[dimension];
  const auto size = static_cast<std::size_t>(dimension + 1);
  std::vector<std::vector<vtkIdType>> sorted;
  for (std::size_t i = 0; i < ids.size(); i += size)
  {
    sorted.emplace_back(ids.begin() + i, ids.begin() + i + size);
  }
  std::sort(sorted.begin(), sorted.end(),
    [](std::vector<vtkIdType> a, std::vector<vtkIdType> b)
    {
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      return a < b;
    });
  auto next = ids.begin();
  for (const auto& tuple : InTurn(sorted))
  {
    next = std::copy(tuple.begin(), tuple.end(), next);
  }
}

template <typename Id>
Buffer<vtkIdType> FindSimplicesOf(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int dimension)
{
  const vtkIdType sizes[4] = { complex.NumberOfVertices, complex.NumberOfEdges,
    complex.NumberOfFaces, complex.NumberOfTets };
  Buffer<vtkIdType> simplices(sizes[dimension], -1);
  ForSimplices(complex, runs, dimension,
    [&](vtkIdType place, vtkIdType entity, bool equal)
    {
      if (!equal)
      {
        simplices[entity] = place;
      }
    });
  return simplices;
}

template <typename Id>
void DeriveEmbedded(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  bool inside, SimplexTuples& derived)
{
  const Links<Id> links(complex);
  auto isInside = [](unsigned char dimensions, const auto& place)
  {
    for (int k = 1; k <= 3; ++k)
    {
      if (dimensions == DimensionBit(k))
      {
        return place(k) == Place::Interior;
      }
    }
    return false;
  };
  ForSimplices(complex, runs, 2,
    [&](vtkIdType, vtkIdType f, bool equal)
    {
      const vtkIdType tets = complex.FaceTets[f].size();
      if (!equal && (inside ? tets == 2 : tets > 0))
      {
        AddTuple(complex.FaceVertices, 3, f, derived);
      }
    });
  ForSimplices(complex, runs, 1,
    [&](vtkIdType, vtkIdType e, bool equal)
    {
      const Id edge = static_cast<Id>(e);
      const bool isFace = links.EdgeFaces[edge].size() > 0;
      auto place = [&](int k) { return links.PlaceEdge(edge, k); };
      if (!equal && isFace && (!inside || isInside(links.EdgeDimensions(edge), place)))
      {
        AddTuple(complex.EdgeVertices, 2, e, derived);
      }
    });
  ForSimplices(complex, runs, 0,
    [&](vtkIdType, vtkIdType v, bool)
    {
      const Id vertex = static_cast<Id>(v);
      const unsigned char dimensions = links.VertexDimensions(vertex);
      auto place = [&](int k) { return links.PlaceVertex(vertex, k); };
      if (dimensions && (!inside || (HoldsOneDimension(dimensions) && isInside(dimensions, place))))
      {
        derived.Tuples[0].push_back(v);
      }
    });
}

template <typename Id>
void DeriveInterfaces(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const int* values, const std::vector<bool>& leftOut, SimplexTuples& derived)
{
  const auto tets = FindSimplicesOf(complex, runs, 3);
  const auto triangles = FindSimplicesOf(complex, runs, 2);
  for (const vtkIdType f : InTurn(complex.NumberOfFaces))
  {
    const Row<Id> sides = complex.FaceTets[f];
    const bool isLeftOut = !leftOut.empty() && leftOut[static_cast<std::size_t>(f)];
    if (sides.size() == 2 && !isLeftOut &&
      values[tets[sides.begin()[0]]] != values[tets[sides.begin()[1]]])
    {
      AddTuple(complex.FaceVertices, 3, f, derived);
    }
  }
  const Links<Id> links(complex);
  for (const vtkIdType e : InTurn(complex.NumberOfEdges))
  {
    const Row<Id> faces = links.EdgeFaces[e];
    const bool onlyTriangles = std::all_of(
      faces.begin(), faces.end(), [&](Id f) { return complex.FaceTets[f].size() == 0; });
    if (onlyTriangles && faces.size() == 2 &&
      values[triangles[faces.begin()[0]]] != values[triangles[faces.begin()[1]]])
    {
      AddTuple(complex.EdgeVertices, 2, e, derived);
    }
  }
}

template <typename Id>
std::vector<FeatureCandidate> FindFeatureCandidates(const SimplicialComplex<Id>& complex)
{
  const Links<Id> links(complex);
  std::vector<FeatureCandidate> candidates;
  for (const vtkIdType e : InTurn(complex.NumberOfEdges))
  {
    for (vtkIdType tets : { 1, 0 }) // boundary triangles of C_3, triangles of C_2
    {
      FeatureCandidate candidate{ { complex.EdgeVertices[2 * e], complex.EdgeVertices[2 * e + 1] },
        { -1, -1 } };
      int count = 0;
      for (Id face : links.EdgeFaces[e])
      {
        if (complex.FaceTets[face].size() == tets)
        {
          candidate.Opposite[std::min(count, 1)] = complex.VertexOpposite(face, static_cast<Id>(e));
          ++count;
        }
      }
      if (count == 2)
      {
        candidates.push_back(candidate);
      }
    }
  }
  return candidates;
}

bool IsFeature(const FeatureCandidate& candidate, const Coordinates& points, double degrees)
{
  const double* a = points.Values + 3 * candidate.Ends[0];
  const double* others[3] = { points.Values + 3 * candidate.Ends[1],
    points.Values + 3 * candidate.Opposite[0], points.Values + 3 * candidate.Opposite[1] };
  double sides[3][3]; // from a; divided by `scale` below, so that no square vanishes or overflows
  double scale = 0.;
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      sides[k][i] = others[k][i] - a[i];
      scale = std::max(scale, std::abs(sides[k][i]));
    }
  }
  if (!(scale > 0.) || std::isinf(scale))
  {
    return false;
  }
  double heights[2][3];
  for (int side = 0; side < 2; ++side)
  {
    double along = 0.;
    double length = 0.;
    for (int i = 0; i < 3; ++i)
    {
      along += sides[1 + side][i] / scale * (sides[0][i] / scale);
      length += sides[0][i] / scale * (sides[0][i] / scale);
    }
    for (int i = 0; i < 3; ++i)
    {
      heights[side][i] =
        sides[1 + side][i] / scale - (length > 0. ? along / length : 0.) * (sides[0][i] / scale);
    }
  }
  const double* h = heights[0];
  const double* g = heights[1];
  const double cross[3] = { h[1] * g[2] - h[2] * g[1], h[2] * g[0] - h[0] * g[2],
    h[0] * g[1] - h[1] * g[0] };
  const double sine = std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  const double cosine = -(h[0] * g[0] + h[1] * g[1] + h[2] * g[2]); // flat: heights are opposite
  if (sine == 0. && cosine == 0.)
  {
    return false; // a triangle without size has no plane
  }
  constexpr double degreesPerRadian = 57.29577951308232;
  return std::atan2(sine, cosine) * degreesPerRadian > degrees + 180. * points.Tie;
}

template <typename Id>
void FlagSimplices(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const unsigned char* flags, SingularSimplices& singular)
{
  Buffer<unsigned char>* targets[3] = { &singular.Vertices, &singular.Edges, &singular.Faces };
  const vtkIdType sizes[3] = { complex.NumberOfVertices, complex.NumberOfEdges,
    complex.NumberOfFaces };
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    Buffer<unsigned char>& target = *targets[dimension];
    ForSimplices(complex, runs, dimension,
      [&](vtkIdType place, vtkIdType entity, bool)
      {
        if (flags[place])
        {
          if (target.empty())
          {
            target = Buffer<unsigned char>(sizes[dimension], 0);
          }
          target[entity] = 1;
        }
      });
  }
}

SUBDIVISION_COMPILE_FUNCTION(FindSimplicesOf);
SUBDIVISION_COMPILE_FUNCTION(DeriveEmbedded);
SUBDIVISION_COMPILE_FUNCTION(DeriveInterfaces);
SUBDIVISION_COMPILE_FUNCTION(FindFeatureCandidates);
SUBDIVISION_COMPILE_FUNCTION(FlagSimplices);

}
