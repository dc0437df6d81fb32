#include "sweepmesh/volume/older_affine.h"

#include <algorithm>
#include <map>

#include "sweepmesh/volume/residual.h"
#include "sweepmesh/volume/slabs.h"

namespace sweepmesh {
namespace {

/// The loops of one part of a slab at any of its layers.
class PartLoops {
 public:
  PartLoops(const Extrusion& x, const Slab& slab, int part) : x_(x), columns_(slab.loops[part]) {
    std::map<std::array<int, 2>, int> seen;
    for (int c = 0; c < x.n_cells(); ++c) {
      const int* columns = x.cell_columns.data() + x.cell_offset[c];
      if (!slab.holds(x, c) || slab.part[columns[0]] != part) continue;
      for (int i = 0, n = x.cell_size(c); i < n; ++i) {
        const int a = columns[i], b = columns[(i + 1) % n];
        const auto [at, is_new] = seen.insert({{std::min(a, b), std::max(a, b)}, 0});
        if (is_new)
          edges_.push_back({a, b});
        else
          at->second = 1;
      }
    }
    std::erase_if(edges_, [&](const std::array<int, 2>& e) {
      return seen.at({std::min(e[0], e[1]), std::max(e[0], e[1])}) > 0;
    });
  }

  bool is_enough() const { return columns_.size() >= 3; }

  std::vector<Point3> at(const Points& points, int k) const {
    std::vector<Point3> out;
    for (const int c : columns_) out.push_back(points.row(x_.node(c, k)));
    return out;
  }
  LoopMap fit(const Points& points, int from, int to, Functional functional) const {
    return fit_points(at(points, from), at(points, to), area(points, from), area(points, to),
                      functional);
  }

 private:
  Point3 area(const Points& points, int k) const {
    const Point3 origin = points.row(x_.node(edges_.front()[0], k));
    Point3 sum = Point3::Zero();
    for (const auto& [a, b] : edges_)
      sum += (Point3(points.row(x_.node(a, k))) - origin)
                 .cross(Point3(points.row(x_.node(b, k))) - origin);
    return 0.5 * sum;
  }

  const Extrusion& x_;
  const std::vector<int>& columns_;
  std::vector<std::array<int, 2>> edges_;  ///< directed, the part on their left
};

/// Per part of a slab and layer: maps from its low and from its high end; empty without loops.
struct SlabFits {
  std::vector<std::vector<LoopMap>> from_low, from_high;
};

SlabFits fit_slab(const Extrusion& x, const Slab& slab, Functional functional,
                  const Points& points) {
  SlabFits fits;
  for (std::size_t p = 0; p < slab.loops.size(); ++p) {
    std::vector<LoopMap>&low = fits.from_low.emplace_back(), &high = fits.from_high.emplace_back();
    const PartLoops loops(x, slab, static_cast<int>(p));
    if (!loops.is_enough()) continue;
    for (int k = slab.k_low; k <= slab.k_high; ++k) {
      low.push_back(loops.fit(points, slab.k_low, k, functional));
      high.push_back(loops.fit(points, slab.k_high, k, functional));
    }
  }
  return fits;
}

LoopMap after(const LoopMap& second, const LoopMap& first) {
  return {second.matrix * first.matrix, second.matrix * first.shift + second.shift};
}

/// Replaces the blends of a block by those of the fits along one of its columns.
void set_blends(const std::vector<Slab>& slabs, const std::vector<SlabFits>& fits,
                const BaseMetric& metric, int column, MotionBlock& block) {
  const LoopMap identity{Eigen::Matrix3d::Identity(), Point3::Zero()};
  const int n = block.k_high - block.k_low;
  std::vector<LoopMap> up(n + 1, identity), down(n + 1, identity);
  bool has_loops = true;
  const auto is_inside = [&](const Slab& s) {
    return s.k_low >= block.k_low && s.k_high <= block.k_high;
  };
  for (std::size_t s = 0; s < slabs.size(); ++s) {
    if (!is_inside(slabs[s])) continue;
    const std::vector<LoopMap>& fit = fits[s].from_low[slabs[s].part[column]];
    has_loops = has_loops && !fit.empty();
    for (std::size_t i = 1; i < fit.size(); ++i) {
      const int start = slabs[s].k_low - block.k_low;
      up[start + i] = after(fit[i], up[start]);
    }
  }
  for (std::size_t s = slabs.size(); s-- > 0;) {
    if (!is_inside(slabs[s])) continue;
    const std::vector<LoopMap>& fit = fits[s].from_high[slabs[s].part[column]];
    for (std::size_t i = 0; i + 1 < fit.size(); ++i)
      down[slabs[s].k_low - block.k_low + i] = after(fit[i], down[slabs[s].k_high - block.k_low]);
  }
  if (!has_loops) return;  // the blends are linear already
  std::vector<double> height(n + 1, 0.0);
  for (int k = 0; k < n; ++k) height[k + 1] = height[k] + metric.height_of(block.k_low + k);
  for (int k = 0; k <= n; ++k) {
    const double s = height[k] / height[n];
    block.blend[k] = {(1 - s) * up[k].matrix, s * down[k].matrix,
                      (1 - s) * up[k].shift + s * down[k].shift};
  }
}

}  // namespace

void place_knupp(const Extrusion& extrusion, const std::vector<char>& fixed, Points& points,
                 ThreadTeam& team) {
  const Extrusion& x = extrusion;
  const std::vector<Slab> slabs = find_slabs(x, fixed, find_blocks(x), team);
  for (std::size_t s = slabs.size(); s-- > 0;) {
    const Slab& slab = slabs[s];
    for (int k = slab.k_high; k > slab.k_low; --k) {
      std::vector<LoopMap> maps;
      for (std::size_t p = 0; p < slab.loops.size(); ++p) {
        const PartLoops loops(x, slab, static_cast<int>(p));
        maps.push_back(loops.is_enough() ? loops.fit(points, k, k - 1, Functional::g)
                                         : LoopMap{Eigen::Matrix3d::Identity(), Point3::Zero()});
      }
      for (int c = 0; c < x.n_columns(); ++c)
        if (slab.part[c] >= 0 && !fixed[x.node(c, k - 1)])
          points.row(x.node(c, k - 1)) = maps[slab.part[c]](points.row(x.node(c, k)));
    }
  }
}

void place_least_squares(const Extrusion& extrusion, const std::vector<char>& fixed,
                         const BaseMetric& metric, Functional functional, Points& points,
                         ThreadTeam& team) {
  const Extrusion& x = extrusion;
  const std::vector<Slab> slabs = find_slabs(x, fixed, find_blocks(x), team);
  std::vector<SlabFits> fits;
  for (const Slab& slab : slabs) fits.push_back(fit_slab(x, slab, functional, points));
  LayerMotion motion = make_layer_motion(x, fixed, points, metric, team);
  std::vector<char> is_done(motion.blocks.size(), 0);
  for (int c = 0; c < x.n_cells(); ++c) {
    if (is_done[motion.cell_block[c]]) continue;
    is_done[motion.cell_block[c]] = 1;
    set_blends(slabs, fits, metric, x.cell_columns[x.cell_offset[c]],
               motion.blocks[motion.cell_block[c]]);
  }
  set_predictions(x, motion, fixed, points, team);
}

}  // namespace sweepmesh
