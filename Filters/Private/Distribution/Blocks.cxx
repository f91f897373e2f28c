// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Blocks.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Distribution/JoinedArrays.h"
#include "Private/Distribution/StampedParts.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/UnusedPoints.h"
#include "Private/Run/StampFields.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

/// The point array with the block of points that no cell uses.
constexpr const char* PointBlockName = "SubdivisionPointBlock";

bool IsAccepted(vtkDataObject* data, bool isOfSurfaces)
{
  return vtkPolyData::SafeDownCast(data) ||
    (!isOfSurfaces && vtkUnstructuredGrid::SafeDownCast(data));
}

/// Gives active attributes that blocks share to the arrays that have them in this block. The filter
/// chose the global ids.
void RestoreAttributes(
  const std::vector<JoinedArray>& arrays, vtkDataSetAttributes* own, vtkDataSetAttributes* data)
{
  const auto isOfFilter = [&](const char* name)
  {
    return !name ||
      std::none_of(arrays.begin(), arrays.end(),
        [name](const JoinedArray& array) { return array.OriginalName == name; });
  };
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = own->GetAbstractAttribute(type);
    vtkAbstractArray* now = data->GetAbstractAttribute(type);
    if (type != vtkDataSetAttributes::GLOBALIDS && !(now && isOfFilter(now->GetName())))
    {
      int index = -1;
      if (active && active->GetName())
      {
        data->GetAbstractArray(active->GetName(), index);
      }
      data->SetActiveAttribute(index, type);
    }
  }
}

/// Takes away arrays that other blocks have and this one does not, and gives the others the names
/// and looks that they have in this one, whose data are `own`. `hasGhosts`: ghost types come from
/// MarkGhosts, whoever had some.
void RestoreArrays(const std::vector<JoinedArray>& arrays, int block, bool hasGhosts,
  vtkDataSetAttributes* own, vtkDataSetAttributes* data)
{
  std::multimap<std::string, int> active; // attributes that arrays of these names were
  for (const JoinedArray& array : arrays)
  {
    vtkAbstractArray* found = data->GetAbstractArray(array.Name.c_str());
    const bool isMade = hasGhosts && array.Name == vtkDataSetAttributes::GhostArrayName();
    if (found && !isMade && !array.OfPart[block])
    {
      for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
      {
        if (data->GetAbstractAttribute(type) == found)
        {
          active.emplace(array.OriginalName, type);
        }
      }
      data->RemoveArray(array.Name.c_str());
    }
  }
  for (const JoinedArray& array : arrays)
  {
    vtkAbstractArray* found = data->GetAbstractArray(array.Name.c_str());
    if (found && array.Name != array.OriginalName)
    {
      found->SetName(array.OriginalName.c_str());
      const auto types = active.equal_range(array.OriginalName);
      for (auto type = types.first; type != types.second; ++type)
      {
        data->SetActiveAttribute(array.OriginalName.c_str(), type->second);
      }
    }
    vtkAbstractArray* given = found ? FindArray(own, found, array) : nullptr;
    if (given)
    {
      CopyLooks(given, found);
    }
  }
  RestoreAttributes(arrays, own, data);
}

/// Original ids that this filter made count the points or cells of the joined mesh: makes them
/// count the points or cells of the block, whose `places` in the joined mesh are given.
void CountInBlock(const char* name, const std::vector<JoinedArray>& arrays,
  const std::vector<vtkIdType>& places, vtkDataSetAttributes* data)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
  const bool wasThere = std::any_of(arrays.begin(), arrays.end(),
    [name](const JoinedArray& array) { return array.OriginalName == name; });
  if (!ids || wasThere || places.empty())
  {
    return;
  }
  std::vector<vtkIdType> index(
    static_cast<size_t>(*std::max_element(places.begin(), places.end()) + 1), -1);
  for (const size_t i : InTurn(places.size()))
  {
    if (places[i] >= 0)
    {
      index[places[i]] = static_cast<vtkIdType>(i);
    }
  }
  for (const vtkIdType i : InTurn(ids->GetNumberOfValues()))
  {
    const vtkIdType id = ids->GetValue(i);
    ids->SetValue(i, id >= 0 && id < static_cast<vtkIdType>(index.size()) ? index[id] : -1);
  }
}

