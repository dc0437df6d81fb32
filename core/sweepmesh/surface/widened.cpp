#include "sweepmesh/surface/widened.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sweepmesh/numerics/ascent/soft_least.h"
#include "sweepmesh/surface/regular_cells.h"

namespace sweepmesh {
namespace {

/// Gain in scaled Jacobian that weighs as much as one in length over the wished one.
constexpr double exchange = 0.8;
/// Of the mean scaled Jacobian, of the mean square of what sides lack, and of that of the moves in
/// wished lengths: what lies over a node on the other cap does not move with it.
constexpr double weight_of_angles = 10.0, weight_of_lengths = 6.0, weight_of_moves = 16.0;

/// Visits (cell, its side, the first node, the next one).
template <class Visit>
void for_each_side(const PlanarMesh& mesh, const Visit& visit) {
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    for (std::size_t i = 0; i < cell.size(); ++i)
      visit(c, mesh.cell_offset[c] + static_cast<int>(i), cell[i], cell[(i + 1) % cell.size()]);
  }
}

double area_of(const PlanarMesh& mesh, const std::vector<Point2>& points, const Metric& metric) {
  double sum = 0.0;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    std::vector<Point2> corners;
    for (const int node : mesh.cell(c)) corners.push_back(points[node]);
    sum += signed_area(corners) * metric_at(metric, points, mesh.cell(c)).determinant();
  }
  return sum;
}

/// A corner between two edges, seen through the surface's metric.
struct Corner {
  int node, next, previous, cell;
  double factor;  ///< of the sine, so that a regular cell has 1
};

struct Side {
  int a, b, cell;
  double wished;
};

/// The nodes that move, and what is measured at them. Metrics are those at the start: the nodes
/// move by less than the surface turns.
class Widening {
 public:
  Widening(const PlanarMesh& mesh, const std::vector<Point2>& points, const SideLengths& wished,
           const WidenOptions& options, const std::vector<int>& squeezed, const Metric& metric)
      : mesh_(mesh), now_(points), options_(options) {
    for (int c = 0; c < mesh.n_cells(); ++c)
      roots_.push_back(metric_at(metric, points, mesh.cell(c)));
    choose_free(squeezed);
    measure(wished);
  }

  std::vector<Point2> run(const Context& context) {
    least_length_ = least_length();
    for (const Side& s : sides_) typical_ += s.wished / static_cast<double>(sides_.size());
    least_angle_ = std::min(least_angle(), options_.good_enough);
    start_ = now_;
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(2 * static_cast<long>(free_.size()));
    LeastAscentOptions ascent;
    ascent.max_steps = 80;
    ascent.sharpness = {10.0, 30.0, 100.0};
    ascend_least([&](const Eigen::VectorXd& m, double sharpness,
                     Eigen::VectorXd* g) { return soft_value(m, sharpness, g); },
                 ascent, moves, context, "surface");
    put(moves);
    const bool is_better = least_length() > least_length_ && least_angle() >= least_angle_;
    return is_better ? now_ : start_;
  }

 private:
  Point2 edge(int from, int to, int cell) const { return roots_[cell] * (now_[to] - now_[from]); }

  void choose_free(const std::vector<int>& squeezed) {
    std::vector<char> is_near(mesh_.n_nodes(), 0);
    for (const int c : squeezed)
      for (const int node : mesh_.cell(c)) is_near[node] = 1;
    for (int ring = 0; ring < options_.rings; ++ring) {
      const std::vector<char> before = is_near;
      for (int c = 0; c < mesh_.n_cells(); ++c) {
        const auto cell = mesh_.cell(c);
        if (std::any_of(cell.begin(), cell.end(), [&](int n) { return before[n]; }))
          for (const int node : cell) is_near[node] = 1;
      }
    }
    unknown_.assign(mesh_.n_nodes(), -1);
    for (int i = mesh_.n_boundary; i < mesh_.n_nodes(); ++i)
      if (is_near[i]) {
        unknown_[i] = static_cast<int>(free_.size());
        free_.push_back(i);
      }
  }

