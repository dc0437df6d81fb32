#include "sweepmesh/imprint/domain_division.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/surface/regular_cells.h"

namespace sweepmesh {
namespace {

/// Cells that are worse than this are worth a cut.
constexpr double poor = 0.1;

/// A domain by the numbers of its nodes among all points.
using Rings = std::vector<std::vector<int>>;

/// From node a to node b of a loop, by their places there, a before b; in `n` mesh edges.
struct Chord {
  std::size_t loop = 0, a = 0, b = 0;
  int n = 1;
  double value = 0.0;
};

double value_of(const PlanarMesh& mesh) {
  return quality(mesh.points, mesh).min;
}

/// How well cells fill a corner: the sine of their angle there, when they are as many as fit best.
double corner_value(double angle) {
  const double n = std::max(1.0, std::round(angle / (std::numbers::pi / 2)));
  return std::sin(angle / n);
}

double angle_between(const Point2& from, const Point2& to) {
  const double angle = std::atan2(cross2(from, to), from.dot(to));
  return angle > 0.0 ? angle : angle + 2 * std::numbers::pi;
}

bool cross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return cross2(b - a, c - a) * cross2(b - a, d - a) <= 0.0 &&
         cross2(d - c, a - c) * cross2(d - c, b - c) <= 0.0;
}

class Divider {
 public:
  Divider(const PlanarLoops& loops, const PlanarMeshOptions& options, const Context& context)
      : options_(options), context_(context), points_(flattened(loops)) {
    int next = 0;
    for (const auto& loop : loops) {
      whole_.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i) whole_.back().push_back(next++);
    }
  }

  std::optional<PlanarMesh> run(const PlanarMesh& mesh) { return cut(whole_, mesh); }

 private:
  // --- chords ------------------------------------------------------------------------------------

  /// Of a domain's boundary nodes (in the row of all loops) those of poor cells.
  static std::set<int> troubled(const PlanarMesh& mesh) {
    std::set<int> out;
    for (int c = 0; c < mesh.n_cells(); ++c)
      if (scaled_jacobian(mesh.points, mesh.cell(c)) < poor)
        for (const int n : mesh.cell(c))
          if (n < mesh.n_boundary) out.insert(n);
    return out;
  }

  const Point2& at(const std::vector<int>& loop, std::size_t i) const {
    return points_[loop[i % loop.size()]];
  }

