// SPDX-License-Identifier: BSD-3-Clause
#include "CountWidget.h"

#include <QLineEdit>
#include <QLocale>
#include <QVBoxLayout>

#include <cmath>

CountWidget::CountWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Line(new QLineEdit(this))
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Line);
  QObject::connect(this->Line, &QLineEdit::editingFinished, this, [this] { this->read(); });
  this->addPropertyLink(this, "count", SIGNAL(countChanged()), property);
}

void CountWidget::setCount(double count)
{
  this->Line->setText(QLocale(QLocale::English).toString(count, 'f', 0));
  if (count != this->Count)
  {
    this->Count = count;
    Q_EMIT this->countChanged();
  }
}

void CountWidget::read()
{
  bool isNumber = false;
  const double read = this->Line->text().remove(',').remove(' ').toDouble(&isNumber);
  this->setCount(isNumber && std::isfinite(read) && read >= 1. ? std::floor(read) : this->Count);
}
