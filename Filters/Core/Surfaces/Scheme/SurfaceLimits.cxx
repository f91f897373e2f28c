// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SurfaceLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/Masks.h"
#include "Core/Rules/Pi.h"
#include "Core/Rules/SectorMasks.h"
#include "Core/Surfaces/Scheme/CurveTangents.h"
#include "Core/Surfaces/Scheme/PrimalRows.h"

#include <cmath>

namespace subdivision
{
template <typename Id>
LimitFinder<Id>::LimitFinder(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  const SurfaceScheme<Id>& scheme, bool modifiedBoundary, LoopWeights weights)
  : Level(level)
  , Mesh(level.Mesh)
  , Tags(tags)
  , Scheme(scheme)
  , ModifiedBoundary(modifiedBoundary)
  , Weights(weights)
  , Quads(!scheme.NeedsTriangles())
{
}

/// The mask of a smooth vertex of six triangles or four quads, in the order of rows.
template <typename Id>
template <int Arity, std::size_t N>
const std::array<double, N>& LimitFinder<Id>::GetRegularMask(LimitKind kind)
{
  static const auto masks = []
  {
    std::array<std::array<double, N>, 3> all;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const StarMask mask = MakeSmoothMask(
        static_cast<LimitKind>(i), (N - 1) / (Arity - 2), Arity == 4, LoopWeights::Warren);
      double* to = all[i].data();
      *to++ = mask.Own;
      for (std::size_t j = 0; j < mask.Edges.size(); ++j)
      {
        *to++ = mask.Edges[j];
        to = std::copy_n(mask.Faces.begin() + j, Arity - 3, to);
      }
    }
    return all;
  }();
  return masks[static_cast<std::size_t>(kind)];
}

template <typename Id>
template <int Arity>
void LimitFinder<Id>::AppendRowsOfNext(const SurfaceLevel<Id>& level,
  const IrregularRows<Id>& others, LoopWeights weights, LimitKind kind, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows)
{
  AppendPrimalLimitsOfNext<Arity>(
    level, GetRegularMask < Arity, Arity == 3 ? 7 : 9 > (kind),
    [&](Id vertex, const std::vector<FanStep<Id>>& steps, const auto& members)
    {
      const StarMask mask = MakeSmoothMask(kind, steps.size(), Arity == 4, weights);
      rows.Add(vertex, mask.Own);
      for (std::size_t j = 0; j < steps.size(); ++j)
      {
        Id ring[2];
        members(steps[j], ring);
        rows.Add(ring[0], mask.Edges[j]);
        if (Arity == 4)
        {
          rows.Add(ring[1], mask.Faces[j]);
        }
      }
    },
    others, kind, begin, end, rows);
}

template <typename Id>
template <int Arity>
const double* LimitFinder<Id>::GetSecondTangent(const double* first)
{
  constexpr std::size_t size = Arity == 3 ? 7 : 9;
  return first == GetRegularMask<Arity, size>(LimitKind::Tangent1).data()
    ? GetRegularMask<Arity, size>(LimitKind::Tangent2).data()
    : nullptr;
}

template <typename Id>
void LimitFinder<Id>::Append(Id vertex, LimitKind kind, RowBlock<Id>& rows)
{
  switch (this->Tags.Vertices[vertex])
  {
    case VertexTag::Smooth:
      this->AppendSmooth(vertex, kind, rows);
      return;
    case VertexTag::Blend:
      if (kind == LimitKind::Position)
      {
        this->AppendBlend(vertex, rows);
      }
      return;
    default:
      if (kind == LimitKind::Position)
      {
        this->AppendCurvePosition(vertex, rows);
      }
      else
      {
        AppendSectorTangent(this->Level, this->Tags, vertex, kind, this->Scratch, rows,
          [&](const SectorEnds<Id>& ends, double turn)
          { this->AppendAcross(vertex, ends, turn, rows); });
      }
  }
}

