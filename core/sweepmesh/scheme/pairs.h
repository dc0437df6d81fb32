// Whether pairs of a source and a target that the user asks for can hold.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// The walls carry the vertices of a target up to those of a source: from each vertex of a paired
/// target the axial edges lead to vertices of certain sources; where none of those is paired with
/// the target, the pairs contradict the correspondence (thesis 7.1.3 and figure 7.7). The reason
/// names source, target and the linking faces along that way. Vertices that no axial edge leaves,
/// and targets without a pair, are not judged.
std::optional<Reason> contradicted_pair(const Network& network, const Division& division,
                                        const std::vector<std::pair<FaceId, FaceId>>& pairs);

}  // namespace sweepmesh
