// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/PatchShape.h"

#include "Core/Solids/Limits/PlacePolynomial.h"

#include "vtkCellType.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Multiples along the axes as weights of the corners of a simplex, the first corner last.
using CornerMultiples = std::array<int, 4>;

CornerMultiples ToCorners(const LatticePoint& point, int all)
{
  return { { point[0], point[1], point[2], all - point[0] - point[1] - point[2] } };
}

/// Where a line of `degree` has its nodes, out of 4 or 8 divisions: symmetric, with both ends.
int GetNodeOfLine(int degree, int i)
{
  constexpr int cubic[4] = { 0, 1, 3, 4 };
  constexpr int quintic[6] = { 0, 1, 3, 5, 7, 8 };
  return degree == 3 ? cubic[i] : degree == 5 ? quintic[i] : i;
}

/// The same for one corner of a simplex, whose control point has these multiples. Inside faces and
/// tetrahedra of degree 5 the nodes are the points near (3, 1, 1), (2, 2, 1) and (2, 1, 1, 1) / 5.
int GetNodeOfCorner(int degree, const CornerMultiples& multiples, int corner)
{
  const int multiple = multiples[corner];
  const auto zeros = std::count(multiples.begin(), multiples.end(), 0);
  if (degree != 5 || zeros >= 2 || multiple == 0)
  {
    return GetNodeOfLine(degree, multiple);
  }
  const int largest = *std::max_element(multiples.begin(), multiples.end());
  if (zeros == 0)
  {
    return multiple == largest ? 5 : 1;
  }
  return largest == 3 ? (multiple == 3 ? 6 : 1) : (multiple == 2 ? 3 : 2);
}

double ComputeFactorial(int n)
{
  return std::tgamma(n + 1.);
}

/// The Bernstein polynomial of these multiples where corners have `weights`.
double Evaluate(const CornerMultiples& multiples, const std::array<double, 4>& weights)
{
  double value = 1.;
  int degree = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    value *= std::pow(weights[corner], multiples[corner]) / ComputeFactorial(multiples[corner]);
    degree += multiples[corner];
  }
  return value * ComputeFactorial(degree);
}

double EvaluateOnLine(int degree, int i, double at)
{
  return Evaluate({ { i, 0, 0, degree - i } }, { { at, 0., 0., 1. - at } });
}

