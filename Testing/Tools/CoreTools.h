// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoreTools.h
 * Small meshes of ordered simplices, their levels, and the operator as a dense matrix.
 */
#ifndef SubdivisionObjects_CoreTools_h
#define SubdivisionObjects_CoreTools_h

#include "Precompiled.h"

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/BoxSpline/Refinement.h"
#include "Core/Solids/Complex/TetOrder.h"

#include <initializer_list>

namespace coretest
{

using namespace subdivision;

/// Vertices of a simplex, smallest first.
using Tuple = std::vector<vtkIdType>;

inline Tuple Sorted(Tuple tuple)
{
  std::sort(tuple.begin(), tuple.end());
  return tuple;
}

/// A control mesh: cells in output order, points, and which simplices are singular.
struct Mesh
{
  std::string Name;
  SimplexList Cells;
  std::vector<double> Points; ///< three for each
  std::set<Tuple> Singular;

  explicit Mesh(std::string name = std::string())
    : Name(std::move(name))
  {
  }
  vtkIdType AddPoint(double x, double y, double z);
  void AddPoints(std::initializer_list<std::array<double, 3>> points);
  void AddCell(const Tuple& vertices)
  {
    this->Cells.Dimensions.push_back(static_cast<unsigned char>(vertices.size() - 1));
    this->Cells.Connectivity.insert(
      this->Cells.Connectivity.end(), vertices.begin(), vertices.end());
  }
  void AddCells(std::initializer_list<Tuple> cells);
};

/// The cells of a list one by one, in their own vertex order.
std::vector<Tuple> GetCells(const SimplexList& list);

template <typename Id>
SingularSimplices FlagSingular(
  const SimplicialComplex<Id>& complex, const std::set<Tuple>& singular)
{
  SingularSimplices flags;
  if (singular.empty())
  {
    return flags;
  }
  auto flag = [&](Buffer<unsigned char>& out, const Buffer<Id>& vertices, int corners, Id size)
  {
    out = Buffer<unsigned char>(size, 0);
    for (Id i = 0; i < size; ++i)
    {
      const Id* first = vertices.data() + corners * vtkIdType(i);
      out[i] = singular.count(Sorted(Tuple(first, first + corners))) > 0;
    }
  };
  Buffer<Id> all(complex.NumberOfVertices);
  for (Id v = 0; v < complex.NumberOfVertices; ++v)
  {
    all[v] = v;
  }
  flag(flags.Vertices, all, 1, complex.NumberOfVertices);
  flag(flags.Edges, complex.EdgeVertices, 2, complex.NumberOfEdges);
  flag(flags.Faces, complex.FaceVertices, 3, complex.NumberOfFaces);
  return flags;
}

/// A level of any scheme and the order of its cells.
template <typename AnyLevel>
struct LevelOfCells
{
  AnyLevel Level;
  std::vector<CellRun> Runs;
};

template <typename Id>
using Subdivided = LevelOfCells<Level<Id>>;

template <typename Id>
Subdivided<Id> Build(const SimplexList& cells, const std::set<Tuple>& singular = {},
  const StrataOptions& options = StrataOptions())
{
  Subdivided<Id> built;
  built.Level.Complex = BuildComplex<Id>(cells, built.Runs);
  built.Level.Strata =
    BuildStrata(built.Level.Complex, FlagSingular(built.Level.Complex, singular), options);
  return built;
}

template <typename AnyLevel>
LevelOfCells<AnyLevel> RefineOnce(
  const LevelOfCells<AnyLevel>& parent, Depth depth = Depth::ForRefinement)
{
  return { Refine(parent.Level, depth), RefineRuns(parent.Runs, 1) };
}

/// Room for cells that are written, and the list that they make.
class WrittenCells
{
public:
  explicit WrittenCells(const CellCounts& counts)
    : Connectivity(counts.Entries, -1)
    , Offsets(counts.Cells + 1, -1)
    , Types(counts.Cells, 0)
  {
  }
  CellStorage<long long> GetStorage()
  {
    return { this->Connectivity.data(), this->Offsets.data(), this->Types.data() };
  }
  /// Dimensions are read from the offsets, so that these are tested too.
  SimplexList ToList(vtkIdType numberOfPoints) const;

