"""Radial sweeps, and solids that cannot be swept."""

import math

import Part
from solids.kit import Z_UP, box, circle, imprint, line, minus, rod, vec
from solids.registry import axial, face_at, scheme, solid


@solid("sec. 7.1", "radial", [0, 0], "two homeomorphic shells and no linking face")
def sphere_shell():
    """Section 7.1: sphere with one concentric void; the sweep goes from shell to shell and has
    no linking face at all."""
    OUTER, INNER = 24, 12
    shape = minus(Part.makeSphere(OUTER), Part.makeSphere(INNER))
    shells = sorted(shape.Shells, key=lambda s: -s.BoundBox.DiagonalLength)
    return shape, [scheme(shells[0].Faces, shells[1].Faces)]


@solid("sec. 7.1", "radial", [0, 0], "two homeomorphic shells and no linking face")
def hollow_box_shell():
    """Section 7.1: box with a box-shaped void; six sources against six targets whose edges
    pair off only through the homeomorphism of the shells."""
    OUTER, INNER = (60, 50, 40), (32, 24, 18)
    block, void = [box(-x / 2, x / 2, -y / 2, y / 2, -z / 2, z / 2) for x, y, z in (OUTER, INNER)]
    shape = minus(block, void)
    shells = sorted(shape.Shells, key=lambda s: -s.BoundBox.DiagonalLength)
    return shape, [scheme(shells[0].Faces, shells[1].Faces)]

@solid("7.4a", "unsweepable", [0, 0, 0], "topological: three shells and no linking face; the outer "
       "shell cannot be homeomorphic to the two inner ones together", True)
def sphere_two_voids():
    """Figure 7.4a: sphere with two separate voids."""
    OUTER, VOID, OFFSET = 30, 8, 13
    shape = minus(Part.makeSphere(OUTER), Part.makeSphere(VOID, vec(-OFFSET, 0, 0)),
                  Part.makeSphere(VOID, vec(OFFSET, 0, 0)))
    return shape, []


@solid("7.4c", "unsweepable", [0, 0, 0, 0], "topological: four shells and no linking face",
       True)
def sphere_three_voids():
    """Figure 7.4c: sphere with three separate voids."""
    OUTER, VOID, OFFSET = 32, 7, 15
    voids = [Part.makeSphere(VOID, vec(OFFSET * math.cos(a), OFFSET * math.sin(a), 0))
             for a in (math.pi / 2, math.pi * 7 / 6, math.pi * 11 / 6)]
    return minus(Part.makeSphere(OUTER), *voids), []


@solid("7.3", "unsweepable", [3], "topological: one shell of genus three; every edge lies between "
       "the ball's one face and a drill wall, so no face is left to link a source with a target",
       True, note="a ball, not a block: a block with three skew holes could be swept once the hole "
                  "walls are split, as in Figure 8.2")
def genus3_cross_drilled():
    """Figure 7.3: ball drilled along three axes by holes that pass each other."""
    RADIUS, DRILL, OFFSET = 30, 6, 10
    ball = Part.makeSphere(RADIUS)
    shape = minus(ball, rod(DRILL, vec(-40, OFFSET, -OFFSET), 80, vec(1, 0, 0)),
                  rod(DRILL, vec(-OFFSET, -40, OFFSET), 80, vec(0, 1, 0)),
                  rod(DRILL, vec(OFFSET, -OFFSET, -40), 80))
    return shape, []


@solid("7.6", "unsweepable", [1], "geometric: the hole's wall runs back against the sweep "
       "direction, so swept layers fold; topologically it is a 1-1 sweep", True, hexes=4000,
       note="the scheme listed is the topologically valid one")
def curved_through_hole():
    """Figure 7.6: block whose through hole bends over and runs back down before it leaves at
    the top."""
    LX, LY, HEIGHT, RADIUS = 90, 50, 70, 6
    PATH = [(-24, 0), (-24, 24), (-22, 42), (-12, 51), (-3, 43), (0, 35), (3, 27), (12, 19),
            (22, 28), (24, 46), (24, 70)]
    spine = Part.BSplineCurve()
    spine.interpolate(Points=[vec(x, 0, z) for x, z in PATH], InitialTangent=Z_UP,
                      FinalTangent=Z_UP)
    tube = Part.Wire([spine.toShape()]).makePipeShell([circle(RADIUS, vec(-24, 0, 0))], True, True)
    shape = minus(box(-LX / 2, LX / 2, -LY / 2, LY / 2, 0, HEIGHT), tube)
    return shape, [axial(shape)]


@solid("7.7a", "unsweepable", [0], "prescribed: the pairs below contradict the vertex "
       "correspondence along the linking faces; without them the solid is sweepable", True,
       note="scheme 0 carries the impossible pairs, scheme 1 is the free one")
def prescribed_mismatch():
    """Figure 7.7a: four quadrants above and four below; the user pairs each quadrant with the
    one diagonally opposite instead of the one beneath."""
    SIDE, HEIGHT = 60, 36
    half = SIDE / 2.0
    shape = imprint(box(-half, half, -half, half, 0, HEIGHT),
                    [line(vec(0, -half, z), vec(0, half, z)) for z in (0, HEIGHT)] +
                    [line(vec(-half, 0, z), vec(half, 0, z)) for z in (0, HEIGHT)])
    quadrants = [(-15, -15), (15, -15), (15, 15), (-15, 15)]
    sources = [face_at(shape, vec(x, y, HEIGHT)) for x, y in quadrants]
    opposite = [face_at(shape, vec(-x, -y, 0)) for x, y in quadrants]
    beneath = [face_at(shape, vec(x, y, 0)) for x, y in quadrants]
    return shape, [
        scheme(sources, opposite, kind="M-N", pairs=[[k, k] for k in range(4)], feasible=False),
        scheme(sources, beneath, kind="M-N", feasible=True)]
