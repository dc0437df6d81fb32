"""Random prisms whose walls move between their caps: twisted, bent, leaning, with holes that turn, wander and wind.

    solid = make("braid", 7)         # the same seed, the same solid
    solid.shape, solid.sources, solid.targets, solid.numbers

Each family has a motion that grows from nothing to what no mesh can follow, so about half of its solids can be meshed.
What the motion was is in `numbers`, for tables.
"""

import dataclasses
import math
import random

import Part
from solids.kit import (
    Z_UP,
    at_height,
    box,
    minus,
    oblique_rod,
    polygon_prism,
    regular,
    ring_prism,
    steps,
    turned,
    union,
    vec,
)

SECTIONS = 24
"""Of a stack; enough that it follows a full turn."""


@dataclasses.dataclass
class Moved:
    """One solid of a family."""

    shape: object
    sources: list
    """Numbers of the faces at one end, from 1."""
    targets: list
    numbers: dict


def make(family, seed):
    """The solid of a family and a seed; a motion that cuts the solid in two is drawn anew."""
    source = random.Random(f"{family} {seed}")
    while True:
        try:
            shape, up, numbers = FAMILIES[family](source)
        except (ValueError, Part.OCCError):
            continue
        if shape.isValid() and shape.Volume > 1.0:
            return Moved(shape, *ends(shape, up), numbers)


def ends(shape, up):
    """Numbers of the plane faces that look along +`up[1]` and of those that look along -`up[0]`."""
    looks = [
        (number, face.normalAt(0, 0))
        for number, face in enumerate(shape.Faces, 1)
        if isinstance(face.Surface, Part.Plane)
    ]
    return (
        [number for number, normal in looks if normal.dot(up[1]) > 0.999],
        [number for number, normal in looks if normal.dot(up[0]) < -0.999],
    )


UPRIGHT = (Z_UP, Z_UP)


def slot(long, short):
    """Corners of a rectangle around the origin."""
    return [(-long / 2, -short / 2), (long / 2, -short / 2), (long / 2, short / 2), (-long / 2, short / 2)]


def disc(radius, x, y, z):
    """Poles of a round ring."""
    angles = [2 * math.pi * i / 12 for i in range(12)]
    return [vec(x + radius * math.cos(a), y + radius * math.sin(a), z) for a in angles]


def block(side, height):
    """An upright block around the z axis."""
    return box(-side / 2, side / 2, -side / 2, side / 2, 0, height)


def slot_turns(source):
    """A rectangular hole turns by up to 300 degrees."""
    height, long = source.choice((30, 60, 90)), source.uniform(16, 50)
    short, turn = source.uniform(6, min(20, long)), source.uniform(0, 300)
    hole = polygon_prism([at_height(turned(slot(long, short), turn * t), height * t) for t in steps(SECTIONS)])
    return minus(block(60, height), hole), UPRIGHT, {"long": long, "short": short, "height": height, "turn": turn}


def slot_turns_in_steps(source):
    """The same, with a boss on top and one below, so sources and targets lie on two levels each."""
    height, long = source.choice((30, 60)), source.uniform(16, 46)
    short, turn = source.uniform(6, min(20, long)), source.uniform(0, 260)
    hole = polygon_prism([at_height(turned(slot(long, short), turn * t), height * t) for t in steps(SECTIONS)])
    body = union(block(70, height), box(-35, -26, -35, 35, height, height + 10), box(-35, 35, 27, 35, -10, 0))
    return minus(body, hole), UPRIGHT, {"long": long, "short": short, "height": height, "turn": turn}


