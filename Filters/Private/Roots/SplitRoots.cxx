// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Roots/SplitRoots.h"

#include "Private/ArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace subdivision
{

vtkIdType LatticeReader::GetPoint(
  const RootLattice& lattice, vtkIdType first, const FrameNode& node) const
{
  const int corner = lattice.GetCorner(node);
  if (corner >= -1)
  {
    return corner < 0 ? -1 : this->GetPointOfCorner(first, corner);
  }
  // The point of the octahedron that no other cell has.
  const LatticeCell& oct = lattice.GetOctahedra()[-2 - corner];
  std::array<vtkIdType, 6> others{};
  std::transform(oct.Corners.begin(), oct.Corners.begin() + 6, others.begin(),
    [&](const FrameNode& other)
    { return other == node ? -1 : this->GetPoint(lattice, first, other); });
  for (int piece = 0; piece < 4; ++piece)
  {
    const CellIds ids = this->GetCell(first + oct.First + piece);
    const vtkIdType* found = std::find_if(ids.Ids, ids.Ids + ids.Size,
      [&](vtkIdType id) { return std::find(others.begin(), others.end(), id) == others.end(); });
    if (found != ids.Ids + ids.Size)
    {
      return *found;
    }
  }
  return -1;
}

SplitRoots::SplitRoots(
  vtkPointSet* mesh, int steps, const std::function<bool(const Root&)>& accepts)
  : LatticeReader(mesh)
  , Steps(steps)
  , Types(this->Cells.GetNumberOfCells())
  , Octahedra(mesh->GetCellData()->GetArray(OctahedraName))
{
  ForEach(this->Types.size(),
    [this](vtkIdType c)
    {
      this->Types[c] =
        static_cast<unsigned char>(this->Cells.GetGridType(c, this->GetCell(c).Size));
    });
  if (!this->FindRoots(accepts, true))
  {
    this->FindRoots(accepts, false);
  }
}

/// Finds one root after the other. With `guesses` the types of cells tell the roots of a shape and
/// order that was met, and all of them are proved afterwards, in threads. Returns false if one of
/// them is wrong: if none is, the roots are the same without.
bool SplitRoots::FindRoots(const Accepts& accepts, bool guesses)
{
  this->Roots.clear();
  this->Last.fill(-1);
  Turns turns;
  for (vtkIdType first = 0; first < this->Types.size();)
  {
    turns.Next();
    Root root = this->FindRoot(first, accepts, guesses);
    for (; root.Quarter < (root.Shape == CellShape::Octahedron ? 4 : 1); ++root.Quarter)
    {
      this->Roots.push_back(root);
    }
    first += root.Lattice ? static_cast<vtkIdType>(root.Lattice->GetTypes().size()) : 1;
  }
  std::atomic<bool> isRight{ true };
  ForEach(guesses ? this->GetNumberOfRoots() : 0,
    [&](vtkIdType r)
    {
      const Root& root = this->Roots[r];
      if (root.Lattice && root.Quarter == 0 && !this->Fits(root))
      {
        isRight = false;
      }
    });
  for (const Root& root : InTurn(this->Roots))
  {
    isRight = isRight && (!guesses || !root.Lattice || !accepts || accepts(root));
  }
  return isRight;
}

const RootLattice* SplitRoots::GetLattice(CellShape shape, SplitOrder order, int steps)
{
  const int number = static_cast<int>(shape) +
    NumberOfShapes * (static_cast<int>(order) + (steps == this->Steps ? 0 : NumberOfSplitOrders));
  auto& lattice = this->Lattices[static_cast<std::size_t>(number)];
  lattice = lattice ? std::move(lattice) : std::make_unique<RootLattice>(shape, order, steps);
  return lattice.get();
}

/// A side of a face that has not four is as a quad that was split in one step less.
Root SplitRoots::FindRoot(vtkIdType first, const Accepts& accepts, bool guesses)
{
  std::array<std::pair<CellShape, int>, 3> tries;
  std::size_t size = 0;
  if (this->Octahedra && this->Steps > 0 && this->Octahedra->GetComponent(first, 0) >= 0.)
  {
    tries[size++] = { CellShape::Octahedron, this->Steps };
  }
  const auto* type = std::find(TypesOfShapes.begin(), TypesOfShapes.end(), this->Types[first]);
  if (type != TypesOfShapes.end())
  {
    tries[size++] = { static_cast<CellShape>(type - TypesOfShapes.begin()), this->Steps };
  }
  if (this->Types[first] == VTK_QUAD && this->Steps > 0)
  {
    tries[size++] = { CellShape::Quad, this->Steps - 1 };
  }
  for (std::size_t t = 0; t < size; ++t)
  {
    const auto [shape, steps] = tries[t];
    int& last = this->Last[static_cast<std::size_t>(shape)];
    const bool isGuess = guesses && last >= 0;
    for (int i = 0; i < NumberOfSplitOrders; ++i)
    {
      const auto order = static_cast<SplitOrder>((std::max(0, last) + i) % NumberOfSplitOrders);
      const Root root{ first, shape, order, steps, 0, this->GetLattice(shape, order, steps) };
      if (this->HasTypes(root) && (isGuess || this->Fits(root)) &&
        (guesses || !accepts || accepts(root)))
      {
        last = static_cast<int>(order);
        return root;
      }
    }
  }
  return { first, CellShape::Vertex, SplitOrder::Simplices, 0, 0, nullptr };
}

bool SplitRoots::HasTypes(const Root& root) const
{
  const auto& types = root.Lattice->GetTypes();
  return root.First + static_cast<vtkIdType>(types.size()) <= this->Types.size() &&
    std::equal(types.begin(), types.end(), this->Types.data() + root.First);
}

bool SplitRoots::Fits(const Root& root) const
{
  // Each cell is read once, and its points as often as others share them.
  const auto size = static_cast<vtkIdType>(root.Lattice->GetTypes().size());
  std::vector<vtkIdType> points(static_cast<std::size_t>(8 * size), -1);
  std::vector<vtkIdType> scratch;
  for (vtkIdType c = 0; c < size; ++c)
  {
    const CellIds cell = this->Cells.GetCell(root.First + c, scratch);
    std::copy_n(cell.Ids, std::min<vtkIdType>(cell.Size, 8), points.data() + 8 * c);
  }
  const auto& equal = root.Lattice->GetEqualCorners();
  return std::all_of(equal.begin(), equal.end(), [&points](const auto& corners)
    { return points.data()[corners.first] == points.data()[corners.second]; });
}

}
