// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/LimitPatches.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Memory/Vectors.h"
#include "Core/Solids/Location/CurveOrder.h"
#include "Private/Places/LimitPatchShape.h"
#include "Private/Places/PlaceScore.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

using vectors::Vector;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Rounding = 1e-14;            ///< of limits, by the largest coordinate
constexpr int MostSplits = 24;                ///< of a cell
constexpr double Farthest = 1e14;             ///< sizes, beyond which only the direction counts
constexpr vtkIdType Width = 4;                ///< children of a box
constexpr std::size_t MostRequests = 1 << 14; ///< of a point, so that no search goes on for ever
constexpr std::size_t MostPlaces = 16;        ///< at which searches for a point begin
constexpr std::size_t SplitAtATime = 512;

double Measure(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}
bool IsFinite(const Vector& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// How many patches may be split next for a point: few, as each may show that others need not be;
/// but more once many were, as nearly all may be equally near.
std::size_t CountRequests(std::size_t before)
{
  constexpr std::size_t few = 16;
  constexpr std::size_t many = 512;
  return before < many ? few : std::min(before / 4, MostRequests - std::min(MostRequests, before));
}

/// Corner k of a cell with patches.
std::array<double, 2> GetCorner(PatchKind kind, std::size_t k)
{
  constexpr double ofQuad[4][2] = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } };
  constexpr double ofSimplex[3][2] = { { 0., 0. }, { 1., 0. }, { 0., 1. } };
  const double* at = kind == PatchKind::Quad ? ofQuad[k] : ofSimplex[k];
  return { { at[0], at[1] } };
}
/// A place of the cell by its coordinates along the axes of a part.
std::array<double, 2> TakePlace(const PatchFrame& frame, double x, double y)
{
  std::array<double, 2> at = frame[0];
  for (int c = 0; c < 2; ++c)
  {
    at[c] += x * (frame[1][c] - frame[0][c]) + y * (frame[2][c] - frame[0][c]);
  }
  return at;
}

constexpr double Equal = 1e-12;    ///< scores of places of which the first counts
constexpr double Resolved = 1e-14; ///< to which the score of a place is found

}

const LimitPatches::Shape& LimitPatches::GetShape(PatchKind kind)
{
  static const std::array<Shape, 3> shapes{ { Shape(PatchShape::Curve), Shape(PatchShape::Triangle),
    Shape(PatchShape::Quad) } };
  return shapes[static_cast<std::size_t>(kind)];
}

/// For one point: the places found so far, and the patches to split before more can be said.
struct LimitPatches::Search
{
  explicit Search(const Vector& point)
    : Of(point)
  {
  }
  void Take(const NearestPlace& place, double score)
  {
    const double tolerance = this->Of.GetTolerance(this->Least, Equal);
    if (this->Place.Cell < 0 || score < this->Least - tolerance ||
      (score <= this->Least + tolerance && place.Cell < this->Place.Cell))
    {
      this->Place = place;
    }
    this->Least = std::min(this->Least, score);
  }
  /// The place, and places in other cells that may be nearer still.
  std::vector<NearestPlace> ListPlaces()
  {
    std::vector<NearestPlace> places{ this->Place };
    const double most = this->Least - this->Of.GetTolerance(this->Least, Equal);
    std::stable_sort(this->Others.begin(), this->Others.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [lower, place] : this->Others)
    {
      const bool isListed = std::any_of(places.begin(), places.end(),
        [&place = place](const NearestPlace& listed) { return listed.Cell == place.Cell; });
      if (lower < most && !isListed && places.size() < MostPlaces)
      {
        places.push_back(place);
      }
    }
    return places;
  }
  double GetMost() const { return this->Least + this->Of.GetTolerance(this->Least, Equal); }

  const PlaceScore Of;
  NearestPlace Place;
  double Least = Infinity;
  std::vector<std::pair<double, vtkIdType>> Requests;  ///< with the score that they may have
  std::vector<std::pair<double, NearestPlace>> Others; ///< likewise, in patches that are not split
};

LimitPatches::LimitPatches(const SearchedCells& cells, const EvaluatePlaces& evaluate)
  : Cells(cells)
  , Evaluate(evaluate)
{
  this->MakeRoots();
  this->SortRoots();
}

