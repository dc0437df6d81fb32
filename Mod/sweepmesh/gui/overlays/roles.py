"""Faces of a shape in colours that say something: what they are in the sweep, for one."""
from pivy import coin

COLOURS = {
    "source": (1.0, 0.55, 0.15),
    "target": (0.20, 0.50, 1.0),
    "linking": (0.80, 0.86, 0.68),
    "divided": (0.85, 0.70, 0.55),
}
_GLOW = 0.2  # part of the colour that needs no light, so that it can be told from all sides
_BETWEEN = 0.5  # polygon offset: before the shape's faces (1), behind its edges (0)
_COARSER = 1.1  # than FreeCAD's facets: those are kept then


class FaceOverlay:
    """Draws coloured faces over a document object's own; the object is not changed."""

    def __init__(self, obj):
        self._root = obj.ViewObject.RootNode
        self._separator = _unpickable_separator()
        self._faces = {}
        for name, facets in _facets_of_faces(obj).items():
            self._faces[name] = _Face(facets)
            self._separator.addChild(self._faces[name].switch)
        self._colours, self._uncovered = {}, ()
        self._root.addChild(self._separator)

    def set_colours(self, colours):
        """Colour the faces of {"Face1": (r, g, b), ...}; others keep their own colours."""
        if colours != self._colours:
            self._colours = dict(colours)
            self._draw()

    def uncover(self, names):
        """Leave these faces to the shape's own colours: FreeCAD shows there what is selected."""
        self._uncovered = tuple(names)
        self._draw()

    def remove(self):
        """Take the overlay out of the view, for good."""
        index = self._root.findChild(self._separator)
        if index >= 0:
            self._root.removeChild(index)

    def _draw(self):
        for name, face in self._faces.items():
            face.show(None if name in self._uncovered else self._colours.get(name))


class _Face:
    def __init__(self, facets):
        self.switch, self._material = coin.SoSwitch(), coin.SoMaterial()
        group = coin.SoSeparator()
        for node in (self._material, *_face_set(*facets)):
            group.addChild(node)
        self.switch.addChild(group)
        self.switch.whichChild = coin.SO_SWITCH_NONE

    def show(self, colour):
        """Draw the face in a colour, or not at all for None."""
        if colour:
            self._material.diffuseColor = colour
            self._material.emissiveColor = [_GLOW * part for part in colour]
        self.switch.whichChild = coin.SO_SWITCH_ALL if colour else coin.SO_SWITCH_NONE


def _unpickable_separator():
    separator = coin.SoSeparator()
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    offset = coin.SoPolygonOffset()
    offset.factor, offset.units = _BETWEEN, _BETWEEN
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    for node in (style, offset, hints):
        separator.addChild(node)
    return separator


def _facets_of_faces(obj):
    """{"Face1": (points, triangles)} in the object's own coordinates: its node places them.

    The facets are those that FreeCAD draws, where it has drawn any: others would be now before, now behind them.
    """
    back, box = obj.Placement.inverse(), obj.Shape.BoundBox
    deviation = _COARSER * getattr(obj.ViewObject, "Deviation", 0.5) * (box.XLength + box.YLength + box.ZLength) / 300
    facets = [face.tessellate(max(deviation, 1e-9)) for face in obj.Shape.Faces]
    return {f"Face{i}": (list(map(back.multVec, points)), three) for i, (points, three) in enumerate(facets, 1)}


def _face_set(points, triangles):
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), [tuple(point) for point in points])
    indices = [index for triangle in triangles for index in (*triangle, -1)]
    faces = coin.SoIndexedFaceSet()
    faces.coordIndex.setValues(0, len(indices), indices)
    return coordinates, faces