template <typename Id>
void LimitFinder<Id>::AddStep(const FanStep<Id>& step, Id vertex)
{
  const Id edge = this->Mesh.Edges[step.GetHalfEdgeIn(this->Mesh)];
  this->Around.Edges.push_back(edge);
  this->Around.Ends.push_back(this->Mesh.GetOtherEnd(edge, vertex));
  this->Around.Faces.push_back(this->Mesh.GetFace(step.Corner));
  this->Around.Opposite.push_back(
    this->Mesh.Vertices[this->Mesh.Next(this->Mesh.Next(step.Corner))]);
}

/// Whether the rules around the star are the same on all further levels.
template <typename Id>
bool LimitFinder<Id>::IsUniform() const
{
  if (this->Quads && this->Mesh.Arity != 4)
  {
    return false;
  }
  // The ring of a Blend edge of the control mesh may have members that span no face with it.
  if (this->Level.Step == 0 &&
    std::any_of(this->Around.Edges.begin(), this->Around.Edges.end(),
      [this](Id e) { return this->Tags.Edges[e] == EdgeTag::Blend; }))
  {
    return false;
  }
  if (!this->ModifiedBoundary)
  {
    return true;
  }
  // The end of an edge on a curve changes the rule of the edge; the flatness of a corner changes
  // the rules of its faces too.
  const bool isNearCurve = std::any_of(this->Around.Ends.begin(), this->Around.Ends.end(),
    [this](Id v)
    {
      return this->Tags.Vertices[v] == VertexTag::Curve ||
        this->Tags.Vertices[v] == VertexTag::Corner;
    });
  const bool isNearCorner = this->Quads &&
    std::any_of(this->Around.Opposite.begin(), this->Around.Opposite.end(),
      [this](Id v) { return this->Tags.Vertices[v] == VertexTag::Corner; });
  return !isNearCurve && !isNearCorner;
}

/// Adds the mask: over the vertices of this level if rules stay the same, else over the next level,
/// times the rows of the step.
template <typename Id>
void LimitFinder<Id>::AppendMask(Id vertex, RowBlock<Id>& rows)
{
  const StarMask& mask = this->Row;
  if (this->IsUniform())
  {
    rows.Add(vertex, mask.Own);
    for (std::size_t j = 0; j < mask.Edges.size(); ++j)
    {
      rows.Add(this->Around.Ends[j], mask.Edges[j]);
      if (j < mask.Faces.size())
      {
        rows.Add(this->Around.Opposite[j], mask.Faces[j]);
      }
    }
    return;
  }
  auto add = [&](vtkIdType row, double weight)
  {
    if (weight == 0.)
    {
      return;
    }
    this->Next.Clear();
    this->Scheme.AppendRows(this->Level, this->Tags, row, row + 1, this->Next);
    AddTimes(this->Next, weight, rows);
  };
  const vtkIdType edges = this->Mesh.NumberOfVertices;
  const vtkIdType faces = edges + this->Mesh.GetNumberOfEdges();
  add(vertex, mask.Own);
  for (std::size_t j = 0; j < mask.Edges.size(); ++j)
  {
    add(edges + this->Around.Edges[j], mask.Edges[j]);
  }
  for (std::size_t j = 0; j < mask.Faces.size(); ++j)
  {
    add(faces + this->Around.Faces[j], mask.Faces[j]);
  }
}

// ------------------------------------------------------------------------------------------------
// Inside the surface

