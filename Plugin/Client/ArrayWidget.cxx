// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayWidget.h"

#include "pqCoreUtilities.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkSMArrayListDomain.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QComboBox>
#include <QIcon>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <string>

ArrayWidget::ArrayWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Array(property)
  , Box(new QComboBox(this))
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Box);
  auto* domain = property->FindDomain<vtkSMArrayListDomain>();
  pqCoreUtilities::connect(domain, vtkCommand::DomainModifiedEvent, this, SLOT(fill()));
  pqCoreUtilities::connect(property, vtkCommand::ModifiedEvent, this, SLOT(fill()));
  pqCoreUtilities::connect(
    property, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(fill()));
  QObject::connect(this->Box, &QComboBox::textActivated, this,
    [this](const QString& name) { this->choose(name); });
  this->fill();
}

bool ArrayWidget::IsFor(vtkSMProperty* property)
{
  auto* array = vtkSMStringVectorProperty::SafeDownCast(property);
  auto* domain = property->FindDomain<vtkSMArrayListDomain>();
  return array && domain && domain->GetNoneString() && array->GetNumberOfElements() == 5 &&
    array->GetDefaultValue(3) == std::to_string(vtkDataObject::CELL) &&
    std::string(array->GetDefaultValue(4)) == domain->GetNoneString();
}

void ArrayWidget::fill()
{
  const QSignalBlocker blocker(this->Box);
  auto* domain = this->Array->FindDomain<vtkSMArrayListDomain>();
  const QString chosen = vtkSMUncheckedPropertyHelper(this->Array).GetInputArrayNameToProcess();
  this->Box->clear();
  for (unsigned int i = 0; i < domain->GetNumberOfStrings(); ++i)
  {
    const QString name = domain->GetString(i);
    this->Box->addItem(
      name == domain->GetNoneString() ? QIcon() : QIcon(":/pqWidgets/Icons/pqCellData.svg"), name);
  }
  if (this->Box->findText(chosen) < 0) // the input no longer has it
  {
    this->Box->addItem(chosen);
  }
  this->Box->setCurrentIndex(this->Box->findText(chosen));
}

void ArrayWidget::choose(const QString& name)
{
  vtkSMUncheckedPropertyHelper(this->Array)
    .SetInputArrayToProcess(vtkDataObject::CELL, name.toUtf8().data());
  Q_EMIT this->changeAvailable();
}

void ArrayWidget::apply()
{
  const vtkSMUncheckedPropertyHelper chosen(this->Array);
  const std::string name = chosen.GetInputArrayNameToProcess();
  vtkSMPropertyHelper(this->Array)
    .SetInputArrayToProcess(chosen.GetInputArrayAssociation(), name.c_str());
}

void ArrayWidget::reset()
{
  this->Array->ClearUncheckedElements();
  this->fill();
}
