"""One plane that divides a solid that cannot be swept into pieces that can."""

import dataclasses
from typing import List, Optional, Tuple

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import Model, as_model, chosen_solids
from sweepmesh.engine.options import Options
from sweepmesh.engine.worker import run

_NO_PICKS = _sweepmesh.Picks(sources=[], targets=[], pairs=[], types=[])


@dataclasses.dataclass
class Cut:
    """A plane and what it leaves of the solid."""

    point: Tuple[float, float, float]
    """A point of the plane."""
    normal: Tuple[float, float, float]
    """Its unit normal."""
    face: Optional[int]
    """The plane face that it extends, 7 for Face7; None where it extends none."""
    text: str
    """A sentence for people: where to cut."""
    shape: str
    """BREP text of a compound of the pieces (`Part.Shape.importBrepFromString`)."""
    pieces: List[Model]
    """The pieces, each of which can be swept; they can be given wherever BREP text can."""
    is_tried: bool
    """Whether the pieces have been meshed for a trial; False where time did not allow it."""

    def as_report(self):
        """Plain numbers and names, as the JSON report has them."""
        return {
            "point": list(self.point),
            "normal": list(self.normal),
            "face": f"Face{self.face}" if self.face else None,
            "pieces": len(self.pieces),
            "tried": self.is_tried,
            "text": self.text,
        }

    @classmethod
    def from_core(cls, core):
        """From the C++ module's SuggestedCut."""
        return cls(
            point=tuple(float(x) for x in core.point),
            normal=tuple(float(x) for x in core.normal),
            face=core.face + 1 if core.face >= 0 else None,
            text=core.text,
            shape=core.shape,
            pieces=core.pieces,
            is_tried=core.is_tried,
        )


def suggest_cut(shape, options=None, progress=None):
    """The best plane found that cuts the shape's first unsweepable solid into pieces that can all be swept.

    `shape` is BREP text or a Model; of the options `solid` and `threads` count. Every plane that comes into question
    is tried: the solid is cut and its pieces are assessed, for five seconds at most, and the best of them are meshed,
    for twenty. None where no plane helps, or where every solid can be swept as it is.
    """
    options = options or Options()

    def work(context):
        for solid in chosen_solids(as_model(shape), options.solid):
            found = _sweepmesh.assess([solid], _NO_PICKS, context)
            if not found.is_sweepable():
                return _sweepmesh.suggest_cut(solid, found.reasons, context)
        return None

    core = run(work, options.threads, progress)
    return Cut.from_core(core) if core else None
