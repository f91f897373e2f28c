// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenSeams.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Values/PointCopies.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

/**
 * The points of a refined mesh as the torn input has them. A point of which all control points have
 * one side has one; another has a copy for each pair of copies at the ends of its edge. The first
 * that a cell asks for is the point itself.
 */
template <typename Id>
class SeamSides
{
public:
  SeamSides(vtkPointSet* torn, vtkPointSet* joined, const RedGreenMesh& mesh,
    const std::vector<std::array<Id, 2>>& ends)
    : Mesh(mesh)
    , Ends(ends)
    , Given(mesh.Control.Cells.Simplices.NumberOfPoints)
    , Cells(torn)
    , JoinedCells(joined)
    , CopyOfTorn(torn->GetNumberOfPoints(), -1)
    , Texture(torn->GetPointData()->GetTCoords())
    , Width(static_cast<std::size_t>(Texture->GetNumberOfComponents()))
  {
    const vtkIdType size = this->Given + static_cast<vtkIdType>(ends.size());
    this->Sources.resize(static_cast<std::size_t>(size));
    std::iota(this->Sources.begin(), this->Sources.end(), vtkIdType(0));
    this->IsTaken.resize(this->Sources.size());
    this->Values.resize(this->Sources.size() * this->Width);
    this->FindSplit(torn, joined);
  }

  /// The copy of a point that the parts of a simplex have.
  vtkIdType GetCopy(vtkIdType point, vtkIdType simplex)
  {
    if (!this->IsSplit[point])
    {
      return point;
    }
    if (point < this->Given)
    {
      return this->GetControlCopy(point, simplex);
    }
    const auto known = this->Known.find({ point, simplex });
    if (known != this->Known.end())
    {
      return known->second;
    }
    const auto& ends = this->Ends[point - this->Given];
    const std::pair<vtkIdType, vtkIdType> sides(
      this->GetCopy(ends[0], simplex), this->GetCopy(ends[1], simplex));
    const auto [middle, isNew] = this->Middles.try_emplace(sides, -1);
    if (isNew)
    {
      middle->second = this->Add(point);
      this->SetMean(middle->second, { sides.first, sides.second });
    }
    this->Known.emplace(std::make_pair(point, simplex), middle->second);
    return middle->second;
  }

  /// Of each copy the point.
  const std::vector<vtkIdType>& GetSources() const { return this->Sources; }

