"""SweepMesh: swept hexahedral meshes of CAD solids.

    import sweepmesh
    options = sweepmesh.Options(size=2.5, sources=[2], targets=[1])
    result = sweepmesh.mesh(shape.exportBrepToString(), options)
    print(len(result.hexahedra), result.quality["min_scaled_jacobian"])
    sweepmesh.write(result, "part.vtu")

`sweepmesh.engine` needs neither FreeCAD nor Qt; `sweepmesh.app` makes FEM objects of FreeCAD's documents;
`sweepmesh.gui` is the workbench.
"""

from sweepmesh.engine import (
    Assessment,
    Cancelled,
    Cut,
    ImprintError,
    InputError,
    InvalidMeshError,
    Model,
    Options,
    Progress,
    Reason,
    Result,
    SolverError,
    SweepMeshError,
    __version__,
    assess,
    face_at,
    mesh,
    read,
    suggest_cut,
)
from sweepmesh.output import write

__all__ = [
    "Assessment",
    "Cancelled",
    "Cut",
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
    "__version__",
    "assess",
    "face_at",
    "mesh",
    "read",
    "suggest_cut",
    "write",
]
