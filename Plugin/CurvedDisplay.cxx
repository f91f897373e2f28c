// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedDisplay.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace
{
constexpr int LevelOfCurved = 3; ///< an edge is drawn as eight lines

/// Whether a filter's output has, or may have, curved lines. VTK up to 9.2 crashes where it draws
/// these in more than two parts. Outputs on a server are not looked at.
bool MayHaveLines(vtkSMProxy* source)
{
  auto* const filter = vtkSMSourceProxy::SafeDownCast(source);
  auto* const made = vtkAlgorithm::SafeDownCast(source->GetClientSideObject());
  if (!filter || !made)
  {
    return true;
  }
  filter->UpdatePipeline(); // a script may show what was not made yet
  const auto isLine = [](double type)
  { return type == VTK_QUADRATIC_EDGE || type == VTK_LAGRANGE_CURVE; };
  for (auto* mesh :
    vtkCompositeDataSet::GetDataSets<vtkUnstructuredGrid>(made->GetOutputDataObject(0)))
  {
    vtkUnsignedCharArray* const types = mesh->GetDistinctCellTypesArray();
    for (vtkIdType i = 0; i < types->GetNumberOfTuples(); ++i)
    {
      if (isLine(types->GetComponent(i, 0)))
      {
        return true;
      }
    }
  }
  return false;
}

/// A display is registered once it has its input, and before it is drawn.
void SetLevel(vtkObject*, unsigned long, void*, void* data)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  vtkSMProxy* display = registered ? registered->Proxy : nullptr;
  if (!display || !display->GetProperty("NonlinearSubdivisionLevel") ||
    !display->GetProperty("Input") || !display->GetSessionProxyManager() ||
    display->GetSessionProxyManager()->GetInLoadXMLState()) // a state has its own level
  {
    return;
  }
  vtkSMProxy* source = vtkSMPropertyHelper(display, "Input").GetAsProxy();
  if (source && source->GetProperty("OutputCells") &&
    vtkSMPropertyHelper(source, "OutputCells").GetAsInt() != 0)
  {
    vtkSMPropertyHelper level(display, "NonlinearSubdivisionLevel");
    const bool isFine = level.GetAsInt() >= LevelOfCurved || MayHaveLines(source);
    isFine ? void() : level.Set(LevelOfCurved);
  }
}

/// Sessions come before or after plugins.
void Follow(vtkObject*, unsigned long, void*, void*)
{
  static bool follows = false;
  if (!follows && vtkSMProxyManager::IsInitialized())
  {
    follows = true;
    vtkNew<vtkCallbackCommand> registers;
    registers->SetCallback(SetLevel);
    vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, registers);
  }
}
}

void AddCurvedDisplay()
{
  vtkNew<vtkCallbackCommand> created;
  created->SetCallback(Follow);
  vtkProcessModule::GetProcessModule()->AddObserver(vtkCommand::ConnectionCreatedEvent, created);
  Follow(nullptr, 0, nullptr, nullptr);
}
