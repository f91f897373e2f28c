// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridSearch.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include <algorithm>
#include <utility>

namespace subdivision
{
namespace
{

using LocalCorners = std::array<int, 4>;

/// Calls use(corners) for the triangles of a face, of which the fourth is none.
template <typename Id, typename Use>
void CutFace(const std::vector<unsigned char>& face, const Id* corners, const Use& use)
{
  const std::size_t size = face.size();
  const auto first =
    static_cast<std::size_t>(std::min_element(face.begin(), face.end(),
                               [corners](int a, int b) { return corners[a] < corners[b]; }) -
      face.begin());
  for (std::size_t k = 1; k + 1 < size; ++k)
  {
    use(LocalCorners{ { face[first], face[(first + k) % size], face[(first + k + 1) % size], 0 } });
  }
}

/// Calls use(corners) for the tetrahedra of a solid.
template <typename Id, typename Use>
void CutSolid(const CellTable& table, const Id* corners, const Use& use)
{
  const auto smallest =
    static_cast<int>(std::min_element(corners, corners + table.Corners) - corners);
  for (const std::vector<unsigned char>& face : table.Faces)
  {
    if (std::find(face.begin(), face.end(), smallest) == face.end())
    {
      CutFace(face, corners,
        [&](LocalCorners triangle)
        {
          triangle[3] = smallest;
          use(triangle);
        });
    }
  }
}

/// Tetrahedra of the children of the children of cells.
template <typename Id>
struct FineTets
{
  explicit FineTets(const CellComplex<Id>& complex)
    : Control(complex)
    , Coarse(SplitCells(complex))
    , Fine(SplitCells(RefineCellComplex(complex)))
    , Firsts{ FindFirstChildren(complex.Cells), FindFirstChildren(this->Coarse) }
  {
    ForEachInTurn(this->Fine.GetNumberOfCells(),
      [this](vtkIdType c)
      {
        if (this->Fine.GetTable(c).Dimension == 3)
        {
          const Id* corners = this->Fine.GetCorners(c);
          CutSolid(this->Fine.GetTable(c), corners,
            [&](const LocalCorners& tet)
            {
              this->Tets.emplace_back(c, tet);
              for (const int corner : tet)
              {
                this->Points.push_back(static_cast<int>(corners[corner]));
              }
            });
        }
      });
  }
  /// The control cell with a place in a tetrahedron, and where the place is there but for what
  /// smoothing moves: the search begins with it.
  std::pair<vtkIdType, FramePoint> Locate(vtkIdType tet, const std::array<double, 4>& weights) const
  {
    const auto& [fine, local] = this->Tets[static_cast<std::size_t>(tet)];
    const vtkIdType parent = FindParent(this->Firsts[1], fine);
    const vtkIdType cell = FindParent(this->Firsts[0], parent);
    const CellShape shape = this->Control.Cells.Shapes[cell];
    std::vector<FramePoint> corners = GetFrameCorners(shape);
    corners = GetChildCorners(shape, corners, this->GetChild(shape, 0, cell, parent));
    corners = GetChildCorners(this->Coarse.Shapes[parent], corners,
      this->GetChild(this->Coarse.Shapes[parent], 1, parent, fine));
    FramePoint at{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        at[k] += weights[i] * corners[static_cast<std::size_t>(local[i])][k];
      }
    }
    return { cell, at };
  }

  std::vector<int> Points; ///< four for each tetrahedron

private:
  static vtkIdType FindParent(const Buffer<Id>& firsts, vtkIdType child)
  {
    return std::upper_bound(firsts.begin(), firsts.end(), static_cast<Id>(child)) - firsts.begin() -
      1;
  }
  const CellChild& GetChild(
    CellShape shape, std::size_t step, vtkIdType parent, vtkIdType child) const
  {
    return GetCellTable(shape)
      .Children[static_cast<std::size_t>(child - this->Firsts[step][parent])];
  }

  const CellComplex<Id>& Control;
  const CellList<Id> Coarse;
  const CellList<Id> Fine;
  const std::array<Buffer<Id>, 2> Firsts; ///< children of each cell
  std::vector<std::pair<vtkIdType, LocalCorners>> Tets;
};

}

template <typename Id>
HybridSearch<Id>::HybridSearch(const CellComplex<Id>& complex, const ReadQuarter& readQuarter)
  : Complex(complex)
{
  const vtkIdType size = complex.Cells.GetNumberOfCells();
  ForEachInTurn(size,
    [&](vtkIdType c)
    {
      this->Firsts.push_back(this->Parts.size());
      this->AddCell(c, readQuarter);
    });
  this->Firsts.push_back(this->Parts.size());
  ForEachInTurn(size, [this](vtkIdType c) { this->AddSides(c); });
}

