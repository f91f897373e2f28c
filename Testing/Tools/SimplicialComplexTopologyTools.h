// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplicialComplexTopologyTools.h
 * Ways to run vtkSimplicialComplexTopology and to read what it says of one simplex.
 */
#ifndef SubdivisionObjects_SimplicialComplexTopologyTools_h
#define SubdivisionObjects_SimplicialComplexTopologyTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSimplicialComplexTopology.h"

namespace simplicial_complex_topology_tools
{

using namespace multi_dimensional_subdivision_tools;

using Configure = std::function<void(vtkSubdivisionAlgorithm*)>;

/// Runs the filter. Without `messages` it may not say anything.
Grid Probe(vtkDataObject* input, const Configure& setup = nullptr, bool special = false,
  Messages* messages = nullptr);

/// Points in general position; only their number matters.
Grid MakeComplex(int points, const std::vector<Cell>& cells);

void Flag(vtkUnstructuredGrid* grid, const std::vector<int>& flags, const char* name = "Singular");

inline const char* const Names[] = { "ManifoldDimensions", "Boundary", "NonManifoldType",
  "Singular", "Valence", "RuleDimension" };

/// The six values of a simplex, in the order of `Names`; empty where it is no cell.
std::vector<int> Values(vtkUnstructuredGrid* probe, const Ids& simplex);

inline int RuleOf(vtkUnstructuredGrid* probe, const Ids& simplex)
{
  const std::vector<int> values = Values(probe, simplex);
  return values.empty() ? -9 : values[5];
}

inline int SingularOf(vtkUnstructuredGrid* probe, const Ids& simplex)
{
  const std::vector<int> values = Values(probe, simplex);
  return values.empty() ? -9 : values[3];
}

std::vector<Ids> SingularCells(vtkUnstructuredGrid* probe);

inline Ids Field(vtkUnstructuredGrid* probe, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(probe->GetFieldData()->GetArray(name));
  return array ? Ids(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples())
               : Ids();
}

void ExpectNumbers(vtkUnstructuredGrid* probe, const Ids& counts, const Ids& components);

using V = std::vector<int>;

/// Vertex 6 inside the octahedron of 0 to 5; opposite are 0 1, 2 3, 4 5.
inline const std::vector<Point> BallPoints = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
  { 0, 0, 1 }, { 0, 0, -1 }, { 0, 0, 0 } };

std::vector<Cell> BallCells(bool solid);

Grid MakeBall(std::vector<Cell> more = {});

}

#endif
