"""Everything that a workbench has to have: icons, texts, forms, preferences, packages that hide no others."""
import os
import pathlib
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import check, go, is_panel_open, left_of_panels, note, picture, settle, texts, widget
from PySide import QtCore, QtGui

from sweepmesh.app import preferences
from sweepmesh.gui.commands import COMMANDS
from sweepmesh.gui.resources import RESOURCES, load_form


def steps():
    commands()
    forms()
    icons()
    check("tests, core and Mod hide no other packages", not {"tests", "core", "Mod"} & set(sys.modules))
    check("FreeCAD knows the workbench's icon", pathlib.Path(FreeCADGui.activeWorkbench().Icon).is_file())
    preference_page()
    preferences_are_used()
    whats_this()
    another_language()


def commands():
    known = FreeCADGui.listCommands()
    for name in COMMANDS:
        info = FreeCADGui.Command.get(name).getInfo()
        check(f"{name} is known", name in known)
        check(f"{name} has text and tooltip", info["menuText"] and info["toolTip"])
        check(f"{name} has an icon", os.path.isfile(info["pixmap"]))
        check(f"{name} has a page of help", os.path.isfile(info["whatsThis"]))
        check(f"{name} is off without a document", not FreeCADGui.Command.get(name).isActive())


def forms():
    for path in sorted((RESOURCES / "ui").glob("*.ui")):
        check(f"{path.name} loads", load_form(path.stem) is not None)


def icons():
    for path in sorted((RESOURCES / "icons").glob("*.svg")):
        check(f"{path.name} can be drawn", not QtGui.QIcon(str(path)).pixmap(32, 32).isNull())


def preference_page():
    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        box = dialog.findChild(QtGui.QListWidget)
        names = texts(box)
        box.setCurrentRow(next((i for i, name in enumerate(names) if "SweepMesh" in name), 0))
        settle()
        picture("01_preferences")
        fields = [field for field in dialog.findChildren(QtGui.QSpinBox, "elements") if field.isVisible()]
        check("there is a page of preferences", len(fields) == 1 and fields[0].value() == preferences.DEFAULT_ELEMENTS)
        fields[0].setValue(500)
        dialog.accept()

    QtCore.QTimer.singleShot(1000, look)
    FreeCADGui.runCommand("Std_DlgPreferences")
    settle()
    check("what is set there is kept", preferences.wished_elements() == 500)


def preferences_are_used():
    from sweepmesh.gui.taskpanels.task_sweep import SweepPanel

    document = FreeCAD.newDocument("Part")
    brick = document.addObject("Part::Box", "Brick")
    document.recompute()
    group = FreeCAD.ParamGet(preferences.GROUP)
    group.SetInt("Order", 1)
    group.SetBool("ColourFaces", False)
    panel = SweepPanel(brick)
    settings = panel.settings()
    note("settings", settings)
    check("a panel starts with them", settings["size"] == 1.3 and settings["order"] == 2)
    check("and colours only if wished", not panel.widgets.showRoles.isChecked())
    panel.reject()
    settle()
    check("a panel is found in Python", "SweepPanel" in left_of_panels())
    del panel
    check("a closed panel leaves nothing behind in Python", lambda: left_of_panels() == [])


def whats_this():
    kinds = (QtGui.QAbstractButton, QtGui.QComboBox, QtGui.QAbstractSpinBox, QtGui.QAbstractItemView)
    for name in ("Sweep", "Overrides", "Preview", "Quality"):
        form = load_form(name)
        own = [field for field in form.findChildren(QtGui.QWidget) if isinstance(field, kinds) and _is_own(field)]
        mute = [field.objectName() for field in own if not field.whatsThis()]
        check(f"every field of {name} explains itself", own and not mute)
        note(f"mute in {name}", mute)


def _is_own(field):
    """Is this a field of the form, not a part of one?"""
    return field.objectName() and not field.objectName().startswith("qt_")


def another_language():
    if not (RESOURCES / "translations" / "SweepMesh_de.qm").exists():
        note("no translation", "Qt's lrelease is not installed")
        return
    FreeCADGui.setLocale("German")
    settle()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Brick)
    FreeCADGui.runCommand("SweepMesh_CreateMesh")
    check("the panel speaks German", lambda: is_panel_open() and "durchziehbar" in widget("verdict").text())
    check("its fields, too", widget("propose").text() == "Vorschlagen")
    picture("03_german")
    FreeCADGui.Control.closeDialog()
    FreeCADGui.setLocale("English")


go(steps)
