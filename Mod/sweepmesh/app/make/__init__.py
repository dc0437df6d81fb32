"""Functions that make document objects."""
from sweepmesh.app.make.make_cut import make_cut
from sweepmesh.app.make.make_imprint import make_imprint
from sweepmesh.app.make.make_sweep import make_sweep_mesh, update_sweep_mesh

__all__ = ["make_cut", "make_imprint", "make_sweep_mesh", "update_sweep_mesh"]
