#include "sweepmesh/intervals/count_repair.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;

/// A demand as seen from the changes of classes: low <= sum of coefficient * change <= high, or a
/// parity.
struct Row {
  Kind kind = Kind::equality;
  std::map<int, int> coefficient;  ///< by class
  double low = 0.0, high = 0.0;
  int bit = 0;  ///< of a parity row: the parity of the sum before any change
  bool is_parity() const { return kind == Kind::even || kind == Kind::preferably_even; }
  int reach(int max_step) const {
    int sum = 0;
    for (const auto& [c, a] : coefficient) sum += std::abs(a) * max_step;
    return sum;
  }
};

Row row_of(const CountProblem::Demand& d, const std::vector<bool>& fixed,
           const std::vector<double>& value) {
  Row row{d.kind, {}, -unbounded, unbounded, 0};
  double sum = 0.0;
  for (const auto& t : d.terms) {
    sum += t.coefficient * value[t.variable];
    if (!fixed[t.variable]) row.coefficient[t.variable] = static_cast<int>(t.coefficient);
  }
  if (d.kind == Kind::equality || d.kind == Kind::at_least) row.low = d.right - sum;
  if (d.kind == Kind::equality || d.kind == Kind::at_most) row.high = d.right - sum;
  row.bit = static_cast<int>(std::fmod(std::abs(sum), 2.0));
  return row;
}

/// Partial sums of the open rows, in the order of `open`.
using State = std::vector<int>;
struct Entry {
  double cost = 0.0;
  int parent = -1, change = 0;
};

class Repair {
 public:
  Repair(const CountClasses& classes, const std::vector<double>& value,
         const RepairOptions& options)
      : classes_(classes), value_(value), options_(options) {}

  void add(Row row) {
    const int reach = row.reach(options_.max_step);
    const bool binds = row.is_parity() || row.low > -reach || row.high < reach;
    if (!binds) return;
    for (const auto& [c, a] : row.coefficient)
      rows_of_[c].push_back(static_cast<int>(rows_.size()));
    last_step_.push_back(-1);
    reach_left_.push_back(reach);
    rows_.push_back(std::move(row));
  }

  std::optional<std::vector<double>> solve() {
    double cost = 0.0;
    for (const Row& row : rows_)
      if (row.coefficient.empty() && !close(row, 0, cost)) return std::nullopt;
    order_classes();
    steps_.push_back({{State{}, Entry{}}});
    for (std::size_t s = 0; s < order_.size(); ++s)
      if (!advance(static_cast<int>(s))) return std::nullopt;
    return traced_back();
  }

 private:
  using Step = std::vector<std::pair<State, Entry>>;

  /// Greedy: next comes the class that opens the fewest rows; among those, the one in most open
  /// rows.
  void order_classes() {
    std::vector<char> is_open(rows_.size(), 0);
    std::map<int, std::vector<int>> left = rows_of_;
    while (!left.empty()) {
      auto best = left.end();
      std::pair<int, int> best_key{0, 0};
      for (auto at = left.begin(); at != left.end(); ++at) {
        int n_open = 0;
        for (const int r : at->second) n_open += is_open[r];
        const std::pair<int, int> key{static_cast<int>(at->second.size()) - n_open, -n_open};
        if (best == left.end() || key < best_key) std::tie(best, best_key) = std::tie(at, key);
      }
      for (const int r : best->second) {
        is_open[r] = 1;
        last_step_[r] = static_cast<int>(order_.size());
      }
      order_.push_back(best->first);
      left.erase(best);
    }
  }

  bool close(const Row& row, int sum, double& cost) const {
    if (!row.is_parity()) return sum >= row.low && sum <= row.high;
    const bool is_odd = ((sum + row.bit) % 2 + 2) % 2 == 1;
    if (is_odd && row.kind == Kind::preferably_even) cost += options_.odd_penalty;
    return !is_odd || row.kind == Kind::preferably_even;
  }

