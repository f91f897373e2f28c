// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UsedProperties.h
 * Which properties of a filter are used, so that traces have no others.
 */
#ifndef SubdivisionObjects_UsedProperties_h
#define SubdivisionObjects_UsedProperties_h

#include <QObject>

class pqPipelineSource;
class vtkSMProxy;

/**
 * ParaView traces inputs even where there are none, and functions that no option uses. Those with a
 * hint TracedIf have the visibility "never", and thus are in no trace, until the property that the
 * hint names has a value. Only the client does so: in pvpython states have all of them.
 */
class UsedProperties : public QObject
{
  Q_OBJECT
public:
  /// From now on for all filters of the project.
  static void Follow();

private Q_SLOTS:
  void update();

private:
  explicit UsedProperties(pqPipelineSource* source);

  vtkSMProxy* Proxy;
};

#endif
