#include "sweepmesh/volume/element_patches.h"

#include <algorithm>
#include <numeric>

namespace sweepmesh {
namespace {

using Numbers = std::vector<long>;

class PatchFinder {
 public:
  PatchFinder(const ElementIndex& index, const std::vector<char>& is_held)
      : index_(index), is_held_(is_held) {}

  /// Patches around `bad` elements; two patches share no element.
  std::vector<ElementPatch> find(Numbers bad, int rings) const {
    for (int ring = 0; ring < rings; ++ring) bad = elements_around(nodes_of(bad));
    Numbers nodes = nodes_of(bad);
    std::erase_if(nodes, [&](long n) { return is_held_[n] != 0; });
    return divide(nodes, elements_around(nodes));
  }

 private:
  Numbers nodes_of(const Numbers& elements) const {
    Numbers nodes;
    for (const long e : elements)
      index_.for_nodes(index_.element(e), [&](long n) { nodes.push_back(n); });
    sort_unique(nodes);
    return nodes;
  }
  Numbers elements_around(const Numbers& nodes) const {
    Numbers elements;
    for (const long n : nodes) index_.for_elements(n, [&](long e) { elements.push_back(e); });
    sort_unique(elements);
    return elements;
  }

  /// Elements belong together when they share a free node.
  std::vector<ElementPatch> divide(const Numbers& nodes, const Numbers& elements) const {
    Numbers root(elements.size());
    std::iota(root.begin(), root.end(), 0L);
    const auto find = [&](long i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    Numbers first(nodes.size(), -1);
    for (std::size_t n = 0; n < nodes.size(); ++n)
      index_.for_elements(nodes[n], [&](long e) {
        const long i = find(position_in(elements, e));
        if (first[n] < 0) first[n] = i;
        const long j = find(first[n]);
        root[std::max(i, j)] = std::min(i, j);
      });
    std::vector<ElementPatch> patches;
    std::vector<long> patch_of(elements.size(), -1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      long& p = patch_of[find(static_cast<long>(i))];
      if (p < 0) {
        p = static_cast<long>(patches.size());
        patches.emplace_back();
      }
      patches[p].elements.push_back(elements[i]);
    }
    for (std::size_t n = 0; n < nodes.size(); ++n)
      patches[patch_of[find(first[n])]].free_nodes.push_back(nodes[n]);
    return patches;
  }

  const ElementIndex& index_;
  const std::vector<char>& is_held_;
};

}  // namespace

void sort_unique(Numbers& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

long position_in(const Numbers& sorted, long value) {
  return std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin();
}

std::vector<ElementPatch> find_patches(const ElementIndex& index, const std::vector<char>& is_held,
                                       Numbers elements, int rings) {
  return PatchFinder(index, is_held).find(std::move(elements), rings);
}

}  // namespace sweepmesh
