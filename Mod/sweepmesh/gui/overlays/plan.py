"""A plan drawn on a shape: vertex types as letters, intervals as ticks and numbers, levels as colours."""
import numpy as np
from pivy import coin

LETTERS = {"end": "E", "side": "S", "corner": "C", "reversal": "R"}
TYPE_COLOURS = {
    "end": (0.0, 0.35, 0.0),
    "side": (0.3, 0.3, 0.3),
    "corner": (0.75, 0.0, 0.0),
    "reversal": (0.6, 0.0, 0.6),
}
EDGE_COLOURS = {
    "axial": (0.0, 0.2, 0.8),
    "transverse": (0.5, 0.15, 0.0),
    "divided": (0.25, 0.1, 0.1),
    "own": (0.8, 0.0, 0.5),
    None: (0.2, 0.2, 0.2),
}
_LEVEL_STOPS = (0.0, 0.5, 1.0)
_LEVEL_COLOURS = ((0.27, 0.0, 0.33), (0.13, 0.57, 0.55), (0.99, 0.91, 0.14))
_LEVEL_WIDTH = 4
_LEVEL_TEXT = (1.0, 1.0, 1.0)
_INSET = 0.04  # how far a letter stands from its vertex, as part of the shape's diagonal
_DEPTH = 0.99  # of the depth buffer's range: less than 1 brings the drawing before the faces that it lies on
_NUMBER_DEPTH = 0.88  # numbers on edges reach farther over the faces beside them
_FONT_SIZE = 15
_TICK_SIZE = 6  # pixels


class PlanOverlay:
    """Draws a little before the faces, in the node of a document object; nothing of it can be picked."""

    def __init__(self, obj):
        self._root = obj.ViewObject.RootNode
        shape = obj.Shape.copy()
        shape.Placement = obj.Placement.inverse().multiply(shape.Placement)
        self._elements = _by_name(shape)
        self._vertices = _vertices_of(shape)
        self._inset = _INSET * shape.BoundBox.DiagonalLength
        self._top = coin.SoSeparator()
        style, light, depth, font = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDepthBuffer(), coin.SoFont()
        font.name, font.size = "sans:bold", _FONT_SIZE
        style.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        depth.range = (0.0, _DEPTH)
        self._types, self._intervals, self._levels = coin.SoSeparator(), coin.SoSeparator(), coin.SoSeparator()
        for node in (style, light, depth, font, self._types, self._intervals, self._levels):
            self._top.addChild(node)
        self._root.addChild(self._top)

    def show_types(self, corners, emphasized):
        """Draw the letters of [("Face3", "Vertex7", "end"), ...]; none clear them. `emphasized`: ("Face3", "Vertex7")."""
        self._types.removeAllChildren()
        groups = {}
        for face, vertex, kind in corners:
            colour = EDGE_COLOURS["own"] if (face, vertex) in emphasized else TYPE_COLOURS[kind]
            groups.setdefault(colour, []).append((self._beside(face, vertex), LETTERS[kind]))
        for colour, texts in groups.items():
            self._types.addChild(_in_colour(colour, [], texts))

    def show_intervals(self, edge_nodes, roles, emphasized):
        """Draw the nodes of {"Edge1": points} as ticks, and how many intervals they make; none clear them.

        Colours follow {"Edge1": "axial"}, or say that the edge is one of `emphasized`. Edges on which a number
        has no room have ticks only.
        """
        self._intervals.removeAllChildren()
        groups = {}
        for name in edge_nodes:
            groups.setdefault("own" if name in emphasized else roles.get(name), []).append(name)
        for role, names in groups.items():
            ticks = np.concatenate([edge_nodes[name] for name in names])
            texts = [self._number_on(name, edge_nodes[name]) for name in names if self._has_room(name)]
            self._intervals.addChild(_in_colour(EDGE_COLOURS[role], ticks.tolist(), texts))

    def show_levels(self, levels, edge_nodes, caps):
        """Draw edges within a layer in its colour, by {"Vertex1": 0} and {"Edge1": points}; none clear them.

        On the faces of `caps`, {"Face1": 0}, stands the number of their layer.
        """
        self._levels.removeAllChildren()
        lines = {}
        for edge, nodes in edge_nodes.items():
            at = {levels.get(vertex) for vertex in self._vertices[edge]}
            if len(at) == 1 and None not in at:
                lines.setdefault(at.pop(), []).append(nodes)
        highest = max(levels.values(), default=0)
        for level in sorted(lines):
            self._levels.addChild(_polylines(level_colour(level, highest), lines[level]))
        texts = [(self._middle(face), f"{level}") for face, level in caps.items()]
        self._levels.addChild(_in_colour(_LEVEL_TEXT, [], texts))

    def cap_levels(self, levels, roles):
        """Return {"Face1": 0} for the sources and targets in `roles`, by {"Vertex1": 0}."""
        caps = [face for face, role in roles.items() if role in ("source", "target")]
        at = {face: [levels[vertex] for vertex in self._vertices[face] if vertex in levels] for face in caps}
        return {face: of_vertices[0] for face, of_vertices in at.items() if of_vertices}

    def _middle(self, face):
        face = self._elements[face]
        return face.Surface.value(*face.Surface.parameter(face.CenterOfMass))

    def _has_room(self, edge):
        return self._elements[edge].Length > self._inset

    def _number_on(self, edge, nodes):
        return self._elements[edge].discretize(Number=3)[1], f" {len(nodes) - 1}"

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


