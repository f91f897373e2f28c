// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/LabelNet.h"

#include "Core/Memory/Sorting.h"
#include "Core/Memory/Vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subdivision
{
namespace
{

using namespace vectors;

/// Taubin's factors: long waves keep their height.
constexpr double Inwards = .5;
constexpr double Outwards = -.53;

/// The label beyond a border that stays flat.
constexpr int Outside = -1;

enum EdgeKind
{
  NOWHERE,
  INSIDE,
  INTERFACE,
  CURVE
};

/// Of the labels of the four voxels around an edge, by rows.
EdgeKind Classify(const std::array<int, 4>& around)
{
  std::array<int, 4> sorted = around;
  std::sort(sorted.begin(), sorted.end());
  const auto kinds = std::unique(sorted.begin(), sorted.end()) - sorted.begin();
  if (sorted.back() <= 0)
  {
    return NOWHERE;
  }
  if (kinds == 1)
  {
    return INSIDE;
  }
  // Two voxels of one label that only touch in the edge are a joint.
  const bool isJoint = around[0] == around[3] && around[1] == around[2];
  return kinds > 2 || isJoint ? CURVE : INTERFACE;
}

/// Whether faces of the border end at an edge, or turn there.
bool EndsBorder(const std::array<int, 4>& around)
{
  const auto outside = std::count(around.begin(), around.end(), Outside);
  const auto inside =
    std::count_if(around.begin(), around.end(), [](int label) { return label > 0; });
  return outside > 0 && inside > 0 && !(outside == 2 && inside == 2);
}

void Add(double factor, const Vector& a, Vector& to)
{
  for (int c = 0; c < 3; ++c)
  {
    to[c] += factor * a[c];
  }
}

double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

}

LabelNet::LabelNet(const LabelImage& image, double largest, bool isFlat)
  : Image(image)
  , Largest(largest)
  , IsFlat(isFlat)
  , Lines{ image.Size[0] + 1, image.Size[1] + 1, image.Size[2] + 1 }
  , Ids(Lines[0] * Lines[1] * Lines[2], -1)
{
  this->AddPoints();
  this->AddCells();
  this->AddFaces();
  this->Smoothed.resize(this->Corners.size());
  ForEach(this->GetNumberOfPoints(), [&](vtkIdType i)
    { this->Smoothed[i] = { this->GetRest(i, 0), this->GetRest(i, 1), this->GetRest(i, 2) }; });
}

double LabelNet::GetRest(vtkIdType i, int axis) const
{
  const vtkIdType last = this->Image.Size[axis];
  const double end = static_cast<double>(this->Image.FineSize[axis]) / this->Image.Length;
  return this->Corners[i][axis] == last ? end - static_cast<double>(last) : 0.;
}

/// Beyond the image there is background, or no label at all.
int LabelNet::GetLabel(vtkIdType i, vtkIdType j, vtkIdType k) const
{
  std::array<vtkIdType, 3> at{ i, j, k };
  int beyond = 0;
  int end = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkIdType inside = std::clamp(at[axis], vtkIdType(0), this->Image.Size[axis] - 1);
    if (inside != at[axis])
    {
      ++beyond;
      end = 2 * axis + (at[axis] > 0 ? 1 : 0);
      at[axis] = inside;
    }
  }
  const vtkIdType voxel = this->Image.GetId(at[0], at[1], at[2]);
  const int label = this->Image.Voxels[voxel];
  if (beyond == 0)
  {
    return label;
  }
  const bool touches = beyond == 1 && label > 0 && (this->Image.Ends[voxel] >> end & 1);
  return touches && this->IsFlat ? Outside : 0;
}

