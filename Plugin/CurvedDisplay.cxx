// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedDisplay.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

namespace
{
constexpr int LevelOfCurved = 3; ///< an edge is drawn as eight lines

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
    level.GetAsInt() < LevelOfCurved ? level.Set(LevelOfCurved) : void();
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
