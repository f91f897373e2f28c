// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HangingPoints.h
 * Points that lie inside an edge or a face of another cell.
 */
#ifndef SubdivisionObjects_HangingPoints_h
#define SubdivisionObjects_HangingPoints_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Control/OpenPoints.h"
#include "Private/Reading/FlatPart.h"
#include "Private/Reading/NearPoints.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace subdivision
{

/// A simplex of the complex, or a face (2) or an edge (1) of a surface.
struct Owner
{
  int Dimension;
  vtkIdType Index;
};

inline double GetLength(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Moves all sides of a box outwards, by a part of its diagonal.
inline void Grow(Box& box, double part)
{
  const double by = part * GetDiagonal(box);
  std::transform(box.Low, box.Low + 3, box.Low, [=](double low) { return low - by; });
  std::transform(box.High, box.High + 3, box.High, [=](double high) { return high + by; });
}

/// An open part, or another edge or face near open points: points may hang on it.
struct Host
{
  std::size_t First; ///< of its points in the list of all hosts
  int Size;
  Owner Of;
  bool IsOpen; ///< no other cell has it
};

/// The open points that hang.
class HangingPoints
{
public:
  HangingPoints(const std::vector<vtkIdType>& open, const double* coordinates, vtkIdType points)
    : Open(open)
    , Numbers(points, -1)
    , X(3 * open.size())
    , Ids(static_cast<vtkIdType>(open.size()))
    , Hangs(open.size())
  {
    Box box;
    for (const std::size_t i : InTurn(open.size()))
    {
      box.Add(coordinates + 3 * open[i]);
      this->Numbers[open[i]] = static_cast<int>(i);
      this->Ids[static_cast<vtkIdType>(i)] = static_cast<int>(i);
    }
    // Products of very large and very small numbers do not fit.
    const double size = GetDiagonal(box);
    for (const std::size_t i : InTurn(this->X.size()))
    {
      this->X[i] = (coordinates[3 * open[i / 3] + static_cast<vtkIdType>(i % 3)] / size) -
        box.Low[i % 3] / size;
    }
    this->Tree = SimplexTree(this->X.data(), 1, this->Ids);
  }
  template <typename Id>
  void AddHost(const Id* vertices, int size, const Owner& owner, bool isOpen)
  {
    this->Hosts.push_back({ this->Corners.size(), size, owner, isOpen });
    std::transform(vertices, vertices + size, std::back_inserter(this->Corners),
      [this](Id vertex) { return this->Numbers[vertex]; });
    this->HostOf.insert(this->HostOf.end(), size, static_cast<int>(this->Hosts.size()) - 1);
  }
  /// `mayHang(owner, vertex)`: whether a point can hang on a host of this owner; `isSingle`: it
  /// needs no edge along the host; `fit(owner, other)`: whether cells share an edge or a face.
  template <typename MayHang, typename Fit>
  void Find(bool isSingle, const MayHang& mayHang, const Fit& fit)
  {
    const Rows<int> hostsAt = ListByRow<int>(
      static_cast<vtkIdType>(this->Open.size()), static_cast<vtkIdType>(this->Corners.size()),
      [&](vtkIdType i) { return this->Corners[i]; }, [&](vtkIdType i) { return this->HostOf[i]; });
    this->Held = Buffer<int>(static_cast<vtkIdType>(this->Hosts.size()), -1);
    const auto findOf = [&](vtkIdType h, const std::vector<int>& candidates)
    {
      const Host& host = this->Hosts[h];
      for (const int point : this->FindInside(h, candidates))
      {
        if (mayHang(host.Of, this->Open[point]) &&
          (isSingle || this->HasAlong(host, point, hostsAt[point], fit)))
        {
          this->Hangs[point].store(1, std::memory_order_relaxed);
          this->Held[h] = this->Held[h] < 0 ? point : std::min(this->Held[h], point);
        }
      }
    };
    // Hosts that follow each other are mostly near each other, and have the same points near them.
    constexpr vtkIdType together = 16;
    constexpr std::size_t most = 128;
    const vtkIdType count = this->Held.size();
    ForEach((count + together - 1) / together,
      [&](vtkIdType group)
      {
        const vtkIdType first = together * group;
        const vtkIdType last = std::min(first + together, count);
        const std::vector<int> near = this->FindInBox(this->GetBox(first, last));
        for (vtkIdType h = first; h < last; ++h)
        {
          findOf(h, near.size() <= most ? near : this->FindInBox(this->GetBox(h, h + 1)));
        }
      });
  }
  std::string Describe(const OpenPointOptions& options) const
  {
    const auto count = std::count(this->Hangs.begin(), this->Hangs.end(), 1);
    std::pair<vtkIdType, vtkIdType> first(VTK_ID_MAX, -1); // cell and point
    for (const vtkIdType h : InTurn(this->Held.size()))
    {
      if (this->Held[h] >= 0)
      {
        const Owner& owner = this->Hosts[h].Of;
        first = std::min(
          first, { options.FindCell(owner.Dimension, owner.Index), this->Open[this->Held[h]] });
      }
    }
    return count == 0
      ? std::string()
      : std::to_string(count) + (count == 1 ? " point hangs: it lies" : " points hang: they lie") +
        " inside an edge or a face of another cell (the first cell is " +
        std::to_string(first.first) + ", with point " + std::to_string(first.second) +
        "), as in adaptive meshes, and cells come apart there. Switch CloseHangingNodes on to have "
        "cells cut so that they fit.";
  }

private:
  FlatPart MakePart(const Host& host) const
  {
    std::vector<const double*> corners;
    for (int i = 0; i < host.Size; ++i)
    {
      corners.push_back(this->GetPoint(this->Corners[host.First + i]));
    }
    return FlatPart(corners.data(), host.Size);
  }
  /// The box of hosts, a bit larger: a face that is warped may bulge out of the box of its corners.
  Box GetBox(vtkIdType first, vtkIdType last) const
  {
    Box box;
    int size = 0;
    for (vtkIdType h = first; h < last; ++h)
    {
      const int* corners = this->Corners.data() + this->Hosts[h].First;
      std::for_each(corners, corners + this->Hosts[h].Size,
        [&](int corner) { box.Add(this->GetPoint(corner)); });
      size = std::max(size, this->Hosts[h].Size);
    }
    Grow(box, size > 3 ? 0.1 : 2. * FlatPart::Tolerance);
    return box;
  }
  std::vector<int> FindInBox(const Box& box) const
  {
    std::vector<int> points;
    this->Tree.ForEachWhere([&box](const Box& other) { return box.Meets(other); },
      [&](vtkIdType i)
      {
        if (box.Holds(this->GetPoint(static_cast<int>(i))))
        {
          points.push_back(static_cast<int>(i));
        }
      });
    return points;
  }
  /// The points in the box of a host that lie inside it.
  std::vector<int> FindInside(vtkIdType h, std::vector<int> points) const
  {
    const Host& host = this->Hosts[h];
    const int* begin = this->Corners.data() + host.First;
    const Box box = this->GetBox(h, h + 1);
    const auto erase = [&points](const auto& isOut)
    { points.erase(std::remove_if(points.begin(), points.end(), isOut), points.end()); };
    erase(
      [&](int point)
      {
        return !box.Holds(this->GetPoint(point)) ||
          std::find(begin, begin + host.Size, point) != begin + host.Size;
      });
    if (!points.empty())
    {
      const FlatPart part = this->MakePart(host);
      erase([&](int point) { return part.Find(this->GetPoint(point)) != FlatPart::Inside; });
    }
    return points;
  }
  /// Whether a line ends at a point, or an edge of another cell leaves it along the host. Where the
  /// cells fit, there have to be edges on two sides along a part of the border, because flat cells
  /// have points on their own edges. An edge hardly longer than the tolerance may have any
  /// direction.
  template <typename Fit>
  bool HasAlong(const Host& host, int point, const Row<int>& around, const Fit& fit) const
  {
    if (around.size() == 1 && this->Hosts[*around.begin()].Of.Dimension == 1)
    {
      return true;
    }
    const FlatPart part = this->MakePart(host);
    const double* x = this->GetPoint(point);
    std::vector<vectors::Vector> sides; // of cells that fit
    for (const int other : around)
    {
      const Host& edge = this->Hosts[other];
      const bool isOwn =
        std::tie(edge.Of.Dimension, edge.Of.Index) == std::tie(host.Of.Dimension, host.Of.Index);
      for (int i = 0; !isOwn && i < edge.Size; ++i)
      {
        const int corner = this->Corners[edge.First + i];
        const double* end = this->GetPoint(corner);
        vectors::Vector at; // it may end beyond the host
        vectors::Vector step;
        for (int k = 0; k < 3; ++k)
        {
          step[k] = (end[k] - x[k]) / 16.;
          at[k] = x[k] + step[k];
        }
        const bool isAlong = corner != point && GetLength(x, at.data()) > part.GetTolerance() &&
          part.Find(at.data()) != FlatPart::Off;
        if (isAlong && !fit(edge.Of, host.Of))
        {
          return true;
        }
        if (isAlong && host.IsOpen)
        {
          sides.push_back(step);
        }
      }
    }
    return std::any_of(sides.begin(), sides.end(),
      [&sides](const auto& side) { return vectors::Dot(side, sides[0]) < 0.; });
  }
  const double* GetPoint(int i) const { return this->X.data() + 3 * static_cast<std::size_t>(i); }

  const std::vector<vtkIdType>& Open;
  Buffer<int> Numbers; ///< of points among the open ones
  std::vector<double> X;
  Buffer<int> Ids;
  SimplexTree Tree;
  std::vector<Host> Hosts;
  std::vector<int> Corners; ///< of all hosts, by their numbers
  std::vector<int> HostOf;  ///< of each corner
  std::vector<std::atomic<unsigned char>> Hangs;
  Buffer<int> Held; ///< the first point that hangs on each host
};

}

#endif
