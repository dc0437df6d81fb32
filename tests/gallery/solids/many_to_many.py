"""Many sources, many targets."""

import math

import Part
from solids.kit import (
    Z_UP,
    arc,
    box,
    circle,
    extruded,
    imprint,
    line,
    minus,
    oblique_rod,
    one_solid,
    planar,
    polygon,
    regular,
    ring_prism,
    rod,
    stadium,
    steps,
    union,
    vec,
)
from solids.registry import axial, caps, cylinder_faces, interior_point, outward_normal, scheme, solid


@solid("5.1a", "M-N", [0], "two sources over two targets, four patches after imprinting")
def two_by_two():
    """Figures 5.1a and 5.14: coplanar sources S1, S2 and targets T1, T2 whose dividing edges
    cross when seen along the sweep."""
    LX, LY, HEIGHT = 60, 50, 35
    shape = imprint(box(0, LX, 0, LY, 0, HEIGHT),
                    [line(vec(24, 0, HEIGHT), vec(36, LY, HEIGHT)),
                     line(vec(0, 20, 0), vec(LX, 31, 0))])
    return shape, [axial(shape)]


@solid("5.1a", "M-N", [0], "two levels above, two below", hexes=3000)
def two_by_two_stepped():
    """Figure 5.1a with steps: the source levels divide along x, the target levels along y,
    so the dividing edges are also bounding edges of a lower level."""
    LX, LY, LOW, HIGH, STEP_UP, STEP_DOWN = 60, 50, 15, 40, 14, 15
    shape = union(box(0, LX, 0, LY, LOW, HIGH),
                  box(0, 26, 0, LY, HIGH, HIGH + STEP_UP),
                  box(0, LX, 0, 22, LOW - STEP_DOWN, LOW))
    return shape, [axial(shape)]


@solid("5.1b", "M-N", [1], "two sources, three targets around a growing hole", hexes=3500)
def growing_hole_multi():
    """Figure 5.1b: two sources and three targets around a hole that grows so much that the
    source's dividing edge, carried over unchanged, would fall into the hole."""
    SIDE, HEIGHT, R_SOURCE, R_TARGET, DIVIDE = 64, 40, 6, 19, 11
    half = SIDE / 2.0
    block = box(-half, half, -half, half, 0, HEIGHT)
    solid_ = minus(block, oblique_rod(R_SOURCE, vec(0, 0, 0), R_TARGET, vec(0, 0, HEIGHT)))
    spokes = []
    for degrees, end in ((90, (0, half)), (200, (-half, None)), (330, (half, None))):
        a = math.radians(degrees)
        x = end[0]
        y = end[1] if end[1] is not None else x * math.tan(a)
        spokes.append(line(vec(R_TARGET * math.cos(a), R_TARGET * math.sin(a), HEIGHT),
                           vec(x, y, HEIGHT)))
    shape = imprint(solid_, [line(vec(-half, DIVIDE, 0), vec(half, DIVIDE + 4, 0))] + spokes)
    return shape, [scheme(caps(shape, Z_UP * -1), caps(shape, Z_UP))]


@solid("5.10", "M-N", [0], "steps on both sides", hexes=3000)
def step_both_sides():
    """Figures 5.5 and 5.10: a step above and a step below; seen along the sweep one pair of
    their edges overlaps fully and another pair only in part."""
    LX, LY, LOW, HIGH, UP, DOWN = 80, 50, 0, 24, 14, 12
    SHARED_X, UP_X, DOWN_X, SHARED_Y = 20, 56, 80, 30
    shape = union(box(0, LX, 0, LY, LOW, HIGH),
                  box(SHARED_X, UP_X, 0, SHARED_Y, HIGH, HIGH + UP),
                  box(SHARED_X, DOWN_X, 0, SHARED_Y, LOW - DOWN, LOW))
    return shape, [axial(shape)]


@solid("5.15", "M-N", [0], "four levels above, four below", hexes=4000,
       note="the figure's part is not described further; several levels, bosses and a pocket")
