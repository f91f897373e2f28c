// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PresetWidget.h
 * A list of presets: one choice that sets several properties.
 */
#ifndef SubdivisionObjects_PresetWidget_h
#define SubdivisionObjects_PresetWidget_h

#include "pqPropertyWidget.h"

#include <set>
#include <string>
#include <vector>

class QComboBox;
class vtkPVXMLElement;

/**
 * The widget of properties with panel_widget="SubdivisionObjectsPresets". The hints of the property
 * list the presets, and what each sets; all that any of them sets, and this one does not, gets its
 * default. Choosing one changes the panel; Apply takes it as any other change. Whatever the user
 * changes, the list tells the preset that has these values, or that it is an own choice.
 */
class PresetWidget : public pqPropertyWidget
{
  Q_OBJECT
public:
  PresetWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent);

  void apply() override;
  void reset() override;

private Q_SLOTS:
  void tell();

private:
  void choose(int index);
  bool isChosen(vtkPVXMLElement* preset) const;
  std::vector<int> getValues(vtkPVXMLElement* preset, const std::string& name) const;

  QComboBox* Box;
  std::vector<vtkPVXMLElement*> Presets;
  std::set<std::string> Names; // of properties
  bool IsChoosing = false;
};

#endif