/// Some cells and the cells around them: `layers` times all that share a point with them.
/// Ascending.
std::vector<vtkIdType> AddLayersOf(
  vtkPointSet* whole, const std::vector<vtkIdType>& cells, int layers)
{
  const CellReader reader(whole);
  std::vector<char> isIn(static_cast<size_t>(whole->GetNumberOfCells()), 0);
  std::vector<char> isAt(static_cast<size_t>(whole->GetNumberOfPoints()), 0);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(cells))
  {
    isIn[c] = 1;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
    {
      const CellIds cell = reader.GetCell(c, scratch);
      for (vtkIdType i = 0; isIn[c] && i < cell.Size; ++i)
      {
        isAt[cell.Ids[i]] = 1;
      }
    }
    for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
    {
      const CellIds cell = reader.GetCell(c, scratch);
      isIn[c] |= std::any_of(cell.Ids, cell.Ids + cell.Size, [&](vtkIdType p) { return isAt[p]; });
    }
  }
  std::vector<vtkIdType> all;
  for (const size_t c : InTurn(isIn.size()))
  {
    if (isIn[c])
    {
      all.push_back(static_cast<vtkIdType>(c));
    }
  }
  return all;
}

vtkSmartPointer<vtkUnsignedCharArray> MakeGhostTypes(vtkIdType size, unsigned char value)
{
  auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
  types->SetName(vtkDataSetAttributes::GhostArrayName());
  types->SetNumberOfValues(size);
  types->FillValue(value);
  return types;
}

/// Marks the cells of an output that are not its own, and the points that only these have. `cells`
/// are the cells of the output, `own` some of them.
void MarkGhosts(
  const std::vector<vtkIdType>& cells, const std::vector<vtkIdType>& own, vtkPointSet* output)
{
  constexpr unsigned char duplicate = vtkDataSetAttributes::DUPLICATECELL;
  const auto ofCells = MakeGhostTypes(output->GetNumberOfCells(), 0);
  const auto ofPoints =
    MakeGhostTypes(output->GetNumberOfPoints(), vtkDataSetAttributes::DUPLICATEPOINT);
  if (const unsigned char* hidden = GetGhosts(output, output->GetNumberOfCells()))
  {
    std::copy_n(hidden, output->GetNumberOfCells(), ofCells->GetPointer(0));
  }
  const CellReader reader(output);
  std::vector<vtkIdType> scratch;
  for (const size_t c : InTurn(cells.size()))
  {
    const auto at = static_cast<vtkIdType>(c);
    if (!std::binary_search(own.begin(), own.end(), cells[c]))
    {
      ofCells->SetValue(at, ofCells->GetValue(at) | duplicate);
      continue;
    }
    const CellIds cell = reader.GetCell(at, scratch);
    for (vtkIdType i = 0; i < cell.Size; ++i)
    {
      ofPoints->SetValue(cell.Ids[i], 0);
    }
  }
  output->GetCellData()->AddArray(ofCells);
  output->GetPointData()->AddArray(ofPoints);
}

/// Gives the points the type that the points of a block have: single precision or double.
void SetPrecision(int type, vtkPointSet* output)
{
  vtkDataArray* have = output->GetPoints()->GetData();
  if ((type == VTK_FLOAT || type == VTK_DOUBLE) && have->GetDataType() != type)
  {
    const auto wanted = MakeArray(type, 3, have->GetNumberOfTuples());
    wanted->DeepCopy(have);
    output->GetPoints()->SetDataType(type);
    output->GetPoints()->SetData(wanted);
  }
}

/// Gives the only block all cells and points, without a copy.
void TakeAll(vtkPointSet* whole, vtkPointSet* output)
{
  output->ShallowCopy(whole);
  output->GetCellData()->RemoveArray(BlockName);
  output->GetFieldData()->Initialize();
}

/// Whether all cells come from block 0.
bool IsOneBlock(vtkPointSet* whole)
{
  auto* blocks = vtkIntArray::SafeDownCast(whole->GetCellData()->GetArray(BlockName));
  const vtkIdType size = blocks ? blocks->GetNumberOfValues() : 0;
  const int* first = size > 0 ? blocks->GetPointer(0) : nullptr;
  return size == whole->GetNumberOfCells() &&
    std::all_of(first, first + size, [](int block) { return block == 0; });
}

using Numbers = vtkSmartPointer<vtkIdTypeArray>;

Numbers Count(vtkIdType size)
{
  auto indices = Numbers::New();
  indices->SetNumberOfValues(size);
  std::iota(indices->GetPointer(0), indices->GetPointer(0) + size, vtkIdType(0));
  return indices;
}

