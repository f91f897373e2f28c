// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/StampedParts.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/GreenLeaves.h"
#include "Private/Control/Stamp.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Run/StampFields.h"

#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace subdivision
{
namespace
{

using Ids = std::vector<vtkIdType>;

constexpr const char* BlockPointsName = "SubdivisionBlockPoints";
constexpr const char* BlockCellsName = "SubdivisionBlockCells";

bool ReadNumbers(vtkFieldData* field, const char* name, vtkIdType size, Ids& numbers)
{
  numbers = ReadFieldIds(name, field);
  return static_cast<vtkIdType>(numbers.size()) == size &&
    std::all_of(numbers.begin(), numbers.end(), [](vtkIdType number) { return number >= 0; });
}

/// Leaves out duplicate cells, and points that nothing else uses.
void LeaveOutDuplicates(MeshPart& part)
{
  const unsigned char* types = GetGhosts(part.Mesh, part.Mesh->GetNumberOfCells());
  if (!types)
  {
    return;
  }
  const CellReader reader(part.Mesh);
  Ids scratch;
  std::vector<char> isUsed(part.Points.size(), 0);
  std::vector<char> isOfDuplicate(part.Points.size(), 0);
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const bool isDuplicate = types[c] & vtkDataSetAttributes::DUPLICATECELL;
    const CellIds cell = reader.GetCell(c, scratch);
    for (vtkIdType i = 0; i < cell.Size; ++i)
    {
      (isDuplicate ? isOfDuplicate : isUsed)[cell.Ids[i]] = 1;
    }
    part.Cells[c] = isDuplicate ? -1 : part.Cells[c];
  }
  for (const size_t p : InTurn(part.Points.size()))
  {
    part.Points[p] = isOfDuplicate[p] && !isUsed[p] ? -1 : part.Points[p];
  }
}

bool TakeNumbers(MeshPart& part)
{
  vtkFieldData* field = part.Mesh->GetFieldData();
  return HasStamp(part.Mesh) &&
    ReadNumbers(field, BlockPointsName, part.Mesh->GetNumberOfPoints(), part.Points) &&
    ReadNumbers(field, BlockCellsName, part.Mesh->GetNumberOfCells(), part.Cells);
}

/// Whether a part has all green cells of each of its leaves.
bool AreLeavesWhole(const MeshPart& part, const CellGroups& groups)
{
  const GreenLeaves leaves(part.Mesh);
  for (vtkIdType g = 0; !leaves.IsEmpty() && g < groups.GetNumberOfGroups(); ++g)
  {
    const vtkIdType leaf = leaves.GetLeaf(groups.Cells[groups.Starts[g]]);
    if (leaf >= 0 && groups.Starts[g + 1] - groups.Starts[g] != leaves.CountParts(leaf))
    {
      return false;
    }
  }
  return true;
}

/// The same for a part of an output that several ranks have.
bool TakeNumbersOfPart(MeshPart& part, Stamp& stamp)
{
  if (!TakeNumbers(part) || !ReadPartStamp(part.Mesh, stamp))
  {
    return false;
  }
  LeaveOutDuplicates(part);
  part.Levels = stamp.Levels;
  CellGroups groups;
  return FindGroups(part, groups) && AreLeavesWhole(part, groups);
}

bool AreConsecutive(const Ids& ids)
{
  for (const size_t i : InTurn(ids.size()))
  {
    if (ids[i] != static_cast<vtkIdType>(i))
    {
      return false;
    }
  }
  return true;
}

/// The position of an id in an ascending list; -1: it is not there.
vtkIdType Find(const Ids& ids, vtkIdType id)
{
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  return found == ids.end() || *found != id ? -1 : found - ids.begin();
}

/// The corners of a control simplex, ascending, from the corners of its descendants (as in
/// FindControlMesh).
Ids FindCorners(const Ids& descendants, int dimension)
{
  const auto size = static_cast<size_t>(dimension + 1);
  const size_t others =
    dimension == 0 ? 0 : (descendants.size() / size - 1) / ((size_t(1) << dimension) - 1);
  Ids corners;
  for (size_t corner = 0; corner < size; ++corner)
  {
    corners.push_back(descendants[corner * others * size + corner]);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Collects the singular simplices of all parts: the descendants of each once, as points of the
/// joined mesh, in the order of SortTuples. `sharpness` gets theirs, where any is finite.
Ids JoinTuples(const std::vector<MeshPart>& parts, int dimension, int levels,
  const JoinedMesh& joined, std::vector<double>& sharpness)
{
  std::map<Ids, double> sharpnessOf;
  bool isFinite = false;
  const size_t size = static_cast<size_t>(dimension + 1) << (dimension * levels);
  std::map<Ids, Ids> found; // by corners
  for (const MeshPart& part : parts)
  {
    const Ids ids =
      ReadFieldIds(SingularNames[dimension], part.Mesh->GetFieldData(), dimension + 1);
    const std::vector<double> values =
      ReadFieldValues(SharpnessNames[dimension], part.Mesh->GetFieldData());
    for (size_t first = 0; first + size <= ids.size(); first += size)
    {
      Ids group;
      std::transform(ids.begin() + first, ids.begin() + first + size, std::back_inserter(group),
        [&](vtkIdType number) { return Find(joined.PointIds, number); });
      if (std::find(group.begin(), group.end(), vtkIdType(-1)) == group.end())
      {
        const Ids corners = FindCorners(group, dimension);
        found.emplace(corners, group);
        const double value = dimension > 0 && (dimension + 1) * values.size() == ids.size()
          ? values[first / (dimension + 1)]
          : std::numeric_limits<double>::infinity();
        double& largest = sharpnessOf.emplace(corners, value).first->second;
        largest = std::max(largest, value);
        isFinite = isFinite || value < std::numeric_limits<double>::infinity();
      }
    }
  }
  Ids tuples;
  for (const auto& [corners, group] : found)
  {
    tuples.insert(tuples.end(), group.begin(), group.end());
    if (isFinite)
    {
      sharpness.insert(sharpness.end(), group.size() / (dimension + 1), sharpnessOf[corners]);
    }
  }
  return tuples;
}

/// Collects the inverted control simplices.
Ids JoinInverted(const std::vector<MeshPart>& parts, int levels, const JoinedMesh& joined)
{
  std::set<vtkIdType> first;
  std::set<vtkIdType> all;
  for (const MeshPart& part : parts)
  {
    vtkFieldData* field = part.Mesh->GetFieldData();
    const Ids inParts = ReadFieldIds(FirstInvertedName, field);
    first.insert(inParts.begin(), inParts.end());
    const Ids inWhole = ReadFieldIds(InvertedCellsName, field);
    all.insert(inWhole.begin(), inWhole.end());
  }
  const CellReader cells(joined.Mesh);
  vtkIdType simplex = 0;
  for (vtkIdType c = 0; !first.empty() && c < cells.GetNumberOfCells(); ++simplex)
  {
    for (const int isFlat : { 0, 1 })
    {
      if (first.count(2 * joined.CellIds[c] + isFlat))
      {
        all.insert(2 * simplex + isFlat);
      }
    }
    Ids scratch;
    c += vtkIdType(1) << ((cells.GetCell(c, scratch).Size - 1) * levels);
  }
  return { all.begin(), all.end() };
}

/// Collects the control points of a surface, in the order of the points of the joined mesh.
void JoinControlPoints(const std::vector<MeshPart>& parts, vtkIdType size, JoinedMesh& joined)
{
  constexpr int components = ControlPointComponents;
  std::vector<double> all;
  for (const MeshPart& part : parts)
  {
    const std::vector<double> points =
      ReadFieldValues(ControlPointsName, part.Mesh->GetFieldData(), components);
    all.resize(points.empty() ? all.size() : static_cast<size_t>(components * size), 0.);
    for (size_t i = 0; i < points.size(); i += components)
    {
      const vtkIdType place = Find(joined.PointIds, static_cast<vtkIdType>(points[i]));
      if (place >= 0 && place < size)
      {
        std::copy_n(points.begin() + i, components, all.begin() + components * place);
      }
    }
  }
  WriteField<vtkDoubleArray>(ControlPointsName, all, joined.Mesh->GetFieldData(), components);
}

/// Collects the creases of a surface, as pairs of points of the joined mesh.
void JoinControlCreases(const std::vector<MeshPart>& parts, JoinedMesh& joined)
{
  std::map<std::pair<vtkIdType, vtkIdType>, double> all;
  for (const MeshPart& part : parts)
  {
    const std::vector<double> numbers =
      ReadFieldValues(ControlCreasesName, part.Mesh->GetFieldData(), CreaseComponents);
    for (size_t i = 0; i < numbers.size(); i += CreaseComponents)
    {
      const auto find = [&](double number) { return Find(joined.PointIds, ToId(number)); };
      const auto ends = std::make_pair(find(numbers[i]), find(numbers[i + 1]));
      if (ends.first >= 0 && ends.second >= 0)
      {
        all.emplace(ends, numbers[i + 2]);
      }
    }
  }
  std::vector<double> creases;
  for (const auto& [ends, sharpness] : all)
  {
    creases.insert(creases.end(),
      { static_cast<double>(ends.first), static_cast<double>(ends.second), sharpness });
  }
  WriteField<vtkDoubleArray>(
    ControlCreasesName, creases, joined.Mesh->GetFieldData(), CreaseComponents);
}

/// Copies the stamp of an output that has come together again.
void CopyStamp(vtkFieldData* from, vtkFieldData* to)
{
  AddFieldArrays(
    from,
    [](vtkAbstractArray* array)
    {
      const char* name = array->GetName();
      return BelongsToStamp(name) && std::string(name) != BlockPointsName &&
        std::string(name) != BlockCellsName;
    },
    to);
}

}

bool HasStamp(vtkPointSet* mesh)
{
  return mesh->GetFieldData()->HasArray(StampName) ||
    mesh->GetFieldData()->HasArray(SurfaceStampName);
}

void WriteStampedNumbers(vtkIdTypeArray* points, vtkIdTypeArray* cells, vtkPointSet* block)
{
  points->SetName(BlockPointsName);
  cells->SetName(BlockCellsName);
  block->GetFieldData()->AddArray(points);
  block->GetFieldData()->AddArray(cells);
}

bool IsStampedList(vtkAbstractArray* array)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  return name == FirstInvertedName || name == ControlPointsName || name == ControlCreasesName ||
    name == SharpnessNames[1] || name == SharpnessNames[2] ||
    std::find(std::begin(SingularNames), std::end(SingularNames), name) != std::end(SingularNames);
}

namespace
{

bool TakeNumbersOfParts(std::vector<MeshPart>& parts, Exchange& exchange)
{
  bool taken = true;
  if (exchange.GetNumberOfPartitions() == 1)
  {
    for (MeshPart& part : parts)
    {
      taken = taken && TakeNumbers(part);
    }
    return taken && !parts.empty();
  }
  vtkIdType cells = 0;
  std::vector<Stamp> stamps;
  for (MeshPart& part : parts)
  {
    stamps.emplace_back();
    taken = taken && TakeNumbersOfPart(part, stamps.back());
    cells += taken ? std::count_if(part.Cells.begin(), part.Cells.end(),
                       [](vtkIdType cell) { return cell >= 0; })
                   : 0;
  }
  if (!exchange.Agree(taken))
  {
    return false;
  }
  const auto numbersOf = [](const Stamp& stamp)
  {
    return std::array<vtkIdType, 5>{ static_cast<vtkIdType>(stamp.Scheme), stamp.Levels,
      stamp.NumberOfControlPoints, stamp.NumberOfPoints, stamp.NumberOfCells };
  };
  std::array<vtkIdType, 5> most = numbersOf(stamps.empty() ? Stamp() : stamps[0]);
  for (vtkIdType& number : most)
  {
    number = exchange.Max(stamps.empty() ? -1 : number);
  }
  const vtkIdType all = exchange.Sum(cells);
  return exchange.Agree(std::all_of(stamps.begin(), stamps.end(),
           [&](const Stamp& stamp) { return numbersOf(stamp) == most; })) &&
    all == most[4];
}

}

bool TakeStampedNumbers(std::vector<MeshPart>& parts, Exchange& exchange)
{
  const bool taken = TakeNumbersOfParts(parts, exchange);
  for (MeshPart& part : parts)
  {
    part.Levels = taken ? part.Levels : 0;
  }
  return taken;
}

bool RestoreStamp(
  const std::vector<MeshPart>& parts, bool taken, bool isPartial, JoinedMesh& joined)
{
  if (!std::any_of(
        parts.begin(), parts.end(), [](const MeshPart& part) { return HasStamp(part.Mesh); }))
  {
    return true;
  }
  const bool isWhole = AreConsecutive(joined.PointIds) && AreConsecutive(joined.CellIds);
  vtkFieldData* field = parts[0].Mesh->GetFieldData();
  // A block that is the whole output of an earlier filter has the stamp of that.
  const bool isWholeOutput =
    !taken && !isPartial && isWhole && parts.size() == 1 && !field->HasArray(BlockPointsName);
  if (isWholeOutput)
  {
    CopyStamp(field, joined.Mesh->GetFieldData());
    return true;
  }
  Stamp stamp;
  const bool isRead = taken && ReadPartStamp(parts[0].Mesh, stamp);
  const bool isOfPartitions =
    parts.back().Block == NoBlock || parts[0].Levels > 0 || stamp.Scheme == StampScheme::RedGreen;
  if (!isRead || (!isWhole && !isOfPartitions))
  {
    if (taken && isWhole)
    {
      CopyStamp(field, joined.Mesh->GetFieldData());
    }
    return taken && isWhole;
  }
  StampedIds ids;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    ids.Singular.Tuples.Tuples[dimension] =
      JoinTuples(parts, dimension, stamp.Levels, joined, ids.Singular.Sharpness[dimension]);
  }
  ids.Inverted = JoinInverted(parts, stamp.Levels, joined);
  ids.Interpolated = ReadFieldIds(InterpolatedName, field);
  if (isWhole)
  {
    ids.Global = ReadFieldIds(GlobalIdsName, field);
  }
  WriteStampedIds(ids, joined.Mesh);
  stamp.NumberOfControlPoints =
    std::lower_bound(joined.PointIds.begin(), joined.PointIds.end(), stamp.NumberOfControlPoints) -
    joined.PointIds.begin();
  JoinControlPoints(parts, stamp.NumberOfControlPoints, joined);
  JoinControlCreases(parts, joined);
  stamp.NumberOfPoints = 0;
  WriteStamp(stamp, joined.Mesh);
  return true;
}

