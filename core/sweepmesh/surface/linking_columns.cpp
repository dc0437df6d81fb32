#include "sweepmesh/surface/linking_columns.h"

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

class Linker {
 public:
  explicit Linker(const SurfaceMesh& mesh)
      : mesh_(mesh), above_(mesh.n_nodes(), -1), below_(mesh.n_nodes(), -1) {}

  ColumnChains link() {
    for (int cell = 0; cell < mesh_.n_cells(); ++cell) add_sides(cell);
    ColumnChains out;
    for (int n = 0; n < mesh_.n_nodes(); ++n) {
      if (above_[n] < 0 || below_[n] >= 0) continue;
      out.chains.emplace_back();
      for (int at = n; at >= 0; at = above_[at]) out.chains.back().push_back(NodeId{at});
    }
    return out;
  }

 private:
  void add_sides(int cell) {
    const int n = mesh_.cell_size(cell), first = mesh_.cell_offset[cell];
    for (int c = 0; c < n; ++c) {
      const int a = mesh_.cell_nodes[first + c], b = mesh_.cell_nodes[first + (c + 1) % n];
      if (mesh_.k[a] < 0 || mesh_.k[b] < 0) continue;
      if (mesh_.k[b] == mesh_.k[a] + 1) connect(a, b, cell);
      if (mesh_.k[a] == mesh_.k[b] + 1) connect(b, a, cell);
    }
  }

  void connect(int low, int high, int cell) {
    const bool fits =
        (above_[low] < 0 || above_[low] == high) && (below_[high] < 0 || below_[high] == low);
    if (!fits)
      throw InvalidMeshError("surface",
                             "A column of mesh nodes divides on " + name_of(mesh_.cell_face[cell]) +
                                 ", where every node must have one node above and one below.",
                             {name_of(mesh_.cell_face[cell])}, {cell});
    above_[low] = high;
    below_[high] = low;
  }

  const SurfaceMesh& mesh_;
  std::vector<int> above_, below_;
};

}  // namespace

ColumnChains columns_from(const SurfaceMesh& mesh) {
  return Linker(mesh).link();
}

}  // namespace sweepmesh
