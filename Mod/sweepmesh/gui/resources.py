"""Where icons and forms are, and translation."""
import pathlib

import FreeCADGui
from FreeCAD import Qt
from PySide import QtGui

RESOURCES = pathlib.Path(__file__).resolve().parents[3] / "Resources"


def icon(name):
    """Return the path of an icon: icon("Sweep")."""
    return str(RESOURCES / "icons" / f"{name}.svg")


def load_form(name):
    """Return a new widget made from Resources/ui/`name`.ui."""
    return FreeCADGui.PySideUic.loadUi(str(RESOURCES / "ui" / f"{name}.ui"))


def tr(text):
    """Return the translation of a whole sentence (or label) of the workbench."""
    return Qt.translate("SweepMesh", text)


def button(name):
    """Return a standard button ("Close") as panels hand it to FreeCAD, with Qt 5 and with Qt 6."""
    flag = getattr(QtGui.QDialogButtonBox, name)
    return flag if hasattr(flag, "value") else int(flag)
