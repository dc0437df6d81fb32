#include "sweepmesh/numerics/ascent/soft_least.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace sweepmesh {
namespace {

/// Steps and changes of the gradient that L-BFGS remembers.
class Memory {
 public:
  /// `change` of the negative gradient.
  void add(Eigen::VectorXd step, Eigen::VectorXd change) {
    constexpr std::size_t most = 8;
    const double product = step.dot(change);
    if (!(product > 0.0)) return;
    pairs_.push_back({std::move(step), std::move(change), 1.0 / product});
    if (pairs_.size() > most) pairs_.pop_front();
  }
  void clear() { pairs_.clear(); }
  bool is_empty() const { return pairs_.empty(); }

  Eigen::VectorXd direction(Eigen::VectorXd q) const {
    std::vector<double> a(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      a[i] = pairs_[i].rho * pairs_[i].step.dot(q);
      q -= a[i] * pairs_[i].change;
    }
    if (!pairs_.empty()) q /= pairs_.back().rho * pairs_.back().change.squaredNorm();
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      q += (a[i] - pairs_[i].rho * pairs_[i].change.dot(q)) * pairs_[i].step;
    return q;
  }

 private:
  struct Pair {
    Eigen::VectorXd step, change;
    double rho;
  };
  std::deque<Pair> pairs_;
};

int climb(const SoftLeast& value, double sharpness, const LeastAscentOptions& options,
          Eigen::VectorXd& x, const Context& context, const char* stage) {
  constexpr double sufficient = 1e-4;  // Armijo's constant
  constexpr int most_halvings = 12;
  Eigen::VectorXd uphill(x.size()), next_uphill(x.size());
  double now = value(x, sharpness, &uphill);
  Memory memory;
  for (int step = 0; step < options.max_steps; ++step) {
    context.check(stage);
    Eigen::VectorXd move = memory.direction(uphill);
    if (!(move.dot(uphill) > 0.0)) move = uphill;
    const double longest = move.lpNorm<Eigen::Infinity>();
    if (!(longest > 0.0)) return step;
    const double most = memory.is_empty() ? 0.1 * options.longest_step : options.longest_step;
    if (memory.is_empty() || longest > most) move *= most / longest;
    const double slope = move.dot(uphill);
    double length = 1.0, next = now;
    int halving = 0;
    Eigen::VectorXd trial;
    for (; halving < most_halvings; ++halving, length *= 0.5) {
      trial = x + length * move;
      next = value(trial, sharpness, &next_uphill);
      if (next >= now + sufficient * length * slope) break;
    }
    if (halving == most_halvings) return step;
    memory.add(trial - x, uphill - next_uphill);
    const double gain = next - now;
    x = std::move(trial);
    uphill = next_uphill;
    now = next;
    if (gain < options.least_gain) return step + 1;
  }
  return options.max_steps;
}

}  // namespace

double soft_least(std::vector<double>& values, double sharpness) {
  const double least = *std::min_element(values.begin(), values.end());
  double sum = 0.0;
  for (double& v : values) sum += v = std::exp(-sharpness * (v - least));
  for (double& v : values) v /= sum;
  return least - std::log(sum) / sharpness;
}

int ascend_least(const SoftLeast& value, const LeastAscentOptions& options, Eigen::VectorXd& x,
                 const Context& context, const char* stage) {
  int n_steps = 0;
  for (const double sharpness : options.sharpness)
    n_steps += climb(value, sharpness, options, x, context, stage);
  return n_steps;
}

}  // namespace sweepmesh
