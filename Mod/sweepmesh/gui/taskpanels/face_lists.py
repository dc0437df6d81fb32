"""The lists of sources and targets of a panel, and picking them in the 3D view."""
from PySide import QtCore, QtGui

from sweepmesh.app.stages import faces_with
from sweepmesh.gui.selection import Gate

ROLES = ("source", "target")


class FaceLists(QtCore.QObject):
    """Picked and proposed sources and targets. Picks are upright, proposals in italics.

    While one of the buttons is down, a click on a face picks it, and a second click unpicks it. Otherwise the
    lists and the selection in the 3D view follow each other. `changed` says that the picks have changed.
    """

    changed = QtCore.Signal()

    def __init__(self, form, obj, picking):
        super().__init__()
        self._picking = picking
        self._lists = {"source": form.sources, "target": form.targets}
        self._pair_rows = form.pairs
        self.picks = {role: [] for role in ROLES}
        self.pairs = []
        picking.add(form.pickSources, Gate(obj, "Face"), self.take_source)
        picking.add(form.pickTargets, Gate(obj, "Face"), self.take_target)
        picking.clicked.connect(self._mark_rows)
        for rows in self._lists.values():
            rows.itemSelectionChanged.connect(self._select_rows)
        form.removeFaces.clicked.connect(self._remove_rows)
        form.swapFaces.clicked.connect(self.swap)
        form.pairFaces.clicked.connect(self._pair_rows_marked)

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

    def take_source(self, name, _point):
        """A face was clicked while sources are picked."""
        self.toggle("source", name)

    def take_target(self, name, _point):
        """A face was clicked while targets are picked."""
        self.toggle("target", name)

    def _shown(self, role):
        rows = self._lists[role]
        return [rows.item(i).text() for i in range(rows.count())]

    def _select_rows(self):
        self._picking.select([name for each in ROLES for name in self._marked(each)])

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
