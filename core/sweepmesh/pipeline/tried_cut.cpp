#include "sweepmesh/pipeline/tried_cut.h"

#include <utility>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/pipeline/sweep.h"

namespace sweepmesh {
namespace {

/// A piece at which anything goes wrong is none to offer.
bool has_mesh(const Model& piece, Context& context) try {
  return sweep(piece, {}, {}, context).quality.n_elements > 0;
} catch (const Cancelled&) {
  throw;
} catch (const std::exception&) {
  return false;
}

}  // namespace

std::optional<SuggestedCut> suggest_tried_cut(const Model& model,
                                              const std::vector<Reason>& reasons,
                                              CutOptions options, Context& context) {
  options.can_mesh = has_mesh;
  return suggest_cut(model, reasons, options, context);
}

}  // namespace sweepmesh
