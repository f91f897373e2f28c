// SPDX-License-Identifier: BSD-3-Clause
// Uniform linear refinement that keeps the types of cells.
#include "Private/Uniform/UniformSubdivision.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Core/Solids/RedCells/RedCells.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedNumbers.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Run/SizeChecks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace subdivision
{
namespace
{

constexpr std::array<unsigned char, NumberOfShapes> Types = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE,
  VTK_QUAD, VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };

/// The cells of the input that can be refined, and from which of its cells each is.
struct KeptCells
{
  ShapedCells Cells;
  std::vector<vtkIdType> Sources;
  std::vector<std::string> Warnings;
  std::string Error;
};

/// Reads cells one by one.
class KeptReader
{
public:
  KeptReader(vtkPointSet* input, KeptCells& result)
    : Reader(input)
    , Points(input->GetPoints()->GetData())
    , Ghosts(GetGhosts(input, input->GetNumberOfCells()))
    , Result(result)
  {
    result.Cells.NumberOfPoints = input->GetNumberOfPoints();
  }

  void Read()
  {
    KeptCells& result = this->Result;
    std::vector<vtkIdType> scratch;
    for (const vtkIdType cell : InTurn(this->Reader.GetNumberOfCells()))
    {
      if (!result.Error.empty())
      {
        break;
      }
      if (!this->Ghosts || !IsHiddenCell(this->Ghosts[cell]))
      {
        this->Read(cell, this->Reader.GetCell(cell, scratch));
      }
    }
    if (this->LeftOut > 0)
    {
      result.Warnings.push_back(std::to_string(this->LeftOut) +
        " cell(s) have points that do not exist, are not finite, or are repeated; the filter "
        "leaves them out. The first is cell " +
        std::to_string(this->FirstLeftOut) + ".");
    }
  }

private:
  void Read(vtkIdType cell, const CellIds& ids)
  {
    const int type = this->Reader.GetCellType(cell);
    const std::vector<vtkIdType> p(ids.Ids, ids.Ids + ids.Size);
    const auto shape = std::find(Types.begin(), Types.end(), type);
    if (type == VTK_EMPTY_CELL)
    {
      return;
    }
    if (shape != Types.end())
    {
      this->Add(cell, static_cast<CellShape>(shape - Types.begin()), p);
    }
    else if (type == VTK_VOXEL && p.size() == 8)
    {
      this->Add(cell, CellShape::Hex, { p[0], p[1], p[3], p[2], p[4], p[5], p[7], p[6] });
    }
    else if (type == VTK_PIXEL && p.size() == 4)
    {
      this->Add(cell, CellShape::Quad, { p[0], p[1], p[3], p[2] });
    }
    else if (type == VTK_POLYGON && (p.size() == 3 || p.size() == 4))
    {
      this->Add(cell, p.size() == 3 ? CellShape::Triangle : CellShape::Quad, p);
    }
    else if (type == VTK_POLY_VERTEX || type == VTK_POLY_LINE || type == VTK_TRIANGLE_STRIP)
    {
      const std::size_t size = type == VTK_POLY_VERTEX ? 1 : type == VTK_POLY_LINE ? 2 : 3;
      for (std::size_t i = 0; i + size <= p.size(); ++i)
      {
        std::vector<vtkIdType> piece(p.begin() + i, p.begin() + i + size);
        if (size == 3 && i % 2 == 1)
        {
          std::swap(piece[1], piece[2]);
        }
        this->Add(cell,
          size == 1     ? CellShape::Vertex
            : size == 2 ? CellShape::Line
                        : CellShape::Triangle,
          piece);
      }
    }
    else
    {
      this->Result.Error = "Cell " + std::to_string(cell) + " has " + std::to_string(p.size()) +
        " points and the type " + std::to_string(type) +
        " of VTK, which KeepCellTypes has no children for. Switch it off: the filter then splits "
        "all cells into simplices.";
    }
  }

  void Add(vtkIdType cell, CellShape shape, const std::vector<vtkIdType>& points)
  {
    std::vector<vtkIdType> sorted = points;
    std::sort(sorted.begin(), sorted.end());
    const bool isValid = static_cast<int>(points.size()) == GetNumberOfCorners(shape) &&
      std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() && sorted.front() >= 0 &&
      sorted.back() < this->Result.Cells.NumberOfPoints &&
      std::all_of(points.begin(), points.end(), [this](vtkIdType p) { return this->IsFinite(p); });
    if (!isValid)
    {
      this->FirstLeftOut = this->LeftOut++ == 0 ? cell : this->FirstLeftOut;
      return;
    }
    const std::vector<long long> corners(points.begin(), points.end());
    this->Result.Cells.Add(shape, corners.data());
    this->Result.Sources.push_back(cell);
  }
  bool IsFinite(vtkIdType point) const
  {
    bool isFinite = true;
    for (int c = 0; c < 3; ++c)
    {
      isFinite = isFinite && std::isfinite(this->Points->GetComponent(point, c));
    }
    return isFinite;
  }

  const CellReader Reader;
  vtkDataArray* Points;
  const unsigned char* Ghosts;
  KeptCells& Result;
  vtkIdType LeftOut = 0;
  vtkIdType FirstLeftOut = 0;
};

/// An error message if the output is too large.
std::string CheckSize(vtkPointSet* input, const ShapedCells& cells, const UniformOptions& options)
{
  std::array<double, NumberOfShapes> counts{};
  for (const CellShape shape : InTurn(cells.Shapes))
  {
    ++counts[static_cast<std::size_t>(shape)];
  }
  for (int level = 0; level < options.Levels; ++level)
  {
    counts = CountRedChildren(counts);
  }
  const double all = std::accumulate(counts.begin(), counts.end(), 0.);
  double corners = 0.;
  for (int s = 0; s < NumberOfShapes; ++s)
  {
    corners += counts[s] * GetNumberOfCorners(static_cast<CellShape>(s));
  }
  const double bytes = 8. * corners + 17. * all;
  const std::string tooMany =
    CheckNumberOfCells(all, bytes, options.Levels, options.MaximumNumberOfCells);
  if (!tooMany.empty())
  {
    return tooMany;
  }
  // About one point for each cell; while edges and quads are numbered they take as much as cells.
  const double points = all + static_cast<double>(input->GetNumberOfPoints());
  return CheckMemory(all, points,
    3. * bytes + all * GetBytesPerTuple(input->GetCellData()) +
      2. * points * (24. + GetBytesPerTuple(input->GetPointData())),
    options.Levels);
}

/// Chooses the shortest diagonal of each tetrahedron.
void OrderTetsOf(ShapedCells& cells, const Coordinates& points, const std::vector<vtkIdType>& ids)
{
  long long* corners = cells.Corners.data();
  for (const CellShape shape : InTurn(cells.Shapes))
  {
    if (shape == CellShape::Tet)
    {
      vtkIdType tet[4];
      std::copy_n(corners, 4, tet);
      OrderTet(tet, points, ids.empty() ? nullptr : ids.data(), static_cast<vtkIdType>(ids.size()));
      std::copy_n(tet, 4, corners);
    }
    corners += GetNumberOfCorners(shape);
  }
}

void WriteCells(const ShapedCells& cells, bool use32BitIds, vtkUnstructuredGrid* output)
{
  const auto size = static_cast<vtkIdType>(cells.Shapes.size());
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfTuples(size);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfTuples(size + 1);
  offsets->SetValue(0, 0);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfTuples(static_cast<vtkIdType>(cells.Corners.size()));
  for (const vtkIdType c : InTurn(size))
  {
    types->SetValue(c, Types[static_cast<std::size_t>(cells.Shapes[c])]);
    offsets->SetValue(c + 1, offsets->GetValue(c) + GetNumberOfCorners(cells.Shapes[c]));
  }
  std::copy(cells.Corners.begin(), cells.Corners.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> array;
  array->SetData(offsets, corners);
  if (use32BitIds && array->CanConvertTo32BitStorage())
  {
    array->ConvertTo32BitStorage();
  }
  output->SetCells(types, array);
}

/// The output's field data have no stamp: any filter may go on with the cells as they are.
void RemoveStamp(vtkFieldData* data)
{
  for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    if (BelongsToStamp(data->GetAbstractArray(a)->GetName()))
    {
      data->RemoveArray(a);
    }
  }
}

void WriteCellData(vtkPointSet* input, const std::vector<vtkIdType>& sources,
  const UniformOptions& options, vtkUnstructuredGrid* output)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfTuples(static_cast<vtkIdType>(sources.size()));
  ids->SetName(OriginalCellIdsName);
  std::copy(sources.begin(), sources.end(), ids->GetPointer(0));
  CellArrayOptions cells;
  cells.Levels = options.Levels;
  cells.PointsMove = options.MovesPoints();
  cells.OriginalIds = options.GenerateOriginalIds;
  cells.Warn = options.Warn;
  CopyCellArrays(input, ids, cells, output);
  RebuildPointGhosts(input, output);
  RemoveStamp(output->GetFieldData());
}

