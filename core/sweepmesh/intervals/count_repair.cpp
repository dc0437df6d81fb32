#include "sweepmesh/intervals/count_repair.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

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

/// How the cheapest way to a state came there.
struct Entry {
  double cost = 0.0;
  int parent = -1, change = 0;
};

/// The states after a step, each a row of `width` partial sums (of the open rows, in their order).
struct States {
  std::size_t width = 0;
  std::vector<int> sums;
  std::vector<Entry> entries;

  const int* at(std::size_t i) const { return sums.data() + i * width; }
  std::size_t size() const { return entries.size(); }
};

/// What a step does to one row: where its sum stands before (-1: it is not open yet), and by how
/// much a change moves it.
struct RowStep {
  int row, from, coefficient;

  int sum(const int* before, int change) const {
    return (from < 0 ? 0 : before[from]) + coefficient * change;
  }
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
    states_.entries.push_back({});
    for (std::size_t s = 0; s < order_.size(); ++s)
      if (!advance(static_cast<int>(s))) return std::nullopt;
    return traced_back();
  }

 private:
  /// Greedy: next comes the class that opens the fewest rows; among those, the one in most open
  /// rows.
  void order_classes() {
    struct Key {
      int n_new, n_not_open, c;
      auto operator<=>(const Key&) const = default;
    };
    std::map<int, Key> key;
    std::set<Key> left;
    for (const auto& [c, rows] : rows_of_) {
      key[c] = {static_cast<int>(rows.size()), 0, c};
      left.insert(key[c]);
    }
    std::vector<char> is_open(rows_.size(), 0);
    while (!left.empty()) {
      const int next = left.begin()->c;
      left.erase(left.begin());
      for (const int r : rows_of_[next]) {
        last_step_[r] = static_cast<int>(order_.size());
        if (is_open[r]) continue;
        is_open[r] = 1;
        for (const auto& [c, a] : rows_[r].coefficient) {
          Key& k = key[c];
          if (left.erase(k) == 0) continue;
          k = {k.n_new - 1, k.n_not_open - 1, c};
          left.insert(k);
        }
      }
      order_.push_back(next);
    }
  }

  bool close(const Row& row, int sum, double& cost) const {
    if (!row.is_parity()) return sum >= row.low && sum <= row.high;
    const bool is_odd = ((sum + row.bit) % 2 + 2) % 2 == 1;
    if (is_odd && row.kind == Kind::preferably_even) cost += options_.odd_penalty;
    return !is_odd || row.kind == Kind::preferably_even;
  }

  /// What step s does to the rows that stay open after it, and to those that end with it.
  struct Plan {
    std::vector<RowStep> open, closing;
  };

  Plan plan_of(int s) {
    const int c = order_[s];
    Plan plan;
    const auto add = [&](int r, int from) {
      const auto a = rows_[r].coefficient.find(c);
      const RowStep step{r, from, a == rows_[r].coefficient.end() ? 0 : a->second};
      (last_step_[r] > s ? plan.open : plan.closing).push_back(step);
    };
    for (std::size_t j = 0; j < open_.size(); ++j) add(open_[j], static_cast<int>(j));
    for (const int r : rows_of_.at(c)) {
      reach_left_[r] -= std::abs(rows_[r].coefficient.at(c)) * options_.max_step;
      if (std::find(open_.begin(), open_.end(), r) == open_.end()) add(r, -1);
    }
    open_.clear();
    for (const RowStep& step : plan.open) open_.push_back(step.row);
    return plan;
  }

  /// The state after a change, written to `after`; false where a row cannot be met any more.
  bool next_state(const Plan& plan, const int* before, int change, int* after, double& cost) const {
    for (const RowStep& step : plan.closing)
      if (!close(rows_[step.row], step.sum(before, change), cost)) return false;
    for (const RowStep& step : plan.open) {
      const Row& row = rows_[step.row];
      const int sum = step.sum(before, change), reach = reach_left_[step.row];
      *after++ = row.is_parity() ? (sum % 2 + 2) % 2 : sum;
      if (!row.is_parity() && (sum + reach < row.low || sum - reach > row.high)) return false;
    }
    return true;
  }

  bool advance(int s) {
    const auto& k = classes_.classes[order_[s]];
    const double n = value_[order_[s]];
    const Plan plan = plan_of(s);
    States next;
    next.width = plan.open.size();
    for (int change = -options_.max_step; change <= options_.max_step; ++change) {
      if (n + change < k.lower || n + change > k.upper) continue;
      const double step_cost = class_cost(k, n + change) - class_cost(k, n);
      for (std::size_t p = 0; p < states_.size(); ++p) {
        double cost = states_.entries[p].cost + step_cost;
        const std::size_t begin = next.sums.size();
        next.sums.resize(begin + next.width);
        if (next_state(plan, states_.at(p), change, next.sums.data() + begin, cost))
          next.entries.push_back({cost, static_cast<int>(p), change});
        else
          next.sums.resize(begin);
      }
    }
    states_ = cheapest(next);
    steps_.push_back(states_.entries);
    return states_.size() > 0;
  }

  /// The cheapest way to each state; of too many states the cheapest.
  States cheapest(const States& all) const {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto compare = [&](std::size_t a, std::size_t b) {
      return std::lexicographical_compare_three_way(all.at(a), all.at(a) + all.width, all.at(b),
                                                    all.at(b) + all.width);
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const auto by_state = compare(a, b);
      const Entry &x = all.entries[a], &y = all.entries[b];
      return by_state != 0
                 ? by_state < 0
                 : std::tie(x.cost, x.parent, x.change) < std::tie(y.cost, y.parent, y.change);
    });
    const auto is_same = [&](std::size_t a, std::size_t b) { return compare(a, b) == 0; };
    order.erase(std::unique(order.begin(), order.end(), is_same), order.end());
    if (order.size() > options_.max_states) {
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return all.entries[a].cost < all.entries[b].cost;
      });
      order.resize(options_.max_states);
    }
    States out;
    out.width = all.width;
    for (const std::size_t i : order) {
      out.sums.insert(out.sums.end(), all.at(i), all.at(i) + all.width);
      out.entries.push_back(all.entries[i]);
    }
    return out;
  }

  std::vector<double> traced_back() const {
    std::vector<double> out = value_;
    int at = 0;
    for (std::size_t s = order_.size(); s > 0; --s) {
      const Entry& entry = steps_[s - 1][at];
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
  States states_;
  std::vector<std::vector<Entry>> steps_;
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
