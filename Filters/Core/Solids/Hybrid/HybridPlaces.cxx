// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridPlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/Hybrid/HybridLimits.h"
#include "Core/Solids/Hybrid/HybridLocal.h"
#include "Core/Solids/Hybrid/HybridSplines.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>
#include <unordered_map>

namespace subdivision
{
namespace
{

/// The limit is linear over so small a part but for rounding, and its corners are exact.
constexpr int Splits = 44;

/// A cell with the cells around it.
template <typename Id>
struct CellPatch
{
  struct Child
  {
    const CellPatch* Next = nullptr;
    // A row for each vertex of Next, over those of this patch; empty: cells are missing.
    std::vector<std::size_t> Offsets{ 0 };
    std::vector<Id> Columns;
    std::vector<double> Weights;
  };

  std::shared_ptr<const HybridLevel<Id>> Level; ///< the cells alone, or the control level
  std::shared_ptr<const HybridRows<Id>> Rows;
  typename HybridRows<Id>::AddRow AddLimit;
  vtkIdType Cell = 0;
  std::size_t Known = 0;                         ///< HybridPatch
  mutable std::map<std::size_t, Child> Children; ///< that were needed
  std::vector<Id> Spline;

  CellPatch(const std::shared_ptr<const HybridLevel<Id>>& level,
    const std::shared_ptr<const HybridRows<Id>>& rows, vtkIdType cell, std::size_t known)
    : Level(level)
    , Rows(rows)
    , AddLimit(StartLimits(*level, *rows))
    , Cell(cell)
    , Known(known)
    , Spline(FindSpline(*level, cell))
  {
  }
  CellShape GetShape() const { return this->Level->Complex.Cells.Shapes[this->Cell]; }
};

/// The patches of one thread, and the way from a control cell to a small part of it, for PlaceSum.
template <typename Id>
class PatchPath
{
public:
  using Patch = CellPatch<Id>;
  using LevelRow = VertexRow<LevelVertex<Id>>;

  PatchPath(const std::shared_ptr<const HybridLevel<Id>>& control,
    const std::shared_ptr<const HybridRows<Id>>& rows)
    : Control(control)
    , Rows(rows)
  {
    // Octahedra in the middle of tetrahedra reach one edge farther.
    const Buffer<CellShape>& shapes = control->Complex.Cells.Shapes;
    const bool hasTets = std::any_of(shapes.begin(), shapes.end(),
      [](CellShape shape)
      {
        return shape == CellShape::Tet || shape == CellShape::Pyramid ||
          shape == CellShape::Octahedron;
      });
    this->Layers = hasTets ? 2 : 1;
  }

  void Start(vtkIdType cell)
  {
    // So much memory is bounded. Patches of control cells lead to others, which many share.
    constexpr std::size_t most = 192;
    const bool areMany = this->Known.size() > most;
    if (areMany || 4 * this->Roots.size() > most || this->Others.size() > most)
    {
      this->Roots.clear();
      this->Others.clear();
    }
    areMany ? this->Known.clear() : void();
    std::unique_ptr<Patch>& root = this->Roots[cell];
    if (!root)
    {
      root = std::make_unique<Patch>(this->Control, this->Rows, cell,
        static_cast<std::size_t>(this->Control->Complex.NumberOfVertices));
    }
    this->Steps.clear();
    this->Last = root.get();
  }
  void GoTo(std::size_t number)
  {
    typename Patch::Child& child = this->Last->Children[number];
    if (!child.Next)
    {
      this->MakeChild(*this->Last, number, child);
    }
    this->Steps.push_back(&child);
    this->Last = child.Next;
  }
  const Patch& GetLast() const { return *this->Last; }
  std::size_t GetSize() const
  {
    return static_cast<std::size_t>(this->Last->Level->Complex.NumberOfVertices);
  }
  int GetLevel() const { return static_cast<int>(this->Steps.size()); }

  /// False: cells are missing.
  bool ReadRow(const LevelVertex<Id>& vertex, LevelRow& row) const
  {
    const typename Patch::Child& step = *this->Steps[static_cast<std::size_t>(vertex.Level - 1)];
    const std::size_t* ends = step.Offsets.data() + vertex.Number;
    row.Clear();
    for (std::size_t k = ends[0]; k < ends[1]; ++k)
    {
      row.Add({ vertex.Level - 1, step.Columns[k] }, step.Weights[k]);
    }
    return ends[0] < ends[1];
  }
  /// The limit of a corner of the last cell.
  bool ReadLimit(int corner, LevelRow& row)
  {
    const Patch& last = *this->Last;
    this->Block.Clear();
    last.AddLimit(last.Level->Complex.Cells.GetCorners(last.Cell)[corner], this->Block);
    row.Clear();
    for (std::size_t k = 0; k < this->Block.GetNumberOfEntries(); ++k)
    {
      row.Add({ this->GetLevel(), this->Block.GetColumns()[k] }, this->Block.GetWeights()[k]);
    }
    return true;
  }