namespace
{

/// The descendants of a control cell: corner c of it is corner c, or of a polygon the first corner,
/// of descendant c * OfCorner.
struct Descent
{
  vtkIdType Corners;
  vtkIdType Count;
  vtkIdType OfCorner;
  bool IsPolygon = false;
};

/// Of a simplex, or, where there are no levels, of any cell, which is its own descendant.
Descent FindDescent(int dimension, int levels)
{
  const vtkIdType count = levels > 0 ? vtkIdType(1) << (dimension * levels) : 1;
  return { dimension + 1, count, count > 1 ? (count - 1) / ((1 << dimension) - 1) : 0 };
}

/// Adds the green parts of a leaf, with all of their points.
void AddLeaf(
  const CellReader& reader, const GreenLeaves& leaves, vtkIdType first, CellGroups& groups)
{
  const auto size = static_cast<vtkIdType>(groups.Cells.size());
  const vtkIdType leaf = leaves.GetLeaf(groups.Cells[first]);
  Ids scratch;
  vtkIdType end = first;
  for (; end < size && leaves.GetLeaf(groups.Cells[end]) == leaf; ++end)
  {
    const CellIds cell = reader.GetCell(groups.Cells[end], scratch);
    groups.Points.insert(groups.Points.end(), cell.Ids, cell.Ids + cell.Size);
  }
  groups.Starts.push_back(end);
  groups.PointStarts.push_back(static_cast<vtkIdType>(groups.Points.size()));
}

}

