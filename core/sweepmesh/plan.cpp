#include "sweepmesh/plan.h"

#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/imprint_counts.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/intervals/assign_intervals.h"

namespace sweepmesh {
namespace {

std::vector<CornerType> corners_of(const Model& model, const Scheme& scheme) {
  std::vector<CornerType> out;
  for (const FaceId face : scheme.faces_with(FaceRole::linking)) {
    const auto& loops = model.loops(face);
    const auto& types = scheme.face[face.index].type;
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c)
        out.push_back({face, loops[l][c].end, types[l][c]});
  }
  return out;
}

Intervals intervals_of(const Model& model, const Scheme& scheme, const IntervalOptions& options,
                       Context& context) {
  if (is_shell_like(model, scheme))
    return count_shell(model, scheme, find_shell(model, scheme, context), options, context)
        .intervals;
  if (is_one_to_one(scheme)) return assign_intervals(model, scheme, options, context);
  ImprintOptions how;
  how.size = options.size;
  const Imprint imprint = imprint_caps(model, scheme, how, context);
  return count_imprint(model, scheme, imprint, options, context).intervals;
}

}  // namespace

SweepPlan plan_sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                     Context& context) {
  check_options(options);
  check_picks(picks);
  SweepPlan plan;
  plan.size = options.size.value_or(default_size(model));
  refuse_explosion(model, options, plan.size);
  plan.assessment = assess(model, picks, context);
  if (!plan.assessment.is_sweepable()) return plan;
  const Scheme& scheme = plan.assessment.schemes.front();
  plan.corners = corners_of(model, scheme);
  plan.intervals = intervals_of(model, scheme, interval_options(options, plan.size), context);
  return plan;
}

}  // namespace sweepmesh
