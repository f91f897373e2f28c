// SPDX-License-Identifier: BSD-3-Clause
#include "SearchWords.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineSource.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QAction>
#include <QMenu>

#include <cstring>

namespace
{
struct Word
{
  const char* Text;
  const char* Filter;
  const char* Scheme; ///< which it chooses; null: the default
};

constexpr Word Words[] = {
  { "Smooth (Multi-dimensional Subdivision)", "MultiDimensionalSubdivision", nullptr },
  { "Subdivide (Multi-dimensional Subdivision)", "MultiDimensionalSubdivision", nullptr },
  { "Loop (Surface Subdivision)", "SurfaceSubdivision", "Loop" },
  { "Catmull-Clark (Surface Subdivision)", "SurfaceSubdivision", "Catmull-Clark" },
  { "Butterfly (Surface Subdivision)", "SurfaceSubdivision", "Modified Butterfly" },
  { "Doo-Sabin (Surface Subdivision)", "SurfaceSubdivision", "Doo-Sabin" },
  { "Refine locally (Red-Green Refinement)", "RedGreenRefinement", nullptr },
};

/// The entry of the menu of filters, which knows whether the filter takes what is active.
QAction* FindEntry(const QString& filter)
{
  auto* menu = pqCoreUtilities::mainWidget()->findChild<QMenu*>("menuFilters");
  for (auto* part : menu ? menu->findChildren<QMenu*>() : QList<QMenu*>())
  {
    for (auto* action : part->actions())
    {
      if (action->objectName() == filter)
      {
        return action;
      }
    }
  }
  return nullptr;
}

/// As if the user had done so in the panel: Apply takes it.
void Choose(const Word& word)
{
  auto* source = pqActiveObjects::instance().activeSource();
  auto* proxy = source ? source->getProxy() : nullptr;
  if (!word.Scheme || !proxy || std::strcmp(proxy->GetXMLName(), word.Filter) != 0)
  {
    return;
  }
  auto* scheme = proxy->GetProperty("Scheme");
  auto* entries = scheme->FindDomain<vtkSMEnumerationDomain>();
  if (entries->HasEntryText(word.Scheme))
  {
    vtkSMUncheckedPropertyHelper(scheme).Set(entries->GetEntryValueForText(word.Scheme));
  }
}
}

SearchWords::SearchWords()
{
  for (const Word& word : Words)
  {
    auto* action = new QAction(word.Text, this);
    action->setObjectName(QString("SubdivisionObjects.%1").arg(word.Text));
    action->setData(word.Filter);
    this->addAction(action);
    QObject::connect(action, &QAction::triggered, this,
      [word]
      {
        if (auto* entry = FindEntry(word.Filter))
        {
          entry->trigger();
          Choose(word);
        }
      });
  }
}

void SearchWords::follow()
{
  for (auto* action : this->actions())
  {
    auto* entry = FindEntry(action->data().toString());
    action->setEnabled(entry && entry->isEnabled());
    if (entry) // which ParaView updates at the same time
    {
      action->setIcon(entry->icon());
      QObject::connect(entry, &QAction::changed, this, &SearchWords::follow, Qt::UniqueConnection);
    }
  }
}

void SearchWords::Add()
{
  auto* core = pqApplicationCore::instance();
  if (!core->inherits("pqPVApplicationCore")) // other applications have no quick launch
  {
    return;
  }
  auto* words = new SearchWords;
  QObject::connect(core, &QObject::destroyed, words, &QObject::deleteLater);
  // By name, and a virtual method: so nothing of the library is needed, which servers do not load.
  QObject::connect(core, SIGNAL(aboutToShowQuickLaunch()), words, SLOT(follow()));
  static_cast<pqPVApplicationCore*>(core)->registerForQuicklaunch(words);
}
