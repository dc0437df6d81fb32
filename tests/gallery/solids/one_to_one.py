"""One source, one target."""

import math

import Part
from solids.kit import (
    Z_UP,
    arc,
    at_height,
    bezier_prism,
    box,
    circle,
    dome_ball,
    extruded,
    line,
    minus,
    oblique_rod,
    one_solid,
    planar,
    polygon,
    polygon_prism,
    regular,
    ring_prism,
    rod,
    steps,
    turned,
    vec,
)
from solids.registry import axial, caps, scheme, solid


@solid("1.1", "1-1", [0], "right prism")
def brick():
    """Figure 1.1: plain block, the control case; all three directions sweep."""
    LX, LY, LZ = 60, 40, 25
    shape = box(0, LX, 0, LY, 0, LZ)
    return shape, [axial(shape), axial(shape, vec(1, 0, 0)), axial(shape, vec(0, 1, 0))]


@solid("1.1", "1-1", [0], "right prism over a disc")
def cylinder_full():
    """Figure 1.1: cylinder along its axis; the wall is one periodic face with a seam."""
    RADIUS, HEIGHT = 20, 50
    shape = rod(RADIUS, vec(0, 0, 0), HEIGHT)
    return shape, [axial(shape)]


@solid("3.9", "1-1", [1], "caps are homeomorphic, the wall of the hole is ruled")
def moving_hole():
    """Figure 3.9: the round hole changes place between source and target while the
    outer boundary stays; an affine source-target map inverts quads."""
    SIDE, HEIGHT, RADIUS, SHIFT = 60, 40, 9, 14
    block = box(-SIDE / 2, SIDE / 2, -SIDE / 2, SIDE / 2, 0, HEIGHT)
    shape = minus(block, oblique_rod(RADIUS, vec(-SHIFT, -SHIFT, 0),
                                     RADIUS, vec(SHIFT, SHIFT, HEIGHT)))
    return shape, [axial(shape)]


@solid("3.11", "1-1", [1], "caps are homeomorphic", hexes=3000)
def concave_twisted_growing_hole():
    """Figure 3.11: concave outline (deep notch) with a square hole that grows and twists;
    the wide end of the hole comes close to the notch."""
    OUTLINE = [(0, 0), (90, 0), (90, 70), (56, 70), (56, 52), (28, 52), (28, 70), (0, 70)]
    HEIGHT, CENTRE, SIDE0, SIDE1, TWIST = 40, (43, 26), 12, 26, 60
    block = extruded(polygon(OUTLINE), HEIGHT)
    square = regular(4, SIDE0, math.pi / 4, CENTRE)
    hole = polygon_prism([
        at_height(turned(square, TWIST * t, CENTRE, 1 + t * (SIDE1 / SIDE0 - 1)), HEIGHT * t)
        for t in steps(8)])
    shape = minus(block, hole)
    return shape, [axial(shape)]


@solid("3.13", "1-1", [1], "caps are homeomorphic", hexes=3000)
def random_hole():
    """Figure 3.13: a hole with a smooth irregular boundary that changes its shape and
    turns by 70 degrees on the way."""
    SIDE, HEIGHT, TURN = 70, 45, 70
    BOTTOM = [15, 19, 13, 10, 16, 21, 18, 12, 9, 14, 20, 17, 11, 12]
    TOP = [20, 13, 11, 18, 23, 16, 10, 13, 19, 12, 14, 22, 19, 24]
    block = box(-SIDE / 2, SIDE / 2, -SIDE / 2, SIDE / 2, 0, HEIGHT)
    sections = []
    for t in steps(6):
        ring = []
        for k, (r0, r1) in enumerate(zip(BOTTOM, TOP)):
            angle = 2 * math.pi * k / len(BOTTOM) + math.radians(TURN * t)
            radius = r0 + t * (r1 - r0)
            ring.append(vec(radius * math.cos(angle), radius * math.sin(angle), HEIGHT * t))
        sections.append(ring)
    shape = minus(block, ring_prism(sections))
    return shape, [axial(shape)]


