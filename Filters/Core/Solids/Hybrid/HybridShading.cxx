// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridShading.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Solids/Hybrid/HybridRowSum.h"

#include "vtkSMPThreadLocal.h"

#include <memory>
#include <unordered_map>

namespace subdivision
{
namespace
{

/// Local matrices are full ones. Larger stars are those of the level.
constexpr std::size_t MostItems = 200;

/// What lies at a vertex: a corner of a face between two edges, or a line with one edge, or
/// nothing.
template <typename Id>
struct ShadingPart
{
  Id Vertex;
  Id Ends[2]; ///< of the edges; -1: none
  Id Face;
};

/// The rows of the far ends of some edges at a vertex, seen from there.
template <typename Id>
class StarRowMaker
{
public:
  StarRowMaker(const HybridLevel<Id>& level, const HybridRows<Id>& rows, int made)
    : Here(level)
    , Reader(rows.StartRows())
    , Star(level)
    , Made(made)
  {
  }

  /// Appends one row for each of `ends`; `corners` are pairs of these, from 1 on.
  void Append(Id vertex, const std::vector<Id>& ends,
    const std::vector<std::array<int, 2>>& corners, RowBlock<Id>& rows)
  {
    this->Star.ReadStar(vertex);
    const bool isCurve = corners.empty() && ends.size() == 2 &&
      this->Here.Strata.Vertices[vertex].Result.GetRule() == Rule::Curve;
    if (isCurve || this->Star.Numbers.Vertices.size() > MostItems)
    {
      for (const Id end : ends)
      {
        rows.Add(vertex, -1.);
        rows.Add(end, 1.);
        rows.EndRow();
      }
      return;
    }
    const Known& known = this->Find(ends, corners);
    const std::size_t size = known.Items;
    for (const int item : known.Ends)
    {
      this->Reader.AddItems(this->Star, known.Points,
        known.Rows.data() + static_cast<std::size_t>(item - 1) * size, size,
        [&](Id column, double weight) { this->Sum.Add(column, weight); });
      this->Sum.EndRow(rows);
    }
  }

private:
  struct Known
  {
    std::size_t Items = 0;
    std::vector<double> Rows; ///< of all items but the first
    std::vector<std::array<int, 2>> Points;
    std::vector<int> Ends; ///< items
  };

  const Known& Find(const std::vector<Id>& ends, const std::vector<std::array<int, 2>>& corners)
  {
    Neighbourhood key = this->Star.Key;
    key.push_back(-1);
    for (const Id end : ends)
    {
      key.push_back(static_cast<int>(this->Star.Numbers.Find(end)));
    }
    for (const std::array<int, 2>& corner : corners)
    {
      key.insert(key.end(), corner.begin(), corner.end());
    }
    if (this->Solved.size() > MostSolutions / 16)
    {
      this->Solved.clear();
    }
    Known& known = this->Solved[this->Star.IsPlain() ? key : Neighbourhood()];
    if (known.Items == 0 || !this->Star.IsPlain())
    {
      known = this->Solve(ends, corners);
    }
    return known;
  }

  Known Solve(const std::vector<Id>& ends, const std::vector<std::array<int, 2>>& corners)
  {
    LocalItems items = ReadLocalItems(this->Star, this->Reader);
    Known known;
    known.Items = items.Rows.GetNumberOfItems();
    known.Points = items.Points;
    for (const Id end : ends)
    {
      known.Ends.push_back(this->FindItem(known.Points, end));
    }
    std::vector<std::array<int, 2>> pairs;
    for (const std::array<int, 2>& corner : corners)
    {
      pairs.push_back({ { known.Ends[static_cast<std::size_t>(corner[0] - 1)],
        known.Ends[static_cast<std::size_t>(corner[1] - 1)] } });
    }
    known.Rows =
      FindStarRows(items.Rows.Fill(), known.Items, pairs, this->Made + items.CountSteps());
    for (std::size_t i = 0; !items.Steps.empty() && i < known.Rows.size(); i += known.Items)
    {
      const auto row = known.Rows.begin() + static_cast<std::ptrdiff_t>(i);
      const std::vector<double> later(row, row + static_cast<std::ptrdiff_t>(known.Items));
      std::vector<double> back = items.StepBack(later);
      std::copy(back.begin(), back.end(), row);
    }
    return known;
  }