def _vertices_of(shape):
    """{"Edge1": ["Vertex1", ...], "Face1": ...}"""
    places = {}
    for i, vertex in enumerate(shape.Vertexes, 1):
        places.setdefault(vertex.hashCode(), []).append((f"Vertex{i}", vertex))

    def name(vertex):
        return next(its for its, same in places[vertex.hashCode()] if same.isSame(vertex))

    named = {}
    for kind, elements in (("Face", shape.Faces), ("Edge", shape.Edges)):
        named.update({f"{kind}{i}": [name(v) for v in element.Vertexes] for i, element in enumerate(elements, 1)})
    return named


def level_colour(level, highest):
    """The colour of a level: from violet, 0, over green to yellow, the highest."""
    at = level / highest if highest else 0.0
    return tuple(float(np.interp(at, _LEVEL_STOPS, channel)) for channel in zip(*_LEVEL_COLOURS))


def _polylines(colour, lines):
    group, paint, style = coin.SoSeparator(), coin.SoBaseColor(), coin.SoDrawStyle()
    paint.rgb = colour
    style.lineWidth = _LEVEL_WIDTH
    points, indices, n_points = [], [], 0
    for line in lines:
        points.extend(line.tolist())
        indices.extend([*range(n_points, n_points + len(line)), -1])
        n_points += len(line)
    coordinates, strips = coin.SoCoordinate3(), coin.SoIndexedLineSet()
    coordinates.point.setValues(0, len(points), points)
    strips.coordIndex.setValues(0, len(indices), indices)
    for node in (paint, style, coordinates, strips):
        group.addChild(node)
    return group


def _in_colour(colour, ticks, texts):
    """One group for all that has one colour: the fewer nodes, the faster it is drawn."""
    group, paint = coin.SoSeparator(), coin.SoBaseColor()
    paint.rgb = colour
    group.addChild(paint)
    if ticks:
        style, coordinates, points = coin.SoDrawStyle(), coin.SoCoordinate3(), coin.SoPointSet()
        style.pointSize = _TICK_SIZE
        coordinates.point.setValues(0, len(ticks), ticks)
        for node in (style, coordinates, points):
            group.addChild(node)
    here = coin.SbVec3f(0, 0, 0)
    if ticks and texts:
        depth = coin.SoDepthBuffer()
        depth.range = (0.0, _NUMBER_DEPTH)
        group.addChild(depth)
    for point, string in texts:
        way, text = coin.SoTranslation(), coin.SoText2()
        there = coin.SbVec3f(*point)
        way.translation = there - here
        text.string, here = string, there
        group.addChild(way)
        group.addChild(text)
    return group
