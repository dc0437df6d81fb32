"""Bars and pipes that turn, with flanges, collars and bolt holes: many sources and targets along a bent path, without picks."""

import math
import random

import pytest
from checker import expect_valid_sweep
from solids.kit import Z_UP, arc, box, line, minus, one_solid, rod, union, vec

from sweepmesh import Model, mesh
from sweepmesh.freecad import import_freecad

import_freecad()
import Part  # noqa: E402

STRAIGHT = 20.0
"""Length of the straight part at either end."""


class Bend:
    """A path that rises, turns towards +x by `degrees` around `radius`, and goes straight on."""

    def __init__(self, degrees, radius):
        turn = math.radians(degrees)
        self.ahead = vec(math.sin(turn), 0, math.cos(turn))
        last = self._on_arc(radius, turn)
        self.end = last + self.ahead * STRAIGHT
        self.wire = Part.Wire(
            [
                line(vec(0, 0, 0), vec(0, 0, STRAIGHT)),
                arc(vec(0, 0, STRAIGHT), self._on_arc(radius, turn / 2), last),
                line(last, self.end),
            ]
        )

    @staticmethod
    def _on_arc(radius, turn):
        return vec(radius - radius * math.cos(turn), 0, STRAIGHT + radius * math.sin(turn))

    def moved(self, profile):
        """The solid of a wire in the plane z = 0, moved along the path."""
        return self.wire.makePipeShell([profile], True, True)


def round_profile(radius):
    """At the path's beginning."""
    return Part.Wire(Part.makeCircle(radius))


def square_profile(half):
    """At the path's beginning."""
    corners = [vec(half, half), vec(-half, half), vec(-half, -half), vec(half, -half)]
    return Part.makePolygon([*corners, corners[0]])


def holes_around(start, axis, across, radius):
    """Four bolt holes through a flange of thickness 5."""
    other = axis.cross(across)
    places = [across, other, across * -1, other * -1]
    return [rod(2.2, start + place * radius - axis * 5, 15, axis) for place in places]


def flanged_pipe(degrees, radius=30.0, bore=7.0, has_bolts=False):
    """A pipe with a round flange at either end."""
    path = Bend(degrees, radius)
    flange = 22.0 if has_bolts else 17.0
    far = path.end - path.ahead * 5
    solid = union(path.moved(round_profile(10)), rod(flange, vec(0, 0, 0), 5), rod(flange, far, 5, path.ahead))
    tools = [path.moved(round_profile(bore))] if bore else []
    if has_bolts:
        tools += holes_around(vec(0, 0, 0), Z_UP, vec(1, 0), 16)
        tools += holes_around(far, path.ahead, vec(0, 1), 16)
    return one_solid(minus(solid, *tools)) if tools else one_solid(solid)


def hook(degrees, radius=25.0):
    """A square bar with a collar and a thicker end."""
    path = Bend(degrees, radius)
    return one_solid(union(path.moved(square_profile(5)), box(-8, 8, -7, 7, 10, 15), box(-6, 6, -6, 6, 0, 4)))


def duct(degrees, radius=32.0):
    """A square duct with square flanges."""
    path = Bend(degrees, radius)
    far = box(-16, 16, -16, 16, -5, 0)
    far.rotate(vec(0, 0, 0), vec(0, 1, 0), degrees)
    far.translate(path.end)
    solid = union(path.moved(square_profile(10)), box(-16, 16, -16, 16, 0, 5), far)
    return one_solid(minus(solid, path.moved(square_profile(7))))


def any_part(seed):
    """Of a random kind, with random numbers."""
    source = random.Random(seed)
    degrees = source.uniform(40, 200)
    kind = source.choice(["pipe", "bolted", "bar", "hook", "duct"])
    radius = source.uniform(26, 45)
    if kind == "hook":
        return hook(degrees, radius)
    if kind == "duct":
        return duct(degrees, radius)
    bore = 0.0 if kind == "bar" else source.uniform(5, 8)
    return flanged_pipe(degrees, radius, bore, kind == "bolted")


def expect_swept_along(shape, least=0.3):
    """Meshes without picks, all elements good."""
    model = Model.from_brep(shape.exportBrepToString(), 0)
    result = mesh(model)
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model)
    assert result.quality["min_scaled_jacobian"] > least


@pytest.mark.parametrize("degrees", [45, 90, 135, 180, 210])
def test_a_pipe_may_turn_between_its_flanges(degrees):
    expect_swept_along(flanged_pipe(degrees), 0.5)


@pytest.mark.parametrize("seed", range(10))
def test_random_parts_are_swept_along_their_path(seed):
    expect_swept_along(any_part(seed))
