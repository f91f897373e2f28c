// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForecastWidget.h
 * A line of the panel that tells how much the next Apply will make.
 */
#ifndef SubdivisionObjects_ForecastWidget_h
#define SubdivisionObjects_ForecastWidget_h

#include "pqPropertyWidget.h"

class QLabel;

/**
 * The widget of properties with panel_widget="SubdivisionObjectsForecast". It follows the values
 * that the panel shows, and the input.
 */
class ForecastWidget : public pqPropertyWidget
{
  Q_OBJECT
public:
  ForecastWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);

private Q_SLOTS:
  void tell();

private:
  QLabel* Text;
};

#endif