PatchKind LimitPatches::GetKind(vtkIdType cell) const
{
  return this->Cells.Dimensions[cell] < 2 ? PatchKind::Line
    : this->Cells.IsQuad(cell)            ? PatchKind::Quad
                                          : PatchKind::Triangle;
}

NearestPlace LimitPatches::MakePlace(vtkIdType cell, const std::array<double, 2>& at) const
{
  NearestPlace place;
  place.Cell = cell;
  place.Weights = this->Cells.IsQuad(cell)
    ? std::array<double, 4>{ { at[0], at[1], 0., 0. } }
    : std::array<double, 4>{ { std::max(0., 1. - at[0] - at[1]), at[0], at[1], 0. } };
  return place;
}

Vector LimitPatches::Normalize(const Vector& x) const
{
  Vector made{};
  double most = 0.;
  for (int c = 0; c < 3; ++c)
  {
    made[c] = 0.25 * x[c] - 0.25 * this->Middle[c]; // does not overflow
    most = std::max(most, std::abs(made[c]));
  }
  const bool isFar = most > 0.25 * Farthest * this->Size;
  for (double& m : made)
  {
    m = isFar ? m / most * Farthest : 4. * m / this->Size;
  }
  return made;
}

Vector LimitPatches::Approach(const Vector& point) const
{
  Vector near = this->Normalize(point);
  if (std::max({ std::abs(near[0]), std::abs(near[1]), std::abs(near[2]) }) < 0.5 * Farthest)
  {
    return point;
  }
  for (int c = 0; c < 3; ++c)
  {
    near[c] = this->Middle[c] + this->Size * near[c];
  }
  return near;
}

/// The limits at the points of cells with patches; they tell how large all are.
std::vector<Vector> LimitPatches::FindCorners()
{
  std::vector<NearestPlace> asked(static_cast<std::size_t>(this->Cells.NumberOfPoints));
  vtkIdType start = 0;
  for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
  {
    const int corners = this->Cells.CountCorners(c);
    for (int k = 0; this->Cells.Dimensions[c] < 3 && k < corners; ++k)
    {
      NearestPlace& place = asked[this->Cells.Connectivity[start + k]];
      place = place.Cell < 0 ? this->MakePlace(c, GetCorner(this->GetKind(c), k)) : place;
    }
    start += corners;
  }
  std::vector<std::size_t> points;
  std::vector<NearestPlace> places;
  for (const std::size_t i : InTurn(asked.size()))
  {
    if (asked[i].Cell >= 0)
    {
      points.push_back(i);
      places.push_back(asked[i]);
    }
  }
  const PlaceValues values = this->Evaluate(places, true);
  std::vector<Vector> corners(asked.size());
  Box all;
  for (const std::size_t i : InTurn(points.size()))
  {
    corners[points[i]] = values[i][PlaceParts::Value];
    IsFinite(corners[points[i]]) ? all.Add(corners[points[i]].data()) : void();
  }
  if (all.Low[0] <= all.High[0])
  {
    Vector diagonal{};
    double largest = 0.;
    for (int c = 0; c < 3; ++c)
    {
      largest = std::max({ largest, std::abs(all.Low[c]), std::abs(all.High[c]) });
      this->Middle[c] = 0.5 * all.Low[c] + 0.5 * all.High[c];
      diagonal[c] = all.High[c] - all.Low[c];
    }
    const double rounding = Rounding * largest;
    this->Size = std::max(Measure(diagonal), rounding);
    this->Size = this->Size > 0. ? this->Size : 1.;
    this->Enough = std::max(this->Enough, rounding / this->Size);
  }
  return corners;
}

