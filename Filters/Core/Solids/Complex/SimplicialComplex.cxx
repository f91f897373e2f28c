// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Complex/SimplicialComplex.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/TupleIndex.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The cells of one dimension in output order, and which of them equal an earlier one.
template <int N, typename Id>
struct CellsOfDimension
{
  Buffer<std::array<Id, N>> Vertices;
  Buffer<bool> Repeats;
};

/// How many simplices a list has of each dimension.
std::array<vtkIdType, 4> CountDimensions(const SimplexList& simplices)
{
  std::array<vtkIdType, 4> counts;
  for (std::size_t d = 0; d < counts.size(); ++d)
  {
    counts[d] = std::count(simplices.Dimensions.begin(), simplices.Dimensions.end(), d);
  }
  return counts;
}

/// `entries`: where the vertices of each simplex begin; not read if all have one dimension.
template <int N, typename Id>
CellsOfDimension<N, Id> GatherCells(
  const SimplexList& simplices, const Buffer<vtkIdType>& entries, vtkIdType count)
{
  const vtkIdType size = simplices.GetNumberOfSimplices();
  if (count == 0 || count == size)
  {
    CellsOfDimension<N, Id> all{ Buffer<std::array<Id, N>>(count), Buffer<bool>(count, false) };
    ForEach(count,
      [&](vtkIdType i)
      {
        for (int k = 0; k < N; ++k)
        {
          all.Vertices[i][k] = static_cast<Id>(simplices.Connectivity[N * i + k]);
        }
      });
    return all;
  }
  Buffer<Id> places(size + 1);
  ForEach(size, [&](vtkIdType i) { places[i] = simplices.Dimensions[i] == N - 1 ? 1 : 0; });
  CountsToOffsets(places);
  CellsOfDimension<N, Id> cells;
  cells.Vertices = Buffer<std::array<Id, N>>(places[size]);
  cells.Repeats = Buffer<bool>(places[size], false);
  ForEach(size,
    [&](vtkIdType i)
    {
      if (simplices.Dimensions[i] == N - 1)
      {
        for (int k = 0; k < N; ++k)
        {
          cells.Vertices[places[i]][k] = static_cast<Id>(simplices.Connectivity[entries[i] + k]);
        }
      }
    });
  return cells;
}

/// Returns the cells that equal no earlier one, in order, and moves the others to `equal`.
template <int N, typename Id>
Buffer<std::array<Id, N>> TakeFirsts(
  CellsOfDimension<N, Id>& cells, const TupleNumbers<Id>& numbers, EqualCells<Id>& equal)
{
  const vtkIdType size = cells.Vertices.size();
  if (numbers.Representatives.size() == numbers.Numbers.size())
  {
    return std::move(cells.Vertices); // all are different
  }
  ForEach(size,
    [&](vtkIdType i) { cells.Repeats[i] = numbers.Representatives[numbers.Numbers[i]] != i; });
  const vtkIdType firsts = std::count(cells.Repeats.begin(), cells.Repeats.end(), false);
  if (firsts == size)
  {
    return std::move(cells.Vertices);
  }
  Buffer<std::array<Id, N>> taken(firsts);
  equal.Vertices = Buffer<Id>(N * (size - firsts));
  equal.Twins = Buffer<Id>(size - firsts);
  vtkIdType repeat = 0;
  vtkIdType first = 0;
  ForEachInTurn(size,
    [&](vtkIdType i)
    {
      if (cells.Repeats[i])
      {
        std::copy(cells.Vertices[i].begin(), cells.Vertices[i].end(), &equal.Vertices[N * repeat]);
        equal.Twins[repeat++] = numbers.Numbers[i];
      }
      else
      {
        taken[first++] = cells.Vertices[i];
      }
    });
  return taken;
}

