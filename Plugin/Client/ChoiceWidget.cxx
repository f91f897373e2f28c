// SPDX-License-Identifier: BSD-3-Clause
#include "ChoiceWidget.h"

#include "vtkSMEnumerationDomain.h"
#include "vtkSMIntVectorProperty.h"

#include <QComboBox>
#include <QVBoxLayout>

#include <set>

ChoiceWidget::ChoiceWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Box(new QComboBox(this))
{
  auto* domain = property->FindDomain<vtkSMEnumerationDomain>();
  for (unsigned int i = 0; i < domain->GetNumberOfEntries(); ++i)
  {
    const int number = domain->GetEntryValue(i);
    this->Numbers[domain->GetEntryText(i)] = number;
    if (this->Box->findData(number) < 0)
    {
      this->Box->addItem(domain->GetEntryText(i), number);
    }
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Box);
  QObject::connect(this->Box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this] { Q_EMIT this->choiceChanged(); });
  this->addPropertyLink(this, "choice", SIGNAL(choiceChanged()), property);
}

bool ChoiceWidget::IsFor(vtkSMProperty* property)
{
  auto* domain = property->FindDomain<vtkSMEnumerationDomain>();
  if (!vtkSMIntVectorProperty::SafeDownCast(property) || property->GetRepeatable() || !domain)
  {
    return false;
  }
  std::set<int> numbers;
  for (unsigned int i = 0; i < domain->GetNumberOfEntries(); ++i)
  {
    numbers.insert(domain->GetEntryValue(i));
  }
  return numbers.size() < domain->GetNumberOfEntries();
}

QString ChoiceWidget::choice() const
{
  return this->Box->currentText();
}

void ChoiceWidget::setChoice(const QString& spelling)
{
  this->Box->setCurrentIndex(this->Box->findData(this->Numbers.value(spelling)));
}
