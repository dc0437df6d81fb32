// From the states of coedges to the noun that the other stages read, and how good it promises to be.
#pragma once

#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// `n_faces` and `n_edges` are those of the whole shape. `division` is decided.
Scheme to_scheme(const Network& network, const Division& division, int n_faces, int n_edges);

/// What schemes are ordered by, the best first: first by `burden`, the cost of the angles and what else makes a sweep hard, then by the
/// area of the caps (they are meshed freely; the less of that, the better), then by the faces' numbers.
struct Rank {
  double burden = 0.0;
  double cap_area = 0.0;
  std::vector<FaceId> sources;
  auto operator<=>(const Rank&) const = default;
};

struct RankOptions {
  double per_extra_cap = 0.5;  ///< each cap beyond one source and one target has to be imprinted
  double per_annulus = 0.5;     ///< linking face whose grid closes upon itself around a hole
  double per_cap_seam = 0.5;    ///< seam inside a cap: its mesh has to close upon itself
};

Rank rank_of(const Network& network, const Division& division, const RankOptions& options = {});

/// Turns a division upside down: sources become targets and k runs the other way.
void turn_over(Division& division);

}  // namespace sweepmesh
