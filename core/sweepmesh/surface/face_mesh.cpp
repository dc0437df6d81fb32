#include "sweepmesh/surface/face_mesh.h"

#include <algorithm>

namespace sweepmesh {
namespace {

struct Corner {
  int cell = -1, corner = -1;
};

/// By directed side (from node, to node): the cell on its left and the side's first corner there.
using Sides = std::map<std::pair<int, int>, Corner>;

Sides sides_of(const FaceMesh& mesh) {
  Sides out;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    const int n = static_cast<int>(cell.size());
    for (int i = 0; i < n; ++i) out[{cell[i], cell[(i + 1) % n]}] = {c, i};
  }
  return out;
}

/// Goes from cell to cell over common sides.
class Matcher {
 public:
  Matcher(const FaceMesh& a, const FaceMesh& b, std::vector<int> known)
      : a_(a), b_(b), in_a_(sides_of(a)), in_b_(sides_of(b)), to_(std::move(known)) {
    from_.assign(b.points.size(), -1);
    seen_.assign(a.n_cells(), 0);
  }

  std::optional<std::vector<int>> run() {
    if (a_.n_cells() != b_.n_cells() || a_.points.size() != b_.points.size()) return {};
    for (std::size_t n = 0; n < to_.size(); ++n)
      if (to_[n] >= 0) {
        if (from_[to_[n]] >= 0) return {};
        from_[to_[n]] = static_cast<int>(n);
      }
    for (const auto& [side, corner] : in_a_)
      if (to_[side.first] >= 0 && to_[side.second] >= 0) waiting_.push_back(side);
    while (!waiting_.empty()) {
      const auto side = waiting_.back();
      waiting_.pop_back();
      if (!visit(side)) return {};
    }
    const bool is_whole = std::ranges::all_of(seen_, [](char s) { return s != 0; });
    return is_whole ? std::optional(to_) : std::nullopt;
  }

 private:
  bool visit(const std::pair<int, int>& side) {
    const auto at = in_a_.find(side);
    if (at == in_a_.end() || seen_[at->second.cell]) return true;
    const auto other = in_b_.find({to_[side.first], to_[side.second]});
    if (other == in_b_.end()) return false;
    const auto cell = a_.cell(at->second.cell), image = b_.cell(other->second.cell);
    if (cell.size() != image.size()) return false;
    seen_[at->second.cell] = 1;
    const std::size_t n = cell.size();
    for (std::size_t i = 0; i < n; ++i)
      if (!tie(cell[(at->second.corner + i) % n], image[(other->second.corner + i) % n]))
        return false;
    for (std::size_t i = 0; i < n; ++i) waiting_.emplace_back(cell[(i + 1) % n], cell[i]);
    return true;
  }

  bool tie(int node, int image) {
    if (to_[node] < 0 && from_[image] < 0) {
      to_[node] = image;
      from_[image] = node;
    }
    return to_[node] == image;
  }

  const FaceMesh &a_, &b_;
  const Sides in_a_, in_b_;
  std::vector<int> to_, from_;
  std::vector<char> seen_;
  std::vector<std::pair<int, int>> waiting_;
};

}  // namespace

FaceMesh mesh_of_face(const SurfaceMesh& mesh, FaceId face, std::vector<NodeId>* nodes) {
  FaceMesh out;
  std::vector<int> number(mesh.n_nodes(), -1);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    if (mesh.cell_face[c] != face) continue;
    for (int i = mesh.cell_offset[c]; i < mesh.cell_offset[c + 1]; ++i) {
      const int n = mesh.cell_nodes[i];
      if (number[n] < 0) {
        number[n] = static_cast<int>(out.points.size());
        out.points.push_back(mesh.points[n]);
        if (nodes) nodes->push_back(NodeId{n});
      }
      out.cell_nodes.push_back(number[n]);
    }
    out.cell_offset.push_back(static_cast<int>(out.cell_nodes.size()));
  }
  return out;
}

FaceMesh seen_from_behind(FaceMesh mesh) {
  for (int c = 0; c < mesh.n_cells(); ++c)
    std::reverse(mesh.cell_nodes.begin() + mesh.cell_offset[c],
                 mesh.cell_nodes.begin() + mesh.cell_offset[c + 1]);
  return mesh;
}

std::optional<std::vector<int>> matched(const FaceMesh& a, const FaceMesh& b,
                                        std::vector<int> known) {
  return Matcher(a, b, std::move(known)).run();
}

}  // namespace sweepmesh
