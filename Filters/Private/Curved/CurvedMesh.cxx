// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CurvedMesh.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Curved/CellJacobian.h"
#include "Private/Curved/CurvedNodes.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <tuple>

namespace subdivision
{
namespace
{

using Point = std::array<double, 3>;
using Cells = std::vector<vtkIdType>;

/// Reads points in several threads.
class PointReader
{
public:
  explicit PointReader(vtkDataArray* points)
    : Points(points)
    , Single(points->GetDataType() == VTK_FLOAT ? points->GetVoidPointer(0) : nullptr)
    , Double(points->GetDataType() == VTK_DOUBLE ? points->GetVoidPointer(0) : nullptr)
  {
  }
  Point Get(vtkIdType i) const
  {
    Point p;
    if (this->Double)
    {
      std::copy_n(static_cast<const double*>(this->Double) + 3 * i, 3, p.begin());
    }
    else if (this->Single)
    {
      std::copy_n(static_cast<const float*>(this->Single) + 3 * i, 3, p.begin());
    }
    else
    {
      this->Points->GetTuple(i, p.data());
    }
    return p;
  }

private:
  vtkDataArray* Points;
  const void* Single;
  const void* Double;
};

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

/// The solids at each node, and nodes on the boundary: on faces of one solid only, and of other
/// cells. Both are looked up for few nodes, next to solids that have to be repaired.
class Surroundings
{
public:
  Surroundings(const CurvedMesh& mesh, vtkIdType points)
    : Mesh(mesh)
    , Starts(points + 1, 0)
    , AreOther(points, 0)
  {
    this->ForNodes([this](vtkIdType, vtkIdType node) { ++this->Starts[node + 1]; });
    for (const vtkIdType node : InTurn(points))
    {
      this->Starts[node + 1] += this->Starts[node];
    }
    this->Solids.resize(this->Starts[points]);
    Cells next(this->Starts.begin(), this->Starts.end() - 1);
    this->ForNodes([&](vtkIdType cell, vtkIdType node) { this->Solids[next[node]++] = cell; });
  }
  const vtkIdType* Begin(vtkIdType node) const { return this->Solids.data() + this->Starts[node]; }
  const vtkIdType* End(vtkIdType node) const
  {
    return this->Solids.data() + this->Starts[node + 1];
  }
  bool IsOnBoundary(vtkIdType node) const
  {
    return this->AreOther[node] ||
      std::any_of(this->Begin(node), this->End(node),
        [&](vtkIdType solid)
        {
          const auto& faces = this->Mesh.Shapes[solid]->Faces;
          const vtkIdType* nodes = this->Mesh.GetNodes(solid);
          return std::any_of(faces.begin(), faces.end(),
            [&](const CurvedShape::Face& face)
            {
              return std::any_of(face.Nodes.begin(), face.Nodes.end(),
                       [&](int n) { return nodes[n] == node; }) &&
                this->IsOpen(solid, face);
            });
        });
  }

private:
  /// act(cell, node) for all solids; nodes of other cells are on the boundary.
  template <typename Act>
  void ForNodes(const Act& act)
  {
    for (const vtkIdType c : InTurn(this->Mesh.GetNumberOfCells()))
    {
      const CurvedShape& shape = *this->Mesh.Shapes[c];
      const vtkIdType* nodes = this->Mesh.GetNodes(c);
      for (int n = 0; n < shape.GetNumberOfNodes(); ++n)
      {
        shape.Jacobian ? act(c, nodes[n]) : void(this->AreOther[nodes[n]] = 1);
      }
    }
  }
  /// Whether no other solid has all corners of a face.
  bool IsOpen(vtkIdType solid, const CurvedShape::Face& face) const
  {
    const vtkIdType* nodes = this->Mesh.GetNodes(solid);
    const auto hasAll = [&](vtkIdType other)
    {
      const vtkIdType* begin = this->Mesh.GetNodes(other);
      const vtkIdType* end = begin + GetCellTable(this->Mesh.Shapes[other]->Shape).Corners;
      return other != solid &&
        std::all_of(face.Nodes.begin(), face.Nodes.begin() + face.Corners,
          [&](int corner) { return std::find(begin, end, nodes[corner]) != end; });
    };
    const vtkIdType first = nodes[face.Nodes[0]];
    return std::none_of(this->Begin(first), this->End(first), hasAll);
  }

  const CurvedMesh& Mesh;
  Cells Starts;
  Cells Solids;
  std::vector<unsigned char> AreOther;
};

/// Moves nodes of solids that are not valid.
class Repair
{
public:
  /// `invalid`: the cells, in ascending order.
  Repair(const CurvedMesh& mesh, vtkDataArray* given, vtkDataArray* points, const Cells& invalid,
    CurvedProof& proof)
    : Mesh(mesh)
    , Points(points)
    , Given(given)
    , At(points)
    , Around(mesh, points->GetNumberOfTuples())
    , Shares(points->GetNumberOfTuples(), 1.)
    , OnBoundary(points->GetNumberOfTuples(), Unknown)
    , All(invalid)
    , Proof(proof)
  {
  }

