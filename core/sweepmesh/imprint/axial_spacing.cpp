#include "sweepmesh/imprint/axial_spacing.h"

#include <algorithm>
#include <limits>
#include <map>

#include "sweepmesh/base/element_quality.h"
#include "sweepmesh/imprint/edge_lengths.h"
#include "sweepmesh/surface/linking_columns.h"

namespace sweepmesh {
namespace {

/// What draws one layer of a line.
struct Pull {
  double distance = std::numeric_limits<double>::infinity();
  double at = 0.0;  ///< where it is nearest

  void offer(double other_distance, double other_at) {
    if (other_distance < distance) *this = {other_distance, other_at};
  }
};

/// A place that is wished for, and how strongly; 0 is not at all.
struct Wish {
  double at = 0.0, weight = 0.0;
};

/// Minimises sum (step / rest - 1)^2 + sum weight (x - wish)^2 over the inner x with both ends
/// fixed, by elimination from the first to the last; `x` gives the rests, in units of their mean.
std::vector<double> settled(const std::vector<double>& x, const std::vector<Wish>& wish) {
  const int n = static_cast<int>(x.size()) - 1;
  const auto stiffness = [&](int step) {  // of the step before x[step]
    const double rest = x[step] - x[step - 1];
    return 1.0 / (rest * rest);
  };
  const auto tension = [&](int step) { return 1.0 / (x[step] - x[step - 1]); };
  std::vector<double> out = x, diagonal(n + 1, 1.0), right(n + 1, 0.0);
  for (int i = 1; i < n; ++i) {
    const double below = stiffness(i), ratio = i > 1 ? below / diagonal[i - 1] : 0.0;
    diagonal[i] = below + stiffness(i + 1) + wish[i].weight - ratio * below;
    right[i] = tension(i) - tension(i + 1) + wish[i].weight * wish[i].at;
    right[i] += i > 1 ? ratio * right[i - 1] : below * x[0];
    if (i == n - 1) right[i] += stiffness(n) * x[n];
  }
  for (int i = n - 1; i > 0; --i)
    out[i] = (right[i] + (i < n - 1 ? stiffness(i + 1) * out[i + 1] : 0.0)) / diagonal[i];
  return out;
}

/// As near to `wished` as can be on the way from `x`, with no step below a quarter of the mean one.
std::vector<double> with_least_step(const std::vector<double>& x,
                                    const std::vector<double>& wished) {
  constexpr double least = 0.25;
  double share = 1.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double before = x[i] - x[i - 1], after = wished[i] - wished[i - 1];
    if (after < least && after < before)
      share = std::min(share, std::max(0.0, (before - least) / (before - after)));
  }
  std::vector<double> out;
  for (std::size_t i = 0; i < x.size(); ++i) out.push_back(x[i] + share * (wished[i] - x[i]));
  return out;
}

Wish wish_of(const Pull& pull, double size, double tolerance) {
  constexpr double reach = 0.45;  // sizes, at which a pull is as strong as a spring
  const double near = reach * size / std::max(pull.distance, tolerance);
  return {pull.at, near * near};
}

class Spacer {
 public:
  Spacer(const Model& model, const Scheme& scheme, const Intervals& intervals,
         const IntervalOptions& options)
      : model_(model), intervals_(intervals), size_(options.size) {
    for (const EdgeId e : model.edges())
      if (scheme.edge_role[e.index] == EdgeRole::transverse) add_points(e);
  }

  void space(EdgeId e, std::vector<double>& t) const {
    const int k_start = k_of(model_.start(e)), k_end = k_of(model_.end(e));
    const int n = static_cast<int>(t.size()) - 1, up = k_end > k_start ? 1 : -1;
    std::vector<Wish> wishes(n + 1);
    bool is_drawn = false;
    for (int i = 1; i < n; ++i) {
      const auto at = points_.find(k_start + up * i);
      if (at == points_.end()) continue;
      Pull pull = nearest_pull(e, at->second);
      pull.at = n * length_fractions(model_, e, {pull.at}).front();
      wishes[i] = wish_of(pull, size_, model_.tolerances().point);
      is_drawn = true;
    }
    if (!is_drawn) return;
    std::vector<double> even;
    for (int i = 0; i <= n; ++i) even.push_back(i);
    std::vector<double> fractions = with_least_step(even, settled(even, wishes));
    for (double& f : fractions) f /= n;
    const auto [first, last] = model_.range(e);
    t = model_.at_length_fractions(e, fractions);
    t.front() = first;
    t.back() = last;
  }

 private:
  int k_of(VertexId v) const { return intervals_.k[v.index]; }

  void add_points(EdgeId e) {
    constexpr int n = 8;
    const auto [first, last] = model_.range(e);
    for (int i = 0; i <= n; ++i)
      points_[k_of(model_.start(e))].push_back(model_.point(e, first + (last - first) * i / n));
  }

  Pull nearest_pull(EdgeId e, const std::vector<Point3>& points) const {
    Pull best;
    for (const Point3& p : points) {
      const double t = model_.project(e, p);
      best.offer((model_.point(e, t) - p).norm(), t);
    }
    return best;
  }