/// One patch for each cell, which is not known yet. The limit over a cell is not farther away from
/// the limits at its corners, and at the corners of its neighbours, than these are from each other.
void LimitPatches::MakeRoots()
{
  const std::vector<Vector> corners = this->FindCorners();
  vtkIdType start = 0;
  std::vector<vtkIdType> starts;
  for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
  {
    starts.push_back(start);
    start += this->Cells.CountCorners(c);
  }
  std::vector<Box> around(corners.size()); // the corners of all cells at a point
  const auto forCorners = [&](vtkIdType c, const auto& act)
  {
    for (int k = 0; k < this->Cells.CountCorners(c); ++k)
    {
      act(this->Cells.Connectivity[starts[c] + k]);
    }
  };
  for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
  {
    Patch patch;
    patch.Cell = c;
    Box own;
    forCorners(c,
      [&](vtkIdType point)
      {
        if (this->Cells.Dimensions[c] < 3)
        {
          patch.Corners.push_back(this->Normalize(corners[point]));
          own.Add(patch.Corners.back().data());
        }
      });
    forCorners(c, [&](vtkIdType point) { around[point].Add(own); });
    patch.IsKnown = patch.IsFinal = this->Cells.Dimensions[c] == 0;
    this->Patches.push_back(patch);
  }
  for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
  {
    Box& box = this->Patches[c].Bounds;
    if (this->Cells.Dimensions[c] == 0)
    {
      box.Add(this->Patches[c].Corners[0].data());
      continue;
    }
    forCorners(c, [&](vtkIdType point) { box.Add(around[point]); });
    const double size =
      std::hypot(box.High[0] - box.Low[0], box.High[1] - box.Low[1], box.High[2] - box.Low[2]);
    for (int k = 0; k < 3; ++k)
    {
      box.Low[k] -= 0.5 * size;
      box.High[k] += 0.5 * size;
    }
  }
}

/// Of cells with patches.
void LimitPatches::SortRoots()
{
  std::vector<vtkIdType> cells;
  Box all;
  for (const vtkIdType c : InTurn(this->Cells.GetNumberOfCells()))
  {
    if (this->Cells.Dimensions[c] < 3)
    {
      cells.push_back(c);
      all.Add(this->Patches[c].Bounds);
    }
  }
  this->Order = SortAlongCurve(static_cast<vtkIdType>(cells.size()), all,
    [&](vtkIdType i, double* x)
    {
      const Box& box = this->Patches[cells[i]].Bounds;
      for (int c = 0; c < 3; ++c)
      {
        x[c] = 0.5 * (box.Low[c] + box.High[c]);
      }
    });
  ForEach(this->Order.size(), [&](vtkIdType i) { this->Order[i] = cells[this->Order[i]]; });
  for (vtkIdType below = this->Order.size(); this->Levels.empty() || below > 1;)
  {
    Buffer<Box> boxes((below + Width - 1) / Width, Box());
    for (const vtkIdType i : InTurn(below))
    {
      boxes[i / Width].Add(
        this->Levels.empty() ? this->Patches[this->Order[i]].Bounds : this->Levels.back()[i]);
    }
    below = boxes.size();
    this->Levels.push_back(std::move(boxes));
  }
}

void LimitPatches::Fit(Patch& patch) const
{
  const PatchShape& shape = GetShape(this->GetKind(patch.Cell)).Of;
  patch.Factors.assign(shape.Nodes.size(), Vector{});
  patch.Bounds = Box();
  bool isFinite = true;
  for (std::size_t k = 0; k < shape.Nodes.size(); ++k)
  {
    for (std::size_t node = 0; node < shape.Nodes.size(); ++node)
    {
      for (int c = 0; c < 3; ++c)
      {
        patch.Factors[k][c] += shape.Weights[k][node] * patch.Nodes[node][c];
      }
    }
    isFinite = isFinite && IsFinite(patch.Factors[k]);
    patch.Bounds.Add(patch.Factors[k].data());
  }
  for (int c = 0; c < 3; ++c)
  {
    patch.Bounds.Low[c] -= patch.Margin;
    patch.Bounds.High[c] += patch.Margin;
  }
  patch.Bounds = isFinite ? patch.Bounds : Box(); // no place of it is near to any point
}

