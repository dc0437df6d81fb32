// Sweeping a solid in parts of its faces: where its boundary has to turn in the middle of rounded
// edges (scheme/round_cuts.h), it is divided there, swept, and the answer told in its own numbers.
#pragma once

#include <optional>

#include "sweepmesh/model/divided_model.h"
#include "sweepmesh/pipeline/plan.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {

/// A divided solid that can be swept, with the picks and options for its parts.
struct DividedSweep {
  DividedModel parts;
  Picks picks;
  SweepOptions options;
  Assessment assessment;  ///< of parts.model, sweepable
};

/// Whether strained schemes (layout.h) will do for a divided solid.
enum class Strain { refused, accepted };

/// The solid with those cuts along its rounds that a scheme has use for; empty where it has no
/// rounds or cannot be swept with all of them cut. A picked face is picked with all of its pieces;
/// a fixed number of mesh edges on a divided edge goes to its pieces by length.
std::optional<DividedSweep> divide_to_sweep(const Model& model, const Picks& picks,
                                            const SweepOptions& options, Strain strain,
                                            Context& context);

/// Whether to divide a solid that has this verdict as it is: not where walls run against each
/// other, which no division mends.
bool may_be_divided(const Assessment& whole);

/// The verdict on a solid as it is or, where it cannot be swept so, divided; then the same with
/// strained schemes. Where nothing was picked, schemes that cannot be laid out do not count.
/// sweep() and plan_sweep() go the same way.
Assessment assess_or_divide(const Model& model, const Picks& picks, Context& context);

// From the numbers of the parts to those of the solid. A face or edge whose pieces differ has the
// role `divided`, and schemes have no directions (FaceScheme), as these are of pieces.
Assessment of_whole(const Model& model, const DividedModel& parts, const Assessment& assessment);
Intervals of_whole(const Model& model, const DividedModel& parts, const Intervals& intervals);
SweepPlan of_whole(const Model& model, const DividedModel& parts, const SweepPlan& plan);
VolumeMesh of_whole(const DividedModel& parts, VolumeMesh mesh);

}  // namespace sweepmesh
