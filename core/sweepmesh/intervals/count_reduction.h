// Fewer unknowns for the same problem: those that must be equal become one.
#pragma once

#include <vector>

#include "sweepmesh/intervals/count_problem.h"

namespace sweepmesh {

/// Unknowns of the same class have the same value. A class collects the bounds and wishes of its
/// members.
struct CountClasses {
  struct Class {
    double lower = -unbounded;
    double upper = unbounded;
    std::vector<double> wishes, weights;
  };
  std::vector<int> class_of;  ///< per unknown
  std::vector<Class> classes;
  std::vector<CountProblem::Demand>
      demands;  ///< over classes; those already met by merging are dropped
};

/// Merges x and y for demands x - y = 0, and the first unknowns of equalities that agree in
/// everything else (counts of edges between the same two levels), until nothing changes.
/// Near-linear.
CountClasses merge_equal(const CountProblem& problem);

/// Cost of the value `n` for a class: sum of weight (n / wish + wish / n - 2).
double class_cost(const CountClasses::Class& c, double n);

/// The whole number of least cost within the bounds; for a class without wishes the one nearest to
/// 0.
double best_count(const CountClasses::Class& c);

}  // namespace sweepmesh
