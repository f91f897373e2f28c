// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridRuns.h
 * The rows of regular places, which are alike: in lattices of hexahedra, and where nothing moves.
 * They have equal weights, so that only columns are made (RowBlock::AddRun). In a lattice a vertex
 * has 27 of them, an edge 18, a quad 12, a centre 8.
 */
#ifndef SubdivisionObjects_HybridRuns_h
#define SubdivisionObjects_HybridRuns_h

#include "Core/Operators/RowBlock.h"
#include "Core/Solids/Hybrid/HybridLevel.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace subdivision
{

template <typename Id>
class HybridRuns
{
public:
  HybridRuns(const HybridLevel<Id>& level, HybridRules rules)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , IsLinear(rules == HybridRules::Linear)
  {
  }

  /// Adds rows from `row` on that are alike, none of them at or after `end`. Returns how many.
  vtkIdType Add(vtkIdType row, vtkIdType end, RowBlock<Id>& block) const
  {
    const CellComplex<Id>& complex = this->Complex;
    const vtkIdType edges = complex.NumberOfVertices;
    const vtkIdType quads = edges + complex.NumberOfEdges;
    const vtkIdType centres = quads + complex.NumberOfQuads;
    if (row < edges)
    {
      return this->AddVertices(row, std::min(end, edges), block);
    }
    if (row < quads)
    {
      return this->AddEdges(row - edges, std::min(end, quads) - row, block);
    }
    if (row < centres)
    {
      return this->AddQuads(row - quads, std::min(end, centres) - row, block);
    }
    return block.AddRun(MeanOfEight, end - row,
      [&](vtkIdType i, Id* columns)
      {
        const vtkIdType cell = complex.CentreCells[row - centres + i];
        const bool isHex = complex.Cells.Shapes[cell] == CellShape::Hex;
        std::copy_n(complex.Cells.GetCorners(cell), isHex ? 8 : 0, columns);
        return isHex;
      });
  }

private:
  /// The corner of a hexahedron that has no face in common with each, and the opposite face.
  static constexpr std::array<unsigned char, 8> Opposite{ { 6, 7, 4, 5, 2, 3, 0, 1 } };
  static constexpr std::array<std::array<unsigned char, 4>, 6> Behind{ { { { 4, 5, 6, 7 } },
    { { 0, 1, 2, 3 } }, { { 3, 2, 6, 7 } }, { { 0, 3, 7, 4 } }, { { 0, 1, 5, 4 } },
    { { 1, 2, 6, 5 } } } };
  /// The corners across each quad at a corner, and that quad.
  struct Diagonal
  {
    unsigned char Corner;
    unsigned char Quad;
  };
  static constexpr std::array<std::array<Diagonal, 3>, 8> Across{
    { { { { 2, 0 }, { 5, 2 }, { 7, 5 } } }, { { { 3, 0 }, { 4, 2 }, { 6, 3 } } },
      { { { 0, 0 }, { 5, 3 }, { 7, 4 } } }, { { { 1, 0 }, { 4, 5 }, { 6, 4 } } },
      { { { 1, 2 }, { 3, 5 }, { 6, 1 } } }, { { { 0, 2 }, { 2, 3 }, { 7, 1 } } },
      { { { 1, 3 }, { 3, 4 }, { 4, 1 } } }, { { { 0, 5 }, { 2, 4 }, { 5, 1 } } } }
  };

  /// Some entries of one weight after another.
  struct Entries
  {
    std::size_t Count;
    double Weight;
  };
  template <std::size_t N>
  static constexpr std::array<double, N> MakeWeights(std::initializer_list<Entries> entries)
  {
    std::array<double, N> weights{};
    std::size_t i = 0;
    for (const Entries& some : entries)
    {
      for (std::size_t k = 0; k < some.Count; ++k)
      {
        weights[i++] = some.Weight;
      }
    }
    return weights;
  }
  inline static const std::array<double, 2> MeanOfTwo = MakeWeights<2>({ { 2, 1. / 2. } });
  inline static const std::array<double, 4> MeanOfFour = MakeWeights<4>({ { 4, 1. / 4. } });
  inline static const std::array<double, 8> MeanOfEight = MakeWeights<8>({ { 8, 1. / 8. } });
  inline static const std::array<double, 12> OfQuad =
    MakeWeights<12>({ { 4, 3. / 16. }, { 8, 1. / 32. } });
  inline static const std::array<double, 18> OfEdge =
    MakeWeights<18>({ { 2, 9. / 32. }, { 8, 3. / 64. }, { 8, 1. / 128. } });
  inline static const std::array<double, 27> OfVertex =
    MakeWeights<27>({ { 1, 27. / 64. }, { 6, 9. / 128. }, { 12, 3. / 256. }, { 8, 1. / 512. } });

  vtkIdType AddVertices(vtkIdType first, vtkIdType end, RowBlock<Id>& block) const
  {
    if (this->IsLinear)
    {
      block.AddCopies(first, end - first);
      return end - first;
    }
    return block.AddRun(OfVertex, end - first, [&](vtkIdType i, Id* columns)
      { return this->FillVertex(static_cast<Id>(first + i), columns); });
  }
  vtkIdType AddEdges(vtkIdType first, vtkIdType count, RowBlock<Id>& block) const
  {
    const Id* ends = this->Complex.EdgeVertices.data() + 2 * first;
    if (this->IsLinear)
    {
      return block.AddRun(MeanOfTwo, count,
        [&](vtkIdType i, Id* columns)
        {
          std::copy_n(ends + 2 * i, 2, columns);
          return true;
        });
    }
    return block.AddRun(OfEdge, count, [&](vtkIdType i, Id* columns)
      { return this->FillEdge(static_cast<Id>(first + i), ends + 2 * i, columns); });
  }
  vtkIdType AddQuads(vtkIdType first, vtkIdType count, RowBlock<Id>& block) const
  {
    const Id* corners = this->Complex.FaceVertices.data() + 4 * first;
    if (this->IsLinear)
    {
      return block.AddRun(MeanOfFour, count,
        [&](vtkIdType i, Id* columns)
        {
          std::copy_n(corners + 4 * i, 4, columns);
          return true;
        });
    }
    return block.AddRun(OfQuad, count, [&](vtkIdType i, Id* columns)
      { return this->FillQuad(static_cast<Id>(first + i), corners + 4 * i, columns); });
  }

  /// Whether solids are so many hexahedra.
  bool AreHexes(Row<Id> solids, vtkIdType count) const
  {
    return solids.size() == count &&
      std::all_of(solids.begin(), solids.end(),
        [this](Id cell) { return this->Complex.Cells.Shapes[cell] == CellShape::Hex; });
  }
  static int FindCorner(const Id* corners, Id vertex)
  {
    int place = 0;
    while (place < 7 && corners[place] != vertex)
    {
      ++place;
    }
    return place;
  }

  bool FillVertex(Id vertex, Id* columns) const
  {
    const Row<Id> edges = this->Complex.VertexEdges[vertex];
    const Row<Id> solids = this->Complex.VertexSolids[vertex];
    if (this->Strata.Vertices[vertex].Result.GetRule() != Rule::Solid || edges.size() != 6 ||
      !this->AreHexes(solids, 8))
    {
      return false;
    }
    *columns++ = vertex;
    for (const Id edge : edges)
    {
      if (this->Complex.EdgeSolids[edge].size() != 4)
      {
        return false;
      }
      *columns++ = this->Complex.GetOtherEnd(edge, vertex);
    }
    // Twelve corners across quads: each from the first of the two hexahedra at the quad.
    Id* across = columns;
    Id* const opposite = columns + 12;
    Id* end = opposite;
    for (const Id cell : solids)
    {
      const Id* corners = this->Complex.Cells.GetCorners(cell);
      const Id* quads = this->Complex.CellFaces[cell].begin();
      const int place = FindCorner(corners, vertex);
      for (const Diagonal& diagonal : Across[place])
      {
        const Row<Id> sides = this->Complex.FaceSolids[quads[diagonal.Quad]];
        if (sides.size() != 2)
        {
          return false;
        }
        if (*sides.begin() == cell && across != opposite)
        {
          *across++ = corners[diagonal.Corner];
        }
      }
      *end++ = corners[Opposite[place]];
    }
    return across == opposite;
  }

  bool FillEdge(Id edge, const Id* ends, Id* columns) const
  {
    const Row<Id> faces = this->Complex.EdgeFaces[edge];
    const Row<Id> solids = this->Complex.EdgeSolids[edge];
    if (this->Strata.Edges[edge].Result.GetRule() != Rule::Solid || faces.size() != 4 ||
      !this->AreHexes(solids, 4))
    {
      return false;
    }
    columns = std::copy_n(ends, 2, columns);
    for (const Id face : faces)
    {
      if (face >= this->Complex.NumberOfQuads)
      {
        return false;
      }
      const Id* corners = this->Complex.FaceVertices.data() + 4 * vtkIdType(face);
      const Id* own = this->Complex.FaceEdges.data() + 4 * vtkIdType(face);
      const auto place = std::find(own, own + 3, edge) - own;
      *columns++ = corners[(place + 2) % 4];
      *columns++ = corners[(place + 3) % 4];
    }
    for (const Id cell : solids)
    {
      const Id* corners = this->Complex.Cells.GetCorners(cell);
      *columns++ = corners[Opposite[FindCorner(corners, ends[0])]];
      *columns++ = corners[Opposite[FindCorner(corners, ends[1])]];
    }
    return true;
  }

  bool FillQuad(Id face, const Id* corners, Id* columns) const
  {
    const Row<Id> solids = this->Complex.FaceSolids[face];
    if (this->Strata.Faces[face].GetRule() != Rule::Solid || !this->AreHexes(solids, 2))
    {
      return false;
    }
    columns = std::copy_n(corners, 4, columns);
    for (const Id cell : solids)
    {
      const Id* faces = this->Complex.CellFaces[cell].begin();
      const Id* from = this->Complex.Cells.GetCorners(cell);
      for (const unsigned char k : Behind[std::find(faces, faces + 5, face) - faces])
      {
        *columns++ = from[k];
      }
    }
    return true;
  }

  const CellComplex<Id>& Complex;
  const HybridStrata<Id>& Strata;
  const bool IsLinear;
};

}

#endif
