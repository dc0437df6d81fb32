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

double angle_at(const Point3& tip, const Point3& a, const Point3& b) {
  return std::atan2((a - tip).cross(b - tip).norm(), (a - tip).dot(b - tip));
}

void add_polygon(const PolygonMatrix& m, const Point3* p, double factor) {
  if (m.n == 4) {
    // The diagonal 0-2 is Delaunay when the angles that face it add up to less than half a turn.
    const double facing = angle_at(p[1], p[0], p[2]) + angle_at(p[3], p[2], p[0]);
    const double other = angle_at(p[0], p[3], p[1]) + angle_at(p[2], p[1], p[3]);
    add_fan(m, p, facing <= other ? 0 : 1, factor);
    return;
  }
  const int n_fans = m.n == 3 ? 1 : m.n;
  for (int apex = 0; apex < n_fans; ++apex) add_fan(m, p, apex, factor / n_fans);
}

void add_cells(const Extrusion& x, const Points& points, BaseMetric& metric) {
  for (int c = 0; c < x.n_cells(); ++c) {
    const long n = x.cell_size(c);
    metric.pair_offset.push_back(metric.pair_offset.back() + n * (n - 1) / 2);
  }
  metric.pair_weight.assign(metric.pair_offset.back(), 0.0);
  metric.corner_mass.assign(x.cell_columns.size(), 0.0);
  std::vector<Point3> p;
  for (int c = 0; c < x.n_cells(); ++c) {
    const PolygonMatrix m = {x.cell_size(c), &metric.pair_weight[metric.pair_offset[c]],
                             &metric.corner_mass[x.cell_offset[c]]};
    p.resize(m.n);
    for (const int k : {x.cell_k_low[c], x.cell_k_high[c]}) {
      for (int i = 0; i < m.n; ++i)
        p[i] = points.row(x.node(x.cell_columns[x.cell_offset[c] + i], k));
      add_polygon(m, p.data(), 0.5);
    }
    for (int i = 0; i < m.n; ++i)
      for (int j = i + 1; j < m.n; ++j) m.weight(i, j) = std::max(0.0, m.weight(i, j));
  }
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

void set_heights(const Extrusion& x, const std::vector<char>& fixed, const Points& points,
                 BaseMetric& metric) {
  const int first = *std::min_element(x.k_low.begin(), x.k_low.end());
  const int last = *std::max_element(x.k_high.begin(), x.k_high.end());
  metric.k_first = first;
  HeightSums linking(last - first), runs(last - first);
  for (int c = 0; c < x.n_columns(); ++c)
    for (int k = x.k_low[c]; k < x.k_high[c]; ++k) {
      const long node = x.node(c, k);
      if (fixed[node] && fixed[node + 1])
        linking.add(k - first, (points.row(node + 1) - points.row(node)).norm());
    }
  for (int c = 0; c < x.n_cells(); ++c) {
    const int low = x.cell_k_low[c], high = x.cell_k_high[c];
    const int column = x.cell_columns[x.cell_offset[c]];
    const double length =
        (points.row(x.node(column, high)) - points.row(x.node(column, low))).norm();
    for (int k = low; k < high; ++k) runs.add(k - first, length / (high - low));
  }
  metric.height.assign(last - first, 1.0);
  for (int k = 0; k < last - first; ++k) {
    const HeightSums& sums = linking.length[k] > 0.0 ? linking : runs;
    if (sums.length[k] > 0.0) metric.height[k] = sums.length[k] / sums.count[k];
  }
}

}  // namespace

BaseMetric make_base_metric(const Extrusion& extrusion, const std::vector<char>& fixed,
                            const Points& points) {
  BaseMetric metric;
  if (extrusion.n_cells() == 0) return metric;
  add_cells(extrusion, points, metric);
  set_heights(extrusion, fixed, points, metric);
  return metric;
}

}  // namespace sweepmesh