bool FindGroups(const MeshPart& part, CellGroups& groups)
{
  const CellReader reader(part.Mesh);
  const GreenLeaves leaves(part.Mesh);
  for (const size_t c : InTurn(part.Cells.size()))
  {
    if (part.Cells[c] >= 0)
    {
      groups.Cells.push_back(static_cast<vtkIdType>(c));
    }
  }
  if (part.Levels > 0 || !leaves.IsEmpty())
  {
    std::sort(groups.Cells.begin(), groups.Cells.end(),
      [&part](vtkIdType a, vtkIdType b) { return part.Cells[a] < part.Cells[b]; });
  }
  Ids scratch;
  const auto size = static_cast<vtkIdType>(groups.Cells.size());
  const auto vertexOf = [&](vtkIdType cell, int corner)
  { return reader.GetCell(groups.Cells[cell], scratch).Ids[corner]; };
  for (vtkIdType first = 0; first < size; first = groups.Starts.back())
  {
    if (leaves.GetLeaf(groups.Cells[first]) >= 0)
    {
      AddLeaf(reader, leaves, first, groups);
      continue;
    }
    const vtkIdType corners = reader.GetCell(groups.Cells[first], scratch).Size;
    Descent descent = FindDescent(static_cast<int>(corners) - 1, part.Levels);
    if (part.Levels > 0 && corners == 4 && reader.GetCellType(groups.Cells[first]) == VTK_POLYGON)
    {
      descent.OfCorner = vtkIdType(1) << (2 * (part.Levels - 1));
      descent.Corners = CountCornersOfPolygon(first, size, part.Levels, vertexOf);
      descent.Count = descent.Corners * descent.OfCorner;
      descent.IsPolygon = true;
      if (descent.Corners < 3)
      {
        return false;
      }
    }
    const vtkIdType last = first + std::min(descent.Count, size - first) - 1;
    if (part.Cells[groups.Cells[last]] - part.Cells[groups.Cells[first]] != descent.Count - 1)
    {
      return false;
    }
    for (vtkIdType corner = 0; corner < descent.Corners; ++corner)
    {
      const CellIds cell = reader.GetCell(groups.Cells[first + corner * descent.OfCorner], scratch);
      if (cell.Size != corners)
      {
        return false;
      }
      groups.Points.push_back(cell.Ids[descent.IsPolygon ? 0 : corner]);
    }
    groups.Starts.push_back(first + descent.Count);
    groups.PointStarts.push_back(static_cast<vtkIdType>(groups.Points.size()));
  }
  return true;
}

}
