// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FeatureTools.h
 * Rows of the subdivision matrix by impulse response, and rows by hand (Mathematics 5) to compare
 * with.
 */
#ifndef SubdivisionObjects_FeatureTools_h
#define SubdivisionObjects_FeatureTools_h

#include "MultiDimensionalSubdivisionTools.h"

namespace feature_tools
{

using namespace multi_dimensional_subdivision_tools;

using Filter = vtkMultiDimensionalSubdivision;
using Configure = std::function<void(Filter*)>;
/// A row of the matrix, without zeros.
using MatrixRow = std::map<vtkIdType, double>;

/// Runs the filter, which cuts all cells unless `configure` says otherwise; without `messages` it
/// may not say anything.
Grid Execute(
  vtkDataObject* input, int levels, const Configure& configure = {}, Messages* messages = nullptr);

/// One after the other.
Configure And(const Configure& a, const Configure& b);

/// A row that goes by this weight to the sharp one.
MatrixRow Blend(double weight, const MatrixRow& sharp, const MatrixRow& smooth);

inline void SetCellArray(vtkAlgorithm* filter, int index, const char* name)
{
  filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name);
}

template <typename Array = vtkIntArray>
void AddCellArray(vtkUnstructuredGrid* grid, const char* name, const std::vector<int>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (int value : values)
  {
    array->InsertNextTuple1(value);
  }
  grid->GetCellData()->AddArray(array);
}

/// The grid with one more cell array.
inline Grid With(vtkUnstructuredGrid* grid, const char* name, const std::vector<int>& values)
{
  const Grid copy = DeepCopy(grid);
  AddCellArray(copy, name, values);
  return copy;
}

/// Vertices and edges of cells, as sorted tuples.
std::set<std::pair<vtkIdType, vtkIdType>> GetEdges(vtkUnstructuredGrid* grid);

/// One step's matrix, by a one-hot array.
class Matrix
{
public:
  explicit Matrix(vtkUnstructuredGrid* input, const Configure& configure = {})
    : Matrix(input, configure, nullptr)
  {
  }
  Matrix(vtkUnstructuredGrid* input, const Configure& configure, Messages* messages);
  MatrixRow Vertex(vtkIdType v) const { return this->GetRow(v); }
  /// The row of an edge's point: the only new point that is joined to both ends.
  MatrixRow Edge(vtkIdType a, vtkIdType b) const;
  vtkUnstructuredGrid* GetOutput() const { return this->Output; }

private:
  MatrixRow GetRow(vtkIdType point) const;

  vtkIdType Size;
  Grid Output;
  std::set<std::pair<vtkIdType, vtkIdType>> Edges;
};

MatrixRow MakeRow(const Ids& own, double ownWeight, const Ids& ring, double ringWeight);

// Mathematics 5, by hand.
inline MatrixRow Corner(vtkIdType v)
{
  return { { v, 1. } };
}
inline MatrixRow CurveVertex(vtkIdType v, vtkIdType a, vtkIdType b)
{
  return { { v, 3. / 4 }, { a, 1. / 8 }, { b, 1. / 8 } };
}
inline MatrixRow SurfaceVertex(vtkIdType v, const Ids& ring)
{
  const double m = static_cast<double>(ring.size());
  const double c = ring.size() == 3 ? 3. / 16 : 3. / 8 / m;
  return MakeRow({ v }, 1. - m * c, ring, c);
}
inline MatrixRow SolidVertex(vtkIdType v, const Ids& ring)
{
  return MakeRow({ v }, 9. / 16, ring, 7. / 16 / static_cast<double>(ring.size()));
}
inline MatrixRow CurveEdge(vtkIdType a, vtkIdType b)
{
  return { { a, 1. / 2 }, { b, 1. / 2 } };
}
inline MatrixRow SurfaceEdge(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
  return { { a, 3. / 8 }, { b, 3. / 8 }, { c, 1. / 8 }, { d, 1. / 8 } };
}
inline MatrixRow SolidEdge(vtkIdType a, vtkIdType b, const Ids& ring)
{
  return MakeRow({ a, b }, 5. / 16, ring, 3. / 8 / static_cast<double>(ring.size()));
}

testing::AssertionResult Near(const MatrixRow& actual, const MatrixRow& expected);

// ------------------------------------------------------------------------------------------------
// The smallest complexes

/// Vertex 0 inside `n` triangles, not flat; cell i - 1 is (0, i, i + 1), ring 1 to n.
Grid MakeFan(int n, const std::vector<Cell>& more = {});

/// Eight tetrahedra around vertex 0; 1, 2 = +x, -x; 3, 4 = +y, -y; 5, 6 = +z, -z. The first four
/// cells are the upper ones, in turn between 1 3, 3 2, 2 4, 4 1; so are the others below.
Grid MakeOctahedron(const std::vector<Cell>& more = {});

/// `cells` after `before` cells that are not flagged, all flagged.
inline std::vector<int> FlagsAfter(int before, std::size_t flagged)
{
  std::vector<int> flags(before, 0);
  flags.insert(flags.end(), flagged, 1);
  return flags;
}

inline Grid MakeFlaggedFan(int n, const std::vector<Cell>& flagged)
{
  return With(MakeFan(n, flagged), "Singular", FlagsAfter(n, flagged.size()));
}

inline Grid MakeFlaggedOctahedron(const std::vector<Cell>& flagged)
{
  return With(MakeOctahedron(flagged), "Singular", FlagsAfter(8, flagged.size()));
}

/// n^3 cubes of six tetrahedra each (Kuhn), in [0, n]^3, moved a little by `noise` inside.
Grid MakeKuhnBox(int n, double noise = 0., unsigned seed = 1);

/// Level 3 of a Kuhn box by a volume scheme, two of whose tetrahedra are swapped. It has so many
/// cells that the sample by which stamps are checked does not have these. All children of the first
/// tetrahedron are flagged as singular, which solids cannot be.
Grid MakeSwappedLevel(int volumeScheme);

/// A random complex on `n` points: cells of all dimensions, joints of every type, followers, equal
/// cells; with arrays Singular, MaterialId, Part and Rule.
Grid MakeRandomComplex(unsigned seed, bool withSolids = true);

/// Options of every kind from bits of a random number.
Configure RandomOptions(unsigned seed);

}

#endif