  vtkSmartPointer<vtkDataArray> MakeTexture() const
  {
    auto made = vtkSmartPointer<vtkDataArray>::Take(this->Texture->NewInstance());
    made->SetName(this->Texture->GetName());
    Allocate(made, this->Texture->GetNumberOfComponents(), this->Sources.size());
    for (const std::size_t i : InTurn(this->Sources.size()))
    {
      made->SetTuple(static_cast<vtkIdType>(i), this->Values.data() + i * this->Width);
    }
    return made;
  }

private:
  /// Finds which points have sides, and sets the texture of all others.
  void FindSplit(vtkPointSet* torn, vtkPointSet* joined)
  {
    this->IsSplit.resize(this->Sources.size());
    std::vector<vtkIdType> first(static_cast<std::size_t>(joined->GetNumberOfPoints()), -1);
    const Buffer<vtkIdType> points = FindJoinedPoints(torn, joined);
    for (const vtkIdType t : InTurn(points.size()))
    {
      if (points[t] >= 0)
      {
        this->IsSplit[points[t]] = first[points[t]] >= 0;
        first[points[t]] < 0 ? void(first[points[t]] = t) : void();
      }
    }
    for (std::size_t p = 0; p < first.size(); ++p)
    {
      first[p] >= 0 ? this->Texture->GetTuple(first[p], this->Values.data() + p * this->Width)
                    : void();
    }
    const SimplicesOfCells& cells = this->Mesh.Control.Cells;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCentres()))
    {
      this->SetPlain(this->Given - cells.GetNumberOfCentres() + c,
        { cells.CentreMembers.begin() + cells.CentreOffsets[c],
          cells.CentreMembers.begin() + cells.CentreOffsets[c + 1] });
    }
    for (const std::size_t i : InTurn(this->Ends.size()))
    {
      this->SetPlain(
        this->Given + static_cast<vtkIdType>(i), { this->Ends[i][0], this->Ends[i][1] });
    }
  }
  /// A point in the middle of others.
  void SetPlain(vtkIdType point, const std::vector<vtkIdType>& others)
  {
    const bool isSplit = std::any_of(
      others.begin(), others.end(), [this](vtkIdType p) { return this->IsSplit[p] != 0; });
    this->IsSplit[point] = isSplit ? 1 : 0;
    isSplit ? void() : this->SetMean(point, others);
  }
  void SetMean(vtkIdType point, const std::vector<vtkIdType>& others)
  {
    for (std::size_t k = 0; k < this->Width; ++k)
    {
      double sum = 0.;
      for (const vtkIdType other : others)
      {
        sum += this->Values[static_cast<std::size_t>(other) * this->Width + k];
      }
      this->Values[static_cast<std::size_t>(point) * this->Width + k] =
        sum / static_cast<double>(others.size());
    }
  }
  vtkIdType Add(vtkIdType point)
  {
    if (!std::exchange(this->IsTaken[point], 1))
    {
      return point;
    }
    this->Sources.push_back(point);
    this->Values.resize(this->Sources.size() * this->Width);
    return static_cast<vtkIdType>(this->Sources.size()) - 1;
  }
  vtkIdType GetControlCopy(vtkIdType point, vtkIdType simplex)
  {
    const SimplicesOfCells& cells = this->Mesh.Control.Cells;
    const vtkIdType centre = point - (this->Given - cells.GetNumberOfCentres());
    if (centre < 0)
    {
      return this->CopyTorn(point, this->FindTorn(point, simplex));
    }
    if (!std::exchange(this->IsTaken[point], 1)) // it lies in one cell of a surface
    {
      std::vector<vtkIdType> members;
      for (vtkIdType m = cells.CentreOffsets[centre]; m < cells.CentreOffsets[centre + 1]; ++m)
      {
        members.push_back(this->GetCopy(cells.CentreMembers[m], simplex));
      }
      this->SetMean(point, members);
    }
    return point;
  }
  /// The point of the torn mesh that the cells of a simplex have; a leaf of an earlier filter is
  /// several cells.
  vtkIdType FindTorn(vtkIdType point, vtkIdType simplex)
  {
    const vtkIdType begin = this->Mesh.GetInputCell(simplex);
    const vtkIdType end = simplex + 1 < this->Mesh.Control.Cells.GetView().NumberOfSimplices
      ? std::max(begin + 1, this->Mesh.GetInputCell(simplex + 1))
      : this->Cells.GetNumberOfCells();
    for (vtkIdType c = begin; c < end; ++c)
    {
      const CellIds joined = this->JoinedCells.GetCell(c, this->Scratch[0]);
      const CellIds torn = this->Cells.GetCell(c, this->Scratch[1]);
      const vtkIdType* const found = std::find(joined.Ids, joined.Ids + joined.Size, point);
      if (found != joined.Ids + joined.Size)
      {
        return torn.Ids[found - joined.Ids];
      }
    }
    return -1;
  }
  vtkIdType CopyTorn(vtkIdType point, vtkIdType torn)
  {
    if (torn < 0)
    {
      return point;
    }
    vtkIdType& copy = this->CopyOfTorn[torn];
    if (copy < 0)
    {
      copy = this->Add(point);
      this->Texture->GetTuple(
        torn, this->Values.data() + static_cast<std::size_t>(copy) * this->Width);
    }
    return copy;
  }

  const RedGreenMesh& Mesh;
  const std::vector<std::array<Id, 2>>& Ends;
  vtkIdType Given; ///< points of the control mesh
  CellReader Cells;
  CellReader JoinedCells;
  std::vector<vtkIdType> Scratch[2];
  Buffer<vtkIdType> CopyOfTorn;
  vtkDataArray* Texture;
  std::size_t Width;
  std::vector<unsigned char> IsSplit;                           ///< by point
  std::vector<unsigned char> IsTaken;                           ///< of points that are split
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Known;   ///< by point and simplex
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Middles; ///< by the copies at the ends
  std::vector<vtkIdType> Sources;
  std::vector<double> Values; ///< texture coordinates of copies
};

}

template <typename Id>
void TearSeams(vtkPointSet* torn, vtkPointSet* joined, const RedGreenMesh& mesh,
  const std::vector<std::array<Id, 2>>& ends, const std::vector<vtkIdType>& simplices,
  vtkUnstructuredGrid* output)
{
  SeamSides<Id> sides(torn, joined, mesh, ends);
  const CellReader cells(output);
  std::vector<vtkIdType> offsets{ 0 };
  std::vector<vtkIdType> copies;
  std::vector<vtkIdType> scratch;
  for (const std::size_t c : InTurn(simplices.size()))
  {
    const CellIds ids = cells.GetCell(static_cast<vtkIdType>(c), scratch);
    std::transform(ids.Ids, ids.Ids + ids.Size, std::back_inserter(copies),
      [&](vtkIdType id) { return sides.GetCopy(id, simplices[c]); });
    offsets.push_back(static_cast<vtkIdType>(copies.size()));
  }
  TakePoints(output, sides.GetSources(),
    [&](vtkIdType cell, auto* begin, auto* end)
    {
      std::transform(copies.begin() + offsets[cell], copies.begin() + offsets[cell] + (end - begin),
        begin, [](vtkIdType id) { return static_cast<std::decay_t<decltype(*begin)>>(id); });
    });
  output->GetPointData()->SetTCoords(sides.MakeTexture());
}

SUBDIVISION_COMPILE_FUNCTION(TearSeams);

}
