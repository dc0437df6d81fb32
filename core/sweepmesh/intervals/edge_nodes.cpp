#include "sweepmesh/intervals/edge_nodes.h"

#include <algorithm>
#include <cmath>

namespace sweepmesh {

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
    const auto own = options.edge_bias.find(e);
    const Bias bias = own == options.edge_bias.end() ? Bias{} : own->second;
    out.t[e.index] = model.at_length_fractions(e, biased_fractions(intervals.edge[e.index], bias));
    out.t[e.index].front() = model.range(e).first;
    out.t[e.index].back() = model.range(e).second;
  }
  return out;
}

}  // namespace sweepmesh
