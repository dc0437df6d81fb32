"""What a run returns: plain values and numpy arrays."""

import dataclasses
from typing import Dict, List

import numpy

VERTEX, EDGE, FACE, INSIDE = range(4)
"""Values of `Result.owner_kind`."""


@dataclasses.dataclass
class Reason:
    """Why a solid cannot be swept."""

    kind: str
    """"topological", "geometric", "prescribed" or "unsupported"."""
    text: str
    """A whole sentence."""
    entities: List[str]
    """The faces, edges and vertices at fault, by FreeCAD's names."""


@dataclasses.dataclass
class Assessment:
    """Whether a solid can be swept, and how."""

    verdict: str
    """"sweepable" or "unsweepable"."""
    reasons: List[Reason]
    """Why not; empty for a sweepable solid."""
    schemes: List[Dict[str, str]]
    """The ways to sweep it, best first: {"Face1": "source", ...}."""

    @property
    def is_sweepable(self):
        """True where at least one scheme was found."""
        return self.verdict == "sweepable"

    @property
    def roles(self):
        """The best scheme; empty for a solid that cannot be swept."""
        return self.schemes[0] if self.schemes else {}

    @classmethod
    def from_core(cls, core):
        """From the C++ module's Assessment."""
        return cls(
            verdict="sweepable" if core.is_sweepable() else "unsweepable",
            reasons=[Reason(r.kind.name, r.text, list(r.entities)) for r in core.reasons],
            schemes=[_roles(scheme) for scheme in core.schemes],
        )


@dataclasses.dataclass
class Result:
    """A mesh and what there is to say about it. An unsweepable solid gives one without elements."""

    assessment: Assessment
    points: numpy.ndarray
    """(n, 3) float64."""
    hexahedra: numpy.ndarray
    """(m, 8) int32, in VTK's order of nodes; (m, 20) for second order."""
    prisms: numpy.ndarray
    """(m, 6) int32, first ring counterclockwise seen from the second (Abaqus' order); (m, 15) for second order."""
    polyhedron_offsets: numpy.ndarray
    """Polyhedron i, a prism over a polygon of five corners or more, has the nodes
    polyhedron_nodes[polyhedron_offsets[i]:polyhedron_offsets[i + 1]]."""
    polyhedron_nodes: numpy.ndarray
    """int32, of each its first ring, counterclockwise seen from the second, and then the second."""
    boundary_offsets: numpy.ndarray
    """Polygon i of the boundary has the nodes boundary_nodes[boundary_offsets[i]:boundary_offsets[i + 1]]."""
    boundary_nodes: numpy.ndarray
    """int32, counterclockwise seen from outside; for second order the mid-side nodes follow the corners."""
    boundary_faces: numpy.ndarray
    """int32, per polygon: the number of its CAD face, 7 for Face7."""
    owner_kind: numpy.ndarray
    """int8, per node: on what it lies, VERTEX, EDGE, FACE or INSIDE."""
    owner_number: numpy.ndarray
    """int32, per node: the number of that vertex, edge or face, from 1; 0 inside."""
    quality: dict
    """min_scaled_jacobian, mean_scaled_jacobian, n_inverted, histogram (counts of 20 bins from -1 to 1)."""
    scaled_jacobians: numpy.ndarray
    """float64, per element: hexahedra, then prisms, then polyhedra."""
    seconds: Dict[str, float]
    """Time of each stage."""
    size: float
    """The element size that was used."""
    intervals: Dict[str, int]
    """Mesh edges on each CAD edge: {"Edge1": 12, ...}."""
    n_layers: int
    area_deviation: Dict[str, float]
    """By which part of a CAD face's area the mesh misses it, above 0 where it has more: {"Face1": -0.02, ...}. Beyond
    0.1 either way there is a warning."""
    warnings: List[str]

    @property
    def n_elements(self):
        """Volume elements of all kinds."""
        return len(self.hexahedra) + len(self.prisms) + self.n_polyhedra

    @property
    def n_polyhedra(self):
        """Elements over polygons of five corners or more."""
        return len(self.polyhedron_offsets) - 1

    def polyhedra_by_corners(self):
        """[(which polyhedra, their nodes as (m, 2 n))] for each number n of corners that there is, the fewest first."""
        starts, sizes = self.polyhedron_offsets[:-1], numpy.diff(self.polyhedron_offsets)
        groups = [(size, numpy.flatnonzero(sizes == size)) for size in numpy.unique(sizes)]
        return [(its, self.polyhedron_nodes[starts[its, None] + numpy.arange(size)]) for size, its in groups]

    @property
    def order(self):
        """2 where there are mid-side nodes, else 1."""
        return 2 if self.hexahedra.shape[1] == 20 or self.prisms.shape[1] == 15 else 1

    def boundary_sizes(self):
        """Corners of each polygon of the boundary, mid-side nodes not counted."""
        return numpy.diff(self.boundary_offsets) // self.order

    @classmethod
    def from_core(cls, core, scaled_jacobians):
        """From the C++ module's SweepResult; large arrays are views of its memory."""
        inside = core.owner_index < 0
        offsets, nodes = _boundary(core)
        return cls(
            assessment=Assessment.from_core(core.assessment),
            points=core.points,
            hexahedra=_with_mid_nodes(core.hexahedra, core.hexahedron_mid_nodes),
            prisms=_with_mid_nodes(core.prisms, core.prism_mid_nodes),
            polyhedron_offsets=core.polyhedron_offset,
            polyhedron_nodes=core.polyhedron_nodes,
            boundary_offsets=offsets,
            boundary_nodes=nodes,
            boundary_faces=core.boundary_face + 1,
            owner_kind=numpy.where(inside, INSIDE, core.owner_kind).astype(numpy.int8),
            owner_number=numpy.where(inside, 0, core.owner_index + 1).astype(numpy.int32),
            quality=_quality(core.quality),
            scaled_jacobians=scaled_jacobians,
            seconds=dict(core.seconds),
            size=core.size,
            intervals={f"Edge{i + 1}": n for i, n in enumerate(core.edge_intervals) if n > 0},
            n_layers=core.n_layers,
            area_deviation={f"Face{face + 1}": deviation for face, deviation in core.area_deviation.items()},
            warnings=list(core.warnings),
        )


def _roles(scheme):
    return {f"Face{i + 1}": role.name for i, role in enumerate(scheme.face_role) if role.name != "none"}


def _with_mid_nodes(corners, mid_nodes):
    return numpy.hstack([corners, mid_nodes]) if len(mid_nodes) else corners


def _boundary(core):
    """Offsets and nodes of the boundary's polygons; mid-side nodes, where there are any, follow the corners."""
    offsets, corners, mid_nodes = core.boundary_offset, core.boundary_nodes, core.boundary_mid_nodes
    if not len(mid_nodes):
        return offsets, corners
    sizes = numpy.repeat(numpy.diff(offsets), numpy.diff(offsets))
    places = numpy.arange(len(corners)) + numpy.repeat(offsets[:-1], numpy.diff(offsets))
    nodes = numpy.empty(2 * len(corners), corners.dtype)
    nodes[places], nodes[places + sizes] = corners, mid_nodes
    return 2 * offsets, nodes


def _quality(report):
    return {
        "min_scaled_jacobian": report.scaled_jacobian.min,
        "mean_scaled_jacobian": report.scaled_jacobian.mean,
        "n_inverted": report.n_inverted,
        "histogram": list(report.histogram),
    }
