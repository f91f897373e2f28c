// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChoiceWidget.h
 * A list of choices, each of which has several spellings.
 */
#ifndef SubdivisionObjects_ChoiceWidget_h
#define SubdivisionObjects_ChoiceWidget_h

#include "pqPropertyWidget.h"

#include <QMap>

class QComboBox;

/**
 * The widget of enumerations in which numbers have several names: scripts may write any of them,
 * and ParaView's own widget would list them all. This one lists the first name of each number.
 */
class ChoiceWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QString choice READ choice WRITE setChoice NOTIFY choiceChanged)
public:
  ChoiceWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);

  static bool IsFor(vtkSMProperty* property);

  QString choice() const;
  void setChoice(const QString& spelling);

Q_SIGNALS:
  void choiceChanged();

private:
  QComboBox* Box;
  QMap<QString, int> Numbers; // of all spellings
};

#endif
