#include "sweepmesh/pipeline/faces_at_elements.h"

#include <algorithm>
#include <set>

#include "sweepmesh/volume/element_index.h"

namespace sweepmesh {

std::vector<std::string> faces_at_elements(const SurfaceMesh& surface, const Assembly& assembly,
                                           const std::vector<long>& elements) {
  const ElementIndex index(assembly.extrusion);
  std::vector<char> is_near(assembly.points.rows(), false);
  for (const long e : elements)
    index.for_nodes(index.element(e), [&](long node) { is_near[node] = true; });
  std::set<FaceId> beside, touching;
  for (int c = 0; c < surface.n_cells(); ++c) {
    const auto first = surface.cell_nodes.begin() + surface.cell_offset[c];
    const auto n = std::count_if(first, first + surface.cell_size(c),
                                 [&](int node) { return is_near[assembly.volume_node[node]]; });
    if (n == surface.cell_size(c)) beside.insert(surface.cell_face[c]);
    if (n > 0) touching.insert(surface.cell_face[c]);
  }
  std::vector<std::string> names;
  for (const FaceId f : beside.empty() ? touching : beside) names.push_back(name_of(f));
  return names;
}

}  // namespace sweepmesh
