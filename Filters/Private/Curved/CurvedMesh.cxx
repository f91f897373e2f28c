// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CurvedMesh.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Curved/CellJacobian.h"
#include "Private/Curved/CurvedNodes.h"
#include "Private/Curved/CurvedParts.h"
#include "Private/Partitions/OtherPartitions.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <numeric>
#include <sstream>
#include <tuple>

namespace subdivision
{
namespace
{

using Point = NodePoint;
using Cells = std::vector<vtkIdType>;

/// Finds bounds of cells that are added one by one, some at a time. place(cell, number, node) is
/// where a node is; act(cell, bound) is called for solids only.
template <typename Place, typename Act>
class BoundFinder
{
public:
  BoundFinder(const CurvedMesh& mesh, const Place& place, const Act& act)
    : Mesh(mesh)
    , Where(place)
    , Use(act)
  {
  }
  void Add(vtkIdType cell)
  {
    const CurvedShape* shape = this->Mesh.Shapes[cell];
    if (!shape->Jacobian)
    {
      return;
    }
    if (shape != this->Shape)
    {
      this->Finish();
      this->Shape = shape;
      shape->Jacobian->Start(this->Work);
    }
    const vtkIdType* nodes = this->Mesh.GetNodes(cell);
    for (int n = 0; n < shape->GetNumberOfNodes(); ++n)
    {
      this->Work.Set(this->Size, n, this->Where(cell, n, nodes[n]).data());
    }
    this->Cells[this->Size] = cell;
    if (++this->Size == CellJacobian::Lanes)
    {
      this->Finish();
    }
  }
  void Finish()
  {
    CellJacobian::Bound bounds[CellJacobian::Lanes];
    this->Size > 0 ? this->Shape->Jacobian->Find(this->Work, this->Size, bounds) : void();
    for (int l = 0; l < this->Size; ++l)
    {
      this->Use(this->Cells[l], bounds[l]);
    }
    this->Size = 0;
  }

private:
  const CurvedMesh& Mesh;
  const Place& Where;
  const Act& Use;
  const CurvedShape* Shape = nullptr;
  CellJacobian::Workspace Work;
  vtkIdType Cells[CellJacobian::Lanes] = {};
  int Size = 0;
};

/// The same for the cells get(0), get(1), ... in threads. No bound depends on the cells beside it.
template <typename Get, typename Place, typename Act>
void ForBounds(
  const CurvedMesh& mesh, vtkIdType size, const Get& get, const Place& place, const Act& act)
{
  constexpr vtkIdType block = 64;
  ForRangesOfBlocks((size + block - 1) / block,
    [&](vtkIdType begin, vtkIdType end)
    {
      BoundFinder<Place, Act> finder(mesh, place, act);
      for (vtkIdType i = block * begin; i < std::min(size, block * end); ++i)
      {
        finder.Add(get(i));
      }
      finder.Finish();
    });
}

/// Moves nodes of solids that are not valid. All ranks do the same steps: each has its own cells,
/// and all tell one another which nodes move.
class Repair
{
public:
  Repair(const std::vector<CurvedPart*>& parts, Exchange& ranks)
    : Parts(parts)
    , Ranks(ranks)
    , Joined(parts)
    , Mesh(this->Joined.Mesh)
    , Given(this->Joined.Points)
    , At(this->Given)
    , Around(this->Mesh, static_cast<vtkIdType>(this->At.size()))
    , Shares(this->At.size(), 1.)
    , OnBoundary(this->At.size(), Unknown)
    , Proof(this->Joined.Proof)
  {
  }

  void Mend(const std::function<void(const std::string&)>& warn,
    const std::function<void(const std::string&)>& fail)
  {
    vtkIdType solids = 0;
    Cells invalid;
    for (const vtkIdType c : InTurn(this->Mesh.GetNumberOfCells()))
    {
      solids += this->Mesh.Shapes[c]->Jacobian ? 1 : 0;
      this->Proof.Valid[c] ? void() : invalid.push_back(c);
    }
    const std::string were = this->DescribeInvalid(solids, " curved solids were not valid");
    this->LeaveOutHopeless(invalid);
    for (const bool movesBoundary : { false, true })
    {
      this->MendAll(invalid, movesBoundary);
    }
    // A node of a neighbour that moved may have turned more of these than there were.
    const std::string are =
      this->DescribeInvalid(solids, " curved solids are inside out even with straight edges");
    const bool tells = this->Ranks.GetPartition() == 0;
    if (this->LargestMove > 0. && tells)
    {
      std::ostringstream text;
      text << were << ": nodes of them went back towards the straight cells, by "
           << this->LargestMove
           << " at most. The control mesh is coarse there: take more levels, or make it finer.";
      warn(text.str());
    }
    if (!are.empty() && tells)
    {
      fail(are +
        ": the control mesh is too thin there, or its cells are inside out. Turn these, make the "
        "solids less flat, or take fewer levels.");
    }
    this->WriteParts();
  }

private:
  enum : unsigned char
  {
    No,
    Yes,
    Unknown
  };
  struct Move
  {
    NodeKey Node;
    double Share;
    Point To;

