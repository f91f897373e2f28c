// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelBuilder.h
 * Builds control meshes from points, simplices, and hexahedra that are split conformingly.
 */
#ifndef SubdivisionObjects_ModelBuilder_h
#define SubdivisionObjects_ModelBuilder_h

#include "vtkType.h"

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

class vtkUnstructuredGrid;

namespace subdivision
{

class ModelBuilder
{
public:
  using Vector = std::array<double, 3>;
  using Ids = std::vector<vtkIdType>;

  enum Flag
  {
    SMOOTH = 0,
    SINGULAR = 1
  };

  /// The value of Tension at every point that is added from now on.
  std::function<double(const Vector&)> Tension = [](const Vector&) { return 0.0; };

  /// The MaterialId of every cell that is added from now on.
  int Material = 0;

  ///@{
  /// Add points. Coordinates and tensions are rounded to four decimals, so that a model has the
  /// same bits on every machine and after it was written to a text file.
  vtkIdType Point(const Vector& x);
  vtkIdType Point(double x, double y, double z) { return this->Point(Vector{ x, y, z }); }
  ///@}

  /// `n` points (n even) of a horizontal circle around the z axis, by rising angle. The even ones
  /// are numbered first, so that the diagonals of the walls between two rings zigzag symmetrically.
  Ids Ring(int n, double radius, double z, double phaseInDegrees = 0.0);

  ///@{
  /// Add one simplex.
  void Vertex(vtkIdType a, Flag flag = SMOOTH);
  void Line(vtkIdType a, vtkIdType b, Flag flag = SMOOTH);
  void Triangle(vtkIdType a, vtkIdType b, vtkIdType c, Flag flag = SMOOTH);
  void Tetrahedron(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d); ///< turned positive
  ///@}

  /// The lines between consecutive points.
  void Polyline(const Ids& ids, Flag flag = SMOOTH, bool closed = false);

  /// Two triangles of a free surface: the shorter diagonal, in a tie the one through the smallest
  /// id.
  void Quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d);

  /// The triangles that a hexahedron has on this face: the diagonal through the smallest id.
  /// Repeated ids are collapsed.
  void SolidFace(const Ids& face, Flag flag = SMOOTH);

  /// Quads between two rows of equally many points, one row along the other.
  void Strip(const Ids& row, const Ids& next, bool closed = false);

  /// Triangles from `centre` to the consecutive points of `row`.
  void Fan(vtkIdType centre, const Ids& row, bool closed = false);

  /// A hexahedron, by its bottom and its top quad (as VTK_HEXAHEDRON), as tetrahedra around its
  /// smallest id, where every face is cut through its smallest id: neighbours conform. Corners may
  /// coincide: an edge collapsed gives a wedge and so on, as long as no face becomes a figure
  /// eight.
  void Hexahedron(const Ids& bottom, const Ids& top);

  /// Doubles the model: mirror images at the plane where coordinate `axis` is 0. Points and cells
  /// in the plane are their own images.
  void Mirror(int axis);

  /// Turns triangles, so that two that continue each other across an edge run along it in opposite
  /// directions: normals then have one side on each surface. The first triangle of a surface stays
  /// as it is. Triangles meet so in edges of no tetrahedron and no other triangle. Call it when all
  /// cells are there.
  void OrientTriangles();

  const Vector& operator[](vtkIdType id) const { return this->Points[id]; }

  /// The model as a grid, with Tension, MaterialId and Singular.
  void Write(vtkUnstructuredGrid* output, int dataTypeOfPoints) const;

private:
  struct Cell
  {
    int Size; // number of points: 1..4
    std::array<vtkIdType, 4> PointIds;
    int Material;
    int Singular;
  };

  std::vector<Vector> Points;
  std::vector<double> Tensions;
  std::vector<Cell> Cells;

  using Edge = std::pair<vtkIdType, vtkIdType>; // ascending

  void Add(const Ids& ids, Flag flag);
  /// The two triangles at each edge in which they continue each other.
  std::map<Edge, std::vector<std::size_t>> FindInnerEdges() const;
  static bool RunsAlong(const Cell& triangle, const Edge& edge);
  double SquaredLength(vtkIdType a, vtkIdType b) const;
  void WriteAttributes(vtkUnstructuredGrid* output) const;
};

}

#endif