template <int N, typename Id>
Buffer<Id> Flatten(const Buffer<std::array<Id, N>>& tuples)
{
  Buffer<Id> flat(N * tuples.size());
  ForEach(tuples.size(),
    [&](vtkIdType i) { std::copy(tuples[i].begin(), tuples[i].end(), flat.data() + N * i); });
  return flat;
}

/// Tetrahedra: the distinct ones in order.
template <typename Id>
void BuildTets(SimplicialComplex<Id>& complex, CellsOfDimension<4, Id>& cells)
{
  Buffer<std::array<Id, 4>> tuples(cells.Vertices.size());
  ForEach(
    tuples.size(), [&](vtkIdType i) { tuples[i] = SortedTuple<4>(cells.Vertices[i].data()); });
  const auto numbers = NumberTuples<4>(tuples, complex.NumberOfVertices, tuples.size());
  complex.TetVertices = Flatten<4>(TakeFirsts<4>(cells, numbers, complex.EqualTets));
  complex.NumberOfTets = static_cast<Id>(complex.TetVertices.size() / 4);
}

/// Faces: the triangle cells, then the other faces of tetrahedra.
template <typename Id>
void BuildFaces(SimplicialComplex<Id>& complex, CellsOfDimension<3, Id>& cells)
{
  const vtkIdType leading = cells.Vertices.size();
  Buffer<std::array<Id, 3>> tuples(leading + 4 * static_cast<vtkIdType>(complex.NumberOfTets));
  ForEach(leading, [&](vtkIdType i) { tuples[i] = SortedTuple<3>(cells.Vertices[i].data()); });
  ForEach(complex.NumberOfTets,
    [&](vtkIdType t)
    {
      const Id* tet = complex.TetVertices.data() + 4 * t;
      for (int face = 0; face < 4; ++face)
      {
        const int* local = tetrahedron::FaceVertices[face];
        const Id vertices[3] = { tet[local[0]], tet[local[1]], tet[local[2]] };
        tuples[leading + 4 * t + face] = SortedTuple<3>(vertices);
      }
    });
  const auto numbers = NumberTuples<3>(tuples, complex.NumberOfVertices, leading);
  const auto firsts = TakeFirsts<3>(cells, numbers, complex.EqualTriangles);
  complex.NumberOfTriangleCells = static_cast<Id>(firsts.size());
  complex.NumberOfFaces = static_cast<Id>(numbers.Representatives.size());
  complex.FaceVertices = Buffer<Id>(3 * numbers.Representatives.size());
  ForEach(complex.NumberOfFaces,
    [&](vtkIdType f)
    {
      const auto& face = f < firsts.size() ? firsts[f] : tuples[numbers.Representatives[f]];
      std::copy(face.begin(), face.end(), complex.FaceVertices.data() + 3 * f);
    });
  complex.TetFaces = Buffer<Id>(4 * static_cast<vtkIdType>(complex.NumberOfTets));
  ForEach(complex.TetFaces.size(),
    [&](vtkIdType i) { complex.TetFaces[i] = numbers.Numbers[leading + i]; });
}

