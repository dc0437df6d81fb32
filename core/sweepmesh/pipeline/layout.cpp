#include "sweepmesh/pipeline/layout.h"

#include "sweepmesh/base/errors.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/imprint_counts.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/pipeline/scheme_mesh.h"

namespace sweepmesh {
namespace {

/// Throws the stages' errors.
void lay_out(const Model& model, const Scheme& scheme, double merge_fraction,
             const IntervalOptions& options, Context& context) {
  if (is_shell_like(model, scheme)) {
    count_shell(model, scheme, find_shell(model, scheme, context), options, context);
  } else if (is_one_to_one(scheme)) {
    assign_intervals(model, scheme, options, context);
  } else {
    const ImprintOptions how{.size = options.size, .merge_fraction = merge_fraction};
    count_imprint(model, scheme, imprint_caps(model, scheme, how, context), options, context);
  }
}

/// What curves do that cannot be carried to another level does not depend on how near they are.
bool can_merging_help(const Error& error) {
  const auto* imprint = dynamic_cast<const ImprintError*>(&error);
  return !error.entities().empty() &&
         (!imprint || imprint->failure() != ImprintFailure::unreachable);
}

}  // namespace

std::optional<Reason> layout_fault(const Model& model, const Scheme& scheme,
                                   const SweepOptions& options, Context& context) {
  const double size = options.size.value_or(default_size(model));
  const IntervalOptions intervals = interval_options(model, options, size);
  std::optional<Reason> first;
  for (const double fraction : merge_fractions(options, size)) try {
      lay_out(model, scheme, fraction, intervals, context);
      return {};
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (!first) first = Reason{ReasonKind::geometric, error.what(), error.entities()};
      if (!can_merging_help(error)) break;
    }
  return first;
}

void accept_strained(const Model& model, const SweepOptions& options, Context& context,
                     Assessment& verdict) {
  if (verdict.is_sweepable()) return;
  const std::size_t n = std::min(kMostStrained, verdict.strained.size());
  for (std::size_t s = 0; s < n && verdict.schemes.size() < kEnoughStrained; ++s)
    if (!layout_fault(model, verdict.strained[s], options, context))
      verdict.schemes.push_back(verdict.strained[s]);
  if (verdict.is_sweepable()) verdict.reasons.clear();
}

}  // namespace sweepmesh
