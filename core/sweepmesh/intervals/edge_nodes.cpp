#include "sweepmesh/intervals/edge_nodes.h"

#include <algorithm>
#include <cmath>

namespace sweepmesh {
namespace {

Bias bias_of(const Model& model, const Intervals& intervals, const IntervalOptions& options,
             EdgeId e) {
  const auto own = options.edge_bias.find(e);
  if (own != options.edge_bias.end()) return own->second;
  if (!options.sweep_bias || intervals.k.empty()) return {};
  const int rise = intervals.k[model.end(e).index] - intervals.k[model.start(e).index];
  if (rise == 0) return {};
  const Bias along = *options.sweep_bias;
  const bool is_turned = rise < 0 && !along.symmetric;
  return {is_turned ? 1.0 / along.ratio : along.ratio, along.symmetric};
}

}  // namespace

std::vector<double> biased_fractions(int n, const Bias& bias) {
  std::vector<double> at(n + 1, 0.0);
  for (int s = 0; s < n; ++s) {
    const int power = bias.symmetric ? std::min(s, n - 1 - s) : s;
    at[s + 1] = at[s] + std::pow(bias.ratio, power);
  }
  for (double& a : at) a /= at[n];
  at[n] = 1.0;
  return at;
}

EdgeNodes place_edge_nodes(const Model& model, const Intervals& intervals,
                           const IntervalOptions& options) {
  EdgeNodes out;
  out.t.resize(model.n_edges());
  for (const EdgeId e : model.edges()) {
    const Bias bias = bias_of(model, intervals, options, e);
    out.t[e.index] = model.at_length_fractions(e, biased_fractions(intervals.edge[e.index], bias));
    out.t[e.index].front() = model.range(e).first;
    out.t[e.index].back() = model.range(e).second;
  }
  return out;
}

}  // namespace sweepmesh