void LabelNet::AddPoints()
{
  std::array<int, 8> around;
  const vtkIdType strides[3] = { 1, this->Lines[0], this->Lines[0] * this->Lines[1] };
  Turns turns;
  for (int k = 0; k < this->Lines[2]; ++k)
  {
    for (int j = 0; j < this->Lines[1]; ++j)
    {
      for (int i = 0; i < this->Lines[0]; ++i, turns.Next())
      {
        for (int v = 0; v < 8; ++v)
        {
          around[v] = this->GetLabel(i - 1 + (v & 1), j - 1 + (v >> 1 & 1), k - 1 + (v >> 2));
        }
        if (std::all_of(around.begin(), around.end(), [](int label) { return label <= 0; }))
        {
          continue;
        }
        const vtkIdType place = this->GetPlace(i, j, k);
        int masks[4] = { 0, 0, 0, 0 };
        for (int direction = 0; direction < 6; ++direction)
        {
          std::array<int, 4> four;
          int n = 0;
          for (int v = 0; v < 8; ++v)
          {
            if ((v >> direction / 2 & 1) == direction % 2)
            {
              four[n++] = around[v];
            }
          }
          masks[Classify(four)] |= 1 << direction;
          if (direction % 2 && EndsBorder(four))
          {
            this->BorderEdges.push_back({ place, place + strides[direction / 2] });
          }
        }
        const int curves = masks[CURVE];
        const bool isOnCurve = curves & (curves - 1); // the end of a curve lies on an interface
        const int on = isOnCurve ? curves : curves | masks[INTERFACE];
        this->Ids[place] = this->GetNumberOfPoints();
        this->Corners.push_back({ i, j, k });
        this->Directions.push_back(static_cast<unsigned char>(on ? on : masks[INSIDE]));
        this->IsInside.push_back(on == 0);
        int held = 0;
        for (int v = 0; v < 8; ++v)
        {
          const vtkIdType at[3] = { i - 1 + (v & 1), j - 1 + (v >> 1 & 1), k - 1 + (v >> 2) };
          for (int axis = 0; axis < 3 && around[v] == Outside; ++axis)
          {
            held |= at[axis] < 0 || at[axis] >= this->Image.Size[axis] ? 1 << axis : 0;
          }
        }
        this->Held.push_back(static_cast<unsigned char>(held));
      }
    }
  }
  for (auto& edge : InTurn(this->BorderEdges))
  {
    edge = { this->Ids[edge[0]], this->Ids[edge[1]] };
  }
}

void LabelNet::AddCells()
{
  static const int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const auto& size = this->Image.Size;
  Turns turns;
  for (vtkIdType k = 0; k < size[2]; ++k)
  {
    for (vtkIdType j = 0; j < size[1]; ++j)
    {
      for (vtkIdType i = 0; i < size[0]; ++i, turns.Next())
      {
        const int label = this->GetLabel(i, j, k);
        if (label == 0)
        {
          continue;
        }
        Cell cell;
        for (int c = 0; c < 8; ++c)
        {
          cell[c] =
            this->Ids[this->GetPlace(i + corners[c][0], j + corners[c][1], k + corners[c][2])];
        }
        this->Cells.push_back(cell);
        this->CellLabels.push_back(label);
      }
    }
  }
}

void LabelNet::AddFaces()
{
  Turns turns;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<vtkIdType, 3> u{ 0, 0, 0 };
    std::array<vtkIdType, 3> v{ 0, 0, 0 };
    std::array<vtkIdType, 3> back{ 0, 0, 0 };
    u[(axis + 1) % 3] = 1;
    v[(axis + 2) % 3] = 1;
    back[axis] = 1;
    for (vtkIdType k = 0; k < this->Lines[2] - u[2] - v[2]; ++k)
    {
      for (vtkIdType j = 0; j < this->Lines[1] - u[1] - v[1]; ++j)
      {
        for (vtkIdType i = 0; i < this->Lines[0] - u[0] - v[0]; ++i, turns.Next())
        {
          const int low = std::max(0, this->GetLabel(i - back[0], j - back[1], k - back[2]));
          const int high = std::max(0, this->GetLabel(i, j, k));
          if (low != high)
          {
            const vtkIdType first = this->GetPlace(i, j, k);
            const vtkIdType along = this->GetPlace(u[0], u[1], u[2]);
            const vtkIdType across = this->GetPlace(v[0], v[1], v[2]);
            this->Faces.push_back(
              { { this->Ids[first], this->Ids[first + along], this->Ids[first + along + across],
                  this->Ids[first + across] },
                low, high });
          }
        }
      }
    }
  }
}

