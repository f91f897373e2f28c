// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelectionTools.h
 * Selections of points and cells, and refinement by them.
 */
#ifndef SubdivisionObjects_SelectionTools_h
#define SubdivisionObjects_SelectionTools_h

#include "Precompiled.h"

#include "vtkIdTypeArray.h"
#include "vtkRefinementAlgorithm.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTrivialProducer.h"

namespace selection_tools
{

using Selection = vtkSmartPointer<vtkSelection>;

inline Selection MakeSelection(int field, int content, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(content);
  node->SetFieldType(field);
  node->SetSelectionList(list);
  auto selection = Selection::New();
  selection->AddNode(node);
  return selection;
}

inline Selection MakeSelection(int field, const std::vector<vtkIdType>& ids)
{
  return MakeSelection(field, vtkSelectionNode::INDICES, ids);
}

inline void RefineBy(vtkRefinementAlgorithm* filter, vtkSelection* selection)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(selection);
  filter->RefineBySelectionOn();
  filter->SetSelectionConnection(producer->GetOutputPort());
}

}

#endif
