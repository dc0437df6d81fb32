"""A static analysis with FreeCAD's own FEM objects and CalculiX, for whatever mesh object it is given."""
import math

import FreeCAD
import ObjectsFem
from femmesh import gmshtools
from femtools.ccxtools import FemToolsCcx

YOUNG, POISSON = 210000.0, 0.3  # MPa
SHEAR = YOUNG / (2 * (1 + POISSON))


def make_analysis(shape, fixed, loaded, force, axis):
    """An analysis of `shape` with faces `fixed`, and `force` (N) on the face `loaded` along the vector `axis`."""
    doc = shape.Document
    analysis = ObjectsFem.makeAnalysis(doc, "Analysis")
    analysis.addObject(ObjectsFem.makeSolverCalculixCcxTools(doc))
    material = ObjectsFem.makeMaterialSolid(doc)
    material.Material = {"Name": "Steel", "YoungsModulus": f"{YOUNG} MPa", "PoissonRatio": str(POISSON)}
    fixture = ObjectsFem.makeConstraintFixed(doc)
    fixture.References = [(shape, fixed)]
    load = ObjectsFem.makeConstraintForce(doc)
    load.References = [(shape, loaded)]
    load.Force = force
    load.Direction = (_line_along(doc, axis), ["Edge1"])
    for member in (material, fixture, load):
        analysis.addObject(member)
    doc.recompute()
    return analysis


def _line_along(doc, axis):
    line = doc.addObject("Part::Line", "Direction")
    line.X2, line.Y2, line.Z2 = axis
    return line


def add_tetrahedra(analysis, shape, size):
    """Put FreeCAD's own Gmsh mesh into the analysis: tetrahedra of second order."""
    mesh = ObjectsFem.makeMeshGmsh(shape.Document)
    mesh.Part = shape
    mesh.CharacteristicLengthMax = size
    mesh.ElementOrder = "2nd"
    mesh.HighOrderOptimize = "Optimization"
    messages = gmshtools.GmshTools(mesh).create_mesh()
    assert mesh.FemMesh.TetraCount, messages
    analysis.addObject(mesh)
    return mesh


def solve(analysis, folder):
    """Run CalculiX and return FreeCAD's result object."""
    solver = next(m for m in analysis.Group if m.isDerivedFrom("Fem::FemSolverObject"))
    tools = FemToolsCcx(analysis, solver, test_mode=False)
    tools.update_objects()
    folder.mkdir(exist_ok=True)
    tools.setup_working_dir(str(folder))
    tools.setup_ccx()
    problem = tools.check_prerequisites()
    assert not problem, problem
    tools.purge_results()
    tools.write_inp_file()
    assert tools.ccx_run() == 0
    tools.load_results()
    result = next(m for m in analysis.Group if m.isDerivedFrom("Fem::FemResultObject"))
    assert len(result.DisplacementVectors) == len(result.NodeNumbers) > 0
    return result


def mean_displacement(result, fem_mesh, face):
    """Mean displacement of the nodes on `face`."""
    on_face = set(fem_mesh.getNodesByFace(face))
    vectors = [v for n, v in zip(result.NodeNumbers, result.DisplacementVectors) if n in on_face]
    assert len(vectors) == len(on_face)
    total = FreeCAD.Vector()
    for vector in vectors:
        total += vector
    return total / len(vectors)


def ring_inertia(outer, inner):
    return math.pi / 4 * (outer**4 - inner**4)