  /// The item at the far end of an edge: the end itself, or the middle of the edge.
  int FindItem(const std::vector<std::array<int, 2>>& points, Id end) const
  {
    const CellComplex<Id>& complex = this->Here.Complex;
    return LocalReader<Id>::FindItem(this->Star, points, end,
      vtkIdType(complex.NumberOfVertices) + complex.FindEdge(this->Star.Numbers.Vertices[0], end));
  }

  const HybridLevel<Id>& Here;
  LocalReader<Id> Reader;
  HybridPatch<Id> Star;
  HybridRowSum<Id> Sum;
  const int Made;
  std::unordered_map<Neighbourhood, Known, HashNeighbourhood> Solved;
};

template <typename Id>
class HybridShadingBuilder
{
public:
  using Stars = ShadingStars<Id>;
  using Part = ShadingPart<Id>;

  HybridShadingBuilder(const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls,
    const Buffer<unsigned char>& missing)
    : Here(level)
    , Complex(level.Complex)
    , Faces(level.Complex, controls)
    , Controls(controls)
    , Missing(missing)
  {
  }

  Stars Build(int made)
  {
    this->Collect();
    const Rows<vtkIdType> parts = ListByRow<vtkIdType>(
      this->Complex.NumberOfVertices, static_cast<vtkIdType>(this->Parts.size()),
      [this](vtkIdType i) { return this->Parts[static_cast<std::size_t>(i)].Vertex; },
      [](vtkIdType i) { return i; });
    for (const Id v : InTurn(static_cast<Id>(this->Complex.NumberOfVertices)))
    {
      if (parts[v].size() > 0)
      {
        this->AddStar(v, parts[v]);
      }
    }
    this->Found.Stars.push_back(this->GetEnd());
    this->MakeRows(made);
    return std::move(this->Found);
  }

private:
  void Collect()
  {
    this->FindPolygons();
    for (const Id f : InTurn(static_cast<Id>(this->Complex.NumberOfFaces)))
    {
      const Id cell = this->Polygons[f];
      const Id* corners =
        cell < 0 ? this->Complex.GetVertices(f).begin() : this->Complex.Cells.GetCorners(cell);
      const int size = this->Complex.GetSize(f);
      for (int k = 0; k < size && (cell >= 0 || this->Complex.FaceSolids[f].size() < 2); ++k)
      {
        this->Add({ corners[k], { corners[(k + 1) % size], corners[(k + size - 1) % size] }, f });
      }
    }
    const CellList<Id>& cells = this->Complex.Cells;
    std::vector<char> isDone(static_cast<std::size_t>(this->Complex.NumberOfEdges), 0);
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      const Id* corners = cells.GetCorners(c);
      if (cells.Shapes[c] == CellShape::Line)
      {
        char& wasThere = isDone[static_cast<std::size_t>(*this->Complex.CellEdges[c].begin())];
        for (int end = 0; end < 2 && !wasThere; ++end)
        {
          this->Add({ corners[end], { corners[1 - end], Id(-1) }, Id(-1) });
        }
        wasThere = 1;
      }
      else if (cells.Shapes[c] == CellShape::Vertex)
      {
        this->Add({ corners[0], { Id(-1), Id(-1) }, Id(-1) });
      }
    }
  }
  /// The first cell that each face is.
  void FindPolygons()
  {
    this->Polygons = Buffer<Id>(this->Complex.NumberOfFaces, Id(-1));
    ForEachInTurn(this->Complex.Cells.GetNumberOfCells(),
      [this](vtkIdType c)
      {
        if (this->Complex.Cells.GetTable(c).Dimension == 2)
        {
          Id& polygon = this->Polygons[*this->Complex.CellFaces[c].begin()];
          polygon = polygon < 0 ? static_cast<Id>(c) : polygon;
        }
      });
  }
  void Add(const Part& part)
  {
    if (this->Missing[part.Vertex])
    {
      this->Parts.push_back(part);
    }
  }

  typename Stars::Star GetEnd() const
  {
    typename Stars::Star end;
    end.FirstRow = this->NumberOfRows;
    end.FirstCorner = static_cast<vtkIdType>(this->Found.Corners.size());
    end.FirstLine = static_cast<vtkIdType>(this->Found.Lines.size());
    return end;
  }