    auto GetRank() const { return std::make_tuple(this->Node, this->Share, ToBits(this->To)); }
  };

  /// Counts the cells of all ranks that are not valid, and names the first; empty: there are none.
  std::string DescribeInvalid(vtkIdType solids, const char* what)
  {
    const auto& valid = this->Proof.Valid;
    vtkIdType cell = std::find(valid.begin(), valid.end(), 0) - valid.begin();
    const bool isFound = cell < static_cast<vtkIdType>(valid.size());
    std::size_t part = 0;
    for (; isFound && cell >= this->Parts[part]->Mesh.GetNumberOfCells(); ++part)
    {
      cell -= this->Parts[part]->Mesh.GetNumberOfCells();
    }
    const vtkIdType count = this->Ranks.Sum(std::count(valid.begin(), valid.end(), 0));
    const vtkIdType all = this->Ranks.Sum(solids);
    const auto cells = this->Ranks.Gather(isFound ? cell + 1 : 0);
    const auto blocks = this->Ranks.Gather(isFound ? this->Parts[part]->Block : 0);
    const auto rank = static_cast<std::size_t>(
      std::find_if(cells.begin(), cells.end(), [](vtkIdType c) { return c > 0; }) - cells.begin());
    if (rank == cells.size())
    {
      return "";
    }
    return std::to_string(count) + " of " + std::to_string(all) + what + ", the first is cell " +
      std::to_string(cells[rank] - 1) +
      (blocks[rank] > 0 ? " of block " + std::to_string(blocks[rank]) : "") +
      (cells.size() > 1 ? " of rank " + std::to_string(rank) : "");
  }
  /// Gives the parts what they have now.
  void WriteParts()
  {
    auto node = this->Joined.Firsts.begin();
    auto valid = this->Proof.Valid.begin();
    auto scaled = this->Proof.Scaled.begin();
    for (CurvedPart* part : this->Parts)
    {
      vtkSmartPointer<vtkDataArray> moved;
      for (const vtkIdType i : InTurn(part->Points->GetNumberOfTuples()))
      {
        if (this->Shares[*node] < 1.)
        {
          if (!moved)
          {
            moved = vtkSmartPointer<vtkDataArray>::Take(part->Points->NewInstance());
            moved->DeepCopy(part->Points);
          }
          moved->SetTuple(i, this->At[*node].data());
        }
        ++node;
      }
      part->Points = moved ? moved : part->Points;
      const vtkIdType size = part->Mesh.GetNumberOfCells();
      std::copy_n(valid, size, part->Proof.Valid.begin());
      std::copy_n(scaled, size, part->Proof.Scaled.begin());
      valid += size;
      scaled += size;
    }
  }

