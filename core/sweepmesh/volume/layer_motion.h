// How the layers of an extrusion move: the affine motion that fits the bounding loops of every
// layer.
//
// A *block* is a connected set of runs with the same two ends. Between two levels of the extrusion
// each connected part of the cross-section has bounding loops (the columns that are fixed all the
// way); the affine map that fits them best, layer by layer, is the motion of that part. Chained
// over the levels it carries both ends of a block to each of its layers, and the mean of the two
// images, weighted with the distance to the other end, is the *prediction* of a node. Ends are met
// exactly, and so are interior nodes when the layers really move affinely (translation, rotation,
// bend, taper, scaling).
//
// Fit: least squares over the loops (thesis A.2). A planar loop says nothing of its normal; there
// the normal goes to the normal of the image, scaled as the plane is (the vectors u of functional
// H). Where loops are missing (no linking face), collinear, or so small beside the caps that their
// motion takes one end nowhere near the other, the prediction is linear between the two ends.
#pragma once

#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

/// x -> matrix x + shift.
struct AffineMap {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Point3 shift = Point3::Zero();

  Point3 operator()(const Point3& p) const { return matrix * p + shift; }
  AffineMap after(const AffineMap& first) const {
    return {matrix * first.matrix, matrix * first.shift + shift};
  }
  AffineMap inverse() const {
    const Eigen::Matrix3d m = matrix.inverse();
    return {m, -m * shift};
  }
};

/// AffineMap map that carries the points `from` best to `to` (least squares), or false when they
/// lie on a line or the map is singular. Planar sets: see above.
bool fit_affine(const std::vector<Point3>& from, const std::vector<Point3>& to, AffineMap& map);

/// Prediction of a block at one level: low * (node at the low end) + high * (at the high end) +
/// shift.
struct MotionBlend {
  Eigen::Matrix3d low, high;
  Point3 shift;
};

struct MotionBlock {
  int k_low = 0, k_high = 0;
  std::vector<AffineMap> up;       ///< per level: from the low end
  std::vector<MotionBlend> blend;  ///< per level k_low .. k_high
  bool has_loops = false;          ///< false: linear between the ends
};

struct LayerMotion {
  std::vector<MotionBlock> blocks;
  std::vector<int> cell_block;
  /// Blocks of every column in compressed rows, ascending.
  std::vector<int> column_offset, column_blocks;
};

/// Linear in the number of fixed nodes. Throws InputError when an end of a run is not fixed.
LayerMotion make_layer_motion(const Extrusion& extrusion, const std::vector<char>& fixed,
                              const Points& points, const BaseMetric& metric, ThreadTeam& team);

/// Predictions of `column` in `block` for the levels k_begin .. k_end - 1, written to `out`.
void predict(const Extrusion& extrusion, const Points& points, const MotionBlock& block, int column,
             int k_begin, int k_end, Point3* out);

}  // namespace sweepmesh
