// Whether choices admit layers: k at every vertex, the same along transverse edges and all over a
// cap, growing along +k.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/scheme/network.h"

namespace sweepmesh {

/// Groups of vertices that lie on one layer, numbered so that k grows (weakly) with the number; -1
/// for vertices not in use.
struct LevelGroups {
  std::vector<int> group;  ///< by vertex
  int n_groups = 0;
};

/// From the coedges and faces that are decided so far: transverse edges, edges inside caps and
/// whole caps join vertices; axial edges order the groups. Empty where an axial edge would have to
/// grow and not to grow (the order has a cycle). Linear in the number of edges.
std::optional<LevelGroups> level_groups(const Network& network, const Choices& choices);

/// Whether there is a source and a target, and no closed shell is a cap as a whole unless it is one
/// of two, the other being the opposite cap (a radial sweep): a closed section cannot be joined to
/// or cut from anything else. `choices` are decided.
bool has_both_ends(const Network& network, const Choices& choices);

/// Whether sources and targets can be swept into each other at all, by the Euler characteristic:
/// going up through the levels, a target is joined to the section along its CORNER edges and a
/// source is cut out of it along its CORNER edges, so
///   sum over targets of (chi(target) - chi(its CORNER edges)) = sum over sources of the same.
/// (Thesis 7.1.1, the go-through operation, as one equation.) `choices` are decided.
bool is_euler_balanced(const Network& network, const Choices& choices);

}  // namespace sweepmesh
