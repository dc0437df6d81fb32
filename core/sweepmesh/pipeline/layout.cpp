#include "sweepmesh/pipeline/layout.h"

#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/imprint_counts.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/pipeline/scheme_mesh.h"
#include "sweepmesh/pipeline/sweep.h"

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

LayoutFault fault_of(const Error& error) {
  return {{ReasonKind::geometric, error.what(), error.entities()}, !is_final(error)};
}

/// Whether some size gives the scheme a layout; the fault at the first one where none does.
std::optional<LayoutFault> fault_at_all_sizes(const Model& model, const Scheme& scheme,
                                              Context& context) {
  std::optional<LayoutFault> first;
  SweepOptions options;
  for (const double share : kSizeShares) {
    options.size = share * default_size(model);
    const auto fault = layout_fault(model, scheme, options, context);
    if (!fault) return {};
    if (!first) first = fault;
    if (!fault->is_of_size) break;
  }
  return first;
}

}  // namespace

bool is_final(const Error& error) {
  const auto* imprint = dynamic_cast<const ImprintError*>(&error);
  return imprint && imprint->failure() == ImprintFailure::unreachable;
}

std::optional<LayoutFault> layout_fault(const Model& model, const Scheme& scheme,
                                        const SweepOptions& options, Context& context) {
  const double size = options.size.value_or(default_size(model));
  const IntervalOptions intervals = interval_options(model, options, size);
  std::optional<LayoutFault> first;
  for (const double fraction : merge_fractions(options, size)) try {
      lay_out(model, scheme, fraction, intervals, context);
      return {};
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (!first) first = fault_of(error);
      if (error.entities().empty() || is_final(error)) break;
    }
  return first;
}

bool is_free(const Picks& picks) {
  return picks.sources.empty() && picks.targets.empty() && picks.pairs.empty() &&
         picks.types.empty();
}

void keep_laid_out(const Model& model, const SweepOptions& options, Context& context,
                   Assessment& verdict) {
  std::vector<Scheme> kept;
  for (const std::size_t s : tries(verdict.schemes.size())) {
    auto fault = layout_fault(model, verdict.schemes[s], options, context);
    if (!fault)
      kept.push_back(std::move(verdict.schemes[s]));
    else if (verdict.reasons.empty())
      verdict.reasons.push_back(std::move(fault->reason));
  }
  if (!kept.empty()) verdict.reasons.clear();
  verdict.schemes = std::move(kept);
}

Assessment without_layout(Reason fault) {
  fault.text += " Cut the solid there, or pick other sources and targets.";
  return {{}, {std::move(fault)}};
}

Assessment without_layout(const Error& error) {
  return without_layout(fault_of(error).reason);
}

void refuse_without_layout(const Model& model, Context& context, Assessment& verdict) {
  std::optional<Reason> first;
  for (const std::size_t s : tries(verdict.schemes.size())) {
    const Scheme& scheme = verdict.schemes[s];
    if (is_one_to_one(scheme) && !is_shell_like(model, scheme)) return;
    auto fault = fault_at_all_sizes(model, scheme, context);
    if (!fault) return;
    if (!first) first = std::move(fault->reason);
  }
  if (!first) return;
  verdict = without_layout(std::move(*first));
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
