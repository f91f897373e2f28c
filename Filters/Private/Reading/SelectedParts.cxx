// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/SelectedParts.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/UnusedPoints.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkExecutive.h"
#include "vtkExtractSelection.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSignedCharArray.h"

#include <algorithm>

namespace subdivision
{
namespace
{

constexpr const char* InsideName = "vtkInsidedness";

/// act(mesh, mesh of `other` at the same position) for all meshes of a data object.
template <typename Act>
void ForMeshes(vtkDataObject* object, vtkDataObject* other, const Act& act)
{
  auto* all = vtkCompositeDataSet::SafeDownCast(object);
  auto* others = vtkCompositeDataSet::SafeDownCast(other);
  if (!all)
  {
    act(vtkPointSet::SafeDownCast(object), other);
    return;
  }
  auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(all->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    auto* mesh = vtkPointSet::SafeDownCast(at->GetCurrentDataObject());
    if (mesh)
    {
      act(mesh, others ? others->GetDataSet(at) : nullptr);
    }
  }
}

vtkSmartPointer<vtkDataSet> MakeBare(vtkDataSet* mesh)
{
  auto bare = vtkSmartPointer<vtkDataSet>::Take(mesh->NewInstance());
  bare->ShallowCopy(mesh);
  bare->GetCellData()->RemoveArray(InsideName);
  bare->GetPointData()->RemoveArray(InsideName);
  return bare;
}

/// A shallow copy of the input without arrays of the name InsideName, which VTK gives to its
/// result.
vtkSmartPointer<vtkDataObject> MakeBare(vtkDataObject* input)
{
  auto* all = vtkCompositeDataSet::SafeDownCast(input);
  if (!all)
  {
    return MakeBare(vtkDataSet::SafeDownCast(input));
  }
  auto bare = vtkSmartPointer<vtkCompositeDataSet>::Take(all->NewInstance());
  bare->CopyStructure(all);
  auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(all->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    auto* mesh = vtkDataSet::SafeDownCast(at->GetCurrentDataObject());
    bare->SetDataSet(at, mesh ? MakeBare(mesh).Get() : at->GetCurrentDataObject());
  }
  return bare;
}

vtkDataArray* GetInsidedness(vtkDataSetAttributes* data, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(InsideName);
  return array && array->GetNumberOfTuples() == tuples ? array : nullptr;
}

/// The flags that VTK found on one mesh for nodes of one kind.
std::vector<unsigned char> ReadFlags(vtkDataArray* array)
{
  std::vector<unsigned char> flags;
  for (const vtkIdType i : InTurn(array ? array->GetNumberOfTuples() : vtkIdType(0)))
  {
    flags.push_back(array->GetComponent(i, 0) > 0);
  }
  if (std::none_of(flags.begin(), flags.end(), [](unsigned char flag) { return flag != 0; }))
  {
    flags.clear();
  }
  return flags;
}

SelectedParts ReadAnswer(vtkPointSet* mesh, vtkDataSet* answer)
{
  SelectedParts selected;
  vtkDataArray* ofCells = GetInsidedness(answer->GetCellData(), mesh->GetNumberOfCells());
  selected.Cells = ReadFlags(ofCells);
  if (!ofCells)
  {
    selected.Points = ReadFlags(GetInsidedness(answer->GetPointData(), mesh->GetNumberOfPoints()));
    vtkIdTypeArray* became = GetMergedPoints(mesh);
    for (const size_t i : InTurn(became ? selected.Points.size() : 0))
    {
      if (selected.Points[i])
      {
        selected.Points[became->GetValue(static_cast<vtkIdType>(i))] = 1;
      }
    }
  }
  return selected;
}

using SelectedOfMeshes = std::map<vtkDataObject*, SelectedParts>;

/// Flags the cells that are selected or have a selected point.
SelectedCells FindTouched(const SelectedOfMeshes& selected)
{
  SelectedCells touched;
  for (const auto& of : selected)
  {
    auto* mesh = vtkPointSet::SafeDownCast(of.first);
    const std::vector<unsigned char>& points = of.second.Points;
    if (points.empty())
    {
      touched[mesh] = of.second.Cells;
      continue;
    }
    const CellReader cells(mesh);
    std::vector<unsigned char> flags;
    std::vector<vtkIdType> scratch;
    for (const vtkIdType i : InTurn(cells.GetNumberOfCells()))
    {
      const CellIds ids = cells.GetCell(i, scratch);
      flags.push_back(std::any_of(ids.Ids, ids.Ids + ids.Size, [&](vtkIdType point)
        { return point >= 0 && point < static_cast<vtkIdType>(points.size()) && points[point]; }));
    }
    if (std::find(flags.begin(), flags.end(), 1) != flags.end())
    {
      touched[mesh] = std::move(flags);
    }
  }
  return touched;
}

bool IsOfNumbers(vtkAbstractArray* array)
{
  return vtkDataArray::SafeDownCast(array) != nullptr;
}

/// Whether the values of a node can be compared with values of the input.
bool IsComparable(vtkDataObject* input, vtkSelectionNode* node)
{
  vtkAbstractArray* list = node->GetSelectionList();
  const bool areIds = node->GetContentType() == vtkSelectionNode::PEDIGREEIDS;
  if (!areIds && node->GetContentType() != vtkSelectionNode::VALUES)
  {
    return IsOfNumbers(list);
  }
  bool isComparable = true;
  ForMeshes(input, nullptr,
    [&](vtkPointSet* mesh, vtkDataObject*)
    {
      vtkDataSetAttributes* data =
        mesh->GetAttributes(node->GetFieldType() == vtkSelectionNode::CELL ? vtkDataObject::CELL
                                                                           : vtkDataObject::POINT);
      vtkAbstractArray* array = areIds ? data->GetPedigreeIds()
        : list->GetName()              ? data->GetAbstractArray(list->GetName())
                                       : data->GetScalars();
      isComparable = isComparable && (!array || IsOfNumbers(array) == IsOfNumbers(list));
    });
  return isComparable;
}

/// Why VTK cannot evaluate a node, or would crash on it; empty if it can.
std::string FindFault(vtkDataObject* input, vtkSelectionNode* node)
{
  const int content = node->GetContentType();
  const int field = node->GetFieldType();
  vtkAbstractArray* list = node->GetSelectionList();
  if (field != vtkSelectionNode::CELL && field != vtkSelectionNode::POINT)
  {
    return "is neither of cells nor of points";
  }
  if (content < 0 || content > vtkSelectionNode::BLOCKS)
  {
    return content == vtkSelectionNode::QUERY
      ? "is a query in text form: freeze the selection first, so that it consists of ids"
      : "has a content type (" + std::to_string(content) + ") that is not supported";
  }
  if (!list)
  {
    return "has no list";
  }
  if (content == vtkSelectionNode::FRUSTUM &&
    (list->GetNumberOfValues() != 32 || list->GetDataType() != VTK_DOUBLE))
  {
    return "is a frustum, but does not have 32 numbers in double precision";
  }
  if (content == vtkSelectionNode::THRESHOLDS && list->GetNumberOfValues() % 2 > 0)
  {
    return "has a threshold with one number instead of two";
  }
  if (!IsComparable(input, node))
  {
    return "has text where the input has numbers, or numbers where it has text";
  }
  return "";
}

/// Whether VTK can read the expression. Its filter may crash on one that it cannot read.
bool IsReadable(vtkSelection* selection)
{
  std::vector<vtkSmartPointer<vtkSignedCharArray>> arrays;
  std::vector<vtkSignedCharArray*> values;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    arrays.push_back(vtkSmartPointer<vtkSignedCharArray>::New());
    arrays.back()->InsertNextValue(0);
    values.push_back(arrays.back());
  }
  const auto result = selection->Evaluate(values.data(), static_cast<unsigned int>(values.size()));
  return result != nullptr;
}

struct ErrorCounter
{
  int Errors = 0;
  void Count(vtkObject*, unsigned long, void*) { ++this->Errors; }
};

/// Lets VTK evaluate a selection whose nodes are all of cells, or all of points.
SelectedOfMeshes Extract(vtkDataObject* input, vtkDataObject* bare, vtkSelection* selection,
  const std::function<void(const std::string&)>& fail)
{
  vtkNew<vtkExtractSelection> extract;
  ErrorCounter counter;
  extract->AddObserver(vtkCommand::ErrorEvent, &counter, &ErrorCounter::Count);
  extract->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, &counter, &ErrorCounter::Count);
  extract->SetPreserveTopology(true);
  extract->SetInputData(0, bare);
  extract->SetInputData(1, selection);
  extract->Update();
  if (counter.Errors > 0)
  {
    fail(
      "Its nodes or its expression \"" + selection->GetExpression() + "\" do not fit the input.");
    return SelectedOfMeshes();
  }
  SelectedOfMeshes found;
  ForMeshes(input, extract->GetOutputDataObject(0),
    [&found](vtkPointSet* mesh, vtkDataObject* object)
    {
      vtkDataSet* answer = vtkDataSet::SafeDownCast(object);
      SelectedParts parts = answer ? ReadAnswer(mesh, answer) : SelectedParts();
      if (!parts.Cells.empty() || !parts.Points.empty())
      {
        found[mesh] = std::move(parts);
      }
    });
  return found;
}

