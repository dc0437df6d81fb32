"""Assess and mesh solids: plain values in, plain values out (no FreeCAD, no Qt)."""

from sweepmesh.engine._sweepmesh import __version__
from sweepmesh.engine.cuts import Cut, suggest_cut
from sweepmesh.engine.errors import (
    Cancelled,
    ImprintError,
    InputError,
    InvalidMeshError,
    SolverError,
    SweepMeshError,
)
from sweepmesh.engine.imprints import Imprint, imprint
from sweepmesh.engine.face_types import FaceCorner, face_types
from sweepmesh.engine.model import Model, face_at, read
from sweepmesh.engine.options import Options
from sweepmesh.engine.plans import EdgeDirection, SweepPlan, VirtualCorner, plan
from sweepmesh.engine.progress import Progress
from sweepmesh.engine.results import Assessment, Reason, Result
from sweepmesh.engine.stages import assess, mesh
from sweepmesh.engine.windings import HoleWinding, hole_winding

__all__ = [
    "Assessment",
    "Cancelled",
    "Cut",
    "EdgeDirection",
    "FaceCorner",
    "HoleWinding",
    "Imprint",
    "ImprintError",
    "InputError",
    "InvalidMeshError",
    "Model",
    "Options",
    "Progress",
    "Reason",
    "Result",
    "SolverError",
    "SweepMeshError",
    "SweepPlan",
    "VirtualCorner",
    "__version__",
    "assess",
    "face_at",
    "face_types",
    "hole_winding",
    "imprint",
    "mesh",
    "plan",
    "read",
    "suggest_cut",
]
