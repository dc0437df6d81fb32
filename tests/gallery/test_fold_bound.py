"""Holes that wind too far are refused before any mesh, and nothing that can be meshed is."""

import json
import math
import os
import subprocess
import sys

import fold_families
import Part
import pytest
import sweepmesh
from checker import expect_valid_sweep
from gallery import ROOT
from sweepmesh.engine import hole_winding
from sweepmesh.engine.model import as_model

TURNING = ("slot_turns", "slot_turns_in_steps", "bend_with_hole", "braid")
"""Families whose `turn` is how far their holes wind."""
LIMIT = 200
SEEDS = range(8)


def brep(solid):
    """Text for the engine."""
    return solid.shape.exportBrepToString()


def options(solid, **more):
    """With the ends picked."""
    return sweepmesh.Options(sources=solid.sources, targets=solid.targets, **more)


def walls_of_holes(solid):
    """The faces that are no planes."""
    return {f"Face{i}" for i, face in enumerate(solid.shape.Faces, 1) if not isinstance(face.Surface, Part.Plane)}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("family", TURNING)
def test_the_bound_measures_the_motion_and_refuses_what_winds_too_far(family, seed):
    solid = fold_families.make(family, seed)
    if not set(solid.sources).isdisjoint(solid.targets):
        pytest.skip("a bend that comes back to the plane that it began in")
    turn = solid.numbers["turn"]
    measured = hole_winding(brep(solid), options(solid))
    assert measured.degrees == pytest.approx(turn, abs=4)
    verdict = sweepmesh.assess(brep(solid), options(solid))
    assert verdict.is_sweepable == (measured.degrees <= LIMIT)
    if not verdict.is_sweepable:
        (reason,) = verdict.reasons
        assert reason.kind == "geometric" and f"{measured.degrees:.0f} degrees" in reason.text
        parts = math.ceil(measured.degrees / 140)
        assert f"across the sweep into {parts} parts" in reason.text
        assert set(reason.entities) == set(measured.faces)
        if family != "bend_with_hole":
            assert set(reason.entities) == walls_of_holes(solid)


@pytest.mark.parametrize("family", ["bar_turns", "moving_hole", "overhang"])
@pytest.mark.parametrize("seed", SEEDS)
def test_what_does_not_wind_is_not_refused_for_it(family, seed):
    """However far a bar turns as a whole, a hole moves, or a wall leans."""
    solid = fold_families.make(family, seed)
    assert hole_winding(brep(solid), options(solid)).degrees < 60
    assert not any("half a turn" in reason.text for reason in sweepmesh.assess(brep(solid), options(solid)).reasons)


@pytest.mark.parametrize(("family", "seed"), [("slot_turns_in_steps", 0), ("braid", 2)])
def test_nearly_half_a_turn_is_meshed(family, seed):
    solid = fold_families.make(family, seed)
    assert 140 < hole_winding(brep(solid), options(solid)).degrees < 180
    result = sweepmesh.mesh(brep(solid), options(solid))
    assert result.assessment.is_sweepable
    expect_valid_sweep(result, as_model(brep(solid)))


@pytest.mark.parametrize(("family", "seed"), [("braid", 65)])
def test_what_is_refused_folds_indeed(family, seed):
    """Tried all the same, elements stay inverted."""
    solid = fold_families.make(family, seed)
    assert not sweepmesh.assess(brep(solid), options(solid)).is_sweepable
    tried = sweepmesh.mesh(brep(solid), options(solid, refuse_folds=False))
    assert not tried.assessment.is_sweepable
    assert "stay inverted" in tried.assessment.reasons[0].text


def test_the_command_line_says_why(tmp_path):
    solid = fold_families.make("slot_turns", 5)
    solid.shape.exportBrep(str(tmp_path / "solid.brep"))
    command = [sys.executable, "-m", "sweepmesh", "solid.brep", "--out", "mesh.vtu", "--report", "report.json"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "Mod")}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and not (tmp_path / "mesh.vtu").exists()
    (reason,) = json.loads((tmp_path / "report.json").read_text())["reasons"]
    assert reason["kind"] == "geometric" and set(reason["entities"]) == walls_of_holes(solid)
    assert reason["text"] in done.stdout


def test_the_way_out_is_a_cut_across():
    solid = fold_families.make("slot_turns", 5)
    cut = sweepmesh.suggest_cut(brep(solid))
    assert cut is not None and cut.is_tried and len(cut.pieces) == 2
    assert abs(cut.normal[2]) == pytest.approx(1) and cut.point[2] == pytest.approx(solid.numbers["height"] / 2)


def leaning(degrees, share):
    """A block with a hole that leans over by so much, over this share of its way."""
    path, least = fold_families.leaning_path(math.radians(degrees), 70, share)
    return fold_families.leaning_hole(path, 0.5 * least, 50, 40, 0).exportBrepToString()


def test_a_hole_that_runs_back_a_little_is_meshed():
    """Even against straight walls: the layers tilt."""
    shape = leaning(108, 0.15)
    result = sweepmesh.mesh(shape)
    assert result.assessment.is_sweepable
    expect_valid_sweep(result, as_model(shape))


def test_a_hole_that_runs_back_a_long_way_is_refused():
    verdict = sweepmesh.assess(leaning(160, 0.22))
    assert not verdict.is_sweepable and "runs back against the sweep" in verdict.reasons[0].text
