#include "sweepmesh/pipeline/layout.h"

#include <algorithm>

#include "sweepmesh/imprint/shell.h"
#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/scheme/ranking.h"

namespace sweepmesh {
namespace {

LayoutFault fault_of(const Error& error) {
  return {{ReasonKind::geometric, error.what(), error.entities()}, !is_final(error)};
}

/// Whether some size gives the scheme a layout.
bool has_layout(const Model& model, const Scheme& scheme, Context& context) {
  SweepOptions options;
  for (const double share : kSizeShares) {
    options.size = share * default_size(model);
    const auto fault = layout_fault(model, scheme, options, context, true);
    if (!fault) return true;
    if (!fault->is_of_size) break;
  }
  return false;
}

/// Of a scheme that has none.
Reason reason_of(const Model& model, const Scheme& scheme, const SweepOptions& options,
                 Context& context) {
  auto fault = layout_fault(model, scheme, options, context, false);
  return fault ? std::move(fault->reason) : Reason{};
}

}  // namespace

std::vector<std::size_t> tries(std::size_t n) {
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < n; ++s)
    if (s < 4 || s + 2 >= n) out.push_back(s);
  return out;
}

std::optional<LayoutFault> layout_fault(const Model& model, const Scheme& scheme,
                                        const SweepOptions& options, Context& context,
                                        bool is_trial) {
  try {
    lay_out(model, scheme, options, options.size.value_or(default_size(model)), context, is_trial);
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
  for (const std::size_t s : tries(verdict.schemes.size()))
    if (!layout_fault(model, verdict.schemes[s], options, context, true))
      kept.push_back(verdict.schemes[s]);
  if (kept.empty() && verdict.is_sweepable())
    verdict.reasons.push_back(reason_of(model, verdict.schemes.front(), options, context));
  verdict.schemes = std::move(kept);
}

bool is_fault_of_layout(const Error& error) {
  return dynamic_cast<const ImprintError*>(&error) || dynamic_cast<const InvalidMeshError*>(&error);
}

Assessment without_layout(Reason fault) {
  fault.text += " No other choice of sources and targets that was tried can be laid out.";
  return {{}, {std::move(fault)}};
}

Assessment without_layout(const Error& error) {
  return without_layout(fault_of(error).reason);
}

void refuse_without_layout(const Model& model, Context& context, Assessment& verdict) {
  if (!verdict.is_sweepable()) return;
  for (const std::size_t s : tries(verdict.schemes.size()))
    if (has_layout(model, verdict.schemes[s], context)) return;
  verdict = without_layout(reason_of(model, verdict.schemes.front(), {}, context));
}

std::vector<Scheme> schemes_beside(const Model& model, const std::vector<Scheme>& tried,
                                   Context& context) {
  std::vector<Scheme> out = strained_schemes(model, context);
  std::erase_if(out, [&](const Scheme& scheme) {
    return std::ranges::any_of(tried,
                               [&](const Scheme& other) { return has_same_caps(scheme, other); });
  });
  return out;
}

void accept_strained(const Model& model, const SweepOptions& options, Context& context,
                     Assessment& verdict) {
  if (verdict.is_sweepable()) return;
  std::size_t n_tried = 0;
  for (const Scheme& scheme : verdict.strained) {
    if (n_tried == kMostStrained || verdict.schemes.size() == kEnoughStrained) break;
    if (!may_be_shell(model, scheme)) continue;
    ++n_tried;
    if (!layout_fault(model, scheme, options, context, true)) verdict.schemes.push_back(scheme);
  }
  if (verdict.is_sweepable()) verdict.reasons.clear();
}

}  // namespace sweepmesh
