"""What is prescribed for single edges and vertices: picked in the 3D view, listed, changed and taken back here."""
from dataclasses import dataclass

import FreeCAD
from PySide import QtCore, QtGui

from sweepmesh.gui.resources import tr


@dataclass(frozen=True)
class Kind:
    """One kind of override: the setting that it is in, and the form's fields for its value."""

    setting: str
    fields: tuple


COUNT = Kind("edge_count", ("overrideCount",))
SIZE = Kind("edge_size", ("overrideSize",))
BIAS = Kind("edge_bias", ("overrideRatio", "overrideBoth"))
TYPE = Kind("vertex_types", ("overrideType",))
KINDS = (COUNT, SIZE, BIAS, TYPE)
TYPES = ("end", "side", "corner", "reversal")
_EXCLUSIVE = {COUNT.setting: SIZE.setting, SIZE.setting: COUNT.setting}


class Overrides(QtCore.QObject):
    """Counts, sizes and biases by the names of edges, types by those of a face and a vertex: `settings()` as the
    functions of `app` take them.

    While the button is down, a click on an edge prescribes what the fields say, a second click takes it back; for
    a vertex type a linking face is clicked first, then its vertices. What is marked in the list is selected in the
    3D view, shown in the fields and changed with them. `changed` says that other counts, sizes or biases are
    prescribed now, `types_changed` that other types are, `started` that picking has begun, and of what.
    """

    changed = QtCore.Signal()
    types_changed = QtCore.Signal()
    started = QtCore.Signal(str)

    def __init__(self, form, obj, picking):
        super().__init__()
        self._form, self._obj, self._picking = form, obj, picking
        self._values = {kind.setting: {} for kind in KINDS}
        self._is_loading = False
        self._caps, self._face = set(), None  # the face whose vertices are picked
        form.overrideKind.addItems([tr("Intervals"), tr("Edge length"), tr("Growth"), tr("Vertex type")])
        form.overrideType.addItems([tr("End (1 quad)"), tr("Side (2 quads)"), tr("Corner (3)"), tr("Reversal (4)")])
        form.overrideHint.setVisible(False)
        picking.add(form.pickOverride, _Gate(self), self.take)
        picking.clicked.connect(self._mark_rows)
        picking.started.connect(self._picking_started)
        form.pickOverride.toggled.connect(self._show_hint)
        form.overrideKind.currentIndexChanged.connect(self._show_fields)
        form.overrideType.currentIndexChanged.connect(self._value_changed)
        form.overrideCount.valueChanged.connect(self._value_changed)
        form.overrideRatio.valueChanged.connect(self._value_changed)
        form.overrideBoth.toggled.connect(self._value_changed)
        QtCore.QObject.connect(form.overrideSize, QtCore.SIGNAL("valueChanged(double)"), self._value_changed)
        form.overrides.itemSelectionChanged.connect(self._rows_marked)
        form.removeOverrides.clicked.connect(self._remove_rows)
        self._show_fields()

    def set(self, size, settings):
        """Show what `settings` prescribe; `size` is the edge length to start with."""
        self._form.overrideSize.setProperty("rawValue", size or 1.0)
        for setting in self._values:
            self._values[setting] = dict(settings.get(setting, {}))
        self._fill()

    def settings(self):
        """Return {"edge_count": {"Edge5": 12}, ...}."""
        return {setting: dict(values) for setting, values in self._values.items()}

    def names(self):
        """Return the names of all edges, and the names (face, vertex), for which something is prescribed."""
        return {name for values in self._values.values() for name in values}

    def set_caps(self, faces):
        """These faces are picked as sources or targets: they have no vertex types."""
        self._caps = set(faces)

    def forget_all(self):
        """Prescribe nothing any more."""
        self.set(None, {})
        self.types_changed.emit()

    def admits(self, obj, name):
        """May this be clicked now?"""
        if obj != self._obj:
            return False
        if self._kind() is not TYPE:
            return name.startswith("Edge")
        if name.startswith("Face"):
            return name not in self._caps
        return bool(self._face) and name in vertices_of(self._obj.Shape, self._face)

    def take(self, name, point):
        """Something was clicked while overrides are picked: prescribe what the fields say, or take it back."""
        if name.startswith("Face"):
            self._take_face(name)
            return
        if self._kind() is TYPE:
            name = self._face, name
            QtCore.QTimer.singleShot(0, self._show_face)
        setting, value = self._kind().setting, self._value(name, point)
        if self._values[setting].get(name) == value:
            del self._values[setting][name]
        else:
            self._values[setting][name] = value
            self._values.get(_EXCLUSIVE.get(setting), {}).pop(name, None)
        self._fill()
        self._tell([setting])

    def _take_face(self, name):
        self._face = name
        self._show_hint()
        QtCore.QTimer.singleShot(0, self._show_face)

    def _show_face(self):
        """The face stays selected, so that it can be seen whose vertices are picked."""
        if self._face and self._kind() is TYPE and self._picking.is_down(self._form.pickOverride):
            self._picking.select([self._face])

    def _tell(self, settings):
        (self.types_changed if TYPE.setting in settings else self.changed).emit()

    def _kind(self):
        return KINDS[self._form.overrideKind.currentIndex()]

    def _value(self, name=None, point=None):
        """What the fields say; a bias begins at the end of the edge that is nearer to `point`."""
        form, kind = self._form, self._kind()
        if kind is COUNT:
            return form.overrideCount.value()
        if kind is SIZE:
            return form.overrideSize.property("rawValue")
        if kind is TYPE:
            return TYPES[form.overrideType.currentIndex()]
        ratio, is_symmetric = round(form.overrideRatio.value(), 6), form.overrideBoth.isChecked()
        is_turned = point and not is_symmetric and _is_nearer_to_end(self._obj, name, point)
        return (round(1 / ratio, 6) if is_turned else ratio), is_symmetric

    # --- the list -------------------------------------------------------------------------------------

    def _fill(self, marked=()):
        rows = self._form.overrides
        self._is_loading = True
        rows.clear()
        for setting, values in self._values.items():
            for name in sorted(values, key=_numbers):
                item = QtGui.QListWidgetItem(_row_text(setting, name, values[name]))
                item.setData(QtCore.Qt.UserRole, [setting, name])
                rows.addItem(item)
                item.setSelected((setting, name) in marked)
        self._is_loading = False

    def _marked(self):
        return [_row(item) for item in self._form.overrides.selectedItems()]

    def _rows_marked(self):
        marked = self._marked()
        if self._is_loading:
            return
        self._picking.select([part for _, name in marked for part in _parts(name)])
        if marked:
            self._load(*marked[0])

    def _mark_rows(self, name):
        rows = self._form.overrides
        self._is_loading = True
        for i in range(rows.count()):
            rows.item(i).setSelected(_parts(_row(rows.item(i))[1])[-1] == name)
        self._is_loading = False
        if self._marked():
            self._load(*self._marked()[0])

    def _remove_rows(self):
        marked = self._marked()
        for setting, name in marked:
            del self._values[setting][name]
        self._fill()
        self._tell([setting for setting, _ in marked])

    # --- the fields -----------------------------------------------------------------------------------

    def _load(self, setting, name):
        """Show in the fields what is prescribed for an edge."""
        form, value = self._form, self._values[setting][name]
        self._is_loading = True
        form.overrideKind.setCurrentIndex([kind.setting for kind in KINDS].index(setting))
        if setting == COUNT.setting:
            form.overrideCount.setValue(value)
        elif setting == SIZE.setting:
            form.overrideSize.setProperty("rawValue", value)
        elif setting == TYPE.setting:
            form.overrideType.setCurrentIndex(TYPES.index(value))
        else:
            form.overrideRatio.setValue(value[0])
            form.overrideBoth.setChecked(value[1])
        self._is_loading = False

    def _value_changed(self, *_):
        """The marked rows of this kind get what the fields say now."""
        marked = [] if self._is_loading else self._marked()
        own = [(setting, name) for setting, name in marked if setting == self._kind().setting]
        if own:
            for setting, name in own:
                self._values[setting][name] = self._value()
            self._fill(own)
            self._tell([self._kind().setting])

    def _show_fields(self, *_):
        for kind in KINDS:
            for field in kind.fields:
                getattr(self._form, field).setVisible(kind is self._kind())
        self._show_hint()

    def _show_hint(self, *_):
        self._form.overrideHint.setVisible(self._form.pickOverride.isChecked())
        if self._kind() is BIAS:
            self._form.overrideHint.setText(tr("Click on an edge near the end where its mesh edges are to be short."))
        elif self._kind() is TYPE and self._face:
            self._form.overrideHint.setText(tr("Click on vertices of {}, or on another face.").format(self._face))
        elif self._kind() is TYPE:
            self._form.overrideHint.setText(tr("Click on a linking face, then on its vertices."))
        else:
            self._form.overrideHint.setText(tr("Click on edges of the solid."))

    def _picking_started(self, button):
        if button is self._form.pickOverride:
            self._form.overrides.clearSelection()
            self._face = None
            self._show_hint()
            self.started.emit(self._kind().setting)