  /// Weights of all vertices of the last patch become weights of the first child: sums over few
  /// vertices with numbers, in far less time than PlaceSum. Returns false if cells are missing.
  bool StepBackToChild(std::vector<PartWeights>& weights)
  {
    RemoveConstants(weights);
    for (; this->Steps.size() > 1; this->Steps.pop_back())
    {
      const typename Patch::Child& step = *this->Steps.back();
      const CellComplex<Id>& before = this->Steps[this->Steps.size() - 2]->Next->Level->Complex;
      this->Before.assign(static_cast<std::size_t>(before.NumberOfVertices), PartWeights{});
      for (std::size_t i = 0; i < weights.size(); ++i)
      {
        const bool isUsed = weights[i] != PartWeights{};
        if (isUsed && step.Offsets[i] == step.Offsets[i + 1])
        {
          return false;
        }
        for (std::size_t k = step.Offsets[i]; isUsed && k < step.Offsets[i + 1]; ++k)
        {
          PartWeights& sum = this->Before[static_cast<std::size_t>(step.Columns[k])];
          for (std::size_t p = 0; p < sum.size(); ++p)
          {
            sum[p] += step.Weights[k] * weights[i][p];
          }
        }
      }
      std::swap(weights, this->Before);
      RemoveConstants(weights);
    }
    return true;
  }

private:
  static StarCell<Id> GetCell(const CellComplex<Id>& complex, vtkIdType cell)
  {
    return GetStarCell(complex, cell, complex.Cells.GetCorners(cell)[0]);
  }

  /// On the control level members of rings may lie outside of the patch, so that rows are those of
  /// the level.
  void MakeChild(const Patch& patch, std::size_t number, typename Patch::Child& child)
  {
    const CellComplex<Id>& complex = patch.Level->Complex;
    HybridPatch<Id> around(*patch.Level);
    around.ReadLayers(GetCell(complex, patch.Cell), this->Layers);
    const HybridLevel<Id> alone = around.MakeLevel();
    const HybridLevel<Id> fine = RefineHybrid(alone, HybridRules::Smooth);
    HybridPatch<Id> next(fine);
    next.ReadLayers(GetCell(fine.Complex, static_cast<vtkIdType>(number)), this->Layers);
    const auto places = LocalReader<Id>::LocatePoints(around, alone.Complex, next.Numbers);
    const auto addRow = patch.Rows->StartRows();
    for (const auto& [cell, place] : places)
    {
      const vtkIdType point =
        GetNewPoint(complex, around.Cells[static_cast<std::size_t>(cell)], place);
      const auto origin = patch.Rows->FindOrigin(point, std::less<Id>());
      this->Block.Clear();
      static_cast<std::size_t>(origin) < patch.Known ? addRow(point, this->Block) : void();
      const auto size = static_cast<std::ptrdiff_t>(this->Block.GetNumberOfEntries());
      const Id* columns = this->Block.GetColumns();
      const double* weights = this->Block.GetWeights();
      child.Columns.insert(child.Columns.end(), columns, columns + size);
      child.Weights.insert(child.Weights.end(), weights, weights + size);
      child.Offsets.push_back(child.Columns.size());
    }
    std::unique_ptr<Patch>& found =
      next.IsPlain() ? this->Known[next.Key] : this->Others.emplace_back();
    if (!found)
    {
      const auto level = std::make_shared<const HybridLevel<Id>>(next.MakeLevel());
      found = std::make_unique<Patch>(
        level, std::make_shared<const HybridRows<Id>>(*level, HybridRules::Smooth), 0, next.Known);
    }
    child.Next = found.get();
  }

