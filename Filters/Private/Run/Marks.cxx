// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/Marks.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"
#include "Private/Run/MarkGeometry.h"

#include "vtkCellType.h"
#include "vtkPointData.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

constexpr double Forever = std::numeric_limits<double>::infinity();

/// The faces of one cell of the input, as loops of points.
class CellFaces
{
public:
  explicit CellFaces(vtkPointSet* input)
    : Reader(input)
  {
  }

  void Read(vtkIdType cell)
  {
    if (cell == this->Cell)
    {
      return;
    }
    this->Cell = cell;
    this->Loops.clear();
    const int type = this->Reader.GetCellType(cell);
    const CellIds ids = this->Reader.GetCell(cell, this->Scratch);
    if (IsPolyhedron(type))
    {
      ForEachFaceLoop(type, ids, this->Loop,
        [this](const vtkIdType* loop, vtkIdType size) { this->Add(loop, size); });
    }
    else if (const SolidFaces* table = GetFaceTable(type))
    {
      this->AddFaces(*table, ids.Ids);
    }
    else if (type == VTK_PIXEL)
    {
      vtkIdType quad[4];
      GetQuad(type, ids.Ids, quad);
      this->Add(quad, 4);
    }
    else if (type == VTK_QUAD || type == VTK_POLYGON)
    {
      this->Add(ids.Ids, ids.Size);
    }
  }
  /// Whether two points are the ends of an edge; true for cells that are simplices or rows of them.
  bool HasEdge(vtkIdType a, vtkIdType b) const
  {
    return this->Loops.empty() ||
      std::any_of(this->Loops.begin(), this->Loops.end(),
        [=](const std::vector<vtkIdType>& loop)
        {
          vtkIdType last = loop.back();
          for (const vtkIdType point : loop)
          {
            if ((point == a && last == b) || (point == b && last == a))
            {
              return true;
            }
            last = point;
          }
          return false;
        });
  }
  /// Whether three points are of one face all of whose points are marked.
  template <typename IsMarked>
  bool HasFace(const vtkIdType* ids, const IsMarked& isMarked) const
  {
    return this->Loops.empty() ||
      std::any_of(this->Loops.begin(), this->Loops.end(),
        [&](const std::vector<vtkIdType>& loop)
        {
          return std::all_of(ids, ids + 3, [&](vtkIdType id)
                   { return std::find(loop.begin(), loop.end(), id) != loop.end(); }) &&
            std::all_of(loop.begin(), loop.end(), isMarked);
        });
  }

private:
  void Add(const vtkIdType* loop, vtkIdType size) { this->Loops.emplace_back(loop, loop + size); }
  void AddFaces(const SolidFaces& table, const vtkIdType* ids)
  {
    for (int f = 0; f < table.NumberOfFaces; ++f)
    {
      vtkIdType loop[4];
      int size = 0;
      for (; size < 4 && table.Faces[f][size] >= 0; ++size)
      {
        loop[size] = ids[table.Faces[f][size]];
      }
      this->Add(loop, size);
    }
  }

  const CellReader Reader;
  vtkIdType Cell = -1;
  std::vector<std::vector<vtkIdType>> Loops;
  std::vector<vtkIdType> Loop;
  std::vector<vtkIdType> Scratch;
};

enum class Mark : char
{
  None,
  New,
  Known ///< the point is a corner already
};

/// The marked points of the input.
std::vector<Mark> FindMarkedPoints(vtkPointSet* input, const MarkOptions& options)
{
  std::vector<Mark> marked(static_cast<size_t>(input->GetNumberOfPoints()), Mark::None);
  for (vtkDataArray* array : { options.Array.Get(), options.SelectedPoints.Get() })
  {
    for (size_t i = 0; array && i < marked.size(); ++i)
    {
      marked[i] = array->GetComponent(static_cast<vtkIdType>(i), 0) != 0. ? Mark::New : marked[i];
    }
  }
  for (size_t i = 0; options.Function && i < marked.size(); ++i)
  {
    double point[3];
    input->GetPoint(static_cast<vtkIdType>(i), point);
    marked[i] = options.Function->FunctionValue(point) <= 0. ? Mark::New : marked[i];
  }
  return marked;
}

void Add(int dimension, const vtkIdType* ids, SharpTuples& all, double sharpness = Forever)
{
  SimplexTuples& tuples = all.Tuples;
  const SimplexKey key = MakeKey(ids, dimension + 1);
  auto& to = tuples.Tuples[dimension];
  to.insert(to.end(), key.end() - dimension - 1, key.end());
  if (dimension > 0)
  {
    all.Sharpness[dimension].push_back(sharpness);
  }
}

/// The tuples of a dimension, each once, with its largest sharpness.
std::map<SimplexKey, double> ToMap(const SharpTuples& tuples, int dimension)
{
  const std::vector<vtkIdType>& ids = tuples.Tuples.Tuples[dimension];
  std::map<SimplexKey, double> keys;
  for (size_t i = 0; i + dimension < ids.size(); i += dimension + 1)
  {
    const double sharpness = tuples.GetSharpness(dimension, i / (dimension + 1));
    const auto added = keys.emplace(MakeKey(ids.data() + i, dimension + 1), sharpness);
    added.first->second = std::max(added.first->second, sharpness);
  }
  return keys;
}

/// Sorts tuples and drops repeated ones.
void MakeUnique(SharpTuples& tuples)
{
  SharpTuples sorted;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    for (const auto& found : ToMap(tuples, dimension))
    {
      Add(dimension, found.first.data() + 2 - dimension, sorted, found.second);
    }
  }
  sorted.Simplify();
  tuples = std::move(sorted);
}

