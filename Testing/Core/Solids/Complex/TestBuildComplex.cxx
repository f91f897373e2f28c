// SPDX-License-Identifier: BSD-3-Clause
// BuildComplex against its definition, with sets of vertex sets: cells that equal earlier ones,
// lines and triangles that are parts of other cells, and many cells at one edge or face.
#include "CoreZoo.h"

#include "Core/Solids/Complex/Links.h"

using namespace coretest;

namespace
{

using Lists = std::vector<std::vector<vtkIdType>>;

/// The complex by definition, in lists: lines and triangles that are cells come first, as they are,
/// then all other edges and faces in order.
struct Defined
{
  explicit Defined(const SimplexList& cells)
  {
    Lists all[4];
    for (const Tuple& cell : GetCells(cells))
    {
      const std::size_t d = cell.size() - 1;
      const auto place = this->Numbers.emplace(Sorted(cell), all[d].size());
      this->Repeats.push_back(d > 0 && !place.second);
      if (d > 0 && !place.second)
      {
        this->Equal[d].push_back(cell);
        this->Twins[d].push_back(place.first->second);
      }
      else
      {
        all[d].push_back(cell);
      }
    }
    this->Lines = static_cast<vtkIdType>(all[1].size());
    this->Triangles = static_cast<vtkIdType>(all[2].size());
    this->Tets = all[3];
    this->Faces = all[2];
    this->Edges = all[1];
    this->AddParts(this->Tets, this->Faces);
    this->AddParts(this->Faces, this->Edges);
  }
  /// Adds the sides of cells to a list that has some of them.
  void AddParts(const Lists& cells, Lists& parts)
  {
    std::set<Tuple> others;
    for (const auto& cell : cells)
    {
      for (const Tuple& side : GetSides(cell))
      {
        others.insert(Sorted(side));
      }
    }
    for (const auto& part : parts)
    {
      others.erase(Sorted(part));
    }
    for (const Tuple& other : others)
    {
      this->Numbers.emplace(other, parts.size());
      parts.push_back(other);
    }
  }
  /// Edges of a triangle, or faces of a tetrahedron, in the order that the complex has.
  static std::vector<Tuple> GetSides(const Tuple& cell)
  {
    if (cell.size() == 3)
    {
      return { { cell[0], cell[1] }, { cell[1], cell[2] }, { cell[0], cell[2] } };
    }
    return { { cell[1], cell[2], cell[3] }, { cell[0], cell[2], cell[3] },
      { cell[0], cell[1], cell[3] }, { cell[0], cell[1], cell[2] } };
  }
  vtkIdType Find(const Tuple& tuple) const
  {
    return static_cast<vtkIdType>(this->Numbers.at(Sorted(tuple)));
  }
  std::vector<vtkIdType> FindSides(const Lists& cells) const
  {
    std::vector<vtkIdType> sides;
    for (const auto& cell : cells)
    {
      for (const Tuple& side : GetSides(cell))
      {
        sides.push_back(this->Find(side));
      }
    }
    return sides;
  }
  std::vector<vtkIdType> FindTetEdges() const
  {
    std::vector<vtkIdType> edges;
    for (const auto& t : this->Tets)
    {
      for (const auto& ends : tetrahedron::EdgeVertices)
      {
        edges.push_back(this->Find({ t[ends[0]], t[ends[1]] }));
      }
    }
    return edges;
  }

  std::map<Tuple, std::size_t> Numbers;
  std::vector<bool> Repeats; ///< of each cell
  Lists Edges;
  Lists Faces;
  Lists Tets;
  Lists Equal[4];
  std::vector<vtkIdType> Twins[4];
  vtkIdType Lines = 0;
  vtkIdType Triangles = 0;
};

std::vector<vtkIdType> Flat(const Lists& lists)
{
  std::vector<vtkIdType> flat;
  for (const auto& list : lists)
  {
    flat.insert(flat.end(), list.begin(), list.end());
  }
  return flat;
}

template <typename Id>
std::vector<vtkIdType> ToVector(const Buffer<Id>& buffer)
{
  return std::vector<vtkIdType>(buffer.begin(), buffer.end());
}

/// For each of `rows` members the lists, `length` long, that name it.
Lists Invert(const std::vector<vtkIdType>& members, vtkIdType length, std::size_t rows)
{
  Lists lists(rows);
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    lists[members[i]].push_back(static_cast<vtkIdType>(i) / length);
  }
  return lists;
}

template <typename Id>
Lists ToLists(const Rows<Id>& rows)
{
  Lists lists;
  for (vtkIdType i = 0; i < rows.GetNumberOfRows(); ++i)
  {
    lists.emplace_back(rows[i].begin(), rows[i].end());
  }
  return lists;
}

template <typename Id>
void CheckRuns(const SimplexList& cells, const std::vector<CellRun>& runs, const Defined& defined)
{
  std::size_t cell = 0;
  vtkIdType entry = 0;
  vtkIdType next[4][2] = {};
  for (const CellRun& run : runs)
  {
    ASSERT_EQ(run.FirstCell, static_cast<vtkIdType>(cell));
    ASSERT_EQ(run.FirstEntry, entry);
    ASSERT_EQ(run.First, next[run.Dimension][run.Equal]);
    ASSERT_GT(run.Count, 0);
    next[run.Dimension][run.Equal] += run.Count;
    for (vtkIdType i = 0; i < run.Count; ++i, ++cell)
    {
      ASSERT_EQ(run.Dimension, cells.Dimensions[cell]);
      ASSERT_EQ(run.Equal, defined.Repeats[cell]);
      entry += run.Dimension + 1;
    }
  }
  EXPECT_EQ(cell, cells.Dimensions.size());
}

