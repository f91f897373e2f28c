// SPDX-License-Identifier: BSD-3-Clause
#include "GroupInterface.h"

#include "AddClient.h"
#include "ArrayWidget.h"
#include "ChoiceWidget.h"
#include "CollapsibleGroup.h"
#include "CountWidget.h"
#include "CriteriaWidget.h"
#include "EditBox.h"
#include "Forecast.h"
#include "ForecastWidget.h"
#include "PresetWidget.h"
#include "SearchWords.h"
#include "UsedProperties.h"

#include "pqApplicationCore.h"
#include "pqInterfaceTracker.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"

#include <QCoreApplication>
#include <QTimer>

GroupInterface::GroupInterface(QObject* parent)
  : QObject(parent)
{
}

pqPropertyWidget* GroupInterface::createWidgetForPropertyGroup(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
{
  const QString widget = group->GetPanelWidget();
  if (widget == "SubdivisionObjectsCriteria")
  {
    return new CriteriaWidget(proxy, group, parent);
  }
  if (widget == "SubdivisionObjectsBox")
  {
    return new EditBox(proxy, group, parent);
  }
  return widget == "SubdivisionObjectsGroup" ? new CollapsibleGroup(proxy, group, parent) : nullptr;
}

pqPropertyWidget* GroupInterface::createWidgetForProperty(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
{
  const QString widget = property->GetPanelWidget();
  if (widget == "SubdivisionObjectsCount")
  {
    return new CountWidget(proxy, property, parent);
  }
  if (widget == "SubdivisionObjectsForecast")
  {
    return new ForecastWidget(proxy, property, parent);
  }
  if (widget == "SubdivisionObjectsPresets")
  {
    return new PresetWidget(proxy, property, parent);
  }
  if (ArrayWidget::IsFor(property))
  {
    return new ArrayWidget(proxy, property, parent);
  }
  return ChoiceWidget::IsFor(property) ? new ChoiceWidget(proxy, property, parent) : nullptr;
}

void AddClient()
{
  if (auto* core = pqApplicationCore::instance())
  {
    auto* tracker = core->interfaceTracker();
    tracker->addInterface(new GroupInterface(tracker));
    QObject::connect(core->getObjectBuilder(), &pqObjectBuilder::filterCreated, tracker,
      [](pqPipelineSource* filter)
      {
        auto* proxy = filter->getProxy();
        // Levels of the output, not of a mesh around it, and no limit of levels. Solids from labels
        // take long, and have no limit of cells.
        if (proxy->GetProperty("NextApply") && proxy->GetProperty("OutputCells") &&
          proxy->GetProperty("NumberOfLevels") && proxy->GetProperty("MaximumNumberOfCells"))
        {
          SetFirstLevels(proxy);
        }
      });
    SearchWords::Add();
    UsedProperties::Follow();
  }
  else if (auto* application = QCoreApplication::instance())
  {
    QTimer::singleShot(0, application,
      [] { AddClient(); }); // ParaView loads some plugins before it has made its core
  }
}
