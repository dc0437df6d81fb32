"""Swept hexahedral meshes for FreeCAD's Python: no window needed.

    import FreeCAD, Part
    from sweepmesh import app as sweepmesh

    solid = Part.read("bent_pipe.step")
    print(sweepmesh.assess(solid).verdict)
    result = sweepmesh.mesh(solid, size=2.0)
    fem_mesh = sweepmesh.to_femmesh(result)

docs/macros.md shows more.
"""
from sweepmesh.app.femmesh import to_femmesh
from sweepmesh.app.imprints import Imprint, imprint
from sweepmesh.app.make import make_cut, make_imprint, make_sweep_mesh, update_sweep_mesh
from sweepmesh.app.stages import Plan, assess, mesh, plan

__all__ = [
    "Imprint",
    "Plan",
    "assess",
    "imprint",
    "make_cut",
    "make_imprint",
    "make_sweep_mesh",
    "mesh",
    "plan",
    "to_femmesh",
    "update_sweep_mesh",
]
