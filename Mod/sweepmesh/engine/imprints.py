"""How the caps of a sweep are divided: imprinted curves and paired parts as shapes, without a mesh."""

import dataclasses
from typing import List, Tuple

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import as_model, chosen_solids
from sweepmesh.engine.options import Options
from sweepmesh.engine.results import Assessment
from sweepmesh.engine.worker import run


@dataclasses.dataclass
class CapPart:
    """A part of a source or a target; the two parts of one pair are swept from one to the other."""

    cap: str
    """"Face7": the face that it is a part of."""
    role: str
    """"source" or "target"."""
    pair: int
    """From 1."""


@dataclasses.dataclass
class Imprint:
    """The caps of a shape divided by each other's edges; nothing but the verdict where there is no way to sweep."""

    assessment: Assessment
    size: float
    """The element size that would be used: curves nearer than a part of it are brought together."""
    n_pairs: int
    parts: List[CapPart]
    """What each face of `caps` is, in their order. A part that crosses a seam of its face is there twice."""
    caps: str
    """BREP text: a compound of the caps' parts, one face each, their normals out of the solid."""
    curve_caps: List[str]
    """On which face each of `curves` lies."""
    curves: str
    """BREP text: a compound of the imprinted curves, one wire each; edges of the faces themselves are none."""
    merges: List[Tuple[str, str, float]]
    """("Edge3", "Edge7", 0.2): near edges that are taken as one, and how far apart they are at most."""

    @classmethod
    def from_core(cls, core):
        """From the C++ module's ImprintShapes."""
        return cls(
            assessment=Assessment.from_core(core.assessment),
            size=core.size,
            n_pairs=core.n_pairs,
            parts=[CapPart(f"Face{p.cap + 1}", "source" if p.is_source else "target", p.pair + 1) for p in core.parts],
            caps=core.caps,
            curve_caps=[f"Face{face + 1}" for face in core.curve_on],
            curves=core.curves,
            merges=[(f"Edge{m.kept + 1}", f"Edge{m.merged + 1}", m.distance) for m in core.merges],
        )


def imprint(shape, options=None, progress=None):
    """The Imprint that `mesh` would use, for a solid or for all of a shape; takes and raises what `mesh` does."""
    options = options or Options()

    def work(context):
        solids = chosen_solids(as_model(shape), options.solid)
        return _sweepmesh.imprint(solids, options.picks(solids[0]), options.to_core(), context)

    return Imprint.from_core(run(work, options.threads, progress))