  std::vector<Chord> chords(const Rings& rings, const std::set<int>& wanted) const {
    std::vector<Chord> out;
    int first = 0;
    for (std::size_t l = 0; l < rings.size(); ++l) {
      const std::size_t n = rings[l].size();
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = a + 2; b < n && b - a + 2 <= n; ++b) {
          if (!wanted.contains(first + static_cast<int>(a)) &&
              !wanted.contains(first + static_cast<int>(b)))
            continue;
          if (auto c = chord(rings, l, a, b)) out.push_back(*c);
        }
      first += static_cast<int>(n);
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Chord& a, const Chord& b) { return a.value > b.value; });
    return out;
  }

  /// With as many edges as come nearest to the wished size and leave the parts even.
  std::optional<Chord> chord(const Rings& rings, std::size_t l, std::size_t a,
                             std::size_t b) const {
    const auto& loop = rings[l];
    const Point2 d = at(loop, b) - at(loop, a);
    const double corners = std::min(corners_at(loop, a, d), corners_at(loop, b, -d));
    if (corners <= 0.0 || !is_visible(rings, at(loop, a), at(loop, b))) return std::nullopt;
    const double share = d.norm() / options_.size;
    const bool is_odd = (b - a) % 2 != 0;
    const int n = is_odd ? 1 + 2 * static_cast<int>(std::max(0.0, std::round((share - 1.0) / 2)))
                         : 2 * static_cast<int>(std::max(1.0, std::round(share / 2)));
    if (is_odd && n == 1 && (b - a == 1 || loop.size() - (b - a) == 1)) return std::nullopt;
    const double length = share / n;
    const double stretch = std::min(1.0, 2.0 * std::min(length, 1.0 / length));
    return Chord{l, a, b, n,
                 corners * clearance(rings, at(loop, a), at(loop, b)) * (n == 1 ? 1.0 : stretch)};
  }

  /// The worse of the two corners that a chord along `d` leaves at a node; negative outside.
  double corners_at(const std::vector<int>& loop, std::size_t i, const Point2& d) const {
    const Point2& here = at(loop, i);
    const Point2 next = at(loop, i + 1) - here, before = at(loop, i + loop.size() - 1) - here;
    const double whole = angle_between(next, before), first = angle_between(next, d);
    if (first >= whole) return -1.0;
    return std::min(corner_value(first), corner_value(whole - first));
  }

  bool is_visible(const Rings& rings, const Point2& a, const Point2& b) const {
    for (const auto& loop : rings)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point2 &c = at(loop, i), &d = at(loop, i + 1);
        if (c == a || c == b || d == a || d == b) continue;
        if (cross(a, b, c, d)) return false;
      }
    return true;
  }

  /// 1 where no other node is nearer to the chord than a third of its length or of the size.
  double clearance(const Rings& rings, const Point2& a, const Point2& b) const {
    const double wished = std::min(options_.size, (b - a).norm()) / 3;
    double least = wished;
    for (const auto& loop : rings)
      for (const int n : loop)
        if (points_[n] != a && points_[n] != b)
          least = std::min(least, nearest({a, b}, points_[n]).distance);
    return least / wished;
  }

  // --- parts -------------------------------------------------------------------------------------

  PlanarLoops loops_of(const Rings& rings) const {
    PlanarLoops out;
    for (const auto& loop : rings) {
      out.emplace_back();
      for (const int n : loop) out.back().push_back(points_[n]);
    }
    return out;
  }

  /// The two parts of a domain, the chord's new nodes being points first..; the outer loop first in
  /// each.
  std::array<Rings, 2> divided(const Rings& rings, const Chord& c, int first) const {
    const auto& loop = rings[c.loop];
    std::vector<int> one(loop.begin() + c.a, loop.begin() + c.b + 1);
    std::vector<int> two(loop.begin() + c.b, loop.end());
    two.insert(two.end(), loop.begin(), loop.begin() + c.a + 1);
    for (int i = 1; i < c.n; ++i) two.push_back(first + i - 1);
    for (int i = c.n - 1; i > 0; --i) one.push_back(first + i - 1);
    if (c.loop > 0 && signed_area(loops_of({one}).front()) < 0.0) std::swap(one, two);
    std::array<Rings, 2> out = {Rings{one}, c.loop > 0 ? Rings{rings[0], two} : Rings{two}};
    const PlanarLoops outer = loops_of({one});
    for (std::size_t l = 1; l < rings.size(); ++l)
      if (l != c.loop) out[encloses(outer.front(), at(rings[l], 0)) ? 0 : 1].push_back(rings[l]);
    return out;
  }

  static bool encloses(const std::vector<Point2>& loop, const Point2& p) {
    double turned = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 from = loop[i] - p, to = loop[(i + 1) % loop.size()] - p;
      turned += std::atan2(cross2(from, to), from.dot(to));
    }
    return std::abs(turned) > std::numbers::pi;
  }

  /// What is good enough: half of what the sharpest corner of the boundary admits, if not more.
  static double wanted(const PlanarLoops& loops) {
    double out = poor;
    for (const double angle : interior_angles(loops))
      out = std::min(out, 0.5 * corner_value(angle));
    return out;
  }

  /// The best mesh of a domain that is not cut; empty where there is none.
  std::optional<PlanarMesh> meshed(const Rings& rings) {
    if (++n_meshed_ > most_meshed_) return std::nullopt;
    const PlanarLoops loops = loops_of(rings);
    std::optional<PlanarMesh> best;
    try {
      for (PlanarMesh& m : candidate_meshes(loops, options_, {interior_angles(loops)}, context_))
        if (!best || overall_quality(m) > overall_quality(*best)) best = std::move(m);
    } catch (const InputError&) {
      return std::nullopt;
    } catch (const SolverError&) {
      return std::nullopt;
    }
    return best;
  }

  struct Cut {
    std::array<Rings, 2> part;
    std::array<PlanarMesh, 2> mesh;
    double value() const { return std::min(value_of(mesh[0]), value_of(mesh[1])); }
  };

  std::optional<Cut> cut_along(const Rings& rings, const Chord& c) {
    const int first = static_cast<int>(points_.size());
    const Point2 a = at(rings[c.loop], c.a), b = at(rings[c.loop], c.b);
    for (int i = 1; i < c.n; ++i) points_.push_back(a + (b - a) * i / c.n);
    Cut out{divided(rings, c, first), {}};
    for (int i = 0; i < 2; ++i) {
      auto mesh = meshed(out.part[i]);
      if (!mesh) return std::nullopt;
      out.mesh[i] = std::move(*mesh);
    }
    return out;
  }

  /// The domain cut along the chord that leaves the best parts, these cut again where they are
  /// poor; empty where that is no better than `mesh`.
  std::optional<PlanarMesh> cut(const Rings& rings, const PlanarMesh& mesh) {
    constexpr std::size_t most_chords = 4;
    std::vector<Chord> all = chords(rings, troubled(mesh));
    if (all.size() > most_chords) all.resize(most_chords);
    std::optional<Cut> best;
    for (const Chord& c : all) {
      context_.check("surface");
      std::optional<Cut> made = cut_along(rings, c);
      if (made && (!best || made->value() > best->value())) best = std::move(made);
      if (best && best->value() >= wanted(loops_of(rings))) break;
    }
    if (!best) return std::nullopt;
    for (int i = 0; i < 2; ++i)
      if (value_of(best->mesh[i]) < wanted(loops_of(best->part[i])))
        if (auto better = cut(best->part[i], best->mesh[i])) best->mesh[i] = std::move(*better);
    PlanarMesh out = smoothed(joined(rings, best->part, best->mesh), options_.metric, context_);
    if (value_of(out) <= value_of(mesh)) return std::nullopt;
    return out;
  }

  /// One mesh of the parts' meshes; nodes on the chord are inside.
  PlanarMesh joined(const Rings& rings, const std::array<Rings, 2>& parts,
                    const std::array<PlanarMesh, 2>& meshes) const {
    PlanarMesh out;
    std::vector<int> number(points_.size(), -1);
    const auto add = [&](const std::vector<int>& nodes) {
      for (const int n : nodes) {
        if (number[n] >= 0) continue;
        number[n] = out.n_nodes();
        out.points.push_back(points_[n]);
      }
    };
    for (const auto& loop : rings) add(loop);
    out.n_boundary = out.n_nodes();
    for (int i = 0; i < 2; ++i) {
      std::vector<int> node;
      for (const auto& loop : parts[i]) {
        add(loop);
        for (const int n : loop) node.push_back(number[n]);
      }
      const PlanarMesh& mesh = meshes[i];
      for (int n = mesh.n_boundary; n < mesh.n_nodes(); ++n) {
        node.push_back(out.n_nodes());
        out.points.push_back(mesh.points[n]);
      }
      for (int c = 0; c < mesh.n_cells(); ++c) {
        std::vector<int> cell;
        for (const int n : mesh.cell(c)) cell.push_back(node[n]);
        out.add_cell(cell);
      }
    }
    return out;
  }

  static constexpr int most_meshed_ = 10;  ///< parts; cuts that lead nowhere must come to an end
  const PlanarMeshOptions& options_;
  const Context& context_;
  int n_meshed_ = 0;
  std::vector<Point2> points_;  ///< of the boundary, and of chords
  Rings whole_;
};

}  // namespace

std::optional<PlanarMesh> mesh_divided(const PlanarLoops& loops, const PlanarMesh& mesh,
                                       const PlanarMeshOptions& options, const Context& context) {
  return Divider(loops, options, context).run(mesh);
}

}  // namespace sweepmesh
