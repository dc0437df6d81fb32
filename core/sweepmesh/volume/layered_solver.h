// Solves A e = r for the Laplacian of an extrusion (layered_system.h) in time linear in its nodes.
//
// Conjugate gradients, preconditioned with one V-cycle: the smoother solves every column exactly
// (tridiagonal, so thin and thick layers are all the same to it) under a Chebyshev polynomial of
// degree two, coarser levels join columns by smoothed aggregation and keep all layers. One run or
// many, disjoint columns over one spot, caps inside: all the same code. Bits do not depend on the
// number of threads.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/floats.h"
#include "sweepmesh/volume/layered_system.h"

namespace sweepmesh {

struct SolverOptions {
  /// The residual (in the norm of the preconditioner) is to fall by this factor, in (0, 1).
  double reduction = 1e-4;
  /// Iterations after which SolverError is thrown, >= 1.
  int max_iterations = 100;
};

struct SolverReport {
  int n_iterations = 0;
  int n_levels = 0;
  double reduction = 0.0;  ///< that was reached
};

/// `x` is the right-hand side on entry and the solution on return, in the layout of the finest
/// level. Throws SolverError when it does not converge, and Cancelled.
SolverReport solve(const LayeredSystem& finest, Floats& x, const SolverOptions& options,
                   ThreadTeam& team, const Context& context);

}  // namespace sweepmesh
