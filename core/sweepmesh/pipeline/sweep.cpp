#include "sweepmesh/pipeline/sweep.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/pipeline/cad_angles.h"
#include "sweepmesh/pipeline/divided_sweep.h"
#include "sweepmesh/pipeline/fold_verdict.h"
#include "sweepmesh/pipeline/layout.h"
#include "sweepmesh/pipeline/scheme_mesh.h"

namespace sweepmesh {
namespace {

constexpr double kPoor = 0.2;  ///< scaled Jacobian
constexpr auto kWishedSize = std::span(kSizeShares).first(1);

std::string caps_of(const Scheme& scheme) {
  const auto listed = [&](FaceRole role) {
    std::string text;
    for (const FaceId f : scheme.faces_with(role)) text += (text.empty() ? "" : ", ") + name_of(f);
    return text;
  };
  return listed(FaceRole::source) + " to " + listed(FaceRole::target);
}

/// The verdict where every scheme ends in elements that no position of the inner nodes makes valid.
Assessment folded(const InvalidMeshError& error) {
  Assessment verdict;
  verdict.reasons.push_back(
      {ReasonKind::geometric,
       std::string(error.what()) + " Cut the solid, or sweep it in another direction.",
       error.entities()});
  return verdict;
}

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

std::string text_of(double size) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", size);
  return text;
}

double least_of(const VolumeMesh& mesh, const Context& context) {
  return std::ranges::min(scaled_jacobians(mesh, context));
}

/// Another scheme must be worth that it was not the first choice.
bool is_clearly_better(double least, double than) {
  constexpr double clearly = 0.1;
  return least > than + clearly;
}

bool is_worth_another_try(double least, const VolumeMesh& mesh) {
  constexpr long most_elements = 30000;
  return least < kPoor && mesh.n_elements() < most_elements;
}

/// Meshes one of the schemes of `result.assessment` into `result`.
class SchemeTrier {
 public:
  SchemeTrier(const Model& model, const SweepOptions& options, StageClock& clock, Context& context,
              SweepResult& result)
      : model_(model), options_(options), clock_(clock), context_(context), result_(result) {}

  /// As with_some_scheme, and where that fails with other sizes near the wished one: then
  /// nodes lie elsewhere, and narrow places get other numbers of cells. `shares` of the wished
  /// size, that first. The first failure counts. least() is then the least scaled Jacobian.
  bool at_some_size(std::span<const double> shares = kSizeShares) {
    const SweepResult begun = result_;
    std::optional<Assessment> refused;
    std::exception_ptr first_error;
    for (const double share : shares) try {
        result_.assessment = begun.assessment;
        result_.warnings = begun.warnings;
        result_.size = share * begun.size;
        if (!has_hope()) break;
        if (share < 1.0 && is_explosion(model_, options_, result_.size)) continue;
        if (with_some_scheme()) {
          if (share != 1.0)
            result_.warnings.push_back("The element size is " + text_of(result_.size) + ": with " +
                                       text_of(begun.size) + " no valid mesh was found.");
          return true;
        }
        if (!refused && !first_error) refused = result_.assessment;
      } catch (const Cancelled&) {
        throw;
      } catch (const SolverError& e) {
        if (!refused && !first_error) {
          if (e.stage() != "surface") throw;  // what hangs on the numbers alone fails again
          first_error = std::current_exception();
        }
      } catch (const Error&) {
        if (!refused && !first_error) first_error = std::current_exception();
      }
    result_.size = begun.size;
    if (first_error) std::rethrow_exception(first_error);
    result_.assessment = *refused;
    result_.warnings.clear();
    return false;
  }

  double least() const { return least_; }