/// A shape while it is made.
class ShapeMaker
{
public:
  ShapeMaker(int dimension, int corners, int degree, int levels, int type)
    : IsQuad(dimension == 2 && corners == 4)
    , Degree(degree)
  {
    this->Shape.Dimension = dimension;
    this->Shape.Corners = corners;
    this->Shape.Degree = degree;
    this->Shape.CellType = type;
    this->Shape.SampleLevels = levels;
    this->Shape.Divisions = 1 << levels;
  }
  PatchShape Make()
  {
    this->ListControlPoints();
    this->Invert();
    this->ListChecks();
    this->ListChildren();
    return std::move(this->Shape);
  }

private:
  /// act(point) for all points of the lattice.
  template <typename Act>
  void ForLattice(int divisions, const Act& act) const
  {
    const int last[3] = { divisions, this->Shape.Dimension > 1 ? divisions : 0,
      this->Shape.Dimension > 2 ? divisions : 0 };
    for (int k = 0; k <= last[2]; ++k)
    {
      for (int j = 0; j <= last[1]; ++j)
      {
        for (int i = 0; i <= last[0]; ++i)
        {
          if (this->IsQuad || i + j + k <= divisions)
          {
            act(LatticePoint{ { i, j, k } });
          }
        }
      }
    }
  }
  /// VTK's number of a control point.
  vtkIdType Number(const LatticePoint& control) const
  {
    const CornerMultiples multiples = ToCorners(control, this->Degree);
    if (this->IsQuad)
    {
      const int degrees[2] = { this->Degree, this->Degree };
      return vtkHigherOrderQuadrilateral::PointIndexFromIJK(control[0], control[1], degrees);
    }
    switch (this->Shape.Dimension)
    {
      case 1:
        return control[0] == 0 ? 0 : control[0] == this->Degree ? 1 : control[0] + 1;
      case 2:
      {
        const vtkIdType index[3] = { multiples[0], multiples[1], multiples[3] };
        return vtkHigherOrderTriangle::Index(index, this->Degree);
      }
      default:
      {
        const vtkIdType index[4] = { multiples[0], multiples[1], multiples[2], multiples[3] };
        return vtkHigherOrderTetra::Index(index, this->Degree);
      }
    }
  }
  LatticePoint GetNode(const LatticePoint& control) const
  {
    LatticePoint node{ { 0, 0, 0 } };
    const CornerMultiples multiples = ToCorners(control, this->Degree);
    for (int axis = 0; axis < this->Shape.Dimension; ++axis)
    {
      node[axis] = this->IsQuad ? GetNodeOfLine(this->Degree, control[axis])
                                : GetNodeOfCorner(this->Degree, multiples, axis);
    }
    return node;
  }
  /// A Bernstein polynomial at a point of a lattice.
  double EvaluateAt(const LatticePoint& control, const LatticePoint& point, double divisions) const
  {
    const double x = point[0] / divisions;
    const double y = point[1] / divisions;
    const double z = point[2] / divisions;
    return this->IsQuad
      ? EvaluateOnLine(this->Degree, control[0], x) * EvaluateOnLine(this->Degree, control[1], y)
      : Evaluate(ToCorners(control, this->Degree), { { x, y, z, 1. - x - y - z } });
  }
  void ListControlPoints()
  {
    this->ForLattice(this->Degree, [this](const LatticePoint&) { this->Controls.emplace_back(); });
    this->Shape.Nodes.resize(this->Controls.size());
    this->ForLattice(this->Degree,
      [this](const LatticePoint& control)
      {
        const auto number = static_cast<std::size_t>(this->Number(control));
        this->Controls[number] = control;
        this->Shape.Nodes[number] = this->GetNode(control);
      });
  }
  void Invert();
  void ListChecks();
  void ListChildren();

  const bool IsQuad;
  const int Degree;
  PatchShape Shape;
  std::vector<LatticePoint> Controls;
};

/// The weights of nodes are the inverse of the matrix of the polynomials there.
void ShapeMaker::Invert()
{
  const std::size_t size = this->Controls.size();
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size));
  this->Shape.Weights = matrix;
  std::vector<double*> rows;
  std::vector<double*> inverse;
  for (std::size_t node = 0; node < size; ++node)
  {
    for (std::size_t c = 0; c < size; ++c)
    {
      matrix[node][c] = this->EvaluateAt(
        this->Controls[c], this->Shape.Nodes[node], static_cast<double>(this->Shape.Divisions));
    }
    rows.push_back(matrix[node].data());
    inverse.push_back(this->Shape.Weights[node].data());
  }
  vtkMath::InvertMatrix(rows.data(), inverse.data(), static_cast<int>(size));
  for (auto& weights : this->Shape.Weights)
  {
    for (double& weight : weights)
    {
      weight =
        std::abs(weight) < 1e-13 ? 0. : weight; // nodes elsewhere; others are multiples of 1e-4
    }
  }
}

void ShapeMaker::ListChecks()
{
  const int divisions = 2 * this->Shape.Divisions;
  this->ForLattice(divisions,
    [&](const LatticePoint& point)
    {
      std::vector<double> weights(this->Controls.size());
      for (std::size_t c = 0; c < weights.size(); ++c)
      {
        const double basis =
          this->EvaluateAt(this->Controls[c], point, static_cast<double>(divisions));
        for (std::size_t node = 0; node < weights.size(); ++node)
        {
          weights[node] += basis * this->Shape.Weights[c][node];
        }
      }
      this->Shape.Checked.push_back(point);
      this->Shape.CheckWeights.push_back(std::move(weights));
    });
}