def multi_levels():
    """Figure 5.15: bosses and steps at several levels on both sides; the edges that bound one
    source lead to different targets and many outlines cross in projection."""
    shape = union(
        box(0, 100, 0, 70, 20, 40),
        box(0, 42, 0, 70, 40, 54), box(0, 22, 24, 70, 54, 66), rod(13, vec(70, 45, 40), 10),
        box(26, 78, 0, 30, 8, 20), box(0, 60, 52, 70, 13, 20))
    shape = minus(shape, rod(13, vec(80, 50, 20), 8))
    return shape, [axial(shape)]


@solid("5.16", "M-N", [1], "sources and targets around a typhoon-like hole", hexes=5000)
def typhoon_hole():
    """Figure 5.16: a two-armed typhoon-like hole twists by 110 degrees and grows; the circle
    on the source side, carried over unchanged, would cut into the hole's wide end."""
    SIDE, HEIGHT, TWIST, R0, R1, SWIRL, ARMS, POLES = 90, 50, 110, 8.5, 19, 55, 0.42, 24
    CIRCLE, BOSS = 16, 12
    half = SIDE / 2.0

    def section(t):
        mean = R0 + (R1 - R0) * t
        ring = []
        for k in range(POLES):
            a = 2 * math.pi * k / POLES
            bulge = ARMS * math.cos(2 * a)
            angle = a + math.radians(TWIST * t - SWIRL * bulge)
            ring.append(vec(mean * (1 + bulge) * math.cos(angle),
                            mean * (1 + bulge) * math.sin(angle), HEIGHT * t))
        return ring

    block = union(box(-half, half, -half, half, 0, HEIGHT),
                  box(-half, -half + 15, -half, half, HEIGHT, HEIGHT + BOSS),
                  box(-half, half, half - 13, half, -10, 0))
    solid_ = minus(block, ring_prism([section(t) for t in steps(10)]))
    rim = [e for e in solid_.Edges if e.isClosed() and abs(e.BoundBox.ZMin - HEIGHT) < 1e-6
           and abs(e.BoundBox.ZMax - HEIGHT) < 1e-6]
    assert len(rim) == 1
    cuts = [Part.Edge(Part.Circle(vec(0, 0, 0), Z_UP, CIRCLE))]
    for end in (vec(half, 12, HEIGHT), vec(-half + 15, -20, HEIGHT)):
        ray = line(vec(0, 0, HEIGHT), end)
        cuts.append(line(ray.distToShape(rim[0])[1][0][0], end))
    shape = imprint(solid_, cuts)
    return shape, [scheme(caps(shape, Z_UP * -1), caps(shape, Z_UP))]


@solid("5.18, 8.10", "M-N", [0], "cylinders and webs along one axis", hexes=5000)
def crankshaft():
    """Figures 5.18 and 8.10: three journals, four webs and two off-axis pins along x;
    journals and pins of equal size are not connected and their circles cross in projection."""
    JOURNAL, PIN, WEB, THROW = 11, 10, 17, 15
    LENGTHS = dict(end=20, web=9, pin=15, middle=16)
    X = vec(1, 0, 0)
    parts, x = [], 0.0

    def journal(length):
        nonlocal x
        parts.append(rod(JOURNAL, vec(x, 0, 0), length, X))
        x += length

    def throw(sign):
        nonlocal x
        for piece in ("web", "pin", "web"):
            length = LENGTHS[piece]
            if piece == "pin":
                parts.append(rod(PIN, vec(x, 0, sign * THROW), length, X))
            else:
                plate = extruded(stadium(vec(0, 0, 0), vec(THROW, 0, 0), WEB), length)
                # plate axis z -> x, plate x -> global sign * z
                plate.rotate(vec(0, 0, 0), vec(0, 1, 0), 90)
                if sign > 0:
                    plate.rotate(vec(0, 0, 0), X, 180)
                plate.translate(vec(x, 0, 0))
                parts.append(plate)
            x += length

    journal(LENGTHS["end"])
    throw(+1)
    journal(LENGTHS["middle"])
    throw(-1)
    journal(LENGTHS["end"])
    shape = union(*parts)
    return shape, [axial(shape, X)]