  /// Looks up which nodes of cells are on the boundary. A face that one rank has in one solid only
  /// is not open if another has it, too.
  void LookAround(const Cells& cells)
  {
    std::vector<NodeKey> asked;
    for (const vtkIdType c : InTurn(cells))
    {
      const vtkIdType* nodes = this->Mesh.GetNodes(c);
      for (int n = 0; n < this->Mesh.Shapes[c]->GetNumberOfNodes(); ++n)
      {
        unsigned char& isOn = this->OnBoundary[nodes[n]];
        isOn == Unknown ? asked.push_back(this->Joined.Keys[nodes[n]]) : void();
        isOn = isOn == Unknown ? static_cast<unsigned char>(No) : isOn;
      }
    }
    this->Ranks.ShareWithAll(asked);
    SortDistinct(asked);
    // A node, who has other cells there, and the corners of a face.
    using Sight = std::array<std::int64_t, 17>;
    std::vector<Sight> seen;
    for (const NodeKey& key : InTurn(asked))
    {
      const vtkIdType node = this->Joined.Find(key);
      Sight sight{};
      std::copy(key.begin(), key.end(), sight.begin());
      if (node >= 0 && this->Around.IsOnOther(node))
      {
        sight[4] = 1 + this->Ranks.GetPartition();
        seen.push_back(sight);
        sight[4] = 0;
      }
      const auto add = [&](const Cells& corners)
      {
        std::array<Bits, 4> places{};
        std::transform(corners.begin(), corners.end(), places.begin(),
          [this](vtkIdType corner) { return ToBits(this->Given[corner]); });
        std::sort(places.begin(), places.end());
        std::memcpy(sight.data() + 5, places.data(), sizeof(places));
        seen.push_back(sight);
      };
      node >= 0 ? this->Around.ForOpenFaces(node, add) : void();
    }
    this->Ranks.ShareWithAll(seen);
    StableSort(seen, std::less<>());
    for (auto begin = seen.begin(); begin != seen.end();)
    {
      const auto end = std::upper_bound(begin, seen.end(), *begin);
      NodeKey key;
      std::copy_n(begin->begin(), key.size(), key.begin());
      const vtkIdType node = this->Joined.Find(key);
      if (node >= 0 && end - begin == 1)
      {
        this->OnBoundary[node] = Yes;
      }
      begin = end;
    }
  }
  bool Moves(vtkIdType cell, int n, bool movesBoundary) const
  {
    return n >= GetCellTable(this->Mesh.Shapes[cell]->Shape).Corners &&
      (movesBoundary || this->OnBoundary[this->Mesh.GetNodes(cell)[n]] == No);
  }
  /// Where a node of a cell is that keeps a share of its way from the straight cell.
  Point Place(vtkIdType cell, int n, double share) const
  {
    const CurvedShape& shape = *this->Mesh.Shapes[cell];
    const vtkIdType* nodes = this->Mesh.GetNodes(cell);
    const auto weights = GetStraightWeights(shape, shape.Nodes[n]);
    const Point given = this->Given[nodes[n]];
    Point at{};
    for (int corner = 0; corner < GetCellTable(shape.Shape).Corners; ++corner)
    {
      const Point p = this->Given[nodes[corner]];
      for (int k = 0; k < 3; ++k)
      {
        at[k] += weights[corner] * p[k];
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      at[k] += share * (given[k] - at[k]);
      at[k] = this->Joined.AreSingle[nodes[n]] ? static_cast<float>(at[k]) : at[k];
    }
    return at;
  }
  /// Whether cells are valid where their nodes that may move have a part of their present shares.
  std::vector<unsigned char> AreValidAt(
    const Cells& cells, const std::vector<double>& parts, bool movesBoundary) const
  {
    std::vector<unsigned char> valid(cells.size(), 0);
    const auto find = [&cells](vtkIdType cell)
    { return std::lower_bound(cells.begin(), cells.end(), cell) - cells.begin(); };
    ForBounds(
      this->Mesh, static_cast<vtkIdType>(cells.size()), [&](vtkIdType i) { return cells[i]; },
      [&](vtkIdType cell, int n, vtkIdType node)
      {
        return this->Moves(cell, n, movesBoundary)
          ? this->Place(cell, n, parts[find(cell)] * this->Shares[node])
          : this->At[node];
      },
      [&](vtkIdType cell, const CellJacobian::Bound& bound)
      { valid[find(cell)] = bound.IsValid ? 1 : 0; });
    return valid;
  }
  /// Leaves out cells that are not valid even if they are straight.
  void LeaveOutHopeless(Cells& cells) const
  {
    const auto valid = this->AreValidAt(cells, std::vector<double>(cells.size(), 0.), true);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      cells[kept] = cells[i];
      kept += valid[i];
    }
    cells.resize(kept);
  }

