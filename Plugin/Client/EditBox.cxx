// SPDX-License-Identifier: BSD-3-Clause
#include "EditBox.h"

#include "pqCoreUtilities.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkPVDataInformation.h"
#include "vtkPVGeneralSettings.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSMNewWidgetRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <QTimer>

#include <algorithm>
#include <utility>

EditBox::EditBox(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqBoxPropertyWidget(proxy, group, parent)
{
  pqCoreUtilities::connect(
    proxy->GetProperty("Selection"), vtkCommand::ModifiedEvent, this, SLOT(placeWidget()));
  // With Auto Apply the object follows the mouse, and does not wait until the button is let go.
  this->connect(this, SIGNAL(interaction()), SIGNAL(changeFinished()));
  this->connect(this, SIGNAL(startInteraction()), SLOT(beginDrag()));
  this->connect(this, SIGNAL(endInteraction()), SLOT(endDrag()));
}

EditBox::~EditBox()
{
  this->closeDrag();
}

/// All that is applied during a drag is one step for Undo.
void EditBox::beginDrag()
{
  this->closeDrag();
  this->IsDragged = true;
  BEGIN_UNDO_SET("Drag the box");
  auto* const shown = qobject_cast<pqRenderView*>(this->view());
  this->Interactor = shown ? shown->getRenderViewProxy()->GetInteractor() : nullptr;
  if (this->Interactor && vtkPVGeneralSettings::GetInstance()->GetAutoApply())
  {
    this->Observer =
      this->Interactor->AddObserver(vtkCommand::RenderEvent, this, &EditBox::skipRender, 1.f);
  }
}

/// Each Auto Apply draws the view with the box, so the box need not draw it once more by itself.
bool EditBox::skipRender(vtkObject*, unsigned long, void*)
{
  return true;
}

/// After the last Auto Apply, which the event loop does next.
void EditBox::endDrag()
{
  QTimer::singleShot(0, this, SLOT(closeDrag()));
}

void EditBox::closeDrag()
{
  if (std::exchange(this->IsDragged, false))
  {
    END_UNDO_SET();
    if (this->Interactor)
    {
      this->Interactor->RemoveObserver(this->Observer);
    }
  }
}

/// The selected part of the input; the input where nothing is selected.
vtkSMSourceProxy* EditBox::FindSelected()
{
  const vtkSMPropertyHelper input(this->proxy(), "Input");
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  vtkSMProxy* const selection = vtkSMPropertyHelper(this->proxy(), "Selection").GetAsProxy();
  if (!selection)
  {
    return source;
  }
  if (!this->Selected)
  {
    this->Selected.TakeReference(vtkSMSourceProxy::SafeDownCast(
      this->proxy()->GetSessionProxyManager()->NewProxy("filters", "ExtractSelection")));
  }
  vtkSMPropertyHelper(this->Selected, "Input").Set(source, input.GetOutputPort());
  vtkSMPropertyHelper(this->Selected, "Selection").Set(selection);
  this->Selected->UpdateVTKObjects();
  this->Selected->UpdatePipeline();
  return this->Selected->GetDataInformation(0)->GetNumberOfPoints() > 0 ? this->Selected.Get()
                                                                        : source;
}

void EditBox::placeWidget()
{
  vtkSMSourceProxy* const selected = this->FindSelected();
  vtkBoundingBox box;
  if (selected)
  {
    box.SetBounds(selected->GetDataInformation(0)->GetBounds());
  }
  if (!box.IsValid())
  {
    return;
  }
  // A single point, or points in a plane, get a box with faces that the mouse finds.
  vtkBoundingBox all;
  all.SetBounds(
    vtkSMSourceProxy::SafeDownCast(vtkSMPropertyHelper(this->proxy(), "Input").GetAsProxy())
      ->GetDataInformation(0)
      ->GetBounds());
  const double least = 0.1 * all.GetMaxLength();
  box.Inflate(std::max(0., least - box.GetLength(0)) / 2.,
    std::max(0., least - box.GetLength(1)) / 2., std::max(0., least - box.GetLength(2)) / 2.);
  double bounds[6];
  box.GetBounds(bounds);
  vtkSMPropertyHelper(this->widgetProxy(), "PlaceWidget").Set(bounds, 6);
  this->widgetProxy()->UpdateVTKObjects();
}
