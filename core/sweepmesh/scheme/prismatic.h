// Schemes that sweep along one straight direction, guessed from the normals of faces.
#pragma once

#include <vector>

#include "sweepmesh/scheme/role_search.h"

namespace sweepmesh {

/// The plane faces that look along a direction, and those that look against it; neither is empty.
struct PlaneCaps {
  std::vector<FaceId> along, against;
};

/// For each direction with plane faces on both sides, the largest areas first, at most six.
std::vector<PlaneCaps> plane_caps(const SweepProblem& problem);

/// For each direction that plane faces have (the largest areas first, at most six): faces whose
/// mean normal is within 45 degrees of it are sources, within 45 degrees of its opposite targets,
/// all others linking faces; kept where states exist for these roles. A source of second choices
/// beside search_divisions, which looks for the cheapest and not for the straightest. Ascending
/// cost, no two with the same caps.
std::vector<Division> prismatic_divisions(const Network& network, Context& context);

}  // namespace sweepmesh
