// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/NearestStarts.h"

#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Surfaces/Places/QuadParts.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace subdivision
{

std::array<double, 4> LeavePartOfSimplex(
  int dimension, int levels, vtkIdType part, std::array<double, 4> weights)
{
  const auto& children = ListChildren(dimension);
  for (int step = 0; dimension > 0 && step < levels; ++step)
  {
    const auto count = static_cast<vtkIdType>(children.size());
    const std::array<int, 4>& corners = children[static_cast<std::size_t>(part % count)].Corners;
    part /= count;
    std::array<double, 4> of{};
    for (int i = 0; i <= dimension; ++i)
    {
      const int* ends =
        corners[i] > dimension ? GetEdgeEnds(dimension, corners[i] - dimension - 1) : nullptr;
      of[ends ? ends[0] : corners[i]] += 0.5 * weights[i];
      of[ends ? ends[1] : corners[i]] += 0.5 * weights[i];
    }
    weights = of;
  }
  return weights;
}

namespace
{

/// The same in a quad, whose parts have the numbers of its corners.
std::array<double, 4> LeavePartOfQuad(int levels, vtkIdType part, std::array<double, 2> at)
{
  for (int step = 0; step < levels; ++step)
  {
    at = LeaveCornerOfQuad(static_cast<int>(part % 4), at);
    part /= 4;
  }
  return { { at[0], at[1], 0., 0. } };
}

/// Sets the place in a cell of a place in a flat piece, moved a part of the way to the middle of
/// the piece. `part`: the number of the piece in its cell.
void SetPlace(const SearchedCells& cells, vtkIdType part, int levels, int half,
  const double ofPiece[4], double inside, NearestPlace& start)
{
  const int dimension = cells.Dimensions[start.Cell];
  if (cells.IsQuad(start.Cell))
  {
    const double both = ofPiece[1] + ofPiece[2];
    std::array<double, 2> at{ { half == 0 ? both : ofPiece[1], half == 0 ? ofPiece[2] : both } };
    for (double& x : at)
    {
      x += inside * (0.5 - x);
    }
    start.Weights = LeavePartOfQuad(levels, part, at);
    return;
  }
  std::array<double, 4> weights{};
  for (int i = 0; i < 4; ++i) // corners that are repeated are the last one
  {
    weights[std::min(i, dimension)] += ofPiece[i];
  }
  for (int i = 0; i <= dimension; ++i)
  {
    weights[i] += inside * (1. / (dimension + 1) - weights[i]);
  }
  start.Weights = LeavePartOfSimplex(dimension, levels, part, weights);
}

}

NearestStarts::NearestStarts(const SearchedCells& cells, vtkDataSet* fine, int levels)
  : Cells(cells)
  , Levels(levels)
  , Firsts(cells.GetNumberOfCells() + 1)
  , Points(3 * fine->GetNumberOfPoints())
{
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c) { this->Firsts[c] = vtkIdType(1) << (levels * cells.Dimensions[c]); });
  CountsToOffsets(this->Firsts);
  ForEachInTurn(fine->GetNumberOfPoints(),
    [&](vtkIdType i) { fine->GetPoint(i, this->Points.data() + 3 * i); });
  std::vector<int> corners[2];
  vtkNew<vtkIdList> ids;
  ForEachInTurn(fine->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      fine->GetCellPoints(c, ids);
      const auto add = [&](int kind, int half, std::initializer_list<vtkIdType> of)
      {
        for (const vtkIdType k : of)
        {
          corners[kind].push_back(
            static_cast<int>(ids->GetId(std::min(k, ids->GetNumberOfIds() - 1))));
        }
        this->Kinds[kind].Numbers.push_back({ c, half });
      };
      if (fine->GetCellType(c) == VTK_TETRA)
      {
        add(0, 0, { 0, 1, 2, 3 });
        return;
      }
      add(1, 0, { 0, 1, 2 });
      if (ids->GetNumberOfIds() == 4)
      {
        add(1, 1, { 0, 2, 3 });
      }
    });
  for (int kind = 0; kind < 2; ++kind)
  {
    Pieces& pieces = this->Kinds[kind];
    const int width = kind == 0 ? 4 : 3;
    pieces.Corners = Buffer<int>(static_cast<vtkIdType>(corners[kind].size()));
    std::copy(corners[kind].begin(), corners[kind].end(), pieces.Corners.begin());
    if (!pieces.Numbers.empty())
    {
      pieces.Tree = SimplexTree(this->Points.data(), width, pieces.Corners);
    }
  }
  const Buffer<int>& triangles = this->Kinds[1].Corners;
  this->AtPoints = ListByRow<vtkIdType>(
    fine->GetNumberOfPoints(), triangles.size(), [&](vtkIdType i) { return triangles[i]; },
    [](vtkIdType i) { return i / 3; });
}

