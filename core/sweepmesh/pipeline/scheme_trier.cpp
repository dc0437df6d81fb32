#include "sweepmesh/pipeline/scheme_trier.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <set>
#include <utility>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/pipeline/scheme_mesh.h"

namespace sweepmesh {
namespace {

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

std::string text_of(double size) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", size);
  return text;
}

double least_of(const VolumeMesh& mesh, const Context& context) {
  return std::ranges::min(scaled_jacobians(mesh, context));
}

/// What mesh_some_scheme does.
class SchemeTrier {
 public:
  SchemeTrier(const Model& model, const SweepOptions& options, StageClock& clock, Context& context,
              SweepResult& result)
      : model_(model), options_(options), clock_(clock), context_(context), result_(result) {}

  /// False: the solid turned out not to be sweepable, see the assessment.
  bool at_some_size(std::span<const double> shares) {
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
  /// The same at result_.size.
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

}  // namespace

bool is_worth_another_try(double least, const VolumeMesh& mesh) {
  constexpr long most_elements = 30000;
  return least < kPoor && mesh.n_elements() < most_elements;
}

bool is_clearly_better(double least, double than) {
  constexpr double clearly = 0.1;
  return least > than + clearly;
}

std::optional<double> mesh_some_scheme(const Model& model, const SweepOptions& options,
                                       std::span<const double> shares, StageClock& clock,
                                       Context& context, SweepResult& result) {
  SchemeTrier trier(model, options, clock, context, result);
  if (!trier.at_some_size(shares)) return {};
  return trier.least();
}

}  // namespace sweepmesh