@solid("3.15", "1-1", [15], "caps are homeomorphic, both with 15 holes", hexes=5000)
def spongecake():
    """Figure 3.15: a slab with a domed top and fifteen holes that drift, grow and shrink,
    so the curved target differs from the flat source everywhere."""
    LX, LY, DOME_RADIUS, DOME_TOP = 100, 64, 130, 34
    COLUMNS, ROWS, PITCH_X, PITCH_Y = 5, 3, 19, 19
    R0 = [4.5, 3, 5.5, 4, 3.5, 5, 4, 3, 6, 4.5, 3, 5, 4, 5.5, 3.5]
    R1 = [3, 5, 3.5, 5.5, 4.5, 3, 6, 4.5, 3.5, 3, 5.5, 3, 5.5, 4, 5]
    DRIFT = [(4, 2), (-3, 3), (2, -3), (3, 3), (-4, 1), (2, -4), (-3, -2), (4, 3), (-2, 3),
             (-3, -3), (3, -2), (-3, -2), (3, -3), (-2, -1), (-4, -3)]
    slab = box(-LX / 2, LX / 2, -LY / 2, LY / 2, 0, 2 * DOME_TOP)
    cake = one_solid(slab.common(dome_ball(DOME_RADIUS, vec(0, 0, DOME_TOP - DOME_RADIUS))))
    tools = []
    for k, (r0, r1, (dx, dy)) in enumerate(zip(R0, R1, DRIFT)):
        x = (k % COLUMNS - (COLUMNS - 1) / 2) * PITCH_X
        y = (k // COLUMNS - (ROWS - 1) / 2) * PITCH_Y
        tools.append(oblique_rod(r0, vec(x, y, 0), r1, vec(x + dx, y + dy, DOME_TOP + 2)))
    shape = minus(cake, *tools)
    dome = [f for f in shape.Faces if f.Surface.TypeId == "Part::GeomSphere"]
    assert len(dome) == 1
    return shape, [scheme(caps(shape, Z_UP * -1), dome)]


@solid("4.7", "1-1", [1], "caps are homeomorphic", hexes=3500)
def twisted_through_hole():
    """Figure 4.7: a slender rectangular hole turns by 90 degrees from cap to cap; the
    inner nodes must follow the twist only near the hole."""
    SIDE, HEIGHT, LONG, SHORT, TWIST = 60, 60, 30, 10, 90
    block = box(-SIDE / 2, SIDE / 2, -SIDE / 2, SIDE / 2, 0, HEIGHT)
    slot = [(-LONG / 2, -SHORT / 2), (LONG / 2, -SHORT / 2),
            (LONG / 2, SHORT / 2), (-LONG / 2, SHORT / 2)]
    hole = polygon_prism([at_height(turned(slot, TWIST * t), HEIGHT * t) for t in steps(12)])
    shape = minus(block, hole)
    return shape, [axial(shape)]


@solid("4.5", "1-1", [0], "caps are homeomorphic", hexes=2500)
def blades_cross():
    """Figure 4.5: four blades in a cross; three twist with height and the fourth stays
    straight but its outer half bends aside, so the motion differs from blade to blade."""
    ARM, THICK, HEIGHT, TWIST, BEND = 34, 6, 60, 35, 50

    def section(t):
        """Outline at height fraction t: junction corner, then the blade's tip corners."""
        angles = [math.radians(90 * k + (TWIST * t if k < 3 else 0.0)) for k in range(4)]
        points = []
        half = THICK / 2
        for k, a in enumerate(angles):
            u, n = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))

            def local(s, w, u=u, n=n):
                return (s * u[0] + w * n[0], s * u[1] + w * n[1])
            if k < 3:
                points += [local(ARM, -half), local(ARM, half)]
            else:
                joint = local(ARM / 2, 0)
                right, left = local(ARM / 2, -half), local(ARM / 2, half)
                tip = turned([local(ARM, -half), local(ARM, half)], BEND * t, joint)
                fold = math.radians(BEND * t / 2)
                right = turned([right], math.degrees(fold), joint, 1 / math.cos(fold))[0]
                left = turned([left], math.degrees(fold), joint, 1 / math.cos(fold))[0]
                points += [right] + tip + [left]
            b = angles[(k + 1) % 4]
            gap = (b - a) % (2 * math.pi) / 2
            reach = half / math.sin(gap)
            points.append((reach * math.cos(a + gap), reach * math.sin(a + gap)))
        return points

    shape = polygon_prism([at_height(section(t), HEIGHT * t) for t in steps(8)])
    return shape, [axial(shape)]


