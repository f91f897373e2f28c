// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/Deviations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A bound that is known, or infinity.
double Known(double bound)
{
  return bound < Infinity ? bound : Infinity; // also if it is not a number
}

double GetNorm(const double* vector, int components)
{
  double squares = 0.;
  for (int c = 0; c < components; ++c)
  {
    squares += vector[c] * vector[c];
  }
  return std::sqrt(squares);
}

/// Values at the points after a step: those before, and means of them.
Buffer<double> MakeMiddles(
  const NestedPieces& pieces, int step, int components, const Buffer<double>& values)
{
  const vtkIdType before = pieces.GetNumberOfPoints(step - 1);
  Buffer<double> middles(components * pieces.GetNumberOfPoints(step), 0.);
  CopyInThreads(values.data(), components * before, middles.data());
  ForEach(pieces.GetNumberOfPoints(step) - before,
    [&](vtkIdType i)
    {
      const vtkIdType* parents = pieces.GetParents(step, before + i);
      double* to = middles.data() + components * (before + i);
      int count = 0;
      while (count < NestedPieces::MostCorners && parents[count] >= 0)
      {
        for (int c = 0; c < components; ++c)
        {
          to[c] += values[components * parents[count] + c];
        }
        ++count;
      }
      for (int c = 0; c < components && count > 0; ++c)
      {
        to[c] /= count;
      }
    });
  return middles;
}

}

VectorRange::VectorRange(int components)
  : Components(components)
  , Values(2 * static_cast<std::size_t>(components) + 1)
{
}

void VectorRange::Clear()
{
  std::fill_n(this->Values.begin(), this->Components, Infinity);
  std::fill_n(this->Values.begin() + this->Components, this->Components, -Infinity);
  this->Values.back() = 0.;
}

void VectorRange::Add(const double* range)
{
  for (int c = 0; c < this->Components; ++c)
  {
    double& least = this->Values[c];
    double& largest = this->Values[this->Components + c];
    least = std::min(least, range[c]);
    largest = std::max(largest, range[this->Components + c]);
  }
  this->Values.back() = std::max(this->Values.back(), range[2 * this->Components]);
}

void VectorRange::AddZero()
{
  for (int c = 0; c < this->Components; ++c)
  {
    this->Values[c] = std::min(0., this->Values[c]);
    this->Values[this->Components + c] = std::max(0., this->Values[this->Components + c]);
  }
}

Deviations::Deviations(const NestedPieces& pieces, int components)
  : Pieces(pieces)
  , Components(components)
  , Stride(2 * components + 1)
  , Values(Stride * pieces.GetNumberOfPoints(NestedPieces::Steps))
{
  ForEach(pieces.GetNumberOfPoints(NestedPieces::Steps),
    [this](vtkIdType i)
    {
      double* range = this->Values.data() + this->Stride * i;
      std::fill_n(range, this->Components, Infinity);
      std::fill_n(range + this->Components, this->Components, -Infinity);
      range[2 * this->Components] = 0.;
    });
}

void Deviations::Add(vtkIdType point, const double* vector)
{
  double* range = this->Values.data() + this->Stride * point;
  for (int c = 0; c < this->Components; ++c)
  {
    double& least = range[c];
    double& largest = range[this->Components + c];
    const bool isKnown = std::isfinite(vector[c]);
    least = isKnown ? std::min(least, vector[c]) : -Infinity;
    largest = isKnown ? std::max(largest, vector[c]) : Infinity;
  }
  double& norm = range[2 * this->Components];
  norm = std::max(norm, Known(GetNorm(vector, this->Components)));
}

void Deviations::Spread(int layers)
{
  for (int layer = 0; layer < layers; ++layer)
  {
    this->SpreadOnce();
  }
}

void Deviations::SpreadOnce()
{
  Buffer<double> spread(this->Values.size());
  CopyInThreads(this->Values.data(), this->Values.size(), spread.data());
  VectorRange range(this->Components);
  ForEachInTurn(this->Pieces.GetNumberOfPieces(),
    [&](vtkIdType p)
    {
      const vtkIdType* corners = this->Pieces.GetPiece(p);
      range.Clear();
      for (int k = 0; k < NestedPieces::MostCorners && corners[k] >= 0; ++k)
      {
        range.Add(this->Get(corners[k]));
      }
      for (int k = 0; k < NestedPieces::MostCorners && corners[k] >= 0; ++k)
      {
        double* to = spread.data() + this->Stride * corners[k];
        for (int c = 0; c < this->Components; ++c)
        {
          to[c] = std::min(to[c], range.GetLeast(c));
          to[this->Components + c] = std::max(to[this->Components + c], range.GetLargest(c));
        }
        to[2 * this->Components] = std::max(to[2 * this->Components], range.GetNorm());
      }
    });
  this->Values = std::move(spread);
}

