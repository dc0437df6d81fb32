#include "sweepmesh/volume/base_metric.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace sweepmesh {
namespace {

/// Matrix of one polygon: pair weights and corner masses, added to with a factor.
struct PolygonMatrix {
  int n;
  double* pair_weight;
  double* corner_mass;

  double& weight(int i, int j) const {
    if (i > j) std::swap(i, j);
    return pair_weight[i * n - i * (i + 1) / 2 + (j - i - 1)];
  }
};

void add_triangle(const PolygonMatrix& m, const Point3* p, const int (&corner)[3], double factor) {
  const double area = 0.5 * (p[corner[1]] - p[corner[0]]).cross(p[corner[2]] - p[corner[0]]).norm();
  for (int i = 0; i < 3; ++i) {
    const int a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
    m.corner_mass[corner[i]] += factor * area / 3.0;
    if (area > 0.0)
      m.weight(a, b) += factor * (p[a] - p[corner[i]]).dot(p[b] - p[corner[i]]) / (4.0 * area);
  }
}

void add_fan(const PolygonMatrix& m, const Point3* p, int apex, double factor) {
  for (int i = 1; i + 1 < m.n; ++i)
    add_triangle(m, p, {apex, (apex + i) % m.n, (apex + i + 1) % m.n}, factor);
}

/// Sine and cosine of an angle, times some positive number.
struct Direction {
  double sine, cosine;

