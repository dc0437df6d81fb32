// Polygons from triangles: the dual of a triangle mesh on a boundary that is given.
//
//      o-----o-----o
//      |   .-+-.   |    o  boundary nodes        +  centres of triangles
//      o--+     +--o
//      |   '-+-'   |
//      o-----o-----o
//
// Every inside node of the triangles becomes a cell whose corners are the centres of the triangles
// around it, mostly a hexagon. The boundary's own nodes stay, and no others come to it: a boundary
// edge is the foot of a cell. Where n cells are to meet at a boundary node, it is linked with the
// centres of the n - 1 triangles of its fan that lie in the directions which divide its angle into
// n equal parts.
//
// The graph of boundary edges, edges from centre to centre, and links is plane, with the order of
// edges at each node told by the triangles; its faces are the cells. A corner of a convex cell has
// at least three edges, unless it is the boundary's: centres with one edge are taken away with it,
// those with two are passed over, and what hangs on a single edge or lies between two equal ones
// goes as well. A triangle inside that has large cells around it becomes a node. Every plane graph
// that is left is as good as its smoothing: with links in number, it is three-connected and has
// convex drawings (Tutte, How to draw a graph, 1963).
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// How many cells are to meet at each boundary node, from its interior angles (radians), a row for
/// each shape that the boundary takes: the largest counts. Up to 130 degrees one cell, up to 250
/// two, else three; so a straight side has square corners and a hexagonal hole's corner two of 120.
std::vector<int> polygons_at_nodes(const std::vector<std::vector<double>>& angles);

/// The dual of a valid triangle mesh: the same boundary nodes and edges, inside nodes at centres of
/// triangles. `wished`: cells at each boundary node, >= 1; fewer where its fan has fewer triangles,
/// more where a loop would have no firm hold on the others. Every cell is a simple cycle of nodes;
/// most are convex only after smoothing. Nothing where the domain falls apart (a hole on a single
/// bridge of triangles): a finer mesh may have one. Cost: n log n.
std::optional<PlanarMesh> polygon_dual(const PlanarMesh& triangles, const std::vector<int>& wished);

/// Cuts every cell with a corner of 180 degrees or more from there to the corner that leaves the
/// better parts. Triangles stay as they are.
PlanarMesh with_reflex_corners_cut(const PlanarMesh& mesh, const Metric& metric = {});

}  // namespace sweepmesh