template <typename Id>
typename LimitFinder<Id>::StarMask LimitFinder<Id>::MakeSmoothMask(
  LimitKind kind, std::size_t m, bool quads, LoopWeights weights)
{
  const double k = static_cast<double>(m);
  StarMask mask;
  mask.Edges.assign(m, 0.);
  mask.Faces.assign(quads ? m : 0, 0.);
  if (kind == LimitKind::Position)
  {
    const double c = SurfaceVertexMask(static_cast<vtkIdType>(m), weights).Ring;
    const double edge = quads ? 4. / (k * (k + 5.)) : 8. * c / (3. + 8. * k * c);
    std::fill(mask.Edges.begin(), mask.Edges.end(), edge);
    std::fill(mask.Faces.begin(), mask.Faces.end(), edge / 4.);
    mask.Own = quads ? k / (k + 5.) : 1. - k * edge;
    return mask;
  }
  auto wave = [kind, k](std::size_t j)
  {
    const double angle = 2. * Pi * static_cast<double>(j) / k;
    return kind == LimitKind::Tangent1 ? std::cos(angle) : std::sin(angle);
  };
  if (m == 2 && quads && kind == LimitKind::Tangent2)
  {
    mask.Faces = { 1., -1. }; // the waves of edges and of faces are two tangents then
    return mask;
  }
  const double factor = quads
    ? 1. + std::cos(2. * Pi / k) + std::cos(Pi / k) * std::sqrt(2. * (9. + std::cos(2. * Pi / k)))
    : 1.;
  for (std::size_t j = 0; j < m; ++j)
  {
    mask.Edges[j] = factor * wave(j);
    if (quads)
    {
      mask.Faces[j] = wave(j) + wave(j + 1);
    }
  }
  return mask;
}

template <typename Id>
void LimitFinder<Id>::AppendSmooth(Id vertex, LimitKind kind, RowBlock<Id>& rows)
{
  Star& star = this->Around;
  star = Star();
  VisitCycle(this->Mesh, this->Mesh.VertexCorners[vertex],
    [&](const FanStep<Id>& step) { this->AddStep(step, vertex); });
  const auto sharp = std::find_if(star.Edges.begin(), star.Edges.end(),
    [this](Id e) { return this->Tags.Edges[e] != EdgeTag::Smooth; });
  const bool isDart = sharp != star.Edges.end();
  if (isDart)
  {
    // The crease comes first: so the first guesses of the tangents are symmetric and antisymmetric
    // about it, and the iteration preserves that.
    const auto turn = sharp - star.Edges.begin();
    std::rotate(star.Edges.begin(), star.Edges.begin() + turn, star.Edges.end());
    std::rotate(star.Ends.begin(), star.Ends.begin() + turn, star.Ends.end());
    std::rotate(star.Faces.begin(), star.Faces.begin() + turn, star.Faces.end());
    std::rotate(star.Opposite.begin(), star.Opposite.begin() + turn, star.Opposite.end());
  }
  this->Row = MakeSmoothMask(kind, star.Edges.size(), this->Quads, this->Weights);
  if (isDart)
  {
    const double k = static_cast<double>(star.Edges.size());
    const Mask own = SurfaceVertexMask(static_cast<vtkIdType>(star.Edges.size()), this->Weights);
    this->Solve(kind, this->MakeMatrix(this->Quads ? 1. - 7. / (4. * k) : own.Own, own.Ring));
  }
  this->AppendMask(vertex, rows);
}

template <typename Id>
void LimitFinder<Id>::AppendBlend(Id vertex, RowBlock<Id>& rows)
{
  this->Around = Star();
  CollectEdges(this->Mesh, vertex, [](Id) { return true; }, this->Around.Edges);
  for (Id edge : this->Around.Edges)
  {
    this->Around.Ends.push_back(this->Mesh.GetOtherEnd(edge, vertex));
  }
  const Mask own =
    VertexMask(Rule::Blend, static_cast<vtkIdType>(this->Around.Edges.size()), this->Weights);
  // For each edge the edges with which it spans a triangle.
  const std::size_t m = this->Around.Edges.size();
  const std::size_t n = m + 1;
  std::vector<std::vector<std::size_t>> joined(m);
  VisitFans(this->Mesh, vertex,
    [&](Id corner)
    {
      VisitFan(this->Mesh, corner,
        [&](const FanStep<Id>& step)
        {
          const auto& edges = this->Around.Edges;
          auto find = [&edges](Id edge)
          {
            return static_cast<std::size_t>(
              std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin());
          };
          const std::size_t a = find(this->Mesh.Edges[step.GetHalfEdgeIn(this->Mesh)]);
          const std::size_t b = find(this->Mesh.Edges[step.GetHalfEdgeOut(this->Mesh)]);
          joined[a].push_back(b);
          joined[b].push_back(a);
        });
    });
  std::vector<double> matrix(n * n, 0.);
  matrix[0] = own.Own;
  for (std::size_t j = 0; j < m; ++j)
  {
    matrix[1 + j] = own.Ring;
    const EdgeTag tag = this->Tags.Edges[this->Around.Edges[j]];
    const Rule rule = IsSharp(tag) ? Rule::Curve
      : tag == EdgeTag::Blend      ? Rule::Blend
                                   : Rule::Surface;
    const Mask edge = EdgeMask(rule, static_cast<vtkIdType>(joined[j].size()));
    matrix[(1 + j) * n] = edge.Own;
    matrix[(1 + j) * n + 1 + j] = edge.Own;
    for (std::size_t other : joined[j])
    {
      matrix[(1 + j) * n + 1 + other] += edge.Ring;
    }
  }
  this->Row.Edges.assign(m, 1. / static_cast<double>(n));
  this->Row.Faces.clear();
  this->Row.Own = 1. / static_cast<double>(n);
  this->Solve(LimitKind::Position, matrix);
  this->AppendMask(vertex, rows);
}

