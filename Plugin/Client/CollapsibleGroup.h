// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapsibleGroup.h
 * A group of properties under a heading that opens and closes it.
 */
#ifndef SubdivisionObjects_CollapsibleGroup_h
#define SubdivisionObjects_CollapsibleGroup_h

#include "pqPropertyGroupWidget.h"

class QToolButton;
class pqProxyWidget;

/**
 * The widget of property groups with panel_widget="SubdivisionObjectsGroup". A group starts closed;
 * ParaView's settings keep, by the name of the group, whether the user opened it. A search opens
 * the groups in which it finds something. The heading tells when properties of the group differ
 * from their defaults, so that a closed group hides no choice. Without this widget (pvpython, a
 * ParaView without Qt) the same groups are plain ones.
 *
 * ParaView knows this widget as one item of the panel, and by its heading only. So it asks the
 * panel's search box itself, and decides whether it can be seen where ParaView shows or hides it,
 * which is setVisible().
 */
class CollapsibleGroup : public pqPropertyGroupWidget
{
public:
  CollapsibleGroup(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent);

  void apply() override;
  void reset() override;
  void setView(pqView* view) override;
  void updateWidget(bool showsAdvanced) override;
  void setVisible(bool wanted) override;

private:
  /// What the user types into the search box of the panel that holds the group; empty without one.
  QString searchText() const;
  void followDecorators();
  void arrange();
  void updateHeading();
  void toggle(bool open);

  pqProxyWidget* Properties;
  QToolButton* Heading;
  QString Label;
  QString SettingsKey;
  bool ShowsAdvanced = false;
  bool IsWanted = false; // by the panel
};

#endif