/// Children as steps write them: simplices by Simplices.h, the child of a quad at corner c with
/// that corner, the middle of the edge behind it, the centre, and the middle of the edge before.
void ShapeMaker::ListChildren()
{
  std::vector<LatticePoint>& corners = this->Shape.CornerPoints;
  corners.push_back({ { 0, 0, 0 } });
  if (this->IsQuad)
  {
    corners.insert(corners.end(), { { { 2, 0, 0 } }, { { 2, 2, 0 } }, { { 0, 2, 0 } } });
  }
  else
  {
    for (int axis = 0; axis < this->Shape.Dimension; ++axis)
    {
      corners.push_back({ { 0, 0, 0 } });
      corners.back()[axis] = 2;
    }
  }
  const auto middle = [&corners](int a, int b)
  {
    LatticePoint point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = (corners[a][axis] + corners[b][axis]) / 2;
    }
    return point;
  };
  const auto add = [this](const LatticePoint& origin, const std::vector<LatticePoint>& ends)
  {
    LatticePart child;
    child.Origin = origin;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        child.Axes[i][axis] = ends[i][axis] - origin[axis];
      }
    }
    this->Shape.Children.push_back(child);
  };
  if (this->IsQuad)
  {
    for (int c = 0; c < 4; ++c)
    {
      add(corners[c], { middle(c, (c + 1) % 4), middle(c, (c + 3) % 4) });
    }
    return;
  }
  for (const SimplexChild& child : subdivision::ListChildren(this->Shape.Dimension))
  {
    std::vector<LatticePoint> points;
    for (int i = 0; i <= this->Shape.Dimension; ++i)
    {
      points.push_back(middle(child.Corners[i][0], child.Corners[i][1]));
    }
    add(points[0], { points.begin() + 1, points.end() });
  }
}

}

LatticePoint LatticePart::At(const LatticePoint& point, int divisions) const
{
  LatticePoint at = this->Origin;
  for (int axis = 0; axis < 3; ++axis)
  {
    at[axis] += (point[0] * this->Axes[0][axis] + point[1] * this->Axes[1][axis] +
                  point[2] * this->Axes[2][axis]) /
      divisions;
  }
  return at;
}

LatticePart LatticePart::Take(const LatticePart& child, int divisions) const
{
  LatticePart part;
  part.Origin = this->At(child.Origin, divisions);
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      part.Axes[i][axis] =
        (child.Axes[i][0] * this->Axes[0][axis] + child.Axes[i][1] * this->Axes[1][axis] +
          child.Axes[i][2] * this->Axes[2][axis]) /
        divisions;
    }
  }
  return part;
}

const PatchShape& PatchShape::Get(Kind kind)
{
  static const std::array<PatchShape, NumberOfKinds> shapes{ {
    ShapeMaker(1, 2, 3, 2, VTK_BEZIER_CURVE).Make(),
    ShapeMaker(2, 3, 4, 2, VTK_BEZIER_TRIANGLE).Make(),
    ShapeMaker(2, 4, 3, 2, VTK_BEZIER_QUADRILATERAL).Make(),
    ShapeMaker(3, 4, 5, 3, VTK_BEZIER_TETRAHEDRON).Make(),
  } };
  return shapes[kind];
}

const PatchShape& PatchShape::Get(Kind kind, int degree)
{
  static const std::array<PatchShape, 3> raised{ {
    ShapeMaker(1, 2, 4, 2, VTK_BEZIER_CURVE).Make(),
    ShapeMaker(1, 2, 5, 3, VTK_BEZIER_CURVE).Make(),
    ShapeMaker(2, 3, 5, 3, VTK_BEZIER_TRIANGLE).Make(),
  } };
  const PatchShape& least = Get(kind);
  return degree <= least.Degree ? least : raised[kind == Triangle ? 2 : degree - 4];
}

}
