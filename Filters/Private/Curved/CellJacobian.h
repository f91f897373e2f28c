// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellJacobian.h
 * Proves that a curved solid is nowhere inside out.
 *
 * The determinant of the Jacobian is a polynomial in the parameters. Its Bernstein coefficients are
 * bounds on its values, which come as near as is wanted where the cell is halved (Johnen, Remacle,
 * Geuzaine: Geometrical validity of curvilinear finite elements, 2013). No values are sampled: the
 * determinant is a sum of products of polynomials in the weights of the corners.
 */
#ifndef SubdivisionObjects_CellJacobian_h
#define SubdivisionObjects_CellJacobian_h

#include "Private/Curved/CurvedShapes.h"

#include <array>
#include <vector>

namespace subdivision
{

/// Polynomials over a solid, whose parameters are those of one simplex (tetrahedra), of a triangle
/// and a line (wedges) or of three lines (hexahedra and, before one side becomes the apex,
/// pyramids). A term is the exponents of the three parameters; the first weight of its simplex has
/// what is left of the degree. A polynomial is the coefficients of its terms, in their order.
class CellJacobian
{
public:
  explicit CellJacobian(const CurvedShape& shape);

  struct Bound
  {
    bool IsValid;  ///< the determinant is positive everywhere; of a wedge, or negative everywhere
    double Scaled; ///< a lower bound on the determinant, divided by its mean; at least -1
  };

  /// So many cells are looked at side by side: their coefficients are lanes of the same registers.
  static constexpr int Lanes = 4;
  struct Workspace;

  /// Makes room for cells of this shape.
  void Start(Workspace& work) const;
  /// The bounds of the first `cells` lanes, whose nodes Workspace::Set has set.
  void Find(Workspace& work, int cells, Bound* bounds) const;
  /// The bound of one cell, by the coordinates of each node.
  Bound Find(const double* nodes) const;

private:
  struct Term
  {
    std::array<int, 3> Exponents;
    std::array<int, 3> Firsts; ///< of the first weight of the simplex of each parameter
    int Place;                 ///< of a product it is the sum of places
    double Multinomial;        ///< monomials have this times the Bernstein coefficient
  };
  using Terms = std::vector<Term>;
  using Degrees = std::array<int, 3>; ///< of the simplex of each parameter
  /// A sparse matrix: the coefficient `To` gets `Factor` times `From`.
  struct Entry
  {
    int From;
    int To;
    double Factor;
  };
  using Entries = std::vector<Entry>;
  /// The lines of terms along an edge: so many of one length at a time, side by side.
  struct Lines
  {
    std::vector<int> Sizes;
    std::vector<int> Terms;
  };
  struct Part;

  Terms ListTerms(const Degrees& degrees) const;
  std::vector<int> NumberPlaces(const Terms& terms) const;
  void FindValues(const CurvedShape& shape);
  void FindSlopes(const std::array<Degrees, 3>& degrees);
  void FindLines();
  static int GetLines(int from, int to) { return 3 * (from + 1) + to; }
  void FindDeterminants(Workspace& work) const;
  void FindLongestEdge(const Part& part, int& from, int& to) const;
  int Halve(Workspace& work, int part) const;
  double Look(const Workspace& work, int part, double& known) const;
  double Search(Workspace& work, int lane, double least, double known, double rounding) const;

  std::array<int, 3> Simplex{ { 0, 1, 2 } }; ///< of each parameter
  int Order;
  bool IsPyramid;
  int Nodes;
  std::array<int, 3> Strides{};
  int Size = 0; ///< of the places
  Terms Values;
  Terms Determinant;
  std::array<std::vector<int>, 3> SlopePlaces; ///< of the terms of the slope by each parameter
  std::array<int, 3> SlopeStarts{};
  std::vector<int> CrossPlaces;
  std::vector<int> CrossTerms; ///< which term has a place
  std::vector<int> DeterminantTerms;
  std::vector<double> Divisors; ///< of the terms of the determinant
  std::vector<int> Corners;     ///< terms of the determinant whose coefficients are values
  Entries ToValues;             ///< from nodes
  Entries ToSlopes;             ///< from there
  std::array<Lines, 12> LinesOfEdges;
};

/// A part of the cell: its Bernstein coefficients, and where its corners are: of each parameter the
/// corner that its simplex begins with, and the one with that parameter.
struct CellJacobian::Part
{
  std::array<std::array<double, 3>, 3> Firsts{};
  std::array<std::array<double, 3>, 3> Corners{ { { { 1., 0., 0. } }, { { 0., 1., 0. } },
    { { 0., 0., 1. } } } };
  double Least = 0.;
};

/// What a search works in. A thread keeps one, so that it allocates nothing for a cell.
struct CellJacobian::Workspace
{
  void Set(int lane, int node, const double* point)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Nodes[(3 * node + k) * Lanes + lane] = point[k];
    }
  }

  /// Coefficients with three components each, in lanes; of the determinant with one.
  std::vector<double> Nodes;
  std::vector<double> Values;
  std::vector<double> Slopes;
  std::vector<double> Cross;
  std::vector<double> Determinant;
  std::vector<Part> Parts; ///< of one cell
  std::vector<double> Coefficients;
  std::vector<int> Heap; ///< of parts, least on top
  std::vector<double> Line;
};

}

#endif
