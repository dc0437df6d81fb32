// Why a solid cannot be swept, in sentences that name the entities and, where there is one, the way
// out.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Edges that bound one face only, or more than two. Empty for a closed boundary.
std::vector<Reason> reasons_in_boundary(const SweepProblem& problem);

/// A face picked as source and as target, or a source and a target that share an edge. Empty where
/// there is no such.
std::vector<Reason> reasons_in_picks(const SweepProblem& problem, const Picks& picks);

/// Why the free search found nothing even within the lenient limits: one reason of each kind that
/// applies, at least one.
std::vector<Reason> reasons_of_failure(const Network& network, const SearchResult& result,
                                       const Context& context);

/// A wall that runs back against the sweep.
Reason reason_of_walls(const Network& network, const OpposedWalls& walls);

/// The edges whose angles are within the lenient limits but not within the strict ones, as used in
/// a division.
Reason angle_reason(const Network& network, const Division& division);

/// What of the picks is in the way, given that the solid can be swept without them. `blamed` are
/// the picks without each of which the others hold; `best` is a way out: all sources and targets
/// that can be picked, with as much of what was picked as there is.
Reason pick_reason(const Network& network, const std::vector<FaceId>& blamed, const Division& best);

/// Vertex types that cannot hold together, given that the solid can be swept without them.
/// `instead`: a type that lets the others hold, where there is one.
Reason type_reason(const std::vector<TypePick>& blamed, const std::optional<TypePick>& instead);

}  // namespace sweepmesh