  std::vector<long long> Connectivity;
  std::vector<long long> Offsets;
  std::vector<unsigned char> Types;
};

template <typename Id>
SimplexList ReadCells(const Subdivided<Id>& level)
{
  WrittenCells written(CountCells(level.Runs));
  WriteCells(level.Level.Complex, level.Runs, written.GetStorage());
  return written.ToList(level.Level.Complex.NumberOfVertices);
}

template <typename Id>
SimplexList ReadChildren(const Subdivided<Id>& level)
{
  WrittenCells written(CountCells(RefineRuns(level.Runs, 1)));
  WriteChildren(level.Level.Complex, level.Runs, written.GetStorage());
  return written.ToList(
    vtkIdType(level.Level.Complex.NumberOfVertices) + level.Level.Complex.NumberOfEdges);
}

template <typename T>
T CopyBuffer(const T& from)
{
  T to(from.size());
  std::copy(from.begin(), from.end(), to.begin());
  return to;
}

/// What makes the operator of a level, where there are no octahedra.
template <typename AnyLevel>
AnyLevel CopyForStencils(const AnyLevel& level)
{
  AnyLevel copied;
  copied.Complex.EdgeVertices = CopyBuffer(level.Complex.EdgeVertices);
  copied.Strata.TakeChoices(level.Strata);
  copied.Strata.Sectors = level.Strata.Sectors;
  copied.Strata.Vertices = CopyBuffer(level.Strata.Vertices);
  copied.Strata.Edges = CopyBuffer(level.Strata.Edges);
  copied.Strata.VertexRings.Offsets = CopyBuffer(level.Strata.VertexRings.Offsets);
  copied.Strata.VertexRings.Members = CopyBuffer(level.Strata.VertexRings.Members);
  copied.Strata.EdgeRings.Offsets = CopyBuffer(level.Strata.EdgeRings.Offsets);
  copied.Strata.EdgeRings.Members = CopyBuffer(level.Strata.EdgeRings.Members);
  return copied;
}

/// A copy of a level's operator; the level stays whole.
template <typename Id>
Stencils<Id> CopyStencils(const Level<Id>& level)
{
  Level<Id> copied = CopyForStencils(level);
  return TakeStencils(copied);
}

/// Rows of the operator, one column for each vertex: what it makes of unit impulses.
using Matrix = std::vector<std::vector<double>>;

template <typename Id>
Matrix MakeMatrix(const Stencils<Id>& stencils)
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

/// The number of an edge, -1 if there is none.
template <typename Id>
Id FindEdge(const SimplicialComplex<Id>& complex, vtkIdType a, vtkIdType b)
{
  for (Id e = 0; e < complex.NumberOfEdges; ++e)
  {
    const Id* ends = complex.EdgeVertices.data() + 2 * vtkIdType(e);
    if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
    {
      return e;
    }
  }
  return -1;
}

template <typename Id>
Tuple GetRing(const Rings<Id>& rings, vtkIdType i)
{
  const Row<Id> row = rings.GetMembers(i);
  return Sorted(Tuple(row.begin(), row.end()));
}

/// Children of singular simplices are singular.
template <typename Id>
std::set<Tuple> RefineSingular(const SimplicialComplex<Id>& parent, const std::set<Tuple>& singular)
{
  std::set<Tuple> refined;
  auto middle = [&](vtkIdType a, vtkIdType b)
  { return vtkIdType(parent.NumberOfVertices) + FindEdge(parent, a, b); };
  for (const Tuple& s : singular)
  {
    if (s.size() == 1)
    {
      refined.insert(s);
    }
    else if (s.size() == 2)
    {
      const vtkIdType m = middle(s[0], s[1]);
      refined.insert(Sorted({ s[0], m }));
      refined.insert(Sorted({ s[1], m }));
    }
    else
    {
      const vtkIdType m[3] = { middle(s[1], s[2]), middle(s[2], s[0]), middle(s[0], s[1]) };
      refined.insert(Sorted({ m[0], m[1], m[2] }));
      for (int i = 0; i < 3; ++i)
      {
        refined.insert(Sorted({ s[i], m[(i + 1) % 3], m[(i + 2) % 3] }));
      }
    }
  }
  return refined;
}

}

#endif