class _Gate:
    """Selection gate that admits what can be picked now."""

    def __init__(self, overrides):
        self._overrides = overrides

    def allow(self, document, obj, sub):
        return self._overrides.admits(obj, sub)


def _row(item):
    setting, name = item.data(QtCore.Qt.UserRole)
    return setting, tuple(name) if isinstance(name, (list, tuple)) else name


def _parts(name):
    """The elements that a name stands for: one edge, or a face and its vertex."""
    return [name] if isinstance(name, str) else list(name)


def _numbers(name):
    return [int(part.lstrip("EdgeFacVrtx")) for part in _parts(name)]


def _row_text(setting, name, value):
    if setting == TYPE.setting:
        return tr("{1} of {0}: {2}").format(*name, value)
    if setting == COUNT.setting:
        return tr("{}: {} intervals").format(name, value)
    if setting == SIZE.setting:
        return tr("{}: edge length {}").format(name, FreeCAD.Units.Quantity(value, FreeCAD.Units.Length).UserString)
    ratio, is_symmetric = value
    return (tr("{}: growth {:g} from both ends") if is_symmetric else tr("{}: growth {:g}")).format(name, ratio)


def vertices_of(shape, face):
    """Return the names of the vertices of a face."""
    own = shape.getElement(face).Vertexes
    return [f"Vertex{i}" for i, vertex in enumerate(shape.Vertexes, 1) if any(vertex.isSame(v) for v in own)]


def _is_nearer_to_end(obj, name, point):
    """Is `point` of the 3D view nearer to the end of an edge of `obj` than to its start?"""
    edge = obj.Shape.getElement(name)
    where = obj.Placement.multiply(obj.getGlobalPlacement().inverse()).multVec(FreeCAD.Vector(*point))
    start, end = edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)
    return where.distanceToPoint(end) < where.distanceToPoint(start)
