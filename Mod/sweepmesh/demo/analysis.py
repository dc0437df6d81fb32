"""A small static analysis with FreeCAD's own FEM objects, solved by CalculiX."""

import numpy

from sweepmesh.engine.errors import SolverError

YOUNG, POISSON = "210000 MPa", "0.3"


def make_analysis(shape, fixed, loaded, force, along):
    """An analysis of steel: faces `fixed` are held, `force` (N) pulls the face `loaded` along an edge's direction.

    `along` is the name of a straight edge of `shape`, as FreeCAD's force constraint wants it.
    """
    import ObjectsFem

    document = shape.Document
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    material = ObjectsFem.makeMaterialSolid(document)
    material.Material = {"Name": "Steel", "YoungsModulus": YOUNG, "PoissonRatio": POISSON}
    fixture = ObjectsFem.makeConstraintFixed(document)
    fixture.References = [(shape, fixed)]
    load = ObjectsFem.makeConstraintForce(document)
    load.References = [(shape, loaded)]
    load.Force = force
    load.Direction = (shape, [along])
    for member in (ObjectsFem.makeSolverCalculixCcxTools(document), material, fixture, load):
        analysis.addObject(member)
    document.recompute()
    return analysis


def solve(analysis, folder):
    """Runs CalculiX in `folder`; returns displacements (n, 3) and von Mises stresses (n) in the nodes' order.

    FreeCAD's result object with both is in the analysis afterwards. Raises SolverError.
    """
    from femtools.ccxtools import FemToolsCcx

    solver = next(item for item in analysis.Group if item.isDerivedFrom("Fem::FemSolverObject"))
    tools = FemToolsCcx(analysis, solver, test_mode=False)
    tools.update_objects()
    tools.setup_working_dir(str(folder))
    tools.setup_ccx()
    problem = tools.check_prerequisites()
    if problem:
        raise SolverError(f"CalculiX cannot start: {problem}")
    tools.purge_results()
    tools.write_inp_file()
    tools.ccx_run()
    tools.load_results()
    results = [item for item in analysis.Group if item.isDerivedFrom("Fem::FemResultObject")]
    if not results or not results[0].DisplacementVectors:
        raise SolverError("CalculiX gave no results.")
    order = numpy.argsort(results[0].NodeNumbers)
    displacements = numpy.array([tuple(vector) for vector in results[0].DisplacementVectors])
    return displacements[order], numpy.array(results[0].vonMises)[order]