@solid("8.8", "M-N", [4], "prismatic along z with many levels", hexes=5000,
       note="a track-link-like part; the part in the figure is not dimensioned")
def caterpillar_part():
    """Figure 8.8: track link with an offset eye at either end, counterbore, window, bolt pads
    with holes and a groove below; many sources and targets at many levels."""
    EYE, BORE, SINK, CENTRES, THICK = 20, 10, 14, 90, 22
    shape = union(
        box(0, CENTRES, -14, 14, 0, THICK),
        rod(EYE, vec(0, 0, -8), 8 + THICK), rod(EYE, vec(CENTRES, 0, 0), THICK + 9),
        box(28, 62, 12, 27, 0, THICK + 6))
    window = extruded(stadium(vec(36, -2, -20), vec(54, -2, -20), 7), 80)
    shape = minus(shape,
                  rod(BORE, vec(0, 0, -20), 80), rod(BORE, vec(CENTRES, 0, -20), 80),
                  rod(SINK, vec(0, 0, THICK - 5), 80), window,
                  rod(4, vec(45, 20, -20), 80), box(62, 68, -40, 40, -1, 6),
                  box(24, 30, -40, 40, -1, 5))
    return shape, [axial(shape)]


def quartered_rod(radius, length):
    """Rod along y, centred, with its wall quartered at 45 degrees to the axes."""
    r, y = radius * math.sqrt(0.5), -length / 2.0
    corners = [vec(r, y, r), vec(-r, y, r), vec(-r, y, -r), vec(r, y, -r)]
    mids = [vec(0, y, radius), vec(-radius, y, 0), vec(0, y, -radius), vec(radius, y, 0)]
    wire = Part.Wire([arc(corners[k], mids[k], corners[(k + 1) % 4]) for k in range(4)])
    return planar(wire).extrude(vec(0, length, 0))


def facing(faces, sign):
    """Faces whose outward normal points up (+1) or down (-1) rather than sideways."""
    return [f for f in faces if sign * outward_normal(f, interior_point(f)).z > 0.8]


@solid("8.2", "M-N", [3], "outer faces sweep to inner faces, the pipe ends are linking", hexes=5000,
       note="scheme 1 (along z) holds topologically, but the END edges on the round outside of the "
            "cross pipe measure 180 degrees, so its elements are poor; see pipe_junction_drilled")
def pipe_junction():
    """Figure 8.2: a hollow pipe crosses a bigger hollow pipe; through the thickness the saddle
    edges outside and inside correspond without lying over each other."""
    R_BIG, B_BIG, H_BIG, R_SMALL, B_SMALL, L_SMALL = 20, 14, 72, 12, 7, 76
    foot = vec(0, 0, -H_BIG / 2.0)
    outer = one_solid(rod(R_BIG, foot, H_BIG).fuse(quartered_rod(R_SMALL, L_SMALL)))
    inner = one_solid(rod(B_BIG, foot, H_BIG).fuse(quartered_rod(B_SMALL, L_SMALL)))
    shape = minus(outer, inner)
    quarters = cylinder_faces(shape, R_SMALL, B_SMALL)
    return shape, [
        scheme(cylinder_faces(shape, R_BIG, R_SMALL), cylinder_faces(shape, B_BIG, B_SMALL),
               note="through the thickness"),
        scheme(caps(shape, Z_UP) + facing(quarters, 1),
               caps(shape, Z_UP * -1) + facing(quarters, -1), note="along z")]


