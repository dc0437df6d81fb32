#include "sweepmesh/volume/layer_motion.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <string>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/volume/slabs.h"

namespace sweepmesh {
namespace {

/// Directions with less than this part of the largest variance (squared) count as none.
constexpr double flat_variance = 64.0 * std::numeric_limits<double>::epsilon();

/// Of columns or cells in a chunk of work.
constexpr long few = 1L << 7, many = 1L << 10;

Point3 mean_of(const std::vector<Point3>& points) {
  Point3 sum = Point3::Zero();
  for (const Point3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Fits affine maps of one set of points.
class AffineFit {
 public:
  explicit AffineFit(std::vector<Point3> from) : from_(std::move(from)) {
    if (from_.size() < 3) return;
    center_ = mean_of(from_);
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (Point3& p : from_) {
      p -= center_;
      m += p * p.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(m);  // ascending variances
    axes_ = axes.eigenvectors();
    variance_ = axes.eigenvalues();
    // The frame is right-handed, so that the image of the normal lies on the proper side.
    side_ = axes_.determinant() > 0.0 ? 1.0 : -1.0;
    is_spread_ = variance_[1] > flat_variance * variance_[2];
  }

  /// Map that carries the points best to to(0), to(1) ...; false if there is none.
  template <class To>
  bool find(To&& to, AffineMap& map) const {
    if (!is_spread_) return false;
    Point3 d = Point3::Zero();
    for (std::size_t i = 0; i < from_.size(); ++i) d += to(i);
    d /= static_cast<double>(from_.size());
    Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from_.size(); ++i) f += (to(i) - d) * from_[i].transpose();
    Eigen::Matrix3d image;
    for (int i = 1; i < 3; ++i) image.col(i) = f * axes_.col(i) / variance_[i];
    const Point3 normal = side_ * Point3(image.col(1)).cross(Point3(image.col(2)));
    if (!(normal.norm() > 0.0)) return false;
    const Point3 wanted = normal / std::sqrt(normal.norm());
    // Functional H: one more pair of vectors, as heavy as the narrower direction of the plane.
    image.col(0) = (f * axes_.col(0) + variance_[1] * wanted) / (variance_[0] + variance_[1]);
    map.matrix = image * axes_.transpose();
    map.shift = d - map.matrix * center_;
    return std::abs(map.matrix.determinant()) > 0.0;
  }

 private:
  std::vector<Point3> from_;  ///< relative to their center
  Point3 center_ = Point3::Zero(), variance_ = Point3::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  double side_ = 1.0;
  bool is_spread_ = false;  ///< not on a line
};

/// Per part of a slab: maps from its low level to each of its layers; empty where no fit exists.
using SlabMotion = std::vector<std::vector<AffineMap>>;

std::vector<AffineMap> fit_layers(const Extrusion& x, const Points& points, const Slab& slab,
                                  const std::vector<int>& loop, ThreadTeam& team) {
  constexpr long points_per_chunk = 1L << 10;
  std::vector<Point3> from;
  for (const int c : loop) from.push_back(points.row(x.node(c, slab.k_low)));
  const AffineFit fit(std::move(from));
  const int n_layers = slab.k_high - slab.k_low;
  std::vector<AffineMap> motion(n_layers + 1);
  std::vector<char> is_found(n_layers);
  const long n_points = static_cast<long>(loop.size());
  const long grain = std::max(1L, points_per_chunk / (n_points + 1));
  team.for_chunks(n_layers, grain, [&](long begin, long end, long) {
    for (int k = static_cast<int>(begin); k < end; ++k) {
      const auto to = [&](std::size_t i) -> Point3 {
        return points.row(x.node(loop[i], slab.k_low + k + 1));
      };
      is_found[k] = fit.find(to, motion[k + 1]);
    }
  });
  if (std::find(is_found.begin(), is_found.end(), 0) != is_found.end()) return {};
  return motion;
}

std::vector<SlabMotion> fit_slabs(const Extrusion& x, const Points& points,
                                  const std::vector<Slab>& slabs, ThreadTeam& team) {
  std::vector<SlabMotion> motions;
  for (const Slab& slab : slabs) {
    SlabMotion& motion = motions.emplace_back();
    for (const std::vector<int>& loop : slab.loops)
      motion.push_back(fit_layers(x, points, slab, loop, team));
  }
  return motions;
}

/// Maps from the low end of a block to each of its levels; empty where a slab has no fit.
std::vector<AffineMap> chain(const std::vector<Slab>& slabs, const std::vector<SlabMotion>& motions,
                             const MotionBlock& block, int column) {
  std::vector<AffineMap> maps(1);
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    if (slabs[s].k_high <= block.k_low || slabs[s].k_low >= block.k_high) continue;
    const std::vector<AffineMap>& motion = motions[s][slabs[s].part[column]];
    if (motion.empty()) return {};
    const AffineMap start = maps.back();
    for (std::size_t k = 1; k < motion.size(); ++k) maps.push_back(motion[k].after(start));
  }
  return maps;
}

/// Whether the map from the low end of each block to its high end says more of the motion than no
/// map: loops that are small beside their caps say nothing of what lies far from them.
std::vector<char> are_telling(const std::vector<std::vector<AffineMap>>& maps, const Extrusion& x,
                              const Points& points, const LayerMotion& motion, ThreadTeam& team) {
  constexpr double most_off = 0.5;  // of the way
  struct Lengths {
    std::vector<double> off, way;
  };
  const Lengths none = {std::vector<double>(maps.size(), 0.0),
                        std::vector<double>(maps.size(), 0.0)};
  const auto add_column = [&](int c, Lengths& sum) {
    for (int i = motion.column_offset[c]; i < motion.column_offset[c + 1]; ++i) {
      const int b = motion.column_blocks[i];
      if (maps[b].empty()) continue;
      const Point3 low = points.row(x.node(c, motion.blocks[b].k_low));
      const Point3 high = points.row(x.node(c, motion.blocks[b].k_high));
      sum.off[b] += (maps[b].back()(low) - high).norm();
      sum.way[b] += (low - high).norm();
    }
  };
  const long grain = ThreadTeam::grain_of(x.n_columns(), few, many);
  std::vector<Lengths> parts(ThreadTeam::n_chunks(x.n_columns(), grain), none);
  team.for_chunks(x.n_columns(), grain, [&](long begin, long end, long chunk) {
    for (int c = static_cast<int>(begin); c < end; ++c) add_column(c, parts[chunk]);
  });
  std::vector<char> out(maps.size());
  for (std::size_t b = 0; b < out.size(); ++b) {
    double off = 0.0, way = 0.0;
    for (const Lengths& part : parts) {
      off += part.off[b];
      way += part.way[b];
    }
    out[b] = off <= most_off * way;
  }
  return out;
}

void set_blends(const BaseMetric& metric, std::vector<AffineMap> maps, MotionBlock& block) {
  const int n = block.k_high - block.k_low;
  block.has_loops = !maps.empty();
  if (!block.has_loops) maps.assign(n + 1, AffineMap());
  const AffineMap back = maps.back().inverse();
  std::vector<double> height(n + 1, 0.0);
  for (int k = 0; k < n; ++k) height[k + 1] = height[k] + metric.height_of(block.k_low + k);
  for (int k = 0; k <= n; ++k) {
    const double s = height[k] / height[n];
    const AffineMap down = maps[k].after(back);
    block.blend.push_back(
        {(1 - s) * maps[k].matrix, s * down.matrix, (1 - s) * maps[k].shift + s * down.shift});
  }
  block.up = std::move(maps);
}

void check_ends(const Extrusion& x, const std::vector<char>& fixed, ThreadTeam& team) {
  const auto check_cell = [&](int c) {
    for (int i = x.cell_offset[c]; i < x.cell_offset[c + 1]; ++i)
      for (const int k : {x.cell_k_low[c], x.cell_k_high[c]})
        if (!fixed[x.node(x.cell_columns[i], k)])
          throw InputError("place", "The end of a run at layer " + std::to_string(k) +
                                        " has a node without a position (column " +
                                        std::to_string(x.cell_columns[i]) + ").");
  };
  const long grain = ThreadTeam::grain_of(x.n_cells(), few, many);
  team.for_chunks(x.n_cells(), grain, [&](long begin, long end, long) {
    for (int c = static_cast<int>(begin); c < end; ++c) check_cell(c);
  });
}

}  // namespace

bool fit_affine(const std::vector<Point3>& from, const std::vector<Point3>& to, AffineMap& map) {
  const AffineFit fit(from);
  const auto at = [&](std::size_t i) -> const Point3& { return to[i]; };
  return fit.find(at, map);
}

LayerMotion make_layer_motion(const Extrusion& extrusion, const std::vector<char>& fixed,
                              const Points& points, const BaseMetric& metric, ThreadTeam& team) {
  check_ends(extrusion, fixed, team);
  RunBlocks runs = find_blocks(extrusion);
  const std::vector<Slab> slabs = find_slabs(extrusion, fixed, runs, team);
  LayerMotion motion;
  for (const auto& [low, high] : runs.ends) motion.blocks.push_back({low, high, {}, {}, false});
  motion.cell_block = std::move(runs.of_cell);
  motion.column_offset = std::move(runs.column_offset);
  motion.column_blocks = std::move(runs.column_blocks);
  const std::vector<SlabMotion> motions = fit_slabs(extrusion, points, slabs, team);
  std::vector<std::vector<AffineMap>> maps(motion.blocks.size());
  std::vector<char> is_chained(motion.blocks.size(), 0);
  for (std::size_t c = 0, n_left = maps.size(); n_left > 0; ++c) {
    const int b = motion.cell_block[c];
    if (is_chained[b]) continue;
    is_chained[b] = 1;
    --n_left;
    const int column = extrusion.cell_columns[extrusion.cell_offset[c]];
    maps[b] = chain(slabs, motions, motion.blocks[b], column);
  }
  const std::vector<char> is_telling = are_telling(maps, extrusion, points, motion, team);
  for (std::size_t b = 0; b < maps.size(); ++b)
    set_blends(metric, is_telling[b] ? std::move(maps[b]) : std::vector<AffineMap>(),
               motion.blocks[b]);
  return motion;
}

void predict(const Extrusion& extrusion, const Points& points, const MotionBlock& block, int column,
             int k_begin, int k_end, Point3* out) {
  const Point3 low = points.row(extrusion.node(column, block.k_low));
  const Point3 high = points.row(extrusion.node(column, block.k_high));
  for (int k = k_begin; k < k_end; ++k) {
    const MotionBlend& b = block.blend[k - block.k_low];
    *out++ = b.low * low + b.high * high + b.shift;
  }
}

}  // namespace sweepmesh