  /// Rows open after step s: those before it that do not end here, and those that begin here and go
  /// on.
  std::vector<int> open_after(int s) const {
    std::vector<int> open;
    for (const int r : open_)
      if (last_step_[r] > s) open.push_back(r);
    for (const int r : rows_of_.at(order_[s]))
      if (last_step_[r] > s && std::find(open_.begin(), open_.end(), r) == open_.end())
        open.push_back(r);
    return open;
  }

  /// The state after a change of the class of step s; false where a row that ends here is not met.
  bool next_state(int s, const State& before, int change, const std::vector<int>& open,
                  State& after, double& cost) const {
    const int c = order_[s];
    after.assign(open.size(), 0);
    const auto sum_of = [&](int r) {
      const auto at = std::find(open_.begin(), open_.end(), r);
      const int sum = at == open_.end() ? 0 : before[at - open_.begin()];
      const auto a = rows_[r].coefficient.find(c);
      return sum + (a == rows_[r].coefficient.end() ? 0 : a->second * change);
    };
    for (const int r : rows_of_.at(c))
      if (last_step_[r] == s && !close(rows_[r], sum_of(r), cost)) return false;
    for (std::size_t j = 0; j < open.size(); ++j) {
      const Row& row = rows_[open[j]];
      const int sum = sum_of(open[j]), reach = reach_left_[open[j]];
      after[j] = row.is_parity() ? (sum % 2 + 2) % 2 : sum;
      if (!row.is_parity() && (sum + reach < row.low || sum - reach > row.high)) return false;
    }
    return true;
  }

  bool advance(int s) {
    const auto& k = classes_.classes[order_[s]];
    const double n = value_[order_[s]];
    const std::vector<int> open = open_after(s);
    for (const int r : rows_of_.at(order_[s]))
      reach_left_[r] -= std::abs(rows_[r].coefficient.at(order_[s])) * options_.max_step;
    std::map<State, Entry> next;
    State after;
    for (std::size_t p = 0; p < steps_.back().size(); ++p) {
      const auto& [state, entry] = steps_.back()[p];
      for (int change = -options_.max_step; change <= options_.max_step; ++change) {
        if (n + change < k.lower || n + change > k.upper) continue;
        double cost = entry.cost + class_cost(k, n + change) - class_cost(k, n);
        if (!next_state(s, state, change, open, after, cost)) continue;
        const auto [at, is_new] = next.emplace(after, Entry{cost, static_cast<int>(p), change});
        if (!is_new && cost < at->second.cost) at->second = {cost, static_cast<int>(p), change};
      }
    }
    open_ = open;
    steps_.push_back(cheapest(next));
    return !steps_.back().empty();
  }

  Step cheapest(const std::map<State, Entry>& all) const {
    Step out(all.begin(), all.end());
    if (out.size() <= options_.max_states) return out;
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.second.cost < b.second.cost; });
    out.resize(options_.max_states);
    return out;
  }

  std::vector<double> traced_back() const {
    std::vector<double> out = value_;
    int at = 0;
    for (std::size_t s = order_.size(); s > 0; --s) {
      const Entry& entry = steps_[s][at].second;
      out[order_[s - 1]] += entry.change;
      at = entry.parent;
    }
    return out;
  }

  const CountClasses& classes_;
  const std::vector<double>& value_;
  const RepairOptions& options_;
  std::vector<Row> rows_;
  std::map<int, std::vector<int>> rows_of_;  ///< by class
  std::vector<int> order_;
  std::vector<int> last_step_,
      reach_left_;  ///< by row; how far the classes to come can still move it
  std::vector<int> open_;
  std::vector<Step> steps_;
};

}  // namespace

std::optional<std::vector<double>> repair_parity(const CountClasses& classes,
                                                 const std::vector<int>& part,
                                                 const std::vector<bool>& fixed,
                                                 const std::vector<double>& value,
                                                 const RepairOptions& options) {
  Repair repair(classes, value, options);
  for (const int d : part) repair.add(row_of(classes.demands[d], fixed, value));
  return repair.solve();
}

}  // namespace sweepmesh
