"""A plan drawn on a shape: vertex types as letters, intervals as ticks and numbers on the edges."""
from pivy import coin

LETTERS = {"end": "E", "side": "S", "corner": "C", "reversal": "R"}
TYPE_COLOURS = {
    "end": (0.0, 0.35, 0.0),
    "side": (0.3, 0.3, 0.3),
    "corner": (0.75, 0.0, 0.0),
    "reversal": (0.6, 0.0, 0.6),
}
EDGE_COLOURS = {"axial": (0.0, 0.2, 0.8), "transverse": (0.75, 0.3, 0.0), None: (0.2, 0.2, 0.2)}
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
        style, light, depth, font = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDepthBuffer(), coin.SoFont()
        font.name, font.size = "sans:bold", _FONT_SIZE
        style.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        depth.range = (0.0, _DEPTH)
        self._types, self._intervals = coin.SoSeparator(), coin.SoSeparator()
        for node in (style, light, depth, font, self._types, self._intervals):
            self._top.addChild(node)
        self._root.addChild(self._top)

    def show_types(self, corners):
        """Draw the letters of [("Face3", "Vertex7", "end"), ...]; none clear them."""
        self._types.removeAllChildren()
        for kind, colour in TYPE_COLOURS.items():
            texts = [(self._beside(*of), LETTERS[kind]) for *of, its in corners if its == kind]
            self._types.addChild(_in_colour(colour, [], texts))

    def show_intervals(self, intervals, roles):
        """Draw ticks and the number on each edge of {"Edge1": 12}, coloured by {"Edge1": "axial"}; none clear them.

        Edges on which a number has no room have ticks only.
        """
        self._intervals.removeAllChildren()
        for role, colour in EDGE_COLOURS.items():
            ticks, texts = [], []
            for name in [name for name in intervals if roles.get(name) == role]:
                edge = self._elements[name]
                ticks.extend(edge.discretize(Number=intervals[name] + 1))
                if edge.Length > self._inset:
                    texts.append((edge.discretize(Number=3)[1], f" {intervals[name]}"))
            self._intervals.addChild(_in_colour(colour, ticks, texts))

    def _beside(self, face, vertex):
        """A point of the face's surface beside a vertex, towards the middle but not beyond half the way."""
        face, point = self._elements[face], self._elements[vertex].Point
        way = face.CenterOfMass - point
        aim = point + way * min(0.5, self._inset / max(way.Length, self._inset))
        return face.Surface.value(*face.Surface.parameter(aim))

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


def _in_colour(colour, ticks, texts):
    """One group for all that has one colour: the fewer nodes, the faster it is drawn."""
    group, paint = coin.SoSeparator(), coin.SoBaseColor()
    paint.rgb = colour
    group.addChild(paint)
    if ticks:
        coordinates, markers = coin.SoCoordinate3(), coin.SoMarkerSet()
        coordinates.point.setValues(0, len(ticks), [tuple(point) for point in ticks])
        markers.markerIndex = _TICK
        group.addChild(coordinates)
        group.addChild(markers)
    here = coin.SbVec3f(0, 0, 0)
    for point, string in texts:
        way, text = coin.SoTranslation(), coin.SoText2()
        there = coin.SbVec3f(*point)
        way.translation = there - here
        text.string, here = string, there
        group.addChild(way)
        group.addChild(text)
    return group
