"""The imprint drawn on a shape: paired parts of the caps in one colour, imprinted curves as lines."""
from pivy import coin

from sweepmesh.app.imprints import from_engine

_BETWEEN = 0.25  # polygon offset: before the faces of FaceOverlay (0.5), behind the shape's edges (0)
_GLOW = 0.25  # part of a colour that needs no light
_FACE_DEPTH = 0.998  # facets of curved caps are not those that FreeCAD draws
_DEPTH = 0.99  # of the depth buffer's range: brings the curves before the faces that they lie on
_CURVE_COLOUR = (0.75, 0.0, 0.35)
_CURVE_WIDTH = 3
_DEVIATION = 0.002  # of facets and lines, as part of the diagonal; for drawing only


class Drawing:
    """What is drawn of an engine's Imprint, as plain numbers: can be made outside the GUI's thread."""

    def __init__(self, details):
        imprint = from_engine(details)
        deviation = _DEVIATION * max(imprint.caps.BoundBox.DiagonalLength, 1e-12)
        facets = [face.tessellate(deviation) for face in imprint.caps.Faces]
        self.parts = [(colour, *facet) for colour, facet in zip(imprint.colors, facets)]
        self.n_pairs = details.n_pairs
        self.curves = [edge.discretize(Deflection=deviation) for edge in imprint.curves.Edges]


class ImprintOverlay:
    """Draws before the faces of a document object, in its node; nothing of it can be picked."""

    def __init__(self, obj):
        self._root = obj.ViewObject.RootNode
        self._back = obj.Placement.inverse()  # the node places what is below it
        self._top, style = coin.SoSeparator(), coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self._parts, self._curves = coin.SoSeparator(), coin.SoSeparator()
        for node in (style, self._parts, self._curves):
            self._top.addChild(node)
        self._root.addChild(self._top)

    def show_pairs(self, drawing):
        """Draw the parts of the caps, those of a pair in one colour; None clears them."""
        self._parts.removeAllChildren()
        if drawing is not None:
            for node in _face_style():
                self._parts.addChild(node)
            for colour, points, triangles in drawing.parts:
                self._parts.addChild(_part(colour, self._placed(points), triangles))

    def show_curves(self, drawing):
        """Draw the imprinted curves; None clears them."""
        self._curves.removeAllChildren()
        if drawing is not None and drawing.curves:
            for node in _lines([self._placed(points) for points in drawing.curves]):
                self._curves.addChild(node)

    def remove(self):
        """Take the overlay out of the view, for good."""
        index = self._root.findChild(self._top)
        if index >= 0:
            self._root.removeChild(index)

    def _placed(self, points):
        return [tuple(self._back.multVec(point)) for point in points]


def _face_style():
    offset, hints, depth = coin.SoPolygonOffset(), coin.SoShapeHints(), coin.SoDepthBuffer()
    depth.range = (0.0, _FACE_DEPTH)
    offset.factor = offset.units = _BETWEEN
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    return offset, hints, depth


def _part(colour, points, triangles):
    group, material = coin.SoSeparator(), coin.SoMaterial()
    material.diffuseColor = colour
    material.emissiveColor = [_GLOW * part for part in colour]
    coordinates, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    coordinates.point.setValues(0, len(points), points)
    indices = [index for triangle in triangles for index in (*triangle, -1)]
    faces.coordIndex.setValues(0, len(indices), indices)
    for node in (material, coordinates, faces):
        group.addChild(node)
    return group


def _lines(curves):
    light, depth, paint, style = coin.SoLightModel(), coin.SoDepthBuffer(), coin.SoBaseColor(), coin.SoDrawStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    depth.range = (0.0, _DEPTH)
    paint.rgb = _CURVE_COLOUR
    style.lineWidth = _CURVE_WIDTH
    points = [point for curve in curves for point in curve]
    coordinates, lines = coin.SoCoordinate3(), coin.SoLineSet()
    coordinates.point.setValues(0, len(points), points)
    lines.numVertices.setValues(0, len(curves), [len(curve) for curve in curves])
    return light, depth, paint, style, coordinates, lines
