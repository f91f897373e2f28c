// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridShading.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Solids/Hybrid/HybridRowSum.h"
#include "Core/Solids/Limits/ShadingParts.h"

#include "vtkSMPThreadLocal.h"

#include <memory>
#include <unordered_map>

namespace subdivision
{
namespace
{

/// Local matrices are full ones. Larger stars are those of the level.
constexpr std::size_t MostItems = 200;

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

  ShadingStars<Id> Build(int made)
  {
    this->Collect();
    this->Parts.ListStars(
      this->Complex.NumberOfVertices, [](Id vertex) { return vertex; },
      [this](const Part& part, typename ShadingStars<Id>::Corner& corner)
      {
        corner.Side = this->Faces.IsSide(part.Face)
          ? this->Faces.GetSide(part.Face, part.Vertex, part.Edges[0])
          : -1;
        const Id polygon = corner.Side < 0 ? this->Polygons[part.Face] : Id(-1);
        corner.Parent = polygon < 0
          ? polygon
          : static_cast<Id>(this->Controls[static_cast<std::size_t>(polygon)]);
      });
    const HybridRows<Id> step(this->Here, HybridRules::Smooth);
    vtkSMPThreadLocal<std::shared_ptr<StarRowMaker<Id>>> makers; // each keeps its solutions
    return this->Parts.MakeRows(this->Complex.NumberOfVertices,
      [&]
      {
        auto& maker = makers.Local();
        if (!maker)
        {
          maker = std::make_shared<StarRowMaker<Id>>(this->Here, step, made);
        }
        return [this, maker](vtkIdType star, RowBlock<Id>& rows)
        {
          maker->Append(this->Parts.GetVertex(star), this->Parts.GetEdges(star),
            this->Parts.GetCorners(star), rows);
        };
      });
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
      this->Parts.Add(part);
    }
  }

  const HybridLevel<Id>& Here;
  const CellComplex<Id>& Complex;
  const FacesOfControl<Id> Faces;
  const std::vector<vtkIdType>& Controls;
  const Buffer<unsigned char>& Missing;
  Buffer<Id> Polygons;
  ShadingParts<Id> Parts; ///< an edge by its other end
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
