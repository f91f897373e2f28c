// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/LabelPieces.h"

#include "Core/Memory/Loops.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace subdivision
{
namespace
{

/// Calls visit(neighbour, number of axes between) for the neighbours of a voxel; `before`: only for
/// neighbours with smaller ids.
template <typename Visit>
void VisitNeighbours(
  const LabelImage& image, vtkIdType voxel, bool byCorners, bool before, const Visit& visit)
{
  const std::array<vtkIdType, 3> at = image.GetPlace(voxel);
  for (int n = 0; n < (before ? 13 : 27); ++n)
  {
    const int step[3] = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
    const int axes = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
    bool isThere = axes == 1 || (byCorners && axes > 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType next = at[axis] + step[axis];
      isThere = isThere && next >= 0 && next < image.Size[axis];
    }
    if (isThere)
    {
      visit(image.GetId(at[0] + step[0], at[1] + step[1], at[2] + step[2]), axes);
    }
  }
}

vtkIdType FindFirst(Buffer<vtkIdType>& earlier, vtkIdType i)
{
  while (earlier[i] != i)
  {
    i = earlier[i] = earlier[earlier[i]];
  }
  return i;
}

/// The voxels of a piece in a block.
struct Share
{
  vtkIdType Piece;
  vtkIdType Block;
  vtkIdType Voxels;
};

/// The shares of one piece, by block.
struct PieceShares
{
  const Share* Begin;
  const Share* End;
  vtkIdType Voxels;
};

/// The shares of all pieces.
class AllShares
{
public:
  AllShares(const LabelImage& coarse, const Buffer<vtkIdType>& pieces)
  {
    std::vector<vtkIdType> found;
    for (const vtkIdType block : InTurn(coarse.Voxels.size()))
    {
      found.clear();
      VisitBlock(coarse, block, [&](vtkIdType voxel) { found.push_back(pieces[voxel]); });
      std::sort(found.begin(), found.end());
      for (auto next = std::upper_bound(found.begin(), found.end(), -1); next != found.end();)
      {
        const auto last = std::upper_bound(next, found.end(), *next);
        this->Shares.push_back({ *next, block, last - next });
        next = last;
      }
    }
    std::stable_sort(this->Shares.begin(), this->Shares.end(),
      [](const Share& a, const Share& b) { return a.Piece < b.Piece; });
    for (const Share& share : InTurn(this->Shares))
    {
      if (this->Pieces.empty() || this->Pieces.back().Begin->Piece != share.Piece)
      {
        this->Pieces.push_back({ &share, &share, 0 });
      }
      this->Pieces.back().End = &share + 1;
      this->Pieces.back().Voxels += share.Voxels;
    }
  }
  std::vector<PieceShares> Pieces;

private:
  std::vector<Share> Shares;
};

/// Connects the blocks of pieces.
class Connector
{
public:
  Connector(const LabelImage& fine, bool byCorners, LabelImage& coarse)
    : Fine(fine)
    , ByCorners(byCorners)
    , Coarse(coarse)
    , Nodes(coarse.Voxels.size(), -1)
    , IsGiven(coarse.Voxels.size(), 0)
    , Blocks(fine.Labels.size() + 1, 0)
  {
    for (const int label : InTurn(coarse.Voxels))
    {
      ++this->Blocks[label];
    }
  }

  /// Takes the cheapest way from each block of the label to the first one. Returns whether blocks
  /// have changed.
  bool Connect(const PieceShares& piece)
  {
    using Entry = std::pair<double, vtkIdType>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const int label = this->Fine.Voxels[piece.Begin->Piece];
    const vtkIdType size = piece.End - piece.Begin;
    std::vector<double> costs(size, Never);
    std::vector<vtkIdType> from(size, -1);
    for (vtkIdType node = 0; node < size; ++node)
    {
      this->Nodes[piece.Begin[node].Block] = node;
      if (queue.empty() && this->Coarse.Voxels[piece.Begin[node].Block] == label)
      {
        costs[node] = 0.;
        queue.push({ 0., node });
      }
    }
    while (!queue.empty())
    {
      const vtkIdType node = queue.top().second;
      queue.pop();
      VisitNeighbours(this->Coarse, piece.Begin[node].Block, this->ByCorners, false,
        [&](vtkIdType block, int axes)
        {
          const vtkIdType next = this->Nodes[block];
          const double cost = next < 0
            ? Never
            : costs[node] + (axes > 1 ? Diagonal : 0.) + this->GetCost(piece.Begin[next], label);
          if (next >= 0 && cost < costs[next])
          {
            costs[next] = cost;
            from[next] = node;
            queue.push({ cost, next });
          }
        });
    }
    bool hasChanged = false;
    for (vtkIdType node = 0; node < size; ++node)
    {
      this->Nodes[piece.Begin[node].Block] = -1;
      const bool isOfLabel = this->Coarse.Voxels[piece.Begin[node].Block] == label;
      for (vtkIdType way = node; isOfLabel && way >= 0; way = from[way])
      {
        hasChanged = this->Give(piece.Begin[way].Block, label) || hasChanged;
      }
    }
    return hasChanged;
  }

private:
  static constexpr double Never = std::numeric_limits<double>::infinity();
  static constexpr double Diagonal = 1e9; ///< more than all ways by faces

  /// The cost of giving a block to a label: the fewer voxels of the label it has, the more.
  double GetCost(const Share& share, int label) const
  {
    const int now = this->Coarse.Voxels[share.Block];
    const bool isHeld = this->IsGiven[share.Block] || (now > 0 && this->Blocks[now] == 1);
    return now == label ? 0. : isHeld ? Never : 1. / static_cast<double>(share.Voxels);
  }

  bool Give(vtkIdType block, int label)
  {
    int& now = this->Coarse.Voxels[block];
    if (now == label)
    {
      return false;
    }
    --this->Blocks[now];
    ++this->Blocks[label];
    this->Coarse.NumberOfMaterialVoxels += now == 0 ? 1 : 0;
    now = label;
    this->IsGiven[block] = 1;
    return true;
  }

  const LabelImage& Fine;
  const bool ByCorners;
  LabelImage& Coarse;
  std::vector<vtkIdType> Nodes;  ///< of the blocks of the piece at hand; -1 for others
  std::vector<char> IsGiven;     ///< which blocks a label got here
  std::vector<vtkIdType> Blocks; ///< number of blocks of each label
};

}

Buffer<vtkIdType> FindPieces(const LabelImage& image, bool byCorners)
{
  Buffer<vtkIdType> first(image.Voxels.size());
  for (const vtkIdType voxel : InTurn(image.Voxels.size()))
  {
    const int label = image.Voxels[voxel];
    first[voxel] = label > 0 ? voxel : -1;
    if (label > 0)
    {
      VisitNeighbours(image, voxel, byCorners, true,
        [&](vtkIdType before, int)
        {
          if (image.Voxels[before] == label)
          {
            const vtkIdType a = FindFirst(first, before);
            const vtkIdType b = FindFirst(first, voxel);
            first[std::max(a, b)] = std::min(a, b);
          }
        });
    }
  }
  for (const vtkIdType voxel : InTurn(image.Voxels.size()))
  {
    first[voxel] = first[voxel] < 0 ? -1 : first[first[voxel]];
  }
  return first;
}

void KeepConnected(
  const LabelImage& fine, const Buffer<vtkIdType>& pieces, bool byCorners, LabelImage& coarse)
{
  AllShares shares(coarse, pieces);
  std::stable_sort(shares.Pieces.begin(), shares.Pieces.end(),
    [](const PieceShares& a, const PieceShares& b) { return a.Voxels < b.Voxels; });
  Connector connector(fine, byCorners, coarse);
  // Blocks that a label takes may divide another label, which then finds another way.
  constexpr int rounds = 4;
  bool hasChanged = true;
  for (int round = 0; round < rounds && hasChanged; ++round)
  {
    hasChanged = false;
    for (const PieceShares& piece : InTurn(shares.Pieces))
    {
      hasChanged = connector.Connect(piece) || hasChanged;
    }
  }
}

std::string DescribeChangedLabels(
  const LabelImage& fine, const Buffer<vtkIdType>& pieces, bool byCorners, const LabelImage& coarse)
{
  struct Counts
  {
    vtkIdType Before = 0;
    vtkIdType Large = 0; ///< of these, with enough voxels for a block
    vtkIdType After = 0;
    bool IsTorn = false;
  };
  std::vector<Counts> counts(fine.Labels.size() + 1);
  const Buffer<vtkIdType> after = FindPieces(coarse, byCorners);
  for (const vtkIdType block : InTurn(after.size()))
  {
    counts[coarse.Voxels[block]].After += after[block] == block ? 1 : 0;
  }
  const vtkIdType enough = coarse.Length * coarse.Length * coarse.Length;
  const AllShares shares(coarse, pieces);
  for (const PieceShares& piece : InTurn(shares.Pieces))
  {
    const int label = fine.Voxels[piece.Begin->Piece];
    ++counts[label].Before;
    counts[label].Large += piece.Voxels >= enough ? 1 : 0;
    vtkIdType found = -1;
    for (const Share* share = piece.Begin; share != piece.End; ++share)
    {
      if (coarse.Voxels[share->Block] == label)
      {
        counts[label].IsTorn |= found >= 0 && found != after[share->Block];
        found = after[share->Block];
      }
    }
  }
  const auto isChanged = [](const Counts& of)
  { return of.IsTorn || (of.After > 0 && of.After < of.Large); };
  const auto first = std::find_if(counts.begin(), counts.end(), isChanged);
  if (first == counts.end())
  {
    return std::string();
  }
  const auto tell = [](vtkIdType count)
  { return std::to_string(count) + (count == 1 ? " connected piece" : " connected pieces"); };
  return std::to_string(std::count_if(first, counts.end(), isChanged)) + " of " +
    std::to_string(fine.Labels.size()) + " labels do not keep their pieces: label " +
    fine.Labels[first - counts.begin() - 1].ToString() + " has " + tell(first->Before) +
    " of voxels, and " + tell(first->After) + " in the output. Make NumberOfControlCells larger";
}

}
