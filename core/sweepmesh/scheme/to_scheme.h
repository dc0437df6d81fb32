// From the states of coedges to the noun that the other stages read, and how good it promises to
// be.
#pragma once

#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// `n_faces` and `n_edges` are those of the whole shape. `division` is decided.
Scheme to_scheme(const Network& network, const Division& division, int n_faces, int n_edges);

/// What schemes are ordered by, the best first: by cost (angles, Preferences, distortion.h), then
/// by the area of the caps (they are meshed freely; the less of that, the better), then by the
/// faces' numbers.
struct Rank {
  double cost = 0.0;
  double cap_area = 0.0;
  std::vector<FaceId> sources;
  auto operator<=>(const Rank&) const = default;
};

Rank rank_of(const Network& network, const Division& division);

/// Turns a division upside down: sources become targets and k runs the other way.
void turn_over(Division& division);

}  // namespace sweepmesh
