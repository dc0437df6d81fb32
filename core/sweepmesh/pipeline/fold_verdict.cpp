#include "sweepmesh/pipeline/fold_verdict.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "sweepmesh/base/listed.h"
#include "sweepmesh/pipeline/sweep.h"
#include "sweepmesh/pipeline/wall_sampling.h"
#include "sweepmesh/scheme/assess.h"
#include "sweepmesh/scheme/straight_walls.h"

namespace sweepmesh {
namespace {

Reason reason_of(const Winding& winding) {
  std::vector<std::string> names;
  for (const FaceId f : winding.faces) names.push_back(name_of(f));
  const double degrees = winding.angle * 180.0 / std::numbers::pi;
  const int n_parts = static_cast<int>(std::ceil(winding.angle / kSafeWinding));
  const std::string holes = winding.is_of_two
                                ? "The holes in " + listed(names) + " wind around each other by "
                                : "The hole in " + listed(names) + " winds by ";
  return {
      ReasonKind::geometric,
      holes + std::to_string(std::lround(degrees)) +
          " degrees on the way from cap to cap; beyond half a turn the layers between must fold "
          "over. Cut the solid across the sweep into " +
          std::to_string(n_parts) + " parts.",
      names};
}

/// Whether a section may have holes: not where one face without holes is swept to one.
bool may_have_holes(const Model& model, const Scheme& scheme) {
  if (!is_one_to_one(scheme)) return true;
  return model.loops(scheme.faces_with(FaceRole::source).front()).size() > 1;
}

/// Schemes in the order of their winding: safe, doubtful, refused.
struct Sorted {
  std::vector<Scheme> safe, doubtful;
  std::optional<Reason> refused;
};

}  // namespace

Winding winding_of(const Model& model, const Scheme& scheme, Context& context) {
  if (!may_have_holes(model, scheme) || has_straight_walls(model, scheme)) return {};
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
  Sorted sorted;
  for (Scheme& scheme : verdict.schemes) {
    const Winding winding = sorted.safe.empty() ? winding_of(model, scheme, context) : Winding{};
    if (winding.angle <= kSafeWinding)
      sorted.safe.push_back(std::move(scheme));
    else if (winding.angle <= kMostWinding)
      sorted.doubtful.push_back(std::move(scheme));
    else if (!sorted.refused)
      sorted.refused = reason_of(winding);
  }
  verdict.schemes = std::move(sorted.safe);
  std::ranges::move(sorted.doubtful, std::back_inserter(verdict.schemes));
  if (sorted.refused && !verdict.is_sweepable()) {
    verdict.reasons = {std::move(*sorted.refused)};
    verdict.folds = true;
  }
  return verdict;
}

}  // namespace sweepmesh