/// Adds the singular simplices among one simplex and its faces.
class SimplexMarks
{
public:
  SimplexMarks(vtkPointSet* input, const MarkOptions& options, SharpTuples& tuples)
    : Options(options)
    , Marked(FindMarkedPoints(input, options))
    , Faces(input)
    , Tuples(tuples)
  {
  }

  void Read(vtkIdType cell, bool isPiece, int dimension, const vtkIdType* ids)
  {
    if (this->Options.SelectedCells && this->Options.SelectedCells->GetComponent(cell, 0) != 0.)
    {
      if (dimension < 3)
      {
        Add(dimension, ids, this->Tuples);
      }
      else
      {
        this->FirstSolid = this->Solids++ == 0 ? cell : this->FirstSolid;
      }
    }
    const auto isMarked = [this](vtkIdType id)
    { return id < static_cast<vtkIdType>(this->Marked.size()) && this->Marked[id] != Mark::None; };
    vtkIdType points[4];
    const auto count = std::copy_if(ids, ids + dimension + 1, points, isMarked) - points;
    for (int i = 0; this->Options.Corners && i < count; ++i)
    {
      if (this->Marked[points[i]] == Mark::New)
      {
        Add(0, points + i, this->Tuples);
        this->Marked[points[i]] = Mark::Known;
      }
    }
    if (count > 1 && isPiece)
    {
      this->Faces.Read(cell);
    }
    for (int i = 0; this->Options.Creases && i < count; ++i)
    {
      for (int k = 0; k < i; ++k)
      {
        const vtkIdType edge[2] = { points[k], points[i] };
        const double sharpness = this->GetSharpness(edge, 2);
        if (sharpness > 0. && (!isPiece || this->Faces.HasEdge(edge[0], edge[1])))
        {
          Add(1, edge, this->Tuples, sharpness);
        }
      }
    }
    for (int left = 0; this->Options.Surfaces && count > 2 && left < (count == 4 ? 4 : 1); ++left)
    {
      vtkIdType face[4];
      std::rotate_copy(points, points + (count == 4 ? left : 0), points + count, face);
      const double sharpness = this->Options.FacesStay ? Forever : this->GetSharpness(face, 3);
      if (sharpness > 0. && (!isPiece || this->Faces.HasFace(face, isMarked)))
      {
        Add(2, face, this->Tuples, sharpness);
      }
    }
  }
  void Tell(const std::function<void(const std::string&)>& warn) const
  {
    if (this->Solids > 0)
    {
      warn("The selection of marks has 3D cells, which cannot be singular, so the filter ignores "
           "them, first cell " +
        std::to_string(this->FirstSolid) +
        "; select vertices, lines or faces, or the points between which creases are to be.");
    }
  }

private:
  /// The smallest sharpness of the points; 0 where it is 0 or less, or no number: not singular.
  double GetSharpness(const vtkIdType* points, int size) const
  {
    double least = Forever;
    for (int i = 0; this->Options.Sharpness && i < size; ++i)
    {
      const double sharpness = this->Options.Sharpness->GetComponent(points[i], 0);
      least = sharpness > 0. ? std::min(least, sharpness) : 0.;
    }
    return least;
  }

  const MarkOptions& Options;
  std::vector<Mark> Marked;
  CellFaces Faces;
  SharpTuples& Tuples;
  vtkIdType Solids = 0;
  vtkIdType FirstSolid = -1;
};

}

SharpTuples FindMarkedSimplices(vtkPointSet* input, const SimplicesOfCells& cells,
  const MarkOptions& options, const std::function<void(const std::string&)>& warn)
{
  SharpTuples tuples;
  if (options.IsEmpty())
  {
    return tuples;
  }
  const SimplexView view = cells.GetView();
  const bool isCut = !cells.ParentCells.empty();
  SimplexMarks marks(input, options, tuples);
  vtkIdType entry = 0;
  for (const vtkIdType i : InTurn(view.NumberOfSimplices))
  {
    marks.Read(
      isCut ? cells.ParentCells[i] : i, isCut, view.Dimensions[i], view.Connectivity + entry);
    entry += view.Dimensions[i] + 1;
  }
  marks.Tell(warn);
  if (options.Geometry)
  {
    MarkGeometry(input, view, options, warn, tuples);
  }
  MakeUnique(tuples);
  return tuples;
}

void SharpTuples::Simplify()
{
  for (std::vector<double>& values : InTurn(this->Sharpness))
  {
    if (std::all_of(
          values.begin(), values.end(), [](double sharpness) { return sharpness == Forever; }))
    {
      values.clear();
    }
  }
}

void AddMissing(const SharpTuples& more, SharpTuples& tuples)
{
  if (more.Tuples.IsEmpty())
  {
    return;
  }
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    if (dimension > 0)
    {
      tuples.Sharpness[dimension].resize(
        tuples.Tuples.Tuples[dimension].size() / (dimension + 1), Forever);
    }
    const auto known = ToMap(tuples, dimension);
    for (const auto& found : ToMap(more, dimension))
    {
      if (known.count(found.first) == 0)
      {
        Add(dimension, found.first.data() + 2 - dimension, tuples, found.second);
      }
    }
  }
  tuples.Simplify();
}

void ClearMarks(const MarkOptions& options, vtkPointSet* output)
{
  vtkPointData* data = output->GetPointData();
  int index = -1;
  vtkDataArray* marks = options.Array ? data->GetArray(options.Array->GetName(), index) : nullptr;
  if (!marks)
  {
    return;
  }
  // The array itself may be the input's own.
  const auto cleared = MakeArray(marks->GetDataType(), 1, marks->GetNumberOfTuples());
  CopyLooks(marks, cleared);
  cleared->Fill(0.);
  AddInstead(data, cleared, data);
}

}
