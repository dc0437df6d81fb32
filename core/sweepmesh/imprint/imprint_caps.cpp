#include "sweepmesh/imprint/imprint_caps.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/imprint/overlay.h"
#include "sweepmesh/imprint/patches.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/sweep_levels.h"
#include "sweepmesh/imprint/walls.h"

namespace sweepmesh {
namespace {

constexpr double coincidence_of_size = 1e-3;  ///< what CAD models leave apart is far below this

double coincidence(const Model& model, const ImprintOptions& options) {
  constexpr double safety = 10.0;
  return std::max(safety * model.tolerances().point, coincidence_of_size * options.size);
}

void check(const ImprintOptions& options) {
  if (!(options.size > 0.0) || !std::isfinite(options.size))
    throw InputError("imprint", "The element size must be positive.");
  if (!(options.merge_fraction >= 0.0 && options.merge_fraction <= 1.0))
    throw InputError("imprint", "The merge fraction must lie between 0 and 1.");
}

Reference reference_of(const Model& model, const Scheme& scheme, const Walls& walls,
                       const std::vector<int>& level, double tolerance, const Context& context) {
  if (const auto direction = common_direction(model, scheme, level, tolerance))
    if (auto reference = projected_reference(model, walls, *direction, tolerance, context))
      return std::move(*reference);
  throw ImprintError(ImprintFailure::unreachable,
                     "The columns of the sweep do not stand over each other along one direction.",
                     {});
}

}  // namespace

Imprint imprint_caps(const Model& model, const Scheme& scheme, const ImprintOptions& options,
                     const Context& context) {
  check(options);
  const std::vector<int> level = sweep_levels(model, scheme);
  const Walls walls = find_walls(model, scheme, level);
  const double tolerance = coincidence(model, options);
  const Reference reference = reference_of(model, scheme, walls, level, tolerance, context);
  const double merge = std::max(tolerance, options.merge_fraction * options.size);
  return imprint_of(model, scheme, walls,
                    overlay(model, scheme, walls, reference, merge, context));
}

}  // namespace sweepmesh
