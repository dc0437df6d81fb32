#include "sweepmesh/volume/raise_least.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/element_index.h"
#include "sweepmesh/volume/element_patches.h"

namespace sweepmesh {
namespace {

using Numbers = std::vector<long>;

/// Three sums of edges; their normalised determinant times `factor` is a value. A corner's are its
/// own edges, a centre's the principal axes.
struct Triple {
  /// Nodes, numbered within the patch; a corner uses the first four (itself, then its neighbours).
  std::array<int, 8> node;
  bool is_centre = false;
  double factor = 1.0;
};

/// An edge, nodes numbered within the patch. Its value is its length by `length`, which keeps it
/// from shrinking: scaled Jacobians do not change where a whole element does.
struct Rod {
  int a, b;
  bool is_column;
  double length = 0.0;
};

/// Signs of a hexahedron's corners (low ring, high ring) in its principal axes.
constexpr std::array<std::array<double, 8>, 3> axis_signs = {
    {{-1, 1, 1, -1, -1, 1, 1, -1}, {-1, -1, 1, 1, -1, -1, 1, 1}, {-1, -1, -1, -1, 1, 1, 1, 1}}};

using Axes = std::array<Point3, 3>;

Axes axes_of(const Triple& t, const Points& x) {
  Axes axes;
  for (int d = 0; d < 3; ++d) {
    if (!t.is_centre) {
      axes[d] = x.row(t.node[d + 1]) - x.row(t.node[0]);
      continue;
    }
    axes[d].setZero();
    for (int i = 0; i < 8; ++i) axes[d] += axis_signs[d][i] * Point3(x.row(t.node[i]));
  }
  return axes;
}

double value_of(const Triple& t, const Axes& a) {
  const double lengths = std::sqrt(a[0].squaredNorm() * a[1].squaredNorm() * a[2].squaredNorm());
  return lengths > 0.0 ? t.factor * a[0].cross(a[1]).dot(a[2]) / lengths : 0.0;
}

/// Adds `weight` times the gradient of the value to the rows of the triple's nodes.
void add_gradient(const Triple& t, const Axes& a, double weight, Points& rows) {
  const double lengths = std::sqrt(a[0].squaredNorm() * a[1].squaredNorm() * a[2].squaredNorm());
  if (!(lengths > 0.0)) return;
  const double value = value_of(t, a);
  for (int d = 0; d < 3; ++d) {
    const Point3 g = weight * (t.factor / lengths * a[(d + 1) % 3].cross(a[(d + 2) % 3]) -
                               value / a[d].squaredNorm() * a[d]);
    if (t.is_centre) {
      for (int i = 0; i < 8; ++i) rows.row(t.node[i]) += axis_signs[d][i] * g.transpose();
    } else {
      rows.row(t.node[d + 1]) += g.transpose();
      rows.row(t.node[0]) -= g.transpose();
    }
  }
}

/// One patch, its nodes numbered anew: free ones first. The unknowns are moves of the free nodes,
/// each in units of the shortest edge at the node.
class PatchAscent {
 public:
  PatchAscent(const Extrusion& x, const ElementIndex& index, const ElementPatch& patch,
              const std::vector<SlidingNode>& sliding, const Points& points, double least)
      : patch_(patch), n_free_(static_cast<int>(patch.free_nodes.size())) {
    for (const long e : patch.elements)
      index.for_nodes(index.element(e), [&](long n) { held_.push_back(n); });
    sort_unique(held_);
    std::erase_if(held_, [&](long n) {
      return std::binary_search(patch.free_nodes.begin(), patch.free_nodes.end(), n);
    });
    start_.resize(n_free_ + static_cast<long>(held_.size()), 3);
    for (long i = 0; i < start_.rows(); ++i)
      start_.row(i) = points.row(i < n_free_ ? patch.free_nodes[i] : held_[i - n_free_]);
    unit_.assign(start_.rows(), std::numeric_limits<double>::infinity());
    for (const long e : patch.elements) add_element(x, index.element(e));
    set_lengths(least);
    for (const SlidingNode& s : sliding) {
      const long i = position_in(patch.free_nodes, s.node);
      if (i < n_free_ && patch.free_nodes[i] == s.node)
        sliding_.emplace_back(static_cast<int>(i), s.normal);
    }
    now_ = gradient_ = start_;
  }

  /// The free nodes' positions after the ascent.
  Points ascend(const LeastAscentOptions& options, const Context& context) {
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(3L * n_free_);
    ascend_least([&](const Eigen::VectorXd& m, double sharpness,
                     Eigen::VectorXd* g) { return soft_value(m, sharpness, g); },
                 options, moves, context, "place");
    put(moves);
    return now_.topRows(n_free_);
  }

 private:
  int local(long node) const {
    const long i = position_in(patch_.free_nodes, node);
    const bool is_free = i < n_free_ && patch_.free_nodes[i] == node;
    return static_cast<int>(is_free ? i : n_free_ + position_in(held_, node));
  }

  void add_element(const Extrusion& x, SweptElement e) {
    const int n = x.cell_size(e.cell);
    const int* columns = x.cell_columns.data() + x.cell_offset[e.cell];
    std::vector<int> node(2 * n);
    for (int i = 0; i < n; ++i)
      for (const int up : {0, 1}) node[up * n + i] = local(x.node(columns[i], e.k + up));
    const double factor = n == 4 ? 1.0 : 1.0 / std::sin(2.0 * std::numbers::pi / n);
    for (int i = 0; i < n; ++i)
      for (const int up : {0, 1}) {
        const int next = up * n + (i + 1) % n, last = up * n + (i + n - 1) % n;
        add({{node[up * n + i], node[up ? last : next], node[up ? next : last],
              node[(1 - up) * n + i]},
             false,
             factor});
      }
    for (int i = 0; i < n; ++i) {
      for (const int ring : {0, n}) add_rod(node[ring + i], node[ring + (i + 1) % n], false);
      add_rod(node[i], node[n + i], true);
    }
    if (n != 4) return;
    Triple centre{{}, true, 1.0};
    std::copy_n(node.begin(), 8, centre.node.begin());
    add(centre);
  }