  Direction operator+(const Direction& o) const {
    return {sine * o.cosine + cosine * o.sine, cosine * o.cosine - sine * o.sine};
  }
  /// Of angles in 0 .. full turn, with equal factors.
  bool is_less_than(const Direction& o) const {
    if ((sine >= 0.0) != (o.sine >= 0.0)) return sine >= 0.0;
    const double side = sine >= 0.0 ? 1.0 : -1.0;
    return side * cosine > side * o.cosine;
  }
};

/// A quad, divided by its Delaunay diagonal: 0-2 if the angles that face it add up to less than
/// half a turn.
void add_quad(const PolygonMatrix& m, const Point3* p, double factor) {
  // Edge i leads from corner i to the next; the angle at a corner has the lengths of its edges as
  // factor, sums of opposite angles those of all four.
  using Four = Eigen::Array4d;
  const auto next_of = [](const Four& a) { return Four(a[1], a[2], a[3], a[0]); };
  const auto last_of = [](const Four& a) { return Four(a[3], a[0], a[1], a[2]); };
  Four out[3], in[3];
  for (int d = 0; d < 3; ++d) {
    const Four x(p[0][d], p[1][d], p[2][d], p[3][d]);
    out[d] = next_of(x) - x;
    in[d] = last_of(out[d]);
  }
  const Four length = out[0] * out[0] + out[1] * out[1] + out[2] * out[2];
  const Four a = in[1] * out[2] - in[2] * out[1], b = in[2] * out[0] - in[0] * out[2],
             c = in[0] * out[1] - in[1] * out[0];
  const Four sine = (a * a + b * b + c * c).sqrt();
  const Four cosine = -(in[0] * out[0] + in[1] * out[1] + in[2] * out[2]);
  const auto angle = [&](int i) { return Direction{sine[i], cosine[i]}; };
  // Which it is for a square, rounding says: no branch that is foreseen half of the times.
  const bool is_even = (angle(0) + angle(2)).is_less_than(angle(1) + angle(3));
  const double even = is_even ? 1.0 : 0.0, odd = 1.0 - even;
  const Four is_tip(even, odd, even, odd);  // of the triangle of a corner and its neighbours
  const Four area = is_tip * sine, f = (sine > 0.0).select(0.5 * is_tip / sine, 0.0);
  const Four mass = area + next_of(area) + last_of(area);
  // Edge i faces the next corner but one in the triangle of corner i, this corner in that of the
  // next.
  const Four side = f * (last_of(length) - cosine) + next_of(f * (length - cosine));
  const Four across = f * cosine;
  for (int i = 0; i < 4; ++i) m.corner_mass[i] += factor / 6.0 * mass[i];
  constexpr int edge[4] = {0, 3, 5, 2};
  for (int i = 0; i < 4; ++i) m.pair_weight[edge[i]] += factor * side[i];
  m.pair_weight[1] += factor * (across[1] + across[3]);
  m.pair_weight[4] += factor * (across[0] + across[2]);
}

void add_polygon(const PolygonMatrix& m, const Point3* p, double factor) {
  if (m.n == 4) return add_quad(m, p, factor);
  const int n_fans = m.n == 3 ? 1 : m.n;
  for (int apex = 0; apex < n_fans; ++apex) add_fan(m, p, apex, factor / n_fans);
}

/// Cells or columns that a thread takes at a time.
long grain_of(long n) {
  return ThreadTeam::grain_of(n, 1L << 5, 1L << 10);
}

/// Adds what the ends of a cell have in common with it, half each.
void add_ends(const Extrusion& x, const Points& points, int c, Point3* p, const PolygonMatrix& m) {
  const int* columns = x.cell_columns.data() + x.cell_offset[c];
  for (const int k : {x.cell_k_low[c], x.cell_k_high[c]}) {
    for (int i = 0; i < m.n; ++i) p[i] = points.row(x.node(columns[i], k));
    add_polygon(m, p, 0.5);
  }
}

void keep(const Extrusion& x, int c, const PolygonMatrix& m, BaseMetric& metric) {
  float* weight = &metric.pair_weight[metric.pair_offset[c]];
  float* mass = &metric.corner_mass[x.cell_offset[c]];
  for (int i = 0; i < m.n * (m.n - 1) / 2; ++i)
    weight[i] = static_cast<float>(std::max(0.0, m.pair_weight[i]));
  for (int i = 0; i < m.n; ++i) mass[i] = static_cast<float>(m.corner_mass[i]);
}

void add_cell(const Extrusion& x, const Points& points, int c, BaseMetric& metric) {
  const int n = x.cell_size(c);
  if (n == 4) {
    double weight[6] = {}, mass[4] = {};
    Point3 p[4];
    const PolygonMatrix m = {4, weight, mass};
    add_ends(x, points, c, p, m);
    return keep(x, c, m, metric);
  }
  std::vector<double> weight(n * (n - 1) / 2, 0.0), mass(n, 0.0);
  std::vector<Point3> p(n);
  const PolygonMatrix m = {n, weight.data(), mass.data()};
  add_ends(x, points, c, p.data(), m);
  keep(x, c, m, metric);
}

void add_cells(const Extrusion& x, const Points& points, BaseMetric& metric, ThreadTeam& team) {
  metric.pair_offset.assign(x.n_cells() + 1, 0);
  for (int c = 0; c < x.n_cells(); ++c) {
    const long n = x.cell_size(c);
    metric.pair_offset[c + 1] = metric.pair_offset[c] + n * (n - 1) / 2;
  }
  metric.pair_weight.resize(metric.pair_offset.back());
  metric.corner_mass.resize(x.cell_columns.size());
  team.for_chunks(x.n_cells(), grain_of(x.n_cells()), [&](long begin, long end, long) {
    for (int c = static_cast<int>(begin); c < end; ++c) add_cell(x, points, c, metric);
  });
}

/// Sums of lengths and their numbers, a layer each.
struct HeightSums {
  std::vector<double> length, count;
  explicit HeightSums(std::size_t n) : length(n, 0.0), count(n, 0.0) {}
  void add(int layer, double value) {
    length[layer] += value;
    count[layer] += 1.0;
  }
};

/// Calls add(i, sums) for all i < n on all threads, in chunks of `grain`, and joins the sums in
/// order.
template <class F>
HeightSums sum_heights(std::size_t n_layers, long n, long grain, ThreadTeam& team, F&& add) {
  std::vector<HeightSums> parts(ThreadTeam::n_chunks(n, grain), HeightSums(n_layers));
  team.for_chunks(n, grain, [&](long begin, long end, long chunk) {
    for (int i = static_cast<int>(begin); i < end; ++i) add(i, parts[chunk]);
  });
  HeightSums all(n_layers);
  for (const HeightSums& part : parts)
    for (std::size_t k = 0; k < n_layers; ++k) {
      all.length[k] += part.length[k];
      all.count[k] += part.count[k];
    }
  return all;
}

void set_heights(const Extrusion& x, const std::vector<char>& fixed, const Points& points,
                 BaseMetric& metric, ThreadTeam& team) {
  const int first = *std::min_element(x.k_low.begin(), x.k_low.end());
  const int n_layers = *std::max_element(x.k_high.begin(), x.k_high.end()) - first;
  metric.k_first = first;
  const auto add_column = [&](int c, HeightSums& sums) {
    for (int k = x.k_low[c]; k < x.k_high[c]; ++k) {
      const long node = x.node(c, k);
      if (fixed[node] && fixed[node + 1])
        sums.add(k - first, (points.row(node + 1) - points.row(node)).norm());
    }
  };
  const auto add_cell = [&](int c, HeightSums& sums) {
    const int low = x.cell_k_low[c], high = x.cell_k_high[c];
    const int column = x.cell_columns[x.cell_offset[c]];
    const double length =
        (points.row(x.node(column, high)) - points.row(x.node(column, low))).norm();
    for (int k = low; k < high; ++k) sums.add(k - first, length / (high - low));
  };
  // A chunk holds more columns than the layers that its sums have.
  const long grain = std::max<long>(grain_of(x.n_columns()), n_layers);
  const HeightSums linking = sum_heights(n_layers, x.n_columns(), grain, team, add_column);
  const bool has_all = std::all_of(linking.length.begin(), linking.length.end(),
                                   [](double length) { return length > 0.0; });
  const HeightSums runs = sum_heights(n_layers, has_all ? 0 : x.n_cells(), grain, team, add_cell);
  metric.height.assign(n_layers, 1.0);
  for (int k = 0; k < n_layers; ++k) {
    const HeightSums& sums = linking.length[k] > 0.0 ? linking : runs;
    if (sums.length[k] > 0.0) metric.height[k] = sums.length[k] / sums.count[k];
  }
}

}  // namespace

BaseMetric make_base_metric(const Extrusion& extrusion, const std::vector<char>& fixed,
                            const Points& points, ThreadTeam& team) {
  BaseMetric metric = make_layer_heights(extrusion, fixed, points, team);
  complete_metric(extrusion, points, metric, team);
  return metric;
}

BaseMetric make_layer_heights(const Extrusion& extrusion, const std::vector<char>& fixed,
                              const Points& points, ThreadTeam& team) {
  BaseMetric metric;
  if (extrusion.n_cells() > 0) set_heights(extrusion, fixed, points, metric, team);
  return metric;
}

void complete_metric(const Extrusion& extrusion, const Points& points, BaseMetric& metric,
                     ThreadTeam& team) {
  if (metric.pair_weight.empty()) add_cells(extrusion, points, metric, team);
}

}  // namespace sweepmesh
