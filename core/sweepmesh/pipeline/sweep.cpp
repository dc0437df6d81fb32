#include "sweepmesh/pipeline/sweep.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "sweepmesh/pipeline/cad_angles.h"
#include "sweepmesh/pipeline/divided_sweep.h"
#include "sweepmesh/pipeline/fold_verdict.h"
#include "sweepmesh/pipeline/scheme_trier.h"

namespace sweepmesh {
namespace {

constexpr auto kWishedSize = std::span(kSizeShares).first(1);

std::string division_warning(const Model& model, const Scheme& scheme) {
  std::string faces;
  for (const FaceId f : model.faces())
    if (scheme.face_role[f.index] == FaceRole::divided)
      faces += (faces.empty() ? "" : ", ") + name_of(f);
  if (faces.empty()) return "The sweep turns in the middle of rounded edges.";
  return "The sweep turns in the middle of rounded edges: partly source or target and partly "
         "linking is " +
         faces + ".";
}

/// Warnings of schemes that failed have the numbers of the divided solid, which nobody knows.
bool names_parts(const std::string& warning) {
  return warning.starts_with("The sweep from ");
}

/// A solid that was divided, and the mesh of its parts.
struct DividedMesh {
  DividedSweep divided;
  SweepResult part;
  double worth;  ///< see mesh_some_scheme
};

/// Empty where it cannot be meshed.
std::optional<DividedMesh> mesh_parts(DividedSweep divided, std::span<const double> shares,
                                      double size, StageClock& clock, Context& context) try {
  SweepResult part;
  part.assessment = divided.assessment;
  part.size = size;
  const auto least =
      mesh_some_scheme(divided.parts.model, divided.options, shares, clock, context, part);
  if (!least) return {};
  return DividedMesh{std::move(divided), std::move(part), *least};
} catch (const Cancelled&) {
  throw;
} catch (const Error&) {
  return {};
}

/// Meshes the solid divided along its rounds, where that can be swept. Where elements are poor, it
/// is divided as its other schemes ask for. False: the assessment stays that of the whole solid.
bool mesh_divided(const Model& model, RoundDivision& division, Strain strain, StageClock& clock,
                  Context& context, SweepResult& result) {
  if (!may_be_divided(result.assessment)) return false;
  auto divided = clock.run("assess", [&] { return division.to_sweep(strain, context); });
  const auto next = [&] {
    return clock.run("assess", [&] { return division.other(strain, context); });
  };
  if (!divided) return false;
  auto best = mesh_parts(std::move(*divided), kSizeShares, result.size, clock, context);
  if (!best) return false;
  while (is_worth_another_try(best->worth, best->part.mesh) && (divided = next())) {
    auto other = mesh_parts(std::move(*divided), kWishedSize, result.size, clock, context);
    if (other && is_clearly_better(other->worth, best->worth)) best = std::move(other);
  }
  const DividedModel& parts = best->divided.parts;
  SweepResult& part = best->part;
  result.assessment = of_whole(model, parts, part.assessment);
  result.intervals = of_whole(model, parts, part.intervals);
  result.mesh = of_whole(parts, std::move(part.mesh));
  result.size = part.size;
  result.warnings.push_back(division_warning(model, result.assessment.schemes.front()));
  std::erase_if(part.warnings, names_parts);
  std::ranges::move(part.warnings, std::back_inserter(result.warnings));
  return true;
}

/// With schemes of poor angles that can be laid out. False: the verdict stays what it was.
bool mesh_strained(const Model& model, const SweepOptions& options, StageClock& clock,
                   Context& context, SweepResult& result) {
  SweepResult strained = result;
  clock.run("assess", [&] {
    accept_strained(model, options, context, strained.assessment);
    return 0;
  });
  if (!strained.assessment.is_sweepable()) return false;
  try {
    if (!mesh_some_scheme(model, options, kWishedSize, clock, context, strained)) return false;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return false;
  }
  strained.seconds = result.seconds;
  result = std::move(strained);
  result.warnings.push_back(
      "Angles are far from what the sweep needs, so elements are poor there.");
  return true;
}

/// The solid as it is or, where that cannot be swept or meshed, divided. False: it cannot be swept.
bool mesh_as_assessed(const Model& model, const Picks& picks, const SweepOptions& options,
                      StageClock& clock, Context& context, SweepResult& result) {
  RoundDivision division(model, picks, options);
  const auto divided = [&](Strain strain) {
    return mesh_divided(model, division, strain, clock, context, result);
  };
  if (!result.assessment.is_sweepable())
    return divided(Strain::refused) || mesh_strained(model, options, clock, context, result) ||
           divided(Strain::accepted);
  try {
    return mesh_some_scheme(model, options, kSizeShares, clock, context, result).has_value();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    result.warnings.clear();
    if (divided(Strain::refused)) return true;
    if (!is_free(picks) || !is_fault_of_layout(error)) throw;
    const std::vector<Scheme> regular = std::move(result.assessment.schemes);
    result.assessment = without_layout(error);
    result.assessment.strained =
        clock.run("assess", [&] { return schemes_beside(model, regular, context); });
    return mesh_strained(model, options, clock, context, result) || divided(Strain::accepted);
  }
}

}  // namespace

SweepResult sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                  Context& context) {
  check_options(options);
  check_picks(picks);
  SweepResult result;
  StageClock clock(result.seconds);
  result.size = options.size.value_or(default_size(model));
  refuse_explosion(model, options, result.size);

  context.report(0.0, "Looking for sources and targets");
  result.assessment = clock.run("assess", [&] {
    return options.refuse_folds ? assess_with_shape(model, picks, context)
                                : assess(model, picks, context);
  });
  if (!mesh_as_assessed(model, picks, options, clock, context, result)) return result;

  context.report(0.9, "Measuring quality");
  result.quality = clock.run("quality", [&] { return measure_quality(result.mesh, {}, context); });
  result.coverage = face_coverage(model, face_areas(model), result.mesh);
  std::ranges::move(coverage_warnings(result.coverage), std::back_inserter(result.warnings));
  if (result.quality.scaled_jacobian.min < kPoor) {
    const auto angles =
        poor_cad_angles(model, result.assessment.schemes.front(), result.mesh, kPoor, context);
    if (!angles.empty()) result.warnings.push_back(warning_of(angles));
  }
  context.report(1.0, "Done");
  return result;
}

}  // namespace sweepmesh