 private:
  /// Meshes the schemes in their order until one succeeds with elements that are not poor, or a
  /// mesh so large that another try would cost more than it is worth; of several meshes the best
  /// counts. Its scheme is moved to the front, and a warning tells of those before it that failed.
  /// False: the solid turned out not to be sweepable, see the assessment. Throws the first scheme's
  /// error where all fail otherwise.
  bool with_some_scheme() {
    auto& schemes = result_.assessment.schemes;
    std::exception_ptr first_error;
    std::optional<InvalidMeshError> fold;
    std::optional<std::size_t> best;
    for (const std::size_t s : tries(schemes.size())) try {
        if (hopeless_.contains(s)) continue;
        SchemeMesh made = mesh_scheme(model_, schemes[s], options_, result_.size, clock_, context_);
        const double least = least_of(made.mesh, context_);
        if (best && !is_clearly_better(least, least_)) continue;
        best = s;
        least_ = least;
        made_ = std::move(made);
        if (!is_worth_another_try(least_, made_.mesh)) break;
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& error) {
        if (best) continue;
        if (!first_error) first_error = std::current_exception();
        if (is_final(error)) hopeless_.insert(s);
        const auto* invalid = dynamic_cast<const InvalidMeshError*>(&error);
        if (s == 0 && invalid && invalid->stage() == "place") fold = *invalid;
        result_.warnings.push_back("The sweep from " + caps_of(schemes[s]) +
                                   " could not be meshed: " + error.what());
      }
    if (best) {
      take(std::move(made_));
      std::rotate(schemes.begin(), schemes.begin() + *best, schemes.begin() + *best + 1);
      return true;
    }
    if (!fold) std::rethrow_exception(first_error);
    result_.assessment = folded(*fold);
    result_.warnings.clear();
    return false;
  }

  /// Whether a scheme is left that another size may help.
  bool has_hope() const {
    return std::ranges::any_of(tries(result_.assessment.schemes.size()),
                               [&](std::size_t s) { return !hopeless_.contains(s); });
  }

  void take(SchemeMesh made) {
    result_.intervals = std::move(made.intervals);
    result_.mesh = std::move(made.mesh);
    std::ranges::move(made.warnings, std::back_inserter(result_.warnings));
  }

  const Model& model_;
  const SweepOptions& options_;
  StageClock& clock_;
  Context& context_;
  SweepResult& result_;
  SchemeMesh made_;
  double least_ = 0.0;              ///< scaled Jacobian of made_
  std::set<std::size_t> hopeless_;  ///< schemes that failed whatever the size (is_final)
};

/// Warnings of schemes that failed have the numbers of the divided solid, which nobody knows.
bool names_parts(const std::string& warning) {
  return warning.starts_with("The sweep from ");
}

/// A solid that was divided, and the mesh of its parts.
struct DividedMesh {
  DividedSweep divided;
  SweepResult part;
  double least;  ///< scaled Jacobian
};

/// Empty where it cannot be meshed.
std::optional<DividedMesh> mesh_parts(DividedSweep divided, std::span<const double> shares,
                                      double size, StageClock& clock, Context& context) try {
  SweepResult part;
  part.assessment = divided.assessment;
  part.size = size;
  SchemeTrier trier(divided.parts.model, divided.options, clock, context, part);
  if (!trier.at_some_size(shares)) return {};
  return DividedMesh{std::move(divided), std::move(part), trier.least()};
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
  while (is_worth_another_try(best->least, best->part.mesh) && (divided = next())) {
    auto other = mesh_parts(std::move(*divided), kWishedSize, result.size, clock, context);
    if (other && is_clearly_better(other->least, best->least)) best = std::move(other);
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
    if (!SchemeTrier(model, options, clock, context, strained).at_some_size(kWishedSize))
      return false;
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
    return SchemeTrier(model, options, clock, context, result).at_some_size();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    result.warnings.clear();
    if (divided(Strain::refused)) return true;
    if (!is_free(picks) || !is_fault_of_layout(error)) throw;
    result.assessment = without_layout(error);
    return false;
  }
}

}  // namespace

std::vector<std::size_t> tries(std::size_t n) {
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < n; ++s)
    if (s < 4 || s + 2 >= n) out.push_back(s);
  return out;
}

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
  if (result.quality.scaled_jacobian.min < kPoor) {
    const auto angles =
        poor_cad_angles(model, result.assessment.schemes.front(), result.mesh, kPoor, context);
    if (!angles.empty()) result.warnings.push_back(warning_of(angles));
  }
  context.report(1.0, "Done");
  return result;
}

}  // namespace sweepmesh
