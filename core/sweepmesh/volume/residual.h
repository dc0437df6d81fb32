// What the boundary leaves over of the affine motion, and its harmonic extension.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/floats.h"
#include "sweepmesh/volume/layer_motion.h"
#include "sweepmesh/volume/layered_system.h"

namespace sweepmesh {

/// Columns that a thread takes at a time.
inline long columns_per_chunk(const Extrusion& extrusion) {
  return ThreadTeam::grain_of(extrusion.n_columns(), 16, 256);
}

/// Position minus prediction, a row for each level of a block in one of its columns.
struct ColumnResidual {
  int block = -1;
  std::vector<Point3> value;  ///< per level k_low .. k_high of the block
};

/// Residuals of all columns that have any: those with a fixed node between the ends of a block, and
/// those that lie in several blocks, whose predictions differ. Per column, empty or one for each
/// block.
using Residuals = std::vector<std::vector<ColumnResidual>>;

/// Sets the free nodes of `points` to their predictions (the mean over blocks where there are
/// several).
void set_predictions(const Extrusion& extrusion, const LayerMotion& motion,
                     const std::vector<char>& fixed, Points& points, ThreadTeam& team);

/// `points` as set_predictions leaves them.
Residuals find_residuals(const Extrusion& extrusion, const LayerMotion& motion,
                         const std::vector<char>& fixed, const Points& points, ThreadTeam& team);

double largest(const Residuals& residuals);

/// Right-hand side - sum over blocks of A_block residual_block, times `scale`, in the layout of
/// `system`: so the corrections of all blocks together leave no force at a free node.
Floats right_hand_side(const Extrusion& extrusion, const CellsOfColumns& cells,
                       const LayerMotion& motion, const BaseMetric& metric,
                       const Residuals& residuals, const LayeredSystem& system, double scale,
                       ThreadTeam& team);

}  // namespace sweepmesh