Vector LabelNet::Limit(vtkIdType i, Vector move) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    move[axis] = this->IsHeld(i, axis) ? 0. : move[axis];
  }
  const double length = std::sqrt(Dot(move, move));
  const double factor = length > this->Largest ? this->Largest / length : 1.;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double rest = this->GetRest(i, axis);
    const int at = this->Corners[i][axis];
    move[axis] *= factor;
    if (this->IsFlat && at == 0)
    {
      move[axis] = std::max(move[axis], rest); // nothing leaves the image
    }
    else if (this->IsFlat && at == this->Image.Size[axis])
    {
      move[axis] = std::min(move[axis], rest);
    }
    move[axis] = this->IsHeld(i, axis) ? rest : move[axis];
  }
  return move;
}

void LabelNet::Step(double factor, bool isInside, const Vectors& from, Vectors& to) const
{
  const vtkIdType strides[3] = { 1, this->Lines[0], this->Lines[0] * this->Lines[1] };
  ForEach(this->GetNumberOfPoints(),
    [&](vtkIdType i)
    {
      Vector sum{ 0., 0., 0. };
      int count = 0;
      const auto& at = this->Corners[i];
      const vtkIdType place = this->GetPlace(at[0], at[1], at[2]);
      for (int direction = 0; direction < 6; ++direction)
      {
        if (this->Directions[i] >> direction & 1)
        {
          const int axis = direction / 2;
          const int sign = direction % 2 ? 1 : -1;
          Add(1., from[this->Ids[place + sign * strides[axis]]], sum);
          sum[axis] += sign;
          ++count;
        }
      }
      to[i] = from[i];
      if (count > 0 && (isInside || !this->IsInside[i]))
      {
        Add(-count, from[i], sum);
        Add(factor / count, sum, to[i]);
        to[i] = this->Limit(i, to[i]);
      }
    });
}

void LabelNet::Smooth(int steps)
{
  Vectors next(this->Smoothed.size());
  for (int step = 0; step < steps; ++step)
  {
    this->Step(Inwards, true, this->Smoothed, next);
    this->Step(Outwards, false, next, this->Smoothed);
  }
}

void LabelNet::Stiffen(const std::vector<vtkIdType>& cells)
{
  std::vector<vtkIdType> points;
  for (const vtkIdType cell : InTurn(cells))
  {
    points.insert(points.end(), this->Cells[cell].begin(), this->Cells[cell].end());
  }
  SortDistinct(points);
  for (const vtkIdType point : InTurn(points))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double& move = this->Smoothed[point][axis];
      move -= .25 * (move - this->GetRest(point, axis));
    }
  }
}

std::vector<double> LabelNet::GetVolumes(const Vectors& moves, Vectors& areas) const
{
  std::vector<double> volumes(this->Image.Labels.size() + 1, 0.);
  areas.resize(this->Faces.size());
  for (const std::size_t f : InTurn(this->Faces.size()))
  {
    const Face& face = this->Faces[f];
    Vector at[4];
    Vector middle{ 0., 0., 0. };
    for (int c = 0; c < 4; ++c)
    {
      const auto& corner = this->Corners[face.Corners[c]];
      at[c] = moves[face.Corners[c]];
      Add(1., { 1. * corner[0], 1. * corner[1], 1. * corner[2] }, at[c]);
      Add(.25, at[c], middle);
    }
    Add(-1., at[0], at[2]);
    Add(-1., at[1], at[3]);
    const Vector twice = Cross(at[2], at[3]);
    areas[f] = { twice[0] / 2., twice[1] / 2., twice[2] / 2. };
    const double volume = Dot(areas[f], middle) / 3.;
    volumes[face.Low] += volume;
    volumes[face.High] -= volume;
  }
  return volumes;
}