@solid("6.11", "1-1", [0], "caps are homeomorphic", hexes=2500,
       note="only the aerofoil; the root and platform of the part in the figure are left out")
def blade_twist():
    """Figure 6.11-like turbine blade: cambered aerofoil that twists, leans and tapers from
    root to tip; thin trailing edge against a round leading edge."""
    CHORD, SPAN, TWIST, TAPER, LEAN = 40, 80, 45, 0.6, 8
    LE_X, LE_R, TE_X, TE_HALF = -20, 2.6, 20, 0.9

    def section(t):
        s = CHORD / 40 * (1 - (1 - TAPER) * t)
        le_up, le_down = (LE_X + 1.2, LE_R), (LE_X + 1.2, -LE_R * 0.8)
        te_up, te_down = (TE_X, TE_HALF - 2), (TE_X, -TE_HALF - 2)
        edges = [
            [te_up, (8, 8.5), (-12, 11), le_up],
            [le_up, (LE_X - 1.8, 1.5), (LE_X - 2.0, -1.8), le_down],
            [le_down, (-12, -1.0), (8, 2.2), te_down],
            [te_down, te_up]]
        out = []
        for edge in edges:
            flat = turned(edge, TWIST * t, (0, 0), s)
            out.append([vec(x + LEAN * t * t, y, SPAN * t) for x, y in flat])
        return out

    shape = bezier_prism([section(t) for t in steps(6)])
    return shape, [axial(shape)]


@solid("sec. 1.1", "1-1", [1], "revolved annulus", hexes=3000)
def bent_pipe():
    """Section 1.1: annulus swept along a 90 degree arc; the layers turn with the arc."""
    OUTER, INNER, BEND = 12, 8, 35
    ring = planar(circle(OUTER, vec(BEND, 0, 0)), circle(INNER, vec(BEND, 0, 0)))
    shape = one_solid(ring.revolve(vec(0, 0, 0), vec(0, 1, 0), 90))
    flat = [f for f in shape.Faces if f.Surface.TypeId == "Part::GeomPlane"]
    return shape, [scheme(flat[:1], flat[1:])]


@solid("sec. 1.1", "1-1", [0], "caps are homeomorphic", hexes=2500)
def s_duct():
    """Section 1.1: a square inlet becomes a round outlet along an S path; the four vertices
    of the round cap lie on a smooth circle (180 degree corners)."""
    LENGTH, RISE, SIDE, RADIUS, BEZIER = 90, 35, 30, 16, 0.5522847498

    def section(t):
        w = t * t * (3 - 2 * t)
        slope = math.atan2(RISE * 6 * t * (1 - t), LENGTH)
        centre = (LENGTH * t, RISE * w)
        edges = []
        for k in range(4):
            a = [math.pi / 4 + k * math.pi / 2, math.pi / 4 + (k + 1) * math.pi / 2]
            (cx0, cy0), (cx1, cy1) = [(RADIUS * math.cos(x), RADIUS * math.sin(x)) for x in a]
            round_ = [(cx0, cy0), (cx0 - BEZIER * cy0, cy0 + BEZIER * cx0),
                      (cx1 + BEZIER * cy1, cy1 - BEZIER * cx1), (cx1, cy1)]
            h = SIDE / 2 * math.sqrt(2)
            p, q = [(h * math.cos(x), h * math.sin(x)) for x in a]
            square = [(p[0] + (q[0] - p[0]) * s, p[1] + (q[1] - p[1]) * s)
                      for s in (0, 1 / 3, 2 / 3, 1)]
            edge = []
            for (sx, sy), (rx, ry) in zip(square, round_):
                y, up = sx + w * (rx - sx), sy + w * (ry - sy)
                edge.append(vec(centre[0] - up * math.sin(slope), y,
                                centre[1] + up * math.cos(slope)))
            edges.append(edge)
        return edges

    shape = bezier_prism([section(t) for t in steps(10)])
    return shape, [scheme(caps(shape, vec(-1, 0, 0)), caps(shape, vec(1, 0, 0)))]