/// Combines the cells of the nodes by the expression of the selection.
std::vector<unsigned char> Combine(
  vtkSelection* selection, vtkPointSet* mesh, const std::vector<SelectedCells>& byNode)
{
  std::vector<vtkSmartPointer<vtkSignedCharArray>> arrays;
  std::vector<vtkSignedCharArray*> values;
  for (const SelectedCells& node : byNode)
  {
    arrays.push_back(vtkSmartPointer<vtkSignedCharArray>::New());
    arrays.back()->SetNumberOfValues(mesh->GetNumberOfCells());
    arrays.back()->FillValue(0);
    const auto cells = node.find(mesh);
    if (cells != node.end())
    {
      std::copy(cells->second.begin(), cells->second.end(), arrays.back()->GetPointer(0));
    }
    values.push_back(arrays.back());
  }
  std::vector<unsigned char> selected;
  const auto result = selection->Evaluate(values.data(), static_cast<unsigned int>(values.size()));
  if (result && result->GetNumberOfValues() == mesh->GetNumberOfCells() &&
    result->GetValueRange()[1] > 0)
  {
    selected.assign(result->GetPointer(0), result->GetPointer(0) + result->GetNumberOfValues());
  }
  return selected;
}

/// Lets VTK evaluate a selection: once if all of its nodes are of one kind, else node by node,
/// because VTK cannot evaluate nodes of points together with nodes of cells. Empty after a fault,
/// of which `fail` is told.
std::vector<SelectedOfMeshes> Evaluate(vtkDataObject* input, vtkDataObject* readable,
  vtkSelection* selection, const std::function<void(const std::string&)>& fail)
{
  const unsigned int nodes = selection ? selection->GetNumberOfNodes() : 0;
  std::vector<SelectedOfMeshes> found;
  if (nodes == 0)
  {
    return found;
  }
  for (unsigned int i = 0; i < nodes; ++i)
  {
    const std::string fault = FindFault(readable, selection->GetNode(i));
    if (!fault.empty())
    {
      fail("Node " + std::to_string(i) + " " + fault + ".");
      return found;
    }
  }
  if (!IsReadable(selection))
  {
    fail("Its expression \"" + selection->GetExpression() + "\" cannot be read.");
    return found;
  }
  const auto bare = MakeBare(input);
  bool isOfOneKind = true;
  for (unsigned int i = 1; i < nodes; ++i)
  {
    isOfOneKind =
      isOfOneKind && selection->GetNode(i)->GetFieldType() == selection->GetNode(0)->GetFieldType();
  }
  if (isOfOneKind)
  {
    found.push_back(Extract(readable, bare, selection, fail));
    return found;
  }
  for (unsigned int i = 0; i < nodes; ++i)
  {
    vtkNew<vtkSelection> one;
    one->AddNode(selection->GetNode(i));
    found.push_back(Extract(readable, bare, one, fail));
  }
  return found;
}

