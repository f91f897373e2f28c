# SPDX-License-Identifier: BSD-3-Clause
"""The windows of ParaView's client and the hands of a user, for client_session.py.

The widgets belong to the client, by PyQt in the same process. Pictures of the panels go to the folder panels."""

import ctypes
import os
import time

from paraview import servermanager, simple

with open("/proc/self/maps", encoding="utf-8") as maps:
    has_qt6 = "libQt6Core" in maps.read()
if has_qt6:
    from PyQt6 import QtCore, QtGui, QtWidgets
    QAction = QtGui.QAction
else:
    from PyQt5 import QtCore, QtGui, QtWidgets
    QAction = QtWidgets.QAction

simple.LoadPlugin(os.environ["SUBDIVISIONOBJECTS_PLUGIN"], remote=False, ns=vars(simple))
application = QtWidgets.QApplication.instance()
window = next(widget for widget in application.topLevelWidgets() if isinstance(widget, QtWidgets.QMainWindow))
window.setGeometry(0, 0, 1280, 1020)
panel = window.findChild(QtWidgets.QWidget, "propertiesPanel")
for dock, size in (("pipelineBrowserDock", 100), ("propertiesDock", 900)):
    window.resizeDocks([window.findChild(QtWidgets.QDockWidget, dock)], [size], QtCore.Qt.Orientation.Vertical)
window.resizeDocks([window.findChild(QtWidgets.QDockWidget, "propertiesDock")], [420], QtCore.Qt.Orientation.Horizontal)
search = panel.findChild(QtWidgets.QWidget, "SearchBox")
for part in ("DisplayButton", "ViewButton"):  # closed, for the pictures
    panel.findChild(QtWidgets.QWidget, part).setProperty("checked", False)
filters = ["Multi-dimensional Subdivision", "Red-Green Refinement", "Simplicial Complex Topology", "Surface Subdivision",
           "Adaptive Surface Subdivision", "Extract Dimensions", "Cage Around"]


# PyQt would let go of Python's lock meanwhile, which ParaView's trace counts on: it calls Python without asking for it.
process_events = ctypes.PyDLL(None)["_ZN16QCoreApplication13processEventsE6QFlagsIN10QEventLoop17ProcessEventsFlagEE"]


def settle():
    """All that the client has to do is done, also what its timers of 10 ms bring, such as greyed filters in the menus."""
    end = time.monotonic() + 0.03
    rounds = 50
    while rounds > 0 or time.monotonic() < end:
        process_events(0)
        rounds -= 1


def act(name):
    window.findChild(QAction, name).trigger()
    settle()


def push(name):
    panel.findChild(QtWidgets.QPushButton, name).click()
    settle()


def choose(menu, label):
    """An entry of the plugin's submenu of the menu Sources or Filters."""
    menu = window.findChild(QtWidgets.QMenu, menu)
    menu.aboutToShow.emit()
    (ours,) = [action.menu() for action in menu.actions() if action.text().replace("&", "") == "Subdivision Objects"]
    (entry,) = [action for action in ours.actions() if action.text().replace("&", "") == label]
    if not entry.isEnabled():
        raise RuntimeError(label + " is greyed")
    entry.trigger()
    settle()
    return simple.GetActiveSource()


def find_row(rows, text, above=QtCore.QModelIndex()):
    """The row of a tree with this text, or None."""
    for row in range(rows.rowCount(above)):
        index = rows.index(row, 0, above)
        found = index if rows.data(index) == text else find_row(rows, text, index)
        if found:
            return found
    return None


def choose_with_inputs(label, **inputs):
    """An entry of the menu of filters that asks for inputs; the first one is the active source."""
    names = {source.GetGlobalIDAsString(): name for (name, _), source in simple.GetSources().items()}
    faults = []

    def answer():
        dialog = application.activeModalWidget()
        try:
            tree = dialog.findChild(QtWidgets.QWidget, "pipelineView")
            selection = next(child for child in tree.children() if isinstance(child, QtCore.QItemSelectionModel))
            for port, source in inputs.items():
                dialog.findChild(QtWidgets.QRadioButton, port).click()
                row = find_row(selection.model(), names[source.GetGlobalIDAsString()])
                selection.setCurrentIndex(row, QtCore.QItemSelectionModel.SelectionFlag.ClearAndSelect)
            dialog.accept()
        except Exception as fault:  # a dialog that stays would stop everything
            faults.append(fault)
            dialog.reject()

    QtCore.QTimer.singleShot(0, answer)
    proxy = choose("menuFilters", label)
    if faults:
        raise faults[0]
    return proxy


