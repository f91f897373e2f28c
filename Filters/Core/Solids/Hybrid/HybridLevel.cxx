// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridLevel.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Rules/Masks.h"
#include "Core/Solids/Hybrid/HybridMasks.h"
#include "Core/Solids/Hybrid/HybridRowSum.h"
#include "Core/Solids/Hybrid/HybridRuns.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace subdivision
{
namespace
{

/// The hexahedra and wedges of a product edge; Others: it is none.
struct ProductEdge
{
  vtkIdType Hexes = 0;
  vtkIdType Wedges = 0;
  bool HasOthers = false;

  bool IsLike(const ProductEdge& other) const
  {
    return !other.HasOthers && this->Hexes == other.Hexes && this->Wedges == other.Wedges;
  }
};

/// Makes the rows of a level.
template <typename Id>
class RowMaker
{
public:
  RowMaker(const CellComplex<Id>& complex, const HybridStrata<Id>& strata, HybridRules rules,
    const Buffer<unsigned char>& relaxed)
    : Complex(complex)
    , Strata(strata)
    , IsLinear(rules == HybridRules::Linear)
    , AreRelaxed(relaxed)
  {
  }

  void AddRow(vtkIdType row, RowBlock<Id>& block)
  {
    const CellComplex<Id>& complex = this->Complex;
    const vtkIdType edge = row - complex.NumberOfVertices;
    const vtkIdType face = edge - complex.NumberOfEdges;
    const vtkIdType centre = face - complex.NumberOfQuads;
    if (edge < 0)
    {
      this->AddVertex(static_cast<Id>(row));
    }
    else if (face < 0)
    {
      this->AddEdge(static_cast<Id>(edge));
    }
    else if (centre < 0)
    {
      this->AddQuad(static_cast<Id>(face));
    }
    else
    {
      const vtkIdType cell = complex.CentreCells[centre];
      const Id* corners = complex.Cells.GetCorners(cell);
      this->AddMean(corners, corners + complex.Cells.GetTable(cell).Corners, 1.);
    }
    this->Sum.EndRow(block);
  }

  /// Whether an edge with d = 3 has only hexahedra, and wedges along their axes.
  ProductEdge FindProduct(Id edge) const
  {
    ProductEdge product;
    // A crease that ends as a dart is part of the column at its end.
    const Rule rule = this->Strata.Edges[edge].Result.GetRule();
    product.HasOthers = rule != Rule::Solid && rule != Rule::Curve;
    for (const Id cell : this->Complex.EdgeSolids[edge])
    {
      const CellShape shape = this->Complex.Cells.Shapes[cell];
      const bool isHex = shape == CellShape::Hex;
      const bool isWedge = shape == CellShape::Wedge && this->FindEdgeIn(cell, edge) >= 6;
      product.Hexes += isHex ? 1 : 0;
      product.Wedges += isWedge ? 1 : 0;
      product.HasOthers = product.HasOthers || (!isHex && !isWedge);
    }
    return product;
  }
  double GetRelaxationOf(const ProductEdge& product) const
  {
    return product.HasOthers ? 1.
                             : GetRelaxation(product.Hexes, product.Wedges, this->Strata.Weights);
  }

private:
  int FindEdgeIn(Id cell, Id edge) const
  {
    const Row<Id> edges = this->Complex.CellEdges[cell];
    return static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
  }

  void AddMean(const Id* begin, const Id* end, double weight)
  {
    for (const Id* vertex = begin; vertex != end; ++vertex)
    {
      this->Sum.Add(*vertex, weight / static_cast<double>(end - begin));
    }
  }
  void AddMiddle(Id edge, double weight)
  {
    const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
    this->AddMean(ends, ends + 2, weight);
  }

  /// Adds the mean over solids of their shares in the same local point; local(cell) tells which.
  template <typename Local>
  void AddSolids(Row<Id> solids, double weight, const Local& local)
  {
    this->Masks.clear();
    double all = 0.;
    for (const Id cell : solids)
    {
      this->Masks.push_back(&GetSolidMasks(this->Complex.Cells.Shapes[cell])[local(cell)]);
      all += this->Masks.back()->Weight;
    }
    const SolidMask* const* mask = this->Masks.data();
    for (const Id cell : solids)
    {
      const Id* corners = this->Complex.Cells.GetCorners(cell);
      const Id* end = this->Complex.Cells.GetCorners(cell + 1);
      const double* share = (*mask++)->Shares;
      while (corners != end)
      {
        this->Sum.Add(*corners++, *share++ * (weight / all));
      }
    }
  }

  // Vertices.
  void AddVertex(Id vertex)
  {
    const Decision decision = this->IsLinear ? Decision() : this->Strata.Vertices[vertex];
    switch (this->IsLinear ? Rule::Corner : decision.Result.GetRule())
    {
      case Rule::Corner:
        this->Sum.Add(vertex, 1.);
        break;
      case Rule::Curve:
      {
        const CurveVertex<Id>& curve = this->Strata.GetCurve(vertex);
        this->Sum.Add(vertex, 3. / 4.);
        this->Sum.Add(curve.Ring[0], 1. / 8.);
        this->Sum.Add(curve.Ring[1], 1. / 8.);
        break;
      }
      case Rule::Surface:
        this->AddVertexOfSurface(vertex, decision);
        break;
      case Rule::Blend:
        this->AddJoint(vertex, decision);
        break;
      default:
        this->AddVertexOfSolid(vertex);
        break;
    }
  }

  void AddVertexOfSurface(Id vertex, const Decision& decision)
  {
    this->Faces.clear();
    vtkIdType quads = 0;
    for (const Id edge : this->Complex.VertexEdges[vertex])
    {
      for (const Id face : this->Complex.EdgeFaces[edge])
      {
        const Row<Id> vertices = this->Complex.GetVertices(face);
        const auto place = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
        // Each face once, at the edge to its next vertex.
        if (this->Complex.GetEdges(face).begin()[place] == edge &&
          IsInRing(this->Complex, this->Strata, face, decision))
        {
          this->Faces.push_back({ face, static_cast<int>(place) });
          quads += vertices.size() == 4 ? 1 : 0;
        }
      }
    }
    const vtkIdType triangles = static_cast<vtkIdType>(this->Faces.size()) - quads;
    const double w = GetRelaxation(quads, triangles, this->Strata.Weights);
    const double unit = w / static_cast<double>(3 * quads + 2 * triangles);
    this->Sum.Add(vertex, 1. - w);
    for (const auto& [face, place] : this->Faces)
    {
      const Id* vertices = this->Complex.GetVertices(face).begin();
      if (this->Complex.GetSize(face) == 4)
      {
        constexpr double shares[4] = { 27. / 16., 9. / 16., 3. / 16., 9. / 16. };
        for (int k = 0; k < 4; ++k)
        {
          this->Sum.Add(vertices[(place + k) % 4], shares[k] * unit);
        }
      }
      else
      {
        for (int k = 0; k < 3; ++k)
        {
          this->Sum.Add(vertices[(place + k) % 3], (k == 0 ? 5. / 4. : 3. / 8.) * unit);
        }
      }
    }
  }

  void AddJoint(Id vertex, const Decision& decision)
  {
    const auto isIn = [&](Id edge)
    { return (this->GetDimensions(edge) & decision.Dimensions) != 0; };
    const Row<Id> edges = this->Complex.VertexEdges[vertex];
    const vtkIdType size = std::count_if(edges.begin(), edges.end(), isIn);
    const Mask mask = VertexMask(Rule::Blend, size, this->Strata.Weights);
    this->Sum.Add(vertex, mask.Own);
    for (const Id edge : edges)
    {
      if (isIn(edge))
      {
        this->Sum.Add(this->Complex.GetOtherEnd(edge, vertex), mask.Ring);
      }
    }
  }
  unsigned char GetDimensions(Id edge) const
  {
    unsigned char dimensions = 0;
    for (const Id face : this->Complex.EdgeFaces[edge])
    {
      dimensions |= DimensionBit(this->Complex.FaceSolids[face].size() > 0 ? 3 : 2);
    }
    return dimensions ? dimensions : DimensionBit(1);
  }

  void AddVertexOfSolid(Id vertex)
  {
    double w = 1.;
    if (!this->AreRelaxed.empty())
    {
      Id column[2];
      w = this->FindColumn(vertex, column);
      if (w != 1.)
      {
        this->Sum.Add(vertex, (1. - w) * 3. / 4.);
        for (const Id edge : column)
        {
          this->Sum.Add(this->Complex.GetOtherEnd(edge, vertex), (1. - w) / 8.);
        }
      }
    }
    this->AddSolids(this->Complex.VertexSolids[vertex], w,
      [&](Id cell)
      {
        const Id* corners = this->Complex.Cells.GetCorners(cell);
        return std::find(corners, corners + 8, vertex) - corners;
      });
  }

  /// Whether two product edges at a vertex are alike, and each solid at it has exactly one of them:
  /// then w, or else 1.
  double FindColumn(Id vertex, Id (&column)[2]) const
  {
    const Row<Id> edges = this->Complex.VertexEdges[vertex];
    for (const Id* a = edges.begin(); a != edges.end(); ++a)
    {
      if (!this->AreRelaxed[*a])
      {
        continue;
      }
      const ProductEdge product = this->FindProduct(*a);
      for (const Id* b = a + 1; b != edges.end(); ++b)
      {
        if (this->AreRelaxed[*b] && product.IsLike(this->FindProduct(*b)) &&
          this->AreBetween(vertex, *a, *b))
        {
          column[0] = *a;
          column[1] = *b;
          return this->GetRelaxationOf(product);
        }
      }
    }
    return 1.;
  }
  bool AreBetween(Id vertex, Id a, Id b) const
  {
    const Row<Id> solids = this->Complex.VertexSolids[vertex];
    return std::all_of(solids.begin(), solids.end(),
      [&](Id cell)
      {
        const Row<Id> edges = this->Complex.CellEdges[cell];
        return std::count_if(
                 edges.begin(), edges.end(), [&](Id edge) { return edge == a || edge == b; }) == 1;
      });
  }

  // Edges.
  void AddEdge(Id edge)
  {
    const Decision decision = this->IsLinear ? Decision() : this->Strata.Edges[edge];
    switch (this->IsLinear ? Rule::Curve : decision.Result.GetRule())
    {
      case Rule::Curve:
      case Rule::Corner:
        this->AddMiddle(edge, 1.);
        break;
      case Rule::Surface:
        this->AddEdgeOfSurface(edge, decision);
        break;
      case Rule::Blend:
        this->AddJointEdge(edge, decision);
        break;
      default:
      {
        const double w = this->AreRelaxed.empty() || !this->AreRelaxed[edge]
          ? 1.
          : this->GetRelaxationOf(this->FindProduct(edge));
        if (w != 1.)
        {
          this->AddMiddle(edge, 1. - w);
        }
        this->AddSolids(this->Complex.EdgeSolids[edge], w, [&](Id cell)
          { return this->Complex.Cells.GetTable(cell).Corners + this->FindEdgeIn(cell, edge); });
        break;
      }
    }
  }

  /// Adds the mean of the corners of a face that do not lie on one of its edges.
  void AddOthers(Id face, Id edge, double weight)
  {
    const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
    for (const Id vertex : this->Complex.GetVertices(face))
    {
      if (vertex != ends[0] && vertex != ends[1])
      {
        this->Sum.Add(vertex, weight / (this->Complex.GetSize(face) - 2));
      }
    }
  }

  void AddEdgeOfSurface(Id edge, const Decision& decision)
  {
    const SectorEdgeRange<Id> sectors = FindSectorEdges(this->Strata.Sectors, edge);
    const SectorMask mask = GetSectorMask(sectors);
    for (int i = 0; i < 2; ++i)
    {
      this->Sum.Add(this->Complex.EdgeVertices[2 * vtkIdType(edge) + i], mask.Ends[i]);
    }
    for (const Id face : this->Complex.EdgeFaces[edge])
    {
      if (IsInRing(this->Complex, this->Strata, face, decision))
      {
        this->AddOthers(face, edge, mask.Ring);
      }
    }
    for (const SectorEdge<Id>& sector : sectors)
    {
      for (int i = 0; i < 2 && sector.Flatness > 0.; ++i)
      {
        this->Sum.Add(sector.Ends[i], mask.Bounds[sector.End][i]);
      }
    }
  }

  void AddJointEdge(Id edge, const Decision& decision)
  {
    const Row<Id> faces = this->Complex.EdgeFaces[edge];
    const auto isIn = [&](Id face)
    { return IsInRing(this->Complex, this->Strata, face, decision); };
    const std::vector<Id>* relief = this->Strata.Reliefs.empty()
      ? nullptr
      : &this->Strata.Reliefs[static_cast<std::size_t>(edge)];
    const auto size = std::count_if(faces.begin(), faces.end(), isIn) +
      (relief ? static_cast<std::ptrdiff_t>(relief->size()) : 0);
    const Mask mask = EdgeMask(Rule::Blend, size);
    this->AddMiddle(edge, 2. * mask.Own);
    for (const Id face : faces)
    {
      if (isIn(face))
      {
        this->AddOthers(face, edge, mask.Ring);
      }
    }
    for (std::size_t i = 0; relief && i < relief->size(); ++i)
    {
      this->Sum.Add((*relief)[i], mask.Ring);
    }
  }

  // Quads.
  void AddQuad(Id face)
  {
    const Rule rule = this->IsLinear ? Rule::Surface : this->Strata.Faces[face].GetRule();
    if (rule == Rule::Surface || rule == Rule::Curve)
    {
      const Row<Id> vertices = this->Complex.GetVertices(face);
      this->AddMean(vertices.begin(), vertices.end(), 1.);
      return;
    }
    this->AddSolids(this->Complex.FaceSolids[face], 1.,
      [&](Id cell)
      {
        const CellTable& table = this->Complex.Cells.GetTable(cell);
        const Id* faces = this->Complex.CellFaces[cell].begin();
        const auto quad = std::find_if(table.Quads.begin(), table.Quads.end(),
          [&](unsigned char f) { return faces[f] == face; });
        return table.Corners + static_cast<std::ptrdiff_t>(table.Edges.size()) +
          (quad - table.Quads.begin());
      });
  }

  const CellComplex<Id>& Complex;
  const HybridStrata<Id>& Strata;
  const bool IsLinear;
  const Buffer<unsigned char>& AreRelaxed;
  HybridRowSum<Id> Sum;
  std::vector<const SolidMask*> Masks;   ///< of the solids at a point
  std::vector<std::pair<Id, int>> Faces; ///< at a vertex, and its place in each
};

/// Finds the edges whose w is not 1; empty: there are none.
template <typename Id>
Buffer<unsigned char> FindRelaxed(const CellComplex<Id>& complex, const HybridStrata<Id>& strata)
{
  const vtkIdType size = complex.NumberOfEdges;
  const Buffer<unsigned char> none;
  const RowMaker<Id> maker(complex, strata, HybridRules::Smooth, none);
  Buffer<unsigned char> relaxed(size);
  ForEach(size,
    [&](vtkIdType e)
    {
      const ProductEdge product = maker.FindProduct(static_cast<Id>(e));
      relaxed[e] = maker.GetRelaxationOf(product) != 1. ? 1 : 0;
    });
  const bool some = std::any_of(relaxed.begin(), relaxed.end(), [](unsigned char r) { return r; });
  return some ? std::move(relaxed) : Buffer<unsigned char>();
}

/// Makes rows that are blends of two makers' rows.
template <typename Id>
class BlendMaker
{
public:
  BlendMaker(RowMaker<Id>& smooth, RowMaker<Id>& sharp)
    : Makers{ &smooth, &sharp }
  {
  }
  void AddRow(const SharpRow& row, RowBlock<Id>& block)
  {
    const double sharp = std::min(1., row.Sharpness);
    for (int i = 0; i < 2; ++i)
    {
      const double factor = i == 0 ? 1. - sharp : sharp;
      if (factor > 0.)
      {
        this->Row.Clear();
        this->Makers[i]->AddRow(row.Row, this->Row);
        for (std::size_t k = 0; k < this->Row.GetNumberOfEntries(); ++k)
        {
          this->Sum.Add(this->Row.GetColumns()[k], factor * this->Row.GetWeights()[k]);
        }
      }
    }
    this->Sum.EndRow(block);
  }

private:
  RowMaker<Id>* const Makers[2];
  RowBlock<Id> Row;
  HybridRowSum<Id> Sum;
};

}

template <typename Id>
HybridRows<Id>::HybridRows(const HybridLevel<Id>& level, HybridRules rules)
  : Level(level)
  , Rules(rules)
  , AreRelaxed(rules == HybridRules::Smooth ? FindRelaxed(level.Complex, level.Strata)
                                            : Buffer<unsigned char>())
{
  const HybridSharpness<Id>& sharpness = level.Sharpness;
  if (rules == HybridRules::Smooth && !sharpness.Stages.empty())
  {
    this->Blends = sharpness.FindRows(level.Complex, level.Strata);
    this->AreSharpRelaxed = FindRelaxed(level.Complex, sharpness.Stages.front().Strata);
  }
}

template <typename Id>
void HybridRows<Id>::ForEachBlock(const User& use) const
{
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType first, vtkIdType last)
    {
      const HybridLevel<Id>& level = this->Level;
      const HybridRuns<Id> runs(level, this->Rules);
      RowMaker<Id> maker(level.Complex, level.Strata, this->Rules, this->AreRelaxed);
      RowMaker<Id> sharp(level.Complex,
        this->Blends.empty() ? level.Strata : level.Sharpness.Stages.front().Strata, this->Rules,
        this->AreSharpRelaxed);
      BlendMaker<Id> blends(maker, sharp);
      auto blend = this->FindBlend(first);
      RowBlock<Id> block;
      ForBlocks(first, last,
        [&](vtkIdType begin, vtkIdType end)
        {
          block.Clear();
          for (vtkIdType row = begin; row < end;)
          {
            const vtkIdType stop =
              blend == this->Blends.end() ? end : std::min(end, vtkIdType(blend->Row));
            if (stop == row)
            {
              blends.AddRow(*blend++, block);
              ++row;
              continue;
            }
            const vtkIdType alike = runs.Add(row, stop, block);
            if (alike == 0)
            {
              maker.AddRow(row, block);
            }
            row += std::max<vtkIdType>(alike, 1);
          }
          block.ForRuns(begin, [&use](const auto& rows) { use(rows); });
        });
    });
}

