// Carries a plane mesh to another shape of its boundary: the map from source cap to target cap.
//
//   1. harmonic extension of the boundary's motion, less its best affine part, with mean value
//      weights;
//   2. where cells come out inverted or poor, and around them, the regularised elliptic energy
//      towards the shapes of the source's cells; the neighbourhood grows while one is inverted;
//   3. cells that are still poor are raised at the cost of others (worst_first.h);
//   4. cells that are much narrower than on the source are widened (widened.h).
//
// docs/cap_mapping.md tells why this replaces the harmonic maps of facets to circular domains.
// Source: thesis section 3.3 (harmonic map); Garanzha et al. 2021 (foldover-free energy).
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// p -> leftCols<2>() * p + col(2).
using Affine = Eigen::Matrix<double, 2, 3>;
/// The affine map that takes the points of one row nearest to those of the other (least squares).
Affine best_affine(const std::vector<Point2>& from, const std::vector<Point2>& to);

struct MapOptions {
  Metric source_metric;  ///< surface that the source plane stands for
  Metric target_metric;  ///< surface that the target plane stands for
  /// Cells with a smaller scaled Jacobian on the target are improved, -1..1; -1 improves none that
  /// is valid.
  double poor = 0.5;
  int rings = 3;  ///< cells around a poor one that may move with it, >= 0; four times as many while
                  ///< that is not enough
  /// Sides of cells shorter than this part of what they are on the source are lengthened where that
  /// costs no angles (widened.h), 0..1; 0 leaves them.
  double squeezed = 0.25;
};

struct PlanarMap {
  std::vector<Point2> points;     ///< of all nodes on the target
  PlanarQuality harmonic, final;  ///< on the target, after the first and after the last step
};

/// The first step alone, whether cells come out inverted or not.
std::vector<Point2> harmonic_map(const PlanarMesh& source, const std::vector<Point2>& boundary,
                                 const Metric& source_metric = {});

/// Positions on the target of the nodes of `source`, whose first n_boundary nodes go to `boundary`.
/// The target is counterclockwise as the source is (mirror it before, if it is looked at from
/// behind). Throws InputError when `boundary` has another length than n_boundary, InvalidMeshError
/// when cells stay inverted. Cost: one sparse factorisation, and some more of the size of the poor
/// neighbourhoods.
PlanarMap map_planar(const PlanarMesh& source, const std::vector<Point2>& boundary,
                     const MapOptions& options, const Context& context);

}  // namespace sweepmesh
