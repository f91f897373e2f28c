// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellComplex.h"

#include "Core/Cells/ChildTuples.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/TupleIndex.h"

#include <numeric>

namespace subdivision
{
namespace
{

/// Offsets of rows with size(cell) items.
template <typename Id, typename Size>
Buffer<Id> CountItems(const CellList<Id>& cells, const Size& size)
{
  Buffer<Id> offsets(cells.GetNumberOfCells() + 1);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c) { offsets[c] = static_cast<Id>(size(cells.GetTable(c))); });
  CountsToOffsets(offsets);
  return offsets;
}

template <typename Id>
Rows<Id> StartRows(Buffer<Id> offsets)
{
  Rows<Id> rows;
  rows.Items = Buffer<Id>(offsets[offsets.size() - 1]);
  rows.Offsets = std::move(offsets);
  return rows;
}

template <typename Id>
void NumberEdges(CellComplex<Id>& complex)
{
  const CellList<Id>& cells = complex.Cells;
  complex.CellEdges =
    StartRows(CountItems(cells, [](const CellTable& t) { return t.Edges.size(); }));
  Buffer<std::array<Id, 2>> pairs(complex.CellEdges.Items.size());
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      std::array<Id, 2>* pair = pairs.data() + complex.CellEdges.Offsets[c];
      const Id* corners = cells.GetCorners(c);
      for (const auto& edge : cells.GetTable(c).Edges)
      {
        const Id ends[2] = { corners[edge[0]], corners[edge[1]] };
        *pair++ = SortedTuple<2>(ends);
      }
    });
  TupleNumbers<Id> numbers = NumberTuples<2, Id>(pairs, complex.NumberOfVertices, 0);
  complex.NumberOfEdges = static_cast<Id>(numbers.Representatives.size());
  complex.CellEdges.Items = std::move(numbers.Numbers);
  complex.EdgeFirsts = std::move(numbers.Representatives);
  complex.EdgeVertices = Buffer<Id>(2 * vtkIdType(complex.NumberOfEdges));
  ForEach(complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      const auto& pair = pairs[complex.EdgeFirsts[e]];
      std::copy(pair.begin(), pair.end(), complex.EdgeVertices.data() + 2 * e);
    });
}

/// The first entry that has each number.
template <typename Id>
Buffer<Id> FindFirsts(const Buffer<Id>& numbers, vtkIdType size)
{
  Buffer<Id> firsts(size, Id(-1));
  ForEachInTurn(numbers.size(),
    [&](vtkIdType i)
    {
      Id& first = firsts[numbers[i]];
      first = first < 0 ? static_cast<Id>(i) : first;
    });
  return firsts;
}

template <typename Id>
void NumberEdges(CellComplex<Id>& complex, const CellComplex<Id>& parents)
{
  const CellList<Id>& cells = complex.Cells;
  const ChildTuples<2, Id> tuples(parents);
  complex.CellEdges =
    StartRows(CountItems(cells, [](const CellTable& t) { return t.Edges.size(); }));
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      Id* edges = complex.CellEdges.Items.data() + complex.CellEdges.Offsets[c];
      ForTuples<2>(
        cells, c, [&](vtkIdType k, const auto& tuple) { edges[k] = tuples.Find(tuple); });
    });
  complex.NumberOfEdges = static_cast<Id>(tuples.GetSize());
  complex.EdgeFirsts = FindFirsts(complex.CellEdges.Items, tuples.GetSize());
  complex.EdgeVertices = Buffer<Id>(2 * tuples.GetSize());
  tuples.ForAll(
    [&](Id edge, Id vertex, const auto& tail)
    {
      complex.EdgeVertices[2 * vtkIdType(edge)] = vertex;
      complex.EdgeVertices[2 * vtkIdType(edge) + 1] = tail[0];
    });
}

/// Numbers the faces of N corners from `first` on, and returns how many there are.
template <int N, typename Id>
Id NumberFaces(CellComplex<Id>& complex, Id first, const CellComplex<Id>& parents)
{
  const ChildTuples<N, Id> tuples(parents);
  ForEach(complex.Cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      Id* faces = complex.CellFaces.Items.data() + complex.CellFaces.Offsets[c];
      ForTuples<N>(complex.Cells, c,
        [&](vtkIdType k, const auto& tuple) { faces[k] = first + tuples.Find(tuple); });
    });
  return static_cast<Id>(tuples.GetSize());
}

