#include "sweepmesh/imprint/axial_spacing.h"

#include <algorithm>
#include <limits>
#include <map>

#include "sweepmesh/imprint/edge_lengths.h"

namespace sweepmesh {
namespace {

/// What draws one layer of an edge.
struct Pull {
  double distance = std::numeric_limits<double>::infinity();
  double t = 0.0;  ///< on the axial edge
};

/// Minimises sum (x[i+1] - x[i] - 1)^2 + sum weight[i] (x[i] - wish[i])^2 with both ends fixed, by
/// elimination from the first to the last.
std::vector<double> settled(const std::vector<double>& wish, const std::vector<double>& weight) {
  const int n = static_cast<int>(wish.size()) - 1;
  std::vector<double> x(n + 1), diagonal(n + 1, 1.0), right(n + 1, 0.0);
  for (int i = 1; i < n; ++i) {
    const double above = i > 1 ? -1.0 / diagonal[i - 1] : 0.0;
    diagonal[i] = 2.0 + weight[i] + above;
    right[i] = weight[i] * wish[i] + (i == n - 1 ? n : 0.0) - (i > 1 ? above * right[i - 1] : 0.0);
  }
  x[n] = n;
  for (int i = n - 1; i > 0; --i)
    x[i] = (right[i] + (i < n - 1 ? x[i + 1] : 0.0)) / diagonal[i];
  return x;
}

/// As near to `x` as can be on the way from even steps, with no step below the least.
std::vector<double> with_least_step(const std::vector<double>& x) {
  constexpr double least = 0.25;
  double smallest = 1.0;
  for (std::size_t i = 1; i < x.size(); ++i) smallest = std::min(smallest, x[i] - x[i - 1]);
  const double share = smallest < least ? (1.0 - least) / (1.0 - smallest) : 1.0;
  std::vector<double> out;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double even = static_cast<double>(i);
    out.push_back(even + share * (x[i] - even));
  }
  return out;
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
    std::vector<double> wish(n + 1, 0.0), weight(n + 1, 0.0);
    bool is_drawn = false;
    for (int i = 1; i < n; ++i) {
      const auto at = points_.find(k_start + up * i);
      if (at == points_.end()) continue;
      const Pull pull = nearest_pull(e, at->second);
      wish[i] = n * length_fractions(model_, e, {pull.t}).front();
      const double near = std::max(pull.distance, model_.tolerances().point);
      weight[i] = (size_ / near) * (size_ / near);
      is_drawn = true;
    }
    if (!is_drawn) return;
    std::vector<double> fractions = with_least_step(settled(wish, weight));
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
      const double distance = (model_.point(e, t) - p).norm();
      if (distance < best.distance) best = {distance, t};
    }
    return best;
  }

  const Model& model_;
  const Intervals& intervals_;
  const double size_;
  std::map<int, std::vector<Point3>> points_;  ///< of transverse edges, by layer
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

}  // namespace sweepmesh
