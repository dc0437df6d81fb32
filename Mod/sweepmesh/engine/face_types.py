"""The vertex types that any face would have as a structured grid by itself, apart from any sweep."""

import dataclasses
import math
from typing import Optional, Tuple

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import as_model
from sweepmesh.engine.names import face_number
from sweepmesh.engine.options import Options
from sweepmesh.engine.worker import run


@dataclasses.dataclass
class FaceCorner:
    """A vertex of a face, or a virtual one in the middle of a round or a chamfer."""

    loop: int
    """0 for the outer loop."""
    vertex: Optional[str]
    """None for a virtual one."""
    edge: Optional[str]
    """Of a virtual one: where it lies."""
    point: Tuple[float, float, float]
    angle: float
    """Interior angle in degrees; of a virtual one that of the corner which it stands for."""
    nearest: str
    """The type that the angle alone suggests."""
    type: str
    """"end", "side", "corner" or "reversal"."""

    @classmethod
    def from_core(cls, core):
        """From the C++ module's TypedCorner."""
        return cls(
            loop=core.loop,
            vertex=f"Vertex{core.vertex + 1}" if core.vertex >= 0 else None,
            edge=f"Edge{core.edge + 1}" if core.edge >= 0 else None,
            point=tuple(map(float, core.point)),
            angle=math.degrees(core.angle),
            nearest=core.nearest.name,
            type=core.type.name,
        )


def face_types(shape, face, vertex_types=(), templates=True, older_model=False):
    """[FaceCorner] along the loops of a face of BREP text or a Model; `face` is a name or a number.

    `vertex_types` as in Options. `templates` False: only the vertices that there are. `older_model` solves
    Ruiz-Girones' program, for comparison. Raises InputError where there are no types that close the grid; the
    sentence names the vertices whose given types contradict each other.
    """
    model = as_model(shape)
    number = face_number(face)
    picks = Options(sources=[number], vertex_types=vertex_types).picks(model)  # checks the face, too
    kind = _sweepmesh.TypeModel.ruiz_girones if older_model else _sweepmesh.TypeModel.fewest_changes
    corners = run(lambda context: _sweepmesh.face_types(model, number - 1, picks, kind, templates, context))
    return [FaceCorner.from_core(corner) for corner in corners]