@solid("2.1", "1-1", [0], "caps are homeomorphic discs", hexes=2000)
def domed_cap():
    """Figure 2.1: the source bulges while its rim and the target are flat; boundary-only
    maps flatten or skew the layers."""
    RADIUS, WALL, DOME = 25, 12, 10
    ball = (RADIUS ** 2 + DOME ** 2) / (2.0 * DOME)
    post = rod(RADIUS, vec(0, 0, 0), 2 * (WALL + DOME))
    shape = one_solid(post.common(dome_ball(ball, vec(0, 0, WALL + DOME - ball))))
    dome = [f for f in shape.Faces if f.Surface.TypeId == "Part::GeomSphere"]
    return shape, [scheme(dome, caps(shape, Z_UP * -1))]


@solid("6.2", "1-1", [0], "right prism over an L", hexes=2500)
def l_bracket():
    """Figure 6.2-like: L profile with a fillet inside and a round outside, extruded; the
    fillets blur the corners of the profile."""
    LEG_X, LEG_Z, THICK, WIDTH, FILLET, ROUND = 60, 50, 12, 40, 8, 10
    k = 1 - math.sqrt(0.5)
    p = [vec(ROUND, 0, 0), vec(LEG_X, 0, 0), vec(LEG_X, 0, THICK),
         vec(THICK + FILLET, 0, THICK), vec(THICK, 0, THICK + FILLET), vec(THICK, 0, LEG_Z),
         vec(0, 0, LEG_Z), vec(0, 0, ROUND)]
    outline = Part.Wire([
        line(p[0], p[1]), line(p[1], p[2]), line(p[2], p[3]),
        arc(p[3], vec(THICK + FILLET * k, 0, THICK + FILLET * k), p[4]),
        line(p[4], p[5]), line(p[5], p[6]), line(p[6], p[7]),
        arc(p[7], vec(ROUND * k, 0, ROUND * k), p[0])])
    shape = one_solid(planar(outline).extrude(vec(0, WIDTH, 0)))
    return shape, [axial(shape, vec(0, 1, 0))]


@solid("6.9", "1-1", [1], "right prism over a ring", hexes=5000)
def gear():
    """Figure 6.9: involute spur gear, twenty teeth, hub hole with keyway; multiply-connected
    cap with eighty short edges outside."""
    TEETH, MODULE, PRESSURE, WIDTH = 20, 3, 20, 16
    BORE, KEY_WIDTH, KEY_TOP = 9, 5, 11.6
    pitch = MODULE * TEETH / 2
    tip, root = pitch + MODULE, pitch - 1.25 * MODULE
    base = pitch * math.cos(math.radians(PRESSURE))

    def involute(angle):
        return math.tan(angle) - angle

    half_pitch = math.pi / (2 * TEETH) + involute(math.radians(PRESSURE))

    def half_angle(radius):
        """Half of the tooth's angular width at a radius."""
        return half_pitch - involute(math.acos(min(1.0, base / max(radius, base))))

    def polar(radius, angle):
        return vec(radius * math.cos(angle), radius * math.sin(angle), 0)

    radii = [root, base, base + (tip - base) * 0.33, base + (tip - base) * 0.66, tip]
    edges = []
    for k in range(TEETH):
        axis, step = 2 * math.pi * k / TEETH, 2 * math.pi / TEETH
        for points in ([polar(r, axis - half_angle(r)) for r in radii],
                       [polar(r, axis + half_angle(r)) for r in reversed(radii)]):
            flank = Part.BSplineCurve()
            flank.interpolate(points)
            edges.append(flank.toShape())
        edges.append(arc(polar(tip, axis - half_angle(tip)), polar(tip, axis),
                         polar(tip, axis + half_angle(tip))))
        edges.append(arc(polar(root, axis + half_angle(root)), polar(root, axis + step / 2),
                         polar(root, axis + step - half_angle(root))))
    outer = Part.Wire(Part.__sortEdges__(edges))
    x = math.sqrt(BORE ** 2 - (KEY_WIDTH / 2) ** 2)
    q = [vec(x, -KEY_WIDTH / 2), vec(KEY_TOP, -KEY_WIDTH / 2),
         vec(KEY_TOP, KEY_WIDTH / 2), vec(x, KEY_WIDTH / 2)]
    bore = Part.Wire([line(q[0], q[1]), line(q[1], q[2]), line(q[2], q[3]),
                      arc(q[3], vec(-BORE, 0), q[0])])
    shape = one_solid(extruded(outer, WIDTH, bore))
    return shape, [axial(shape)]