def leaning_path(lean, height, width=0.15):
    """(x, z, angle of the way) of a path that goes up, leans over by `lean` in the middle and goes up again, around x = 0,
    and the least radius of its bends. `width` is the share of the way that leans. ValueError where it does not
    get up, or leaves the heights between its ends."""
    count = 240
    angles = [lean * math.exp(-(((i + 0.5) / count - 0.5) / width) ** 2) for i in range(count)]
    rise = sum(math.cos(a) for a in angles)
    if rise < 0.15 * count:
        raise ValueError("the path gets nowhere")
    unit = height / rise
    path = [(0.0, 0.0, 0.0)]
    for angle in angles:
        x, z, _ = path[-1]
        path.append((x + unit * math.sin(angle), z + unit * math.cos(angle), angle))
    path[-1] = (path[-1][0], height, 0.0)
    if min(z for _, z, _ in path) < 0 or max(z for _, z, _ in path) > height:
        raise ValueError("the path leaves the solid")
    far = path[-1][0] / 2
    radius = unit / max(abs(b - a) for a, b in zip(angles, angles[1:]))
    return [(x - far, z, a) for x, z, a in path[:: count // (2 * SECTIONS)]], radius


def leaning_hole(path, radius, width, room, bulge):
    """A round hole along a path, in a block (or a barrel, with a bulge) with some room beyond the path's ends."""
    height, long = path[-1][1], 2 * max(abs(x) for x, _, _ in path) + room
    rings = [
        [vec(x + p.x * math.cos(a), p.y, z - p.x * math.sin(a)) for p in disc(radius, 0, 0, 0)] for x, z, a in path
    ]
    hole = ring_prism(rings)
    if bulge == 0:
        return minus(box(-long / 2, long / 2, -width / 2, width / 2, 0, height), hole)
    outer = []
    for t in steps(8):
        grow = bulge * 4 * t * (1 - t)
        outer.append(at_height(slot(long + 2 * grow, width + 2 * grow), height * t))
    return minus(polygon_prism(outer), hole)


def winding_hole(source):
    """A round hole leans over by up to 165 degrees on its way up, so it may run back, in a block or a barrel."""
    lean = math.radians(source.uniform(30, 165))
    path, least = leaning_path(lean, 70, source.uniform(0.12, 0.3))
    radius, width = min(source.uniform(3, 7), 0.6 * least), source.choice((30, 50))
    bulge, room = source.choice((0, 9)), source.uniform(24, 50)
    drop = max(a[1] - b[1] for i, a in enumerate(path) for b in path[i:])
    numbers = {"radius": radius, "lean": math.degrees(lean), "width": width, "bulge": bulge, "drop": drop}
    return leaning_hole(path, radius, width, room, bulge), UPRIGHT, numbers


def overhang(source):
    """A round bar whose wall goes outwards all around, leaning by up to 165 degrees, so it may hang over."""
    height, lean = 60, math.radians(source.uniform(30, 165))
    path, _ = leaning_path(lean, height, source.uniform(0.12, 0.3))
    inner = source.uniform(8, 25) - path[0][0]
    rings = [disc(inner + x, 0, 0, z) for x, z, _ in path]
    return ring_prism(rings), UPRIGHT, {"lean": math.degrees(lean), "inner": inner + path[0][0]}


def leaning_wall(source):
    """One wall of a barrel goes outwards, leaning by up to 165 degrees."""
    height, lean, bulge = 60, math.radians(source.uniform(30, 165)), source.uniform(5, 10)
    path, _ = leaning_path(lean, height, source.uniform(0.12, 0.3))
    width, long = source.uniform(20, 50), source.uniform(20, 50)
    sections = []
    for i, (x, z, _) in enumerate(path):
        t = i / (len(path) - 1)
        grow, wall = bulge * 4 * t * (1 - t), long + x - path[0][0]
        y, up = width / 2 + grow, height * t
        sections.append([vec(-grow, -y, up), vec(wall, -y, z), vec(wall, y, z), vec(-grow, y, up)])
    return polygon_prism(sections), UPRIGHT, {"lean": math.degrees(lean), "width": width, "long": long}


def braid(source):
    """Two round holes wind around each other by up to 300 degrees."""
    height, radius = source.choice((30, 60, 90)), source.uniform(4, 8)
    off, turn = source.uniform(radius + 2, 22), source.uniform(0, 300)
    tools = []
    for start in (0, 180):
        rings = []
        for t in steps(SECTIONS):
            a = math.radians(start + turn * t)
            rings.append(disc(radius, off * math.cos(a), off * math.sin(a), height * t))
        tools.append(ring_prism(rings))
    return minus(block(70, height), *tools), UPRIGHT, {"radius": radius, "off": off, "height": height, "turn": turn}


def moving_hole(source):
    """A round hole goes from near one wall to near another."""
    height, radius, other = source.choice((12, 25, 50)), source.uniform(4, 10), source.uniform(4, 10)
    reach = 30 - max(radius, other) - source.uniform(1, 10)
    a, b = source.uniform(0, 2 * math.pi), source.uniform(0, 2 * math.pi)
    low = vec(reach * math.cos(a), reach * math.sin(a), 0)
    high = vec(reach * math.cos(b), reach * math.sin(b), height)
    far = math.hypot(high.x - low.x, high.y - low.y)
    hole = oblique_rod(radius, low, other, high)
    return minus(block(60, height), hole), UPRIGHT, {"radius": radius, "height": height, "far": far}


def bar_turns(source):
    """A bar without holes turns by up to 500 degrees."""
    height, width, long, turn = source.choice((20, 40, 80)), source.uniform(4, 30), source.uniform(20, 60), source.uniform(0, 500)
    bar = polygon_prism([at_height(turned(slot(long, width), turn * t), height * t) for t in steps(SECTIONS)])
    return bar, UPRIGHT, {"width": width, "long": long, "height": height, "turn": turn}


def on_arc(points, angle, radius):
    """Points of a section (x outwards) at an angle of a bend around the y axis."""
    c, s = math.cos(angle), math.sin(angle)
    return [vec(radius - (radius - x) * c, y, (radius - x) * s) for x, y in points]


def bend_with_hole(source):
    """A bent square bar whose hole turns and goes sideways."""
    angle, radius, side = math.radians(source.uniform(20, 200)), source.uniform(34, 60), 40
    hole, turn, aside = source.uniform(8, 18), source.uniform(0, 260), source.uniform(-8, 8)
    outer = polygon_prism([on_arc(slot(side, side), angle * t, radius) for t in steps(SECTIONS)])
    inner = polygon_prism([
        on_arc([(x + aside * t, y) for x, y in turned(regular(4, hole), turn * t)], angle * t, radius)
        for t in steps(SECTIONS)
    ])  # fmt: skip
    up = (Z_UP, vec(math.sin(angle), 0, math.cos(angle)))
    return minus(outer, inner), up, {"bend": math.degrees(angle), "hole": hole, "turn": turn}


def wave(source, size):
    """A smooth random function on 0..1 that begins at 0."""
    terms = [(source.gauss(0, size / (n + 1)), source.uniform(0, 2 * math.pi), n + 1) for n in range(3)]
    return lambda t: sum(a * (math.sin(math.pi * n * t + p) - math.sin(p)) for a, p, n in terms)


def random_motion(source):
    """A block with one to three holes of four to seven corners, each of which moves, turns, grows and tilts."""
    height, strength, tools = source.choice((30, 60)), source.uniform(0.1, 1.6), []
    x, y, z = (wave(source, 10 * strength) for _ in range(3))
    spots = source.sample([(-18, -18), (18, -18), (-18, 18), (18, 18), (0, 0)], source.randint(1, 3))
    for cx, cy in spots:
        corners = regular(source.randint(4, 7), source.uniform(8, 16))
        dx, dy = wave(source, 6 * strength), wave(source, 6 * strength)
        turn, lean = wave(source, 80 * strength), wave(source, 0.5 * strength)
        sections = []
        for t in steps(SECTIONS):
            slope = lean(t) * math.sin(math.pi * t)
            ring = [(px + cx + dx(t), py + cy + dy(t)) for px, py in turned(corners, turn(t))]
            sections.append([vec(px, py, height * t + slope * (px - cx - dx(t))) for px, py in ring])
        tools.append(polygon_prism(sections))
    outer = polygon_prism([at_height(turned(slot(70, 70), 4 * z(t)), height * t) for t in steps(SECTIONS)])
    return minus(outer, *tools), UPRIGHT, {"strength": strength, "holes": len(spots), "height": height}


FAMILIES = {
    "slot_turns": slot_turns,
    "slot_turns_in_steps": slot_turns_in_steps,
    "winding_hole": winding_hole,
    "overhang": overhang,
    "leaning_wall": leaning_wall,
    "braid": braid,
    "moving_hole": moving_hole,
    "bar_turns": bar_turns,
    "bend_with_hole": bend_with_hole,
    "random_motion": random_motion,
}
