"""Mouse, pictures and bookkeeping for macros that test the GUI from inside FreeCAD."""
import dataclasses
import faulthandler
import gc
import json
import os
import pathlib
import subprocess
import time
import traceback

import FreeCAD
import FreeCADGui
import shiboken2
from PySide import QtCore, QtGui
from PySide2.QtTest import QTest

OUT = pathlib.Path(os.environ["SWEEPMESH_TEST_OUT"])
OF_PANELS = tuple(f"sweepmesh.gui.{part}" for part in ("taskpanels", "overlays", "runner", "read_models"))
LEFT, NO_KEY, CONTROL = QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, QtCore.Qt.ControlModifier

results = {"checks": {}, "values": {}, "unmet": []}
LONG_WAIT = 5  # seconds: what takes longer than this is noted


def go(steps):
    """Run `steps` once FreeCAD is up; write results.json and end FreeCAD, whatever happens."""
    seconds = float(os.environ.get("SWEEPMESH_TEST_SECONDS", 280))
    faulthandler.dump_traceback_later(seconds, exit=True, file=open(OUT / "hang.txt", "w", encoding="utf-8"))
    QtCore.QTimer.singleShot(0, lambda: _run(steps))


def _run(steps):
    try:
        main_window().resize(1280, 900)
        for dock in main_window().findChildren(QtGui.QDockWidget):
            if dock.objectName() in ("Python console", "Report view"):
                dock.hide()
        FreeCADGui.activateWorkbench("SweepMeshWorkbench")
        steps()
        _expect_nothing_left()
    except BaseException:
        results["error"] = traceback.format_exc()
        picture("error")
    (OUT / "results.json").write_text(json.dumps(results, indent=1), encoding="utf-8")
    os._exit(1 if "error" in results else 0)


def _expect_nothing_left():
    """Python objects of closed panels must be gone, without the help of its garbage collector: that might run in a
    worker's thread, where nothing of Qt may be deleted. Rows of lists that are gone must not look alive (see below)."""
    if is_panel_open():
        return
    check("nothing is left of the panels", lambda: not left_of_panels())
    note("left of panels", left_of_panels())


def left_of_panels():
    """What there is in Python of our panels (constants of their modules aside), and of rows of lists."""
    rows = [each for each in gc.get_objects() if isinstance(each, QtGui.QListWidgetItem) and shiboken2.isValid(each)]
    own = [each for each in gc.get_objects() if type(each).__module__.startswith(OF_PANELS)]
    return sorted(type(each).__name__ for each in rows + own if not dataclasses.is_dataclass(each))


def check(name, truth):
    """Note whether something is as it should be; the test outside reports what was not. A function is waited for."""
    results["checks"][name] = bool(wait_for(truth) if callable(truth) else truth)
    if not results["checks"][name]:
        picture(f"failed_{len(results['checks'])}")


def note(name, value):
    results["values"][name] = value


def main_window():
    return FreeCADGui.getMainWindow()


def settle(seconds=0.25):
    """Let Qt work for a while."""
    end = time.time() + seconds
    while time.time() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        time.sleep(0.005)


def wait_for(condition, seconds=60):
    """Let Qt work until `condition()`; False when it did not come true in time, which is a failure of the test."""
    start = time.time()
    while not (truth := condition()) and time.time() < start + seconds:
        settle(0.03)
    took = round(time.time() - start, 1)
    if not truth:
        results["unmet"].append(_caller())
    elif took > LONG_WAIT:
        note(f"waited at {_caller()}", took)
    return bool(truth)


def _caller():
    """The line of a macro that runs now: "macro_pairs.py:20"."""
    calls = [call for call in traceback.extract_stack() if call.filename != __file__]
    return f"{pathlib.Path(calls[-1].filename).name}:{calls[-1].lineno}" if calls else "the end"


def picture(name):
    """Write a picture of the whole screen."""
    settle()
    subprocess.run(["import", "-window", "root", str(OUT / f"{name}.png")], check=False)


def view():
    return FreeCADGui.ActiveDocument.ActiveView


def show_all(direction="Axonometric"):
    """Look at everything from `direction`; a little room is left at the borders."""
    getattr(view(), f"view{direction}")()
    view().fitAll()
    settle()


