// SPDX-License-Identifier: BSD-3-Clause
#include "PresetWidget.h"

#include "pqCoreUtilities.h"
#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QComboBox>
#include <QVBoxLayout>

#include <sstream>

namespace
{
vtkSMIntVectorProperty* Find(vtkSMProxy* proxy, const std::string& name)
{
  return vtkSMIntVectorProperty::SafeDownCast(proxy->GetProperty(name.c_str()));
}

std::vector<int> GetDefault(vtkSMProxy* proxy, const std::string& name)
{
  auto* prototype =
    proxy->GetSessionProxyManager()->GetPrototypeProxy(proxy->GetXMLGroup(), proxy->GetXMLName());
  return vtkSMPropertyHelper(Find(prototype, name)).GetIntArray();
}
}

PresetWidget::PresetWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Box(new QComboBox(this))
{
  auto* hints = property->GetHints();
  for (unsigned int i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    auto* preset = hints->GetNestedElement(i);
    this->Presets.push_back(preset);
    this->Box->addItem(preset->GetAttribute("text"));
    for (unsigned int k = 0; k < preset->GetNumberOfNestedElements(); ++k)
    {
      this->Names.insert(preset->GetNestedElement(k)->GetAttribute("property"));
    }
  }
  this->Box->addItem("Own choice");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Box);
  for (const auto& name : this->Names)
  {
    auto* changed = Find(proxy, name);
    pqCoreUtilities::connect(changed, vtkCommand::ModifiedEvent, this, SLOT(tell()));
    pqCoreUtilities::connect(
      changed, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(tell()));
  }
  QObject::connect(this->Box, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index) { this->choose(index); });
  this->tell();
}

std::vector<int> PresetWidget::getValues(vtkPVXMLElement* preset, const std::string& name) const
{
  for (unsigned int i = 0; i < preset->GetNumberOfNestedElements(); ++i)
  {
    auto* set = preset->GetNestedElement(i);
    if (name == set->GetAttribute("property"))
    {
      std::istringstream numbers(set->GetAttribute("value"));
      std::vector<int> values;
      for (int value = 0; numbers >> value;)
      {
        values.push_back(value);
      }
      return values;
    }
  }
  return GetDefault(this->proxy(), name);
}

bool PresetWidget::isChosen(vtkPVXMLElement* preset) const
{
  for (const auto& name : this->Names)
  {
    if (vtkSMUncheckedPropertyHelper(Find(this->proxy(), name)).GetIntArray() !=
      this->getValues(preset, name))
    {
      return false;
    }
  }
  return true;
}

void PresetWidget::tell()
{
  if (this->IsChoosing)
  {
    return;
  }
  std::size_t index = 0;
  while (index < this->Presets.size() && !this->isChosen(this->Presets[index]))
  {
    ++index;
  }
  this->Box->setCurrentIndex(static_cast<int>(index));
}

void PresetWidget::choose(int index)
{
  if (index < static_cast<int>(this->Presets.size()))
  {
    this->IsChoosing = true;
    for (const auto& name : this->Names)
    {
      const auto values = this->getValues(this->Presets[index], name);
      vtkSMUncheckedPropertyHelper(Find(this->proxy(), name))
        .Set(values.data(), static_cast<unsigned int>(values.size()));
    }
    this->IsChoosing = false;
    Q_EMIT this->changeAvailable();
  }
  this->tell();
}

void PresetWidget::apply()
{
  // What no widget of the panel would take over.
  for (const auto& name : this->Names)
  {
    auto* property = Find(this->proxy(), name);
    const auto values = vtkSMUncheckedPropertyHelper(property).GetIntArray();
    vtkSMPropertyHelper(property).Set(values.data(), static_cast<unsigned int>(values.size()));
  }
}

void PresetWidget::reset()
{
  for (const auto& name : this->Names)
  {
    Find(this->proxy(), name)->ClearUncheckedElements();
  }
  this->tell();
}
