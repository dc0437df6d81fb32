#include "sweepmesh/volume/one_to_one.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <map>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

[[noreturn]] void refuse(const char* why) {
  throw InputError("place",
                   std::string("This method of placement is for one-to-one sweeps only: ") + why);
}

std::vector<std::array<int, 2>> find_rim_edges(const Extrusion& x) {
  std::map<std::array<int, 2>, int> seen;
  const auto for_edges = [&](auto&& f) {
    for (int c = 0; c < x.n_cells(); ++c)
      for (int i = 0; i < x.cell_size(c); ++i)
        f(x.cell_columns[x.cell_offset[c] + i],
          x.cell_columns[x.cell_offset[c] + (i + 1) % x.cell_size(c)]);
  };
  for_edges([&](int a, int b) { ++seen[{std::min(a, b), std::max(a, b)}]; });
  std::vector<std::array<int, 2>> edges;
  for_edges([&](int a, int b) {
    if (seen[{std::min(a, b), std::max(a, b)}] == 1) edges.push_back({a, b});
  });
  return edges;
}

/// Pseudo-inverse of a symmetric matrix of moments.
Eigen::Matrix3d pseudo_inverse(const Eigen::Matrix3d& m) {
  constexpr double smallest = 64.0 * std::numeric_limits<double>::epsilon();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  Point3 inverse = Point3::Zero();
  for (int i = 0; i < 3; ++i)
    if (solver.eigenvalues()[i] > smallest * solver.eigenvalues()[2])
      inverse[i] = 1.0 / solver.eigenvalues()[i];
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

Point3 mean_of(const std::vector<Point3>& points) {
  Point3 sum = Point3::Zero();
  for (const Point3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Sums of outer products of pairs u -> v.
struct Moments {
  Eigen::Matrix3d uu = Eigen::Matrix3d::Zero(), vu = Eigen::Matrix3d::Zero();
  void add(const Point3& u, const Point3& v) {
    uu += u * u.transpose();
    vu += v * u.transpose();
  }
  Eigen::Matrix3d map() const { return vu * pseudo_inverse(uu); }
};

/// A loop is planar when it is thinner than this part of its width.
bool is_planar(const Eigen::Matrix3d& moments) {
  constexpr double thin = 1e-6;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] <= thin * thin * solver.eigenvalues()[2];
}

}  // namespace

std::vector<Point3> OneToOne::rim_at(const Points& points, int k) const {
  std::vector<Point3> out;
  for (const int c : rim) out.push_back(at(points, c, k));
  return out;
}

std::vector<std::vector<int>> OneToOne::loops() const {
  std::map<int, std::vector<int>> next;
  for (const auto& [a, b] : rim_edges) next[a].push_back(b);
  std::vector<std::vector<int>> loops;
  for (auto& [start, ends] : next)
    while (!ends.empty()) {
      std::vector<int>& loop = loops.emplace_back();
      int node = start;
      do {
        loop.push_back(node);
        std::vector<int>& out = next[node];
        node = out.back();
        out.pop_back();
      } while (node != start);
    }
  return loops;
}

Point3 OneToOne::rim_area(const Points& points, int k) const {
  const Point3 origin = at(points, rim_edges.front()[0], k);
  Point3 sum = Point3::Zero();
  for (const auto& [a, b] : rim_edges)
    sum += (at(points, a, k) - origin).cross(at(points, b, k) - origin);
  return 0.5 * sum;
}

OneToOne make_one_to_one(const Extrusion& extrusion, const std::vector<char>& fixed,
                         const BaseMetric& metric) {
  OneToOne sweep = {extrusion, 0, 0, {}, {}, {}, {}};
  const Extrusion& x = extrusion;
  if (x.n_cells() == 0) refuse("there is no cell.");
  sweep.k_low = x.cell_k_low[0];
  sweep.k_high = x.cell_k_high[0];
  const auto is_other = [](const std::vector<int>& v, int k) {
    return std::any_of(v.begin(), v.end(), [=](int i) { return i != k; });
  };
  if (is_other(x.cell_k_low, sweep.k_low) || is_other(x.cell_k_high, sweep.k_high) ||
      is_other(x.k_low, sweep.k_low) || is_other(x.k_high, sweep.k_high))
    refuse("its runs begin or end at different layers.");
  sweep.rim_edges = find_rim_edges(x);
  std::vector<char> is_rim(x.n_columns(), 0);
  for (const auto& [a, b] : sweep.rim_edges) is_rim[a] = is_rim[b] = 1;
  for (int c = 0; c < x.n_columns(); ++c) {
    (is_rim[c] ? sweep.rim : sweep.inner).push_back(c);
    for (int k = sweep.k_low; k <= sweep.k_high; ++k)
      if ((fixed[x.node(c, k)] != 0) != (is_rim[c] || k == sweep.k_low || k == sweep.k_high))
        refuse("nodes are fixed inside it, or free on its boundary.");
  }
  if (sweep.rim.size() < 3) refuse("it has no linking face.");
  sweep.fraction.push_back(0.0);
  for (int k = sweep.k_low; k < sweep.k_high; ++k)
    sweep.fraction.push_back(sweep.fraction.back() + metric.height_of(k));
  for (double& f : sweep.fraction) f /= sweep.fraction.back();
  return sweep;
}

LoopMap fit_points(const std::vector<Point3>& x, const std::vector<Point3>& y, const Point3& area_x,
                   const Point3& area_y, Functional functional) {
  const Point3 cx = mean_of(x), cy = mean_of(y);
  const bool is_g = functional == Functional::g;
  Moments moments;
  for (std::size_t i = 0; i < x.size(); ++i)
    is_g ? moments.add(x[i] - cx + cy - cx, y[i] - cx) : moments.add(x[i] - cx, y[i] - cy);
  if (functional == Functional::h && is_planar(moments.uu))
    moments.add(area_x.normalized(), area_y.normalized());
  const Eigen::Matrix3d a = moments.map();
  return is_g ? LoopMap{a, cx + a * (cy - 2.0 * cx)} : LoopMap{a, cy - a * cx};
}

LoopMap fit_loops(const OneToOne& sweep, const Points& points, int from, int to,
                  Functional functional) {
  return fit_points(sweep.rim_at(points, from), sweep.rim_at(points, to),
                    sweep.rim_area(points, from), sweep.rim_area(points, to), functional);
}

void place_boundary_error(const OneToOne& sweep, Points& points, ThreadTeam& team,
                          const Context& context) {
  const int n_layers = sweep.k_high - sweep.k_low;
  for (const int end : {sweep.k_low, sweep.k_high}) {
    const std::vector<Point3> rim = sweep.rim_at(points, end);
    std::vector<LoopMap> map;
    std::vector<std::vector<Point3>> error(n_layers + 1);
    for (int k = sweep.k_low; k <= sweep.k_high; ++k) {
      map.push_back(fit_loops(sweep, points, end, k, Functional::h));
      for (std::size_t j = 0; j < rim.size(); ++j)
        error[k - sweep.k_low].push_back(sweep.at(points, sweep.rim[j], k) - map.back()(rim[j]));
    }
    team.for_chunks(static_cast<long>(sweep.inner.size()), 16, [&](long begin, long last, long) {
      context.check("place");
      std::vector<double> weight(rim.size());
      for (long i = begin; i < last; ++i) {
        const Point3 own = sweep.at(points, sweep.inner[i], end);
        double sum = 0.0;
        for (std::size_t j = 0; j < rim.size(); ++j)
          sum += weight[j] = 1.0 / (own - rim[j]).squaredNorm();
        for (int k = 1; k < n_layers; ++k) {
          Point3 p = map[k](own);
          for (std::size_t j = 0; j < rim.size(); ++j) p += weight[j] / sum * error[k][j];
          const long node = sweep.extrusion.node(sweep.inner[i], sweep.k_low + k);
          const double s = sweep.fraction[k];
          if (end == sweep.k_low)
            points.row(node) = (1 - s) * p;
          else
            points.row(node) += s * p.transpose();
        }
      }
    });
  }
}

}  // namespace sweepmesh
