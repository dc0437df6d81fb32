"""Solids that touch have one mesh: nodes of a common face are there once, its quads lie between two hexahedra."""

import pytest
import touching
from gallery import find_judge
from touching import MIXED, STACKS, box, expect_one_mesh, fragments, rod, vec

from sweepmesh import Options, engine, mesh, write
from sweepmesh.freecad import import_freecad

import_freecad()
import Part  # noqa: E402

JUDGE = find_judge()
ALL = {**STACKS, **MIXED}


def apart(shape):
    """The same solids, each with faces of its own: as they come from modelling one after the other."""
    return Part.Compound([solid.copy() for solid in shape.Solids])


def meshed(shape, **options):
    """(Model, Result) of all solids."""
    model = engine.Model.from_brep(shape.exportBrepToString(), 0)
    return model, mesh(model, Options(**options))


def expect_judged(result, shape, folder):
    """The independent checker finds no fault."""
    if JUDGE is None:
        return
    shape.exportBrep(str(folder / "shape.brep"))
    write(result, folder / "mesh.vtu")
    assert JUDGE(str(folder / "mesh.vtu"), str(folder / "shape.brep"))["failures"] == []


@pytest.mark.parametrize("name", ALL)
def test_fragments_have_one_mesh(name, tmp_path):
    shape = ALL[name]()
    model, result = meshed(shape, size=(shape.Volume / 1500) ** (1 / 3))
    expect_one_mesh(result, model, shape)
    expect_judged(result, shape, tmp_path)


@pytest.mark.parametrize("name", ALL)
def test_solids_of_their_own_have_one_mesh_where_faces_coincide(name, tmp_path):
    shape = apart(ALL[name]())
    shared, coincident = touching.contact_faces(shape)
    assert coincident and not shared
    model, result = meshed(shape, size=(shape.Volume / 1500) ** (1 / 3))
    expect_one_mesh(result, model, shape)
    expect_judged(result, shape, tmp_path)
