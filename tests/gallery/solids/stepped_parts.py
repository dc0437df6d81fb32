"""Parts with caps on several levels, as they are drawn for real: housings, flanges, brackets, terraces with draft or fillets.

`PARTS` gives a function for each name; all stand along z. Walls of some are divided, each side in its own way.
"""

import math

import Part

from solids.kit import box, polygon_prism, rod, vec


def fused(*shapes):
    """One solid, its faces unified."""
    out = shapes[0]
    for shape in shapes[1:]:
        out = out.fuse(shape)
    return out.removeSplitter().Solids[0]


def cut(shape, *tools):
    for tool in tools:
        shape = shape.cut(tool)
    return shape.Solids[0]


def with_fillets(shape, height, radius, inside):
    """Rounded along the edges at a height that lie inside a rectangle (x0, x1, y0, y1)."""
    x0, x1, y0, y1 = inside

    def is_meant(edge):
        b = edge.BoundBox
        level = abs(b.ZMin - height) + abs(b.ZMax - height) < 1e-6
        return level and b.XMin > x0 and b.XMax < x1 and b.YMin > y0 and b.YMax < y1

    return shape.makeFillet(radius, [edge for edge in shape.Edges if is_meant(edge)])


def with_walls_divided(shape, *faces):
    """The solid with its own faces divided along the outlines of plane faces that lie on them."""
    pieces, _ = shape.generalFuse(list(faces))
    return max(pieces.Solids, key=lambda solid: solid.Volume)


def rectangle(*corners):
    points = [vec(*corner) for corner in corners]
    return Part.Face(Part.makePolygon(points + points[:1]))


def across_x(x, y0, y1, z0, z1):
    return rectangle((x, y0, z0), (x, y1, z0), (x, y1, z1), (x, y0, z1))


def across_y(y, x0, x1, z0, z1):
    return rectangle((x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1))


def stepped_block():
    return fused(box(0, 40, 0, 30, 0, 30), box(10, 25, 10, 20, 30, 40))


def housing():
    steps = fused(box(0, 80, 0, 60, 0, 12), box(10, 70, 10, 50, 12, 30), box(25, 55, 20, 40, 30, 42))
    return cut(steps, box(15, 65, 15, 45, -1, 20), rod(6, vec(40, 30), 60))


def flange_with_bosses_on_both_sides():
    disc = fused(rod(40, vec(0, 0), 10), rod(22, vec(0, 0, 10), 15), rod(16, vec(0, 0, -12), 12))
    disc = cut(disc, rod(10, vec(0, 0, -20), 60), rod(30, vec(0, 0, 7), 3).cut(rod(26, vec(0, 0), 20)))
    angles = [i * math.pi / 3 for i in range(6)]
    return cut(disc, *(rod(3, vec(34 * math.cos(a), 34 * math.sin(a), -5), 30) for a in angles))


def bracket_with_ribs():
    ribs = (box(8, 50, 12, 17, 8, 26), box(8, 50, 43, 48, 8, 26))
    return cut(
        fused(box(0, 80, 0, 60, 0, 8), box(0, 8, 0, 60, 8, 40), *ribs),
        rod(5, vec(65, 15, -1), 20),
        rod(5, vec(65, 45, -1), 20),
    )


def terraces_with_holes():
    steps = fused(box(0, 80, 0, 60, 0, 10), box(5, 60, 5, 50, 10, 18), box(10, 40, 10, 40, 18, 26))
    places = ((5, 25, 25), (5, 50, 30), (4, 70, 30), (6, 40, 40))
    return cut(steps, *(rod(radius, vec(x, y, -1), 40) for radius, x, y in places))


def bosses_with_draft():
    cones = Part.makeCone(14, 11, 18, vec(25, 30, 12)), Part.makeCone(12, 10, 10, vec(58, 30, 12))
    return fused(box(0, 80, 0, 60, 0, 12), *cones)


def terrace_with_draft():
    low, high = (15, 65, 12, 48), (17, 63, 14, 46)
    sections = [[vec(a, c, z), vec(b, c, z), vec(b, d, z), vec(a, d, z)] for (a, b, c, d), z in ((low, 12), (high, 28))]
    return fused(box(0, 80, 0, 60, 0, 12), polygon_prism(sections))


def terrace_with_fillets():
    return with_fillets(fused(box(0, 80, 0, 60, 0, 12), box(20, 60, 15, 45, 12, 30)), 12, 3, (1, 79, 1, 59))


def bosses_with_fillets():
    rods = rod(12, vec(30, 30, 12), 20), rod(8, vec(60, 30, 12), 12)
    return with_fillets(fused(box(0, 80, 0, 60, 0, 12), *rods), 12, 2.5, (1, 79, 1, 59))


def slotted_block():
    block = fused(box(0, 80, 0, 60, 0, 20), rod(10, vec(60, 30, 20), 15))
    return cut(block, box(10, 40, -1, 61, 8, 12), box(15, 35, 20, 40, 15, 25))


def boss_on_curved_cap():
    arch = box(0, 80, 0, 60, 0, 20).common(rod(200, vec(40, -10, -180), 80, vec(0, 1))).Solids[0]
    return fused(arch, rod(10, vec(25, 30, 5), 25))


def walls_divided_at_two_heights():
    return with_walls_divided(stepped_block(), across_x(0, 0, 30, 0, 12), across_x(40, 0, 30, 0, 20))


def one_wall_divided_at_two_heights():
    return with_walls_divided(stepped_block(), across_x(0, 0, 15, 0, 12), across_x(0, 15, 30, 0, 20))


def walls_divided_at_two_places():
    return with_walls_divided(stepped_block(), across_y(0, 0, 14, 0, 30), across_y(30, 0, 25, 0, 30))


def wall_with_a_patch():
    return with_walls_divided(stepped_block(), across_x(0, 10, 20, 10, 20))


def terraces_with_divided_walls():
    steps = fused(box(0, 40, 0, 30, 0, 20), box(0, 20, 0, 30, 20, 32), box(25, 40, 0, 30, -8, 0))
    return with_walls_divided(steps, across_x(0, 0, 30, 0, 25), across_x(40, 0, 30, -8, 9))


PARTS = {
    function.__name__: function
    for function in (
        housing,
        flange_with_bosses_on_both_sides,
        bracket_with_ribs,
        terraces_with_holes,
        bosses_with_draft,
        terrace_with_draft,
        terrace_with_fillets,
        bosses_with_fillets,
        slotted_block,
        boss_on_curved_cap,
        walls_divided_at_two_heights,
        one_wall_divided_at_two_heights,
        walls_divided_at_two_places,
        wall_with_a_patch,
        terraces_with_divided_walls,
    )
}
