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
#include "Core/Solids/TetOct/TetOctSplit.h"
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
Stencils<Id> CopyStencils(const TetOctLevel<Id>& level)
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
  copied.Strata.TakeChoices(level.Strata);
  copied.Strata.Sectors = level.Strata.Sectors;
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

/// A tetrahedron of four vertices, or an octahedron of six, opposite ones side by side.
using Solid = std::vector<vtkIdType>;

/// The same for the same octahedron, whatever the order of its vertices.
std::vector<Tuple> Normal(const Solid& solid);

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

  void SplitTet(const Solid& t);
  void SplitOct(const Solid& o);
  void Smooth();

  vtkIdType Vertices;
  std::map<Tuple, vtkIdType> Edges;
};

/// Eigenvalues by size, where they are real and not negative (orthogonal iteration).
std::vector<double> GetSpectrum(const Matrix& matrix);

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
Mesh MakeTetsAroundEdge(int n);

}

#endif
