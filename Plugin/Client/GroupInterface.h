// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GroupInterface.h
 * How ParaView's client finds the widgets of this folder.
 */
#ifndef SubdivisionObjects_GroupInterface_h
#define SubdivisionObjects_GroupInterface_h

#include "pqPropertyWidgetInterface.h"

#include <QObject>

class GroupInterface
  : public QObject
  , public pqPropertyWidgetInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface)
public:
  explicit GroupInterface(QObject* parent);

  pqPropertyWidget* createWidgetForProperty(
    vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent) override;
  pqPropertyWidget* createWidgetForPropertyGroup(
    vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent) override;
};

#endif