def quick_launch(text, launch=False):
    """What Ctrl+Space finds: all that it lists, and what it would make. It is made if `launch`."""
    found = []

    def answer():
        dialog = application.activeModalWidget()
        for letter in text:
            key = QtCore.Qt.Key.Key_Space if letter == " " else QtCore.Qt.Key(ord(letter.upper()))
            application.sendEvent(dialog, QtGui.QKeyEvent(
                QtCore.QEvent.Type.KeyPress, key, QtCore.Qt.KeyboardModifier.NoModifier, letter))
        items = dialog.findChild(QtWidgets.QListWidget)
        found.append([items.item(i).text() for i in range(items.count())])
        found.append(items.currentItem().text() if items.currentItem() else None)
        dialog.accept() if launch else dialog.reject()

    QtCore.QTimer.singleShot(0, answer)
    (shortcut,) = [one for one in window.findChildren(QtWidgets.QShortcut if not has_qt6 else QtGui.QShortcut)
                   if one.key().toString() == "Ctrl+Space"]
    shortcut.activated.emit()
    settle()
    return found


def show_advanced(wanted):
    (button,) = [button for button in search.findChildren(QtWidgets.QToolButton) if button.isCheckable()]
    if button.isChecked() != wanted:
        button.click()
    settle()


def find(text):
    search.setProperty("text", text)
    settle()


def shown():
    """The widget with the properties of the active source."""
    children = panel.findChild(QtWidgets.QWidget, "PropertiesFrame").children()
    return next(child for child in children if child.inherits("pqProxyWidget") and child.isVisible())


def groups():
    """The headings of the collapsible groups that can be seen: their texts, and whether they are open."""
    return {heading.text(): heading.isChecked() for heading in shown().findChildren(QtWidgets.QToolButton, "Heading")
            if heading.isVisible()}


def heading(text):
    return next(heading for heading in shown().findChildren(QtWidgets.QToolButton, "Heading") if heading.text() == text)


def sees(name):
    """Whether the widget of a property can be seen."""
    return any(widget.isVisible() for widget in shown().findChildren(QtWidgets.QWidget, name))


def selection():
    """Two points, as what is copied from a view."""
    ids = simple.IDSelectionSource(IDs=[0, 0, 0, 1], FieldType="POINT")
    return servermanager.filters.AppendSelections(Input=[ids], SelectionNames=["s"], Expression="s")


def picture(name):
    """Pictures of the panel on the screen, which show what a widget paints by itself does not."""
    os.makedirs("panels", exist_ok=True)
    bar = panel.findChild(QtWidgets.QScrollArea).verticalScrollBar()
    part = 1
    bar.setValue(0)
    while True:
        settle()
        application.primaryScreen().grabWindow(panel.winId()).save(f"panels/{name.replace(' ', '')}-{part}.png")
        if bar.value() == bar.maximum():
            break
        bar.setValue(bar.value() + bar.pageStep())
        part += 1


def cells(proxy):
    return proxy.GetDataInformation().GetNumberOfCells()


def client_box(view):
    """The box of the panel in a view."""
    hidden = view.SMProxy.GetProperty("HiddenRepresentations")
    proxies = [hidden.GetProxy(i) for i in range(hidden.GetNumberOfProxies())]
    (box,) = [proxy for proxy in proxies if "BoxWidget" in proxy.GetXMLName()]
    return box.GetRepresentationProxy().GetClientSideObject()


def drag(view, start, followed):
    """Draws what is at a place of the view by the mouse, with Auto Apply: how often `followed` was made meanwhile, and the view
    drawn."""
    settings = servermanager.vtkPVGeneralSettings.GetInstance()
    before = settings.GetAutoApply()
    settings.SetAutoApply(True)
    simple.Render(view)
    renderer, interactor = view.GetRenderer(), view.GetInteractor()
    renderer.SetWorldPoint(*start, 1)
    renderer.WorldToDisplay()
    x, y, _ = map(int, renderer.GetDisplayPoint())
    times = {followed.GetClientSideObject().GetOutputDataObject(0).GetMTime()}
    interactor.SetEventInformation(x, y)
    interactor.InvokeEvent("MouseMoveEvent")
    interactor.InvokeEvent("LeftButtonPressEvent")
    settle()
    drawn = []
    tag = view.GetRenderWindow().AddObserver("StartEvent", lambda *_: drawn.append(1))
    for step in range(1, 11):
        interactor.SetEventInformation(x + 4 * step, y + 4 * step)
        interactor.InvokeEvent("MouseMoveEvent")
        settle()
        times.add(followed.GetClientSideObject().GetOutputDataObject(0).GetMTime())
    view.GetRenderWindow().RemoveObserver(tag)
    interactor.InvokeEvent("LeftButtonReleaseEvent")
    settle()
    settings.SetAutoApply(before)
    return len(times) - 1, len(drawn)


def picture_of_view(view, name):
    os.makedirs("panels", exist_ok=True)
    simple.SaveScreenshot(f"panels/{name}.png", view)
