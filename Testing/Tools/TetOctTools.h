// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctTools.h
 * Tet/oct levels of small meshes, and Mathematics 10 done slowly, cell by cell, to compare with.
 */
#ifndef SubdivisionObjects_TetOctTools_h
#define SubdivisionObjects_TetOctTools_h

#include "CoreZoo.h"

#include "Core/Solids/TetOct/TetOctCells.h"
#include "Core/Solids/TetOct/TetOctComplex.h"
#include "Core/Solids/TetOct/TetOctStencils.h"
#include "Core/Solids/TetOct/TetOctTables.h"

#include <map>

namespace tetoct_tools
{

using namespace coretest;

template <typename Id>
struct TetOctMesh
{
  TetOctLevel<Id> Level;
  std::vector<CellRun> Runs;
};

template <typename Id>
TetOctMesh<Id> BuildTetOct(const SimplexList& cells, const std::set<Tuple>& singular = {},
  const StrataOptions& options = StrataOptions())
{
  Subdivided<Id> control = Build<Id>(cells, singular, options);
  return { MakeTetOctLevel(std::move(control.Level)), control.Runs };
}

template <typename Id>
TetOctMesh<Id> RefineOnce(const TetOctMesh<Id>& parent, Depth depth = Depth::ForRefinement)
{
  return { Refine(parent.Level, depth), RefineRuns(parent.Runs, 1) };
}

template <typename Id>
TetOctMesh<Id> BuildTetOctAt(const Mesh& mesh, int steps)
{
  TetOctMesh<Id> built = BuildTetOct<Id>(mesh.Cells, mesh.Singular);
  for (int i = 0; i < steps; ++i)
  {
    built = RefineOnce(built);
  }
  return built;
}

/// A copy of a level's operator; the level stays whole.
template <typename Id>
TetOctStencils<Id> CopyStencils(const TetOctLevel<Id>& level)
{
  auto copy = [](const auto& from)
  {
    std::decay_t<decltype(from)> to(from.size());
    std::copy(from.begin(), from.end(), to.begin());
    return to;
  };
  TetOctLevel<Id> copied;
  copied.Complex.EdgeVertices = copy(level.Complex.EdgeVertices);
  copied.OctVertices = copy(level.OctVertices);
  copied.Strata.Vertices = copy(level.Strata.Vertices);
  copied.Strata.Edges = copy(level.Strata.Edges);
  copied.Strata.VertexRings.Offsets = copy(level.Strata.VertexRings.Offsets);
  copied.Strata.VertexRings.Members = copy(level.Strata.VertexRings.Members);
  copied.Strata.EdgeRings.Offsets = copy(level.Strata.EdgeRings.Offsets);
  copied.Strata.EdgeRings.Members = copy(level.Strata.EdgeRings.Members);
  copied.TetsAtSpokes = level.TetsAtSpokes;
  copied.NumberOfControlVertices = level.NumberOfControlVertices;
  return TakeStencils(copied);
}

template <typename Id>
Matrix MakeMatrix(const TetOctStencils<Id>& stencils)
{
  const vtkIdType columns = stencils.GetNumberOfColumns();
  std::vector<double> impulses(columns * columns, 0.);
  for (vtkIdType i = 0; i < columns; ++i)
  {
    impulses[i * columns + i] = 1.;
  }
  std::vector<double> result(stencils.GetNumberOfRows() * columns);
  stencils.Apply(impulses.data(), result.data(), static_cast<int>(columns));
  Matrix matrix;
  for (vtkIdType row = 0; row < stencils.GetNumberOfRows(); ++row)
  {
    matrix.emplace_back(result.data() + row * columns, result.data() + (row + 1) * columns);
  }
  return matrix;
}

/// A tetrahedron of four vertices, or an octahedron of six, opposite ones side by side.
using Solid = std::vector<vtkIdType>;

/// The same for the same octahedron, whatever the order of its vertices.
inline std::vector<Tuple> Normal(const Solid& solid)
{
  if (solid.size() == 4)
  {
    return { Sorted(solid) };
  }
  std::vector<Tuple> pairs;
  for (int pair = 0; pair < 3; ++pair)
  {
    pairs.push_back(Sorted({ solid[2 * pair], solid[2 * pair + 1] }));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <typename Id>
std::vector<Solid> GetSolids(const TetOctLevel<Id>& level)
{
  std::vector<Solid> solids;
  for (vtkIdType t = 0; t < level.Complex.NumberOfTets; ++t)
  {
    const Id* v = level.Complex.TetVertices.data() + 4 * t;
    solids.emplace_back(v, v + 4);
  }
  for (vtkIdType o = 0; o < level.NumberOfOctahedra; ++o)
  {
    const Id* v = level.OctVertices.data() + 6 * o;
    solids.emplace_back(v, v + 6);
  }
  return solids;
}

/// One step after the book: all solids are split, all points linear, then centroids are averaged.
class SlowStep
{
public:
  template <typename Id>
  explicit SlowStep(const TetOctLevel<Id>& level)
    : Vertices(level.Complex.NumberOfVertices)
  {
    for (vtkIdType v = 0; v < this->Vertices; ++v)
    {
      this->Linear.push_back({ { v, 1. } });
    }
    for (vtkIdType e = 0; e < level.Complex.NumberOfEdges; ++e)
    {
      const Id* ends = level.Complex.EdgeVertices.data() + 2 * e;
      this->Edges[Sorted({ ends[0], ends[1] })] = this->Vertices + e;
      this->Linear.push_back({ { ends[0], 0.5 }, { ends[1], 0.5 } });
    }
    for (const Solid& solid : GetSolids(level))
    {
      solid.size() == 4 ? this->SplitTet(solid) : this->SplitOct(solid);
    }
    this->Smooth();
  }

  using WeightedRow = std::map<vtkIdType, double>;
  std::vector<Solid> Children;
  std::vector<WeightedRow> Linear;
  std::vector<WeightedRow> Smoothed; ///< empty where no solid is

private:
  vtkIdType Middle(vtkIdType a, vtkIdType b) const { return this->Edges.at(Sorted({ a, b })); }

  void SplitTet(const Solid& t)
  {
    for (vtkIdType a : t)
    {
      Solid child = { a };
      for (vtkIdType b : t)
      {
        if (a != b)
        {
          child.push_back(this->Middle(a, b));
        }
      }
      this->Children.push_back(child);
    }
    this->Children.push_back(
      { this->Middle(t[0], t[1]), this->Middle(t[2], t[3]), this->Middle(t[0], t[2]),
        this->Middle(t[1], t[3]), this->Middle(t[0], t[3]), this->Middle(t[1], t[2]) });
  }

  void SplitOct(const Solid& o)
  {
    const vtkIdType centre = static_cast<vtkIdType>(this->Linear.size());
    WeightedRow mean;
    for (vtkIdType v : o)
    {
      mean[v] = 1. / 6.;
    }
    this->Linear.push_back(mean);
    for (int v = 0; v < 6; ++v)
    {
      Solid child = { o[v], centre };
      for (int w = 0; w < 6; ++w)
      {
        if (w / 2 != v / 2)
        {
          child.push_back(this->Middle(o[v], o[w]));
        }
      }
      this->Children.push_back(child);
    }
    for (int k = 0; k < 8; ++k)
    {
      const vtkIdType a = o[k % 2];
      const vtkIdType b = o[2 + k / 2 % 2];
      const vtkIdType c = o[4 + k / 4];
      this->Children.push_back(
        { centre, this->Middle(a, b), this->Middle(b, c), this->Middle(c, a) });
    }
  }

  void Smooth()
  {
    std::vector<WeightedRow> sums(this->Linear.size());
    std::vector<double> cells(this->Linear.size(), 0.);
    for (const Solid& child : this->Children)
    {
      for (std::size_t i = 0; i < child.size(); ++i)
      {
        cells[child[i]] += 1.;
        for (std::size_t j = 0; j < child.size(); ++j)
        {
          const double weight = child.size() == 4 ? (i == j ? -1. / 16 : 17. / 48)
            : i == j                              ? 3. / 8
            : i / 2 == j / 2                      ? 7. / 24
                                                  : 1. / 12;
          sums[child[i]][child[j]] += weight;
        }
      }
    }
    this->Smoothed.resize(sums.size());
    for (std::size_t v = 0; v < sums.size(); ++v)
    {
      for (const auto& term : sums[v])
      {
        for (const auto& part : this->Linear[term.first])
        {
          this->Smoothed[v][part.first] += term.second / cells[v] * part.second;
        }
      }
    }
  }

  vtkIdType Vertices;
  std::map<Tuple, vtkIdType> Edges;
};

/// Eigenvalues by size, where they are real and not negative (orthogonal iteration).
inline std::vector<double> GetSpectrum(const Matrix& matrix)
{
  const std::size_t n = matrix.size();
  Matrix q(n, std::vector<double>(n, 0.)); // columns as rows
  std::mt19937 random(1);
  for (auto& column : q)
  {
    std::generate(column.begin(), column.end(), [&random] { return random() / 4294967296. - 0.5; });
  }
  std::vector<double> sizes(n);
  for (int iteration = 0; iteration < 3000; ++iteration)
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      std::vector<double> image(n, 0.);
      for (std::size_t i = 0; i < n; ++i)
      {
        image[i] = std::inner_product(matrix[i].begin(), matrix[i].end(), q[k].begin(), 0.);
      }
      for (int twice = 0; twice < 2; ++twice)
      {
        for (std::size_t j = 0; j < k; ++j)
        {
          const double dot = std::inner_product(image.begin(), image.end(), q[j].begin(), 0.);
          for (std::size_t i = 0; i < n; ++i)
          {
            image[i] -= dot * q[j][i];
          }
        }
      }
      sizes[k] = std::sqrt(std::inner_product(image.begin(), image.end(), image.begin(), 0.));
      for (std::size_t i = 0; i < n; ++i)
      {
        q[k][i] = image[i] / std::max(sizes[k], 1e-300);
      }
    }
  }
  std::sort(sizes.begin(), sizes.end(), std::greater<double>());
  return sizes;
}

/// The local matrix of a vertex: what its ring becomes of its ring.
template <typename Id>
Matrix GetLocalMatrix(const TetOctMesh<Id>& mesh, vtkIdType vertex)
{
  const TetOctMesh<Id> next = RefineOnce(mesh);
  auto around = [vertex](const TetOctLevel<Id>& level)
  {
    Tuple all = { vertex };
    const Row<Id> ring = level.Strata.VertexRings.GetMembers(vertex);
    all.insert(all.end(), ring.begin(), ring.end());
    return all;
  };
  const Tuple columns = around(mesh.Level);
  const Matrix all = MakeMatrix(CopyStencils(mesh.Level));
  Matrix local;
  for (vtkIdType row : around(next.Level))
  {
    local.emplace_back();
    for (vtkIdType column : columns)
    {
      local.back().push_back(all[row][column]);
    }
  }
  return local;
}

/// n tetrahedra around the edge 0 1.
inline Mesh MakeTetsAroundEdge(int n)
{
  Mesh mesh("TetsAroundEdge" + std::to_string(n));
  mesh.AddPoints({ { 0, 0, 1 }, { 0, 0, -1 } });
  for (int i = 0; i < n; ++i)
  {
    const double t = 6.283185307179586 * i / n;
    mesh.AddPoint(std::cos(t), std::sin(t), 0.);
  }
  for (int i = 0; i < n; ++i)
  {
    mesh.AddCell({ 0, 1, 2 + i, 2 + (i + 1) % n });
  }
  return mesh;
}

}

#endif
