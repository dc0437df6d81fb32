"""The lists of sources and targets of a panel, and picking them in the 3D view."""
import FreeCADGui
from PySide import QtCore, QtGui

from sweepmesh.app.stages import faces_with
from sweepmesh.gui.selection import FaceGate

ROLES = ("source", "target")


class FaceLists(QtCore.QObject):
    """Picked and proposed sources and targets. Picks are upright, proposals in italics.

    While one of the buttons is down, a click on a face picks it, and a second click unpicks it. Otherwise the
    lists and the selection in the 3D view follow each other. `changed` says that the picks have changed,
    `selected` which faces of the shape are selected now.
    """

    changed = QtCore.Signal()
    selected = QtCore.Signal(list)

    def __init__(self, form, obj):
        super().__init__()
        self._obj = obj
        self._lists = {"source": form.sources, "target": form.targets}
        self._buttons = {"source": form.pickSources, "target": form.pickTargets}
        self._is_selecting = False
        self._pair_rows = form.pairs
        self.picks = {role: [] for role in ROLES}
        self.pairs = []
        form.pickSources.toggled.connect(self._pick_sources)
        form.pickTargets.toggled.connect(self._pick_targets)
        for rows in self._lists.values():
            rows.itemSelectionChanged.connect(self._select_rows)
        form.removeFaces.clicked.connect(self._remove_rows)
        form.swapFaces.clicked.connect(self.swap)
        form.pairFaces.clicked.connect(self._pair_rows_marked)
        FreeCADGui.Selection.addObserver(self)

    def close(self):
        FreeCADGui.Selection.removeObserver(self)
        FreeCADGui.Selection.removeSelectionGate()

    def set_picks(self, sources, targets, pairs=()):
        """Replace all picks by names of faces, and all prescribed pairs (source, target)."""
        self.picks = {"source": list(sources), "target": list(targets)}
        self.pairs = [tuple(pair) for pair in pairs]
        self.changed.emit()

    def swap(self):
        pairs = [(target, source) for source, target in self.pairs]
        self.set_picks(self._shown("target"), self._shown("source"), pairs)

    def show_roles(self, roles):
        """Fill the lists: the picks, then what `roles` adds to them."""
        for role in ROLES:
            rows = self._lists[role]
            rows.blockSignals(True)
            rows.clear()
            found = [name for name in faces_with(roles, role) if name not in self.picks[role]]
            for name in self.picks[role]:
                rows.addItem(QtGui.QListWidgetItem(name))
            for name in found:
                rows.addItem(_proposal(name))
            rows.blockSignals(False)
        self._pair_rows.clear()
        self._pair_rows.addItems([f"{source} \N{RIGHTWARDS ARROW} {target}" for source, target in self.pairs])
        self._pair_rows.setVisible(bool(self.pairs))

    def toggle(self, role, name):
        """Pick a face for a role, or unpick it; a face has one role."""
        is_picked = name in self.picks[role]
        for picked in self.picks.values():
            if name in picked:
                picked.remove(name)
        self.pairs = [pair for pair in self.pairs if name not in pair]
        if not is_picked:
            self.picks[role].append(name)
        self.changed.emit()

    def addSelection(self, document, obj, sub, point):
        """FreeCAD calls this when something was selected in the 3D view or in the tree."""
        self._tell_selected()
        is_own = (document, obj) == (self._obj.Document.Name, self._obj.Name)
        if self._is_selecting or not is_own or not sub.startswith("Face"):
            return
        role = self._picking_role()
        if role:
            self.toggle(role, sub)
            QtCore.QTimer.singleShot(0, FreeCADGui.Selection.clearSelection)
        else:
            self._mark_rows(sub)

    def removeSelection(self, document, obj, sub):
        """FreeCAD calls this when something is selected no more."""
        self._tell_selected()

    def clearSelection(self, document):
        """FreeCAD calls this when nothing is selected any more."""
        self.selected.emit([])

    def _tell_selected(self):
        chosen = FreeCADGui.Selection.getSelectionEx(self._obj.Document.Name)
        self.selected.emit([name for one in chosen if one.Object == self._obj for name in one.SubElementNames])

    def _picking_role(self):
        return next((role for role in ROLES if self._buttons[role].isChecked()), None)

    # Slots are methods, never lambdas: those would keep panel and widgets alive in Python after FreeCAD has deleted
    # the widgets, and a new widget at the old address would be taken for the old one.
    def _pick_sources(self, down):
        self._set_picking("source", down)

    def _pick_targets(self, down):
        self._set_picking("target", down)

    def _set_picking(self, role, down):
        other = ROLES[1 - ROLES.index(role)]
        if down:
            self._buttons[other].setChecked(False)
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelectionGate(FaceGate(self._obj))
        elif not self._buttons[other].isChecked():
            FreeCADGui.Selection.removeSelectionGate()

    def _shown(self, role):
        rows = self._lists[role]
        return [rows.item(i).text() for i in range(rows.count())]

    def _select_rows(self):
        names = [name for each in ROLES for name in self._marked(each)]
        self._is_selecting = True
        FreeCADGui.Selection.clearSelection()
        for name in names:
            FreeCADGui.Selection.addSelection(self._obj, name)
        self._is_selecting = False

    def _mark_rows(self, name):
        for rows in self._lists.values():
            rows.blockSignals(True)
            for i in range(rows.count()):
                rows.item(i).setSelected(rows.item(i).text() == name)
            rows.blockSignals(False)

    def _marked(self, role):
        return [item.text() for item in self._lists[role].selectedItems()]

    def _remove_rows(self):
        marked = {role: self._marked(role) for role in ROLES}
        gone = {self._pair_rows.row(item) for item in self._pair_rows.selectedItems()}
        for role in ROLES:
            self.picks[role] = [name for name in self.picks[role] if name not in marked[role]]
        kept = [pair for i, pair in enumerate(self.pairs) if i not in gone]
        self.pairs = [(s, t) for s, t in kept if s not in marked["source"] and t not in marked["target"]]
        self.changed.emit()

    def _pair_rows_marked(self):
        sources, targets = self._marked("source"), self._marked("target")
        if sources and len(targets) == 1:
            others = [pair for pair in self.pairs if pair[0] not in sources]
            self.pairs = others + [(source, targets[0]) for source in sources]
            self.changed.emit()


def _proposal(name):
    item = QtGui.QListWidgetItem(name)
    font = item.font()
    font.setItalic(True)
    item.setFont(font)
    return item
