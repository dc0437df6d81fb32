#include "sweepmesh/volume/residual.h"

#include <algorithm>

#include "sweepmesh/volume/element_index.h"

namespace sweepmesh {
namespace {

const ColumnResidual* find_in(const std::vector<ColumnResidual>& list, int block) {
  for (const ColumnResidual& r : list)
    if (r.block == block) return &r;
  return nullptr;
}

/// Forces of one cell on one of its columns.
class CellForce {
 public:
  CellForce(const Extrusion& x, const LayerMotion& motion, const BaseMetric& metric,
            const Residuals& residuals, const LayeredSystem& system, double scale)
      : x_(x), motion_(motion), metric_(metric), residuals_(residuals), s_(system), scale_(scale) {}

  void add(int cell, int corner, float* out) const {
    const int block = motion_.cell_block[cell], n = x_.cell_size(cell);
    const int* columns = x_.cell_columns.data() + x_.cell_offset[cell];
    const int column = columns[corner];
    const ColumnResidual* own = find_in(residuals_[column], block);
    for (int j = 0; j < n; ++j) {
      if (j == corner) continue;
      const ColumnResidual* other = find_in(residuals_[columns[j]], block);
      const int a = std::min(corner, j), b = std::max(corner, j);
      const double w =
          metric_.pair_weight[metric_.pair_offset[cell] + a * n - a * (a + 1) / 2 + b - a - 1];
      if (own || other) add_pair(cell, column, w * scale_, own, other, out);
    }
    if (own)
      add_vertical(cell, column, metric_.corner_mass[x_.cell_offset[cell] + corner] * scale_, *own,
                   out);
  }

 private:
  void subtract(float* out, int column, int k, const Point3& force) const {
    const int level = k - s_.k_first;
    if (level < s_.low[column] || level > s_.high[column]) return;
    for (int d = 0; d < 3; ++d)
      out[3L * (level - s_.low[column]) + d] -= static_cast<float>(force[d]);
  }

  void add_pair(int cell, int column, double w, const ColumnResidual* own,
                const ColumnResidual* other, float* out) const {
    const int low = x_.cell_k_low[cell], high = x_.cell_k_high[cell];
    for (int k = low; k <= high; ++k) {
      Point3 difference = Point3::Zero();
      if (own) difference += own->value[k - low];
      if (other) difference -= other->value[k - low];
      const double part = k == low || k == high ? 0.5 : 1.0;
      subtract(out, column, k, w * part * s_.share[3L * (k - s_.k_first)] * difference);
    }
  }

  void add_vertical(int cell, int column, double mass, const ColumnResidual& own,
                    float* out) const {
    for (int k = x_.cell_k_low[cell]; k < x_.cell_k_high[cell]; ++k) {
      const int i = k - x_.cell_k_low[cell];
      const Point3 force =
          mass * s_.spring[3L * (k - s_.k_first)] * (own.value[i + 1] - own.value[i]);
      subtract(out, column, k, -force);
      subtract(out, column, k + 1, force);
    }
  }

