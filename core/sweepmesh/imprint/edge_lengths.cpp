#include "sweepmesh/imprint/edge_lengths.h"

#include <algorithm>

namespace sweepmesh {

std::vector<double> length_fractions(const Model& model, EdgeId e, const std::vector<double>& t) {
  constexpr int n_steps = 64;
  std::vector<double> fractions;
  for (int i = 0; i <= n_steps; ++i) fractions.push_back(static_cast<double>(i) / n_steps);
  std::vector<double> table = model.at_length_fractions(e, fractions);
  const auto [first, last] = model.range(e);
  table.front() = first;
  table.back() = last;
  std::vector<double> out;
  for (const double value : t) {
    const auto upper = std::upper_bound(table.begin() + 1, table.end() - 1, value);
    const std::size_t i = upper - table.begin() - 1;
    const double step = table[i + 1] - table[i];
    const double f = step > 0.0 ? (value - table[i]) / step : 0.0;
    out.push_back((i + std::clamp(f, 0.0, 1.0)) / n_steps);
  }
  return out;
}

std::vector<double> even_parameters(const Model& model, EdgeId e, double first, double last,
                                    int n) {
  if (first > last) {  // the model wants ascending fractions
    std::vector<double> t = even_parameters(model, e, last, first, n);
    std::reverse(t.begin(), t.end());
    return t;
  }
  const std::vector<double> ends = length_fractions(model, e, {first, last});
  std::vector<double> fractions;
  for (int i = 0; i <= n; ++i) fractions.push_back(ends[0] + (ends[1] - ends[0]) * i / n);
  std::vector<double> t = model.at_length_fractions(e, fractions);
  t.front() = first;
  t.back() = last;
  return t;
}

}  // namespace sweepmesh