vtkIdType NearestStarts::FindCell(const Found& found) const
{
  const vtkIdType number = found.Of->Numbers[found.Place.Simplex].Number;
  return std::upper_bound(this->Firsts.begin(), this->Firsts.end(), number) - this->Firsts.begin() -
    1;
}

/// The length of the longer edge at the first corner of a triangle.
double NearestStarts::FindSize(const Found& found) const
{
  const int* corners = found.Of->Tree.GetCorners(found.Place.Simplex);
  double most = 0.;
  for (int i = 1; i < 3; ++i)
  {
    const double* a = this->Points.data() + 3 * vtkIdType(corners[0]);
    const double* b = this->Points.data() + 3 * vtkIdType(corners[i]);
    most = std::max(most, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  return most;
}

/// Near the nearest place of a flat piece, but inside of the piece.
NearestPlace NearestStarts::MakeStart(const Found& found) const
{
  const Piece& piece = found.Of->Numbers[found.Place.Simplex];
  NearestPlace start;
  start.Cell = this->FindCell(found);
  SetPlace(this->Cells, piece.Number - this->Firsts[start.Cell], this->Levels, piece.Half,
    found.Place.Weights, 0.1, start);
  return start;
}

void NearestStarts::Find(const std::array<double, 3>& x, std::vector<NearestPlace>& starts) const
{
  if (!std::isfinite(x[0] + x[1] + x[2]))
  {
    return;
  }
  Found nearest;
  nearest.Distance2 = std::numeric_limits<double>::infinity();
  for (const Pieces& pieces : this->Kinds)
  {
    Found found;
    found.Of = &pieces;
    if (!pieces.Numbers.empty() &&
      pieces.Tree.FindNearest(x.data(), found.Place, found.Distance2) &&
      found.Distance2 < nearest.Distance2)
    {
      nearest = found;
    }
  }
  if (!nearest.Of)
  {
    return;
  }
  starts.push_back(this->MakeStart(nearest));
  const Pieces& triangles = this->Kinds[1];
  if (nearest.Of != &triangles)
  {
    return; // in solids places cost far more, and most points are their own places
  }
  // How far the limit may be from a flat piece, at a guess, is half of its size.
  const double most = std::sqrt(nearest.Distance2) + 0.5 * this->FindSize(nearest);
  std::vector<std::pair<vtkIdType, Found>> others; // of each cell the nearest one
  const int* corners = triangles.Tree.GetCorners(nearest.Place.Simplex);
  for (int i = 0; i < 3; ++i)
  {
    for (const vtkIdType piece : this->AtPoints[corners[i]])
    {
      Found found;
      found.Of = &triangles;
      found.Place.Simplex = piece;
      const vtkIdType cell = this->FindCell(found);
      if (cell == starts.front().Cell)
      {
        continue;
      }
      found.Distance2 = triangles.Tree.FindNearestIn(piece, x.data(), found.Place);
      const auto same = std::find_if(
        others.begin(), others.end(), [cell](const auto& other) { return other.first == cell; });
      if (same != others.end())
      {
        same->second = found.Distance2 < same->second.Distance2 ? found : same->second;
      }
      else if (std::sqrt(found.Distance2) <= most)
      {
        others.emplace_back(cell, found);
      }
    }
  }
  this->AddAtCorner(nearest, x, starts);
  for (const auto& other : others)
  {
    starts.push_back(this->MakeStart(other.second));
    this->AddAtCorner(other.second, x, starts);
  }
}

/// If a flat piece is at a corner of its cell where pieces are not nearly in one plane, adds places
/// in the cell in several directions from the corner, as far away as x and at other distances. The
/// surface may be like the tip of a needle there, so that a cell has several places that are nearer
/// than all around them, however small its pieces are.
void NearestStarts::AddAtCorner(
  const Found& found, const std::array<double, 3>& x, std::vector<NearestPlace>& starts) const
{
  const Piece& piece = found.Of->Numbers[found.Place.Simplex];
  NearestPlace start;
  start.Cell = this->FindCell(found);
  const int* corners = found.Of->Tree.GetCorners(found.Place.Simplex);
  const double size = this->FindSize(found) * static_cast<double>(1 << this->Levels);
  const bool isQuad = this->Cells.IsQuad(start.Cell);
  for (int i = 0; i < 3 && this->Cells.Dimensions[start.Cell] == 2; ++i)
  {
    double ofPiece[4] = {};
    ofPiece[i] = 1.;
    SetPlace(this->Cells, piece.Number - this->Firsts[start.Cell], this->Levels, piece.Half,
      ofPiece, 0., start);
    const auto& at = start.Weights;
    if (!std::all_of(at.begin(), at.end(), [](double w) { return w == 0. || w == 1.; }) ||
      this->IsFlat(corners[i]))
    {
      continue;
    }
    const double* corner = this->Points.data() + 3 * vtkIdType(corners[i]);
    const double distance = std::hypot(x[0] - corner[0], x[1] - corner[1], x[2] - corner[2]);
    for (const double share : { 0.15, 0.5, 0.85 })
    {
      for (const double part : { std::min(0.5, distance / size), 0.2, 0.04 })
      {
        NearestPlace beside = start;
        if (isQuad)
        {
          beside.Weights[0] += part * share * (1. - 2. * at[0]);
          beside.Weights[1] += part * (1. - share) * (1. - 2. * at[1]);
        }
        else
        {
          const auto own = std::max_element(at.begin(), at.begin() + 3) - at.begin();
          beside.Weights[own] -= part;
          beside.Weights[(own + 1) % 3] += part * share;
          beside.Weights[(own + 2) % 3] += part * (1. - share);
        }
        starts.push_back(beside);
      }
    }
  }
}

/// Whether the triangles at a point of the fine level are nearly in one plane.
bool NearestStarts::IsFlat(vtkIdType point) const
{
  constexpr double leastCosine = 0.9;
  const Pieces& triangles = this->Kinds[1];
  const auto getNormal = [&](vtkIdType triangle)
  {
    const int* ids = triangles.Corners.data() + 3 * triangle;
    double normal[3];
    vtkTriangle::ComputeNormal(this->Points.data() + 3 * vtkIdType(ids[0]),
      this->Points.data() + 3 * vtkIdType(ids[1]), this->Points.data() + 3 * vtkIdType(ids[2]),
      normal);
    return std::array<double, 3>{ { normal[0], normal[1], normal[2] } };
  };
  const Row<vtkIdType> at = this->AtPoints[point];
  const std::array<double, 3> first = getNormal(*at.begin());
  return std::all_of(at.begin(), at.end(),
    [&](vtkIdType triangle)
    {
      const std::array<double, 3> normal = getNormal(triangle);
      return std::abs(first[0] * normal[0] + first[1] * normal[1] + first[2] * normal[2]) >=
        leastCosine;
    });
}

}
