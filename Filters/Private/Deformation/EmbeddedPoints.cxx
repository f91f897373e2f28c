// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deformation/EmbeddedPoints.h"

#include "Core/Memory/Coordinates.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Store.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Solids/Location/TetFrame.h"
#include "Private/Arrays/Arrays.h"

#include "vtkMath.h"

#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

/// A point is inside a cell if its weights are not further below 0 than this. Points in single
/// precision, of the object or of the rest mesh, are exact to 1e-7 only, so that points on a
/// boundary may seem to be outside.
constexpr double Tolerance = 1e-10;
constexpr double SingleTolerance = SingleTie;

CornerRow MakeRow(const SimplexTree& tree, const PlaceInSimplex& place, int corners)
{
  CornerRow row;
  const int* ids = tree.GetCorners(place.Simplex);
  for (int i = 0; i < 4; ++i)
  {
    row.Columns[i] = ids[std::min(i, corners - 1)];
    row.Weights[i] = i < corners ? place.Weights[i] : 0.;
  }
  return row;
}

/// The row of the nearest cell; among equally near ones a solid cell.
CornerRow FindNearestCell(
  const double x[3], const SimplexTree& tets, const SimplexTree& others, double tie)
{
  PlaceInSimplex inTet;
  PlaceInSimplex inOther;
  double toTet;
  double toOther;
  const bool hasTet = tets.FindNearest(x, inTet, toTet);
  const bool hasOther = others.FindNearest(x, inOther, toOther);
  return hasTet && (!hasOther || toTet <= toOther * (1. + tie)) ? MakeRow(tets, inTet, 4)
    : hasOther                                                  ? MakeRow(others, inOther, 3)
                                                                : CornerRow();
}

/// The square of the distance up to which a point lies on a surface: in a control mesh without
/// solids, such as a mesh in the plane of an image, the surfaces hold the points. Less than 0 for
/// other meshes.
double FindReach2(const RestMesh& rest, double tolerance)
{
  if (rest.GetTets().GetNumberOfSimplices() > 0)
  {
    return -1.;
  }
  double diagonal2 = 0.;
  for (int c = 0; c < 3; ++c)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const vtkIdType i : InTurn(rest.GetNumberOfPoints()))
    {
      const double x = rest.GetPoints()[3 * i + c];
      low = x < low ? x : low;
      high = x > high ? x : high;
    }
    diagonal2 += high > low ? (high - low) * (high - low) : 0.;
  }
  return tolerance * tolerance * diagonal2;
}

bool IsFinite(const double x[3])
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

/// Adds their remainders to points outside.
template <typename T>
void AddRemainders(const EmbeddedPoints& embedded, T* points)
{
  for (const std::size_t i : InTurn(embedded.Outside.size()))
  {
    T* point = points + 3 * embedded.Outside[i];
    const bool isBound = embedded.IsBound(embedded.Outside[i]);
    const double* remainder = embedded.Remainders.data() + 3 * i;
    for (int c = 0; c < 3; ++c)
    {
      const double mean = isBound ? static_cast<double>(point[c]) : 0.;
      point[c] = Store<T>(mean + remainder[c]);
    }
  }
}

/// An array for the points, which move(values) writes as float or double.
template <typename Move>
vtkSmartPointer<vtkDataArray> MakePoints(const EmbeddedPoints& embedded, int type, const Move& move)
{
  auto points = MakeArray(type, 3, embedded.GetNumberOfPoints());
  const auto moveAll = [&](auto* to)
  {
    move(to);
    AddRemainders(embedded, to);
  };
  type == VTK_FLOAT ? moveAll(static_cast<float*>(points->GetVoidPointer(0)))
                    : moveAll(static_cast<double*>(points->GetVoidPointer(0)));
  return points;
}

void AddOutside(vtkDataArray* points, vtkIdType i, const RestMesh& rest, EmbeddedPoints& embedded)
{
  double x[3];
  points->GetTuple(i, x);
  embedded.NumberNotFinite += !IsFinite(x);
  embedded.Outside.push_back(i);
  const CornerRow row = embedded.Rows.GetRow(i);
  for (int c = 0; c < 3; ++c)
  {
    for (int k = 0; k < 4 && !row.IsEmpty(); ++k)
    {
      x[c] -= row.Weights[k] * rest.GetPoints()[3 * static_cast<vtkIdType>(row.Columns[k]) + c];
    }
    embedded.Remainders.push_back(x[c]);
  }
}

