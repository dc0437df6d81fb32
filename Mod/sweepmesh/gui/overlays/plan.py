"""A plan drawn on a shape: vertex types as letters, intervals as ticks and numbers on the edges."""
from pivy import coin

LETTERS = {"end": "E", "side": "S", "corner": "C", "reversal": "R"}
TYPE_COLOURS = {
    "end": (0.0, 0.35, 0.0),
    "side": (0.3, 0.3, 0.3),
    "corner": (0.75, 0.0, 0.0),
    "reversal": (0.6, 0.0, 0.6),
}
EDGE_COLOURS = {"axial": (0.0, 0.2, 0.8), "transverse": (0.75, 0.3, 0.0)}
_OTHER_EDGE = (0.2, 0.2, 0.2)
_INSET = 0.04  # how far a letter stands from its vertex, as part of the shape's diagonal
_DEPTH = 0.85  # of the depth buffer's range: less than 1 brings the drawing before the faces that it lies on
_FONT_SIZE = 15
_TICK = coin.SoMarkerSet.CIRCLE_FILLED_5_5


class PlanOverlay:
    """Draws a little before the faces, in the node of a document object; nothing of it can be picked."""

    def __init__(self, obj):
        self._root = obj.ViewObject.RootNode
        shape = obj.Shape.copy()
        shape.Placement = obj.Placement.inverse().multiply(shape.Placement)
        self._elements = _by_name(shape)
        self._inset = _INSET * shape.BoundBox.DiagonalLength
        self._top = coin.SoSeparator()
        style, light, depth = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDepthBuffer()
        style.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        depth.range = (0.0, _DEPTH)
        self._types, self._intervals = coin.SoSeparator(), coin.SoSeparator()
        for node in (style, light, depth, self._types, self._intervals):
            self._top.addChild(node)
        self._root.addChild(self._top)

    def show_types(self, corners):
        """Draw the letters of [("Face3", "Vertex7", "end"), ...]; none clear them."""
        self._types.removeAllChildren()
        for face, vertex, kind in corners:
            point = _beside(self._elements[face], self._elements[vertex].Point, self._inset)
            self._types.addChild(_text(point, LETTERS[kind], TYPE_COLOURS[kind]))

    def show_intervals(self, intervals, roles):
        """Draw ticks and the number on each edge of {"Edge1": 12}, coloured by {"Edge1": "axial"}; none clear them."""
        self._intervals.removeAllChildren()
        for name, number in intervals.items():
            edge = self._elements[name]
            colour = EDGE_COLOURS.get(roles.get(name), _OTHER_EDGE)
            self._intervals.addChild(_markers(edge.discretize(Number=number + 1), colour))
            self._intervals.addChild(_text(edge.discretize(Number=3)[1], f" {number}", colour))

    def remove(self):
        """Take the overlay out of the view, for good."""
        index = self._root.findChild(self._top)
        if index >= 0:
            self._root.removeChild(index)


def _by_name(shape):
    named = {}
    for kind, elements in (("Face", shape.Faces), ("Edge", shape.Edges), ("Vertex", shape.Vertexes)):
        named.update({f"{kind}{i}": element for i, element in enumerate(elements, 1)})
    return named


def _beside(face, point, inset):
    """A point of the face's surface beside `point`, towards the middle but not beyond half the way."""
    way = face.CenterOfMass - point
    aim = point + way * min(0.5, inset / max(way.Length, inset))
    return face.Surface.value(*face.Surface.parameter(aim))


def _text(point, string, colour):
    group = coin.SoSeparator()
    place, paint, font, text = coin.SoTranslation(), coin.SoBaseColor(), coin.SoFont(), coin.SoText2()
    place.translation = tuple(point)
    paint.rgb = colour
    font.name, font.size = "sans:bold", _FONT_SIZE
    text.string = string
    for node in (place, paint, font, text):
        group.addChild(node)
    return group


def _markers(points, colour):
    group = coin.SoSeparator()
    paint, coordinates, markers = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoMarkerSet()
    paint.rgb = colour
    coordinates.point.setValues(0, len(points), [tuple(point) for point in points])
    markers.markerIndex = _TICK
    for node in (paint, coordinates, markers):
        group.addChild(node)
    return group
