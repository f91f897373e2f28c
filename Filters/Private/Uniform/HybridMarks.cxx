// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridMarks.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <map>

namespace subdivision
{
namespace
{

/// The vertices, edges and faces of a mesh as simplices; of a quad all four triangles of three of
/// its corners. The cut of a marked quad is two of them, whichever diagonal it has.
template <typename Id>
SimplicesOfCells ListSimplices(const CellComplex<Id>& complex)
{
  SimplicesOfCells cells;
  SimplexList& list = cells.Simplices;
  list.NumberOfPoints = complex.NumberOfVertices;
  const auto add = [&list](std::initializer_list<Id> ids)
  {
    list.Dimensions.push_back(static_cast<unsigned char>(ids.size() - 1));
    list.Connectivity.insert(list.Connectivity.end(), ids.begin(), ids.end());
  };
  for (const Id v : InTurn(complex.NumberOfVertices))
  {
    add({ v });
  }
  for (const vtkIdType e : InTurn(vtkIdType(complex.NumberOfEdges)))
  {
    add({ complex.EdgeVertices[2 * e], complex.EdgeVertices[2 * e + 1] });
  }
  for (const Id f : InTurn(complex.NumberOfFaces))
  {
    const Id* v = complex.GetVertices(f).begin();
    const int size = complex.GetSize(f);
    for (int i = 0; i < (size == 4 ? 4 : 1); ++i)
    {
      add({ v[i], v[(i + 1) % size], v[(i + 2) % size] });
    }
  }
  return cells;
}

/// Triangles by their points, and how sharp they are; 0: not marked.
class MarkedTriangles
{
public:
  explicit MarkedTriangles(const SharpTuples& tuples)
  {
    const std::vector<vtkIdType>& ids = tuples.Tuples.Tuples[2];
    for (std::size_t i = 0; 3 * i < ids.size(); ++i)
    {
      this->Sharpness[MakeKey(ids.data() + 3 * i, 3)] = tuples.GetSharpness(2, i);
    }
  }
  template <typename Id>
  double Find(Row<Id> face) const
  {
    const vtkIdType size = face.size();
    double found[4] = {};
    for (vtkIdType i = 0; i < size; ++i)
    {
      vtkIdType ids[3];
      for (vtkIdType k = 0; k < 3; ++k)
      {
        ids[k] = face.begin()[(i + k) % size];
      }
      const auto place = this->Sharpness.find(MakeKey(ids, 3));
      found[i] = place == this->Sharpness.end() ? 0. : place->second;
    }
    return size == 3 ? found[0]
                     : std::max(std::min(found[0], found[2]), std::min(found[1], found[3]));
  }

private:
  std::map<SimplexKey, double> Sharpness;
};

/// Tells of lines of the crease geometry that lie on diagonals of quads.
template <typename Id>
void TellDiagonals(const CellComplex<Id>& complex, vtkPointSet* input, const MarkOptions& options,
  const std::function<void(const std::string&)>& warn)
{
  MarkOptions lines;
  lines.Geometry = options.Geometry;
  lines.ByIds = options.ByIds;
  const SharpTuples tuples =
    FindMarkedSimplices(input, ListSimplices(complex), lines, [](const std::string&) {});
  const std::vector<vtkIdType>& ends = tuples.Tuples.Tuples[1];
  vtkIdType count = 0;
  std::string first;
  for (const std::size_t i : InTurn(ends.size() / 2))
  {
    const vtkIdType a = ends[2 * i];
    const vtkIdType b = ends[2 * i + 1];
    if (complex.FindEdge(static_cast<Id>(a), static_cast<Id>(b)) < 0 && count++ == 0)
    {
      first = std::to_string(a) + " and " + std::to_string(b);
    }
  }
  if (count > 0)
  {
    warn(std::to_string(count) +
      " of the lines of the crease geometry are diagonals of quads, which "
      "are not cut, so the filter ignores them; the first one is between points " +
      first + ". Let lines follow edges, or take VolumeScheme = BoxSpline, which cuts quads.");
  }
}

}

template <typename Id>
void ForHybridMarks(const CellComplex<Id>& complex, vtkPointSet* input, MarkOptions options,
  const std::function<void(const std::string&)>& warn,
  const std::function<void(int, Id, double)>& mark)
{
  options.SelectedCells = nullptr;
  if (options.IsEmpty())
  {
    return;
  }
  const SharpTuples tuples = FindMarkedSimplices(input, ListSimplices(complex), options, warn);
  for (const vtkIdType v : InTurn(tuples.Tuples.Tuples[0]))
  {
    mark(0, static_cast<Id>(v), tuples.GetSharpness(0, 0));
  }
  const std::vector<vtkIdType>& ends = tuples.Tuples.Tuples[1];
  bool hasDiagonals = false;
  for (const std::size_t i : InTurn(ends.size() / 2))
  {
    // Two marked corners of a quad need not have an edge.
    const Id edge =
      complex.FindEdge(static_cast<Id>(ends[2 * i]), static_cast<Id>(ends[2 * i + 1]));
    if (edge >= 0)
    {
      mark(1, edge, tuples.GetSharpness(1, i));
    }
    hasDiagonals = hasDiagonals || edge < 0;
  }
  if (hasDiagonals && options.Geometry)
  {
    TellDiagonals(complex, input, options, warn);
  }
  const MarkedTriangles triangles(tuples);
  for (const Id f : InTurn(tuples.Tuples.Tuples[2].empty() ? Id(0) : complex.NumberOfFaces))
  {
    const double sharpness = triangles.Find(complex.GetVertices(f));
    if (sharpness > 0.)
    {
      mark(2, f, sharpness);
    }
  }
}

SUBDIVISION_COMPILE_FUNCTION(ForHybridMarks);

}