/// Finds out how good a polynomial is, and splits the patch if that is not enough. `values`: at the
/// finer lattice.
void LimitPatches::TakeValues(vtkIdType number, const Lattice& values)
{
  const Shape& shape = GetShape(this->GetKind(this->Patches[number].Cell));
  const auto at = [&](int i, int j) { return values[PatchSide * j + i]; };
  Patch& patch = this->Patches[number];
  if (!patch.IsKnown)
  {
    patch.IsKnown = true;
    for (const FrameNode& node : shape.Of.Nodes)
    {
      patch.Nodes.push_back(at(2 * node[0], 2 * node[1]));
    }
  }
  double error = 0.;
  for (std::size_t i = 0; i < shape.Of.Checked.size(); ++i)
  {
    Vector difference = at(shape.Of.Checked[i][0], shape.Of.Checked[i][1]);
    for (std::size_t node = 0; node < patch.Nodes.size(); ++node)
    {
      for (int c = 0; c < 3; ++c)
      {
        difference[c] -= shape.Of.CheckWeights[i][node] * patch.Nodes[node][c];
      }
    }
    error = std::max(error, Measure(difference));
  }
  patch.Margin = error;
  this->Fit(patch);
  patch.IsFinal = error <= this->Enough || patch.Splits == MostSplits;
  if (patch.IsFinal || !std::isfinite(error))
  {
    patch.IsFinal = true;
    return;
  }
  this->AddChildren(number, values);
}

void LimitPatches::AddChildren(vtkIdType number, const Lattice& values)
{
  const Shape& shape = GetShape(this->GetKind(this->Patches[number].Cell));
  const double error = this->Patches[number].Margin;
  const auto first = static_cast<vtkIdType>(this->Patches.size());
  for (const LatticePart& part : shape.Of.Children)
  {
    Patch child;
    child.Cell = this->Patches[number].Cell;
    child.Splits = this->Patches[number].Splits + 1;
    child.Margin = error;
    child.IsKnown = true;
    const PatchFrame& frame = this->Patches[number].Frame;
    const auto place = [&](const FrameNode& point) // on the lattice of two divisions
    { return TakePlace(frame, 0.5 * point[0], 0.5 * point[1]); };
    const FrameNode& origin = part.Origin;
    const auto end = [&](int axis)
    { return FrameNode{ { origin[0] + part.Axes[axis][0], origin[1] + part.Axes[axis][1], 0 } }; };
    child.Frame = { { place(origin), place(end(0)), place(end(1)) } };
    for (const FrameNode& node : shape.Of.Nodes)
    {
      const int i = 4 * origin[0] + node[0] * part.Axes[0][0] + node[1] * part.Axes[1][0];
      const int j = 4 * origin[1] + node[0] * part.Axes[0][1] + node[1] * part.Axes[1][1];
      child.Nodes.push_back(values[PatchSide * j + i]);
    }
    this->Fit(child);
    this->Patches.push_back(std::move(child));
  }
  this->Patches[number].Children = first;
}

void LimitPatches::Split(const std::vector<vtkIdType>& patches)
{
  for (std::size_t begin = 0; begin < patches.size(); begin += SplitAtATime)
  {
    const std::size_t end = std::min(patches.size(), begin + SplitAtATime);
    std::vector<NearestPlace> places;
    for (std::size_t p = begin; p < end; ++p)
    {
      const Patch& patch = this->Patches[patches[p]];
      const PatchFrame& frame = patch.Frame;
      for (const auto& [i, j] : GetShape(this->GetKind(patch.Cell)).Places)
      {
        constexpr double side = 1. / Shape::Divisions;
        places.push_back(this->MakePlace(patch.Cell, TakePlace(frame, side * i, side * j)));
      }
    }
    const PlaceValues found = this->Evaluate(places, true);
    auto value = found.begin();
    for (std::size_t p = begin; p < end; ++p)
    {
      Lattice values{};
      for (const auto& [i, j] : GetShape(this->GetKind(this->Patches[patches[p]].Cell)).Places)
      {
        values[PatchSide * j + i] = this->Normalize((*value++)[PlaceParts::Value]);
      }
      this->TakeValues(patches[p], values);
    }
  }
}