namespace
{

/// By how much a step moves the points away from linear values; 0 where no cell has a point.
Buffer<double> FindMoves(const NestedPieces& pieces, int step, int components,
  Buffer<double>&& stepped, const Buffer<double>& middles)
{
  const vtkIdType before = pieces.GetNumberOfPoints(step - 1);
  ForEach(pieces.GetNumberOfPoints(step),
    [&](vtkIdType i)
    {
      const bool isUsed = i < before || pieces.GetParents(step, i)[0] >= 0;
      for (vtkIdType k = components * i; k < components * (i + 1); ++k)
      {
        stepped[k] = isUsed ? stepped[k] - middles[k] : 0.;
      }
    });
  return std::move(stepped);
}

/// The limit over a piece reads the points of the pieces at it; with solids, whose edges have rings
/// beyond these, one layer more.
Deviations SpreadMoves(const NestedPieces& pieces, int components, const Buffer<double>& moves)
{
  Deviations deviations(pieces, components);
  ForEach(pieces.GetNumberOfPoints(NestedPieces::Steps),
    [&](vtkIdType i) { deviations.Add(i, moves.data() + components * i); });
  deviations.Spread(pieces.HasTets() ? 2 : 1);
  return deviations;
}

/// What all steps after step 3 together add to bilinear pieces: what a row makes of them after m
/// steps is h a + h^2 b with h = 2^-m, where a and b follow from two steps (Mathematics 14).
Deviations FindTailOfQuads(const NestedPieces& pieces, int components, const Buffer<double>& first,
  const Buffer<double>& second)
{
  Deviations tail(pieces, components);
  const vtkIdType old = pieces.GetNumberOfPoints(1);
  const vtkIdType before = pieces.GetNumberOfPoints(2);
  ForRanges(pieces.GetNumberOfPoints(3),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> vector(static_cast<std::size_t>(components));
      // Of a row that makes `one` at h = 1 and `half` at h = 1/2.
      const auto add = [&](vtkIdType point, const double* one, double factor, const double* half)
      {
        for (int c = 0; c < components; ++c)
        {
          vector[c] = 0.5 * factor * one[c];
        }
        tail.Add(point, vector.data());
        for (int c = 0; c < components; ++c)
        {
          vector[c] = 0.5 * (4. * half[c] - factor * one[c]);
        }
        tail.Add(point, vector.data());
      };
      for (vtkIdType i = begin; i < end; ++i)
      {
        std::fill(vector.begin(), vector.end(), 0.);
        tail.Add(i, vector.data());
        const double* half = second.data() + components * i;
        if (i < old)
        {
          add(i, first.data() + components * i, 1., half);
        }
        const vtkIdType* parents = i < before ? nullptr : pieces.GetParents(3, i);
        if (parents && parents[0] >= 0 && parents[0] < old && parents[2] < 0)
        {
          // The half of an edge. Its rule may be another one than that of the whole edge; then it
          // is that of the edge's middle, at h = 1/2.
          add(i, first.data() + components * parents[1], 1., half);
          add(i, second.data() + components * parents[1], 2., half);
        }
      }
    });
  tail.Spread(2); // both halves of an edge
  return tail;
}

/// The bound of a piece: on |x + a + b| where x is the difference at a corner, a is in the range of
/// what steps 2 and 3 add, and b in that of all later steps, or `further` out of it.
double BoundPiece(int components, const double* differences, int corners, const VectorRange& steps,
  const VectorRange& tail, double further)
{
  double byNorms = 0.;
  double byComponents = 0.;
  for (int k = 0; k < corners; ++k)
  {
    const double* x = differences + components * k;
    byNorms = std::max(byNorms, Known(GetNorm(x, components)));
    double squares = 0.;
    for (int c = 0; c < components; ++c)
    {
      const double least = x[c] + steps.GetLeast(c) + tail.GetLeast(c);
      const double largest = x[c] + steps.GetLargest(c) + tail.GetLargest(c);
      const double most = std::max(Known(std::abs(least)), Known(std::abs(largest)));
      squares += most * most;
    }
    byComponents = std::max(byComponents, Known(std::sqrt(squares)));
  }
  byNorms += steps.GetNorm() + tail.GetNorm();
  return std::min(Known(byNorms), Known(byComponents)) + further;
}

}

void FindBounds(const NestedPieces& pieces, const BoundedValues& values, double* bounds)
{
  const int components = values.Components;
  const Buffer<double> middles = MakeMiddles(pieces, 2, components, values.Next);
  const Buffer<double> linear = MakeMiddles(pieces, 3, components, middles);
  const Buffer<double> kinks = FindMoves(pieces, 3, components, values.Step(3, middles), linear);
  Buffer<double> stepped = values.Step(2, values.Next);
  const Deviations steps = SpreadMoves(
    pieces, components, FindMoves(pieces, 3, components, values.Step(3, stepped), linear));
  const Deviations tail = pieces.HasQuads()
    ? FindTailOfQuads(
        pieces, components, FindMoves(pieces, 2, components, std::move(stepped), middles), kinks)
    : SpreadMoves(pieces, components, kinks);
  // Rows of vertices in faces between solids, which step 3 does not have, may make a little more of
  // the kink there than rows of edges.
  const double further = pieces.HasTets() ? 0.25 : 0.;
  ForRanges(pieces.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      VectorRange ofSteps(components);
      VectorRange ofTail(components);
      std::vector<double> differences(
        static_cast<std::size_t>(components) * NestedPieces::MostCorners);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const int corners = pieces.GetNumberOfCorners(cell);
        double bound = 0.;
        for (vtkIdType p = pieces.GetFirst(cell); p < pieces.GetFirst(cell + 1); ++p)
        {
          const vtkIdType* piece = pieces.GetPiece(p);
          ofSteps.Clear();
          ofTail.Clear();
          for (int k = 0; k < corners; ++k)
          {
            ofSteps.Add(steps.Get(piece[k]));
            ofTail.Add(tail.Get(piece[k]));
            const NestedPieces::Weights& weights = pieces.GetWeights(cell, p, k);
            for (int c = 0; c < components; ++c)
            {
              double shown = 0.;
              for (int corner = 0; corner < corners; ++corner)
              {
                shown +=
                  weights[corner] * values.Shown[components * pieces.GetCorner(cell, corner) + c];
              }
              differences[components * k + c] = linear[components * piece[k] + c] - shown;
            }
          }
          ofTail.AddZero();
          bound = std::max(bound,
            BoundPiece(components, differences.data(), corners, ofSteps, ofTail,
              further * ofTail.GetNorm()));
        }
        bounds[cell] = bound + values.Rounding;
      }
    });
}

}