  const std::shared_ptr<const HybridLevel<Id>> Control;
  const std::shared_ptr<const HybridRows<Id>> Rows;
  int Layers = 1;
  std::map<vtkIdType, std::unique_ptr<Patch>> Roots;
  std::unordered_map<Neighbourhood, std::unique_ptr<Patch>, HashNeighbourhood> Known;
  std::vector<std::unique_ptr<Patch>> Others; ///< IsPlain() is false
  std::vector<const typename Patch::Child*> Steps;
  const Patch* Last = nullptr;
  RowBlock<Id> Block;
  std::vector<PartWeights> Before;
};

template <typename Id>
void FindPlace(const HybridPlace& place, PatchPath<Id>& path, PlaceRow<Id>& row)
{
  path.Start(place.Cell);
  CellShape shape = path.GetLast().GetShape();
  std::vector<FramePoint> corners = GetFrameCorners(shape);
  CornerShares shares = ShareCorners(shape, corners, place.At);
  while (shape != CellShape::Vertex && path.GetLast().Spline.empty() && path.GetLevel() < Splits)
  {
    const std::vector<CellChild>& children = GetCellTable(shape).Children;
    const std::vector<FramePoint> before = corners;
    std::size_t found = children.size();
    for (std::size_t c = 0; c < children.size(); ++c)
    {
      const std::vector<FramePoint> own = GetChildCorners(shape, before, children[c]);
      const CornerShares ofOwn = ShareCorners(children[c].Shape, own, place.At);
      if (found == children.size() || ofOwn.Least > shares.Least)
      {
        found = c;
        corners = own;
        shares = ofOwn;
      }
    }
    path.GoTo(found);
    shape = children[found].Shape;
  }
  PlaceSum<PatchPath<Id>> sum(path);
  const bool isFar = path.GetLevel() > 1;
  std::vector<PartWeights> far(isFar ? path.GetSize() : 0, PartWeights{});
  const auto add = [&](Id vertex, double factor, const PartWeights& weights)
  {
    PartWeights scaled = weights;
    for (double& weight : scaled)
    {
      weight *= factor;
    }
    if (!isFar)
    {
      sum.Add({ path.GetLevel(), vertex }, scaled);
      return;
    }
    PartWeights& to = far[static_cast<std::size_t>(vertex)];
    std::transform(to.begin(), to.end(), scaled.begin(), to.begin(), std::plus<double>());
  };
  const std::vector<Id>& spline = path.GetLast().Spline;
  const std::vector<PartWeights> ofSpline = spline.empty()
    ? std::vector<PartWeights>()
    : WeighSpline(shape, spline.size(), shares, place.Directions);
  for (std::size_t i = 0; i < spline.size(); ++i)
  {
    add(spline[i], 1., ofSpline[i]);
  }
  typename PatchPath<Id>::LevelRow limit;
  for (std::size_t i = 0; spline.empty() && i < corners.size(); ++i)
  {
    PartWeights weights{ { shares.Values[i] } };
    for (std::size_t k = 0; k < 9; ++k)
    {
      weights[PlaceParts::First + k / 3] +=
        place.Directions[k / 3][k % 3] * shares.Slopes[i][k % 3];
    }
    path.ReadLimit(static_cast<int>(i), limit);
    for (std::size_t k = 0; k < limit.Vertices.size(); ++k)
    {
      add(limit.Vertices[k].Number, limit.Weights[k], weights);
    }
  }
  bool isKnown = !isFar || path.StepBackToChild(far);
  for (std::size_t i = 0; isKnown && i < far.size(); ++i)
  {
    if (far[i] != PartWeights{})
    {
      sum.Add({ 1, static_cast<Id>(i) }, far[i]);
    }
  }
  isKnown = isKnown && sum.StepBack(path.GetLevel());
  if (!isKnown)
  {
    throw std::logic_error("The cells around a place do not tell its limit.");
  }
  sum.Write(row);
}

}

/// Threads keep their patches from one call to the next.
template <typename Id>
struct HybridPlaceLimits<Id>::Finders
{
  /// The owner of the level is the caller.
  explicit Finders(const HybridLevel<Id>& level)
    : Level(&level, [](const HybridLevel<Id>*) {})
    , Rows(std::make_shared<const HybridRows<Id>>(level, HybridRules::Smooth))
  {
  }

  const std::shared_ptr<const HybridLevel<Id>> Level;
  const std::shared_ptr<const HybridRows<Id>> Rows;
  vtkSMPThreadLocal<std::shared_ptr<PatchPath<Id>>> OfThreads;
};

template <typename Id>
HybridPlaceLimits<Id>::HybridPlaceLimits(const HybridLevel<Id>& level)
  : OfThreads(std::make_shared<Finders>(level))
{
}

template <typename Id>
PlaceRows<Id> HybridPlaceLimits<Id>::Find(
  const std::vector<HybridPlace>& places, PlaceDerivatives derivatives)
{
  Finders& all = *this->OfThreads;
  const CellComplex<Id>& complex = all.Level->Complex;
  const auto size = static_cast<vtkIdType>(places.size());
  std::vector<PlaceRow<Id>> found(places.size());
  ForUnevenRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      auto& path = all.OfThreads.Local();
      path = path ? path : std::make_shared<PatchPath<Id>>(all.Level, all.Rows);
      for (vtkIdType i = begin; i < end; ++i)
      {
        FindPlace(places[i], *path, found[i]);
      }
    });
  Buffer<Id> offsets(size + 1);
  int dimension = 0;
  for (const vtkIdType i : InTurn(size))
  {
    offsets[i] = static_cast<Id>(found[i].Columns.size());
    dimension = std::max(dimension, complex.Cells.GetTable(places[i].Cell).Dimension);
  }
  CountsToOffsets(offsets);
  PlaceRows<Id> rows(complex.NumberOfVertices, std::move(offsets), dimension, derivatives);
  ForEach(size,
    [&](vtkIdType i)
    {
      std::copy(
        found[i].Columns.begin(), found[i].Columns.end(), rows.Columns.begin() + rows.Offsets[i]);
      found[i].CopyWeights(rows.GetWeights(i));
    });
  return rows;
}

SUBDIVISION_COMPILE(class HybridPlaceLimits);

}
