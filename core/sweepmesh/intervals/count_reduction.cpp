#include "sweepmesh/intervals/count_reduction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "sweepmesh/base/disjoint_sets.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Demand = CountProblem::Demand;
using Terms = std::vector<IntegerProgram::Term>;

/// Terms over roots, each once, without zeros, ascending.
Terms collected(const Terms& terms, DisjointSets& sets) {
  std::map<int, double> sum;
  for (const auto& t : terms) sum[sets.root(t.variable)] += t.coefficient;
  Terms out;
  for (const auto& [variable, coefficient] : sum)
    if (coefficient != 0.0) out.push_back({variable, coefficient});
  return out;
}

bool says_equal(const Demand& d, const Terms& terms) {
  return d.kind == Kind::equality && d.right == 0.0 && terms.size() == 2 &&
         terms[0].coefficient == -terms[1].coefficient;
}

using RowKey = std::pair<double, std::vector<std::pair<int, double>>>;

/// What an equality says of its first unknown: the other terms per unit of it. Empty where the
/// first unknown is not free of the rest.
std::optional<RowKey> definition(const Demand& d, const Terms& terms, DisjointSets& sets,
                                 int& defined) {
  if (d.kind != Kind::equality || d.terms.empty()) return std::nullopt;
  defined = sets.root(d.terms.front().variable);
  double scale = 0.0;
  RowKey key{d.right, {}};
  for (const auto& t : terms) {
    if (t.variable == defined)
      scale = t.coefficient;
    else
      key.second.emplace_back(t.variable, t.coefficient);
  }
  if (scale == 0.0) return std::nullopt;
  key.first /= scale;
  for (auto& [variable, coefficient] : key.second) coefficient /= scale;
  return key;
}

bool merge_once(const CountProblem& problem, DisjointSets& sets) {
  bool changed = false;
  std::map<RowKey, int> known;
  for (const auto& d : problem.demands) {
    const Terms terms = collected(d.terms, sets);
    if (says_equal(d, terms)) changed |= sets.join(terms[0].variable, terms[1].variable);
    int defined = -1;
    if (auto key = definition(d, terms, sets, defined)) {
      const auto [at, is_new] = known.emplace(std::move(*key), defined);
      if (!is_new) changed |= sets.join(at->second, defined);
    }
  }
  return changed;
}

bool is_trivial(const Demand& d) {
  if (!d.terms.empty()) return false;
  switch (d.kind) {
    case Kind::equality:
      return d.right == 0.0;
    case Kind::at_most:
      return d.right >= 0.0;
    case Kind::at_least:
      return d.right <= 0.0;
    default:
      return true;
  }
}

void add_member(CountClasses::Class& c, const CountProblem::Unknown& u) {
  c.lower = std::max(c.lower, u.lower);
  c.upper = std::min(c.upper, u.upper);
  if (!u.wish) return;
  c.wishes.push_back(*u.wish);
  c.weights.push_back(u.weight);
}

void number_classes(const CountProblem& problem, DisjointSets& sets, CountClasses& out) {
  const int n = static_cast<int>(problem.unknowns.size());
  out.class_of.assign(n, -1);
  for (int u = 0; u < n; ++u) {
    const int root = sets.root(u);
    if (root == u) {
      out.class_of[u] = static_cast<int>(out.classes.size());
      out.classes.emplace_back();
    }
    out.class_of[u] = out.class_of[root];
    add_member(out.classes[out.class_of[u]], problem.unknowns[u]);
  }
}

auto order_key(const Demand& d) {
  std::vector<std::pair<int, double>> terms;
  for (const auto& t : d.terms) terms.emplace_back(t.variable, t.coefficient);
  return std::make_tuple(d.kind, d.right, std::move(terms));
}

/// Demands over classes, each once, in the order in which they were made.
void collect_demands(const CountProblem& problem, DisjointSets& sets, CountClasses& out) {
  std::set<decltype(order_key(Demand{}))> seen;
  for (const auto& original : problem.demands) {
    Demand d = original;
    d.terms = collected(d.terms, sets);
    for (auto& t : d.terms) t.variable = out.class_of[t.variable];
    if (!is_trivial(d) && seen.insert(order_key(d)).second) out.demands.push_back(std::move(d));
  }
}

}  // namespace

CountClasses merge_equal(const CountProblem& problem) {
  DisjointSets sets(static_cast<int>(problem.unknowns.size()));
  while (merge_once(problem, sets)) {
  }
  CountClasses out;
  number_classes(problem, sets, out);
  collect_demands(problem, sets, out);
  return out;
}

double class_cost(const CountClasses::Class& c, double n) {
  double sum = 0.0;
  for (std::size_t j = 0; j < c.wishes.size(); ++j)
    sum += c.weights[j] * (n / c.wishes[j] + c.wishes[j] / n - 2.0);
  return sum;
}

double best_count(const CountClasses::Class& c) {
  double up = 0.0,
         down = 0.0;  // the cost is up * n + down / n plus a constant: least at sqrt(down / up)
  for (std::size_t j = 0; j < c.wishes.size(); ++j) {
    up += c.weights[j] / c.wishes[j];
    down += c.weights[j] * c.wishes[j];
  }
  if (c.wishes.empty()) return std::clamp(0.0, c.lower, c.upper);
  const double low = std::max(1.0, std::floor(std::sqrt(down / up)));
  const double n = class_cost(c, low + 1.0) < class_cost(c, low) ? low + 1.0 : low;
  return std::clamp(n, c.lower, c.upper);
}

}  // namespace sweepmesh
