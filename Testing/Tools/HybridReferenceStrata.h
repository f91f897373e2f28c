// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridReferenceStrata.h
 * Which rule each vertex, edge and quad of a mesh of all cell types follows, by links as sets.
 */
#ifndef SubdivisionObjects_HybridReferenceStrata_h
#define SubdivisionObjects_HybridReferenceStrata_h

#include "HybridReferenceCells.h"

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace hybridtest
{

using Point = std::array<double, 3>;

/// How vertices, edges and quads follow at which the complex is no manifold.
enum class Joints
{
  Blend,
  Sharp
};

struct Mesh
{
  std::vector<Point> Points;
  std::vector<Cell> Cells;
  /// Sorted vertices, edges and faces that are infinitely sharp.
  std::set<Ids> Singular;
  /// For how many steps sorted edges and faces stay sharp.
  std::map<Ids, double> Sharpness;
  Joints Joint = Joints::Blend;
  bool HasDarts = false;       ///< single creases end as if they were not there
  bool HasLoopWeights = false; ///< those of Loop's thesis
  /// Of points that a step made on curves, or left there: their neighbours. Sharp joints need them,
  /// because sharp edges inside a face of three cells also end there.
  std::map<int, Ids> Curves;
};

/// What stands at sorted vertices, edges, faces and cells.
class Complex
{
public:
  explicit Complex(const Mesh& mesh);

  /// Sides of maximal cells of dimension k, by their own dimension and sorted corners.
  const std::map<Ids, Cell>& GetSides(int dimension) const { return this->Known[dimension]; }
  /// Whether a cell is neither a side of another one nor equal to one before it.
  const std::vector<bool>& GetMaximal() const { return this->Maximal; }
  /// Maximal cells of dimension k at a side.
  std::vector<Cell> CellsAt(const Ids& side, int k) const;
  /// Sides of these cells of one dimension that have the given side.
  static std::vector<Cell> SidesAt(
    const std::vector<Cell>& cells, const Ids& side, int dimensionOfSide, int dimension);

private:
  const Mesh& Given;
  std::map<Ids, Cell> Known[4];
  std::map<int, std::vector<std::size_t>> AtVertex;
  std::vector<bool> Maximal;
};

/// What a new point is: (1 - Weight) (mean along the lines, or its linear place) + Weight (mean of
/// centroids of the fine cells in Parts); of a joint that blends, a row of its own.
struct Stratum
{
  int Dimension = 0;
  bool Blends = false;
  std::vector<Cell> Parts;
  std::vector<Cell> Along;
  double Weight = 1.;
};

/// Strata by links, anew in each level: but for curves at sharp joints they are what children
/// inherit, because a split changes no link.
class Strata
{
public:
  Strata(const Mesh& mesh, const Complex& complex);

  Stratum OfVertex(int vertex) const;
  Stratum OfEdge(const Ids& edge) const;
  Stratum OfQuad(const Ids& quad) const;

private:
  enum class Place
  {
    Interior,
    Boundary,
    Joint
  };

  Place PlaceOf(const Ids& side, int dimensionOfSide, int k) const;
  Place PlaceInSolids(int vertex) const;
  std::vector<int> DimensionsAt(const Ids& side) const;
  bool IsJoint(const Ids& side, int dimensionOfSide) const;
  std::vector<Cell> FacesAt(const Ids& side, int dimensionOfSide) const;
  std::vector<Cell> EdgesAt(int vertex) const;
  std::vector<Cell> SingularFacesAt(const Ids& side, int dimensionOfSide) const;
  std::vector<Cell> BoundaryFacesAt(const Ids& side, int dimensionOfSide) const;
  bool IsSingularFace(const Ids& face) const;
  bool IsCrease(const Ids& edge) const;
  bool IsDart(int vertex) const;
  Stratum InSurface(const std::vector<Cell>& faces) const;
  Stratum AtJoint(int vertex) const;
  Stratum InSolids(int vertex) const;

  const Mesh& Given;
  const Complex& Whole;
};

/// How strongly the mean of q quads (or hexahedra) and t triangles (or wedges) draws.
double Relaxation(int q, int t, bool hasLoopWeights);

}

#endif