/// Takes away the array of numbers in the whole output; where there is none, this is the whole, and
/// `indices` are the numbers; null: all.
Numbers TakeNumbers(const char* name, const std::vector<vtkIdType>* indices, vtkIdType size,
  vtkDataSetAttributes* data)
{
  const Numbers found = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(name));
  data->RemoveArray(name);
  return found ? found : indices ? MakeField<vtkIdTypeArray>(name, *indices) : Count(size);
}

void AddGlobalIds(vtkIdTypeArray* points, vtkIdTypeArray* cells, vtkPointSet* output)
{
  const auto copy = [](vtkIdTypeArray* numbers, const char* name)
  {
    auto ids = Numbers::New();
    ids->ShallowCopy(numbers);
    ids->SetName(name);
    return ids;
  };
  output->GetPointData()->SetGlobalIds(copy(points, "GlobalPointIds"));
  output->GetCellData()->SetGlobalIds(copy(cells, "GlobalCellIds"));
}

/// Gives a block its cells and points of `whole`, and returns their numbers in the whole output.
std::pair<Numbers, Numbers> TakeMesh(vtkPointSet* whole, const OutputOptions& options, int block,
  const std::vector<vtkIdType>& own, vtkPointSet* output)
{
  std::vector<vtkIdType> layers;
  if (options.GhostLayers > 0)
  {
    layers = AddLayersOf(whole, own, options.GhostLayers);
  }
  const std::vector<vtkIdType>& cells = options.GhostLayers > 0 ? layers : own;
  std::vector<vtkIdType> kept;
  if (auto* of = vtkIntArray::SafeDownCast(whole->GetPointData()->GetArray(PointBlockName)))
  {
    kept = FindUnusedPoints(whole);
    kept.erase(std::remove_if(kept.begin(), kept.end(),
                 [&](vtkIdType point) { return of->GetValue(point) != block; }),
      kept.end());
  }
  const std::vector<vtkIdType> points = TakeCells(whole, cells, kept, output);
  if (options.GhostLayers > 0)
  {
    MarkGhosts(cells, own, output);
  }
  return { TakeNumbers(PointNumbersName, &points, 0, output->GetPointData()),
    TakeNumbers(CellNumbersName, &cells, 0, output->GetCellData()) };
}

/// Writes the output of one block, whose cells are `own`; null: all.
void TakeOutput(const JoinedMesh& joined, vtkPointSet* whole, const OutputOptions& options,
  int block, const std::vector<vtkIdType>* own, std::vector<Block>& blocks)
{
  vtkPointSet* output = blocks[block].Output;
  const auto addFieldData = [&]
  {
    AddFieldData(blocks[block].Input->GetFieldData(), false, output->GetFieldData());
    AddFieldData(whole->GetFieldData(), true, output->GetFieldData());
  };
  std::pair<Numbers, Numbers> numbers;
  if (own)
  {
    addFieldData(); // TakeMesh replaces green leaves by the block's
    numbers = TakeMesh(whole, options, block, *own, output);
  }
  else
  {
    TakeAll(whole, output);
    addFieldData();
    if (options.GhostLayers > 0)
    {
      std::vector<vtkIdType> all(static_cast<size_t>(whole->GetNumberOfCells()));
      std::iota(all.begin(), all.end(), vtkIdType(0));
      MarkGhosts(all, all, output);
    }
    numbers = { TakeNumbers(
                  PointNumbersName, nullptr, whole->GetNumberOfPoints(), output->GetPointData()),
      TakeNumbers(CellNumbersName, nullptr, whole->GetNumberOfCells(), output->GetCellData()) };
  }
  if (options.OwnPrecision)
  {
    SetPrecision(blocks[block].Input->GetPoints()->GetDataType(), output);
  }
  output->GetPointData()->RemoveArray(PointBlockName);
  output->GetCellData()->RemoveArray(SelectedName);
  output->GetCellData()->RemoveArray(BlockIndexName);
  const bool hasGhosts = options.GhostLayers > 0;
  vtkPointSet* input = blocks[block].Input;
  RestoreArrays(
    joined.PointArrays, block, hasGhosts, input->GetPointData(), output->GetPointData());
  RestoreArrays(joined.CellArrays, block, hasGhosts, input->GetCellData(), output->GetCellData());
  CountInBlock(
    OriginalPointIdsName, joined.PointArrays, joined.PointPlaces[block], output->GetPointData());
  CountInBlock(
    OriginalCellIdsName, joined.CellArrays, joined.CellPlaces[block], output->GetCellData());
  if (options.GlobalIds)
  {
    AddGlobalIds(numbers.first, numbers.second, output);
  }
  if (HasStamp(whole))
  {
    WriteStampedNumbers(numbers.first, numbers.second, output);
  }
}

}

