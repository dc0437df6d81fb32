"""What a sweep would do with a solid, without a mesh."""

import dataclasses
from typing import Dict, List, Optional, Tuple

import numpy

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import as_model, chosen_solids
from sweepmesh.engine.options import Options
from sweepmesh.engine.results import Assessment, Reason
from sweepmesh.engine.worker import run


@dataclasses.dataclass
class VirtualCorner:
    """A place in the middle of a rounded edge where the grid of a linking face turns."""

    face: str
    edge: str
    type: str
    """"end", "side", "corner" or "reversal"."""
    point: Tuple[float, float, float]


@dataclasses.dataclass
class EdgeDirection:
    """How an edge, or a piece of a divided one, lies in the grid of a linking face."""

    face: str
    edge: Optional[str]
    """None for a line across a divided face, where no edge is."""
    axis: str
    """"k" along the sweep, "i" across it."""
    sign: int
    """1 where i or k grows in the direction of the edge, -1 where it grows against it."""
    start: Tuple[float, float, float]
    end: Tuple[float, float, float]
    """The ends of the edge or piece; i or k grows from `start` to `end`."""
    intervals: int

    @classmethod
    def from_core(cls, core):
        """From the C++ module's EdgeDirection, whose start and end are those of the face's loop."""
        way, axis = core.direction.name.split("_")
        grows = way == "plus"
        start, end = (tuple(map(float, point)) for point in (core.start, core.end))
        return cls(
            face=f"Face{core.face + 1}",
            edge=f"Edge{core.edge + 1}" if core.edge >= 0 else None,
            axis=axis,
            sign=1 if grows != core.reversed else -1,
            start=start if grows else end,
            end=end if grows else start,
            intervals=core.n_intervals,
        )


@dataclasses.dataclass
class SweepPlan:
    """Verdict, vertex types and numbers of mesh edges; only the verdict where there is no way to sweep."""

    assessment: Assessment
    size: float
    """The element size that would be used."""
    n_layers: int
    corners: List[Tuple[str, str, str]]
    """("Face3", "Vertex7", "end"): how linking faces turn at their vertices: end, side, corner, reversal."""
    virtual_corners: List[VirtualCorner]
    """The same at places that are no vertices, on edges that are divided."""
    directions: List[EdgeDirection]
    """Of every side of every linking face, by face and along its loops."""
    edge_roles: Dict[str, str]
    """{"Edge1": "axial", "transverse" or, where its pieces differ, "divided"}; edges within a cap have no role."""
    intervals: Dict[str, int]
    """Mesh edges on each CAD edge: {"Edge1": 12, ...}."""
    levels: Dict[str, int]
    """The layer at which each vertex lies: {"Vertex1": 0, ...}."""
    edge_nodes: Dict[str, numpy.ndarray]
    """Points (n + 1, 3) of the nodes on each CAD edge, from its start to its end."""

    @classmethod
    def from_core(cls, core):
        """From the C++ module's SweepPlan."""
        return cls(
            assessment=Assessment.from_core(core.assessment),
            size=core.size,
            n_layers=core.n_layers,
            corners=[
                (f"Face{c.face + 1}", f"Vertex{c.vertex + 1}", c.type.name) for c in core.corners if c.vertex >= 0
            ],
            virtual_corners=[
                VirtualCorner(f"Face{c.face + 1}", f"Edge{c.edge + 1}", c.type.name, tuple(map(float, c.point)))
                for c in core.corners
                if c.vertex < 0
            ],
            directions=[EdgeDirection.from_core(d) for d in core.directions],
            edge_roles={f"Edge{i + 1}": r.name for i, r in enumerate(core.edge_role) if r.name != "none"},
            intervals={f"Edge{i + 1}": n for i, n in enumerate(core.edge_intervals) if n > 0},
            levels={f"Vertex{i + 1}": k for i, k in enumerate(core.vertex_level) if k >= 0},
            edge_nodes={f"Edge{i + 1}": points for i, points in enumerate(core.edge_nodes) if len(points)},
        )


def plan(shape, options=None, progress=None):
    """The scheme and the numbers that `mesh` would use, as a SweepPlan; takes and raises what `mesh` does."""
    options = options or Options()

    def work(context):
        solids = chosen_solids(as_model(shape), options.solid)
        plans = _plans_of(solids, options, context)
        if options.size is None and len(solids) > 1:
            smallest = min(each.size for each in plans)
            plans = _plans_of(solids, dataclasses.replace(options, size=smallest), context)
        return plans

    plans = run(work, options.threads, progress)
    return plans[0] if len(plans) == 1 else _merged(plans)


def _plans_of(solids, options, context):
    core = options.to_core()
    picks = [options.picks(solid) if len(solids) == 1 else _picks_on(solid, options) for solid in solids]
    return [SweepPlan.from_core(_sweepmesh.plan(s, p, core, context)) for s, p in zip(solids, picks)]


def _picks_on(solid, options):
    """The picks on faces of this solid; the others are those of other solids."""
    own = {index + 1 for index in solid.faces}
    mine = dataclasses.replace(
        options,
        sources=[face for face in options.sources if face in own],
        targets=[face for face in options.targets if face in own],
        pairs=[pair for pair in options.pairs if set(pair) <= own],
        vertex_types=[triple for triple in options.type_triples() if triple[0] in own],
    )
    return mine.picks(solid)


def _merged(plans):
    """One plan for several solids: sweepable if all are."""
    reasons = [
        Reason(reason.kind, f"Solid {number}: {reason.text}", reason.entities)
        for number, each in enumerate(plans, 1)
        for reason in each.assessment.reasons
    ]
    if reasons:
        return SweepPlan(Assessment("unsweepable", reasons, []), plans[0].size, 0, [], [], [], {}, {}, {}, {})
    return SweepPlan(
        assessment=Assessment("sweepable", [], [_joined(each.assessment.roles for each in plans)]),
        size=plans[0].size,
        n_layers=max(each.n_layers for each in plans),
        corners=[corner for each in plans for corner in each.corners],
        virtual_corners=[corner for each in plans for corner in each.virtual_corners],
        directions=[direction for each in plans for direction in each.directions],
        edge_roles=_joined(each.edge_roles for each in plans),
        intervals=_joined(each.intervals for each in plans),
        levels=_joined(each.levels for each in plans),
        edge_nodes=_joined(each.edge_nodes for each in plans),
    )


def _joined(parts):
    return {name: value for part in parts for name, value in part.items()}