/// Finds the tetrahedra that hold points.
void FindTets(vtkDataArray* points, double tolerance, const RestMesh& rest, CornerRows& rows)
{
  const vtkIdType size = points->GetNumberOfTuples();
  const SimplexTree& tets = rest.GetTets();
  rows.NumberOfColumns = rest.GetNumberOfPoints();
  rows.Corners = rest.GetTetCorners();
  rows.Simplices = Buffer<int>(size);
  rows.Weights = Buffer<double>(tets.GetNumberOfSimplices() > 0 ? 3 * size : 0);
  const Buffer<vtkIdType> order =
    tets.SortPoints(size, [points](vtkIdType i, double x[3]) { points->GetTuple(i, x); });
  constexpr int most = SimplexTree::MostAtOnce;
  ForEach((size + most - 1) / most,
    [&](vtkIdType group)
    {
      double x[most][3];
      PlaceInSimplex places[most];
      const vtkIdType* numbers = order.data() + group * most;
      const int count = static_cast<int>(std::min<vtkIdType>(most, size - group * most));
      for (int i = 0; i < count; ++i)
      {
        points->GetTuple(numbers[i], x[i]);
      }
      tets.FindHolding(x, count, { Tolerance, tolerance }, places);
      for (int i = 0; i < count; ++i)
      {
        rows.Simplices[numbers[i]] = static_cast<int>(places[i].Simplex);
        if (places[i].Simplex >= 0)
        {
          std::copy_n(places[i].Weights + 1, 3, rows.Weights.data() + 3 * numbers[i]);
        }
      }
    });
}

/// Makes the rows of points that are in no tetrahedron, and tells which of them are outside. False:
/// they are too many.
bool BindToOthers(vtkDataArray* points, bool isSingle, RestMesh& rest, EmbeddedPoints& embedded)
{
  CornerRows& rows = embedded.Rows;
  std::vector<vtkIdType> missing;
  ForEachInTurn(rows.Simplices.size(),
    [&](vtkIdType i)
    {
      if (rows.Simplices[i] < 0)
      {
        missing.push_back(i);
      }
    });
  const bool isNearest = embedded.Rule == OutsideRule::Nearest;
  const double tie = isSingle ? SingleTie : DoubleTie;
  const double reach2 = FindReach2(rest, isSingle ? SingleTolerance : Tolerance);
  const auto size = static_cast<vtkIdType>(missing.size());
  // Points that are left where they are share one row, which is empty.
  const bool isShared = !isNearest && reach2 < 0.;
  if (!isShared && size > EmbeddedPoints::MostOthers)
  {
    return false;
  }
  rows.Others = Buffer<CornerRow>(isShared ? std::min<vtkIdType>(size, 1) : size, CornerRow());
  Buffer<bool> isInside(size, false);
  if (!isShared && size > 0)
  {
    const SimplexTree none;
    const SimplexTree& tets = isNearest ? rest.GetTets() : none;
    const SimplexTree& others = rest.GetOthers();
    const auto bind = [&](vtkIdType i)
    {
      double x[3];
      points->GetTuple(missing[i], x);
      PlaceInSimplex place;
      double distance2 = 0.;
      rows.Simplices[missing[i]] = static_cast<int>(-1 - i);
      if (!IsFinite(x))
      {
        return;
      }
      isInside[i] = reach2 >= 0. && others.FindNearest(x, place, distance2) && distance2 <= reach2;
      rows.Others[i] = isInside[i] ? MakeRow(others, place, 3)
        : isNearest                ? FindNearestCell(x, tets, others, tie)
                                   : CornerRow();
    };
    // In the middle of a surface all of it is equally near.
    ForUnevenRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          bind(i);
        }
      });
  }
  ForEachInTurn(size,
    [&](vtkIdType i)
    {
      if (!isInside[i])
      {
        AddOutside(points, missing[i], rest, embedded);
      }
    });
  return true;
}

