// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CriteriaWidget.h
 * The criteria of local refinement in one list.
 */
#ifndef SubdivisionObjects_CriteriaWidget_h
#define SubdivisionObjects_CriteriaWidget_h

#include "pqPropertyGroupWidget.h"

/**
 * The widget of property groups with panel_widget="SubdivisionObjectsCriteria": a list with a check
 * box for each property, without the words with which the labels of all begin.
 */
class CriteriaWidget : public pqPropertyGroupWidget
{
public:
  CriteriaWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent);
};

#endif
