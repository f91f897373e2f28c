// SPDX-License-Identifier: BSD-3-Clause
#include "ServerManagerClasses.h"

#include "SolidsVolume.h"

#include "vtkCallbackCommand.h"
#include "vtkClientServerInterpreter.h"
#include "vtkClientServerInterpreterInitializer.h"
#include "vtkNew.h"
#include "vtkPVSessionBase.h"
#include "vtkPVXMLElement.h"
#include "vtkProcessModule.h"
#include "vtkSIProxyDefinitionManager.h"
#include "vtkSessionIterator.h"
#include "vtkSmartPointer.h"

namespace
{
constexpr const char* VolumeClass = "vtkSubdivisionSolidsVolume";

template <typename Class>
vtkObjectBase* Make(void*)
{
  return Class::New();
}

void AddTo(vtkClientServerInterpreter* interpreter)
{
  interpreter->AddNewInstanceFunction(VolumeClass, Make<SolidsVolume>);
}

/// The Volume representation of grids has the class of this plugin then, with ParaView's
/// properties.
void TakeSolidsVolume(vtkObject*, unsigned long, void*, void*)
{
  auto all = vtkSmartPointer<vtkSessionIterator>::Take(
    vtkProcessModule::GetProcessModule()->NewSessionIterator());
  for (all->InitTraversal(); !all->IsDoneWithTraversal(); all->GoToNextItem())
  {
    auto* session = vtkPVSessionBase::SafeDownCast(all->GetCurrentSession());
    auto* definitions = session ? session->GetProxyDefinitionManager() : nullptr;
    auto* volume = definitions ? definitions->GetProxyDefinition(
                                   "representations", "UnstructuredGridVolumeRepresentation", false)
                               : nullptr;
    if (volume)
    {
      volume->SetAttribute("class", VolumeClass);
    }
  }
}
}

void AddServerManagerClasses()
{
  vtkClientServerInterpreterInitializer::GetInitializer()->RegisterCallback(AddTo);
  vtkNew<vtkCallbackCommand> created;
  created->SetCallback(TakeSolidsVolume);
  vtkProcessModule::GetProcessModule()->AddObserver(vtkCommand::ConnectionCreatedEvent, created);
  TakeSolidsVolume(nullptr, 0, nullptr, nullptr); // of sessions that there are
}
