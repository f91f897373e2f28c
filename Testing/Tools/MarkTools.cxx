// SPDX-License-Identifier: BSD-3-Clause
#include "MarkTools.h"

#include "vtkCell.h"

namespace feature_tools
{

std::vector<char> Draw(vtkIdType points, double share, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<char> marked;
  for (vtkIdType i = 0; i < points; ++i)
  {
    marked.push_back(random() < share * 4294967296.);
  }
  return marked;
}

std::vector<Cell> FindMarked(vtkPointSet* mesh, vtkUnstructuredGrid* simplices,
  const std::vector<char>& marked, Meaning meaning)
{
  std::set<Ids> found[3];
  const auto isMarked = [&](vtkIdType id) { return marked[id] != 0; };
  std::set<Ids> faces; // all of whose points are marked
  const auto addFace = [&](vtkIdList* ids)
  {
    if (ids->GetNumberOfIds() > 2 && std::all_of(ids->begin(), ids->end(), isMarked))
    {
      Ids face(ids->begin(), ids->end());
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  };
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = mesh->GetCell(c);
    for (const vtkIdType id : *cell->GetPointIds())
    {
      if (meaning.Corners && isMarked(id))
      {
        found[0].insert({ id });
      }
    }
    const auto addEdge = [&](const Ids& edge)
    {
      if (meaning.Creases && std::all_of(edge.begin(), edge.end(), isMarked))
      {
        found[1].insert({ std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) });
      }
    };
    vtkIdList* ids = cell->GetPointIds();
    for (vtkIdType i = 1; cell->GetCellDimension() == 1 && i < ids->GetNumberOfIds(); ++i)
    {
      addEdge({ ids->GetId(i - 1), ids->GetId(i) });
    }
    for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
    {
      vtkIdList* edge = cell->GetEdge(e)->GetPointIds();
      addEdge({ edge->GetId(0), edge->GetId(1) });
    }
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      addFace(cell->GetFace(f)->GetPointIds());
    }
    if (cell->GetCellDimension() == 2)
    {
      addFace(ids);
    }
  }
  for (vtkIdType c = 0; c < simplices->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(simplices, c);
    for (std::size_t left = 0; meaning.Surfaces && ids.size() > 2 && left < ids.size(); ++left)
    {
      Ids triangle = ids;
      if (ids.size() == 4)
      {
        triangle.erase(triangle.begin() + left);
      }
      std::sort(triangle.begin(), triangle.end());
      if (std::any_of(faces.begin(), faces.end(), [&](const Ids& face)
            { return std::includes(face.begin(), face.end(), triangle.begin(), triangle.end()); }))
      {
        found[2].insert(triangle);
      }
    }
  }
  std::vector<Cell> cells;
  const int types[3] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE };
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    for (const Ids& ids : found[dimension])
    {
      cells.push_back({ types[dimension], ids });
    }
  }
  return cells;
}

Grid AddFlagged(vtkUnstructuredGrid* mesh, const std::vector<Cell>& cells)
{
  const Grid flagged = DeepCopy(mesh);
  flagged->GetCellData()->Initialize();
  std::vector<int> flags(mesh->GetNumberOfCells(), 0);
  if (vtkDataArray* known = mesh->GetCellData()->GetArray("Singular"))
  {
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
      flags[i] = known->GetComponent(i, 0) != 0.;
    }
  }
  for (const Cell& cell : cells)
  {
    flagged->InsertNextCell(
      cell.Type, static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
    flags.push_back(1);
  }
  AddCellArray(flagged, "Singular", flags);
  return flagged;
}

void ExpectSame(vtkPointSet* marked, vtkPointSet* flagged, const char* but)
{
  ASSERT_EQ(marked->GetNumberOfPoints(), flagged->GetNumberOfPoints());
  ASSERT_EQ(CompareValues(marked->GetPoints()->GetData(), flagged->GetPoints()->GetData()), "");
  for (int a = 0; a < flagged->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* values = flagged->GetPointData()->GetAbstractArray(a);
    vtkAbstractArray* own = marked->GetPointData()->GetAbstractArray(values->GetName());
    ASSERT_TRUE(own) << values->GetName();
    if (values->GetName() != std::string(but))
    {
      EXPECT_EQ(CompareValues(own, values), "") << values->GetName();
    }
  }
  ASSERT_LE(marked->GetNumberOfCells(), flagged->GetNumberOfCells());
  vtkNew<vtkIdList> a;
  vtkNew<vtkIdList> b;
  for (vtkIdType c = 0; c < marked->GetNumberOfCells(); ++c)
  {
    marked->GetCellPoints(c, a);
    flagged->GetCellPoints(c, b);
    ASSERT_EQ(Ids(a->begin(), a->end()), Ids(b->begin(), b->end()));
  }
  EXPECT_FALSE(marked->GetPointData()->HasArray("SubdivisionMarked"));
  EXPECT_FALSE(marked->GetCellData()->HasArray("SubdivisionMarked"));
}

std::vector<Grid> MakeMarkMeshes()
{
  std::vector<Grid> meshes = { MakeOctahedron(), MakeKuhnBox(2, 0.1), MakeMixedBox(2),
    MakeRandomComplex(3), MakeRandomComplex(8) };
  for (const Grid& mesh : meshes)
  {
    mesh->GetPointData()->AddArray(
      MakeArray<vtkDoubleArray>("Values", 2, mesh->GetNumberOfPoints(), -1., 1., 9));
  }
  return meshes;
}

Grid ExecuteQuietly(vtkDataObject* input, int levels, const Configure& configure)
{
  vtkNew<Messages> messages;
  const Grid output = Execute(input, levels, configure, messages);
  EXPECT_TRUE(messages->Errors.empty());
  return output;
}

}
