// How far a scheme is beyond what the free search takes.
#pragma once

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/role_search.h"

namespace sweepmesh {

/// Above this excess hardly a scheme could be meshed (docs/assessment.md).
inline constexpr double kMostExcess = 7.5;

/// Squared deviations, in quarter turns (limits.h), of the edges that are beyond the strict limits
/// and of the vertices of linking faces that are as far from what their types ask for. Slight
/// deviations do not count, however many there are. Zero within the strict limits but for vertices.
double excess_of(const Model& model, const Network& network, const Division& division);

}  // namespace sweepmesh