/// Finds which points of a step are corners of children of own input cells.
std::vector<char> FindOwnPoints(
  const RedStep& step, const std::vector<vtkIdType>& sources, const OtherPartitions& others)
{
  std::vector<char> own(static_cast<std::size_t>(step.Rows.Offsets.size()) - 1, 0);
  const long long* corner = step.Children.Corners.data();
  for (std::size_t c = 0; c < step.Children.Shapes.size(); ++c)
  {
    const bool isOwn = others.IsOwn(sources[static_cast<std::size_t>(step.Parents[c])]);
    const long long* last = corner + GetNumberOfCorners(step.Children.Shapes[c]);
    for (; corner != last; ++corner)
    {
      own[static_cast<std::size_t>(*corner)] |= isOwn ? 1 : 0;
    }
  }
  return own;
}

/// Numbers the points that a step adds: the middles of edges, then of quads, by the numbers of the
/// corners, then of hexahedra, by their input cell and which of its hexahedra they are in. Six
/// exchanges. `places`: PlaceCells.
void NumberPoints(const RedStep& step, const KeptCells& before,
  const std::vector<vtkIdType>& places, OtherPartitions& others, WholeIds& points)
{
  const std::vector<char> own = FindOwnPoints(step, before.Sources, others);
  const auto& offsets = step.Rows.Offsets;
  auto row = static_cast<vtkIdType>(points.Ids.size());
  for (const int corners : { 2, 4 })
  {
    SharedKeys means;
    means.Width = corners;
    std::vector<vtkIdType> key(static_cast<std::size_t>(corners));
    for (; row + 1 < offsets.size() && offsets[row + 1] - offsets[row] == corners; ++row)
    {
      const long long* columns = step.Rows.Columns.data() + offsets[row];
      std::transform(columns, columns + corners, key.begin(),
        [&points](long long point) { return points.Ids[static_cast<std::size_t>(point)]; });
      std::sort(key.begin(), key.end());
      means.Own.push_back(own[static_cast<std::size_t>(row)] && key[0] >= 0);
      std::replace(key.begin(), key.end(), vtkIdType(-1), vtkIdType(0));
      means.Keys.insert(means.Keys.end(), key.begin(), key.end());
    }
    points.Add(means, others);
  }
  std::vector<vtkIdType> hexes;
  for (std::size_t c = 0; c < before.Cells.Shapes.size(); ++c)
  {
    if (before.Cells.Shapes[c] == CellShape::Hex)
    {
      hexes.push_back(before.Sources[c]);
    }
  }
  points.Add(MakeKeysOfPieces(hexes, places, others), others);
}

}

