// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplicialComplexTopologyTools.h
 * Ways to run vtkSimplicialComplexTopology and to read what it says of one simplex.
 */
#ifndef SubdivisionObjects_SimplicialComplexTopologyTools_h
#define SubdivisionObjects_SimplicialComplexTopologyTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSimplicialComplexTopology.h"

#include <functional>

namespace simplicial_complex_topology_tools
{

using namespace multi_dimensional_subdivision_tools;

using Configure = std::function<void(vtkSubdivisionAlgorithm*)>;

/// Runs the filter. Without `messages` it may not say anything.
inline Grid Probe(vtkDataObject* input, const Configure& setup = nullptr, bool special = false,
  Messages* messages = nullptr)
{
  vtkNew<Messages> own;
  vtkNew<vtkSimplicialComplexTopology> filter;
  (messages ? messages : own.Get())->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetSpecialOnly(special);
  if (setup)
  {
    setup(filter);
  }
  filter->Update();
  for (const auto* list : { &own->Warnings, &own->Errors })
  {
    for (const std::string& text : *list)
    {
      ADD_FAILURE() << "unexpected: " << text;
    }
  }
  return filter->GetOutput();
}

/// Points in general position; only their number matters.
inline Grid MakeComplex(int points, const std::vector<Cell>& cells)
{
  std::vector<Point> positions;
  for (int i = 0; i < points; ++i)
  {
    positions.push_back({ i * 1., i * i * 1., i * i * i * 1. });
  }
  return MakeGrid(positions, cells);
}

inline void Flag(
  vtkUnstructuredGrid* grid, const std::vector<int>& flags, const char* name = "Singular")
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (int flag : flags)
  {
    array->InsertNextValue(flag);
  }
  grid->GetCellData()->AddArray(array);
}

inline const char* const Names[] = { "ManifoldDimensions", "Boundary", "NonManifoldType",
  "Singular", "Valence", "RuleDimension" };

/// The six values of a simplex, in the order of `Names`; empty where it is no cell.
inline std::vector<int> Values(vtkUnstructuredGrid* probe, const Ids& simplex)
{
  for (vtkIdType i = 0; i < probe->GetNumberOfCells(); ++i)
  {
    if (GetCell(probe, i) == simplex)
    {
      std::vector<int> values;
      for (const char* name : Names)
      {
        values.push_back(static_cast<int>(probe->GetCellData()->GetArray(name)->GetTuple1(i)));
      }
      return values;
    }
  }
  return {};
}

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

inline std::vector<Ids> SingularCells(vtkUnstructuredGrid* probe)
{
  std::vector<Ids> cells;
  for (vtkIdType i = 0; i < probe->GetNumberOfCells(); ++i)
  {
    if (probe->GetCellData()->GetArray("Singular")->GetTuple1(i) != 0)
    {
      cells.push_back(GetCell(probe, i));
    }
  }
  return cells;
}

inline Ids Field(vtkUnstructuredGrid* probe, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(probe->GetFieldData()->GetArray(name));
  return array ? Ids(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples())
               : Ids();
}

inline void ExpectNumbers(vtkUnstructuredGrid* probe, const Ids& counts, const Ids& components)
{
  EXPECT_EQ(Field(probe, "SimplexCounts"), counts);
  EXPECT_EQ(
    Field(probe, "EulerCharacteristic"), Ids{ counts[0] - counts[1] + counts[2] - counts[3] });
  EXPECT_EQ(Field(probe, "ManifoldComponents"), components);
}

using V = std::vector<int>;

/// Vertex 6 inside the octahedron of 0 to 5; opposite are 0 1, 2 3, 4 5.
inline const std::vector<Point> BallPoints = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 },
  { 0, 0, 1 }, { 0, 0, -1 }, { 0, 0, 0 } };

inline std::vector<Cell> BallCells(bool solid)
{
  std::vector<Cell> cells;
  for (vtkIdType a : { 0, 1 })
  {
    for (vtkIdType b : { 2, 3 })
    {
      for (vtkIdType c : { 4, 5 })
      {
        cells.push_back(
          solid ? Cell{ VTK_TETRA, { 6, a, b, c } } : Cell{ VTK_TRIANGLE, { a, b, c } });
      }
    }
  }
  return cells;
}

inline Grid MakeBall(std::vector<Cell> more = {})
{
  std::vector<Cell> cells = BallCells(true);
  cells.insert(cells.end(), more.begin(), more.end());
  return MakeGrid(BallPoints, cells);
}

}

#endif
