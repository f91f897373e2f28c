// SPDX-License-Identifier: BSD-3-Clause
#include "SimplicialComplexTopologyTools.h"

namespace simplicial_complex_topology_tools
{

Grid Probe(vtkDataObject* input, const Configure& setup, bool special, Messages* messages)
{
  vtkNew<vtkSimplicialComplexTopology> filter;
  filter->SetSpecialOnly(special);
  if (setup)
  {
    setup(filter);
  }
  UpdateInSilence(filter, input, messages);
  return filter->GetOutput();
}

Grid MakeComplex(int points, const std::vector<Cell>& cells)
{
  std::vector<Point> positions;
  for (int i = 0; i < points; ++i)
  {
    positions.push_back({ i * 1., i * i * 1., i * i * i * 1. });
  }
  return MakeGrid(positions, cells);
}

void Flag(vtkUnstructuredGrid* grid, const std::vector<int>& flags, const char* name)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (int flag : flags)
  {
    array->InsertNextValue(flag);
  }
  grid->GetCellData()->AddArray(array);
}

std::vector<int> Values(vtkUnstructuredGrid* probe, const Ids& simplex)
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

std::vector<Ids> SingularCells(vtkUnstructuredGrid* probe)
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

void ExpectNumbers(vtkUnstructuredGrid* probe, const Ids& counts, const Ids& components)
{
  EXPECT_EQ(Field(probe, "SimplexCounts"), counts);
  EXPECT_EQ(
    Field(probe, "EulerCharacteristic"), Ids{ counts[0] - counts[1] + counts[2] - counts[3] });
  EXPECT_EQ(Field(probe, "ManifoldComponents"), components);
}

std::vector<Cell> BallCells(bool solid)
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

Grid MakeBall(std::vector<Cell> more)
{
  std::vector<Cell> cells = BallCells(true);
  cells.insert(cells.end(), more.begin(), more.end());
  return MakeGrid(BallPoints, cells);
}

}
