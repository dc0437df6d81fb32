#include "sweepmesh/pipeline/layout.h"

#include "sweepmesh/base/errors.h"
#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {
std::optional<Reason> layout_fault(const Model& model, const Scheme& scheme,
                                   const SweepOptions& options, Context& context) {
  try {
    lay_out(model, scheme, options, options.size.value_or(default_size(model)), context);
    return {};
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return Reason{ReasonKind::geometric, error.what(), error.entities()};
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
      verdict.reasons.push_back(std::move(*fault));
  }
  if (!kept.empty()) verdict.reasons.clear();
  verdict.schemes = std::move(kept);
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
