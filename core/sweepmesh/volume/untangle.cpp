#include "sweepmesh/volume/untangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sweepmesh/base/element_quality.h"
#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/element_index.h"
#include "sweepmesh/volume/element_patches.h"

namespace sweepmesh {
namespace {

using Numbers = std::vector<long>;

/// Ideal corners of an element, from the intrinsic metric.
class IdealElement {
 public:
  IdealElement(const Extrusion& x, const BaseMetric& metric, const Points& points,
               bool keeps_lengths)
      : x_(x), metric_(metric), points_(points), keeps_lengths_(keeps_lengths) {}

  /// Calls f(o, a, b, c, W) for each corner; W is the matrix of the ideal edges.
  template <class F>
  void for_corners(SweptElement e, F&& f) const {
    const int n = x_.cell_size(e.cell);
    const double angle = std::numbers::pi * (1.0 - 2.0 / n);
    const int* columns = x_.cell_columns.data() + x_.cell_offset[e.cell];
    for (int i = 0; i < n; ++i) {
      const int next = columns[(i + 1) % n], last = columns[(i + n - 1) % n], own = columns[i];
      for (const int up : {0, 1}) {
        const int k = e.k + up, a = up ? last : next, b = up ? next : last;
        const double la = length(e.cell, own, a, k), lb = length(e.cell, own, b, k);
        Eigen::Matrix3d w;
        w << la, lb * std::cos(angle), 0, 0, lb * std::sin(angle), 0, 0, 0, height(own, e.k);
        f(x_.node(own, k), x_.node(a, k), x_.node(b, k), x_.node(own, up ? e.k : e.k + 1), w);
      }
    }
  }

 private:
  double distance(int a, int ka, int b, int kb) const {
    return (points_.row(x_.node(a, ka)) - points_.row(x_.node(b, kb))).norm();
  }
  double height(int column, int k) const {
    return keeps_lengths_ ? distance(column, k, column, k + 1) : metric_.height_of(k);
  }
  double length(int cell, int a, int b, int k) const {
    if (keeps_lengths_) return distance(a, k, b, k);
    const int low = x_.cell_k_low[cell], high = x_.cell_k_high[cell];
    const double s = static_cast<double>(k - low) / (high - low);
    return (1.0 - s) * distance(a, low, b, low) + s * distance(a, high, b, high);
  }

  const Extrusion& x_;
  const BaseMetric& metric_;
  const Points& points_;
  bool keeps_lengths_;
};

/// The energy's problem on one patch, with its nodes numbered anew: free ones first.
struct PatchProblem {
  UnfoldProblem problem;
  Points x;

  PatchProblem(const ElementPatch& patch, const ElementIndex& index, const IdealElement& ideal,
               const std::vector<SlidingNode>& sliding, const Points& points) {
    Numbers held;
    for (const long e : patch.elements)
      index.for_nodes(index.element(e), [&](long n) { held.push_back(n); });
    sort_unique(held);
    std::erase_if(held, [&](long n) {
      return std::binary_search(patch.free_nodes.begin(), patch.free_nodes.end(), n);
    });
    problem.n_free = static_cast<int>(patch.free_nodes.size());
    x.resize(problem.n_free + static_cast<long>(held.size()), 3);
    for (long i = 0; i < x.rows(); ++i)
      x.row(i) = points.row(i < problem.n_free ? patch.free_nodes[i] : held[i - problem.n_free]);
    const auto local = [&](long node) {
      const long i = position_in(patch.free_nodes, node);
      const bool is_free = i < problem.n_free && patch.free_nodes[i] == node;
      return static_cast<int>(is_free ? i : problem.n_free + position_in(held, node));
    };
    double volume = 0.0, ideal_volume = 0.0;
    for (const long e : patch.elements)
      ideal.for_corners(
          index.element(e), [&](long o, long a, long b, long c, const Eigen::Matrix3d& w) {
            const Point3 p = points.row(o);
            const Point3 pa = points.row(a), pb = points.row(b), pc = points.row(c);
            volume += (pa - p).cross(pb - p).dot(pc - p);
            ideal_volume += w.determinant();
            problem.corners.push_back({{local(o), local(a), local(b), local(c)}, w.inverse()});
          });
    for (int i = 0; i < problem.n_free; ++i)
      if (const SlidingNode* s = find_sliding(sliding, patch.free_nodes[i]))
        problem.sliding.emplace_back(i, s->normal);
    // Ideal elements fill the patch as it is.
    if (volume > 0.0)
      for (CornerTet& corner : problem.corners) corner.ideal *= std::cbrt(ideal_volume / volume);
  }
};

/// How good a patch is: fewer elements up to the threshold, then a greater least value.
struct Worth {
  long n_bad = 0;
  double least = 1.0;

