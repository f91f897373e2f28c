// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/PolygonEars.h"

#include "Core/Memory/Coordinates.h"
#include "Core/Memory/Vectors.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

namespace
{

using Vector3 = vectors::Vector;
using vectors::Cross;
using vectors::Dot;

void Scale(Vector3& a, double factor)
{
  for (double& x : a)
  {
    x *= factor;
  }
}

/// Twice the area of a triangle, positive if its corners run anticlockwise.
double Cross2(const double* a, const double* b, const double* p)
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

double Distance2(const double* a, const double* b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// A triangle in the plane whose corners run anticlockwise. Sines below `leastSine` count as zero.
class EarTriangle
{
public:
  EarTriangle(const double* a, const double* b, const double* c, double leastSine)
    : Sides{ { a, b, Distance2(a, b) }, { b, c, Distance2(b, c) }, { c, a, Distance2(c, a) } }
    , LeastSine(leastSine)
  {
  }
  /// Whether the point is neither outside nor at the same place as a corner: where two parts of the
  /// polygon touch (a bridge to a hole) points coincide.
  bool Contains(const double* point) const
  {
    for (const Side& side : this->Sides)
    {
      const double toPoint2 = Distance2(side.From, point);
      if (toPoint2 == 0. ||
        -Cross2(side.From, side.To, point) > this->LeastSine * std::sqrt(side.Length2 * toPoint2))
      {
        return false;
      }
    }
    return true;
  }

private:
  struct Side
  {
    const double* From;
    const double* To;
    double Length2;
  };

  Side Sides[3];
  double LeastSine;
};

/// Moves the points to the origin and to size 1, so that no product overflows, however large they
/// are.
void Normalize(std::vector<Vector3>& points)
{
  // Scaling comes first, because the difference of two huge coordinates may overflow. The second
  // pass scales the differences.
  for (int pass = 0; pass < 2; ++pass)
  {
    double largest = 0;
    for (const Vector3& p : points)
    {
      largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    }
    const Vector3 origin = pass == 0 ? points[0] : Vector3{};
    for (Vector3& p : points)
    {
      for (int i = 0; i < 3 && largest > 0; ++i)
      {
        p[i] = p[i] / largest - origin[i] / largest;
      }
    }
  }
}

/// Newell's: the sum of the cross products around the loop, as long as twice the enclosed area.
Vector3 MeanNormal(const std::vector<Vector3>& points)
{
  Vector3 normal{};
  for (size_t i = 0; i < points.size(); ++i)
  {
    const Vector3 c = Cross(points[i], points[(i + 1) % points.size()]);
    for (int k = 0; k < 3; ++k)
    {
      normal[k] += c[k];
    }
  }
  return normal;
}

/// Where the loop encloses no area: any plane that shows it as wide as possible.
Vector3 WidestNormal(const std::vector<Vector3>& points, double leastSine)
{
  const auto longest = std::max_element(points.begin(), points.end(),
    [](const Vector3& a, const Vector3& b) { return Dot(a, a) < Dot(b, b); });
  Vector3 normal{};
  for (const Vector3& p : points)
  {
    const Vector3 c = Cross(*longest, p);
    if (Dot(c, c) > Dot(normal, normal))
    {
      normal = c;
    }
  }
  if (Dot(normal, normal) < leastSine * leastSine)
  {
    // All points lie on one line: take a plane that contains it, spanned by the line and the
    // coordinate axis that it follows least.
    Vector3 axis{};
    const auto& d = *longest;
    const auto least = std::min_element(
      d.begin(), d.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    axis[static_cast<size_t>(least - d.begin())] = 1;
    normal = Cross(d, axis);
  }
  return Dot(normal, normal) > 0 ? normal : Vector3{ 0, 0, 1 };
}

}

PolygonEars::PolygonEars(vtkPoints* points, const PointOrder& order)
  : Points(points)
  , Order(order)
{
  // In double precision a sine, which is not squared, can be told from 0 before lengths can be told
  // from each other.
  const bool isSingle = points && points->GetDataType() == VTK_FLOAT;
  this->Tie = isSingle ? SingleTie : DoubleTie;
  this->LeastSine = isSingle ? SingleTie : DoubleTie / 10.;
}

bool PolygonEars::IsBeyond(double cross, double length2a, double length2b, double sign) const
{
  return sign * cross > this->LeastSine * std::sqrt(length2a * length2b);
}

const std::vector<std::array<vtkIdType, 3>>& PolygonEars::Cut(const vtkIdType* loop, vtkIdType size)
{
  this->Triangles.clear();
  this->Project(loop, size);
  if (size > MostCorners && this->CutByVTK())
  {
    return this->Triangles;
  }
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Examine(i);
  }
  vtkIdType start = 0;
  for (vtkIdType left = size; left > 2; --left)
  {
    vtkIdType tip = left == 3 ? this->Corners[start].Next : this->FindBestEar(start);
    if (tip < 0)
    {
      tip = this->FindLeastHarm(start);
    }
    const Corner& corner = this->Corners[tip];
    Corner& previous = this->Corners[corner.Previous];
    Corner& next = this->Corners[corner.Next];
    this->Triangles.push_back({ previous.Id, corner.Id, next.Id });
    previous.Next = corner.Next;
    next.Previous = corner.Previous;
    start = corner.Previous;
    this->Examine(corner.Previous);
    this->Examine(corner.Next);
  }
  return this->Triangles;
}

/// Cuts the polygon, projected, by vtkPolygon. Returns whether that found all triangles.
bool PolygonEars::CutByVTK()
{
  const auto size = static_cast<vtkIdType>(this->Corners.size());
  vtkNew<vtkPolygon> polygon;
  polygon->GetPoints()->SetNumberOfPoints(size);
  polygon->GetPointIds()->SetNumberOfIds(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    polygon->GetPoints()->SetPoint(i, this->Corners[i].X[0], this->Corners[i].X[1], 0.);
    polygon->GetPointIds()->SetId(i, i);
  }
  vtkNew<vtkIdList> corners;
  vtkNew<vtkPoints> places;
  const bool isCut =
    polygon->Triangulate(0, corners, places) != 0 && corners->GetNumberOfIds() == 3 * (size - 2);
  for (vtkIdType i = 0; isCut && i < 3 * (size - 2); i += 3)
  {
    const auto idOf = [&](vtkIdType k) { return this->Corners[corners->GetId(k)].Id; };
    this->Triangles.push_back({ idOf(i), idOf(i + 1), idOf(i + 2) });
  }
  return isCut;
}

void PolygonEars::Project(const vtkIdType* loop, vtkIdType size)
{
  this->Loop.resize(static_cast<size_t>(size));
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Points->GetPoint(loop[i], this->Loop[i].data());
  }
  Normalize(this->Loop);
  Vector3 normal = MeanNormal(this->Loop);
  if (Dot(normal, normal) < this->LeastSine * this->LeastSine)
  {
    normal = WidestNormal(this->Loop, this->LeastSine);
  }
  Scale(normal, 1 / std::sqrt(Dot(normal, normal)));
  Vector3 axis{};
  const auto least = std::min_element(
    normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  axis[static_cast<size_t>(least - normal.begin())] = 1;
  Vector3 u = Cross(axis, normal);
  Scale(u, 1 / std::sqrt(Dot(u, u)));
  const Vector3 v = Cross(normal, u);

  this->Corners.resize(static_cast<size_t>(size));
  for (vtkIdType i = 0; i < size; ++i)
  {
    Corner& corner = this->Corners[i];
    corner.X[0] = Dot(this->Loop[i], u);
    corner.X[1] = Dot(this->Loop[i], v);
    corner.Id = loop[i];
    corner.Next = (i + 1) % size;
    corner.Previous = (i + size - 1) % size;
  }
}

/// Whether the corner bends outwards (sign 1) or inwards (-1).
bool PolygonEars::Bends(const Corner& corner, double sign) const
{
  const double* a = this->Corners[corner.Previous].X;
  const double* b = this->Corners[corner.Next].X;
  return IsBeyond(Cross2(a, corner.X, b), Distance2(a, corner.X), Distance2(corner.X, b), sign);
}

void PolygonEars::Examine(vtkIdType tip)
{
  Corner& corner = this->Corners[tip];
  corner.Diagonal2 = Distance2(this->Corners[corner.Previous].X, this->Corners[corner.Next].X);
  corner.IsEar = this->Bends(corner, 1) && this->IsFree(tip);
}

/// Whether no other corner is in the triangle that cutting the corner off would make.
bool PolygonEars::IsFree(vtkIdType tip) const
{
  const Corner& corner = this->Corners[tip];
  const EarTriangle triangle(
    this->Corners[corner.Previous].X, corner.X, this->Corners[corner.Next].X, this->LeastSine);
  vtkIdType other = this->Corners[corner.Next].Next;
  for (; other != corner.Previous; other = this->Corners[other].Next)
  {
    if (triangle.Contains(this->Corners[other].X))
    {
      return false;
    }
  }
  return true;
}

vtkIdType PolygonEars::FindBestEar(vtkIdType start) const
{
  double shortest = -1;
  vtkIdType i = start;
  do
  {
    const Corner& corner = this->Corners[i];
    if (corner.IsEar && (shortest < 0 || corner.Diagonal2 < shortest))
    {
      shortest = corner.Diagonal2;
    }
    i = corner.Next;
  } while (i != start);
  vtkIdType best = -1;
  do
  {
    const Corner& corner = this->Corners[i];
    if (corner.IsEar && corner.Diagonal2 <= shortest * (1 + 2 * this->Tie) &&
      (best < 0 || this->Precedes(i, best)))
    {
      best = i;
    }
    i = corner.Next;
  } while (i != start);
  return best;
}

vtkIdType PolygonEars::FindLeastHarm(vtkIdType start) const
{
  vtkIdType best = -1;
  bool bestBends = true;
  vtkIdType i = start;
  do
  {
    const Corner& corner = this->Corners[i];
    const bool bends = this->Bends(corner, -1);
    if (best < 0 || (bestBends && !bends) || (bestBends == bends && this->Precedes(i, best)))
    {
      best = i;
      bestBends = bends;
    }
    i = corner.Next;
  } while (i != start);
  return best;
}

}