/// Edges: the line cells, then the other edges of faces.
template <typename Id>
void BuildEdges(SimplicialComplex<Id>& complex, CellsOfDimension<2, Id>& cells)
{
  const vtkIdType leading = cells.Vertices.size();
  Buffer<std::array<Id, 2>> tuples(leading + 3 * static_cast<vtkIdType>(complex.NumberOfFaces));
  ForEach(leading, [&](vtkIdType i) { tuples[i] = SortedTuple<2>(cells.Vertices[i].data()); });
  ForEach(complex.NumberOfFaces,
    [&](vtkIdType f)
    {
      const Id* face = complex.FaceVertices.data() + 3 * f;
      for (int edge = 0; edge < 3; ++edge)
      {
        const int* local = triangle::EdgeVertices[edge];
        const Id vertices[2] = { face[local[0]], face[local[1]] };
        tuples[leading + 3 * f + edge] = SortedTuple<2>(vertices);
      }
    });
  const auto numbers = NumberTuples<2>(tuples, complex.NumberOfVertices, leading);
  const auto firsts = TakeFirsts<2>(cells, numbers, complex.EqualLines);
  complex.NumberOfLineCells = static_cast<Id>(firsts.size());
  complex.NumberOfEdges = static_cast<Id>(numbers.Representatives.size());
  complex.EdgeVertices = Buffer<Id>(2 * numbers.Representatives.size());
  ForEach(complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      const auto& edge = e < firsts.size() ? firsts[e] : tuples[numbers.Representatives[e]];
      std::copy(edge.begin(), edge.end(), complex.EdgeVertices.data() + 2 * e);
    });
  complex.FaceEdges = Buffer<Id>(3 * static_cast<vtkIdType>(complex.NumberOfFaces));
  ForEach(complex.FaceEdges.size(),
    [&](vtkIdType i) { complex.FaceEdges[i] = numbers.Numbers[leading + i]; });
}

/// The edges of a tetrahedron, found in the two faces that hold each.
template <typename Id>
void FindTetEdges(SimplicialComplex<Id>& complex)
{
  complex.TetEdges = Buffer<Id>(6 * static_cast<vtkIdType>(complex.NumberOfTets));
  ForEach(complex.NumberOfTets,
    [&](vtkIdType t)
    {
      const Id* tet = complex.TetVertices.data() + 4 * t;
      for (int edge = 0; edge < 6; ++edge)
      {
        const int outside = tetrahedron::EdgeVertices[tetrahedron::OppositeEdge(edge)][0];
        const Id face = complex.TetFaces[4 * t + outside];
        const Id opposite = tet[tetrahedron::EdgeVertices[tetrahedron::OppositeEdge(edge)][1]];
        complex.TetEdges[6 * t + edge] =
          complex
            .FaceEdges[3 * face + triangle::EdgeOpposite[complex.VertexInFace(face, opposite)]];
      }
    });
}

template <typename Id>
void FindFaceTets(SimplicialComplex<Id>& complex)
{
  complex.FaceTets = ListByRow<Id>(
    complex.NumberOfFaces, complex.TetFaces.size(), [&](vtkIdType i)
    { return complex.TetFaces[i]; }, [](vtkIdType i) { return static_cast<Id>(i / 4); });
}

/// Makes the runs of the output: each has one dimension, and either followers only or none.
template <typename Id>
std::vector<CellRun> MakeRuns(const SimplexList& simplices, const CellsOfDimension<1, Id>& vertices,
  const CellsOfDimension<2, Id>& lines, const CellsOfDimension<3, Id>& triangles,
  const CellsOfDimension<4, Id>& tets)
{
  const Buffer<bool>* repeats[4] = { &vertices.Repeats, &lines.Repeats, &triangles.Repeats,
    &tets.Repeats };
  vtkIdType seen[4] = { 0, 0, 0, 0 };
  vtkIdType next[4][2] = {};
  vtkIdType entry = 0;
  std::vector<CellRun> runs;
  const int first = simplices.Dimensions.empty() ? 0 : simplices.Dimensions[0];
  const Buffer<bool>& ofFirst = *repeats[first];
  if (ofFirst.size() == simplices.GetNumberOfSimplices() &&
    std::count(ofFirst.begin(), ofFirst.end(), true) == 0)
  {
    runs.resize(simplices.Dimensions.empty() ? 0 : 1, { first, false, 0, ofFirst.size(), 0, 0 });
    return runs;
  }
  ForEachInTurn(simplices.GetNumberOfSimplices(),
    [&](vtkIdType i)
    {
      const int dimension = simplices.Dimensions[i];
      const bool equal = (*repeats[dimension])[seen[dimension]++];
      if (runs.empty() || runs.back().Dimension != dimension || runs.back().Equal != equal)
      {
        runs.push_back({ dimension, equal, next[dimension][equal], 0, i, entry });
      }
      ++runs.back().Count;
      ++next[dimension][equal];
      entry += dimension + 1;
    });
  return runs;
}

}