std::vector<Block> GetBlocks(
  vtkDataObject* input, bool isOfSurfaces, const std::function<void(const std::string&)>& warn)
{
  std::vector<Block> blocks;
  auto add = [&](vtkDataObject* data, unsigned int index)
  {
    auto* mesh = vtkPointSet::SafeDownCast(data);
    if (!IsAccepted(data, isOfSurfaces))
    {
      warn("Block " + std::to_string(index) + " is a " + data->GetClassName() +
        ", which this filter cannot use; it is empty in the output. Convert it to " +
        (isOfSurfaces ? "vtkPolyData" : "vtkUnstructuredGrid") + " before.");
    }
    else if (mesh->GetPoints())
    {
      blocks.push_back({ mesh, MakeMesh(isOfSurfaces), index });
    }
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    if (input)
    {
      add(input, 0);
    }
    return blocks;
  }
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    add(iterator->GetCurrentDataObject(), iterator->GetCurrentFlatIndex());
  }
  return blocks;
}

void PrepareBlocks(std::vector<Block>& blocks, bool addIndex,
  const std::function<void(vtkPointSet*, vtkPointSet*)>& prepare)
{
  for (Block& block : blocks)
  {
    const vtkSmartPointer<vtkPointSet> original = block.Input;
    block.Input = vtkSmartPointer<vtkPointSet>::Take(original->NewInstance());
    block.Input->ShallowCopy(original);
    if (addIndex)
    {
      vtkNew<vtkIntArray> indices;
      indices->SetName(BlockIndexName);
      indices->SetNumberOfValues(block.Input->GetNumberOfCells());
      indices->FillValue(static_cast<int>(block.CompositeIndex));
      block.Input->GetCellData()->AddArray(indices);
    }
    if (prepare)
    {
      prepare(original, block.Input);
    }
  }
}

void SetOutputs(
  vtkDataObject* input, const std::vector<Block>& blocks, bool isOfSurfaces, vtkDataObject* output)
{
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  if (!from || !to)
  {
    if (!blocks.empty())
    {
      output->ShallowCopy(blocks[0].Output);
    }
    return;
  }
  CopyTree(from, to);
  size_t next = 0;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(from->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const bool isBlock =
      next < blocks.size() && blocks[next].CompositeIndex == iterator->GetCurrentFlatIndex();
    to->SetDataSet(iterator, isBlock ? blocks[next].Output : MakeMesh(isOfSurfaces));
    next += isBlock ? 1 : 0;
  }
}

void AddPointBlocks(const std::vector<MeshPart>& parts, JoinedMesh& joined)
{
  const std::vector<vtkIdType> unused = FindUnusedPoints(joined.Mesh);
  if (unused.empty())
  {
    return;
  }
  vtkNew<vtkIntArray> blocks;
  blocks->SetName(PointBlockName);
  blocks->SetNumberOfValues(joined.Mesh->GetNumberOfPoints());
  blocks->FillValue(NoBlock);
  for (size_t p = parts.size(); p-- > 0;)
  {
    for (const vtkIdType place : joined.PointPlaces[p])
    {
      if (place >= 0)
      {
        blocks->SetValue(place, parts[p].Block);
      }
    }
  }
  joined.Mesh->GetPointData()->AddArray(blocks);
}

void TakeOutputs(const JoinedMesh& joined, vtkPointSet* whole, const OutputOptions& options,
  std::vector<Block>& blocks)
{
  if (blocks.size() == 1 && IsOneBlock(whole))
  {
    TakeOutput(joined, whole, options, 0, nullptr, blocks);
    return;
  }
  const auto cells = FindCellsOfBlocks(whole, static_cast<int>(blocks.size()));
  for (size_t i = 0; i < blocks.size(); ++i)
  {
    TakeOutput(joined, whole, options, static_cast<int>(i), &cells[i], blocks);
  }
}

void AddFieldData(vtkFieldData* from, bool withStamp, vtkFieldData* to)
{
  AddFieldArrays(
    from, [withStamp](vtkAbstractArray* array)
    { return withStamp || !BelongsToStamp(array->GetName()); }, to);
}

void AddGlobalIds(vtkPointSet* output)
{
  AddGlobalIds(Count(output->GetNumberOfPoints()), Count(output->GetNumberOfCells()), output);
}

}