  /// Adds a star whose rows are not made yet.
  void AddStar(Id vertex, const Row<vtkIdType>& parts)
  {
    typename Stars::Star star = this->GetEnd();
    star.Row = vertex;
    std::vector<Id> ends;
    const auto number = [&ends](Id end)
    {
      const auto at = std::find(ends.begin(), ends.end(), end);
      const auto place = static_cast<Id>(at - ends.begin());
      at == ends.end() ? ends.push_back(end) : void();
      return place;
    };
    for (const vtkIdType i : parts)
    {
      const Part& part = this->Parts[static_cast<std::size_t>(i)];
      if (part.Face >= 0)
      {
        const vtkIdType side = this->Faces.IsSide(part.Face)
          ? this->Faces.GetSide(part.Face, part.Vertex, part.Ends[0])
          : -1;
        const Id first = number(part.Ends[0]);
        const Id polygon = side < 0 ? this->Polygons[part.Face] : Id(-1);
        this->Found.Corners.push_back({ { first, number(part.Ends[1]) },
          polygon < 0 ? polygon
                      : static_cast<Id>(this->Controls[static_cast<std::size_t>(polygon)]),
          side });
      }
      else if (part.Ends[0] >= 0 && star.FirstCorner == this->GetEnd().FirstCorner)
      {
        this->Found.Lines.push_back(number(part.Ends[0]));
      }
    }
    this->NumberOfRows += static_cast<vtkIdType>(ends.size());
    this->Ends.push_back(std::move(ends));
    this->Found.Stars.push_back(star);
  }

  void MakeRows(int made)
  {
    const HybridRows<Id> step(this->Here, HybridRules::Smooth);
    using Maker = StarRowMaker<Id>;
    vtkSMPThreadLocal<std::shared_ptr<Maker>> makers; // each keeps its solutions
    const auto size = static_cast<vtkIdType>(this->Ends.size());
    std::vector<RowBlock<Id>> blocks(static_cast<std::size_t>(size));
    ForRangesOfBlocks(
      size,
      [&](vtkIdType begin, vtkIdType end)
      {
        auto& maker = makers.Local();
        if (!maker)
        {
          maker = std::make_shared<Maker>(this->Here, step, made);
        }
        for (vtkIdType s = begin; s < end; ++s)
        {
          const auto place = static_cast<std::size_t>(s);
          std::vector<std::array<int, 2>> corners;
          for (vtkIdType i = this->Found.Stars[place].FirstCorner;
            i < this->Found.Stars[place + 1].FirstCorner; ++i)
          {
            const Id* ends = this->Found.Corners[static_cast<std::size_t>(i)].Ends;
            corners.push_back({ { static_cast<int>(ends[0]) + 1, static_cast<int>(ends[1]) + 1 } });
          }
          maker->Append(this->Found.Stars[place].Row, this->Ends[place], corners, blocks[place]);
        }
      },
      64);
    this->Store(blocks);
  }

  void Store(const std::vector<RowBlock<Id>>& blocks)
  {
    SparseRows<Id>& rows = this->Found.Rows;
    rows.NumberOfColumns = this->Complex.NumberOfVertices;
    rows.Offsets = Buffer<Id>(this->NumberOfRows + 1, Id(0));
    std::vector<Id> columns;
    std::vector<double> weights;
    vtkIdType row = 0;
    for (const RowBlock<Id>& block : InTurn(blocks))
    {
      for (std::size_t r = 0; r < block.GetNumberOfRows(); ++r)
      {
        rows.Offsets[++row] = static_cast<Id>(columns.size() + block.GetEnd(r));
      }
      const std::size_t size = block.GetNumberOfEntries();
      columns.insert(columns.end(), block.GetColumns(), block.GetColumns() + size);
      weights.insert(weights.end(), block.GetWeights(), block.GetWeights() + size);
    }
    rows.Columns = Buffer<Id>(static_cast<vtkIdType>(columns.size()));
    rows.Weights = Buffer<double>(static_cast<vtkIdType>(weights.size()));
    std::copy(columns.begin(), columns.end(), rows.Columns.begin());
    std::copy(weights.begin(), weights.end(), rows.Weights.begin());
  }

  const HybridLevel<Id>& Here;
  const CellComplex<Id>& Complex;
  const FacesOfControl<Id> Faces;
  const std::vector<vtkIdType>& Controls;
  const Buffer<unsigned char>& Missing;
  Buffer<Id> Polygons;
  std::vector<Part> Parts;
  Stars Found;
  vtkIdType NumberOfRows = 0;
  std::vector<std::vector<Id>> Ends; ///< of each star; its rows in this order
};

}

template <typename Id>
ShadingStars<Id> BuildHybridShading(const HybridLevel<Id>& level,
  const std::vector<vtkIdType>& controls, const Buffer<unsigned char>& missing, int made)
{
  return HybridShadingBuilder<Id>(level, controls, missing).Build(made);
}

SUBDIVISION_COMPILE_FUNCTION(BuildHybridShading);

}