/// The sorted corners of a face; of a quad then the corner opposite to the smallest one, for quads
/// with the same corners in different orders have different edges.
template <int N, typename Id>
std::array<Id, N == 4 ? 5 : N> MakeFaceTuple(const Id* corners)
{
  std::array<Id, N == 4 ? 5 : N> tuple;
  const std::array<Id, N> sorted = SortedTuple<N>(corners);
  std::copy(sorted.begin(), sorted.end(), tuple.begin());
  if constexpr (N == 4)
  {
    tuple[4] = corners[(std::find(corners, corners + 4, sorted[0]) - corners + 2) % 4];
  }
  return tuple;
}

/// Numbers the faces of N corners from `first` on, and returns how many there are.
template <int N, typename Id>
Id NumberFaces(CellComplex<Id>& complex, Id first)
{
  using Tuple = decltype(MakeFaceTuple<N, Id>(nullptr));
  const CellList<Id>& cells = complex.Cells;
  const auto isOne = [](const auto& face) { return face.size() == N; };
  const Buffer<Id> offsets = CountItems(cells,
    [&](const CellTable& t) { return std::count_if(t.Faces.begin(), t.Faces.end(), isOne); });
  Buffer<Tuple> tuples(offsets[cells.GetNumberOfCells()]);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      Tuple* tuple = tuples.data() + offsets[c];
      const Id* corners = cells.GetCorners(c);
      for (const auto& face : cells.GetTable(c).Faces)
      {
        if (isOne(face))
        {
          Id vertices[N];
          std::transform(face.begin(), face.end(), vertices, [&](int k) { return corners[k]; });
          *tuple++ = MakeFaceTuple<N>(vertices);
        }
      }
    });
  const TupleNumbers<Id> numbers =
    NumberTuples<std::tuple_size<Tuple>::value, Id>(tuples, complex.NumberOfVertices, 0);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      vtkIdType i = offsets[c];
      Id* number = complex.CellFaces.Items.data() + complex.CellFaces.Offsets[c];
      for (const auto& face : cells.GetTable(c).Faces)
      {
        *number = isOne(face) ? first + numbers.Numbers[i++] : *number;
        ++number;
      }
    });
  return static_cast<Id>(numbers.Representatives.size());
}

/// Gives each face the vertices and edges that it has in the first cell at it.
template <typename Id>
void FillFaces(CellComplex<Id>& complex)
{
  const CellList<Id>& cells = complex.Cells;
  const vtkIdType size = complex.GetFirst(complex.NumberOfFaces);
  complex.FaceVertices = Buffer<Id>(size);
  complex.FaceEdges = Buffer<Id>(size);
  complex.FaceFirsts = FindFirsts(complex.CellFaces.Items, complex.NumberOfFaces);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      const CellTable& table = cells.GetTable(c);
      for (std::size_t f = 0; f < table.Faces.size(); ++f)
      {
        const vtkIdType place = complex.CellFaces.Offsets[c] + static_cast<vtkIdType>(f);
        const Id face = complex.CellFaces.Items[place];
        if (complex.FaceFirsts[face] == place)
        {
          const vtkIdType first = complex.GetFirst(face);
          for (std::size_t k = 0; k < table.Faces[f].size(); ++k)
          {
            const auto at = first + static_cast<vtkIdType>(k);
            complex.FaceVertices[at] = cells.GetCorners(c)[table.Faces[f][k]];
            complex.FaceEdges[at] = complex.CellEdges[c].begin()[table.FaceEdges[f][k]];
          }
        }
      }
    });
}

/// The solids that `rows` list for each cell, by item.
template <typename Id>
Rows<Id> ListSolids(const CellComplex<Id>& complex, const Rows<Id>& rows, Id size)
{
  const auto isSolid = [&](vtkIdType c)
  { return complex.Cells.GetTable(c).Dimension == 3 && !complex.IsTwin(c); };
  Rows<Id> lists;
  lists.Offsets = Buffer<Id>(vtkIdType(size) + 1, Id(0));
  const auto forAll = [&](const auto& act)
  {
    ForEachInTurn(complex.Cells.GetNumberOfCells(),
      [&](vtkIdType c)
      {
        if (isSolid(c))
        {
          for (const Id item : rows[c])
          {
            act(item, static_cast<Id>(c));
          }
        }
      });
  };
  forAll([&](Id item, Id) { ++lists.Offsets[item]; });
  CountsToOffsets(lists.Offsets);
  lists.Items = Buffer<Id>(lists.Offsets[size]);
  Buffer<Id> next(size);
  CopyInThreads(lists.Offsets.data(), size, next.data());
  forAll([&](Id item, Id cell) { lists.Items[next[item]++] = cell; });
  return lists;
}

