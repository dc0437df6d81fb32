"""How far the holes of a sweep wind: what folding is predicted from."""

import dataclasses
import math
from typing import List

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import as_model, chosen_solids
from sweepmesh.engine.options import Options
from sweepmesh.engine.worker import run


@dataclasses.dataclass
class HoleWinding:
    """The hole, or the pair of holes, that turns the most on its way from cap to cap."""

    degrees: float
    """Whole turns counted; 0 where there is none, or nothing can be said. Beyond 180 no mesh is possible."""
    faces: List[str]
    """Its linking faces."""


def hole_winding(shape, options=None, progress=None):
    """HoleWinding of the best scheme of a solid (options.solid, else the first), be it refused for that or not.

    No mesh of a cap or of the volume is made. Raises InputError for a shape or an option that cannot be used.
    """
    options = options or Options()

    def work(context):
        solid = chosen_solids(as_model(shape), options.solid)[0]
        return _sweepmesh.winding(solid, options.picks(solid), context)

    core = run(work, options.threads, progress)
    return HoleWinding(math.degrees(core.angle), [f"Face{face + 1}" for face in core.faces])
