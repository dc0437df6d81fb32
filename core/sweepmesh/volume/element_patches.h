// Patches of an extrusion: nodes that move together, and the elements that they touch.
#pragma once

#include <vector>

#include "sweepmesh/volume/element_index.h"

namespace sweepmesh {

/// Both ascending.
struct ElementPatch {
  std::vector<long> free_nodes, elements;
};

void sort_unique(std::vector<long>& v);
long position_in(const std::vector<long>& sorted, long value);

/// The nodes of `elements` and of `rings` rings of elements around them, without those that are
/// held, and all elements that they touch; divided so that two patches share no element. In the
/// order of their first elements. n log n in their size.
std::vector<ElementPatch> find_patches(const ElementIndex& index, const std::vector<char>& is_held,
                                       std::vector<long> elements, int rings);

}  // namespace sweepmesh