template <typename Id>
void CheckByDefinition(const SimplexList& cells)
{
  std::vector<CellRun> runs;
  const SimplicialComplex<Id> complex = BuildComplex<Id>(cells, runs);
  const Defined defined(cells);
  EXPECT_EQ(complex.NumberOfLineCells, defined.Lines);
  EXPECT_EQ(complex.NumberOfTriangleCells, defined.Triangles);
  EXPECT_EQ(complex.NumberOfTets, static_cast<Id>(defined.Tets.size()));
  ASSERT_EQ(complex.NumberOfEdges, static_cast<Id>(defined.Edges.size()));
  ASSERT_EQ(complex.NumberOfFaces, static_cast<Id>(defined.Faces.size()));
  EXPECT_EQ(ToVector(complex.EdgeVertices), Flat(defined.Edges));
  EXPECT_EQ(ToVector(complex.FaceVertices), Flat(defined.Faces));
  EXPECT_EQ(ToVector(complex.TetVertices), Flat(defined.Tets));
  EXPECT_EQ(ToVector(complex.FaceEdges), defined.FindSides(defined.Faces));
  EXPECT_EQ(ToVector(complex.TetFaces), defined.FindSides(defined.Tets));
  EXPECT_EQ(ToVector(complex.TetEdges), defined.FindTetEdges());
  EXPECT_EQ(ToLists(complex.FaceTets), Invert(ToVector(complex.TetFaces), 4, defined.Faces.size()));
  const Links<Id> links(complex);
  EXPECT_EQ(ToLists(links.EdgeFaces), Invert(ToVector(complex.FaceEdges), 3, defined.Edges.size()));
  const EqualCells<Id>* equal[4] = { nullptr, &complex.EqualLines, &complex.EqualTriangles,
    &complex.EqualTets };
  for (int d = 1; d < 4; ++d)
  {
    EXPECT_EQ(ToVector(equal[d]->Vertices), Flat(defined.Equal[d])) << d;
    EXPECT_EQ(ToVector(equal[d]->Twins), defined.Twins[d]) << d;
  }
  CheckRuns<Id>(cells, runs, defined);
}

/// `counts`: how many cells of each dimension, on so few points that many are equal or share parts.
SimplexList DrawCells(const std::array<int, 4>& counts, int points, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> sizes;
  for (std::size_t d = 0; d < 4; ++d)
  {
    sizes.insert(sizes.end(), counts[d], d + 1);
  }
  std::shuffle(sizes.begin(), sizes.end(), random);
  Mesh mesh;
  mesh.Cells.NumberOfPoints = points;
  std::vector<vtkIdType> all(points);
  std::iota(all.begin(), all.end(), 0);
  for (const std::size_t size : sizes)
  {
    std::shuffle(all.begin(), all.end(), random);
    mesh.AddCell(Tuple(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size)));
  }
  return mesh.Cells;
}

}

TEST(CoreBuildComplex, ZooByDefinition)
{
  for (const Mesh& mesh : MakeZoo())
  {
    SCOPED_TRACE(mesh.Name);
    CheckByDefinition<int>(mesh.Cells);
    CheckByDefinition<long long>(mesh.Cells);
  }
}

TEST(CoreBuildComplex, RandomCellsByDefinition)
{
  // One dimension, pairs of them, all.
  const std::array<int, 4> counts[] = { { 0, 0, 0, 0 }, { 9, 0, 0, 0 }, { 0, 30, 0, 0 },
    { 0, 0, 40, 0 }, { 0, 0, 0, 40 }, { 5, 20, 0, 0 }, { 0, 20, 30, 0 }, { 0, 0, 30, 30 },
    { 0, 20, 0, 30 }, { 3, 0, 20, 0 }, { 9, 20, 30, 40 } };
  for (const auto& count : counts)
  {
    for (const int points : { 4, 5, 7, 12, 40 })
    {
      SCOPED_TRACE(std::to_string(count[0]) + " " + std::to_string(count[1]) + " " +
        std::to_string(count[2]) + " " + std::to_string(count[3]) + ", points " +
        std::to_string(points));
      CheckByDefinition<int>(DrawCells(count, points, 1));
      CheckByDefinition<long long>(DrawCells(count, points, 2));
    }
  }
}

TEST(CoreBuildComplex, EqualCellsAmongManyAtOneEdgeOrFace)
{
  // With two around an edge or face, and with more than are compared one by one; the last cell
  // equals the second, or none.
  for (const int around : { 2, 5, 12 })
  {
    for (const bool repeats : { false, true })
    {
      for (const std::size_t size : { std::size_t(3), std::size_t(4) })
      {
        SCOPED_TRACE(std::to_string(around) + (repeats ? " repeats " : " ") + std::to_string(size));
        Mesh mesh;
        mesh.Cells.NumberOfPoints = around + 3;
        for (int i = 0; i < around; ++i)
        {
          Tuple cell = { i + 3, 2, 0, 1 };
          cell.resize(size);
          mesh.AddCell(cell);
        }
        if (repeats)
        {
          Tuple cell = { 0, 4, 2, 1 };
          size == 3 ? cell.pop_back() : void();
          mesh.AddCell(cell);
        }
        CheckByDefinition<int>(mesh.Cells);
      }
    }
  }
}

TEST(CoreBuildComplex, LatticesInThreads)
{
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    CheckByDefinition<int>(MakeLattice("Lattice", 14, 1., 3).Control.Cells);
    vtkSMPTools::Initialize(0);
  }
}
