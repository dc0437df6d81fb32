// Harmonic extension of boundary values over a plane mesh, with weights that are always positive.
//
// Every inside node becomes a convex combination of its neighbours along cell edges,
//
//   x_i = sum_j w_ij x_j / sum_j w_ij,   w_ij = (tan(a/2) + tan(b/2)) / |x_j - x_i|,
//
// with a, b the angles at i on either side of the edge: mean value weights, a discrete Laplacian
// that has no negative weight on any mesh (cotangents have) and reproduces linear functions
// exactly. Source: M. Floater, Mean value coordinates, Comput. Aided Geom. Design 20 (2003).
#pragma once

#include <vector>

#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// Values at all nodes: those of the first `boundary.size()` nodes are given, each other one is the
/// mean value combination of its neighbours on `mesh` (angles and lengths seen through `metric`). A
/// node with a straight or reflex angle in a cell, where the weights have no meaning, weighs its
/// neighbours alike. Throws SolverError when a node has no chain of edges to the boundary. Cost:
/// one sparse factorisation.
std::vector<Point2> harmonic_extension(const PlanarMesh& mesh, const std::vector<Point2>& boundary,
                                       const Metric& metric = {});

}  // namespace sweepmesh