/// The local subdivision matrix of a dart: of the vertex, its edges and, for quads, its faces.
template <typename Id>
std::vector<double> LimitFinder<Id>::MakeMatrix(double own, double ring) const
{
  const std::size_t m = this->Around.Edges.size();
  const std::size_t n = this->Quads ? 2 * m + 1 : m + 1;
  const double k = static_cast<double>(m);
  std::vector<double> matrix(n * n, 0.);
  matrix[0] = own;
  for (std::size_t j = 0; j < m; ++j)
  {
    const std::size_t after = 1 + (j + 1) % m;
    const std::size_t before = 1 + (j + m - 1) % m;
    double* row = matrix.data() + (1 + j) * n;
    matrix[1 + j] = this->Quads ? 3. / (2. * k * k) : ring;
    if (this->Quads)
    {
      double* face = matrix.data() + (1 + m + j) * n;
      matrix[1 + m + j] = 1. / (4. * k * k);
      face[0] = face[1 + j] = face[after] = face[1 + m + j] = 0.25;
    }
    if (this->Tags.Edges[this->Around.Edges[j]] != EdgeTag::Smooth)
    {
      row[0] = row[1 + j] = 0.5;
      continue;
    }
    const double side = this->Quads ? 1. / 16. : 1. / 8.;
    row[0] = row[1 + j] = 3. / 8.;
    row[after] += side;
    row[before] += side;
    if (this->Quads)
    {
      row[1 + m + j] += side;
      row[m + before] += side;
    }
  }
  return matrix;
}

/// Turns the mask, a first guess, into a left eigenvector by power iteration. A position has the
/// eigenvalue 1 and entries with the sum 1, a tangent one of the next two and entries with the sum
/// 0.
template <typename Id>
void LimitFinder<Id>::Solve(LimitKind kind, const std::vector<double>& matrix)
{
  StarMask& mask = this->Row;
  std::vector<double> left{ mask.Own };
  left.insert(left.end(), mask.Edges.begin(), mask.Edges.end());
  left.insert(left.end(), mask.Faces.begin(), mask.Faces.end());
  const std::size_t n = left.size();
  std::vector<double> next(n);
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    std::fill(next.begin(), next.end(), 0.);
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t j = 0; j < n; ++j)
      {
        next[j] += left[i] * matrix[i * n + j];
      }
    }
    double sum = 0.;
    double largest = 0.;
    for (double value : next)
    {
      sum += value;
      largest = std::max(largest, std::abs(value));
    }
    const bool isPosition = kind == LimitKind::Position;
    for (std::size_t i = 0; i < n; ++i)
    {
      left[i] = isPosition ? next[i] / sum : (next[i] - sum / static_cast<double>(n)) / largest;
    }
  }
  mask.Own = left[0];
  std::copy(left.begin() + 1, left.begin() + 1 + mask.Edges.size(), mask.Edges.begin());
  std::copy(left.begin() + 1 + mask.Edges.size(), left.end(), mask.Faces.begin());
}

