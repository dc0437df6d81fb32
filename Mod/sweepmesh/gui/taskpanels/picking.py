"""Picking in the 3D view for a panel: which button is down, what it admits, who gets what is clicked."""
import FreeCADGui
from PySide import QtCore


class Picking(QtCore.QObject):
    """At most one button of a panel is down; what is clicked then goes to its taker and is not kept selected.

    Otherwise `clicked` tells what was selected last, by the user. `selected` tells the names of all that is
    selected of the shape now. `started` tells the button that went down.
    """

    clicked = QtCore.Signal(str)
    selected = QtCore.Signal(list)
    started = QtCore.Signal(object)

    def __init__(self, obj):
        super().__init__()
        self._obj = obj
        self._takers = []  # (button, gate, function of name and point)
        self._is_selecting = False
        FreeCADGui.Selection.addObserver(self)

    def add(self, button, gate, taker):
        """While `button` is down, what `gate` admits goes to `taker(name, point)`; the point may be None."""
        self._takers.append((button, gate, taker))
        button.toggled.connect(self._toggled)

    def close(self):
        FreeCADGui.Selection.removeObserver(self)
        FreeCADGui.Selection.removeSelectionGate()
        self._takers = []

    def is_down(self, button):
        return button.isChecked()

    def select(self, names):
        """Select these elements of the shape, and nothing else."""
        self._is_selecting = True
        FreeCADGui.Selection.clearSelection()
        for name in names:
            FreeCADGui.Selection.addSelection(self._obj, name)
        self._is_selecting = False

    def addSelection(self, document, obj, sub, point):
        """FreeCAD calls this when something was selected in the 3D view or in the tree."""
        self._tell_selected()
        is_own = (document, obj) == (self._obj.Document.Name, self._obj.Name)
        if self._is_selecting or not is_own or not sub:
            return
        taker = next((take for button, _, take in self._takers if button.isChecked()), None)
        if taker is None:
            self.clicked.emit(sub)
        else:
            QtCore.QTimer.singleShot(0, FreeCADGui.Selection.clearSelection)
            taker(sub, point)

    def removeSelection(self, document, obj, sub):
        """FreeCAD calls this when something is selected no more."""
        self._tell_selected()

    def clearSelection(self, document):
        """FreeCAD calls this when nothing is selected any more."""
        self.selected.emit([])

    def _tell_selected(self):
        chosen = FreeCADGui.Selection.getSelectionEx(self._obj.Document.Name)
        self.selected.emit([name for one in chosen if one.Object == self._obj for name in one.SubElementNames])

    def _toggled(self, is_down):
        pressed = self.sender()
        if is_down:
            for button, gate, _ in self._takers:
                if button is not pressed:
                    button.setChecked(False)
                else:
                    FreeCADGui.Selection.clearSelection()
                    FreeCADGui.Selection.addSelectionGate(gate)
            self.started.emit(pressed)
        elif not any(button.isChecked() for button, _, _ in self._takers):
            FreeCADGui.Selection.removeSelectionGate()
