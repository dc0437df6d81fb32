// Positions for the interior nodes of an extrusion.
//
//   1. Layers move affinely (layer_motion.h): a prediction for every node.
//   2. What the boundary leaves over is extended harmonically into the interior, on the intrinsic
//      idealised model (base_metric.h, layered_system.h): the sum of the harmonic coordinates of
//      the thesis (4.2), without forming one of them. Where nothing is left over, nothing is
//      solved.
//   3. Where the caps' meshes differ, each block chooses over which layers one passes into the
//      other (cap_transition.h).
//   4. Elements are judged; where one is inverted, its neighbourhood is untangled.
//      Then the worst ones are improved (improve.h), and in small meshes all (node_ascent.h).
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/improve.h"
#include "sweepmesh/volume/placement_method.h"
#include "sweepmesh/volume/untangle.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

struct PlacementOptions {
  PlacementMethod method = PlacementMethod::harmonic_residual;
  /// A residual of the boundary up to this part of the model's size counts as none, >= 0.
  double negligible_residual = 1e-10;
  /// Factor by which the solver reduces its own residual, in (0, 1).
  double reduction = 1e-4;
  /// Once all elements are positive, and if a residual was solved for: layers that are exact images
  /// of the caps stay so. Its `sliding` and `curved` are those below.
  ImproveOptions improve;
  /// Where the mean scaled Jacobian is below this (and layers are no exact images of the caps),
  /// nodes are moved to raise it; 0..1, 0 switches it off. Not in meshes with more elements than
  /// `raise_at_most`: it takes a hundred times as long as the placement itself.
  double raise_mean_below = 0.97;
  long raise_at_most = 20000;
  /// Attempts to untangle, each with twice the rings of neighbours; 0 leaves inverted elements
  /// alone.
  int max_attempts = 5;
  /// Fixed nodes that untangling and improving may move within a plane. Empty: none.
  std::vector<SlidingNode> sliding;
  /// Fixed nodes that improving may move on curved faces. Empty: none.
  CurvedNodes curved;
};

struct PlacementReport {
  double largest_residual = 0.0;  ///< of the boundary against the affine motion, a length
  bool was_solved = false;        ///< false: the affine motion was enough
  int n_iterations = 0;
  /// Elements that are not positive; none unless untangling is switched off or the method an older
  /// one.
  std::vector<long> inverted;
  long n_inverted_before = 0;  ///< elements that had to be untangled
  double min_scaled_jacobian = 1.0, mean_scaled_jacobian = 1.0;
};

/// `points` has a row for every node; rows of `fixed` nodes are input, the others are set. Both
/// ends of every run must be fixed (InputError); everything else may be fixed or free, runs may
/// have any ranges and columns may lie over one spot. The result does not depend on the number of
/// threads.
///
/// Linear in the number of nodes, about 120 bytes a node beside `points` while it solves. Throws
/// InputError, SolverError, Cancelled, and InvalidMeshError with the elements (numbered cell by
/// cell, from the lowest layer up) that stay inverted after untangling; `points` then hold the best
/// that was found.
PlacementReport place_interior(const Extrusion& extrusion, const std::vector<char>& fixed,
                               Points& points, const PlacementOptions& options, Context& context);

/// Hexahedra (cells of four columns), prisms (of three) and polyhedra (of more), cell by cell, from
/// the lowest layer up; no boundary and no owners. Throws InputError for more nodes than an element
/// can number.
VolumeMesh build_volume_mesh(const Extrusion& extrusion, Points points);

}  // namespace sweepmesh
