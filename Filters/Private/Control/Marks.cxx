// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/Marks.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Control/MarkGeometry.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellType.h"
#include "vtkPointData.h"

#include <algorithm>
#include <set>
#include <vector>

namespace subdivision
{
namespace
{

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
    else if (const FaceTable* table = GetFaceTable(type))
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
  void AddFaces(const FaceTable& table, const vtkIdType* ids)
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

void Add(int dimension, const vtkIdType* ids, SimplexTuples& tuples)
{
  const SimplexKey key = MakeKey(ids, dimension + 1);
  auto& to = tuples.Tuples[dimension];
  to.insert(to.end(), key.end() - dimension - 1, key.end());
}

std::set<SimplexKey> ToSet(const std::vector<vtkIdType>& ids, int dimension)
{
  std::set<SimplexKey> keys;
  for (size_t i = 0; i + dimension < ids.size(); i += dimension + 1)
  {
    keys.insert(MakeKey(ids.data() + i, dimension + 1));
  }
  return keys;
}

/// Sorts tuples and drops those that come again.
void MakeUnique(SimplexTuples& tuples)
{
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    const std::set<SimplexKey> unique = ToSet(tuples.Tuples[dimension], dimension);
    tuples.Tuples[dimension].clear();
    for (const SimplexKey& key : unique)
    {
      Add(dimension, key.data() + 2 - dimension, tuples);
    }
  }
}

/// Adds the singular simplices among one simplex and its faces.
class SimplexMarks
{
public:
  SimplexMarks(vtkPointSet* input, const MarkOptions& options, SimplexTuples& tuples)
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
        if (!isPiece || this->Faces.HasEdge(edge[0], edge[1]))
        {
          Add(1, edge, this->Tuples);
        }
      }
    }
    for (int left = 0; this->Options.Surfaces && count > 2 && left < (count == 4 ? 4 : 1); ++left)
    {
      vtkIdType face[4];
      std::rotate_copy(points, points + (count == 4 ? left : 0), points + count, face);
      if (!isPiece || this->Faces.HasFace(face, isMarked))
      {
        Add(2, face, this->Tuples);
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
  const MarkOptions& Options;
  std::vector<Mark> Marked;
  CellFaces Faces;
  SimplexTuples& Tuples;
  vtkIdType Solids = 0;
  vtkIdType FirstSolid = -1;
};

}

SimplexTuples FindMarkedSimplices(vtkPointSet* input, const SimplicesOfCells& cells,
  const MarkOptions& options, const std::function<void(const std::string&)>& warn)
{
  SimplexTuples tuples;
  if (options.IsEmpty())
  {
    return tuples;
  }
  const SimplexView view = cells.GetView();
  const bool isCut = !cells.ParentCells.empty();
  SimplexMarks marks(input, options, tuples);
  vtkIdType entry = 0;
  for (vtkIdType i = 0; i < view.NumberOfSimplices; ++i)
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

void AddMissing(const SimplexTuples& more, SimplexTuples& tuples)
{
  for (int dimension = 0; dimension < 3 && !more.IsEmpty(); ++dimension)
  {
    const std::set<SimplexKey> known = ToSet(tuples.Tuples[dimension], dimension);
    for (const SimplexKey& key : ToSet(more.Tuples[dimension], dimension))
    {
      if (known.count(key) == 0)
      {
        Add(dimension, key.data() + 2 - dimension, tuples);
      }
    }
  }
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