template <typename Id>
void HybridSearch<Id>::AddCell(vtkIdType cell, const ReadQuarter& readQuarter)
{
  const CellTable& table = this->Complex.Cells.GetTable(cell);
  const Id* corners = this->Complex.Cells.GetCorners(cell);
  const auto add = [&](const LocalCorners& simplex) { this->Add(cell, table.Dimension, simplex); };
  LocalCorners quarter;
  if (this->Complex.IsTwin(cell))
  {
    return;
  }
  switch (table.Dimension)
  {
    case 2:
      CutFace(table.Faces.front(), corners, add);
      break;
    case 3:
      if (readQuarter(cell, 0, quarter))
      {
        for (int q = 0; q < 4 && readQuarter(cell, q, quarter); ++q)
        {
          this->Add(cell, 3, quarter, q);
        }
        break;
      }
      CutSolid(table, corners, add);
      break;
    default:
      add({ { 0, 1, 0, 0 } });
      break;
  }
}

template <typename Id>
void HybridSearch<Id>::AddSides(vtkIdType cell)
{
  const CellTable& table = this->Complex.Cells.GetTable(cell);
  if (table.Dimension < 3 || this->Complex.IsTwin(cell))
  {
    return;
  }
  const Id* faces = this->Complex.CellFaces[cell].begin();
  for (std::size_t f = 0; f < table.Faces.size(); ++f)
  {
    const Row<Id> solids = this->Complex.FaceSolids[faces[f]];
    if (solids.end() - solids.begin() == 1)
    {
      CutFace(table.Faces[f], this->Complex.Cells.GetCorners(cell),
        [&](const LocalCorners& triangle) { this->Add(cell, 2, triangle); });
    }
  }
}

template <typename Id>
void HybridSearch<Id>::Add(vtkIdType cell, int dimension, const LocalCorners& corners, int quarter)
{
  const std::vector<FramePoint> frame = GetFrameCorners(this->Complex.Cells.Shapes[cell]);
  Part part{ cell, quarter, {} };
  for (std::size_t k = 0; k <= static_cast<std::size_t>(dimension); ++k)
  {
    part.Corners[k] = frame[static_cast<std::size_t>(corners[k])];
    this->Connectivity.push_back(this->Complex.Cells.GetCorners(cell)[corners[k]]);
  }
  this->Dimensions.push_back(static_cast<unsigned char>(dimension));
  this->Parts.push_back(part);
}

template <typename Id>
HybridPlace HybridSearch<Id>::MakePlace(const NearestPlace& nearest) const
{
  const auto number = static_cast<std::size_t>(nearest.Cell);
  const Part& part = this->Parts[number];
  HybridPlace place;
  place.Cell = part.Cell;
  place.At = part.Corners[0];
  for (std::size_t p = 0; p < this->Dimensions[number]; ++p)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      place.Directions[p][k] = part.Corners[p + 1][k] - part.Corners[0][k];
      place.At[k] += nearest.Weights[p + 1] * place.Directions[p][k];
    }
  }
  return place;
}

/// The part of a cell that has a place, but for rounding.
template <typename Id>
NearestPlace HybridSearch<Id>::FindPlace(vtkIdType cell, const FramePoint& at) const
{
  NearestPlace place;
  double most = -1e300;
  for (std::size_t p = this->Firsts[static_cast<std::size_t>(cell)];
    p < this->Firsts[static_cast<std::size_t>(cell) + 1]; ++p)
  {
    const auto& corners = this->Parts[p].Corners;
    const CornerShares shares =
      ShareCorners(CellShape::Tet, { corners.begin(), corners.end() }, at);
    if (shares.Least > most)
    {
      most = shares.Least;
      place.Cell = static_cast<vtkIdType>(p);
      std::copy_n(shares.Values.begin(), 4, place.Weights.begin());
    }
  }
  double sum = 0.;
  for (double& weight : place.Weights)
  {
    weight = std::max(0., weight);
    sum += weight;
  }
  for (double& weight : place.Weights)
  {
    weight /= sum;
  }
  return place;
}

template <typename Id>
std::unique_ptr<SolidPieces> HybridSearch<Id>::MakePieces(vtkDataSet* fine) const
{
  const auto tets = std::make_shared<FineTets<Id>>(this->Complex);
  return std::make_unique<SolidPieces>(fine, tets->Points,
    [tets, this](vtkIdType piece, const std::array<double, 4>& weights, NearestPlace& start)
    {
      const auto [cell, at] = tets->Locate(piece, weights);
      start = this->FindPlace(cell, at);
    });
}

SUBDIVISION_COMPILE(class HybridSearch);

}