  const Extrusion& x_;
  const LayerMotion& motion_;
  const BaseMetric& metric_;
  const Residuals& residuals_;
  const LayeredSystem& s_;
  double scale_;
};

/// Mean of the predictions of several blocks for the free nodes of a column.
void set_mean_predictions(const Extrusion& x, const LayerMotion& motion,
                          const std::vector<char>& fixed, int column, Points& points) {
  std::vector<Point3> sum(x.k_high[column] - x.k_low[column] + 1, Point3::Zero()), one(sum.size());
  std::vector<int> count(sum.size(), 0);
  for (int i = motion.column_offset[column]; i < motion.column_offset[column + 1]; ++i) {
    const MotionBlock& block = motion.blocks[motion.column_blocks[i]];
    predict(x, points, block, column, block.k_low, block.k_high + 1, one.data());
    for (int k = block.k_low; k <= block.k_high; ++k) {
      sum[k - x.k_low[column]] += one[k - block.k_low];
      ++count[k - x.k_low[column]];
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const long node = x.column_offset[column] + static_cast<long>(k);
    if (!fixed[node] && count[k] > 0) points.row(node) = sum[k] / count[k];
  }
}

}  // namespace

void set_predictions(const Extrusion& extrusion, const LayerMotion& motion,
                     const std::vector<char>& fixed, Points& points, ThreadTeam& team) {
  team.for_chunks(
      extrusion.n_columns(), columns_per_chunk(extrusion), [&](long begin, long end, long) {
        for (int c = static_cast<int>(begin); c < end; ++c) {
          const int first = motion.column_offset[c], n_blocks = motion.column_offset[c + 1] - first;
          if (n_blocks != 1) {
            set_mean_predictions(extrusion, motion, fixed, c, points);
            continue;
          }
          const MotionBlock& block = motion.blocks[motion.column_blocks[first]];
          const Point3 low = points.row(extrusion.node(c, block.k_low));
          const Point3 high = points.row(extrusion.node(c, block.k_high));
          for (int k = block.k_low + 1; k < block.k_high; ++k) {
            const long node = extrusion.node(c, k);
            if (fixed[node]) continue;
            const MotionBlend& b = block.blend[k - block.k_low];
            points.row(node) = b.low * low + b.high * high + b.shift;
          }
        }
      });
}

Residuals find_residuals(const Extrusion& extrusion, const LayerMotion& motion,
                         const std::vector<char>& fixed, const Points& points, ThreadTeam& team) {
  Residuals residuals(extrusion.n_columns());
  const auto add_column = [&](int c) {
    const int first = motion.column_offset[c], last = motion.column_offset[c + 1];
    for (int i = first; i < last; ++i) {
      const int b = motion.column_blocks[i];
      const MotionBlock& block = motion.blocks[b];
      const auto inner = fixed.begin() + extrusion.node(c, block.k_low) + 1;
      const bool is_bound = std::any_of(inner, inner + (block.k_high - block.k_low - 1),
                                        [](char f) { return f != 0; });
      if (!is_bound && last - first == 1) continue;
      ColumnResidual& r = residuals[c].emplace_back();
      r.block = b;
      r.value.resize(block.k_high - block.k_low + 1);
      predict(extrusion, points, block, c, block.k_low, block.k_high + 1, r.value.data());
      for (int k = block.k_low; k <= block.k_high; ++k) {
        Point3& v = r.value[k - block.k_low];
        v = Point3(points.row(extrusion.node(c, k))) - v;
      }
    }
  };
  team.for_chunks(extrusion.n_columns(), columns_per_chunk(extrusion),
                  [&](long begin, long end, long) {
                    for (int c = static_cast<int>(begin); c < end; ++c) add_column(c);
                  });
  return residuals;
}

double largest(const Residuals& residuals) {
  double most = 0.0;
  for (const auto& list : residuals)
    for (const ColumnResidual& r : list)
      for (const Point3& v : r.value) most = std::max(most, v.norm());
  return most;
}

Floats right_hand_side(const Extrusion& extrusion, const CellsOfColumns& cells,
                       const LayerMotion& motion, const BaseMetric& metric,
                       const Residuals& residuals, const LayeredSystem& system, double scale,
                       ThreadTeam& team) {
  const CellForce force(extrusion, motion, metric, residuals, system, scale);
  Floats right = make_vector(system);
  team.for_chunks(
      extrusion.n_columns(), columns_per_chunk(extrusion), [&](long begin, long end, long) {
        for (int c = static_cast<int>(begin); c < end; ++c) {
          if (system.low[c] > system.high[c]) continue;
          std::fill(right.begin() + system.offset[c], right.begin() + system.offset[c + 1], 0.0f);
          for (int i = cells.offset[c]; i < cells.offset[c + 1]; ++i)
            force.add(cells.cell[i], cells.corner[i], right.data() + system.offset[c]);
          for (int t = 0; t < system.n_bands();
               ++t) {  // nothing acts on the fixed nodes of the hull
            const int low = std::max(system.low[c], system.band_begin[t]);
            const int high = std::min(system.high[c] + 1, system.band_begin[t + 1]);
            if (low < high && system.rows[t].diagonal[c] == 0.0f)
              std::fill_n(system.at(right.data(), c, low), 3L * (high - low), 0.0f);
          }
        }
      });
  return right;
}

}  // namespace sweepmesh
