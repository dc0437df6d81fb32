"""Where icons and forms are, and translation."""
import importlib
import pathlib

import FreeCADGui
from FreeCAD import Qt
from PySide import QtCore, QtGui

# shiboken2 or shiboken6, as FreeCAD has PySide2 or PySide6
_shiboken = importlib.import_module(QtCore.QObject.__module__.split(".")[0].replace("PySide", "shiboken"))
RESOURCES = pathlib.Path(__file__).resolve().parents[3] / "Resources"


def icon(name):
    """Return the path of an icon: icon("Sweep")."""
    return str(RESOURCES / "icons" / f"{name}.svg")


def page(name):
    """Return the path of a page of the documentation, for FreeCAD's "What's this?" on commands."""
    return str(RESOURCES.parent / "docs" / f"{name}.md")


def load_form(name):
    """Return a new widget made from Resources/ui/`name`.ui."""
    return FreeCADGui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui"))


def let_go(forms):
    """Part the Python halves of forms that close from the widgets, which FreeCAD is about to delete.

    Else these halves, and those of rows of lists, may outlive the widgets where some other code has seen them, and
    PySide takes one for whatever Qt puts at its address next, be it a widget of another workbench.
    """
    for form in forms:
        for rows in form.findChildren(QtGui.QListWidget):
            rows.blockSignals(True)
            rows.clear()
        _shiboken.invalidate(form)


class Widgets:
    """The widgets of several forms by their names, as if they were one form."""

    def __init__(self, forms):
        self._forms = forms

    def __getattr__(self, name):
        for form in self._forms:
            found = form if form.objectName() == name else form.findChild(QtGui.QWidget, name)
            if found is not None:
                self.__dict__[name] = found
                return found
        raise AttributeError(name)


def tr(text):
    """Return the translation of a whole sentence (or label) of the workbench."""
    return Qt.translate("SweepMesh", text)


def button(name):
    """Return a standard button ("Close") as panels hand it to FreeCAD, with Qt 5 and with Qt 6."""
    flag = getattr(QtGui.QDialogButtonBox, name)
    return flag if hasattr(flag, "value") else int(flag)