  /// Rounds until no cell is invalid: a node that several cells share keeps the smallest share.
  void MendAll(Cells& invalid, bool movesBoundary)
  {
    constexpr int rounds = 10; // cells that are invalid then become straight
    for (int round = 0;
      this->Ranks.Max(invalid.empty() ? 0 : 1) > 0 && (movesBoundary || round <= rounds); ++round)
    {
      this->LookAround(invalid);
      std::vector<double> parts(invalid.size(), 0.);
      const auto helps = this->AreValidAt(invalid, parts, movesBoundary);
      round < rounds ? this->FindParts(invalid, helps, movesBoundary, parts) : void();
      std::vector<Move> moved;
      for (std::size_t i = 0; i < invalid.size(); ++i)
      {
        const vtkIdType c = invalid[i];
        const int nodes = helps[i] || movesBoundary ? this->Mesh.Shapes[c]->GetNumberOfNodes() : 0;
        for (int n = 0; n < nodes; ++n)
        {
          const vtkIdType node = this->Mesh.GetNodes(c)[n];
          const double share = parts[i] * this->Shares[node];
          if (this->Moves(c, n, movesBoundary) && share < this->Shares[node])
          {
            moved.push_back({ this->Joined.Keys[node], share, this->Place(c, n, share) });
          }
        }
      }
      this->Ranks.ShareWithAll(moved);
      if (moved.empty()) // and so in all rounds
      {
        return;
      }
      // Places of the smallest share differ by rounding, from cell to cell: any order chooses.
      std::sort(moved.begin(), moved.end(),
        [](const Move& a, const Move& b) { return a.GetRank() < b.GetRank(); });
      moved.erase(std::unique(moved.begin(), moved.end(),
                    [](const Move& a, const Move& b) { return a.Node == b.Node; }),
        moved.end());
      this->Apply(moved, invalid);
    }
  }
  /// The largest parts with which cells are valid that `helps` says to be so with 0.
  void FindParts(const Cells& cells, const std::vector<unsigned char>& helps, bool movesBoundary,
    std::vector<double>& parts) const
  {
    Cells helped;
    std::vector<double> found;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      helps[i] ? helped.push_back(cells[i]) : void();
    }
    found.resize(helped.size(), 0.);
    for (double step = 0.5; step > 1. / 64.; step *= 0.5)
    {
      std::vector<double> middles = found;
      std::for_each(middles.begin(), middles.end(), [step](double& part) { part += step; });
      const auto valid = this->AreValidAt(helped, middles, movesBoundary);
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        found[i] = valid[i] ? middles[i] : found[i];
      }
    }
    for (std::size_t i = 0, next = 0; i < cells.size(); ++i)
    {
      parts[i] = helps[i] ? found[next++] : 0.;
    }
  }
  /// Moves nodes, and lists the cells there which are not valid, but would be where they are
  /// straight.
  void Apply(const std::vector<Move>& moved, Cells& invalid)
  {
    Cells around = invalid;
    for (const Move& move : moved)
    {
      Point given;
      std::memcpy(given.data(), move.Node.data(), sizeof(given));
      this->LargestMove = std::max(this->LargestMove,
        std::hypot(move.To[0] - given[0], move.To[1] - given[1], move.To[2] - given[2]));
      const vtkIdType node = this->Joined.Find(move.Node);
      if (node >= 0) // else other ranks have it
      {
        this->Shares[node] = move.Share;
        this->At[node] = move.To;
        around.insert(around.end(), this->Around.Begin(node), this->Around.End(node));
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    ForBounds(
      this->Mesh, static_cast<vtkIdType>(around.size()), [&](vtkIdType i) { return around[i]; },
      [this](vtkIdType, int, vtkIdType node) { return this->At[node]; },
      [this](vtkIdType cell, const CellJacobian::Bound& bound) { this->Proof.Set(cell, bound); });
    invalid.clear();
    std::copy_if(around.begin(), around.end(), std::back_inserter(invalid),
      [this](vtkIdType c) { return !this->Proof.Valid[c]; });
    this->LeaveOutHopeless(invalid);
  }

  const std::vector<CurvedPart*>& Parts;
  Exchange& Ranks;
  JoinedParts Joined;
  const CurvedMesh& Mesh;
  const std::vector<Point>& Given; ///< where nodes were
  std::vector<Point> At;           ///< where they are
  const Surroundings Around;
  std::vector<double> Shares;            ///< of each node, how much of its way it keeps
  std::vector<unsigned char> OnBoundary; ///< of the solids, or on other cells
  CurvedProof& Proof;
  double LargestMove = 0.;
};

}

void ProveAndRepair(const std::vector<CurvedPart*>& parts, Exchange& ranks,
  const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail)
{
  bool areValid = true;
  for (CurvedPart* part : parts)
  {
    CurvedProof& proof = part->Proof;
    proof.Valid.assign(part->Mesh.Shapes.size(), 1);
    proof.Scaled.assign(part->Mesh.Shapes.size(), 1.);
    ForBounds(
      part->Mesh, part->Mesh.GetNumberOfCells(), [](vtkIdType i) { return i; },
      [part](vtkIdType, int, vtkIdType node) { return ReadPoint(part->Points, node); },
      [&](vtkIdType cell, const CellJacobian::Bound& bound) { proof.Set(cell, bound); });
    areValid =
      areValid && std::find(proof.Valid.begin(), proof.Valid.end(), 0) == proof.Valid.end();
  }
  if (!ranks.Agree(areValid))
  {
    Repair(parts, ranks).Mend(warn, fail);
  }
}

}
