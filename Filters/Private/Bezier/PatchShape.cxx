// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/PatchShape.h"

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

CornerMultiples ToCorners(const FrameNode& point, int all)
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
            act(FrameNode{ { i, j, k } });
          }
        }
      }
    }
  }
  /// VTK's number of a control point.
  vtkIdType Number(const FrameNode& control) const
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
  FrameNode GetNode(const FrameNode& control) const
  {
    FrameNode node{ { 0, 0, 0 } };
    const CornerMultiples multiples = ToCorners(control, this->Degree);
    for (int axis = 0; axis < this->Shape.Dimension; ++axis)
    {
      node[axis] = this->IsQuad ? GetNodeOfLine(this->Degree, control[axis])
                                : GetNodeOfCorner(this->Degree, multiples, axis);
    }
    return node;
  }
  /// A Bernstein polynomial at a point of a lattice.
  double EvaluateAt(const FrameNode& control, const FrameNode& point, double divisions) const
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
    this->ForLattice(this->Degree, [this](const FrameNode&) { this->Controls.emplace_back(); });
    this->Shape.Nodes.resize(this->Controls.size());
    this->ForLattice(this->Degree,
      [this](const FrameNode& control)
      {
        const auto number = static_cast<std::size_t>(this->Number(control));
        this->Controls[number] = control;
        this->Shape.Nodes[number] = this->GetNode(control);
      });
  }
  /// The weights of nodes are the inverse of the matrix of the polynomials there.
  void Invert()
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
  void ListChecks()
  {
    const int divisions = 2 * this->Shape.Divisions;
    this->ForLattice(divisions,
      [&](const FrameNode& point)
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
  /// Children as steps write them.
  void ListChildren()
  {
    const CellShape shape = this->IsQuad ? CellShape::Quad
      : this->Shape.Dimension == 3       ? CellShape::Tet
                                         : static_cast<CellShape>(this->Shape.Dimension);
    const auto corners = GetCornerNodes(shape, 2);
    this->Shape.CornerPoints.assign(corners.begin(), corners.begin() + this->Shape.Corners);
    for (const LatticeCell& child : ListLatticeCells(shape, SplitOrder::Simplices, 1))
    {
      LatticePart part{ child.Corners[0], {} };
      for (int i = 0; i < this->Shape.Dimension; ++i)
      {
        const FrameNode& end = child.Corners[this->IsQuad ? 1 + 2 * i : 1 + i];
        for (int axis = 0; axis < 3; ++axis)
        {
          part.Axes[i][axis] = end[axis] - part.Origin[axis];
        }
      }
      this->Shape.Children.push_back(part);
    }
  }

  const bool IsQuad;
  const int Degree;
  PatchShape Shape;
  std::vector<FrameNode> Controls;
};

}

FrameNode LatticePart::At(const FrameNode& point, int divisions) const
{
  FrameNode at = this->Origin;
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
