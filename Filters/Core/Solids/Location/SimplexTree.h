// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplexTree.h
 * Which simplex holds a point, or is nearest to it: a tree of boxes over simplices in the order of
 * a space-filling curve.
 *
 * Several threads may build and ask the tree; the answers do not depend on their number. If several
 * simplices hold the point, or are equally near, the answer is the one with the smallest index.
 */
#ifndef SubdivisionObjects_SimplexTree_h
#define SubdivisionObjects_SimplexTree_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"

#include <functional>
#include <vector>

namespace subdivision
{

/// A place in a simplex: its index and the weights of its corners, which sum to 1.
struct PlaceInSimplex
{
  vtkIdType Simplex = -1;
  double Weights[4] = { 0., 0., 0., 0. };
};

/// Weights up to these below 0 are taken for 0. A point that no tetrahedron holds by the first is
/// searched by the second, which is not smaller. They are up to 1e-4.
struct HoldTolerances
{
  double Tight;
  double Loose;
};

class SimplexTree
{
public:
  SimplexTree() = default;
  /// `corners` ids for each simplex: 4, 1 for points, or 3 for triangles, lines and vertices, whose
  /// last corners are repeated. Points and ids must outlive the tree, and points be finite where
  /// simplices use them.
  SimplexTree(const double* points, int corners, const Buffer<int>& ids);

  vtkIdType GetNumberOfSimplices() const { return this->Order.size(); }
  const int* GetCorners(vtkIdType simplex) const { return this->Ids + simplex * this->Corners; }

  /// For each of points that are near each other: the first of the tetrahedra that hold it, and the
  /// place in it. A tetrahedron is looked at once for all of them.
  static constexpr int MostAtOnce = 32;
  void FindHolding(const double (*points)[3], int size, const HoldTolerances& tolerances,
    PlaceInSimplex* places) const;
  /// Points in these are near each other: the numbers of [0, size) along a curve through the box of
  /// all simplices.
  Buffer<vtkIdType> SortPoints(
    vtkIdType size, const std::function<void(vtkIdType i, double x[3])>& getPoint) const;
  /// The first of the nearest simplices, the nearest place in it and the squared distance.
  bool FindNearest(const double x[3], PlaceInSimplex& place, double& distance2) const;
  /// Calls visit(simplex) for all simplices in boxes for which meets(box) holds, and for others
  /// beside them.
  template <typename Meets, typename Visit>
  void ForEachWhere(const Meets& meets, const Visit& visit) const
  {
    if (!this->Levels.empty())
    {
      this->VisitWhere(this->Levels.size() - 1, 0, meets, visit);
    }
  }

private:
  template <typename Meets, typename Visit>
  void VisitWhere(std::size_t level, vtkIdType node, const Meets& meets, const Visit& visit) const
  {
    if (!meets(this->Levels[level][node]))
    {
      return;
    }
    const vtkIdType below = level > 0 ? this->Levels[level - 1].size() : this->Order.size();
    for (vtkIdType i = node * Width; i < std::min(below, (node + 1) * Width); ++i)
    {
      if (level > 0)
      {
        this->VisitWhere(level - 1, i, meets, visit);
      }
      else
      {
        visit(this->Order[i]);
      }
    }
  }

  struct Nearest;
  void Sort(vtkIdType size);
  void MakeBoxes();
  void MakeSlabs();
  Box GetBox(vtkIdType simplex) const;
  void GetPoints(vtkIdType simplex, const double* corners[4]) const;
  void Visit(std::size_t level, vtkIdType node, Nearest& nearest) const;
  static double GetDistance2(const Box& box, const double x[3]);

  /// Two parallel planes between which all triangles of a node lie. Far from a surface a point has
  /// nearly the same distance from many boxes, but not from such planes.
  struct Slab
  {
    double Normal[3];
    double Corner[3]; ///< from which heights count
    double Low;
    double High;
    double GetDistance(const double x[3]) const; ///< at most the distance of a triangle between
  };
  Slab MakeSlab(vtkIdType begin, vtkIdType end) const;
  double GetLeastDistance2(std::size_t level, vtkIdType node, const double x[3]) const;

  static constexpr std::size_t LevelsWithSlabs = 5; ///< beyond these, nodes are not flat
  static constexpr vtkIdType Width = 4;             ///< children of a node, simplices of a leaf

  const double* Points = nullptr;
  int Corners = 4;
  const int* Ids = nullptr;
  Buffer<vtkIdType> Order;         ///< simplices along the curve
  std::vector<Buffer<Box>> Levels; ///< boxes of Width simplices each, then of Width boxes of the
                                   ///< level before each; the last level has one
  std::vector<Buffer<Slab>> Slabs; ///< of the first levels, for triangles
};

}

#endif
