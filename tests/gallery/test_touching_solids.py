"""Solids that touch have one mesh: nodes of a common face are there once, its quads lie between two hexahedra."""

import os

import pytest
import sweepmesh
import touching
from checker import expect_positive
from gallery import find_judge
from rate_of_fragments import table
from test_hand_made import crank
from touching import MIXED, STACKS, box, expect_glued, expect_one_mesh, fragments, rod, vec

from sweepmesh import Options, engine, mesh, write
from sweepmesh.freecad import import_freecad

import_freecad()
import Part  # noqa: E402

JUDGE = find_judge()
COUNT = int(os.environ.get("SWEEPMESH_FRAGMENTS", "5"))
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


@pytest.mark.parametrize("name", ["pin in a plate", "tower", "rod on its side"])
def test_mid_side_nodes_are_common_too(name, tmp_path):
    shape = ALL[name]()
    model, result = meshed(shape, size=(shape.Volume / 600) ** (1 / 3), order=2)
    assert result.hexahedra.shape[1] == 20
    expect_one_mesh(result, model, shape)
    expect_judged(result, shape, tmp_path)


@pytest.mark.parametrize("name", ["L cut across", "rod in three", "rod on a block", "boxes on both sides"])
def test_prisms_have_one_mesh_where_faces_are_both_caps_or_both_linking(name, tmp_path):
    shape = ALL[name]()
    model, result = meshed(shape, size=(shape.Volume / 600) ** (1 / 3), element="prism")
    assert len(result.prisms) and not len(result.hexahedra)
    expect_one_mesh(result, model, shape)
    expect_judged(result, shape, tmp_path)


def test_triangles_do_not_meet_a_grid_and_this_is_said():
    """One box is swept upwards, the other towards it: its end is of triangles, the side of the first is a grid."""
    shape = MIXED["tee of boxes"]()
    along = next(n for n, face in enumerate(shape.Faces, 1) if face.BoundBox.YMin > 39.9)
    up = next(n for n, face in enumerate(shape.Faces, 1) if face.BoundBox.ZMin > 9.9 and face.BoundBox.YMax < 10.1)
    model, result = meshed(shape, size=3, element="prism", sources=[up, along])
    assert result.n_elements and len(result.warnings) == 1
    (number,) = touching.contact_faces(shape)[0]
    assert f"Face{number}, between solids 1 and 2," in result.warnings[0]
    assert "share no nodes there" in result.warnings[0]


def test_a_cap_that_both_sides_divide_stays_open_and_this_is_said():
    """The cut lies between a pin above and one below: the upper one's circle is imprinted on one side of the cut, the
    lower one's on the other."""
    whole = box(0, 40, 0, 30, 0, 10).fuse(rod(6, vec(14, 15, 10), 8)).fuse(rod(6, vec(22, 15, -8), 8))
    shape = touching.cut_by(whole, ((0, 0, 5), (0, 0, 1)))
    model, result = meshed(shape, size=3)
    (number,) = touching.contact_faces(shape)[0]
    assert len(result.warnings) == 1
    assert f"Face{number}, between solids 1 and 2," in result.warnings[0]
    assert "divides it" in result.warnings[0] and "share no nodes there" in result.warnings[0]
    expect_positive(result)


def test_a_cut_that_is_suggested_leaves_pieces_that_have_one_mesh(tmp_path):
    whole = rod(25, vec(0, 0, -10), 10).fuse(touching.half_ring(12, 3))
    cut = sweepmesh.suggest_cut(whole.exportBrepToString())
    shape = Part.Shape()
    shape.importBrepFromString(cut.shape)
    model, result = meshed(shape, size=2.5)
    expect_one_mesh(result, model, shape)
    expect_judged(result, shape, tmp_path)


@pytest.mark.parametrize("name", ["pin in a plate", "rod on a block", "tower"])
def test_the_same_mesh_comes_out_on_every_run(name):
    shape = ALL[name]()
    one, two = (meshed(shape, size=(shape.Volume / 800) ** (1 / 3), threads=n)[1] for n in (1, 2))
    assert (one.points == two.points).all() and (one.hexahedra == two.hexahedra).all()


def test_pieces_cut_by_hand_have_one_mesh():
    """The prisms into which a terraced solid is cut by hand, modelled one by one."""
    terraces = crank()
    pieces = Part.Compound(terraces.pieces())
    model, result = meshed(pieces, size=2.5)
    expect_glued(result, model, pieces, *touching.contact_faces(pieces))
    assert result.quality["n_inverted"] == 0


@pytest.mark.parametrize("family, least", [("prisms", 0.9), ("terraces", 0.4)])
def test_most_random_fragments_have_one_mesh_and_the_others_say_why(family, least):
    outcomes = table(family, range(COUNT))
    assert sum(outcome.is_one for outcome in outcomes) >= least * len(outcomes)
    assert all(outcome.is_one or outcome.said.endswith(".") for outcome in outcomes)
