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

constexpr double kPoorlyCovered = -2.0;  ///< added to what such a mesh is worth
constexpr double kWorthCovered = -1.0;   ///< a mesh is worth more where all faces are covered

double worth_of(const SchemeMesh& made, const Context& context) {
  const double least = std::ranges::min(scaled_jacobians(made.mesh, context));
  return std::ranges::all_of(made.coverage, is_covered) ? least : least + kPoorlyCovered;
}

/// What mesh_some_scheme does.
class SchemeTrier {
 public:
  SchemeTrier(const Model& model, const SweepOptions& options, StageClock& clock, Context& context,
              SweepResult& result)
      : model_(model), options_(options), clock_(clock), context_(context), result_(result) {}

  /// False: the solid turned out not to be sweepable, see the assessment.
  bool at_some_size(std::span<const double> shares) {
    begun_ = result_;
    for (const double share : shares) try {
        if (!begin(share)) break;
        if (share < 1.0 && is_explosion(model_, options_, result_.size)) continue;
        if (!with_some_scheme()) {
          if (!refused_ && !first_error_) refused_ = result_.assessment;
          continue;
        }
        if (keep_best(share)) break;
      } catch (const Cancelled&) {
        throw;
      } catch (const SolverError& e) {
        // what hangs on the numbers alone fails again
        if (e.stage() != "surface" && !best_ && !refused_ && !first_error_) throw;
        note_error();
      } catch (const Error&) {
        note_error();
      }
    return finish();
  }

  double worth() const { return worth_; }

 private:
  /// False: no scheme is left that another size may help.
  bool begin(double share) {
    result_.assessment = begun_.assessment;
    result_.warnings = begun_.warnings;
    result_.size = share * begun_.size;
    return has_hope();
  }

  void note_error() {
    if (!refused_ && !first_error_) first_error_ = std::current_exception();
  }

  /// True where the mesh in result_ will do, or is too large to look for another.
  bool keep_best(double share) {
    constexpr long most_elements = 10000;  // each size may take several schemes
    const bool is_good = worth_ > kWorthCovered;
    if (best_ && !is_good) return false;
    if (share != 1.0)
      result_.warnings.push_back(
          "The element size is " + text_of(result_.size) + ": with " + text_of(begun_.size) +
          (best_ ? " a face was covered poorly." : " no valid mesh was found."));
    best_ = std::move(result_);
    result_.seconds = best_->seconds;
    best_worth_ = worth_;
    return is_good || best_->mesh.n_elements() > most_elements;
  }

  bool finish() {
    if (best_) {
      best_->seconds = std::move(result_.seconds);
      result_ = std::move(*best_);
      worth_ = best_worth_;
      return true;
    }
    result_.size = begun_.size;
    if (first_error_) std::rethrow_exception(first_error_);
    result_.assessment = *refused_;
    result_.warnings.clear();
    return false;
  }

  /// The same at result_.size.
  bool with_some_scheme() {
    auto& schemes = result_.assessment.schemes;
    std::exception_ptr first_error;
    std::optional<InvalidMeshError> fold;
    std::optional<std::size_t> best;
    for (const std::size_t s : tries(schemes.size())) try {
        if (hopeless_.contains(s)) continue;
        SchemeMesh made = mesh_scheme(model_, schemes[s], options_, result_.size, clock_, context_);
        const double worth = worth_of(made, context_);
        if (best && !is_clearly_better(worth, worth_)) continue;
        best = s;
        worth_ = worth;
        made_ = std::move(made);
        if (!is_worth_another_try(worth_, made_.mesh)) break;
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
  SweepResult& result_;  ///< at the size that is being tried
  SweepResult begun_;
  std::optional<SweepResult> best_;
  double best_worth_ = 0.0;
  std::optional<Assessment> refused_;
  std::exception_ptr first_error_;
  SchemeMesh made_;
  double worth_ = 0.0;              ///< of made_
  std::set<std::size_t> hopeless_;  ///< schemes that failed whatever the size (is_final)
};

}  // namespace

bool is_worth_another_try(double worth, const VolumeMesh& mesh) {
  constexpr long most_elements = 30000;
  return worth < kPoor && mesh.n_elements() < most_elements;
}

bool is_clearly_better(double worth, double than) {
  constexpr double clearly = 0.1;
  return worth > than + clearly;
}

std::optional<double> mesh_some_scheme(const Model& model, const SweepOptions& options,
                                       std::span<const double> shares, StageClock& clock,
                                       Context& context, SweepResult& result) {
  SchemeTrier trier(model, options, clock, context, result);
  if (!trier.at_some_size(shares)) return {};
  return trier.worth();
}

}  // namespace sweepmesh
