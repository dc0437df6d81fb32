#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sweepmesh/volume/cage.h"

namespace sweepmesh {
namespace {

enum class Tag : char { untyped, boundary, interior, exterior };

/// A regular grid of cells around the cage. A value is a deformed position: the sum over cage
/// vertices of their harmonic coordinate times where they are, by linearity of the Laplacian.
class Grid {
 public:
  Grid(const Cage& cage, int n_cells) {
    const double infinity = std::numeric_limits<double>::infinity();
    Point3 low = Point3::Constant(infinity), high = -low;
    for (const Point3& p : cage.ideal) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    h_ = (high - low).maxCoeff() / n_cells;
    origin_ = low - Point3::Constant(1.5 * h_);  // a ring of exterior cells all around
    for (int d = 0; d < 3; ++d) n_[d] = static_cast<int>((high[d] - low[d]) / h_) + 4;
    tag_.assign(n_[0] * n_[1] * n_[2], Tag::untyped);
    value_.assign(tag_.size(), Point3::Zero());
  }

  void scan_convert(const Cage& cage) {
    std::vector<int> count(tag_.size(), 0);
    for (const auto& t : cage.triangles) {
      double longest = 0.0;
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, (cage.ideal[t[i]] - cage.ideal[t[(i + 1) % 3]]).norm());
      const int n = 1 + static_cast<int>(3.0 * longest / h_);
      for (int a = 0; a <= n; ++a)
        for (int b = 0; a + b <= n; ++b) {
          const Point3 w(static_cast<double>(a) / n, static_cast<double>(b) / n,
                         static_cast<double>(n - a - b) / n);
          Point3 p = Point3::Zero(), q = p;
          for (int i = 0; i < 3; ++i) {
            p += w[i] * cage.ideal[t[i]];
            q += w[i] * cage.actual[t[i]];
          }
          const int cell = cell_at(p);
          tag_[cell] = Tag::boundary;
          value_[cell] += q;
          ++count[cell];
        }
    }
    for (std::size_t c = 0; c < tag_.size(); ++c)
      if (count[c] > 0) value_[c] /= count[c];
  }

  void fill() {
    std::vector<int> stack = {0};
    tag_[0] = Tag::exterior;
    while (!stack.empty()) {
      const int cell = stack.back();
      stack.pop_back();
      for_neighbours(cell, [&](int b) {
        if (tag_[b] != Tag::untyped) return;
        tag_[b] = Tag::exterior;
        stack.push_back(b);
      });
    }
    Point3 mean = Point3::Zero();
    int n_boundary = 0;
    for (std::size_t c = 0; c < tag_.size(); ++c)
      if (tag_[c] == Tag::boundary) {
        mean += value_[c];
        ++n_boundary;
      }
    for (std::size_t c = 0; c < tag_.size(); ++c)
      if (tag_[c] == Tag::untyped) {
        tag_[c] = Tag::interior;
        value_[c] = mean / n_boundary;
      }
  }

  /// Successive over-relaxation until a sweep changes no value by more than `change`.
  void relax(double change, const Context& context) {
    const double omega = 2.0 / (1.0 + std::sin(std::numbers::pi / *std::max_element(n_, n_ + 3)));
    for (double largest = change + 1.0; largest > change;) {
      context.check("place");
      largest = 0.0;
      for (std::size_t c = 0; c < tag_.size(); ++c) {
        if (tag_[c] != Tag::interior) continue;
        Point3 mean = Point3::Zero();
        for_neighbours(static_cast<int>(c), [&](int b) { mean += value_[b] / 6.0; });
        const Point3 step = omega * (mean - value_[c]);
        value_[c] += step;
        largest = std::max(largest, step.norm());
      }
    }
  }

  /// Trilinear between the centres of cells; exterior ones count nothing.
  Point3 operator()(const Point3& p) const {
    const Point3 t = (p - origin_) / h_ - Point3::Constant(0.5);
    Point3 sum = Point3::Zero();
    double total = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      int index[3];
      double weight = 1.0;
      for (int d = 0; d < 3; ++d) {
        const int low = static_cast<int>(std::floor(t[d])), bit = (corner >> d) & 1;
        index[d] = low + bit;
        weight *= bit ? t[d] - low : 1.0 - (t[d] - low);
      }
      const int cell = index[0] + n_[0] * (index[1] + n_[1] * index[2]);
      if (tag_[cell] == Tag::exterior) continue;
      sum += weight * value_[cell];
      total += weight;
    }
    return total > 0.0 ? Point3(sum / total) : value_[cell_at(p)];
  }

 private:
  int cell_at(const Point3& p) const {
    int index[3];
    for (int d = 0; d < 3; ++d) index[d] = static_cast<int>((p[d] - origin_[d]) / h_);
    return index[0] + n_[0] * (index[1] + n_[1] * index[2]);
  }
  template <class F>
  void for_neighbours(int cell, F&& f) const {
    const int index[3] = {cell % n_[0], cell / n_[0] % n_[1], cell / (n_[0] * n_[1])};
    const int step[3] = {1, n_[0], n_[0] * n_[1]};
    for (int d = 0; d < 3; ++d) {
      if (index[d] > 0) f(cell - step[d]);
      if (index[d] + 1 < n_[d]) f(cell + step[d]);
    }
  }

  Point3 origin_;
  double h_ = 1.0;
  int n_[3];
  std::vector<Tag> tag_;
  std::vector<Point3> value_;
};

}  // namespace

std::vector<Point3> harmonic_grid_positions(const Cage& cage, int n_cells, const Context& context) {
  constexpr double relative_change = 1e-6;
  double size = 0.0;
  for (const Point3& p : cage.actual) size = std::max(size, (p - cage.actual.front()).norm());
  Grid grid(cage, n_cells);
  grid.scan_convert(cage);
  grid.fill();
  grid.relax(relative_change * size, context);
  std::vector<Point3> out;
  for (const Point3& p : cage.inner_ideal) out.push_back(grid(p));
  return out;
}

}  // namespace sweepmesh
