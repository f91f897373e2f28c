// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditBox.h
 * The box that moves points in Edit Selection: it stands around the selected points.
 */
#ifndef SubdivisionObjects_EditBox_h
#define SubdivisionObjects_EditBox_h

#include "pqBoxPropertyWidget.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

class vtkObject;
class vtkRenderWindowInteractor;
class vtkSMSourceProxy;

/**
 * ParaView's box, which by itself stands around its input. Here it stands around the selected
 * points of the input, so that a drag begins at the points that move. With ParaView's Auto Apply
 * the filter runs during the drag, which is one step for Undo.
 */
class EditBox : public pqBoxPropertyWidget
{
  Q_OBJECT
public:
  EditBox(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent);
  ~EditBox() override;

protected Q_SLOTS:
  void placeWidget() override;

private Q_SLOTS:
  void beginDrag();
  void endDrag();
  void closeDrag();

private:
  bool skipRender(vtkObject*, unsigned long, void*);
  vtkSMSourceProxy* FindSelected();

  vtkSmartPointer<vtkSMSourceProxy> Selected;           ///< null before the first selection
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; ///< of the view, during a drag
  unsigned long Observer = 0;
  bool IsDragged = false;
};

#endif