  void measure(const SideLengths& wished) {
    unit_.assign(free_.size(), std::numeric_limits<double>::infinity());
    for (int c = 0; c < mesh_.n_cells(); ++c) {
      const auto cell = mesh_.cell(c);
      const int n = static_cast<int>(cell.size());
      const double factor = n == 4 ? 1.0 : 1.0 / std::sin(2.0 * std::numbers::pi / n);
      for (int i = 0; i < n; ++i) {
        const int node = cell[i], next = cell[(i + 1) % n], previous = cell[(i + n - 1) % n];
        const bool has_next = is_free(node) || is_free(next);
        if (has_next || is_free(previous)) corners_.push_back({node, next, previous, c, factor});
        if (!has_next) continue;
        const double whole = wished[mesh_.cell_offset[c] + i];
        sides_.push_back({node, next, c, whole});
        for (const int end : {node, next})
          if (is_free(end))
            unit_[unknown_[end]] = std::min(unit_[unknown_[end]], (now_[next] - now_[node]).norm());
      }
    }
  }

  bool is_free(int node) const { return unknown_[node] >= 0; }

  double value(const Corner& c) const {
    const Point2 p = edge(c.node, c.next, c.cell), q = edge(c.node, c.previous, c.cell);
    const double lengths = p.norm() * q.norm();
    return lengths > 0.0 ? c.factor * cross2(p, q) / lengths : 0.0;
  }
  double length(const Side& s) const { return edge(s.a, s.b, s.cell).norm() / s.wished; }
  /// Of what there was at the start. A side that becomes shorter than the shortest was loses as an
  /// angle does that closes.
  double slope(double length) const {
    return length < least_length_ ? 1.0 / least_length_ : exchange;
  }
  double worth(const Corner& c) const { return value(c) / least_angle_; }
  double worth(const Side& s) const {
    const double now = length(s);
    return 1.0 + slope(now) * (now - least_length_);
  }

  double least_length() const {
    double least = std::numeric_limits<double>::infinity();
    for (const Side& s : sides_) least = std::min(least, length(s));
    return least;
  }
  double least_angle() const {
    double least = 1.0;
    for (const Corner& c : corners_) least = std::min(least, value(c));
    return least;
  }

  void put(const Eigen::VectorXd& moves) {
    for (std::size_t i = 0; i < free_.size(); ++i)
      now_[free_[i]] = start_[free_[i]] + unit_[i] * moves.segment<2>(2 * static_cast<long>(i));
  }

  void add(int node, const Point2& g, Eigen::VectorXd& gradient) const {
    if (is_free(node)) gradient.segment<2>(2L * unknown_[node]) += unit_[unknown_[node]] * g;
  }

  void add_gradient(const Corner& c, double weight, Eigen::VectorXd& gradient) const {
    const Point2 p = edge(c.node, c.next, c.cell), q = edge(c.node, c.previous, c.cell);
    const double pp = p.squaredNorm(), qq = q.squaredNorm(), lengths = std::sqrt(pp * qq);
    if (!(lengths > 0.0)) return;
    const double v = cross2(p, q) / lengths;
    const Eigen::Matrix2d across = roots_[c.cell].transpose();
    const Point2 by_p =
        weight * c.factor * (across * (Point2(q.y(), -q.x()) / lengths - v / pp * p));
    const Point2 by_q =
        weight * c.factor * (across * (Point2(-p.y(), p.x()) / lengths - v / qq * q));
    add(c.next, by_p, gradient);
    add(c.previous, by_q, gradient);
    add(c.node, -by_p - by_q, gradient);
  }

  void add_gradient(const Side& s, double weight, Eigen::VectorXd& gradient) const {
    const Point2 e = edge(s.a, s.b, s.cell);
    if (!(e.norm() > 0.0)) return;
    const Point2 g = weight / (s.wished * e.norm()) * (roots_[s.cell].transpose() * e);
    add(s.b, g, gradient);
    add(s.a, -g, gradient);
  }

  /// The soft least and the means: the least alone would take any cell down to the worst one, and
  /// any side down to the shortest.
  double soft_value(const Eigen::VectorXd& moves, double sharpness, Eigen::VectorXd* gradient) {
    put(moves);
    const std::size_t n = corners_.size(), m = sides_.size();
    values_.resize(n + m);
    for (std::size_t i = 0; i < n; ++i) values_[i] = worth(corners_[i]);
    for (std::size_t i = 0; i < m; ++i) values_[n + i] = worth(sides_[i]);
    if (gradient) gradient->setZero();
    const double means = add_means(gradient);
    const double soft = soft_least(values_, sharpness);
    if (!gradient) return soft + means;
    for (std::size_t i = 0; i < n; ++i)
      add_gradient(corners_[i], values_[i] / least_angle_, *gradient);
    for (std::size_t i = 0; i < m; ++i)
      add_gradient(sides_[i], slope(length(sides_[i])) * values_[n + i], *gradient);
    return soft + means;
  }