template <typename Id>
SimplicialComplex<Id> BuildComplex(const SimplexList& simplices, std::vector<CellRun>& runs)
{
  const vtkIdType size = simplices.GetNumberOfSimplices();
  const std::array<vtkIdType, 4> counts = CountDimensions(simplices);
  Buffer<vtkIdType> entries;
  if (*std::max_element(counts.begin(), counts.end()) < size)
  {
    entries = Buffer<vtkIdType>(size + 1);
    ForEach(size, [&](vtkIdType i) { entries[i] = simplices.Dimensions[i] + 1; });
    CountsToOffsets(entries);
  }
  const auto vertices = GatherCells<1, Id>(simplices, entries, counts[0]);
  auto lines = GatherCells<2, Id>(simplices, entries, counts[1]);
  auto triangles = GatherCells<3, Id>(simplices, entries, counts[2]);
  auto tets = GatherCells<4, Id>(simplices, entries, counts[3]);

  SimplicialComplex<Id> complex;
  complex.NumberOfVertices = static_cast<Id>(simplices.NumberOfPoints);
  complex.VertexCells = Flatten<1>(vertices.Vertices);
  BuildTets(complex, tets);
  BuildFaces(complex, triangles);
  BuildEdges(complex, lines);
  FindTetEdges(complex);
  FindFaceTets(complex);
  runs = MakeRuns(simplices, vertices, lines, triangles, tets);
  return complex;
}

template <typename Id>
Buffer<unsigned char> FindManifoldDimensions(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs)
{
  // What no cell of the output has is not looked at.
  const auto has = [&runs](int dimension)
  {
    return std::any_of(runs.begin(), runs.end(),
      [dimension](const CellRun& run) { return run.Dimension == dimension; });
  };
  const bool hasVertices = has(0);
  const bool hasEdges = hasVertices || has(1);
  Buffer<unsigned char> vertices(hasVertices ? complex.NumberOfVertices : 0, 0);
  Buffer<unsigned char> edges(hasEdges ? complex.NumberOfEdges : 0, 1);
  auto faceDimension = [&](vtkIdType f)
  { return static_cast<unsigned char>(complex.FaceTets[f].size() > 0 ? 3 : 2); };
  ForEachInTurn(hasEdges ? complex.FaceEdges.size() : 0,
    [&](vtkIdType i)
    {
      unsigned char& edge = edges[complex.FaceEdges[i]];
      edge = std::max(edge, faceDimension(i / 3));
    });
  ForEachInTurn(hasVertices ? complex.EdgeVertices.size() : 0,
    [&](vtkIdType i)
    {
      unsigned char& vertex = vertices[complex.EdgeVertices[i]];
      vertex = std::max(vertex, edges[i / 2]);
    });
  const CellRun last = runs.empty() ? CellRun() : runs.back();
  Buffer<unsigned char> dimensions(last.FirstCell + last.Count);
  for (const CellRun& run : runs)
  {
    ForEach(run.Count,
      [&](vtkIdType k)
      {
        const vtkIdType i = run.First + k;
        unsigned char& dimension = dimensions[run.FirstCell + k];
        switch (run.Dimension)
        {
          case 0:
            dimension = vertices[complex.VertexCells[i]];
            break;
          case 1:
            dimension = edges[run.Equal ? complex.EqualLines.Twins[i] : i];
            break;
          case 2:
            dimension = faceDimension(run.Equal ? complex.EqualTriangles.Twins[i] : i);
            break;
          default:
            dimension = 3;
            break;
        }
      });
  }
  return dimensions;
}

SUBDIVISION_COMPILE_FUNCTION(FindManifoldDimensions);
SUBDIVISION_COMPILE_FUNCTION(BuildComplex);

}
