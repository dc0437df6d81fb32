#include "sweepmesh/pipeline/fold_verdict.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "sweepmesh/pipeline/sweep.h"
#include "sweepmesh/pipeline/wall_sampling.h"
#include "sweepmesh/scheme/assess.h"
#include "sweepmesh/scheme/straight_walls.h"

namespace sweepmesh {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

Reason reason_of(const Winding& winding) {
  std::vector<std::string> names;
  for (const FaceId f : winding.faces) names.push_back(name_of(f));
  const double degrees = winding.angle * 180.0 / std::numbers::pi;
  const int n_parts = static_cast<int>(std::ceil(winding.angle / kSafeWinding));
  return {ReasonKind::geometric,
          "The hole in " + listed(names) + " winds by " + std::to_string(std::lround(degrees)) +
              " degrees on its way from cap to cap; beyond half a turn the layers between must "
              "fold over. Cut the solid across the sweep into " +
              std::to_string(n_parts) + " parts.",
          names};
}

}  // namespace

Winding winding_of(const Model& model, const Scheme& scheme, Context& context) {
  if (has_straight_walls(model, scheme)) return {};
  try {
    const SweepOptions options;
    const double size = default_size(model);
    const Layout layout = lay_out(model, scheme, options, size, context);
    return largest_winding(wall_sections(model, scheme, layout, options, size, context));
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return {};
  }
}

Assessment assess_with_shape(const Model& model, const Picks& picks, Context& context) {
  Assessment verdict = assess(model, picks, context);
  std::vector<Scheme> kept, doubtful;
  std::optional<Reason> first;
  const auto tried = tries(verdict.schemes.size());
  for (std::size_t s = 0; s < verdict.schemes.size(); ++s) {
    Scheme& scheme = verdict.schemes[s];
    const Winding winding =
        std::ranges::binary_search(tried, s) ? winding_of(model, scheme, context) : Winding{};
    if (winding.angle <= kMostWinding)
      (winding.angle <= kSafeWinding ? kept : doubtful).push_back(std::move(scheme));
    else if (!first)
      first = reason_of(winding);
  }
  std::ranges::move(doubtful, std::back_inserter(kept));
  verdict.schemes = std::move(kept);
  if (first && verdict.schemes.empty()) {
    verdict.reasons = {std::move(*first)};
    verdict.folds = true;
  }
  return verdict;
}

}  // namespace sweepmesh
