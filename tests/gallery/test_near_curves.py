"""Curves of different caps that all but coincide, and that cross at small angles: meshes are valid all the way."""

import math

import pytest
from checker import expect_valid_sweep
from solids.kit import box, extruded, polygon, rod, union, vec

from sweepmesh import Options, engine, mesh

SIZE = 4.0
MERGED_BELOW = 0.25
"""Of the size: the default of the core."""


def solid_with_two_steps(gap):
    """A step above at x = 20 and one below, `gap` further."""
    return union(box(0, 40, 0, 30, 0, 20), box(0, 20, 0, 30, 20, 32), box(0, 20 + gap, 0, 30, -12, 0))


def solid_with_two_rims(gap):
    """A round boss above, and below one with a radius larger by `gap`."""
    return union(box(-20, 20, -20, 20, 0, 16), rod(11, vec(0, 0, 16), 10), rod(11 + gap, vec(0, 0, -10), 10))


def solid_with_corners(gap):
    """A square boss above, and the same one below, moved by `gap` along both of its sides."""
    shift = gap
    return union(
        box(-20, 20, -20, 20, 0, 16), box(-9, 9, -9, 9, 16, 26), box(shift - 9, shift + 9, shift - 9, shift + 9, -10, 0)
    )


def solid_with_crossing(degrees):
    """Steps across the solid, above and below, that lean to either side and cross in its middle."""
    half = 90 if degrees < 5 else 30  # of the length: at its ends the curves are farther apart than the limit
    t = half * math.tan(math.radians(degrees) / 2)
    width = t + 20
    slab = box(-width, width, -half, half, 0, 16)

    def step(sign, low, high):
        outline = [(-width, -half), (-sign * t, -half), (sign * t, half), (-width, half)]
        prism = extruded(polygon(outline), high - low)
        prism.translate((0, 0, low))
        return prism

    return union(slab, step(1, 16, 26), step(-1, -10, 0))


def upwards(shape):
    """Options: level faces that look up are sources, those that look down targets."""
    slope = [face.normalAt(0, 0).z if face.Surface.TypeId == "Part::GeomPlane" else 0 for face in shape.Faces]
    return Options(
        size=SIZE,
        sources=[number for number, z in enumerate(slope, 1) if z > 0.9],
        targets=[number for number, z in enumerate(slope, 1) if z < -0.9],
    )


def imprint_and_mesh(shape, is_on_limit=False):
    """The imprint of a sweep upwards, and its mesh once it has been checked.

    Curves just as far apart as the limit may be merged here and there: the mesh must be right, there is no imprint.
    """
    model = engine.Model.from_brep(shape.exportBrepToString(), 0)
    result = mesh(model, upwards(shape))
    expect_valid_sweep(result, model)
    return None if is_on_limit else engine.imprint(model, upwards(shape)), result


@pytest.mark.parametrize("build", [solid_with_two_steps, solid_with_two_rims, solid_with_corners])
@pytest.mark.parametrize("step", range(21))
def test_near_curves_are_merged_below_the_limit_and_kept_above_it(build, step):
    gap, limit = SIZE * step / 20, SIZE * MERGED_BELOW
    imprint, result = imprint_and_mesh(build(gap), is_on_limit=gap == limit)
    if gap == 0 or gap > limit:
        assert not imprint.merges
    elif gap < limit:
        assert imprint.merges
        assert all(0.9 * gap < distance < 1.5 * gap for _, _, distance in imprint.merges)
    assert gap == limit or not any("brought together" in warning for warning in result.warnings)


@pytest.mark.parametrize("degrees", [1, 2, 3, 5, 7, 10, 15, 20, 30, 40, 50, 60, 75, 90])
def test_crossings_are_kept_at_every_angle(degrees):
    imprint, _ = imprint_and_mesh(solid_with_crossing(degrees))
    caps = {}
    for part in imprint.parts:
        caps.setdefault(part.pair, set()).add(part.cap)
    assert len({tuple(sorted(pair)) for pair in caps.values()}) == 4, "a source has lost a target below it"
