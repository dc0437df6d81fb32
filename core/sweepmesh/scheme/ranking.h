// Which of the schemes that were found come first.
#pragma once

#include <vector>

#include "sweepmesh/scheme/asked.h"
#include "sweepmesh/scheme/role_search.h"

namespace sweepmesh {

/// The divisions as schemes, best first (to_scheme.h says what is ranked before what); those with
/// caps that were not picked come last where sources and targets were. Where nothing tells sources
/// and targets apart (no picks), the more are the sources.
std::vector<Scheme> ranked(const Model& model, const Network& network,
                           std::vector<Division> divisions, const std::vector<Pick>& picks);

std::size_t n_caps(const Scheme& scheme);

/// Whether two schemes have the same caps, be it upside down.
bool has_same_caps(const Scheme& a, const Scheme& b);

}  // namespace sweepmesh
