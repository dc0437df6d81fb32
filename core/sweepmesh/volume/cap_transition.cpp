#include "sweepmesh/volume/cap_transition.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/element_index.h"
#include "sweepmesh/volume/layered_solver.h"

namespace sweepmesh {
namespace {

/// Columns or cells that a thread takes at a time.
long grain_of(long n) {
  return ThreadTeam::grain_of(n, 1L << 6, 1L << 10);
}

/// Per column: its only block if all its inner nodes are free there, or -1.
std::vector<int> free_blocks(const Extrusion& x, const std::vector<char>& fixed,
                             const LayerMotion& motion, ThreadTeam& team) {
  std::vector<int> block_of(x.n_columns(), -1);
  team.for_chunks(x.n_columns(), grain_of(x.n_columns()), [&](long begin, long end, long) {
    for (int c = static_cast<int>(begin); c < end; ++c) {
      if (motion.column_offset[c + 1] - motion.column_offset[c] != 1) continue;
      const int b = motion.column_blocks[motion.column_offset[c]];
      const MotionBlock& block = motion.blocks[b];
      const auto first = fixed.begin() + x.node(c, block.k_low) + 1;
      if (block.has_loops && block.k_high - block.k_low > 1 &&
          std::none_of(first, first + (block.k_high - block.k_low - 1),
                       [](char f) { return f != 0; }))
        block_of[c] = b;
    }
  });
  return block_of;
}

/// Per column: high end, carried back to the low one, minus the low end; zero without a block.
class Differences {
 public:
  Differences(const Extrusion& x, const LayerMotion& motion, const Points& points)
      : x_(x), motion_(motion), points_(points) {
    for (const MotionBlock& block : motion.blocks) back_.push_back(block.up.back().inverse());
  }

  Point3 operator()(int c) const {
    if (motion_.column_offset[c] == motion_.column_offset[c + 1]) return Point3::Zero();
    const int b = motion_.column_blocks[motion_.column_offset[c]];
    const MotionBlock& block = motion_.blocks[b];
    if (!block.has_loops) return Point3::Zero();
    return back_[b](Point3(points_.row(x_.node(c, block.k_high)))) -
           Point3(points_.row(x_.node(c, block.k_low)));
  }
  Points all(ThreadTeam& team) const {
    Points out(x_.n_columns(), 3);
    team.for_chunks(x_.n_columns(), grain_of(x_.n_columns()), [&](long begin, long end, long) {
      for (int c = static_cast<int>(begin); c < end; ++c) out.row(c) = (*this)(c);
    });
    return out;
  }

 private:
  const Extrusion& x_;
  const LayerMotion& motion_;
  const Points& points_;
  std::vector<AffineMap> back_;
};

/// The longest of the vectors f(0) .. f(n - 1).
template <class F>
double longest(int n, ThreadTeam& team, F&& f) {
  const long grain = grain_of(n);
  std::vector<double> parts(ThreadTeam::n_chunks(n, grain), 0.0);
  team.for_chunks(n, grain, [&](long begin, long end, long chunk) {
    double most = 0.0;
    for (int c = static_cast<int>(begin); c < end; ++c) most = std::max(most, f(c).squaredNorm());
    parts[chunk] = std::sqrt(most);
  });
  return parts.empty() ? 0.0 : *std::max_element(parts.begin(), parts.end());
}

/// The base as three levels without mass: the middle one's system is the stiffness of the base.
struct BaseProblem {
  Extrusion extrusion;
  BaseMetric metric;
  std::vector<char> fixed;

  BaseProblem(const Extrusion& x, const BaseMetric& m, const std::vector<int>& block_of) {
    for (int c = 0; c < x.n_columns(); ++c) {
      extrusion.add_column(0, 2);
      fixed.insert(fixed.end(), {1, static_cast<char>(block_of[c] < 0), 1});
    }
    extrusion.cell_offset = x.cell_offset;
    extrusion.cell_columns = x.cell_columns;
    extrusion.cell_k_low.assign(x.n_cells(), 0);
    extrusion.cell_k_high.assign(x.n_cells(), 2);
    metric.pair_offset = m.pair_offset;
    metric.pair_weight = m.pair_weight;
    metric.corner_mass.assign(m.corner_mass.size(), 0.0f);
    metric.height.assign(2, 1.0);
  }
};

/// Takes the discrete harmonic extension of the other columns' rows from those with a block, and
/// sets the other rows to zero.
void subtract_extension(const Extrusion& x, const BaseMetric& metric,
                        const std::vector<int>& block_of, Points& rows, ThreadTeam& team,
                        const Context& context) {
  double unit = 0.0;
  for (int c = 0; c < x.n_columns(); ++c)
    if (block_of[c] < 0) unit = std::max(unit, rows.row(c).norm());
  if (unit > 0.0) {
    const BaseProblem base(x, metric, block_of);
    const CellsOfColumns cells(base.extrusion);
    const LayeredSystem system =
        make_layered_system(base.extrusion, cells, base.metric, base.fixed, team);
    Floats right(system.size(), 0.0f);
    for (int c = 0; c < x.n_columns(); ++c) {
      if (system.low[c] > system.high[c]) continue;
      float* force = right.data() + system.offset[c];
      for (int i = cells.offset[c]; i < cells.offset[c + 1]; ++i)
        for_pairs(x, metric, cells.cell[i], cells.corner[i], [&](int other, double w) {
          if (block_of[other] < 0)
            for (int d = 0; d < 3; ++d)
              force[d] += static_cast<float>(system.share[3] * w * rows(other, d) / unit);
        });
    }
    solve(system, right, {}, team, context);
    for (int c = 0; c < x.n_columns(); ++c)
      for (long i = system.offset[c]; i < system.offset[c + 1]; ++i)
        rows(c, i - system.offset[c]) -= unit * right[i];
  }
  for (int c = 0; c < x.n_columns(); ++c)
    if (block_of[c] < 0) rows.row(c).setZero();
}

struct BlockQuality {
  double least = 1.0, sum = 0.0;
  long n = 0;

