// SPDX-License-Identifier: BSD-3-Clause
#include "GroupInterface.h"

#include "AddClient.h"
#include "CollapsibleGroup.h"

#include "pqApplicationCore.h"
#include "pqInterfaceTracker.h"
#include "vtkSMPropertyGroup.h"

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
  return widget == "SubdivisionObjectsGroup" ? new CollapsibleGroup(proxy, group, parent) : nullptr;
}

void AddClient()
{
  if (auto* core = pqApplicationCore::instance())
  {
    auto* tracker = core->interfaceTracker();
    tracker->addInterface(new GroupInterface(tracker));
  }
  else if (auto* application = QCoreApplication::instance())
  {
    QTimer::singleShot(0, application,
      [] { AddClient(); }); // ParaView loads some plugins before it has made its core
  }
}
