// SPDX-License-Identifier: BSD-3-Clause
#include "EmbeddedPoints.h"

#include "Arrays.h"
#include "Core/Store.h"

#include <cmath>

namespace subdivision
{
namespace
{

/// Weights may be this much below 0. Points in single precision are where they are only to 1e-7,
/// so that those on a boundary may seem to be outside.
constexpr double Tolerance = 1e-10;
constexpr double SingleTolerance = 1e-5;

struct Found
{
  int Columns[4] = { 0, 0, 0, 0 };
  double Weights[4] = { 0., 0., 0., 0. };
  int Size = 0;
  bool Inside = false;
};

void SetRow(const SimplexTree& tree, const Place& place, int size, Found& found)
{
  const vtkIdType* corners = tree.GetCorners(place.Simplex);
  found.Size = size;
  for (int i = 0; i < size; ++i)
  {
    found.Columns[i] = static_cast<int>(corners[i]);
    found.Weights[i] = place.Weights[i];
  }
}

/// Among equally near cells, solids come first.
void FindNearestCell(
  const double x[3], const SimplexTree& tets, const SimplexTree& others, Found& found)
{
  Place inTet;
  Place inOther;
  double toTet;
  double toOther;
  const bool hasTet = tets.FindNearest(x, inTet, toTet);
  const bool hasOther = others.FindNearest(x, inOther, toOther);
  if (hasTet && (!hasOther || toTet <= toOther * (1. + 1e-12)))
  {
    SetRow(tets, inTet, 4, found);
  }
  else if (hasOther)
  {
    SetRow(others, inOther, 3, found);
  }
}

bool IsFinite(const double x[3])
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

/// Adds to points outside what their rows do not say.
template <typename T>
void AddRemainders(const EmbeddedPoints& embedded, T* points)
{
  for (std::size_t i = 0; i < embedded.Outside.size(); ++i)
  {
    T* point = points + 3 * embedded.Outside[i];
    const double* remainder = embedded.Remainders.data() + 3 * i;
    for (int c = 0; c < 3; ++c)
    {
      point[c] = Store<T>(static_cast<double>(point[c]) + remainder[c]);
    }
  }
}

/// Composed rows, if reading them is less than reading rows and operators. Few have fewer entries
/// than 16; more points than 4 million could need more than 2^31 entries on the way.
void ComposeIfSmaller(const RestMesh& rest, EmbeddedPoints& embedded)
{
  const vtkIdType points = embedded.Rows.GetNumberOfRows();
  const double now = static_cast<double>(rest.GetOperatorSize() + embedded.Rows.GetMemorySize());
  const double least = 16. * (sizeof(int) + sizeof(double)) * static_cast<double>(points);
  if (rest.GetOperatorSize() == 0 || points > 4000000 || least > now)
  {
    return;
  }
  SparseRows<int> composed = rest.Compose(embedded.Rows);
  if (static_cast<double>(composed.GetMemorySize()) < now)
  {
    embedded.Composed = std::move(composed);
  }
}

}

std::unique_ptr<EmbeddedPoints> EmbedPoints(vtkDataArray* points, OutsideRule rule, RestMesh& rest)
{
  auto embedded = std::make_unique<EmbeddedPoints>();
  embedded->Rule = rule;
  const vtkIdType size = points->GetNumberOfTuples();
  const bool isSingle = points->GetDataType() == VTK_FLOAT;
  const SimplexTree& tets = rest.GetTets();
  const SimplexTree none;
  const SimplexTree& others = rule == OutsideRule::Nearest ? rest.GetOtherCells() : none;
  Buffer<Found> found(size);
  SparseRows<int>& rows = embedded->Rows;
  rows.NumberOfColumns = rest.GetNumberOfPoints();
  rows.Offsets = Buffer<int>(size + 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      double x[3];
      points->GetTuple(i, x);
      Found here;
      Place place;
      if (IsFinite(x))
      {
        here.Inside = tets.FindContaining(x, Tolerance, place) ||
          (isSingle && tets.FindContaining(x, SingleTolerance, place));
        if (here.Inside)
        {
          SetRow(tets, place, 4, here);
        }
        else if (rule == OutsideRule::Nearest)
        {
          FindNearestCell(x, tets, others, here);
        }
      }
      found[i] = here;
      rows.Offsets[i] = here.Size;
    });
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<int>(rows.Offsets[size]);
  rows.Weights = Buffer<double>(rows.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      std::copy(
        found[i].Columns, found[i].Columns + found[i].Size, rows.Columns.begin() + rows.Offsets[i]);
      std::copy(
        found[i].Weights, found[i].Weights + found[i].Size, rows.Weights.begin() + rows.Offsets[i]);
    });
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (!found[i].Inside)
    {
      double x[3];
      points->GetTuple(i, x);
      embedded->NumberNotFinite += !IsFinite(x);
      embedded->Outside.push_back(i);
      for (int c = 0; c < 3; ++c)
      {
        for (int k = 0; k < found[i].Size; ++k)
        {
          x[c] -= found[i].Weights[k] * rest.GetPoints()[3 * found[i].Columns[k] + c];
        }
        embedded->Remainders.push_back(x[c]);
      }
    }
  }
  ComposeIfSmaller(rest, *embedded);
  return embedded;
}

vtkSmartPointer<vtkDataArray> MoveEmbeddedPoints(
  const EmbeddedPoints& embedded, vtkDataArray* control, vtkDataArray* moved, int type)
{
  const auto points = MakeArray(type, 3, embedded.Rows.GetNumberOfRows());
  const SparseRows<int>& rows = moved ? embedded.Rows : embedded.Composed;
  const auto* from = static_cast<const double*>((moved ? moved : control)->GetVoidPointer(0));
  auto move = [&](auto* to)
  {
    rows.Apply(from, to, 3);
    AddRemainders(embedded, to);
  };
  if (type == VTK_FLOAT)
  {
    move(static_cast<float*>(points->GetVoidPointer(0)));
  }
  else
  {
    move(static_cast<double*>(points->GetVoidPointer(0)));
  }
  return points;
}

Buffer<double> ComputeJacobians(
  const EmbeddedPoints& embedded, const double* rest, const double* moved)
{
  const SparseRows<int>& rows = embedded.Rows;
  Buffer<double> jacobians(9 * rows.GetNumberOfRows());
  ForEach(rows.GetNumberOfRows(),
    [&](vtkIdType i)
    {
      double* jacobian = jacobians.data() + 9 * i;
      const int* ids = rows.Columns.data() + rows.Offsets[i];
      for (int k = 0; k < 9; ++k)
      {
        jacobian[k] = k % 4 == 0 ? 1. : 0.;
      }
      if (rows.Offsets[i + 1] - rows.Offsets[i] != 4)
      {
        return;
      }
      const double* corners[4];
      for (int k = 0; k < 4; ++k)
      {
        corners[k] = rest + 3 * static_cast<vtkIdType>(ids[k]);
      }
      double gradients[4][3];
      if (!FindGradientsInTet(corners, gradients))
      {
        return;
      }
      for (int c = 0; c < 3; ++c)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          double sum = 0.;
          for (int k = 0; k < 4; ++k)
          {
            sum += gradients[k][axis] * moved[3 * static_cast<vtkIdType>(ids[k]) + c];
          }
          jacobian[3 * c + axis] = sum;
        }
      }
    });
  return jacobians;
}

}
