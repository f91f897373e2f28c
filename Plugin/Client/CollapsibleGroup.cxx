// SPDX-License-Identifier: BSD-3-Clause
#include "CollapsibleGroup.h"

#include "pqApplicationCore.h"
#include "pqPropertiesPanel.h"
#include "pqPropertyWidgetDecorator.h"
#include "pqProxyWidget.h"
#include "pqSearchBox.h"
#include "pqSettings.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMVectorProperty.h"

#include <QCoreApplication>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <cstring>

namespace
{
// UsedProperties makes these "never" while nothing uses them; the group shows them all the same.
bool IsTracedIfUsed(vtkSMProperty* property)
{
  auto* hints = property->GetHints();
  return hints && hints->FindNestedElementByName("TracedIf");
}

bool HasProxy(const vtkSMPropertyHelper& helper)
{
  return helper.GetNumberOfElements() > 0 && helper.GetAsProxy();
}

// Neither was anything, nor is it to be.
bool IsUnusedInput(vtkSMProperty* property)
{
  return property && IsTracedIfUsed(property) && !HasProxy(vtkSMPropertyHelper(property)) &&
    !HasProxy(vtkSMUncheckedPropertyHelper(property));
}

// A pqProxyWidget shows all properties that it is given, those that a filter withdrew ("never"),
// too.
QStringList ShownProperties(vtkSMProxy* proxy, vtkSMPropertyGroup* group)
{
  QStringList names;
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    auto* property = group->GetProperty(i);
    const char* visibility = property->GetPanelVisibility();
    if (!visibility || std::strcmp(visibility, "never") != 0 || IsTracedIfUsed(property))
    {
      names << proxy->GetPropertyName(property);
    }
  }
  return names;
}

// What comes from the input (arrays, ranges) and proxies (functions, selections) have no default to
// compare with. An array that starts as None has: its property says so.
bool IsChanged(vtkSMProperty* property)
{
  auto* hints = property->GetHints();
  const bool startsAsNone = hints && hints->FindNestedElementByName("NoDefault");
  const bool hasDefault = startsAsNone || !property->HasDomainsWithRequiredProperties();
  return vtkSMVectorProperty::SafeDownCast(property) && hasDefault && !property->IsValueDefault();
}

bool HasChanges(vtkSMPropertyGroup* group)
{
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    if (IsChanged(group->GetProperty(i)))
    {
      return true;
    }
  }
  return false;
}
}

CollapsibleGroup::CollapsibleGroup(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyGroupWidget(proxy, group, parent)
  , Properties(
      new pqProxyWidget(proxy, ShownProperties(proxy, group), /* showHeadersFooters */ false, this))
  , Heading(new QToolButton(this))
  , Label(QCoreApplication::translate("ServerManagerXML", group->GetXMLLabel()))
  , SettingsKey(QString("SubdivisionObjects/OpenGroups/%1").arg(group->GetName()))
{
  this->setShowLabel(false);
  this->setChangeAvailableAsChangeFinished(false); // the properties tell both
  this->Properties->setObjectName("Properties");

  this->Heading->setObjectName("Heading");
  this->Heading->setCheckable(true);
  this->Heading->setAutoRaise(true);
  this->Heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->Heading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto font = this->Heading->font();
  font.setBold(true);
  this->Heading->setFont(font);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(pqPropertiesPanel::suggestedVerticalSpacing());
  layout->addWidget(this->Heading);
  layout->addWidget(this->Properties);

  QObject::connect(
    this->Heading, &QToolButton::clicked, this, [this](bool open) { this->toggle(open); });
  QObject::connect(
    this->Properties, &pqProxyWidget::changeAvailable, this, &pqPropertyWidget::changeAvailable);
  QObject::connect(
    this->Properties, &pqProxyWidget::changeFinished, this, &pqPropertyWidget::changeFinished);
  QObject::connect(
    this->Properties, &pqProxyWidget::restartRequired, this, &pqPropertyWidget::restartRequired);
  this->followDecorators();
  this->updateHeading();
}

// Where another property hides all of a group, its heading is to go, too.
void CollapsibleGroup::followDecorators()
{
  for (auto* widget : this->Properties->findChildren<pqPropertyWidget*>())
  {
    for (const auto& decorator : widget->decorators())
    {
      QObject::connect(decorator, &pqPropertyWidgetDecorator::visibilityChanged, this,
        [this] { QTimer::singleShot(0, this, [this] { this->arrange(); }); });
    }
  }
}

void CollapsibleGroup::apply()
{
  // Not Properties->apply(), which would trace each change a second time.
  for (auto* widget :
    this->Properties->findChildren<pqPropertyWidget*>(QString(), Qt::FindDirectChildrenOnly))
  {
    if (IsUnusedInput(widget->property())) // which ParaView would set, and trace, all the same
    {
      continue;
    }
    widget->apply();
  }
  this->updateHeading();
}

void CollapsibleGroup::reset()
{
  this->Properties->reset();
  this->updateHeading();
}

void CollapsibleGroup::setView(pqView* view)
{
  pqPropertyGroupWidget::setView(view);
  this->Properties->setView(view);
}

void CollapsibleGroup::updateWidget(bool showsAdvanced)
{
  this->ShowsAdvanced = showsAdvanced;
}

void CollapsibleGroup::setVisible(bool wanted)
{
  this->IsWanted = wanted;
  this->arrange();
}

void CollapsibleGroup::arrange()
{
  const auto text = this->searchText();
  bool isOpen = true;
  bool isShown = false;
  if (!text.isEmpty())
  {
    const bool all = this->Label.contains(text, Qt::CaseInsensitive);
    isShown = this->Properties->filterWidgets(true, all ? QString() : text);
  }
  else if (this->IsWanted)
  {
    isOpen = pqApplicationCore::instance()->settings()->value(this->SettingsKey, false).toBool();
    isShown = this->Properties->filterWidgets(this->ShowsAdvanced);
  }
  this->Heading->setChecked(isOpen);
  this->Heading->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
  this->updateHeading();
  this->Properties->setVisible(isOpen);
  pqPropertyGroupWidget::setVisible(isShown);
}

void CollapsibleGroup::updateHeading()
{
  this->Heading->setText(
    HasChanges(this->propertyGroup()) ? this->Label + " (changed)" : this->Label);
}

void CollapsibleGroup::toggle(bool open)
{
  pqApplicationCore::instance()->settings()->setValue(this->SettingsKey, open);
  this->arrange();
}

QString CollapsibleGroup::searchText() const
{
  for (auto* parent = this->parentWidget(); parent; parent = parent->parentWidget())
  {
    if (auto* box = parent->findChild<pqSearchBox*>())
    {
      return box->text();
    }
    if (parent->isWindow() || qobject_cast<pqPropertiesPanel*>(parent))
    {
      break;
    }
  }
  return QString();
}
