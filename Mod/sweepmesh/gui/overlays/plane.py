"""A plane drawn through a shape."""
import FreeCAD
from pivy import coin

_COLOUR = (0.9, 0.1, 0.5)
_TRANSPARENCY = 0.6
_MARGIN = 0.55  # half of the square's side, as part of the shape's diagonal


class PlaneOverlay:
    """A translucent square in the node of a document object; it cannot be picked."""

    def __init__(self, obj, point, normal):
        self._root = obj.ViewObject.RootNode
        self._top, style = coin.SoSeparator(), coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        hints, material = coin.SoShapeHints(), coin.SoMaterial()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        material.diffuseColor = material.emissiveColor = _COLOUR
        material.transparency = _TRANSPARENCY
        coordinates, face = coin.SoCoordinate3(), coin.SoFaceSet()
        coordinates.point.setValues(0, 4, _corners(obj, FreeCAD.Vector(*point), FreeCAD.Vector(*normal)))
        for node in (style, hints, material, coordinates, face):
            self._top.addChild(node)
        self._root.addChild(self._top)

    def remove(self):
        """Take the overlay out of the view, for good."""
        index = self._root.findChild(self._top)
        if index >= 0:
            self._root.removeChild(index)


def _corners(obj, point, normal):
    box, back = obj.Shape.BoundBox, obj.Placement.inverse()
    middle = box.Center - normal * (box.Center - point).dot(normal)
    turn, half = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), normal), _MARGIN * box.DiagonalLength
    signs = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    return [tuple(back.multVec(middle + turn.multVec(FreeCAD.Vector(x * half, y * half, 0)))) for x, y in signs]