/// Stores composed rows, if these are smaller than rows and operators together and so are read
/// faster. Few composed rows have fewer than 16 entries; with more than 4 million points
/// intermediate results could need more than 2^31 entries.
void ComposeIfSmaller(const RestMesh& rest, EmbeddedPoints& embedded)
{
  const vtkIdType points = embedded.Rows.GetNumberOfRows();
  // A row counts for its four entries, of which fewer are stored.
  const double now = static_cast<double>(rest.GetOperatorSize()) +
    static_cast<double>(sizeof(CornerRow)) * static_cast<double>(points);
  const double least = 16. * (sizeof(int) + sizeof(double)) * static_cast<double>(points);
  if (rest.GetOperatorSize() == 0 || points > 4000000 || least > now)
  {
    return;
  }
  SparseRows<int> composed = rest.Compose(embedded.Rows.ToSparseRows());
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
  const bool isSingle = points->GetDataType() == VTK_FLOAT || rest.IsSingle();
  FindTets(points, isSingle ? SingleTolerance : Tolerance, rest, embedded->Rows);
  if (!BindToOthers(points, isSingle, rest, *embedded))
  {
    return nullptr;
  }
  ComposeIfSmaller(rest, *embedded);
  return embedded;
}

vtkSmartPointer<vtkDataArray> MoveEmbeddedPoints(
  const EmbeddedPoints& embedded, const double* control, const double* moved, int type)
{
  return MakePoints(embedded, type,
    [&](auto* to)
    {
      moved                    ? embedded.Rows.Move(moved, to)
        : embedded.IsOnLimit() ? embedded.OnLimit[0].Apply(control, to, 3)
                               : embedded.Composed.Apply(control, to, 3);
    });
}

vtkSmartPointer<vtkDataArray> MoveIfEmbedded(
  const EmbeddedPoints& embedded, const double* moved, int type, vtkDataArray* given)
{
  bool isEmbedded = false;
  const auto points = MakePoints(embedded, type,
    [&](auto* to)
    {
      const Fingerprint print = ComputeFingerprint(
        given, [&](vtkIdType begin, vtkIdType end) { embedded.Rows.Move(begin, end, moved, to); });
      isEmbedded = print == embedded.Print;
    });
  return isEmbedded ? points : nullptr;
}

namespace
{

/// The matrix of the map of the limit: its derivatives by the parameters of a place times the
/// inverse of the derivatives at rest. It stays where these are no basis, as beyond solids.
void FindSlope(
  const EmbeddedPoints& embedded, vtkIdType i, const double* rest, const double* moved, double* to)
{
  double before[3][3];
  double after[3][3];
  double size = 1.;
  for (int k = 0; k < 3; ++k)
  {
    WeightedRows<vtkIdType> row = embedded.OnLimit[k + 1].GetRows(i, i + 1);
    row.FirstRow = 0;
    row.CopiesOnes = false;
    SumRows(row, rest, before[k], 3);
    SumRows(row, moved, after[k], 3);
    size *= vtkMath::Norm(before[k]);
  }
  if (!(std::abs(vtkMath::Determinant3x3(before)) > 1e-10 * size))
  {
    return;
  }
  double inverse[3][3];
  double transposed[3][3];
  vtkMath::Invert3x3(before, inverse);
  vtkMath::Multiply3x3(inverse, after, transposed);
  for (int k = 0; k < 9; ++k)
  {
    to[k] = transposed[k % 3][k / 3];
  }
}

}

Buffer<double> ComputeJacobians(
  const EmbeddedPoints& embedded, const double* rest, const double* moved)
{
  const vtkIdType size = embedded.GetNumberOfPoints();
  Buffer<double> jacobians(9 * size);
  ForEach(size,
    [&](vtkIdType i)
    {
      double* jacobian = jacobians.data() + 9 * i;
      for (int k = 0; k < 9; ++k)
      {
        jacobian[k] = k % 4 == 0 ? 1. : 0.;
      }
      if (embedded.IsOnLimit())
      {
        embedded.IsBound(i) ? FindSlope(embedded, i, rest, moved, jacobian) : void();
        return;
      }
      const CornerRow row = embedded.Rows.GetRow(i);
      const int* ids = row.Columns;
      const double* corners[4];
      for (int k = 0; k < 4; ++k)
      {
        corners[k] = rest + 3 * static_cast<vtkIdType>(ids[k]);
      }
      double gradients[4][3];
      if (!FindGradientsInTet(corners, gradients)) // the cell is flat, no solid, or missing
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
