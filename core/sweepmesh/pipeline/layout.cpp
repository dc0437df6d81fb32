#include "sweepmesh/pipeline/layout.h"

#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {
namespace {

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

std::optional<LayoutFault> layout_fault(const Model& model, const Scheme& scheme,
                                        const SweepOptions& options, Context& context) {
  try {
    lay_out(model, scheme, options, options.size.value_or(default_size(model)), context);
    return {};
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return fault_of(error);
  }
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
