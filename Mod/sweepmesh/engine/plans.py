"""What a sweep would do with a solid, without a mesh."""

import dataclasses
from typing import Dict, List, Tuple

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import as_model
from sweepmesh.engine.options import Options
from sweepmesh.engine.results import Assessment
from sweepmesh.engine.worker import run


@dataclasses.dataclass
class SweepPlan:
    """Verdict, vertex types and numbers of mesh edges; only the verdict where there is no way to sweep."""

    assessment: Assessment
    size: float
    """The element size that would be used."""
    n_layers: int
    corners: List[Tuple[str, str, str]]
    """("Face3", "Vertex7", "end"): how linking faces turn at their vertices: end, side, corner, reversal."""
    edge_roles: Dict[str, str]
    """{"Edge1": "axial" or "transverse"}; edges within a cap have no role."""
    intervals: Dict[str, int]
    """Mesh edges on each CAD edge: {"Edge1": 12, ...}."""
    levels: Dict[str, int]
    """The layer at which each vertex lies: {"Vertex1": 0, ...}."""

    @classmethod
    def from_core(cls, core):
        """From the C++ module's SweepPlan."""
        return cls(
            assessment=Assessment.from_core(core.assessment),
            size=core.size,
            n_layers=core.n_layers,
            corners=[(f"Face{c.face + 1}", f"Vertex{c.vertex + 1}", c.type.name) for c in core.corners],
            edge_roles={f"Edge{i + 1}": r.name for i, r in enumerate(core.edge_role) if r.name != "none"},
            intervals={f"Edge{i + 1}": n for i, n in enumerate(core.edge_intervals) if n > 0},
            levels={f"Vertex{i + 1}": k for i, k in enumerate(core.vertex_level) if k >= 0},
        )


def plan(shape, options=None, progress=None):
    """The scheme and the numbers that `mesh` would use, as a SweepPlan; takes and raises what `mesh` does."""
    options = options or Options()

    def work(context):
        model = as_model(shape)
        return _sweepmesh.plan(model, options.picks(model.n_faces), options.to_core(), context)

    return SweepPlan.from_core(run(work, options.threads, progress))