void LimitPatches::VisitPatch(vtkIdType number, Search& search) const
{
  const Patch& patch = this->Patches[number];
  const PlaceScore& score = search.Of;
  const double bound = score.Bound(patch.Bounds);
  if (!(bound < search.GetMost()))
  {
    return;
  }
  const PatchKind kind = this->GetKind(patch.Cell);
  const Shape& shape = GetShape(kind);
  if (patch.Children >= 0)
  {
    for (std::size_t c = 0; c < shape.Of.Children.size(); ++c)
    {
      this->VisitPatch(patch.Children + static_cast<vtkIdType>(c), search);
    }
    return;
  }
  if (!patch.IsKnown || this->Cells.Dimensions[patch.Cell] == 0)
  {
    for (std::size_t k = 0; k < patch.Corners.size(); ++k)
    {
      search.Take(this->MakePlace(patch.Cell, GetCorner(kind, k)), score.Of(patch.Corners[k]));
    }
    patch.IsKnown ? void() : void(search.Requests.emplace_back(bound, number));
    return;
  }
  PatchFactors factors{};
  double largest = 0.;
  for (const Shape::Product& product : shape.Products)
  {
    const double factor =
      score.Multiply(patch.Factors[product.First], patch.Factors[product.Second]);
    factors[product.Factor] += product.Weight * factor;
    largest = std::max(largest, std::abs(factor));
  }
  const double tolerance =
    std::max(score.GetTolerance(std::min(search.Least, largest), Resolved), 4e-16 * largest);
  PatchMinimum least{ score.Lower(search.GetMost(), -patch.Margin), {} };
  if (LowerToPatch(kind, 2 * shape.Degree, factors, patch.Frame, tolerance, least))
  {
    const NearestPlace place = this->MakePlace(patch.Cell, least.At);
    const double lower = score.Lower(least.Value, patch.Margin);
    search.Take(place, score.Lower(least.Value, -patch.Margin));
    patch.IsFinal ? void(search.Others.emplace_back(lower, place))
                  : void(search.Requests.emplace_back(lower, number));
  }
}

void LimitPatches::Visit(std::size_t level, vtkIdType node, Search& search) const
{
  const vtkIdType below = level == 0 ? this->Order.size() : this->Levels[level - 1].size();
  std::array<std::pair<double, vtkIdType>, Width> children;
  int size = 0;
  for (vtkIdType i = Width * node; i < std::min(below, Width * (node + 1)); ++i)
  {
    const Box& box = level == 0 ? this->Patches[this->Order[i]].Bounds : this->Levels[level - 1][i];
    children[size++] = { search.Of.Bound(box), i };
  }
  std::sort(children.begin(), children.begin() + size);
  for (int i = 0; i < size && children[i].first < search.GetMost(); ++i)
  {
    level == 0 ? this->VisitPatch(this->Order[children[i].second], search)
               : this->Visit(level - 1, children[i].second, search);
  }
}

std::vector<std::vector<NearestPlace>> LimitPatches::Find(const std::vector<Vector>& points)
{
  std::vector<std::vector<NearestPlace>> found(points.size());
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < points.size() && this->Order.size() > 0; ++i)
  {
    IsFinite(points[i]) ? left.push_back(i) : void();
  }
  std::vector<std::size_t> asked(points.size(), 0);
  while (!left.empty())
  {
    std::vector<std::vector<vtkIdType>> requests(left.size());
    ForUnevenRanges(static_cast<vtkIdType>(left.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          Search search(this->Normalize(points[left[i]]));
          this->Visit(this->Levels.size() - 1, 0, search);
          found[left[i]] = search.ListPlaces();
          std::sort(search.Requests.begin(), search.Requests.end());
          for (const auto& [bound, patch] : search.Requests)
          {
            if (bound < search.Least && requests[i].size() < CountRequests(asked[left[i]]))
            {
              requests[i].push_back(patch);
            }
          }
        }
      });
    std::vector<vtkIdType> patches;
    std::vector<std::size_t> unfinished;
    for (const std::size_t i : InTurn(left.size()))
    {
      patches.insert(patches.end(), requests[i].begin(), requests[i].end());
      asked[left[i]] += requests[i].size();
      requests[i].empty() ? void() : unfinished.push_back(left[i]);
    }
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    this->Split(patches);
    left = std::move(unfinished);
  }
  return found;
}

}
