// Solids for the scheme stage, made in code. OpenCASCADE stays inside scheme_solids.cpp.
#pragma once

#include <vector>

#include "solids.h"

namespace sweepmesh::test {

/// A plate whose outline has a chamfer, a quarter round, a fillet, a half-round tab and a
/// three-quarter bulb, with a round hole.
Model rounded_plate();
/// Balls of the given radii cut out of a ball of radius 30, at x = -15, 15, ... or in the middle
/// where there is one.
Model hollow_ball(int n_voids);
/// A disc of radius 25 and height 10 below z = 0, half a ring standing on it.
Model disc_with_handle();
/// A box of 60 x 50 x 40 with a box-shaped void in the middle.
Model hollow_box();
/// A box of 60 x 50 x 40 with a ball cut out of its middle.
Model box_with_ball_void();
/// A tube of square section with a square bore that turns by a right angle in a mitre.
Model mitred_tube();
/// A plate with a slot cut into its top that is wider below (a dovetail), so that walls meet at 60
/// degrees.
Model dovetail();
/// A block with a round hole that rises, bends over and comes back down before it leaves at the
/// top.
Model block_with_returning_hole();
/// A block with one edge cut off: two of its faces have five corners.
Model slanted_block();
/// A pyramid over a rectangle, its tip over an edge of it, with a notch across its slanted side:
/// two triangles on either side of that touch at the tip only.
Model notched_pyramid();
/// A box of which one face is missing.
Model open_box();
/// Columns of the given heights (> 0) on an n x n grid, one solid of the coplanar faces merged.
Model terraces(const std::vector<std::vector<double>>& heights);
/// A box with four quadrants above and below.
Model quartered_box();

}  // namespace sweepmesh::test
