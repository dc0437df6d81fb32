"""Some elements of a mesh drawn in place, coloured by quality."""
import numpy as np
from pivy import coin

# Faces are drawn without light: a colour means a number.
_EDGE_COLOUR = (0.1, 0.1, 0.1)
_STOPS = np.array([0.0, 0.25, 0.5, 1.0])
_COLOURS = np.array([(0.85, 0.0, 0.0), (1.0, 0.6, 0.0), (1.0, 0.95, 0.3), (0.25, 0.65, 0.95)])
_INVERTED = (0.75, 0.0, 0.75)


def colours_of(quality):
    """Return (n, 3) colours of scaled Jacobians: red at 0 over yellow to blue at 1, violet where inverted."""
    quality = np.asarray(quality, dtype=float)
    colours = np.stack([np.interp(quality, _STOPS, _COLOURS[:, channel]) for channel in range(3)], axis=-1)
    colours[quality <= 0] = _INVERTED
    return colours


class ElementOverlay:
    """Quads with a colour each, and their edges, in the node of a document object; not pickable."""

    def __init__(self, obj):
        self._root = obj.ViewObject.RootNode
        self._separator = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self._separator.addChild(style)
        self._root.addChild(self._separator)

    def show(self, points, quads, colours):
        """Draw quads (m, 4) of `points`, each in its colour (m, 3). A triangle repeats its last node."""
        self.clear()
        if len(quads):
            used, quads = np.unique(quads, return_inverse=True)
            quads = quads.reshape(-1, 4)
            coordinates = coin.SoCoordinate3()
            coordinates.point.setValues(0, len(used), points[used].tolist())
            group = coin.SoSeparator()
            for node in (coordinates, _faces(quads, colours), _edges(quads)):
                group.addChild(node)
            self._separator.addChild(group)

    def clear(self):
        while self._separator.getNumChildren() > 1:
            self._separator.removeChild(1)

    def remove(self):
        """Take the overlay out of the view, for good."""
        index = self._root.findChild(self._separator)
        if index >= 0:
            self._root.removeChild(index)


def _faces(quads, colours):
    group = coin.SoSeparator()
    offset = coin.SoPolygonOffset()
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    light, material, binding = coin.SoLightModel(), coin.SoMaterial(), coin.SoMaterialBinding()
    light.model = coin.SoLightModel.BASE_COLOR
    material.diffuseColor.setValues(0, len(colours), np.asarray(colours).tolist())
    binding.value = coin.SoMaterialBinding.PER_FACE
    indices = np.insert(quads, 4, -1, axis=1).ravel().tolist()
    faces = coin.SoIndexedFaceSet()
    faces.coordIndex.setValues(0, len(indices), indices)
    for node in (offset, hints, light, material, binding, faces):
        group.addChild(node)
    return group


def _edges(quads):
    group = coin.SoSeparator()
    colour, light = coin.SoBaseColor(), coin.SoLightModel()
    colour.rgb = _EDGE_COLOUR
    light.model = coin.SoLightModel.BASE_COLOR
    indices = np.concatenate([quads, quads[:, :1], np.full((len(quads), 1), -1)], axis=1).ravel().tolist()
    lines = coin.SoIndexedLineSet()
    lines.coordIndex.setValues(0, len(indices), indices)
    for node in (light, colour, lines):
        group.addChild(node)
    return group