bool RefineKeepingTypes(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  KeptCells kept;
  KeptReader(input, kept).Read();
  Tell(kept.Warnings, options);
  const std::string error = kept.Error.empty() ? CheckSize(input, kept.Cells, options) : kept.Error;
  if (!error.empty())
  {
    options.Fail(error);
    return false;
  }
  SimplicesOfCells noCentres;
  noCentres.Simplices.NumberOfPoints = input->GetNumberOfPoints();
  const std::vector<vtkIdType> ids = ReadIdsOf(input->GetPointData(), input->GetNumberOfPoints());
  const auto points = StartPointArrays(options, input, noCentres, ids, false, options.Warn);
  OtherPartitions* others = options.GenerateGlobalIds ? options.Others : nullptr;
  const auto places = others ? PlaceCells(input, *others) : std::vector<vtkIdType>();
  WholeNumbers numbers;
  if (others)
  {
    numbers.Points = NumberPoints(input->GetNumberOfPoints(), *others);
  }
  for (int level = 0; level < options.Levels; ++level)
  {
    if (options.Progress && options.Progress(level / (options.Levels + 1.)))
    {
      return false;
    }
    OrderTetsOf(kept.Cells, points->GetCoordinates(), level == 0 ? ids : std::vector<vtkIdType>());
    RedStep step = RefineRed(kept.Cells);
    if (others)
    {
      NumberPoints(step, kept, places, *others, numbers.Points);
    }
    points->Advance(step.Rows,
      [&](vtkIdType row)
      {
        const long long* first = step.Rows.Columns.data() + step.Rows.Offsets[row];
        const long long* last = step.Rows.Columns.data() + step.Rows.Offsets[row + 1];
        return *std::min_element(
          first, last, [&](vtkIdType a, vtkIdType b) { return points->IsEarlier(a, b); });
      });
    for (vtkIdType& parent : InTurn(step.Parents))
    {
      parent = kept.Sources[parent];
    }
    kept.Sources = std::move(step.Parents);
    kept.Cells = std::move(step.Children);
  }
  points->Finish(output);
  WriteCells(kept.Cells, options.Use32BitIds, output);
  WriteCellData(input, kept.Sources, options, output);
  if (others)
  {
    numbers.Cells = NumberCells(places, kept.Sources, *others);
    numbers.Write(output);
  }
  return true;
}

}
