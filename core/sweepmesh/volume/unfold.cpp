#include "sweepmesh/volume/unfold.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/volume/element_check.h"

namespace sweepmesh {
namespace {

[[noreturn]] void throw_invalid(const std::vector<long>& elements, const char* cause) {
  throw InvalidMeshError(
      "place", std::to_string(elements.size()) + " elements stay inverted: " + cause, {}, elements);
}

}  // namespace

void unfold_inverted(const Extrusion& extrusion, const BaseMetric& metric,
                     const std::vector<char>& fixed, const std::vector<SlidingNode>& sliding,
                     int max_attempts, const std::vector<long>& inverted, Points& points,
                     ThreadTeam& team, const Context& context) {
  const std::vector<long> hopeless =
      hopeless_elements(extrusion, without_sliding(fixed, sliding), points, inverted);
  if (!hopeless.empty()) throw_invalid(hopeless, "the mesh of the boundary folds there.");
  UntangleOptions how;
  how.threshold = kDegenerate;
  how.max_attempts = max_attempts;
  // Boundaries that leave room for valid elements invert a few percent of them at first.
  constexpr double many = 0.25;
  constexpr int few_rounds = 6;
  if (static_cast<double>(inverted.size()) > many * static_cast<double>(extrusion.n_elements()))
    how.energy.max_rounds = few_rounds;
  const std::vector<long> held = hopeless_elements(extrusion, fixed, points, inverted);
  std::vector<long> left;
  std::ranges::set_difference(inverted, held, std::back_inserter(left));
  left = untangle(extrusion, metric, fixed, points, how, left, team, context).remaining;
  if (left.empty() && held.empty()) return;
  std::vector<long> open;
  std::ranges::set_union(left, held, std::back_inserter(open));
  how.sliding = sliding;
  left = untangle(extrusion, metric, fixed, points, how, open, team, context).remaining;
  if (!left.empty()) throw_invalid(left, "the mesh of the boundary leaves no room for them.");
}

}  // namespace sweepmesh