/// Finds solids that equal earlier ones: they have all faces in common. The same corners are not
/// enough, for the edges and faces of children inside would be others.
template <typename Id>
void FindTwins(CellComplex<Id>& complex)
{
  const CellList<Id>& cells = complex.Cells;
  Buffer<Id> twins(cells.GetNumberOfCells(), Id(-1));
  const auto areEqual = [&complex](const Row<Id>& a, const Row<Id>& b)
  { return std::is_permutation(a.begin(), a.end(), b.begin(), b.end()); };
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      const bool isSolid = cells.GetTable(c).Dimension == 3;
      for (const Id other : isSolid ? complex.FaceSolids[*complex.CellFaces[c].begin()] : Row<Id>())
      {
        if (other < c && twins[c] < 0 && areEqual(complex.CellFaces[other], complex.CellFaces[c]))
        {
          twins[c] = other;
        }
      }
    });
  if (std::any_of(twins.begin(), twins.end(), [](Id twin) { return twin >= 0; }))
  {
    complex.Twins = std::move(twins);
    complex.FaceSolids = ListSolids(complex, complex.CellFaces, complex.NumberOfFaces);
  }
}

template <typename Id>
void NumberCentres(CellComplex<Id>& complex)
{
  const CellList<Id>& cells = complex.Cells;
  Buffer<Id> centres(cells.GetNumberOfCells(), Id(-1));
  ForEachInTurn(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      const CellTable& table = cells.GetTable(c);
      const bool isTwin = complex.IsTwin(c);
      complex.NumberOfTets += table.Dimension == 3 && !isTwin ? 1 : 0;
      complex.NumberOfTriangleCells += table.Dimension == 2 ? 1 : 0;
      complex.NumberOfLineCells += table.Dimension == 1 ? 1 : 0;
      if (table.HasCentre)
      {
        centres[c] = isTwin ? centres[complex.Twins[c]] : complex.NumberOfCentres++;
      }
    });
  complex.Centres = std::move(centres);
  complex.CentreCells = Buffer<Id>(complex.NumberOfCentres);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c)
    {
      if (complex.Centres[c] >= 0 && !complex.IsTwin(c))
      {
        complex.CentreCells[complex.Centres[c]] = static_cast<Id>(c);
      }
    });
}

template <typename Id>
Rows<Id> Invert(const Buffer<Id>& members, int perOwner, Id rows)
{
  return ListByRow<Id>(
    rows, members.size(), [&](vtkIdType i) { return members[i]; },
    [perOwner](vtkIdType i) { return static_cast<Id>(i / perOwner); });
}

template <typename Id>
void ListIncidences(CellComplex<Id>& complex)
{
  complex.VertexEdges = Invert(complex.EdgeVertices, 2, complex.NumberOfVertices);
  const vtkIdType ofQuads = 4 * vtkIdType(complex.NumberOfQuads);
  complex.EdgeFaces = ListByRow<Id>(
    complex.NumberOfEdges, complex.FaceEdges.size(),
    [&](vtkIdType i) { return complex.FaceEdges[i]; }, [&](vtkIdType i)
    { return static_cast<Id>(i < ofQuads ? i / 4 : complex.NumberOfQuads + (i - ofQuads) / 3); });
  complex.EdgeSolids = ListSolids(complex, complex.CellEdges, complex.NumberOfEdges);
  Rows<Id> corners;
  std::swap(corners.Offsets, complex.Cells.Offsets);
  std::swap(corners.Items, complex.Cells.Corners);
  complex.VertexSolids = ListSolids(complex, corners, complex.NumberOfVertices);
  std::swap(corners.Offsets, complex.Cells.Offsets);
  std::swap(corners.Items, complex.Cells.Corners);
}

}

template <typename Id>
void FindPointsOfStep(const CellComplex<Id>& complex, vtkIdType cell, Id* points)
{
  const Id* corners = complex.Cells.GetCorners(cell);
  const CellTable& table = complex.Cells.GetTable(cell);
  points = std::copy_n(corners, table.Corners, points);
  for (const Id edge : complex.CellEdges[cell])
  {
    *points++ = complex.NumberOfVertices + edge;
  }
  for (const unsigned char quad : table.Quads)
  {
    *points++ =
      complex.NumberOfVertices + complex.NumberOfEdges + complex.CellFaces[cell].begin()[quad];
  }
  if (table.HasCentre)
  {
    *points = complex.NumberOfVertices + complex.NumberOfEdges + complex.NumberOfQuads +
      complex.Centres[cell];
  }
}

