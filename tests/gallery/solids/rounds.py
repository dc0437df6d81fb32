"""Solids whose linking faces turn in the middle of rounded edges, whatever is swept."""

import Part
from solids.kit import arc, box, extruded, line, minus, planar, rod, stadium, union, vec
from solids.registry import solid

ACROSS = "linking faces with round outlines: the walls of holes are floor, ceiling and sides"


def upright(radius, x, y, height):
    """A drill along z."""
    return rod(radius, vec(x, y, 0), height)


@solid("6.3d, 8.2", "submap", [3], ACROSS, hexes=2500)
def cross_drilled_block():
    """Figures 6.3d and 8.2: a block with round holes along all three axes that pass each other; whatever is
    swept, two of them lie in linking faces."""
    along_y, along_x = rod(7, vec(20, 0, 15), 40, vec(0, 1, 0)), rod(7, vec(0, 20, 36), 60, vec(1, 0, 0))
    return minus(box(0, 60, 0, 40, 0, 50), along_y, along_x, upright(4, 45, 33, 50)), []


@solid("6.3d", "submap", [2], ACROSS, hexes=2500)
def stepped_cross_bore():
    """Figure 6.3d: a stepped hole across a block with an upright hole; the shoulder is a ring without a straight
    edge."""
    bores = [rod(6, vec(32, 0, 25), 40, vec(0, 1, 0)), rod(10, vec(32, 0, 25), 12, vec(0, 1, 0))]
    return minus(box(0, 60, 0, 40, 0, 50), upright(4, 8, 20, 50), *bores), []


@solid("6.3d", "submap", [1], ACROSS, hexes=2500)
def blind_cross_bore():
    """Figure 6.3d: a blind hole across a block with an upright hole; its bottom is a full circle that is a
    linking face."""
    return minus(box(0, 60, 0, 40, 0, 50), upright(4, 8, 20, 50), rod(9, vec(32, 0, 25), 20, vec(0, 1, 0))), []


@solid("6.3d", "submap", [1], ACROSS, hexes=2000)
def drilled_shaft():
    """Figure 6.3d: a shaft with a cross bore: the bore's circle lies in the periodic wall."""
    return minus(rod(20, vec(0, 0, 0), 80), rod(8, vec(-30, 0, 40), 60, vec(1, 0, 0))), []


@solid("6.3b", "submap", [2], "linking faces with the round ends of a slot", hexes=2500)
def slotted_block():
    """Figure 6.3b: a lying slot with round ends across a block with an upright hole."""
    slot = stadium(vec(24, 25, 0), vec(40, 25, 0), 7)
    tool = planar(slot).extrude(vec(0, 0, 40))
    tool.rotate(vec(0, 0, 0), vec(1, 0, 0), 90)
    tool.translate(vec(0, 40, 0))
    return minus(box(0, 60, 0, 40, 0, 50), upright(4, 8, 20, 50), tool), []


@solid("6.10", "submap", [3], ACROSS, hexes=3000)
def bearing_block():
    """Figure 6.10-like mechanical part: a foot with rounded corners and two bolt holes carries an eye with a round
    top and a bore across them."""
    FOOT, ROUND, EYE, BORE, TOP = 12, 8, 18, 9, 42
    foot = rounded_plate(100, 40, ROUND, FOOT)
    y0, depth, low, high = 8, 24, 50 - EYE, 50 + EYE
    outline = Part.Wire([
        line(vec(low, y0, FOOT), vec(high, y0, FOOT)), line(vec(high, y0, FOOT), vec(high, y0, TOP)),
        arc(vec(high, y0, TOP), vec(50, y0, TOP + EYE), vec(low, y0, TOP)),
        line(vec(low, y0, TOP), vec(low, y0, FOOT))])
    eye = planar(outline).extrude(vec(0, depth, 0))
    bolts = [upright(5, x, 20, FOOT) for x in (14, 86)]
    return minus(union(foot, eye), rod(BORE, vec(50, 0, TOP), 40, vec(0, 1, 0)), *bolts), []


def rounded_plate(lx, ly, radius, height):
    """A plate with four quarter rounds."""
    q = radius * (1 - 0.5**0.5)
    corners = [((lx - radius, 0), (lx - q, q), (lx, radius)), ((lx, ly - radius), (lx - q, ly - q), (lx - radius, ly)),
               ((radius, ly), (q, ly - q), (0, ly - radius)), ((0, radius), (q, q), (radius, 0))]
    edges = []
    for k, (a, mid, b) in enumerate(corners):
        edges += [arc(vec(*a), vec(*mid), vec(*b)), line(vec(*b), vec(*corners[(k + 1) % 4][0]))]
    return extruded(Part.Wire(edges), height)
