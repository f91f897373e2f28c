// SPDX-License-Identifier: BSD-3-Clause
// Finds the edges of all cells first, as pairs of vertices, and then the faces, each as the edge
// between its smaller two vertices and its largest one: few faces share that edge, so that hardly
// anything is left to sort.
#include "Core/Solids/Complex/SimplicialComplex.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/PairNumbers.h"
#include "Core/Memory/SimplexStarts.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace subdivision
{
namespace
{

/// The cells of one dimension in output order, and which of them equal an earlier one.
template <typename Id>
struct CellsOfDimension
{
  vtkIdType Count = 0;
  Buffer<Id> Vertices;  ///< dimension + 1 for each
  Buffer<bool> Repeats; ///< empty: none
};

/// Whether two of some numbers are equal, or there are too many to look at each pair of them.
template <typename Id, typename Get>
bool MayHaveEqual(vtkIdType size, const Get& get)
{
  constexpr vtkIdType most = 8;
  bool found = size > most;
  for (vtkIdType i = 1; i < size && !found; ++i)
  {
    for (vtkIdType k = 0; k < i; ++k)
    {
      found = found || get(i) == get(k);
    }
  }
  return found;
}

// ------------------------------------------------------------------------------------------------
// Tetrahedra and equal cells

/// Takes the lists of distinct tetrahedra out of some lists.
template <typename Id>
Buffer<Id> TakeDistinct(const Buffer<Id>& lists, int length, const Buffer<Id>& tets)
{
  Buffer<Id> taken(length * tets.size());
  ForEach(tets.size(),
    [&](vtkIdType i)
    {
      std::copy_n(lists.data() + vtkIdType(length) * tets[i], length, taken.data() + length * i);
    });
  return taken;
}

template <typename Id>
class ComplexBuilder
{
public:
  explicit ComplexBuilder(const SimplexList& simplices)
    : Simplices(simplices)
  {
  }

  SimplicialComplex<Id> Build(std::vector<CellRun>& runs)
  {
    this->GatherCells();
    this->Complex.NumberOfVertices = static_cast<Id>(this->Simplices.NumberOfPoints);
    this->Complex.VertexCells = std::move(this->Cells[0].Vertices);
    this->FindEdges();
    this->FindFaces();
    this->FindTets();
    runs = this->MakeRuns();
    return std::move(this->Complex);
  }

private:
  using Entry = PairEntry<Id>;

  vtkIdType Count(int dimension) const { return this->Cells[dimension].Count; }
  const Id* GetVertices(int dimension, vtkIdType cell) const
  {
    return this->Cells[dimension].Vertices.data() + (dimension + 1) * cell;
  }
  /// The pair of vertices of a local edge of a cell is this and its local number.
  vtkIdType GetFirstEdge(int dimension, vtkIdType cell) const
  {
    return dimension == 1 ? cell
      : dimension == 2    ? this->Count(1) + 3 * cell
                          : this->Count(1) + 3 * this->Count(2) + 6 * cell;
  }
  /// The same for faces.
  vtkIdType GetFirstFace(vtkIdType tet) const { return this->Count(2) + 4 * tet; }
  void GatherCells()
  {
    const std::array<vtkIdType, 4> counts = CountDimensions(this->Simplices);
    const SimplexStarts entries = FindCorners(SimplexView(this->Simplices));
    for (int dimension = 0; dimension < 4; ++dimension)
    {
      this->Cells[dimension].Count = counts[dimension];
      this->GatherCells(dimension, entries);
    }
  }

  /// `entries`: where the vertices of each simplex begin.
  void GatherCells(int dimension, const SimplexStarts& entries)
  {
    const vtkIdType size = this->Simplices.GetNumberOfSimplices();
    const int corners = dimension + 1;
    CellsOfDimension<Id>& cells = this->Cells[dimension];
    cells.Vertices = Buffer<Id>(corners * cells.Count);
    const vtkIdType* const ids = this->Simplices.Connectivity.data();
    if (cells.Count == 0 || cells.Count == size)
    {
      CopyInThreads(ids, cells.Vertices.size(), cells.Vertices.data());
      return;
    }
    const auto isOne = [&](vtkIdType i) { return this->Simplices.Dimensions[i] == dimension; };
    Buffer<Id> places(size + 1);
    ForEach(size, [&](vtkIdType i) { places[i] = isOne(i) ? 1 : 0; });
    CountsToOffsets(places);
    ForEach(size,
      [&](vtkIdType i)
      {
        if (isOne(i))
        {
          std::copy_n(ids + entries[i], corners, cells.Vertices.data() + corners * places[i]);
        }
      });
  }
  /// Whether each line comes after the one before in lexicographic order, so that all are
  /// different.
  bool AreLinesAscending() const
  {
    const auto get = [this](vtkIdType line)
    {
      const Id* ends = this->GetVertices(1, line);
      return std::make_pair(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
    };
    for (const vtkIdType line : InTurn(this->Count(1) - 1))
    {
      if (!(get(line) < get(line + 1)))
      {
        return false;
      }
    }
    return true;
  }
  /// Calls use(pair, a, b) for the ends of each edge of each cell.
  template <typename Use>
  void ForEdges(const Use& use) const
  {
    constexpr int line[1][2] = { { 0, 1 } };
    const auto forCells = [&](int dimension, const auto& edges)
    {
      ForEachInTurn(this->Count(dimension),
        [&](vtkIdType cell)
        {
          const Id* ids = this->GetVertices(dimension, cell);
          vtkIdType pair = this->GetFirstEdge(dimension, cell);
          for (const auto& ends : edges)
          {
            use(pair++, ids[ends[0]], ids[ends[1]]);
          }
        });
    };
    forCells(1, line);
    forCells(2, triangle::EdgeVertices);
    forCells(3, tetrahedron::EdgeVertices);
  }
  void FindEdges()
  {
    const vtkIdType size = this->GetFirstEdge(3, this->Count(3));
    const vtkIdType lines = this->Count(1);
    if (size == lines && this->AreLinesAscending())
    {
      this->Complex.NumberOfEdges = this->Complex.NumberOfLineCells = static_cast<Id>(lines);
      this->Complex.EdgeVertices = std::move(this->Cells[1].Vertices);
      return;
    }
    const bool areTriangles = this->Count(2) > 0 && this->Count(3) == 0;
    const PairIndex<Id> index(size, this->Complex.NumberOfVertices,
      [this](const auto& use)
      {
        this->ForEdges(
          [&use](vtkIdType pair, Id a, Id b) { use(pair, std::min(a, b), std::max(a, b)); });
      });
    const vtkIdType edges = index.GetNumberOfRanks();
    this->Complex.EdgeVertices = Buffer<Id>(2 * edges);
    if (areTriangles && lines == 0)
    {
      this->Complex.EdgeFaces = { Buffer<Id>(edges + 1), Buffer<Id>(size) };
      this->Complex.EdgeFaces.Offsets[edges] = static_cast<Id>(size);
    }
    std::atomic<bool> mayRepeat(false);
    this->Edges = PairNumbers<Id>(index, lines,
      [&](Id rank, Id first, const Entry* begin, const Entry* end)
      {
        Id* const ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(rank);
        ends[0] = first;
        ends[1] = begin->GetSecond();
        if (areTriangles && this->TakeTriangles(rank, index.GetPlace(begin), begin, end))
        {
          mayRepeat = true;
        }
      });
    this->MayRepeatTriangles = mayRepeat;
    this->Complex.NumberOfEdges = static_cast<Id>(edges);
    if (lines > 0)
    {
      this->PutLinesFirst();
    }
  }
  /// Takes the triangles at an edge, if there are triangles alone. Returns whether two may be
  /// equal.
  bool TakeTriangles(Id edge, vtkIdType place, const Entry* begin, const Entry* end)
  {
    const vtkIdType lines = this->Count(1);
    const auto opposite = [&](const Entry& entry)
    {
      const auto corner = static_cast<Id>(entry.GetPair() - lines);
      return this->GetVertices(2, corner / 3)[triangle::VertexOpposite[corner % 3]];
    };
    Rows<Id>& faces = this->Complex.EdgeFaces;
    if (faces.Offsets.empty())
    {
      const Entry* first =
        std::find_if(begin, end, [lines](const Entry& entry) { return entry.GetPair() >= lines; });
      return MayHaveEqual<Id>(end - first, [&](vtkIdType i) { return opposite(first[i]); });
    }
    faces.Offsets[edge] = static_cast<Id>(place);
    if (end - begin == 2) // most edges; a loop would be compiled for long ones
    {
      faces.Items[place] = begin[0].GetPair() / 3;
      faces.Items[place + 1] = begin[1].GetPair() / 3;
      return opposite(begin[0]) == opposite(begin[1]);
    }
    std::transform(begin, end, faces.Items.data() + place,
      [](const Entry& entry) { return entry.GetPair() / 3; });
    return MayHaveEqual<Id>(end - begin, [&](vtkIdType i) { return opposite(begin[i]); });
  }
  /// Edges that are line cells have the numbers of these, and run as the first of them does.
  void PutLinesFirst()
  {
    this->FindRepeats(1, this->Edges, this->Complex.EqualLines);
    this->Complex.NumberOfLineCells =
      static_cast<Id>(this->Count(1) - this->Complex.EqualLines.Twins.size());
    Buffer<Id> sorted = std::move(this->Complex.EdgeVertices);
    this->Complex.EdgeVertices = Buffer<Id>(sorted.size());
    ForEach(this->Complex.NumberOfEdges,
      [&](vtkIdType rank)
      {
        const Id edge = this->Edges.GetNumber(static_cast<Id>(rank));
        const Id* ends = edge < this->Complex.NumberOfLineCells
          ? this->GetVertices(1, this->Edges.Firsts[edge])
          : sorted.data() + 2 * rank;
        std::copy_n(ends, 2, this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge));
      });
  }
  /// Calls use(pair, edge, vertex) for each face of each cell of two dimensions or more: the rank
  /// of the edge between its smaller vertices, and its largest vertex.
  template <typename Use>
  void ForFaces(const Use& use) const
  {
    ForEachInTurn(this->Count(2),
      [&](vtkIdType cell)
      {
        const Id* ids = this->GetVertices(2, cell);
        const int largest = static_cast<int>(std::max_element(ids, ids + 3) - ids);
        const int edge = triangle::EdgeOpposite[largest];
        use(cell, this->Edges.Ranks[this->GetFirstEdge(2, cell) + edge], ids[largest]);
      });
    ForEachInTurn(this->Count(3),
      [&](vtkIdType tet)
      {
        const Id* ids = this->GetVertices(3, tet);
        const Id* edges = this->Edges.Ranks.data() + this->GetFirstEdge(3, tet);
        for (int face = 0; face < 4; ++face)
        {
          const int* local = tetrahedron::FaceVertices[face];
          int a = local[0];
          int b = local[1];
          int largest = local[2];
          if (ids[a] > ids[largest])
          {
            std::swap(a, largest);
          }
          if (ids[b] > ids[largest])
          {
            std::swap(b, largest);
          }
          use(this->GetFirstFace(tet) + face, edges[tetrahedron::EdgeOf[a][b]], ids[largest]);
        }
      });
  }
  void FindFaces()
  {
    const vtkIdType triangles = this->Count(2);
    if (this->Count(3) > 0 || this->MayRepeatTriangles)
    {
      this->SortFaces();
    }
    else
    {
      this->Complex.NumberOfFaces = this->Complex.NumberOfTriangleCells =
        static_cast<Id>(triangles);
      this->Complex.FaceVertices = std::move(this->Cells[2].Vertices);
      this->Complex.FaceEdges = TakeNumbers(this->Edges, this->GetFirstEdge(2, 0), 3 * triangles);
      this->Complex.FaceTets = { Buffer<Id>(triangles + 1, Id(0)), Buffer<Id>() };
    }
  }
  void SortFaces()
  {
    const vtkIdType size = this->GetFirstFace(this->Count(3));
    const vtkIdType triangles = this->Count(2);
    const PairIndex<Id> index(
      size, this->Edges.Firsts.size(), [this](const auto& use) { this->ForFaces(use); });
    this->Complex.EdgeFaces = Rows<Id>(); // cells may be no faces of their own
    Rows<Id>& tets = this->Complex.FaceTets;
    if (triangles == 0)
    {
      tets = { Buffer<Id>(index.GetNumberOfRanks() + vtkIdType(1)), Buffer<Id>(size) };
      tets.Offsets[index.GetNumberOfRanks()] = static_cast<Id>(size);
    }
    std::atomic<bool> mayRepeat(false);
    this->Faces = PairNumbers<Id>(index, triangles,
      [&](Id rank, Id, const Entry* begin, const Entry* end)
      {
        if (triangles == 0)
        {
          const vtkIdType place = index.GetPlace(begin);
          tets.Offsets[rank] = static_cast<Id>(place);
          std::transform(begin, end, tets.Items.data() + place,
            [](const Entry& entry) { return entry.GetPair() / 4; });
        }
        const Entry* first = std::find_if(
          begin, end, [triangles](const Entry& entry) { return entry.GetPair() >= triangles; });
        const auto opposite = [&](vtkIdType i)
        { return this->Cells[3].Vertices[first[i].GetPair() - triangles]; };
        if (MayHaveEqual<Id>(end - first, opposite))
        {
          mayRepeat = true;
        }
      });
    this->MayRepeatTets = mayRepeat;
    this->FindRepeats(2, this->Faces, this->Complex.EqualTriangles);
    this->Complex.NumberOfTriangleCells =
      static_cast<Id>(triangles - this->Complex.EqualTriangles.Twins.size());
    this->Complex.NumberOfFaces = static_cast<Id>(this->Faces.Firsts.size());
    this->Complex.FaceVertices = Buffer<Id>(3 * this->Faces.Firsts.size());
    this->Complex.FaceEdges = Buffer<Id>(3 * this->Faces.Firsts.size());
    ForEach(this->Faces.Firsts.size(), [this](vtkIdType face) { this->WriteFace(face); });
  }

  /// Writes a face as the first cell that has it: a triangle as it runs, a face of a tetrahedron
  /// with its vertices in order.
  void WriteFace(vtkIdType face)
  {
    Id* vertices = this->Complex.FaceVertices.data() + 3 * face;
    Id* edges = this->Complex.FaceEdges.data() + 3 * face;
    const vtkIdType pair = this->Faces.Firsts[face];
    if (pair < this->Count(2))
    {
      std::copy_n(this->GetVertices(2, pair), 3, vertices);
      for (int i = 0; i < 3; ++i)
      {
        edges[i] = this->Edges[this->GetFirstEdge(2, pair) + i];
      }
      return;
    }
    const vtkIdType tet = (pair - this->Count(2)) / 4;
    const Id* ids = this->GetVertices(3, tet);
    const int* local = tetrahedron::FaceVertices[(pair - this->Count(2)) % 4];
    int order[3] = { local[0], local[1], local[2] };
    for (const int i : { 0, 1, 0 })
    {
      if (ids[order[i]] > ids[order[i + 1]])
      {
        std::swap(order[i], order[i + 1]);
      }
    }
    const vtkIdType first = this->GetFirstEdge(3, tet);
    for (int i = 0; i < 3; ++i)
    {
      const int* ends = triangle::EdgeVertices[i];
      vertices[i] = ids[order[i]];
      edges[i] = this->Edges[first + tetrahedron::EdgeOf[order[ends[0]]][order[ends[1]]]];
    }
  }
  void FindTets()
  {
    const vtkIdType tets = this->Count(3);
    SimplicialComplex<Id>& complex = this->Complex;
    complex.TetEdges = TakeNumbers(this->Edges, this->GetFirstEdge(3, 0), 6 * tets);
    complex.TetFaces = TakeNumbers(this->Faces, this->GetFirstFace(0), 4 * tets);
    if (this->MayRepeatTets)
    {
      this->TakeDistinctTets();
    }
    complex.TetVertices = std::move(this->Cells[3].Vertices);
    complex.NumberOfTets = static_cast<Id>(complex.TetVertices.size() / 4);
    if (complex.FaceTets.Offsets.empty())
    {
      complex.FaceTets = ListByRow<Id>(
        complex.NumberOfFaces, complex.TetFaces.size(), [&](vtkIdType i)
        { return complex.TetFaces[i]; }, [](vtkIdType i) { return static_cast<Id>(i / 4); });
    }
  }
  /// Tetrahedra are equal if their largest vertices are, and the faces opposite to these.
  void TakeDistinctTets()
  {
    SimplicialComplex<Id>& complex = this->Complex;
    const vtkIdType tets = this->Count(3);
    const PairIndex<Id> index(tets, complex.NumberOfFaces,
      [&](const auto& use)
      {
        ForEachInTurn(tets,
          [&](vtkIdType tet)
          {
            const Id* ids = this->GetVertices(3, tet);
            const Id* largest = std::max_element(ids, ids + 4);
            use(tet, complex.TetFaces[4 * tet + (largest - ids)], *largest);
          });
      });
    const PairNumbers<Id> numbers(index, tets, [](Id, Id, const Entry*, const Entry*) {});
    this->FindRepeats(3, numbers, complex.EqualTets);
    if (!complex.EqualTets.Twins.empty())
    {
      complex.TetEdges = TakeDistinct(complex.TetEdges, 6, numbers.Firsts);
      complex.TetFaces = TakeDistinct(complex.TetFaces, 4, numbers.Firsts);
      this->Cells[3].Vertices = TakeDistinct(this->Cells[3].Vertices, 4, numbers.Firsts);
      complex.FaceTets = Rows<Id>();
    }
  }

  /// Marks cells that equal an earlier one, and lists them.
  void FindRepeats(int dimension, const PairNumbers<Id>& numbers, EqualCells<Id>& equal)
  {
    CellsOfDimension<Id>& cells = this->Cells[dimension];
    const int corners = dimension + 1;
    vtkIdType count = 0;
    ForEachInTurn(cells.Count, [&](vtkIdType i) { count += numbers.IsRepeated(i) ? 1 : 0; });
    if (count == 0)
    {
      return;
    }
    cells.Repeats = Buffer<bool>(cells.Count);
    equal.Vertices = Buffer<Id>(corners * count);
    equal.Twins = Buffer<Id>(count);
    vtkIdType repeat = 0;
    ForEachInTurn(cells.Count,
      [&](vtkIdType i)
      {
        cells.Repeats[i] = numbers.IsRepeated(i);
        if (cells.Repeats[i])
        {
          std::copy_n(this->GetVertices(dimension, i), corners, &equal.Vertices[corners * repeat]);
          equal.Twins[repeat++] = numbers[i];
        }
      });
  }
  /// Makes the runs of the output: each has one dimension, and either followers only or none.
  std::vector<CellRun> MakeRuns() const
  {
    const std::vector<unsigned char>& dimensions = this->Simplices.Dimensions;
    const vtkIdType size = this->Simplices.GetNumberOfSimplices();
    std::vector<CellRun> runs;
    const int first = size > 0 ? dimensions[0] : 0;
    if (this->Count(first) == size && this->Cells[first].Repeats.empty())
    {
      runs.resize(size > 0 ? 1 : 0, { first, false, 0, size, 0, 0 });
      return runs;
    }
    vtkIdType seen[4] = { 0, 0, 0, 0 };
    vtkIdType next[4][2] = {};
    vtkIdType entry = 0;
    ForEachInTurn(size,
      [&](vtkIdType i)
      {
        const int dimension = dimensions[i];
        const Buffer<bool>& repeats = this->Cells[dimension].Repeats;
        const vtkIdType cell = seen[dimension]++;
        const bool equal = !repeats.empty() && repeats[cell];
        if (runs.empty() || runs.back().Dimension != dimension || runs.back().Equal != equal)
        {
          runs.push_back({ dimension, equal, next[dimension][equal], 0, i, entry });
        }
        ++runs.back().Count;
        ++next[dimension][equal];
        entry += dimension + 1;
      });
    return runs;
  }

  const SimplexList& Simplices;
  CellsOfDimension<Id> Cells[4];
  PairNumbers<Id> Edges;
  PairNumbers<Id> Faces;
  bool MayRepeatTriangles = false;
  bool MayRepeatTets = false;
  SimplicialComplex<Id> Complex;
};

}

template <typename Id>
SimplicialComplex<Id> BuildComplex(const SimplexList& simplices, std::vector<CellRun>& runs)
{
  return ComplexBuilder<Id>(simplices).Build(runs);
}

SUBDIVISION_COMPILE_FUNCTION(BuildComplex);

}
