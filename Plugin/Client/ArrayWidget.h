// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArrayWidget.h
 * A list of cell arrays, the first of which is None.
 */
#ifndef SubdivisionObjects_ArrayWidget_h
#define SubdivisionObjects_ArrayWidget_h

#include "pqPropertyWidget.h"

class QComboBox;

/**
 * The widget of cell arrays that start as None. ParaView's own knows None as an array of points
 * only, and shows "None (?)" for one of cells.
 */
class ArrayWidget : public pqPropertyWidget
{
  Q_OBJECT
public:
  ArrayWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);

  static bool IsFor(vtkSMProperty* property);

  void apply() override;
  void reset() override;

private Q_SLOTS:
  void fill();

private:
  void choose(const QString& name);

  vtkSMProperty* Array;
  QComboBox* Box;
};

#endif
