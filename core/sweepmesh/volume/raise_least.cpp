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

bool contains(const Numbers& sorted, long value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

/// Three sums of edges; their normalised determinant times `factor` is a value. A corner's are its
/// own edges, a centre's the principal axes.
struct Triple {
  /// Nodes, numbered within the patch; a corner uses the first four (itself, then its neighbours).
  std::array<int, 8> node;
  bool is_centre = false;
  double factor = 1.0;
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

/// An edge: its value is that of its length over the one it had.
struct Edge {
  int a, b;
  double whole;  ///< length
};
constexpr double shortest_share = 0.4, steepness = 5.0;

double value_of(const Edge& e, const Points& x) {
  return steepness * ((x.row(e.a) - x.row(e.b)).norm() / e.whole - shortest_share);
}

void add_gradient(const Edge& e, double weight, const Points& x, Points& rows) {
  const Eigen::RowVector3d along = x.row(e.a) - x.row(e.b);
  const double length = along.norm();
  if (!(length > 0.0)) return;
  const Eigen::RowVector3d g = weight * steepness / (e.whole * length) * along;
  rows.row(e.a) += g;
  rows.row(e.b) -= g;
}

/// One patch, its nodes numbered anew: free ones first. The unknowns are moves of the free nodes,
/// each in units of the shortest edge at the node.
class PatchAscent {
 public:
  PatchAscent(const Extrusion& x, const ElementIndex& index, const ElementPatch& patch,
              const RaiseOptions& options, const Points& points)
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
    add_edges(options.lengths_of ? *options.lengths_of : points);
    for (int i = 0; i < n_free_; ++i) {
      const long node = patch.free_nodes[i];
      if (const SlidingNode* s = find_sliding(options.sliding, node))
        sliding_.emplace_back(i, s->normal);
      else if (contains(options.curved.nodes, node))
        sliding_.emplace_back(i, options.curved.onto(node, start_.row(i)).normal);
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

  /// Of the triples' corners, each once.
  void add_edges(const Points& whole) {
    std::vector<std::pair<int, int>> pairs;
    for (const Triple& t : triples_)
      for (int i = 1; !t.is_centre && i < 4; ++i)
        if (std::min(t.node[0], t.node[i]) < n_free_)
          pairs.emplace_back(std::minmax(t.node[0], t.node[i]));
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    const auto global = [&](int i) {
      return i < n_free_ ? patch_.free_nodes[i] : held_[i - n_free_];
    };
    for (const auto& [a, b] : pairs) {
      const double length = (whole.row(global(a)) - whole.row(global(b))).norm();
      if (length > 0.0) edges_.push_back({a, b, length});
    }
  }

  void put(const Eigen::VectorXd& moves) {
    for (int i = 0; i < n_free_; ++i)
      now_.row(i) = start_.row(i) + unit_[i] * moves.segment<3>(3L * i).transpose();
  }

  double soft_value(const Eigen::VectorXd& moves, double sharpness, Eigen::VectorXd* gradient) {
    constexpr double negligible = 1e-9;  // weight
    put(moves);
    const std::size_t n = triples_.size();
    values_.resize(n + edges_.size());
    for (std::size_t t = 0; t < n; ++t)
      values_[t] = value_of(triples_[t], axes_of(triples_[t], now_));
    for (std::size_t e = 0; e < edges_.size(); ++e) values_[n + e] = value_of(edges_[e], now_);
    const double value = soft_least(values_, sharpness);
    if (!gradient) return value;
    gradient_.setZero();
    for (std::size_t t = 0; t < n; ++t)
      if (values_[t] > negligible)
        add_gradient(triples_[t], axes_of(triples_[t], now_), values_[t], gradient_);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (values_[n + e] > negligible) add_gradient(edges_[e], values_[n + e], now_, gradient_);
    for (const auto& [i, normal] : sliding_)
      gradient_.row(i) -= gradient_.row(i).dot(normal.transpose()) * normal.transpose();
    for (int i = 0; i < n_free_; ++i)
      gradient->segment<3>(3L * i) = unit_[i] * gradient_.row(i).transpose();
    return value;
  }

  const ElementPatch& patch_;
  int n_free_;
  Numbers held_;
  Points start_, now_, gradient_;
  std::vector<double> unit_, values_;
  std::vector<Triple> triples_;
  std::vector<Edge> edges_;
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
  PatchAscent ascent(x, index, patch, options, points);
  const double before = least_of(x, index, points, patch.elements);
  const Points after = ascent.ascend(options.ascent, context);
  Points old(after.rows(), 3);
  for (long i = 0; i < after.rows(); ++i) {
    old.row(i) = points.row(patch.free_nodes[i]);
    const long node = patch.free_nodes[i];
    points.row(node) = after.row(i);
    if (contains(options.curved.nodes, node))
      points.row(node) = options.curved.onto(node, after.row(i)).point;
  }
  if (least_of(x, index, points, patch.elements) > before) return;
  for (long i = 0; i < after.rows(); ++i) points.row(patch.free_nodes[i]) = old.row(i);
}

}  // namespace

std::vector<char> without_moving(const std::vector<char>& fixed, const RaiseOptions& options) {
  std::vector<char> held = without_sliding(fixed, options.sliding);
  for (const long node : options.curved.nodes) held[node] = 0;
  return held;
}

void raise_least(const Extrusion& extrusion, const std::vector<char>& fixed, Points& points,
                 const RaiseOptions& options, const Numbers& elements, ThreadTeam& team,
                 const Context& context) {
  const ElementIndex index(extrusion);
  const std::vector<char> is_held = without_moving(fixed, options);
  const std::vector<ElementPatch> patches = find_patches(index, is_held, elements, options.rings);
  team.for_chunks(static_cast<long>(patches.size()), 1, [&](long p, long, long) {
    raise_patch(extrusion, index, patches[p], options, context, points);
  });
}

}  // namespace sweepmesh
