// SPDX-License-Identifier: BSD-3-Clause
#include "UsedProperties.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSmartPointer.h"

namespace
{
/// The properties with the hint, each with the one that it names.
template <typename Call>
void ForEach(vtkSMProxy* proxy, const Call& call)
{
  auto all = vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (all->Begin(); !all->IsAtEnd(); all->Next())
  {
    auto* hints = all->GetProperty()->GetHints();
    auto* hint = hints ? hints->FindNestedElementByName("TracedIf") : nullptr;
    if (auto* used = hint ? proxy->GetProperty(hint->GetAttribute("property")) : nullptr)
    {
      call(all->GetProperty(), used);
    }
  }
}

bool IsSet(vtkSMProperty* property)
{
  const vtkSMPropertyHelper value(property);
  if (property->IsA("vtkSMProxyProperty"))
  {
    return value.GetNumberOfElements() > 0 && value.GetAsProxy();
  }
  return value.GetAsInt() != 0;
}
}

UsedProperties::UsedProperties(pqPipelineSource* source)
  : QObject(source)
  , Proxy(source->getProxy())
{
  ForEach(this->Proxy, [this](vtkSMProperty*, vtkSMProperty* used)
    { pqCoreUtilities::connect(used, vtkCommand::ModifiedEvent, this, SLOT(update())); });
  this->update();
}

void UsedProperties::update()
{
  ForEach(this->Proxy,
    [](vtkSMProperty* property, vtkSMProperty* used)
    {
      property->SetPanelVisibility(IsSet(used) ? "advanced" : "never");
      property->SetDisableSubTrace(IsSet(used) ? nullptr : "1");
    });
}

void UsedProperties::Follow()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::sourceAdded, model,
    [](pqPipelineSource* source) { new UsedProperties(source); });
}
