// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CountWidget.h
 * A field for a large whole number.
 */
#ifndef SubdivisionObjects_CountWidget_h
#define SubdivisionObjects_CountWidget_h

#include "pqPropertyWidget.h"

class QLineEdit;

/**
 * The widget of properties with panel_widget="SubdivisionObjectsCount": it shows 500,000,000 where
 * ParaView's own shows 5e+08. It takes numbers with or without commas, and 5e8.
 */
class CountWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(double count READ count WRITE setCount NOTIFY countChanged)
public:
  CountWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);

  double count() const { return this->Count; }
  void setCount(double count);

Q_SIGNALS:
  void countChanged();

private:
  void read();

  QLineEdit* Line;
  double Count = 0.;
};

#endif