@solid("8.2b", "M-N", [3], "floor and ceiling quarters of the cross bore are caps", hexes=4000)
def pipe_junction_drilled():
    """Figure 8.2b-e: a thick pipe with a cross bore through both walls, swept along the pipe;
    the quarter points of the bore's circles (180 degrees) must become CORNER vertices."""
    OUTER, BORE, HEIGHT, CROSS = 24, 10, 60, 8
    foot = vec(0, 0, -HEIGHT / 2.0)
    shape = minus(rod(OUTER, foot, HEIGHT), rod(BORE, foot, HEIGHT), quartered_rod(CROSS, 80))
    quarters = cylinder_faces(shape, CROSS)
    return shape, [scheme(caps(shape, Z_UP) + facing(quarters, 1),
                          caps(shape, Z_UP * -1) + facing(quarters, -1))]


@solid("8.6", "M-N", [7], "prismatic along z", hexes=5000,
       note="the figure shows an assembly without dimensions; the part is free")
def inlet_part():
    """Figure 8.6: one part of a reactor inlet: hexagonal grid plate with seven holes, a round
    nozzle below, a hexagonal rim above and a hub; the round and hexagonal outlines cross."""
    FLATS, INNER_FLATS, PLATE, NOZZLE_R, NOZZLE_BORE, HUB = 60, 44, 14, 24, 19.5, 8
    shape = union(
        extruded(polygon(regular(6, FLATS), 15), PLATE),
        extruded(polygon(regular(6, FLATS), 29), 12, polygon(regular(6, INNER_FLATS), 29)),
        extruded(circle(NOZZLE_R, vec(0, 0, 0)), 15, circle(NOZZLE_BORE, vec(0, 0, 0))),
        rod(HUB, vec(0, 0, 6), 9))
    holes = [rod(4.5, vec(0, 0, -5), 60)]
    for k in range(6):
        a = math.radians(60 * k + 20)
        holes.append(rod(3.5, vec(14 * math.cos(a), 14 * math.sin(a), -5), 60))
    shape = minus(shape, *holes)
    return shape, [axial(shape)]


@solid("8.6", "M-N", [1, 1, 7, 7], "every part sweeps along z", hexes=6000,
       note="touching faces are imprinted, so each contact is the same face in both solids "
            "(two coincident STEP faces)")
def inlet_assembly():
    """Figure 8.6: nozzle, grid plate, hexagonal can and rod-pierced core touching along z; the
    meshes must agree on the contacts, so a sweep of one part prescribes a cap of the next."""
    FLATS, INNER_FLATS = 60, 44
    nozzle = extruded(circle(24, vec(0, 0, 0)), 18, circle(19.5, vec(0, 0, 0)))
    hole_at = [(0.0, 0.0)] + [(14 * math.cos(math.radians(60 * k + 20)),
                               14 * math.sin(math.radians(60 * k + 20))) for k in range(6)]
    plate = extruded(polygon(regular(6, FLATS), 18), 12,
                     *[circle(3.5, vec(x, y, 18)) for x, y in hole_at])
    can = extruded(polygon(regular(6, FLATS), 30), 30, polygon(regular(6, INNER_FLATS), 30))
    core = extruded(polygon(regular(6, INNER_FLATS), 30), 30,
                    *[circle(3.5, vec(x, y, 30)) for x, y in hole_at])
    compound, _ = nozzle.generalFuse([plate, can, core])
    schemes = []
    for name, body in zip(("nozzle", "plate", "can", "core"), compound.Solids):
        entry = axial(body, body=body, part=name)
        count = (len(entry["sources"]), len(entry["targets"]))
        entry["kind"] = "1-1" if count == (1, 1) else "M-1" if count[1] == 1 else "M-N"
        if entry["kind"] == "M-N" and count[0] == 1:
            entry["sources"], entry["targets"] = entry["targets"], entry["sources"]
            entry["kind"] = "M-1"
        box_ = body.BoundBox
        entry["solid"] = dict(z=[round(box_.ZMin, 6), round(box_.ZMax, 6)],
                              volume=round(body.Volume, 6))
        schemes.append(entry)
    return compound, schemes
