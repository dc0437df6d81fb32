"""Plates whose top face is to be submapped."""

import math

import Part
from solids.kit import arc, circle, extruded, line, one_solid, polygon, vec
from solids.registry import solid, submapped


@solid("6.3, 6.7", "submap", [1], "prism; top face submappable with the round templates",
       hexes=3000)
def fillet_round_chamfer_plate():
    """Figures 6.2, 6.3 and 6.7: outline with a chamfer, a quarter round, a fillet, a half-round
    tab, a three-quarter bulb and a full circle hole; the angles alone give no valid corners."""
    LX, LY, CHAMFER, ROUND, BULB, TAB_R, TAB_X, TAB_Y, FILLET, HOLE = (
        110, 60, 12, 14, 10, 12, 66, 74, 6, 10)
    HEIGHT, HOLE_AT, Q = 8, (36, 28), math.sqrt(0.5)
    x0, x1 = TAB_X - TAB_R, TAB_X + TAB_R
    fillet_at = (x0 - FILLET, LY + FILLET)
    round_at = (LX - ROUND, ROUND)

    def p(x, y):
        return vec(x, y, 0)

    outline = Part.Wire([
        line(p(CHAMFER, 0), p(LX - ROUND, 0)),
        arc(p(LX - ROUND, 0), p(round_at[0] + ROUND * Q, round_at[1] - ROUND * Q), p(LX, ROUND)),
        line(p(LX, ROUND), p(LX, LY)), line(p(LX, LY), p(x1, LY)),
        line(p(x1, LY), p(x1, TAB_Y)),
        arc(p(x1, TAB_Y), p(TAB_X, TAB_Y + TAB_R), p(x0, TAB_Y)),
        line(p(x0, TAB_Y), p(x0, LY + FILLET)),
        arc(p(x0, LY + FILLET), p(fillet_at[0] + FILLET * Q, fillet_at[1] - FILLET * Q),
            p(x0 - FILLET, LY)),
        line(p(x0 - FILLET, LY), p(BULB, LY)),
        arc(p(BULB, LY), p(-BULB * Q, LY + BULB * Q), p(0, LY - BULB)),
        line(p(0, LY - BULB), p(0, CHAMFER)), line(p(0, CHAMFER), p(CHAMFER, 0))])
    shape = one_solid(extruded(outline, HEIGHT, circle(HOLE, vec(*HOLE_AT))))
    virtual = [((CHAMFER / 2.0, CHAMFER / 2.0), "END"),
               ((round_at[0] + ROUND * Q, round_at[1] - ROUND * Q), "END"),
               ((TAB_X + TAB_R * Q, TAB_Y + TAB_R * Q), "END"),
               ((TAB_X - TAB_R * Q, TAB_Y + TAB_R * Q), "END"),
               ((fillet_at[0] + FILLET * Q, fillet_at[1] - FILLET * Q), "CORNER")]
    virtual += [((sx * BULB * Q, LY + sy * BULB * Q), "END")
                for sx, sy in ((1, 1), (-1, 1), (-1, -1))]
    virtual += [((HOLE_AT[0] + sx * HOLE * Q, HOLE_AT[1] + sy * HOLE * Q), "CORNER")
                for sx in (-1, 1) for sy in (-1, 1)]
    return submapped(shape, HEIGHT, {(0, CHAMFER): "SIDE", (CHAMFER, 0): "SIDE"}, virtual,
                     ["chamfer: one of its ends END and the other SIDE, without a virtual vertex"])


@solid("6.1, 6.8", "submap", [0], "prism; top face submappable once the sum is repaired")
def ambiguous_angles_plate():
    """Figures 6.1 and 6.8: a slanted step whose two angles (222 and 130 degrees) round to SIDE
    and END, which adds up to five."""
    HEIGHT = 8
    shape = extruded(polygon([(0, 0), (80, 0), (80, 20), (50, 20), (30, 38), (0, 34)]), HEIGHT)
    return submapped(one_solid(shape), HEIGHT, {(50, 20): "CORNER"},
                     alternatives=["(30, 38) SIDE and (50, 20) SIDE"])


@solid("6.6", "submap", [0], "prism; top face submappable with the reversal flattened")
def reversal_to_side_plate():
    """Figure 6.6: a cusp between two smooth shoulders measures 350 degrees (REVERSAL); only as a
    SIDE does the sum reach four, a change of two that the older model forbids."""
    LX, LY, HEIGHT, TIP, SHOULDER, LEAN, KNEE = 90, 60, 8, 38, 27, 1.5, 55
    mid = LX / 2.0

    def bezier(*points):
        curve = Part.BezierCurve()
        curve.setPoles([vec(x, y, 0) for x, y in points])
        return curve.toShape()

    outline = Part.Wire([
        line(vec(0, 0), vec(LX, 0)), line(vec(LX, 0), vec(LX, LY)),
        line(vec(LX, LY), vec(mid + SHOULDER, LY)),
        bezier((mid + SHOULDER, LY), (mid + SHOULDER / 2, LY), (mid + LEAN, KNEE), (mid, TIP)),
        bezier((mid, TIP), (mid - LEAN, KNEE), (mid - SHOULDER / 2, LY), (mid - SHOULDER, LY)),
        line(vec(mid - SHOULDER, LY), vec(0, LY)), line(vec(0, LY), vec(0, 0))])
    shape = one_solid(extruded(outline, HEIGHT))
    return submapped(shape, HEIGHT, {(mid, TIP): "SIDE"},
                     alternatives=["a virtual END on each shoulder, the cusp a REVERSAL"])


@solid("A.2", "submap", [0], "prism; top face submappable with the corner flattened")
def corner_to_side_plate():
    """Figure A.2: a wide notch of 246 degrees reads as CORNER, which leaves a sum of three."""
    HEIGHT = 8
    shape = extruded(polygon([(0, 0), (80, 0), (80, 50), (40, 24), (0, 50)]), HEIGHT)
    return submapped(one_solid(shape), HEIGHT, {(40, 24): "SIDE"})


@solid("sec. 6.4", "submap", [2], "prism; all angles right", hexes=3000)
def multiply_connected_plate():
    """Section 6.4: rectilinear plate with a rectangular and an L-shaped hole; the intervals of
    the holes must agree with those of the outer boundary."""
    HEIGHT = 8
    OUTLINE = [(0, 0), (110, 0), (110, 50), (84, 50), (84, 74), (22, 74), (22, 60), (0, 60)]
    RECTANGLE = [(12, 16), (36, 16), (36, 42), (12, 42)]
    ELL = [(52, 12), (94, 12), (94, 30), (70, 30), (70, 58), (52, 58)]
    shape = extruded(polygon(OUTLINE), HEIGHT, polygon(RECTANGLE), polygon(ELL))
    return submapped(one_solid(shape), HEIGHT)