  void Mend(vtkIdType solids, const std::function<void(const std::string&)>& warn,
    const std::function<void(const std::string&)>& fail)
  {
    Cells invalid = this->All;
    this->LeaveOutHopeless(invalid);
    for (const bool movesBoundary : { false, true })
    {
      this->MendAll(invalid, movesBoundary);
    }
    std::ostringstream text;
    if (this->LargestMove > 0.)
    {
      text << this->All.size() << " of " << solids
           << " curved solids were not valid, the first is cell " << this->All[0]
           << ": nodes of them went back towards the straight cells, by " << this->LargestMove
           << " at most. The control mesh is coarse there: take more levels, or make it finer.";
      warn(text.str());
    }
    // A node of a neighbour that moved may have turned more of these than there were.
    const std::vector<unsigned char>& valid = this->Proof.Valid;
    const auto hopeless = std::count(valid.begin(), valid.end(), 0);
    if (hopeless > 0)
    {
      text.str("");
      text << hopeless << " of " << solids
           << " curved solids are inside out even with straight edges, the first is cell "
           << std::find(valid.begin(), valid.end(), 0) - valid.begin()
           << ": the control mesh is too thin there, or its cells are inside out. "
           << "Turn these, make the solids less flat, or take fewer levels.";
      fail(text.str());
    }
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
    vtkIdType Node;
    double Share;
    Point To;
  };

  /// Looks up which nodes of cells are on the boundary.
  void LookAround(const Cells& cells)
  {
    for (const vtkIdType c : InTurn(cells))
    {
      const vtkIdType* nodes = this->Mesh.GetNodes(c);
      for (int n = 0; n < this->Mesh.Shapes[c]->GetNumberOfNodes(); ++n)
      {
        unsigned char& isOn = this->OnBoundary[nodes[n]];
        if (isOn == Unknown)
        {
          isOn = this->Around.IsOnBoundary(nodes[n]) ? Yes : No;
        }
      }
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
    const Point given = this->Given.Get(nodes[n]);
    Point at{};
    for (int corner = 0; corner < GetCellTable(shape.Shape).Corners; ++corner)
    {
      const Point p = this->Given.Get(nodes[corner]);
      for (int k = 0; k < 3; ++k)
      {
        at[k] += weights[corner] * p[k];
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      at[k] += share * (given[k] - at[k]);
      at[k] = this->Points->GetDataType() == VTK_FLOAT ? static_cast<float>(at[k]) : at[k];
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
          : this->At.Get(node);
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
    for (int round = 0; !invalid.empty() && (movesBoundary || round <= rounds); ++round)
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
          if (this->Moves(c, n, movesBoundary))
          {
            moved.push_back({ node, share, this->Place(c, n, share) });
          }
        }
      }
      // The first cell of the smallest share tells the place: others differ by rounding.
      std::stable_sort(moved.begin(), moved.end(), [](const Move& a, const Move& b)
        { return std::tie(a.Node, a.Share) < std::tie(b.Node, b.Share); });
      moved.erase(std::unique(moved.begin(), moved.end(),
                    [](const Move& a, const Move& b) { return a.Node == b.Node; }),
        moved.end());
      if (moved.empty()) // and so in all rounds
      {
        return;
      }
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
    for (const auto& [node, share, at] : moved)
    {
      const Point given = this->Given.Get(node);
      this->Shares[node] = share;
      this->Points->SetTuple(node, at.data());
      this->LargestMove = std::max(
        this->LargestMove, std::hypot(at[0] - given[0], at[1] - given[1], at[2] - given[2]));
      around.insert(around.end(), this->Around.Begin(node), this->Around.End(node));
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    ForBounds(
      this->Mesh, static_cast<vtkIdType>(around.size()), [&](vtkIdType i) { return around[i]; },
      [this](vtkIdType, int, vtkIdType node) { return this->At.Get(node); },
      [this](vtkIdType cell, const CellJacobian::Bound& bound) { this->Proof.Set(cell, bound); });
    invalid.clear();
    std::copy_if(around.begin(), around.end(), std::back_inserter(invalid),
      [this](vtkIdType c) { return !this->Proof.Valid[c]; });
    this->LeaveOutHopeless(invalid);
  }

  const CurvedMesh& Mesh;
  vtkDataArray* Points;
  const PointReader Given; ///< where nodes were
  const PointReader At;    ///< where they are
  const Surroundings Around;
  std::vector<double> Shares;            ///< of each node, how much of its way it keeps
  std::vector<unsigned char> OnBoundary; ///< of the solids, or on other cells
  const Cells& All;
  CurvedProof& Proof;
  double LargestMove = 0.;
};

}

CurvedProof ProveAndRepair(const CurvedMesh& mesh, bool isWhole,
  vtkSmartPointer<vtkDataArray>& points, const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail)
{
  const auto given = Contiguous(points);
  const PointReader reader(given);
  CurvedProof proof;
  proof.Valid.assign(mesh.Shapes.size(), 1);
  proof.Scaled.assign(mesh.Shapes.size(), 1.);
  ForBounds(
    mesh, mesh.GetNumberOfCells(), [](vtkIdType i) { return i; },
    [&](vtkIdType, int, vtkIdType node) { return reader.Get(node); },
    [&](vtkIdType cell, const CellJacobian::Bound& bound) { proof.Set(cell, bound); });
  Cells invalid;
  vtkIdType solids = 0;
  for (const vtkIdType c : InTurn(mesh.GetNumberOfCells()))
  {
    solids += mesh.Shapes[c]->Jacobian ? 1 : 0;
    proof.Valid[c] ? void() : invalid.push_back(c);
  }
  if (!invalid.empty() && !isWhole)
  {
    warn(std::to_string(invalid.size()) + " of " + std::to_string(solids) +
      " curved solids are not valid, the first is cell " + std::to_string(invalid[0]) +
      " of its block: solids of several blocks and ranks are not repaired. Join the blocks in one "
      "process, or take more levels.");
  }
  else if (!invalid.empty())
  {
    points = vtkSmartPointer<vtkDataArray>::Take(given->NewInstance());
    points->DeepCopy(given);
    Repair(mesh, given, points, invalid, proof).Mend(solids, warn, fail);
  }
  return proof;
}

}
