// Sweeping a solid in parts of its faces: where its boundary has to turn in the middle of rounded
// edges (scheme/round_cuts.h), it is divided there, swept, and the answer told in its own numbers.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "sweepmesh/model/divided_model.h"
#include "sweepmesh/pipeline/plan.h"
#include "sweepmesh/pipeline/sweep.h"
#include "sweepmesh/scheme/round_cuts.h"

namespace sweepmesh {

/// A divided solid that can be swept, with the picks and options for its parts.
struct DividedSweep {
  DividedModel parts;
  Picks picks;
  SweepOptions options;
  Assessment assessment;  ///< of parts.model, sweepable where it is handed out
};

/// Whether strained schemes (layout.h) will do for a divided solid.
enum class Strain { refused, accepted };

/// A solid with those cuts along its rounds that a scheme has use for. The cuts and the verdict on
/// what they leave are found once, when first asked for.
class RoundDivision {
 public:
  /// The arguments must outlive it.
  RoundDivision(const Model& model, const Picks& picks, const SweepOptions& options)
      : model_(model), picks_(picks), options_(options) {}

  /// Empty where the solid has no rounds or cannot be swept with all of them cut. A picked face is
  /// picked with all of its pieces; a fixed number of mesh edges on a divided edge goes to its
  /// pieces by length. Throws Cancelled only.
  std::optional<DividedSweep> to_sweep(Strain strain, Context& context);

  /// After to_sweep: divided as another scheme of the solid with all its rounds cut asks for, by
  /// other cuts than before. Empty where no scheme asks for any. Throws Cancelled only.
  std::optional<DividedSweep> other(Strain strain, Context& context);

 private:
  void divide(Context& context);
  std::optional<DividedSweep> swept(Strain strain, Context& context);
  std::optional<DividedSweep> divided_as(const Scheme& scheme, Strain strain, Context& context);

  const Model& model_;
  const Picks& picks_;
  const SweepOptions& options_;
  bool is_known_ = false;
  std::vector<CutGroup> groups_;
  std::optional<DividedSweep> all_;          ///< with all cuts, sweepable or not
  std::set<std::set<std::size_t>> is_made_;  ///< sets of groups
  std::size_t scheme_ = 0;                   ///< of all_, the next one to look at
};

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
