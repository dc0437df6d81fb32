// Families of extrusions for the tests: a base mesh, layers, and a map that says where nodes
// belong.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "sweepmesh/base/geometry.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh::testing {

/// A base mesh in the plane: grid nodes with their places, cells counterclockwise.
struct Base {
  std::vector<Point2> points;
  std::vector<std::vector<int>> cells;

  std::vector<char> boundary() const {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& cell : cells)
      for (std::size_t i = 0; i < cell.size(); ++i) {
        const int a = cell[i], b = cell[(i + 1) % cell.size()];
        ++edges[{std::min(a, b), std::max(a, b)}];
      }
    std::vector<char> is_boundary(points.size(), 0);
    for (const auto& [edge, count] : edges)
      if (count == 1) is_boundary[edge.first] = is_boundary[edge.second] = 1;
    return is_boundary;
  }
};

/// n x n unit quads around the origin without those for which `is_hole(i, j)`.
inline Base make_grid(int nx, int ny, const std::function<bool(int, int)>& is_hole = {}) {
  Base base;
  std::map<std::pair<int, int>, int> node;
  const auto at = [&](int i, int j) {
    const auto [it, is_new] = node.try_emplace({i, j}, static_cast<int>(base.points.size()));
    if (is_new) base.points.emplace_back(i - 0.5 * nx, j - 0.5 * ny);
    return it->second;
  };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      if (!is_hole || !is_hole(i, j))
        base.cells.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return base;
}

/// A square block of n x n quads with a square hole of m x m in its middle.
inline Base make_square_with_hole(int n, int m) {
  const int a = (n - m) / 2;
  return make_grid(n, n, [=](int i, int j) { return i >= a && i < a + m && j >= a && j < a + m; });
}

/// Every quad divided into two triangles, by alternating diagonals.
inline Base with_triangles(const Base& quads) {
  Base base{quads.points, {}};
  for (std::size_t c = 0; c < quads.cells.size(); ++c) {
    const auto& q = quads.cells[c];
    const int s = static_cast<int>(c % 2);
    base.cells.push_back({q[s], q[s + 1], q[s + 2]});
    base.cells.push_back({q[s], q[s + 2], q[(s + 3) % 4]});
  }
  return base;
}

/// Hexagons in rows, n x n.
inline Base make_hexagons(int n) {
  Base base;
  std::map<std::pair<long, long>, int> node;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point2 centre(std::sqrt(3.0) * (i + 0.5 * (j % 2)), 1.5 * j);
      std::vector<int> cell;
      for (int a = 0; a < 6; ++a) {
        const double angle = M_PI * (a / 3.0 + 1.0 / 6.0);
        const Point2 p = centre + Point2(std::cos(angle), std::sin(angle));
        const std::pair<long, long> key(std::lround(p.x() * 1e4), std::lround(p.y() * 1e4));
        const auto [it, is_new] = node.try_emplace(key, static_cast<int>(base.points.size()));
        if (is_new) base.points.push_back(p);
        cell.push_back(it->second);
      }
      base.cells.push_back(cell);
    }
  return base;
}

/// An extrusion, its fixed nodes (all of the boundary) and where its nodes belong.
struct Solid {
  Extrusion extrusion;
  std::vector<char> fixed;
  Points exact;

  /// What placement is given: fixed nodes as they are, free ones far off.
  Points input() const {
    Points points = exact;
    for (long n = 0; n < points.rows(); ++n)
      if (!fixed[n]) points.row(n).setConstant(1e6);
    return points;
  }
  double size() const { return (exact.colwise().maxCoeff() - exact.colwise().minCoeff()).norm(); }
};

using Map = std::function<Point3(double, double, double)>;

/// One run: `map` takes (x, y) of the base and w in 0..1 through the layers.
inline Solid make_solid(const Base& base, int n_layers, const Map& map) {
  Solid solid;
  const std::vector<char> is_boundary = base.boundary();
  for (std::size_t c = 0; c < base.points.size(); ++c) solid.extrusion.add_column(0, n_layers);
  for (const auto& cell : base.cells) solid.extrusion.add_cell(cell, 0, n_layers);
  solid.exact.resize(solid.extrusion.n_nodes(), 3);
  for (std::size_t c = 0; c < base.points.size(); ++c)
    for (int k = 0; k <= n_layers; ++k) {
      solid.exact.row(solid.extrusion.node(static_cast<int>(c), k)) =
          map(base.points[c].x(), base.points[c].y(), static_cast<double>(k) / n_layers);
      solid.fixed.push_back(k == 0 || k == n_layers || is_boundary[c]);
    }
  return solid;
}

/// Several runs: cell c reaches from range(c).first to range(c).second; columns are glued where
/// runs overlap. Fixed: ends of runs and whatever has an outer face beside it.
inline Solid make_steps(const Base& base,
                        const std::function<std::pair<int, int>(const Point2&)>& range,
                        int n_layers, const Map& map) {
  Solid solid;
  std::vector<int> low(base.points.size(), n_layers), high(base.points.size(), 0);
  std::vector<std::pair<int, int>> ranges;
  for (const auto& cell : base.cells) {
    Point2 centre = Point2::Zero();
    for (const int n : cell) centre += base.points[n] / cell.size();
    ranges.push_back(range(centre));
    for (const int n : cell) {
      low[n] = std::min(low[n], ranges.back().first);
      high[n] = std::max(high[n], ranges.back().second);
    }
  }
  for (std::size_t n = 0; n < base.points.size(); ++n) solid.extrusion.add_column(low[n], high[n]);
  for (std::size_t c = 0; c < base.cells.size(); ++c)
    solid.extrusion.add_cell(base.cells[c], ranges[c].first, ranges[c].second);
  solid.exact.resize(solid.extrusion.n_nodes(), 3);
  solid.fixed.assign(solid.extrusion.n_nodes(), 0);
  for (std::size_t n = 0; n < base.points.size(); ++n)
    for (int k = low[n]; k <= high[n]; ++k)
      solid.exact.row(solid.extrusion.node(static_cast<int>(n), k)) =
          map(base.points[n].x(), base.points[n].y(), static_cast<double>(k) / n_layers);
  for (int k = 0; k < n_layers; ++k) {  // edges with one cell in this layer bound the solid
    Base section{base.points, {}};
    for (std::size_t c = 0; c < base.cells.size(); ++c)
      if (ranges[c].first <= k && k < ranges[c].second) section.cells.push_back(base.cells[c]);
    const std::vector<char> is_boundary = section.boundary();
    for (std::size_t n = 0; n < base.points.size(); ++n)
      if (is_boundary[n])
        for (int end : {k, k + 1}) solid.fixed[solid.extrusion.node(static_cast<int>(n), end)] = 1;
  }
  for (std::size_t c = 0; c < base.cells.size(); ++c)
    for (const int n : base.cells[c])
      for (const int k : {ranges[c].first, ranges[c].second})
        solid.fixed[solid.extrusion.node(n, k)] = 1;
  return solid;
}

}  // namespace sweepmesh::testing
