// The greatest least: moves unknowns so that the least of many smooth values grows.
//
// The least of values v_i is replaced by the soft least
//
//     v_min - log(sum exp(-s (v_i - v_min))) / s,
//
// which is smooth, never above the least, and tends to it as the sharpness s grows. Its gradient is
// a mean of those of the values, weighted with exp(-s v_i): the worst count, and all of them
// together, where the gradient of the least alone would follow one value until another takes over.
// Limited-memory BFGS (Nocedal and Wright, Numerical Optimization, 7.2) climbs it, from one
// sharpness to the next.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "sweepmesh/base/context.h"

namespace sweepmesh {

/// Adds the weights w_i = exp(-s (v_i - v_min)) / sum in place of the values; returns the soft
/// least. `values` must not be empty.
double soft_least(std::vector<double>& values, double sharpness);

struct LeastAscentOptions {
  /// One round each, ascending, > 0; the last one says how near the soft least comes to the least.
  std::vector<double> sharpness = {30.0, 100.0, 300.0};
  int max_steps = 40;         ///< in a round, >= 1
  double longest_step = 0.3;  ///< of any unknown in one step, in units of the unknowns, > 0
  double least_gain = 1e-5;   ///< of a step, below which a round ends, >= 0
};

/// The soft least at `x` for a sharpness, and its gradient if asked for.
using SoftLeast =
    std::function<double(const Eigen::VectorXd& x, double sharpness, Eigen::VectorXd* gradient)>;

/// Climbs to a local maximum of each round's soft least; the unknowns should be of order one (edge
/// lengths, say). Returns the number of steps. Deterministic. Throws Cancelled between two steps.
int ascend_least(const SoftLeast& value, const LeastAscentOptions& options, Eigen::VectorXd& x,
                 const Context& context, const char* stage);

}  // namespace sweepmesh
