// SPDX-License-Identifier: BSD-3-Clause
#include "CriteriaWidget.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"

#include <QCheckBox>
#include <QVBoxLayout>

CriteriaWidget::CriteriaWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyGroupWidget(proxy, group, parent)
{
  const QString beginning = QString(group->GetXMLLabel()) + " ";
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    auto* property = group->GetProperty(i);
    QString label = property->GetXMLLabel();
    if (label.startsWith(beginning, Qt::CaseInsensitive))
    {
      label.remove(0, beginning.size());
    }
    auto* box = new QCheckBox(label, this);
    box->setObjectName(proxy->GetPropertyName(property));
    box->setToolTip(pqPropertyWidget::getTooltip(property));
    layout->addWidget(box);
    this->addPropertyLink(box, "checked", SIGNAL(toggled(bool)), property);
  }
}