  const Model& model_;
  const Intervals& intervals_;
  const double size_;
  std::map<int, std::vector<Point3>> points_;  ///< of transverse edges, by layer
};

/// Moves the nodes inside linking faces.
class ColumnSpacer {
 public:
  ColumnSpacer(const Model& model, const Scheme& scheme, double size, SurfaceMesh& mesh)
      : model_(model), size_(size), mesh_(mesh) {
    for (int n = 0; n < mesh.n_nodes(); ++n) {
      const Owner& o = mesh.owner[n];
      const bool is_transverse =
          o.kind == EntityKind::edge && scheme.edge_role[o.index] == EdgeRole::transverse;
      if (mesh.k[n] >= 0 && (is_transverse || o.kind == EntityKind::vertex))
        level_points_[mesh.k[n]].push_back(mesh.points[n]);
    }
  }

  void run() {
    std::map<FaceId, double> before = least_by_face();
    const std::vector<Point3> old = mesh_.points;
    for (const auto& chain : columns_from(mesh_).chains) {
      std::size_t begin = 0;
      for (std::size_t i = 1; i < chain.size(); ++i) {
        if (mesh_.owner[chain[i].index].kind == EntityKind::face) continue;
        if (i > begin + 1) space({chain.begin() + begin, chain.begin() + i + 1});
        begin = i;
      }
    }
    constexpr double poor = 0.6;
    for (const auto& [face, least] : least_by_face())
      if (least < before.at(face) && least < poor) restore(face, old);
  }

 private:
  /// `row` begins and ends at nodes that stay.
  void space(const std::vector<NodeId>& row) {
    const int n = static_cast<int>(row.size()) - 1;
    std::vector<Point3> line;
    std::vector<double> x = {0.0};
    for (const NodeId node : row) line.push_back(mesh_.points[node.index]);
    for (int i = 1; i <= n; ++i) x.push_back(x.back() + (line[i] - line[i - 1]).norm());
    const double scale = n / x.back();
    for (double& value : x) value *= scale;
    std::vector<Wish> wishes(n + 1);
    bool is_drawn = false;
    for (int i = 1; i < n; ++i) {
      const auto at = level_points_.find(mesh_.k[row[i].index]);
      if (at == level_points_.end()) continue;
      wishes[i] = wish_of(nearest_pull(line, x, at->second), size_, model_.tolerances().point);
      is_drawn = true;
    }
    if (is_drawn) move(row, line, x, with_least_step(x, settled(x, wishes)));
  }

  /// Of the points that are near enough to be felt.
  Pull nearest_pull(const std::vector<Point3>& line, const std::vector<double>& x,
                    const std::vector<Point3>& points) const {
    constexpr double felt = 3.0;  // sizes
    Eigen::AlignedBox3d box;
    for (const Point3& p : line) box.extend(p);
    Pull best;
    for (const Point3& p : points)
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        if (box.squaredExteriorDistance(p) > felt * felt * size_ * size_) break;
        const Point3 along = line[i + 1] - line[i];
        const double f = std::clamp((p - line[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best.offer((line[i] + f * along - p).norm(), x[i] + f * (x[i + 1] - x[i]));
      }
    return best;
  }

  void move(const std::vector<NodeId>& row, const std::vector<Point3>& line,
            const std::vector<double>& x, const std::vector<double>& to) {
    for (std::size_t i = 1; i + 1 < row.size(); ++i) {
      const std::size_t s = std::upper_bound(x.begin() + 1, x.end() - 1, to[i]) - x.begin() - 1;
      const double f = (to[i] - x[s]) / (x[s + 1] - x[s]);
      const FaceId face{mesh_.owner[row[i].index].index};
      const Point3 p = line[s] + f * (line[s + 1] - line[s]);
      mesh_.points[row[i].index] = model_.point(face, model_.project(face, p));
    }
  }

  std::map<FaceId, double> least_by_face() const {
    std::map<FaceId, double> out;
    for (int c = 0; c < mesh_.n_cells(); ++c) {
      if (mesh_.cell_size(c) != 4) continue;
      Point3 corners[4];
      for (int i = 0; i < 4; ++i)
        corners[i] = mesh_.points[mesh_.cell_nodes[mesh_.cell_offset[c] + i]];
      const auto at = out.emplace(mesh_.cell_face[c], 1.0).first;
      at->second = std::min(at->second, scaled_jacobian_of_quad(corners));
    }
    return out;
  }

  void restore(FaceId face, const std::vector<Point3>& points) {
    for (int n = 0; n < mesh_.n_nodes(); ++n)
      if (mesh_.owner[n] == Owner{EntityKind::face, face.index}) mesh_.points[n] = points[n];
  }

  const Model& model_;
  const double size_;
  SurfaceMesh& mesh_;
  std::map<int, std::vector<Point3>> level_points_;  ///< of transverse edges, by layer
};

}  // namespace

void space_by_levels(const Model& model, const Scheme& scheme, const Intervals& intervals,
                     const IntervalOptions& options, EdgeNodes& nodes) {
  if (options.sweep_bias) return;
  const Spacer spacer(model, scheme, intervals, options);
  for (const EdgeId e : model.edges())
    if (scheme.edge_role[e.index] == EdgeRole::axial && nodes.t[e.index].size() > 2 &&
        !options.edge_bias.contains(e))
      spacer.space(e, nodes.t[e.index]);
}

void space_by_levels(const Model& model, const Scheme& scheme, double size, SurfaceMesh& mesh) {
  ColumnSpacer(model, scheme, size, mesh).run();
}

}  // namespace sweepmesh
