#include "sweepmesh/volume/layered_system.h"

#include <algorithm>
#include <cmath>

namespace sweepmesh {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Levels at which a column begins, ends, or turns from free to fixed or back, and where a run
/// begins or ends (its last level has half of the matrix, so it is a band of its own).
std::vector<int> find_bands(const Extrusion& x, const std::vector<char>& fixed, int first,
                            int last) {
  std::vector<char> begins(last - first + 2, 0);
  begins[0] = begins[last - first + 1] = 1;
  for (int c = 0; c < x.n_columns(); ++c) {
    begins[x.k_low[c] - first] = begins[x.k_high[c] + 1 - first] = 1;
    for (int k = x.k_low[c] + 1; k <= x.k_high[c]; ++k)
      if ((fixed[x.node(c, k)] != 0) != (fixed[x.node(c, k - 1)] != 0)) begins[k - first] = 1;
  }
  for (int c = 0; c < x.n_cells(); ++c)
    for (const int k :
         {x.cell_k_low[c], x.cell_k_low[c] + 1, x.cell_k_high[c], x.cell_k_high[c] + 1})
      begins[k - first] = 1;
  std::vector<int> bands;
  for (std::size_t k = 0; k < begins.size(); ++k)
    if (begins[k]) bands.push_back(static_cast<int>(k));
  return bands;
}

/// Calls f(i, j, weight) for the corners of each pair of a cell.
template <class F>
void for_pairs(const Extrusion& x, const BaseMetric& metric, int cell, F&& f) {
  const int* columns = x.cell_columns.data() + x.cell_offset[cell];
  const double* weight = metric.pair_weight.data() + metric.pair_offset[cell];
  for (int i = 0; i < x.cell_size(cell); ++i)
    for (int j = i + 1; j < x.cell_size(cell); ++j) f(columns[i], columns[j], *weight++);
}

BaseMatrix band_matrix(const Extrusion& x, const BaseMetric& metric,
                       const std::vector<char>& is_free, int k) {
  Triplets entries;
  for (int c = 0; c < x.n_cells(); ++c) {
    if (k < x.cell_k_low[c] || k > x.cell_k_high[c]) continue;
    const double part = k == x.cell_k_low[c] || k == x.cell_k_high[c] ? 0.5 : 1.0;
    for_pairs(x, metric, c, [&](int a, int b, double w) {
      w *= part;
      if (w == 0.0) return;
      if (is_free[a]) entries.emplace_back(a, a, w);
      if (is_free[b]) entries.emplace_back(b, b, w);
      if (!is_free[a] || !is_free[b]) return;
      entries.emplace_back(a, b, -w);
      entries.emplace_back(b, a, -w);
    });
  }
  BaseMatrix matrix(x.n_columns(), x.n_columns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The class of the layer above level k, whose ends are free as said.
LayerClass layer_class(const Extrusion& x, const BaseMetric& metric, int k,
                       const std::vector<char>& is_free, const std::vector<char>& is_free_above) {
  LayerClass layer;
  std::vector<double> mass(x.n_columns(), 0.0);
  for (int c = 0; c < x.n_cells(); ++c)
    if (x.cell_k_low[c] <= k && k < x.cell_k_high[c])
      for (int i = x.cell_offset[c]; i < x.cell_offset[c + 1]; ++i)
        mass[x.cell_columns[i]] += metric.corner_mass[i];
  for (int c = 0; c < x.n_columns(); ++c) {
    const float m = static_cast<float>(mass[c]);
    layer.lower.push_back(is_free[c] ? m : 0.0f);
    layer.upper.push_back(is_free_above[c] ? m : 0.0f);
    layer.across.push_back(is_free[c] && is_free_above[c] ? m : 0.0f);
  }
  return layer;
}

BaseRows rows_of(const BaseMatrix& matrix) {
  BaseRows rows;
  rows.offset.push_back(0);
  rows.diagonal.assign(matrix.rows(), 0.0f);
  for (int c = 0; c < matrix.rows(); ++c) {
    for (const bool is_diagonal : {true, false})
      for (BaseMatrix::InnerIterator entry(matrix, c); entry; ++entry) {
        if ((entry.col() == c) != is_diagonal || entry.value() == 0.0) continue;
        rows.neighbour.push_back(static_cast<int>(entry.col()));
        rows.weight.push_back(static_cast<float>(entry.value()));
        if (is_diagonal) rows.diagonal[c] = rows.weight.back();
      }
    rows.offset.push_back(static_cast<int>(rows.neighbour.size()));
  }
  return rows;
}

/// Sets the hulls of the columns from the bands in which they have a diagonal.
void set_hulls(LayeredSystem& s) {
  const int n = static_cast<int>(s.rows.front().diagonal.size());
  s.low.assign(n, 0);
  s.high.assign(n, -1);
  s.offset.assign(1, 0);
  for (int c = 0; c < n; ++c) {
    for (int t = 0; t < s.n_bands(); ++t) {
      if (s.rows[t].diagonal[c] == 0.0f) continue;
      if (s.high[c] < 0) s.low[c] = s.band_begin[t];
      s.high[c] = s.band_begin[t + 1] - 1;
    }
    s.offset.push_back(s.offset.back() + 3L * (s.high[c] - s.low[c] + 1));
  }
}

void set_layers(const BaseMetric& metric, LayeredSystem& s) {
  const int n = static_cast<int>(metric.height.size());
  double mean = 0.0;
  for (const double h : metric.height) mean += h / n;
  const auto half = [&](int k) { return k >= 0 && k < n ? 0.5 * metric.height[k] / mean : 0.0; };
  for (int k = 0; k <= n; ++k)
    s.share.insert(s.share.end(), 3, static_cast<float>(half(k - 1) + half(k)));
  for (int k = 0; k < n; ++k)
    s.spring.insert(s.spring.end(), 3, static_cast<float>(1.0 / (metric.height[k] * mean)));
}

std::vector<char> free_columns(const Extrusion& x, const std::vector<char>& fixed, int k) {
  std::vector<char> is_free(x.n_columns());
  for (int c = 0; c < x.n_columns(); ++c)
    is_free[c] = x.k_low[c] <= k && k <= x.k_high[c] && !fixed[x.node(c, k)];
  return is_free;
}

/// Sum of |off-diagonal| entries that count as strong, at least this part of the geometric mean of
/// the diagonals.
constexpr double strong_coupling = 0.08;

bool is_strong(double value, double a, double b) {
  return value < 0.0 && value * value > strong_coupling * strong_coupling * a * b;
}

/// The base matrix that stands for all levels: the sum over bands, each times its levels.
BaseMatrix sum_over_levels(const LayeredLevel& level) {
  BaseMatrix sum = level.matrix.front();
  sum.setZero();
  for (int t = 0; t < level.system.n_bands(); ++t) {
    const int n_levels = level.system.band_begin[t + 1] - level.system.band_begin[t];
    if (level.matrix[t].nonZeros() > 0) sum += n_levels * level.matrix[t];
  }
  return sum;
}

/// Aggregates (Vanek, Mandel, Brezina 1996, algorithm 5.1); -1 for columns that are nowhere free.
std::vector<int> make_aggregates(const BaseMatrix& matrix, const Eigen::VectorXd& diagonal,
                                 int& n_aggregates) {
  constexpr int none = -1;
  const int n = static_cast<int>(matrix.rows());
  std::vector<int> aggregate(n, none);
  n_aggregates = 0;
  const auto for_strong = [&](int c, auto&& f) {
    for (BaseMatrix::InnerIterator entry(matrix, c); entry; ++entry)
      if (entry.col() != c && is_strong(entry.value(), diagonal[c], diagonal[entry.col()]))
        f(static_cast<int>(entry.col()), -entry.value());
  };
  for (int c = 0; c < n; ++c) {
    bool is_untouched = aggregate[c] == none && diagonal[c] > 0.0;
    for_strong(c, [&](int b, double) { is_untouched = is_untouched && aggregate[b] == none; });
    if (!is_untouched) continue;
    aggregate[c] = n_aggregates;
    for_strong(c, [&](int b, double) { aggregate[b] = n_aggregates; });
    ++n_aggregates;
  }
  const std::vector<int> seeds = aggregate;
  for (int c = 0; c < n; ++c) {
    if (aggregate[c] != none || diagonal[c] <= 0.0) continue;
    double strongest = 0.0;
    for_strong(c, [&](int b, double w) {
      if (seeds[b] == none || w <= strongest) return;
      strongest = w;
      aggregate[c] = seeds[b];
    });
    if (aggregate[c] == none) aggregate[c] = n_aggregates++;
  }
  return aggregate;
}

}  // namespace

LayeredLevel make_layered_level(const Extrusion& extrusion, const BaseMetric& metric,
                                const std::vector<char>& fixed) {
  LayeredLevel level;
  LayeredSystem& s = level.system;
  s.k_first = metric.k_first;
  const int last = s.k_first + static_cast<int>(metric.height.size());
  s.band_begin = find_bands(extrusion, fixed, s.k_first, last);
  set_layers(metric, s);
  for (std::size_t t = 0; t + 1 < s.band_begin.size(); ++t) {
    const int k = s.k_first + s.band_begin[t], above = s.k_first + s.band_begin[t + 1];
    const std::vector<char> is_free = free_columns(extrusion, fixed, k);
    level.matrix.push_back(band_matrix(extrusion, metric, is_free, k));
    s.rows.push_back(rows_of(level.matrix.back()));
    s.layers.push_back(layer_class(extrusion, metric, k, is_free, is_free));
    s.layers.push_back(
        layer_class(extrusion, metric, above - 1, is_free, free_columns(extrusion, fixed, above)));
  }
  set_hulls(s);
  return level;
}

BaseMatrix make_prolongation(const LayeredLevel& fine) {
  const BaseMatrix sum = sum_over_levels(fine);
  const Eigen::VectorXd diagonal = sum.diagonal();
  int n_aggregates = 0;
  const std::vector<int> aggregate = make_aggregates(sum, diagonal, n_aggregates);
  Triplets tentative, smoother;
  for (int c = 0; c < sum.rows(); ++c) {
    if (aggregate[c] < 0) continue;
    tentative.emplace_back(c, aggregate[c], 1.0);
    // One damped Jacobi step with the weak couplings lumped to the diagonal.
    double lumped = 0.0;
    for (BaseMatrix::InnerIterator entry(sum, c); entry; ++entry) {
      if (entry.col() == c || is_strong(entry.value(), diagonal[c], diagonal[entry.col()]))
        continue;
      lumped += entry.value();
    }
    const double d = std::max(diagonal[c] + lumped, strong_coupling * diagonal[c]);
    for (BaseMatrix::InnerIterator entry(sum, c); entry; ++entry)
      if (entry.col() != c && is_strong(entry.value(), diagonal[c], diagonal[entry.col()]))
        smoother.emplace_back(c, static_cast<int>(entry.col()), -2.0 / 3.0 * entry.value() / d);
    smoother.emplace_back(c, c, 1.0 / 3.0);
  }
  BaseMatrix p(sum.rows(), n_aggregates), jacobi(sum.rows(), sum.rows());
  p.setFromTriplets(tentative.begin(), tentative.end());
  jacobi.setFromTriplets(smoother.begin(), smoother.end());
  return (jacobi * p).pruned();
}

LayeredLevel make_coarser(const LayeredLevel& fine, const BaseMatrix& prolongation) {
  LayeredLevel coarse;
  LayeredSystem& s = coarse.system;
  const LayeredSystem& f = fine.system;
  s.k_first = f.k_first;
  s.share = f.share;
  s.spring = f.spring;
  s.band_begin = f.band_begin;
  const Eigen::VectorXd row_sum = prolongation * Eigen::VectorXd::Ones(prolongation.cols());
  const BaseMatrix transposed = prolongation.transpose();
  const auto restricted = [&](const std::vector<float>& mass) {
    std::vector<float> out(transposed.rows(), 0.0f);
    for (int c = 0; c < transposed.rows(); ++c) {
      double sum = 0.0;
      for (BaseMatrix::InnerIterator entry(transposed, c); entry; ++entry)
        sum += entry.value() * mass[entry.col()] * row_sum[entry.col()];
      out[c] = static_cast<float>(sum);
    }
    return out;
  };
  for (int t = 0; t < f.n_bands(); ++t) {
    // Rows of the prolongation that are not free in this band drop out, since their matrix rows are
    // empty.
    coarse.matrix.push_back(
        BaseMatrix(prolongation.transpose() * fine.matrix[t] * prolongation).pruned());
    s.rows.push_back(rows_of(coarse.matrix.back()));
  }
  for (const LayerClass& layer : f.layers)
    s.layers.push_back(
        {restricted(layer.across), restricted(layer.lower), restricted(layer.upper)});
  set_hulls(s);
  return coarse;
}

}  // namespace sweepmesh