  bool is_better_than(const Worth& other) const {
    if (other.least > 0.0 && least < other.least) return false;
    return n_bad < other.n_bad || (n_bad == other.n_bad && least > other.least);
  }
};

Worth worth_of(const Extrusion& x, const ElementIndex& index, const Points& points,
               const Numbers& elements, double threshold) {
  Worth worth;
  for (const long e : elements) {
    const double value = scaled_jacobian_of(x, points, index.element(e));
    worth.n_bad += !(value > threshold);
    worth.least = std::min(worth.least, value);
  }
  return worth;
}

void mend(const Extrusion& x, const BaseMetric& metric, const ElementIndex& index,
          const ElementPatch& patch, const UntangleOptions& options, const Context& context,
          Points& points) {
  if (patch.free_nodes.empty()) return;
  const IdealElement ideal(x, metric, points, options.keeps_lengths);
  PatchProblem local(patch, index, ideal, options.sliding, points);
  const Points before = local.x.topRows(local.problem.n_free);
  const Worth old_worth = worth_of(x, index, points, patch.elements, options.threshold);
  minimise_foldover(local.problem, local.x, options.energy, context);
  const auto put = [&](const Points& rows) {
    for (int i = 0; i < local.problem.n_free; ++i) points.row(patch.free_nodes[i]) = rows.row(i);
  };
  // The least energy is not the greatest least value: part of the way may be better than all of it.
  const Points after = local.x.topRows(local.problem.n_free);
  for (const double part : {1.0, 0.5, 0.25, 0.125}) {
    put(before + part * (after - before));
    if (worth_of(x, index, points, patch.elements, options.threshold).is_better_than(old_worth))
      return;
  }
  put(before);
}

/// A corner's node and its neighbours, right-handed; the last is the one above or below.
std::array<long, 4> corner_nodes(const Extrusion& x, SweptElement e, int i, int up) {
  const int n = x.cell_size(e.cell), k = e.k + up;
  const int* columns = x.cell_columns.data() + x.cell_offset[e.cell];
  const int next = columns[(i + 1) % n], last = columns[(i + n - 1) % n];
  return {x.node(columns[i], k), x.node(up ? last : next, k), x.node(up ? next : last, k),
          x.node(columns[i], up ? e.k : e.k + 1)};
}

}  // namespace

const SlidingNode* find_sliding(const std::vector<SlidingNode>& sliding, long node) {
  const auto it = std::lower_bound(sliding.begin(), sliding.end(), node,
                                   [](const SlidingNode& s, long n) { return s.node < n; });
  return it != sliding.end() && it->node == node ? &*it : nullptr;
}

std::vector<char> without_sliding(std::vector<char> fixed,
                                  const std::vector<SlidingNode>& sliding) {
  for (const SlidingNode& s : sliding) fixed[s.node] = 0;
  return fixed;
}

UntangleReport untangle(const Extrusion& extrusion, const BaseMetric& metric,
                        const std::vector<char>& fixed, Points& points,
                        const UntangleOptions& options, const Numbers& elements, ThreadTeam& team,
                        const Context& context) {
  const ElementIndex index(extrusion);
  const std::vector<char> is_held = without_sliding(fixed, options.sliding);
  UntangleReport report;
  report.remaining = elements;
  std::size_t last_size = 0;
  for (int rings = options.first_rings; report.n_attempts < options.max_attempts; rings *= 2) {
    if (report.remaining.empty()) break;
    ++report.n_attempts;
    const std::vector<ElementPatch> patches = find_patches(index, is_held, report.remaining, rings);
    std::size_t size = 0;
    for (const ElementPatch& patch : patches) size += patch.elements.size();
    if (size == last_size) break;  // rings have reached the ends of the mesh
    last_size = size;
    team.for_chunks(static_cast<long>(patches.size()), 1, [&](long p, long, long) {
      mend(extrusion, metric, index, patches[p], options, context, points);
    });
    Numbers remaining;
    report.n_moved = 0;
    for (const ElementPatch& patch : patches) {
      report.n_moved += static_cast<long>(patch.free_nodes.size());
      for (const long e : patch.elements)
        if (!(scaled_jacobian_of(extrusion, points, index.element(e)) > options.threshold))
          remaining.push_back(e);
    }
    const auto n_before = static_cast<double>(report.remaining.size()),
               n_left = static_cast<double>(remaining.size());
    report.remaining = std::move(remaining);
    // Where so much is left, or more room has hardly helped, yet more never has, and costs most.
    constexpr double hopeless = 0.1, hardly = 0.9;
    if (n_left > hopeless * static_cast<double>(extrusion.n_elements())) break;
    if (report.n_attempts > 1 && n_left > hardly * n_before) break;
  }
  sort_unique(report.remaining);
  return report;
}

double bound_by_boundary(const Extrusion& extrusion, const std::vector<char>& fixed,
                         const Points& points, SweptElement element) {
  const int n = extrusion.cell_size(element.cell);
  const double ideal = n == 4 ? 1.0 : std::sin(2.0 * std::numbers::pi / n);
  double bound = 1.0;
  for (int i = 0; i < n; ++i)
    for (const int up : {0, 1}) {
      const std::array<long, 4> corner = corner_nodes(extrusion, element, i, up);
      if (!fixed[corner[0]]) continue;
      const Point3 o = points.row(corner[0]);
      std::array<Point3, 3> side;
      int n_fixed = 0;
      bool has_upright = false;
      for (int j = 1; j < 4; ++j) {
        if (!fixed[corner[j]]) continue;
        has_upright = has_upright || j == 3;
        side[n_fixed++] = Point3(points.row(corner[j])) - o;
      }
      if (n_fixed < 2) continue;
      const double value = n_fixed == 3
                               ? normalised_determinant(side[0], side[1], side[2])
                               : side[0].cross(side[1]).norm() / (side[0].norm() * side[1].norm());
      // Only a corner of the ideal polygon counts as less than one.
      bound = std::min(bound, value / (n_fixed == 2 && has_upright ? 1.0 : ideal));
    }
  return bound;
}

std::vector<long> hopeless_elements(const Extrusion& extrusion, const std::vector<char>& fixed,
                                    const Points& points, const std::vector<long>& elements) {
  const ElementIndex index(extrusion);
  std::vector<long> hopeless;
  for (const long number : elements) {
    const SweptElement e = index.element(number);
    bool is_hopeless = false;
    for (int i = 0; i < extrusion.cell_size(e.cell); ++i)
      for (const int up : {0, 1}) {
        const std::array<long, 4> corner = corner_nodes(extrusion, e, i, up);
        if (!std::all_of(corner.begin(), corner.end(), [&](long c) { return fixed[c] != 0; }))
          continue;
        const Point3 o = points.row(corner[0]);
        const Point3 a = points.row(corner[1]), b = points.row(corner[2]),
                     c = points.row(corner[3]);
        is_hopeless = is_hopeless || !(normalised_determinant(a - o, b - o, c - o) > kDegenerate);
      }
    if (is_hopeless) hopeless.push_back(number);
  }
  return hopeless;
}

}  // namespace sweepmesh