template <typename Id>
void CellComplex<Id>::ForgetIncidences()
{
  for (Buffer<Id>* list : { &this->EdgeVertices, &this->FaceVertices, &this->FaceEdges,
         &this->EdgeFirsts, &this->FaceFirsts, &this->CentreCells, &this->Twins })
  {
    *list = Buffer<Id>();
  }
  for (Rows<Id>* rows : { &this->FaceSolids, &this->EdgeFaces, &this->EdgeSolids,
         &this->VertexEdges, &this->VertexSolids })
  {
    *rows = Rows<Id>();
  }
}

template <typename Id>
Id CellComplex<Id>::FindEdge(Id a, Id b) const
{
  for (const Id edge : this->VertexEdges[a])
  {
    if (this->GetOtherEnd(edge, a) == b)
    {
      return edge;
    }
  }
  return -1;
}

namespace
{

/// `parents`: complexes of which the cells are the children; at most one.
template <typename Id, typename... Parents>
CellComplex<Id> Build(CellList<Id> cells, bool hasTwins, const Parents&... parents)
{
  CellComplex<Id> complex;
  complex.NumberOfVertices = static_cast<Id>(cells.NumberOfPoints);
  complex.Cells = std::move(cells);
  NumberEdges(complex, parents...);
  complex.CellFaces =
    StartRows(CountItems(complex.Cells, [](const CellTable& t) { return t.Faces.size(); }));
  complex.NumberOfQuads = NumberFaces<4, Id>(complex, 0, parents...);
  complex.NumberOfFaces =
    complex.NumberOfQuads + NumberFaces<3, Id>(complex, complex.NumberOfQuads, parents...);
  FillFaces(complex);
  complex.FaceSolids = ListSolids(complex, complex.CellFaces, complex.NumberOfFaces);
  hasTwins ? FindTwins(complex) : void();
  NumberCentres(complex);
  ListIncidences(complex);
  return complex;
}

}

template <typename Id>
CellComplex<Id> BuildCellComplex(CellList<Id> cells)
{
  return Build(std::move(cells), true);
}

template <typename Id>
CellComplex<Id> RefineCellComplex(const CellComplex<Id>& complex)
{
  return Build(SplitCells(complex), !complex.Twins.empty(), complex);
}

template <typename Id>
Buffer<Id> FindFirstChildren(const CellList<Id>& cells)
{
  return CountItems(cells, [](const CellTable& t) { return t.Children.size(); });
}

template <typename Id>
CellList<Id> SplitCells(const CellComplex<Id>& complex)
{
  const CellList<Id>& cells = complex.Cells;
  const Buffer<Id> first = FindFirstChildren(cells);
  const Buffer<Id> corners = CountItems(cells,
    [](const CellTable& t)
    {
      return std::accumulate(t.Children.begin(), t.Children.end(), 0,
        [](int sum, const CellChild& child) { return sum + GetCellTable(child.Shape).Corners; });
    });
  const vtkIdType size = cells.GetNumberOfCells();
  CellList<Id> children;
  children.NumberOfPoints = complex.GetNumberOfNewPoints();
  children.Shapes = Buffer<CellShape>(first[size]);
  children.Offsets = Buffer<Id>(vtkIdType(first[size]) + 1);
  children.Offsets[first[size]] = corners[size];
  children.Corners = Buffer<Id>(corners[size]);
  ForEach(size,
    [&](vtkIdType c)
    {
      Id points[27];
      FindPointsOfStep(complex, c, points);
      vtkIdType child = first[c];
      Id at = corners[c];
      for (const CellChild& made : cells.GetTable(c).Children)
      {
        children.Shapes[child] = made.Shape;
        children.Offsets[child++] = at;
        const int count = GetCellTable(made.Shape).Corners;
        for (int k = 0; k < count; ++k)
        {
          children.Corners[at++] = points[made.Points[k]];
        }
      }
    });
  return children;
}

SUBDIVISION_COMPILE(struct CellComplex);
SUBDIVISION_COMPILE_FUNCTION(BuildCellComplex);
SUBDIVISION_COMPILE_FUNCTION(RefineCellComplex);
SUBDIVISION_COMPILE_FUNCTION(FindPointsOfStep);
SUBDIVISION_COMPILE_FUNCTION(FindFirstChildren);
SUBDIVISION_COMPILE_FUNCTION(SplitCells);

}
