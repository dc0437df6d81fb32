// White's conditions for sweepability (thesis A.7), as the reference that the assessment is
// compared with.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/ids.h"
#include "sweepmesh/scheme/sweep_problem.h"

namespace sweepmesh {

/// Theorem A.1: which of its conditions hold. All three are necessary for sweeps with linking
/// faces, and not sufficient.
struct WhiteConditions {
  /// (a) The linking faces can be mapped or submapped by their angles and form chains.
  bool has_chains = false;
  /// (b) Leaving a contiguous set of caps over its END edges, or over its CORNER edges, always goes
  /// the same way in the common ij parameters of the linking faces.
  bool agrees_over_equal_edges = false;
  /// (c) Over its END edges and over its CORNER edges opposite ways.
  bool opposes_over_unequal_edges = false;
  std::vector<std::string> entities;  ///< at fault, where one does not hold

  bool hold() const { return has_chains && agrees_over_equal_edges && opposes_over_unequal_edges; }
};

/// `caps` are the sources and targets together (White does not tell them apart); all other faces
/// link. Vertex types are the nearest to the angles, edges are END, SIDE or CORNER by the nearest
/// to their dihedral angle.
///
/// Where it goes wrong: a radial sweep has no linking face, so (a) fails although it can be swept;
/// and caps without edges to linking faces, like a closed void inside of a swept block, or caps
/// that are not homeomorphic under the go-through operation meet all conditions although nothing
/// can be swept. Linear in the number of edges.
WhiteConditions white_conditions(const SweepProblem& problem, const std::vector<FaceId>& caps);

}  // namespace sweepmesh