  double mean() const { return n > 0 ? sum / static_cast<double>(n) : 1.0; }
  bool is_better_than(const BlockQuality& o, double gain) const {
    return least > o.least - 0.1 * gain && (least > 0.0) >= (o.least > 0.0) &&
           mean() > o.mean() + gain;
  }
};

std::vector<BlockQuality> measure(const Extrusion& x, const LayerMotion& motion,
                                  const Points& points, ThreadTeam& team) {
  const std::vector<BlockQuality> none(motion.blocks.size());
  const long grain = grain_of(x.n_cells());
  std::vector<std::vector<BlockQuality>> parts(ThreadTeam::n_chunks(x.n_cells(), grain), none);
  team.for_chunks(x.n_cells(), grain, [&](long begin, long end, long chunk) {
    for (int c = static_cast<int>(begin); c < end; ++c) {
      BlockQuality& q = parts[chunk][motion.cell_block[c]];
      for (int k = x.cell_k_low[c]; k < x.cell_k_high[c]; ++k) {
        const double value = scaled_jacobian_of(x, points, {c, k});
        q.least = std::min(q.least, value);
        q.sum += value;
        ++q.n;
      }
    }
  });
  std::vector<BlockQuality> all = none;
  for (const std::vector<BlockQuality>& part : parts)
    for (std::size_t b = 0; b < all.size(); ++b) {
      all[b].least = std::min(all[b].least, part[b].least);
      all[b].sum += part[b].sum;
      all[b].n += part[b].n;
    }
  return all;
}

/// The fractions of the height between which the high cap's share goes from 0 to 1.
struct Ramp {
  double begin = 0.0, end = 1.0;

  double operator()(double s) const { return std::clamp((s - begin) / (end - begin), 0.0, 1.0); }
  bool operator==(const Ramp&) const = default;
};

/// Blocks with another ramp each, and the nodes' way from one to another.
class Transitions {
 public:
  Transitions(const Extrusion& x, const LayerMotion& motion, const BaseMetric& metric,
              std::vector<int> block_of, Points mismatch)
      : ramp(motion.blocks.size()),
        x_(x),
        motion_(motion),
        block_of_(std::move(block_of)),
        mismatch_(std::move(mismatch)) {
    for (const MotionBlock& block : motion.blocks) {
      std::vector<double>& height = height_.emplace_back(1, 0.0);
      for (int k = block.k_low; k < block.k_high; ++k)
        height.push_back(height.back() + metric.height_of(k));
      for (double& h : height) h /= height.back();
    }
  }

  void change_to(const std::vector<Ramp>& next, Points& points, ThreadTeam& team) {
    team.for_chunks(x_.n_columns(), grain_of(x_.n_columns()), [&](long begin, long end, long) {
      for (int c = static_cast<int>(begin); c < end; ++c) {
        const int b = block_of_[c];
        if (b < 0 || next[b] == ramp[b]) continue;
        const Point3 d = mismatch_.row(c);
        const MotionBlock& block = motion_.blocks[b];
        for (int k = block.k_low + 1; k < block.k_high; ++k) {
          const int i = k - block.k_low;
          const double more = next[b](height_[b][i]) - ramp[b](height_[b][i]);
          points.row(x_.node(c, k)) += more * (block.up[i].matrix * d);
        }
      }
    });
    ramp = next;
  }

  std::vector<Ramp> ramp;

 private:
  const Extrusion& x_;
  const LayerMotion& motion_;
  std::vector<int> block_of_;
  Points mismatch_;
  std::vector<std::vector<double>> height_;  ///< per block and level, in 0 .. 1
};

}  // namespace

bool choose_transitions(const Extrusion& extrusion, const std::vector<char>& fixed,
                        BaseMetric& metric, const LayerMotion& motion,
                        const TransitionOptions& options, Points& points, ThreadTeam& team,
                        const Context& context) {
  const Differences differences(extrusion, motion, points);
  if (longest(extrusion.n_columns(), team, differences) <= options.negligible) return false;
  std::vector<int> block_of = free_blocks(extrusion, fixed, motion, team);
  Points mismatch = differences.all(team);
  complete_metric(extrusion, points, metric, team);
  subtract_extension(extrusion, metric, block_of, mismatch, team, context);
  const auto row = [&](int c) { return mismatch.row(c); };
  if (longest(extrusion.n_columns(), team, row) <= options.negligible) return false;

  Transitions transitions(extrusion, motion, metric, std::move(block_of), std::move(mismatch));
  std::vector<BlockQuality> best = measure(extrusion, motion, points, team);
  bool has_changed = false;
  for (const Ramp half : {Ramp{0.0, 0.5}, Ramp{0.5, 1.0}}) {
    context.check("place");
    const std::vector<Ramp> before = transitions.ramp;
    std::vector<Ramp> next(before.size(), half);
    transitions.change_to(next, points, team);
    const std::vector<BlockQuality> found = measure(extrusion, motion, points, team);
    for (std::size_t b = 0; b < next.size(); ++b) {
      const bool is_better = found[b].is_better_than(best[b], options.least_gain);
      if (is_better)
        best[b] = found[b];
      else
        next[b] = before[b];
      has_changed = has_changed || is_better;
    }
    transitions.change_to(next, points, team);
  }
  return has_changed;
}

}  // namespace sweepmesh
