// The regularised elliptic energy that unfolds elements (Garanzha, Kaporin, Kudryavtseva, Protais,
// Ray, Sokolov, "Foldover-free maps in 50 lines of code", 2021).
//
// A *corner* of an element is a tetrahedron: a node o and three neighbours a, b, c, right-handed.
// With X = [a - o, b - o, c - o], the same of the ideal element in W, J = X W^-1 and D = det J, its
// energy is
//
//     tr(J^T J) / (3 chi(D)^(2/3)) + volume_weight (D^2 + 1) / (2 chi(D)),
//     chi(D) = (D + sqrt(eps^2 + D^2)) / 2,
//
// shape and volume, each 1 for the ideal element. chi is positive for all D, so an inverted corner
// has a finite energy with a slope towards validity; as eps goes to 0 the energy becomes a barrier
// at D = 0.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// Nodes 0 .. n_free - 1 of a patch are unknown, the others are held.
struct CornerTet {
  std::array<int, 4> node;  ///< o, a, b, c
  Eigen::Matrix3d ideal;    ///< W^-1
};

struct UnfoldProblem {
  int n_free = 0;
  std::vector<CornerTet> corners;
  /// Free nodes that stay in a plane: the node and the plane's unit normal.
  std::vector<std::pair<int, Point3>> sliding;
};

struct UnfoldOptions {
  double volume_weight = 1.0 / 16.0;  ///< of the volume term, > 0
  int power = 1;  ///< of each corner's energy in the sum, >= 1; a greater one cares for the worst
  int max_rounds = 40;             ///< times that eps is set anew, >= 1
  int max_steps = 60;              ///< quasi-Newton steps for one eps, >= 1
  double stop_at_decrease = 1e-3;  ///< relative decrease of the energy in a round that ends the run
};

/// Energy at `x`, and (if asked for) its gradient with respect to the free nodes.
double foldover_energy(const UnfoldProblem& problem, const Points& x, double eps,
                       const UnfoldOptions& options, Points* gradient);

/// Least det J over the corners.
double least_determinant(const UnfoldProblem& problem, const Points& x);

/// Moves the free rows of `x` to a (local) minimum: L-BFGS whose first matrix is the factored
/// quadratic form sum tr(J^T J), so that the number of steps hardly grows with the patch.
/// Deterministic. Returns the least det J that was reached. Cost of a step: linear in the corners,
/// plus one back substitution.
/// Throws Cancelled between two steps.
double minimise_foldover(const UnfoldProblem& problem, Points& x, const UnfoldOptions& options,
                         const Context& context);

}  // namespace sweepmesh