  double add_means(Eigen::VectorXd* gradient) const {
    const auto share = [](double weight, const auto& of) {
      return weight / static_cast<double>(of.size());
    };
    const double of_angle = share(weight_of_angles, corners_),
                 of_side = share(weight_of_lengths, sides_),
                 of_move = share(weight_of_moves, free_) / (typical_ * typical_);
    double sum = 0.0;
    for (const Corner& c : corners_) {
      sum += of_angle * value(c);
      if (gradient) add_gradient(c, of_angle, *gradient);
    }
    for (const Side& s : sides_) {
      const double missing = std::max(0.0, 1.0 - length(s));
      sum -= of_side * missing * missing;
      if (gradient) add_gradient(s, 2.0 * of_side * missing, *gradient);
    }
    for (const int node : free_) {
      const Point2 move = now_[node] - start_[node];
      sum -= of_move * move.squaredNorm();
      if (gradient) add(node, -2.0 * of_move * move, *gradient);
    }
    return sum;
  }

  const PlanarMesh& mesh_;
  std::vector<Point2> now_, start_;
  const WidenOptions& options_;
  std::vector<Eigen::Matrix2d> roots_;  ///< by cell
  std::vector<int> free_, unknown_;
  std::vector<double> unit_, values_;
  std::vector<Corner> corners_;
  std::vector<Side> sides_;
  double typical_ = 0.0;  ///< wished length
  double least_length_ = 0.0, least_angle_ = 0.0;
};

}  // namespace

SideLengths lengths_like(const PlanarMesh& mesh, const Metric& metric,
                         const std::vector<Point2>& points, const Metric& there) {
  const double scale =
      std::sqrt(std::max(0.0, area_of(mesh, points, there)) / area_of(mesh, mesh.points, metric));
  SideLengths out(mesh.cell_nodes.size());
  for_each_side(mesh, [&](int c, int side, int a, int b) {
    const Eigen::Matrix2d root = metric_at(metric, mesh.points, mesh.cell(c));
    out[side] = scale * (root * (mesh.points[b] - mesh.points[a])).norm();
  });
  return out;
}

SideLengths lengths_of_regular(const PlanarMesh& mesh, const Metric& metric) {
  const std::vector<double> of_cell = wished_lengths(mesh, metric);
  SideLengths out(mesh.cell_nodes.size());
  for_each_side(mesh, [&](int c, int side, int, int) { out[side] = of_cell[c]; });
  return out;
}

std::vector<int> cells_narrower_than(double share, const PlanarMesh& mesh,
                                     const std::vector<Point2>& points, const SideLengths& wished,
                                     const Metric& metric) {
  std::vector<int> out;
  for_each_side(mesh, [&](int c, int side, int a, int b) {
    if (std::max(a, b) < mesh.n_boundary || (!out.empty() && out.back() == c)) return;
    const Eigen::Matrix2d root = metric_at(metric, points, mesh.cell(c));
    if ((root * (points[b] - points[a])).norm() < share * wished[side]) out.push_back(c);
  });
  return out;
}

double evenness(const PlanarMesh& mesh, const std::vector<Point2>& points,
                const SideLengths& wished, const Metric& metric) {
  double sum = 0.0;
  long n = 0;
  for_each_side(mesh, [&](int c, int side, int a, int b) {
    if (std::max(a, b) < mesh.n_boundary) return;
    const Eigen::Matrix2d root = metric_at(metric, points, mesh.cell(c));
    sum += std::min(1.0, (root * (points[b] - points[a])).norm() / wished[side]);
    ++n;
  });
  return n == 0 ? 1.0 : sum / static_cast<double>(n);
}

std::vector<Point2> widened(const PlanarMesh& mesh, const std::vector<Point2>& points,
                            const SideLengths& wished, const WidenOptions& options,
                            const Metric& metric, const Context& context) {
  const auto squeezed = cells_narrower_than(options.squeezed, mesh, points, wished, metric);
  if (squeezed.empty() || quality(points, mesh, metric).n_inverted > 0) return points;
  return Widening(mesh, points, wished, options, squeezed, metric).run(context);
}

}  // namespace sweepmesh
