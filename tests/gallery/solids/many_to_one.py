"""Many sources, one target."""

from solids.kit import (
    at_height,
    box,
    extruded,
    minus,
    polygon,
    polygon_prism,
    regular,
    rod,
    stadium,
    steps,
    turned,
    union,
    vec,
)
from solids.registry import axial, solid


@solid("4.4", "M-1", [0], "the hole's floor is a source at an inner level", hexes=3500)
def twisted_blind_hole():
    """Figure 4.4: a rectangular blind hole turns by 75 degrees; the sweep starts from its
    floor as well as from the top face, two levels in all."""
    SIDE, HEIGHT, DEPTH, LONG, SHORT, TWIST = 60, 50, 34, 30, 12, 75
    block = box(-SIDE / 2, SIDE / 2, -SIDE / 2, SIDE / 2, 0, HEIGHT)
    slot = [(-LONG / 2, -SHORT / 2), (LONG / 2, -SHORT / 2),
            (LONG / 2, SHORT / 2), (-LONG / 2, SHORT / 2)]
    hole = polygon_prism([at_height(turned(slot, TWIST * t), HEIGHT - DEPTH * t)
                          for t in steps(10)])
    shape = minus(block, hole)
    return shape, [axial(shape)]


@solid("1.2", "M-1", [0], "bosses on one plate", hexes=3500)
def stepped_boss():
    """Figure 1.2b: bosses of different height and outline on one plate, one carrying
    another; every boss outline must be found in the target's mesh."""
    LX, LY, PLATE = 90, 60, 10
    shape = union(
        box(0, LX, 0, LY, 0, PLATE),
        rod(11, vec(18, 40, PLATE), 16),
        box(40, 60, 12, 34, PLATE, 38),
        extruded(polygon(regular(6, 16, 0.2, (76, 44)), PLATE), 9),
        rod(5, vec(18, 40, PLATE + 16), 12),
        extruded(stadium(vec(14, 14, PLATE), vec(26, 14, PLATE), 6), 6))
    return shape, [axial(shape)]


@solid("1.2", "M-1", [0], "three levels above one target")
def nsurface():
    """Figure 1.2b: three source faces at three levels over one target; the step edges meet
    in a T, so no direction is a plain extrusion."""
    SIDE, LOW, MIDDLE, HIGH, SPLIT_X, SPLIT_Y = 60, 12, 24, 40, 34, 27
    shape = union(box(0, SIDE, 0, SIDE, 0, LOW),
                  box(0, SIDE, SPLIT_Y, SIDE, LOW, MIDDLE),
                  box(0, SPLIT_X, SPLIT_Y, SIDE, MIDDLE, HIGH))
    return shape, [axial(shape)]


@solid("8.4", "M-1", [0], "the floors of the blind holes are sources", hexes=4500,
       note="2 x 2 cell of a spacer; the assembly in the figure has many more holes")
def grid_spacer():
    """Figure 8.4 (and 4.1): a duct cell with four blind twisted cross-shaped holes; thin
    blades with few nodes next to a large plain boundary."""
    PITCH, CELLS, HEIGHT, DEPTH, ARM, HALF, TWIST = 22, 2, 36, 24, 8, 1.8, 40
    cross = [(ARM, -HALF), (ARM, HALF), (HALF, HALF), (HALF, ARM), (-HALF, ARM), (-HALF, HALF),
             (-ARM, HALF), (-ARM, -HALF), (-HALF, -HALF), (-HALF, -ARM), (HALF, -ARM),
             (HALF, -HALF)]
    duct = box(0, PITCH * CELLS, 0, PITCH * CELLS, 0, HEIGHT)
    holes = []
    for i in range(CELLS):
        for j in range(CELLS):
            cx, cy = (i + 0.5) * PITCH, (j + 0.5) * PITCH
            turn = TWIST if (i + j) % 2 == 0 else -TWIST
            holes.append(polygon_prism(
                [[vec(cx + x, cy + y, HEIGHT - DEPTH * t) for x, y in turned(cross, turn * t)]
                 for t in steps(6)]))
    shape = minus(duct, *holes)
    return shape, [axial(shape)]
