// What was picked, as the search takes it: faces with the states that are left to them, corners
// with a fixed type.
#pragma once

#include <utility>
#include <vector>

#include "sweepmesh/scheme/network.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// A face and the states that it may have.
using Pick = std::pair<FaceId, StateSet>;

/// Sources and targets, those of pairs too, each once, ascending.
std::vector<Pick> all_picks(const Picks& picks);
/// These, and every face with a picked vertex type as a linking face.
std::vector<Pick> with_types(std::vector<Pick> caps, const std::vector<TypePick>& types);

bool is_cap(const Pick& pick);
bool has_picked(const std::vector<Pick>& picks, StateSet role);

/// Throws InputError where a face is not of this solid.
int index_of(const SweepProblem& problem, FaceId id);
/// Throws InputError where a vertex is given two types on one face, or a type on a face that is
/// picked as a cap.
void check_types(const Picks& picks);
/// Throws InputError where a vertex is not of its face.
std::vector<FixedCorner> fixed_corners(const SweepProblem& problem,
                                       const std::vector<TypePick>& types);

/// All choices open but for these.
Choices start_of(const Network& network, const std::vector<Pick>& picks);

}  // namespace sweepmesh