  void add(const Triple& t) {
    const int n = t.is_centre ? 8 : 4;
    if (std::none_of(t.node.begin(), t.node.begin() + n, [&](int i) { return i < n_free_; }))
      return;
    triples_.push_back(t);
    if (t.is_centre) return;
    for (int i = 1; i < 4; ++i) {
      const double length = (start_.row(t.node[i]) - start_.row(t.node[0])).norm();
      for (const int j : {t.node[0], t.node[i]}) unit_[j] = std::min(unit_[j], length);
    }
  }

  void add_rod(int a, int b, bool is_column) {
    if (std::min(a, b) < n_free_) rods_.push_back({std::min(a, b), std::max(a, b), is_column});
  }

  /// Edges may become half as long as those of their kind are in the mean, times the least value;
  /// those that are shorter already may not become shorter.
  void set_lengths(double least) {
    const auto key = [](const Rod& r) { return std::pair{r.a, r.b}; };
    std::ranges::sort(rods_, {}, key);
    rods_.erase(std::ranges::unique(rods_, {}, key).begin(), rods_.end());
    std::array<double, 2> sum{}, count{};
    for (Rod& r : rods_) {
      r.length = (start_.row(r.a) - start_.row(r.b)).norm();
      sum[r.is_column] += r.length;
      ++count[r.is_column];
    }
    constexpr double half = 0.5, tiny = 1e-3;
    for (Rod& r : rods_)
      r.length =
          std::min(half * sum[r.is_column] / count[r.is_column], r.length / std::max(least, tiny));
  }

  void put(const Eigen::VectorXd& moves) {
    for (int i = 0; i < n_free_; ++i)
      now_.row(i) = start_.row(i) + unit_[i] * moves.segment<3>(3L * i).transpose();
  }

  double soft_value(const Eigen::VectorXd& moves, double sharpness, Eigen::VectorXd* gradient) {
    constexpr double negligible = 1e-9;  // weight
    put(moves);
    const std::size_t n = triples_.size();
    values_.resize(n + rods_.size());
    for (std::size_t t = 0; t < n; ++t)
      values_[t] = value_of(triples_[t], axes_of(triples_[t], now_));
    for (std::size_t r = 0; r < rods_.size(); ++r) values_[n + r] = along(rods_[r]).norm();
    const double value = soft_least(values_, sharpness);
    if (!gradient) return value;
    gradient_.setZero();
    for (std::size_t t = 0; t < n; ++t)
      if (values_[t] > negligible)
        add_gradient(triples_[t], axes_of(triples_[t], now_), values_[t], gradient_);
    for (std::size_t r = 0; r < rods_.size(); ++r)
      if (values_[n + r] > negligible) {
        const Point3 g = values_[n + r] / rods_[r].length * along(rods_[r]).normalized();
        gradient_.row(rods_[r].b) += g.transpose();
        gradient_.row(rods_[r].a) -= g.transpose();
      }
    for (const auto& [i, normal] : sliding_)
      gradient_.row(i) -= gradient_.row(i).dot(normal.transpose()) * normal.transpose();
    for (int i = 0; i < n_free_; ++i)
      gradient->segment<3>(3L * i) = unit_[i] * gradient_.row(i).transpose();
    return value;
  }

  /// An edge in units of its length.
  Point3 along(const Rod& r) const { return (now_.row(r.b) - now_.row(r.a)) / r.length; }

  const ElementPatch& patch_;
  int n_free_;
  Numbers held_;
  Points start_, now_, gradient_;
  std::vector<double> unit_, values_;
  std::vector<Triple> triples_;
  std::vector<Rod> rods_;
  std::vector<std::pair<int, Point3>> sliding_;
};

double least_of(const Extrusion& x, const ElementIndex& index, const Points& points,
                const Numbers& elements) {
  double least = 1.0;
  for (const long e : elements)
    least = std::min(least, scaled_jacobian_of(x, points, index.element(e)));
  return least;
}

void raise_patch(const Extrusion& x, const ElementIndex& index, const ElementPatch& patch,
                 const RaiseOptions& options, const Context& context, Points& points) {
  if (patch.free_nodes.empty()) return;
  const double before = least_of(x, index, points, patch.elements);
  PatchAscent ascent(x, index, patch, options.sliding, points, before);
  const Points after = ascent.ascend(options.ascent, context);
  Points old(after.rows(), 3);
  for (long i = 0; i < after.rows(); ++i) {
    old.row(i) = points.row(patch.free_nodes[i]);
    points.row(patch.free_nodes[i]) = after.row(i);
  }
  if (least_of(x, index, points, patch.elements) > before) return;
  for (long i = 0; i < after.rows(); ++i) points.row(patch.free_nodes[i]) = old.row(i);
}

}  // namespace

void raise_least(const Extrusion& extrusion, const std::vector<char>& fixed, Points& points,
                 const RaiseOptions& options, const Numbers& elements, ThreadTeam& team,
                 const Context& context) {
  const ElementIndex index(extrusion);
  const std::vector<char> is_held = without_sliding(fixed, options.sliding);
  const std::vector<ElementPatch> patches = find_patches(index, is_held, elements, options.rings);
  team.for_chunks(static_cast<long>(patches.size()), 1, [&](long p, long, long) {
    raise_patch(extrusion, index, patches[p], options, context, points);
  });
}

}  // namespace sweepmesh