def look_from(*direction):
    """Look at everything from a direction in space; z points up."""
    back, up = FreeCAD.Vector(*direction), FreeCAD.Vector(0, 0, 1)
    view().setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(), up, back, "ZYX").Q)
    view().fitAll()
    settle()


def click_point(point, key=NO_KEY):
    """Click with the left button on a point of space, as it appears in the 3D view."""
    canvas = _canvas()
    x, y = view().getPointOnScreen(FreeCAD.Vector(*point))
    at = QtCore.QPoint(x, canvas.height() - 1 - y)
    QTest.mouseMove(canvas, at)
    settle(0.1)
    QTest.mouseClick(canvas, LEFT, key, at)
    settle(0.2)


def click_edge(obj, name, part=0.5, key=NO_KEY):
    """Click on an edge that can be seen, at this part of its length."""
    edge = obj.Shape.getElement(name)
    click_point(edge.valueAt(edge.getParameterByLength(part * edge.Length)), key)


def click_vertex(obj, name, key=NO_KEY):
    """Click on a vertex that can be seen."""
    click_point(obj.Shape.getElement(name).Point, key)


def click_face(obj, name, key=NO_KEY):
    """Click on a face that can be seen: where it is widest."""
    points, triangles = obj.Shape.getElement(name).tessellate(0.01 * obj.Shape.BoundBox.DiagonalLength)
    corners = max(([points[i] for i in three] for three in triangles), key=_narrowest)
    click_point((corners[0] + corners[1] + corners[2]) * (1 / 3), key)


def _narrowest(corners):
    """The radius of the circle in a triangle."""
    a, b, c = corners
    area = (b - a).cross(c - a).Length / 2
    return 2 * area / ((b - a).Length + (c - b).Length + (a - c).Length)


def _canvas():
    for widget in main_window().findChild(QtGui.QMdiArea).findChildren(QtGui.QWidget):
        if "QuarterWidget" in widget.metaObject().className() and widget.isVisible():
            return widget
    raise LookupError("There is no 3D view.")


def reveal(field):
    """Scroll the task panel until a widget of it can be seen."""
    parent = field.parentWidget()
    while parent is not None:
        if isinstance(parent, QtGui.QScrollArea):
            parent.ensureWidgetVisible(field, 0, 20)
        parent = parent.parentWidget()


