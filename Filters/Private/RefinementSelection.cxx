// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementSelection.h"

#include "CellReader.h"

#include "vtkCellData.h"
#include "vtkExtractSelection.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The selection for one block: nodes that are for other blocks select nothing, but stay, because
/// an expression may name them.
vtkSmartPointer<vtkSelection> ForBlock(vtkSelection* selection, unsigned int block)
{
  auto result = vtkSmartPointer<vtkSelection>::New();
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    vtkInformation* properties = node->GetProperties();
    const bool isElsewhere = block > 0 && properties->Has(vtkSelectionNode::COMPOSITE_INDEX()) &&
      properties->Get(vtkSelectionNode::COMPOSITE_INDEX()) != static_cast<int>(block);
    vtkNew<vtkSelectionNode> copy;
    if (isElsewhere)
    {
      vtkNew<vtkIdTypeArray> nothing;
      copy->SetContentType(vtkSelectionNode::INDICES);
      copy->SetFieldType(node->GetFieldType());
      copy->SetSelectionList(nothing);
    }
    else
    {
      copy->ShallowCopy(node);
      copy->GetProperties()->Remove(vtkSelectionNode::COMPOSITE_INDEX());
    }
    result->SetNode(selection->GetNodeNameAtIndex(i), copy);
  }
  result->SetExpression(selection->GetExpression());
  return result;
}

vtkDataArray* GetInsidedness(vtkDataSetAttributes* data, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray("vtkInsidedness");
  return array && array->GetNumberOfTuples() == tuples ? array : nullptr;
}

}

std::vector<unsigned char> FindSelectedCells(
  vtkPointSet* input, vtkSelection* selection, unsigned int block)
{
  std::vector<unsigned char> selected;
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return selected;
  }
  // An array by that name that the input has already would be taken for the answer.
  auto bare = vtkSmartPointer<vtkPointSet>::Take(input->NewInstance());
  bare->ShallowCopy(input);
  bare->GetCellData()->RemoveArray("vtkInsidedness");
  bare->GetPointData()->RemoveArray("vtkInsidedness");
  vtkNew<vtkExtractSelection> extract;
  extract->SetPreserveTopology(true);
  extract->SetInputData(0, bare);
  extract->SetInputData(1, ForBlock(selection, block));
  extract->Update();
  auto* result = vtkDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  if (!result)
  {
    return selected;
  }
  const CellReader cells(input);
  vtkDataArray* ofCells = GetInsidedness(result->GetCellData(), input->GetNumberOfCells());
  vtkDataArray* ofPoints = GetInsidedness(result->GetPointData(), input->GetNumberOfPoints());
  if (!ofCells && !ofPoints)
  {
    return selected;
  }
  selected.resize(input->GetNumberOfCells(), 0);
  std::vector<vtkIdType> scratch;
  for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i)
  {
    const CellIds ids = cells.GetCell(i, scratch);
    selected[i] = (ofCells && ofCells->GetComponent(i, 0) > 0) ||
      (!ofCells &&
        std::any_of(ids.Ids, ids.Ids + ids.Size,
          [&](vtkIdType point)
          {
            return point >= 0 && point < ofPoints->GetNumberOfTuples() &&
              ofPoints->GetComponent(point, 0) > 0;
          }));
  }
  if (std::none_of(selected.begin(), selected.end(), [](unsigned char s) { return s != 0; }))
  {
    selected.clear();
  }
  return selected;
}

}
