#include "sweepmesh/surface/submap_place.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <map>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

struct Extent {
  GridPoint low, high;
};

Extent extent_of(const GridRegion& r) {
  Extent e{r.nodes.front(), r.nodes.front()};
  for (const auto& p : r.nodes) {
    e.low = {std::min(e.low.i, p.i), std::min(e.low.k, p.k)};
    e.high = {std::max(e.high.i, p.i), std::max(e.high.k, p.k)};
  }
  return e;
}

/// Arc length fractions along a side.
std::vector<double> fractions(const std::vector<int>& side, const std::vector<Point3>& points) {
  std::vector<double> at(side.size(), 0.0);
  for (std::size_t s = 1; s < side.size(); ++s)
    at[s] = at[s - 1] + (points[side[s]] - points[side[s - 1]]).norm();
  for (double& a : at) a /= at.back();
  return at;
}

/// The nodes of a rectangle by column and row.
class Rectangle {
 public:
  explicit Rectangle(const GridRegion& r) : e_(extent_of(r)) {
    at_.assign((width() + 1) * (height() + 1), -1);
    for (std::size_t n = 0; n < r.nodes.size(); ++n)
      at_[index(r.nodes[n].i - e_.low.i, r.nodes[n].k - e_.low.k)] = static_cast<int>(n);
  }
  int width() const { return e_.high.i - e_.low.i; }
  int height() const { return e_.high.k - e_.low.k; }
  int node(int i, int k) const { return at_[index(i, k)]; }

  std::vector<int> row(int k) const {
    std::vector<int> out;
    for (int i = 0; i <= width(); ++i) out.push_back(node(i, k));
    return out;
  }
  std::vector<int> column(int i) const {
    std::vector<int> out;
    for (int k = 0; k <= height(); ++k) out.push_back(node(i, k));
    return out;
  }

 private:
  int index(int i, int k) const { return k * (width() + 1) + i; }
  Extent e_;
  std::vector<int> at_;
};

/// The weighted edges of the grid, each once.
std::map<std::pair<int, int>, double> grid_weights(const PlacedRegion& p) {
  const GridSpacing spacing(p);
  std::map<std::pair<int, int>, double> weight;
  for (const auto& cell : p.region.cells)
    for (int c = 0; c < 4; ++c) {
      const GridPoint low = p.region.nodes[cell[0]];
      const double length = c % 2 == 0 ? spacing.of_column(low.i) : spacing.of_row(low.k);
      const int a = cell[c], b = cell[(c + 1) % 4];
      weight[{std::min(a, b), std::max(a, b)}] = 1.0 / length;
    }
  return weight;
}

}  // namespace

GridSpacing::GridSpacing(const PlacedRegion& p) {
  const auto& r = p.region;
  double sum = 0.0;
  int n = 0;
  for (const auto& cell : r.cells)
    for (int c = 0; c < 4; ++c) {
      const int a = cell[c], b = cell[(c + 1) % 4];
      if (a >= r.n_boundary || b >= r.n_boundary) continue;
      const GridPoint low = r.nodes[cell[0]];
      auto& entry = c % 2 == 0 ? along_i_[low.i] : along_k_[low.k];
      const double length = (p.points[a] - p.points[b]).norm();
      entry.first += length;
      entry.second += 1;
      sum += length;
      ++n;
    }
  if (n > 0) overall_ = sum / n;
}

/// Rows of a tube have no step of their own: the mean of all steps stands in.
double GridSpacing::mean(const Table& table, int at) const {
  const auto found = table.find(at);
  return found == table.end() ? overall_ : found->second.first / found->second.second;
}

bool is_rectangle(const GridRegion& r) {
  const Extent e = extent_of(r);
  const int width = e.high.i - e.low.i, height = e.high.k - e.low.k;
  return static_cast<int>(r.cells.size()) == width * height &&
         static_cast<int>(r.nodes.size()) == (width + 1) * (height + 1) &&
         r.n_boundary == 2 * (width + height);
}

void place_transfinite(PlacedRegion& p) {
  const Rectangle grid(p.region);
  const int w = grid.width(), h = grid.height();
  const auto bottom = fractions(grid.row(0), p.points), top = fractions(grid.row(h), p.points);
  const auto left = fractions(grid.column(0), p.points),
             right = fractions(grid.column(w), p.points);
  p.uv.resize(p.region.nodes.size());
  const auto at = [&](int i, int k) -> Point2& { return p.uv[grid.node(i, k)]; };
  for (int k = 1; k < h; ++k) {
    for (int i = 1; i < w; ++i) {
      const double db = top[i] - bottom[i], dl = right[k] - left[k];
      const double x = (bottom[i] + left[k] * db) / (1.0 - db * dl), y = left[k] + x * dl;
      const Point2 sides = (1 - x) * at(0, k) + x * at(w, k) + (1 - y) * at(i, 0) + y * at(i, h);
      const Point2 corners =
          (1 - x) * ((1 - y) * at(0, 0) + y * at(0, h)) + x * ((1 - y) * at(w, 0) + y * at(w, h));
      at(i, k) = sides - corners;
    }
  }
}

bool is_plain_tube(const PlacedRegion& p) {
  const Extent e = extent_of(p.region);
  return p.period > 0 && p.region.n_boundary == 2 * p.period &&
         static_cast<int>(p.region.cells.size()) == p.period * (e.high.k - e.low.k);
}

void place_ruled(PlacedRegion& p) {
  const Extent e = extent_of(p.region);
  const auto around = [&](int i) { return ((i % p.period) + p.period) % p.period; };
  std::vector<Point2> low(p.period), high(p.period);
  for (int n = 0; n < p.region.n_boundary; ++n) {
    const GridPoint at = p.region.nodes[n];
    (at.k == e.low.k ? low : high)[around(at.i)] = p.uv[n];
  }
  for (std::size_t n = p.region.n_boundary; n < p.region.nodes.size(); ++n) {
    const GridPoint at = p.region.nodes[n];
    const double share = static_cast<double>(at.k - e.low.k) / (e.high.k - e.low.k);
    p.uv.push_back((1.0 - share) * low[around(at.i)] + share * high[around(at.i)]);
  }
}

void place_harmonic(PlacedRegion& p) {
  const int n_fixed = p.region.n_boundary;
  const int n_free = static_cast<int>(p.region.nodes.size()) - n_fixed;
  p.uv.resize(p.region.nodes.size());
  if (n_free == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n_free, 2);
  const auto add = [&](int free, int other, double w) {
    if (free < n_fixed) return;
    entries.emplace_back(free - n_fixed, free - n_fixed, w);
    if (other < n_fixed)
      right.row(free - n_fixed) += w * p.uv[other].transpose();
    else
      entries.emplace_back(free - n_fixed, other - n_fixed, -w);
  };
  for (const auto& [ends, w] : grid_weights(p)) {
    add(ends.first, ends.second, w);
    add(ends.second, ends.first, w);
  }
  Eigen::SparseMatrix<double> matrix(n_free, n_free);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success)
    throw SolverError("surface", "The interior of a structured grid could not be computed.");
  const Eigen::MatrixX2d uv = factor.solve(right);
  for (int n = 0; n < n_free; ++n) p.uv[n_fixed + n] = uv.row(n).transpose();
}

}  // namespace sweepmesh