// ------------------------------------------------------------------------------------------------
// On curves

template <typename Id>
void LimitFinder<Id>::AppendCurvePosition(Id vertex, RowBlock<Id>& rows)
{
  this->Scratch.clear();
  if (this->Tags.Vertices[vertex] == VertexTag::Curve)
  {
    CollectCurveEdges(this->Mesh, this->Tags, vertex, this->Scratch);
  }
  if (this->Scratch.size() != 2)
  {
    rows.Add(vertex, 1.);
    return;
  }
  rows.Add(vertex, 2. / 3.);
  rows.Add(this->Mesh.GetOtherEnd(this->Scratch[0], vertex), 1. / 6.);
  rows.Add(this->Mesh.GetOtherEnd(this->Scratch[1], vertex), 1. / 6.);
}

/// Appends the tangent across a curve in a sector, times `turn`.
template <typename Id>
void LimitFinder<Id>::AppendAcross(
  Id vertex, const SectorEnds<Id>& ends, double turn, RowBlock<Id>& rows)
{
  this->Around = Star();
  FanStep<Id> step = ends.First;
  for (int i = 0; i < ends.Size; ++i)
  {
    this->AddStep(step, vertex);
    step.Advance(this->Mesh);
  }
  const Id last = this->Mesh.Edges[ends.Last.GetHalfEdgeOut(this->Mesh)];
  this->Around.Edges.push_back(last);
  this->Around.Ends.push_back(this->Mesh.GetOtherEnd(last, vertex));
  this->SetTransversalMask();
  this->Row.Own *= turn;
  for (std::vector<double>* weights : { &this->Row.Edges, &this->Row.Faces })
  {
    std::transform(weights->begin(), weights->end(), weights->begin(),
      [turn](double weight) { return weight * turn; });
  }
  this->AppendMask(vertex, rows);
}

/// Sets the mask of the tangent across a curve in a sector of k faces, with the weight sin(j pi /
/// k) for inner edge j.
template <typename Id>
void LimitFinder<Id>::SetTransversalMask()
{
  const std::size_t k = this->Around.Edges.size() - 1;
  StarMask& mask = this->Row;
  mask.Edges.assign(k + 1, 0.);
  mask.Faces.assign(this->Quads ? k : 0, 0.);
  if (k == 1)
  {
    mask.Own = -2.;
    mask.Edges = { 1., 1. };
    return;
  }
  const double t = Pi / static_cast<double>(k);
  const TransversalMask weights =
    GetTransversalMask(static_cast<int>(k), this->Quads, this->ModifiedBoundary);
  mask.Own = weights.Own;
  for (std::size_t j = 1; j < k; ++j)
  {
    mask.Edges[j] = std::sin(static_cast<double>(j) * t);
  }
  mask.Edges[0] = mask.Edges[k] = weights.End;
  for (std::size_t j = 0; j < mask.Faces.size(); ++j)
  {
    mask.Faces[j] = weights.Faces *
      (std::sin(static_cast<double>(j) * t) + std::sin(static_cast<double>(j + 1) * t));
  }
}

SUBDIVISION_COMPILE(class LimitFinder);

#define SUBDIVISION_LIMITS_OF_NEXT(Id, Arity)                                                      \
  template const double* LimitFinder<Id>::GetSecondTangent<Arity>(const double*);                  \
  template void LimitFinder<Id>::AppendRowsOfNext<Arity>(const SurfaceLevel<Id>&,                  \
    const IrregularRows<Id>&, LoopWeights, LimitKind, vtkIdType, vtkIdType, RowBlock<Id>&)
SUBDIVISION_LIMITS_OF_NEXT(int, 3);
SUBDIVISION_LIMITS_OF_NEXT(int, 4);
SUBDIVISION_LIMITS_OF_NEXT(long long, 3);
SUBDIVISION_LIMITS_OF_NEXT(long long, 4);

}
