// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline.h"
#include "Conversion.h"
#include "Files.h"
#include "Messages.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>

namespace subdivide
{
namespace
{

bool HasArray(vtkDataObject* data, int association, const std::string& name)
{
  const auto sets = GetDataSets(data);
  return std::any_of(sets.begin(), sets.end(), [&](vtkDataSet* set)
    { return set->GetAttributesAsFieldData(association)->HasArray(name.c_str()); });
}

/// Where an array is at the other of points and cells alone, it is that.
void FindArrays(const Stage& stage)
{
  for (const auto& one : stage.Arrays)
  {
    const Option& option = *one.first;
    vtkAlgorithm* before = stage.Algorithm->GetNumberOfInputConnections(option.Port) > 0
      ? stage.Algorithm->GetInputAlgorithm(option.Port, 0)
      : nullptr;
    if (!before)
    {
      continue;
    }
    before->Update();
    vtkDataObject* data = stage.Algorithm->GetInputDataObject(option.Port, 0);
    const int other = 1 - option.Association; // points are 0, cells are 1
    if (data && !HasArray(data, option.Association, one.second) &&
      HasArray(data, other, one.second))
    {
      stage.Algorithm->SetInputArrayToProcess(
        option.Index, option.Port, 0, other, one.second.c_str());
    }
  }
}

}

void Connect(Command& command)
{
  for (std::size_t i = 0; i < command.Stages.size(); ++i)
  {
    Stage& stage = command.Stages[i];
    for (const auto& file : stage.Files)
    {
      const bool isTable = file.first->Type == Kind::Table;
      stage.Algorithm->SetInputDataObject(
        file.first->Port, isTable ? ReadTable(file.second) : ReadFile(file.second));
    }
    if (i > 0)
    {
      stage.Algorithm->SetInputConnection(0, command.Stages[i - 1].Algorithm->GetOutputPort());
    }
    else if (stage.What->HasInput)
    {
      stage.Algorithm->SetInputDataObject(0, ReadFile(command.Input));
    }
    ShowProgress(stage.Algorithm, stage.What->Label);
  }
}

vtkDataObject* Update(const Command& command)
{
  const int before = GetNumberOfErrors();
  vtkDataObject* data = nullptr;
  for (const Stage& stage : command.Stages)
  {
    FindArrays(stage);
    stage.Algorithm->Update();
    data = stage.Algorithm->GetOutputDataObject(0);
    if (!data || GetNumberOfErrors() > before)
    {
      throw Failure(std::string("the filter ") + stage.What->Name + " failed");
    }
  }
  EndProgress();
  return data;
}

Size GetSize(vtkDataObject* data)
{
  Size size;
  for (vtkDataSet* set : GetDataSets(data))
  {
    size.Cells += static_cast<double>(set->GetNumberOfCells());
    size.Points += static_cast<double>(set->GetNumberOfPoints());
    for (vtkIdType i = 0; !size.HasSolids && i < set->GetNumberOfCells(); ++i)
    {
      const int type = set->GetCellType(i);
      size.HasSolids = type >= VTK_TETRA && type <= VTK_HEXAGONAL_PRISM;
    }
  }
  size.Bytes = 1024. * static_cast<double>(data->GetActualMemorySize());
  return size;
}

}