def press(button):
    """Click on a button of a panel or a toolbar, or on the box of a check box, once it can be pressed."""
    wait_for(button.isEnabled, 10)
    reveal(button)
    at = QtCore.QPoint(10, button.height() // 2) if isinstance(button, QtGui.QCheckBox) else QtCore.QPoint()
    QTest.mouseClick(button, LEFT, NO_KEY, at)
    settle()


def tool_button(text):
    """The button of a command in a toolbar, by its text."""
    for button in main_window().findChildren(QtGui.QToolButton):
        action = button.defaultAction()
        if action and action.text().replace("&", "") == text and button.isVisible():
            return button
    raise LookupError(f"There is no button '{text}'.")


def panel_button(text):
    """A button of the task panel, its OK and Cancel included."""
    for button in main_window().findChildren(QtGui.QAbstractButton):
        if button.text().replace("&", "") == text and button.isVisible():
            return button
    raise LookupError(f"There is no button '{text}'.")


def widget(name):
    """A visible widget of the panel by its name in the form."""
    for found in main_window().findChildren(QtGui.QWidget, name):
        if found.isVisible():
            return found
    raise LookupError(f"There is no widget '{name}'.")


def choose(name, index):
    """Choose an entry of a box by the keyboard, as QTest cannot see into the list that opens."""
    box = widget(name)
    reveal(box)
    box.setFocus()
    for _ in range(box.count()):
        if box.currentIndex() != index:
            QTest.keyClick(box, QtCore.Qt.Key_Down if box.currentIndex() < index else QtCore.Qt.Key_Up)
    settle(0.1)


def click_row(name, row, key=NO_KEY):
    """Click on a row of a list of the panel."""
    shown = widget(name)
    reveal(shown)
    QTest.mouseClick(shown.viewport(), LEFT, key, place_of(shown, row))
    settle(0.1)


def is_shown(name):
    """Is there a widget of this name to be seen?"""
    return any(found.isVisible() for found in main_window().findChildren(QtGui.QWidget, name))


def rows(name):
    """The texts of a list of the panel; none while there is no such list."""
    return texts(widget(name)) if is_shown(name) else []


def marked(name):
    """The texts of the marked rows of a list."""
    return [index.data() for index in widget(name).selectionModel().selectedIndexes()]


def are_proposed(name):
    """Are the rows of a list proposals, which are in italics?"""
    shown = widget(name)
    fonts = [row_of(shown, i).data(QtCore.Qt.FontRole) for i in range(shown.count())]
    return bool(fonts) and all(font is not None and font.italic() for font in fonts)


# Rows are read by their indices. PySide would keep a Python half of every QListWidgetItem that it has seen, longer
# than FreeCAD keeps its lists, and take it for the widget that Qt puts at the same address later.


def texts(shown):
    """The texts of a list."""
    return [row_of(shown, i).data() for i in range(shown.count())]


def row_of(shown, row):
    """The index of a row of a list."""
    return shown.model().index(row, 0)


def place_of(shown, row):
    """Where to click on a row of a list."""
    return shown.visualRect(row_of(shown, row)).center()


def type_into(name, text):
    """Replace what an input field holds, as a user does, and leave it."""
    field = widget(name)
    reveal(field)
    field.setFocus()
    QTest.keyClick(field, QtCore.Qt.Key_A, CONTROL)
    QTest.keyClicks(field, text)
    QTest.keyClick(field, QtCore.Qt.Key_Tab)
    settle(0.1)


def double_click_in_tree(label):
    """Double click on an object in the tree of the model."""
    combo = next(tab for tab in main_window().findChildren(QtGui.QTabWidget) if tab.objectName() == "combiTab")
    combo.setCurrentIndex(0)
    settle(0.1)
    exactly, all_the_way = QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, -1
    for tree in main_window().findChildren(QtGui.QTreeWidget):
        model = tree.model()
        for index in model.match(model.index(0, 0), 0, label, all_the_way, exactly) if tree.isVisible() else ():
            tree.scrollTo(index)
            at = tree.visualRect(index).center()
            QTest.mouseClick(tree.viewport(), LEFT, NO_KEY, at)
            QTest.mouseDClick(tree.viewport(), LEFT, NO_KEY, at)
            settle(0.2)
            return
    raise LookupError(f"There is no {label} in the tree.")


def answer_file_dialog(command, path, name_filter="", wants_picture=False):
    """Run a command of FreeCAD's that asks for a file, and name the file; the filter is the first with that text."""
    asked = []

    def answer():
        dialog = QtGui.QApplication.activeModalWidget()
        if not isinstance(dialog, QtGui.QFileDialog):
            if not asked and time.time() < give_up:
                QtCore.QTimer.singleShot(50, answer)
            return
        asked.append(dialog)
        chosen = [each for each in dialog.nameFilters() if name_filter in each]
        dialog.selectNameFilter(chosen[0])
        accept = dialog.findChild(QtGui.QDialogButtonBox).buttons()[0]
        field = dialog.findChild(QtGui.QLineEdit, "fileNameEdit")
        if wants_picture:
            picture(f"dialog_{path.suffix[1:]}")
        field.setText(str(path))  # and at once the button: the dialog completes what stands there for a while
        accept.setEnabled(True)
        accept.click()
        if dialog.isVisible() and time.time() < give_up:
            asked.clear()
            QtCore.QTimer.singleShot(500, answer)
        elif dialog.isVisible():
            dialog.reject()

    give_up = time.time() + 60
    QtCore.QTimer.singleShot(50, answer)
    FreeCADGui.runCommand(command)
    settle()
    return bool(asked)


def type_shortcut(command):
    """Press the keys of one of FreeCAD's commands, once it can be used."""
    action = FreeCADGui.Command.get(command).getAction()[0]
    wait_for(action.isEnabled, 10)
    keys = action.shortcut()[0]
    QTest.keyClick(main_window(), QtCore.Qt.Key(keys & 0x01FFFFFF), QtCore.Qt.KeyboardModifiers(keys & 0xFE000000))
    settle(0.1)


def is_panel_open():
    return bool(FreeCADGui.Control.activeDialog())