LabelNet::Vectors LabelNet::Press(const Vectors& areas, const std::vector<double>& sizes,
  const std::vector<double>& pressures) const
{
  constexpr double smallest = 1e-12; // faces that have become points
  Vectors moves(this->Corners.size(), Vector{ 0., 0., 0. });
  for (const std::size_t f : InTurn(this->Faces.size()))
  {
    const Face& face = this->Faces[f];
    const double pressure = pressures[face.Low] - pressures[face.High];
    for (const vtkIdType corner : face.Corners)
    {
      Add(pressure / std::max(sizes[corner], smallest), areas[f], moves[corner]);
    }
  }
  ForEach(this->GetNumberOfPoints(),
    [&](vtkIdType i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        moves[i][axis] = this->IsHeld(i, axis) ? 0. : moves[i][axis];
      }
    });
  return moves;
}

std::vector<double> LabelNet::GetChange(const Vectors& areas, const Vectors& moves) const
{
  std::vector<double> change(this->Image.Labels.size() + 1, 0.);
  for (const std::size_t f : InTurn(this->Faces.size()))
  {
    const Face& face = this->Faces[f];
    for (const vtkIdType corner : face.Corners)
    {
      const double swept = Dot(areas[f], moves[corner]) / 4.;
      change[face.Low] += swept;
      change[face.High] -= swept;
    }
  }
  change[0] = 0.; // the background has no pressure
  return change;
}

/// By conjugate gradients: as many products as there are labels, or fewer.
LabelNet::Vectors LabelNet::Solve(const Vectors& areas, const std::vector<double>& change) const
{
  std::vector<double> sizes(this->Corners.size(), 0.);
  for (const std::size_t f : InTurn(this->Faces.size()))
  {
    for (const vtkIdType corner : this->Faces[f].Corners)
    {
      sizes[corner] += std::sqrt(Dot(areas[f], areas[f]));
    }
  }
  constexpr int most = 100;
  constexpr double accuracy = 1e-20; // of squares
  constexpr double stiffness = 1e-6; // labels in a box of flat borders cannot all grow
  std::vector<double> pressures(change.size(), 0.);
  std::vector<double> residual = change;
  residual[0] = 0.;
  std::vector<double> direction = residual;
  const double start = Dot(residual, residual);
  double square = start;
  for (int i = 0; i < most && square > accuracy * start; ++i)
  {
    std::vector<double> product = this->GetChange(areas, this->Press(areas, sizes, direction));
    for (std::size_t m = 0; m < product.size(); ++m)
    {
      product[m] += stiffness * direction[m];
    }
    const double resistance = Dot(direction, product);
    if (resistance <= 0.)
    {
      break; // no face is left that could move
    }
    const double step = square / resistance;
    const double before = square;
    for (std::size_t m = 0; m < change.size(); ++m)
    {
      pressures[m] += step * direction[m];
      residual[m] -= step * product[m];
    }
    square = Dot(residual, residual);
    for (std::size_t m = 0; m < change.size(); ++m)
    {
      direction[m] = residual[m] + square / before * direction[m];
    }
  }
  return this->Press(areas, sizes, pressures);
}

std::vector<Vector> LabelNet::HoldVolumes(const std::vector<double>& volumes) const
{
  constexpr int rounds = 5;
  Vectors moves = this->Smoothed;
  Vectors areas;
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<double> change = this->GetVolumes(moves, areas);
    for (std::size_t m = 1; m < change.size(); ++m)
    {
      change[m] = volumes[m] - change[m];
    }
    const Vectors more = this->Solve(areas, change);
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
      Add(1., more[i], moves[i]);
      moves[i] = this->Limit(static_cast<vtkIdType>(i), moves[i]);
    }
  }
  for (const std::size_t i : InTurn(moves.size()))
  {
    const auto& corner = this->Corners[i];
    Add(1., { 1. * corner[0], 1. * corner[1], 1. * corner[2] }, moves[i]);
  }
  return moves;
}

}
