"""What all document objects of the workbench share: property tables, saving and restoring."""
from dataclasses import dataclass, replace

from FreeCAD import Qt

translate = Qt.translate


EDITABLE, READ_ONLY, HIDDEN = range(3)  # FreeCAD's editor modes


@dataclass(frozen=True)
class Property:
    """One row of an object's table of properties. `values` are those of an enumeration."""

    kind: str
    name: str
    text: str
    default: object = None
    values: tuple = ()
    group: str = ""
    mode: int = EDITABLE


def in_group(group, mode, *rows):
    """Return the rows as those of one group and editor mode; a row's own mode stays where it has one."""
    return tuple(replace(row, group=group, mode=row.mode or mode) for row in rows)


def ensure_properties(obj, table):
    """Give `obj` the properties of `table` that it lacks: all when it is made, new ones when it is restored."""
    for row in table:
        if row.name not in obj.PropertiesList:
            _add_property(obj, row)
        obj.setEditorMode(row.name, row.mode)


def _add_property(obj, row):
    obj.addProperty(row.kind, row.name, row.group, translate("SweepMesh", row.text))
    if row.values:
        setattr(obj, row.name, list(row.values))
    if row.default is not None:
        setattr(obj, row.name, row.default)


class Proxy:
    """Base of the proxies. All state is in properties, so there is none to save, in any version of FreeCAD."""

    Type = ""
    table = ()

    def __init__(self, obj):
        ensure_properties(obj, self.table)
        obj.Proxy = self

    def onDocumentRestored(self, obj):
        ensure_properties(obj, self.table)

    def dumps(self):
        return None

    def loads(self, state):
        pass

    def __getstate__(self):
        return self.dumps()

    def __setstate__(self, state):
        self.loads(state)
