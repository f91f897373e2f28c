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

namespace tetoct_tools
{

using namespace coretest;
using coretest::CopyStencils;

template <typename Id>
using TetOctMesh = LevelOfCells<TetOctLevel<Id>>;

template <typename Id>
TetOctMesh<Id> BuildTetOct(const SimplexList& cells, const std::set<Tuple>& singular = {},
  const StrataOptions& options = StrataOptions())
{
  Subdivided<Id> control = Build<Id>(cells, singular, options);
  return { MakeTetOctLevel(std::move(control.Level)), control.Runs };
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
  TetOctLevel<Id> copied = CopyForStencils(level);
  copied.OctVertices = CopyBuffer(level.OctVertices);
  copied.TetsAtSpokes = level.TetsAtSpokes;
  copied.NumberOfControlVertices = level.NumberOfControlVertices;
  return TakeStencils(copied);
}

/// The schemes of typed tests.
struct OfBoxSpline
{
  template <typename Id>
  using Split = BoxSplineSplit<Id>;
  template <typename Id = int>
  static Subdivided<Id> Make(const Mesh& mesh, const StrataOptions& options = StrataOptions())
  {
    return Build<Id>(mesh.Cells, mesh.Singular, options);
  }
};
struct OfTetOct
{
  template <typename Id>
  using Split = TetOctSplit<Id>;
  template <typename Id = int>
  static TetOctMesh<Id> Make(const Mesh& mesh, const StrataOptions& options = StrataOptions())
  {
    return BuildTetOct<Id>(mesh.Cells, mesh.Singular, options);
  }
};

/// Points of each level.
template <typename Scheme, typename Id = int, typename T>
std::vector<std::vector<T>> SubdividePoints(
  const Mesh& mesh, const std::vector<T>& points, int components, int levels)
{
  auto level = Scheme::template Make<Id>(mesh);
  std::vector<std::vector<T>> all = { points };
  for (int step = 0; step < levels; ++step)
  {
    const Stencils<Id> stencils = CopyStencils(level.Level);
    std::vector<T> next(stencils.GetNumberOfRows() * components);
    stencils.Apply(all.back().data(), next.data(), components);
    all.push_back(next);
    if (step + 1 < levels)
    {
      level = RefineOnce(level, step + 2 < levels ? Depth::ForRefinement : Depth::ForOutput);
    }
  }
  return all;
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