void Join(const std::vector<unsigned char>& more, std::vector<unsigned char>& flags)
{
  flags.resize(std::max(flags.size(), more.size()), 0);
  for (const size_t i : InTurn(more.size()))
  {
    flags[i] |= more[i];
  }
}

}

SelectedCells FindSelectedCells(vtkDataObject* input, vtkDataObject* readable,
  vtkSelection* selection, const std::function<void(const std::string&)>& fail)
{
  std::vector<SelectedCells> byNode;
  for (const SelectedOfMeshes& parts : Evaluate(input, readable, selection, fail))
  {
    byNode.push_back(FindTouched(parts));
  }
  if (byNode.size() < 2)
  {
    return byNode.empty() ? SelectedCells() : byNode[0];
  }
  SelectedCells found;
  ForMeshes(readable, nullptr,
    [&](vtkPointSet* mesh, vtkDataObject*)
    {
      std::vector<unsigned char> cells = Combine(selection, mesh, byNode);
      if (!cells.empty())
      {
        found[mesh] = std::move(cells);
      }
    });
  return found;
}

std::map<vtkDataObject*, SelectedParts> FindSelectedParts(vtkDataObject* input,
  vtkDataObject* readable, vtkSelection* selection,
  const std::function<void(const std::string&)>& fail)
{
  SelectedOfMeshes found;
  for (const SelectedOfMeshes& some : Evaluate(input, readable, selection, fail))
  {
    for (const auto& of : some)
    {
      Join(of.second.Points, found[of.first].Points);
      Join(of.second.Cells, found[of.first].Cells);
    }
  }
  return found;
}

}