template <typename Id>
typename HybridRows<Id>::AddRow HybridRows<Id>::StartRows() const
{
  const HybridLevel<Id>& level = this->Level;
  const auto smooth =
    std::make_shared<RowMaker<Id>>(level.Complex, level.Strata, this->Rules, this->AreRelaxed);
  if (this->Blends.empty())
  {
    return [smooth](vtkIdType row, RowBlock<Id>& block) { smooth->AddRow(row, block); };
  }
  const auto sharp = std::make_shared<RowMaker<Id>>(
    level.Complex, level.Sharpness.Stages.front().Strata, this->Rules, this->AreSharpRelaxed);
  const auto blends = std::make_shared<BlendMaker<Id>>(*smooth, *sharp);
  return [this, smooth, sharp, blends](vtkIdType row, RowBlock<Id>& block)
  {
    const auto blend = this->FindBlend(row);
    blend != this->Blends.end() && blend->Row == row ? blends->AddRow(*blend, block)
                                                     : smooth->AddRow(row, block);
  };
}

template <typename Id>
Row<Id> HybridRows<Id>::GetCorners(vtkIdType row) const
{
  const CellComplex<Id>& complex = this->Level.Complex;
  const vtkIdType edge = row - complex.NumberOfVertices;
  const vtkIdType face = edge - complex.NumberOfEdges;
  const vtkIdType centre = face - complex.NumberOfQuads;
  if (edge < 0)
  {
    return {};
  }
  if (face < 0)
  {
    const Id* ends = complex.EdgeVertices.data() + 2 * edge;
    return { ends, ends + 2 };
  }
  if (centre < 0)
  {
    return complex.GetVertices(static_cast<Id>(face));
  }
  const vtkIdType cell = complex.CentreCells[centre];
  const Id* corners = complex.Cells.GetCorners(cell);
  return { corners, corners + complex.Cells.GetTable(cell).Corners };
}

template <typename Id>
HybridLevel<Id> RefineHybrid(const HybridLevel<Id>& level, HybridRules rules)
{
  HybridLevel<Id> next;
  next.Complex = RefineCellComplex(level.Complex);
  if (rules == HybridRules::Smooth)
  {
    next.Strata = RefineHybridStrata(level.Complex, level.Strata, next.Complex);
    next.Sharpness = RefineHybridSharpness(level.Complex, level.Sharpness, next.Complex);
  }
  return next;
}

SUBDIVISION_COMPILE(class HybridRows);
SUBDIVISION_COMPILE_FUNCTION(RefineHybrid);

}
