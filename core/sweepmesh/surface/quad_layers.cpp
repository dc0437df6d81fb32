#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <utility>

#include "sweepmesh/surface/quad_cleanup.h"

namespace sweepmesh {
namespace {

using Cell = std::vector<int>;
using Edge = std::pair<int, int>;

/// Of a cell without inside nodes and of two loops or more, the loop that comes last.
void mark_tied_holes(const PlanarMesh& mesh, const std::vector<int>& loop_of,
                     std::vector<char>& marks) {
  for (int c = 0; c < mesh.n_cells(); ++c) {
    int first = static_cast<int>(marks.size()), last = -1;
    bool has_inside_node = false;
    for (const int node : mesh.cell(c)) {
      if (node >= mesh.n_boundary) {
        has_inside_node = true;
        continue;
      }
      first = std::min(first, loop_of[node]);
      last = std::max(last, loop_of[node]);
    }
    if (!has_inside_node && first != last) marks[last] = 1;
  }
}

void mark_flat_corners(const PlanarMesh& mesh, const std::vector<int>& loop_of,
                       const std::vector<std::vector<double>>& angles, std::vector<char>& marks) {
  constexpr double flat = 150.0 / 180.0 * std::numbers::pi;
  std::vector<int> count(mesh.n_nodes(), 0);
  for (const int node : mesh.cell_nodes) ++count[node];
  for (int i = 0; i < mesh.n_boundary; ++i)
    for (const auto& shape : angles)
      if (shape[i] > flat * count[i]) marks[loop_of[i]] = 1;
}

/// New nodes a little inside of a loop's, for the cells there to use, and the quads between.
void add_ring(int first, int count, std::vector<int>& number, PlanarMesh& mesh) {
  constexpr double share = 0.3;  // of the boundary edges
  const int ring = mesh.n_nodes();
  for (int i = 0; i < count; ++i) {
    const Point2& p = mesh.points[first + i];
    const Point2 along =
        mesh.points[first + (i + 1) % count] - mesh.points[first + (i + count - 1) % count];
    number[first + i] = ring + i;
    mesh.points.push_back(p + 0.5 * share * Point2(-along.y(), along.x()));
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    const std::array<int, 4> quad = {first + i, first + next, ring + next, ring + i};
    mesh.add_cell(quad);
  }
}

}  // namespace

PlanarMesh with_rings(const PlanarMesh& mesh, const PlanarLoops& loops,
                      const std::vector<std::vector<double>>& angles,
                      const std::vector<char>& wants_ring) {
  std::vector<int> loop_of;
  for (std::size_t l = 0; l < loops.size(); ++l)
    loop_of.insert(loop_of.end(), loops[l].size(), static_cast<int>(l));
  std::vector<char> is_ringed(loops.size(), 0);
  mark_tied_holes(mesh, loop_of, is_ringed);
  mark_flat_corners(mesh, loop_of, angles, is_ringed);
  for (std::size_t i = 0; i < wants_ring.size(); ++i)
    if (wants_ring[i]) is_ringed[loop_of[i]] = 1;
  PlanarMesh out;
  out.points = mesh.points;
  out.n_boundary = mesh.n_boundary;
  std::vector<int> number(mesh.n_nodes());
  for (int i = 0; i < mesh.n_nodes(); ++i) number[i] = i;
  int first = 0;
  for (std::size_t l = 0; l < loops.size(); first += static_cast<int>(loops[l++].size()))
    if (is_ringed[l]) add_ring(first, static_cast<int>(loops[l].size()), number, out);
  for (int c = 0; c < mesh.n_cells(); ++c) {
    Cell cell;
    for (const int node : mesh.cell(c)) cell.push_back(number[node]);
    out.add_cell(cell);
  }
  return out;
}

PlanarMesh refined_to_quads(const PlanarMesh& mesh, const PlanarLoops& boundary) {
  PlanarMesh out;
  out.points = flattened(boundary);
  out.n_boundary = out.n_nodes();
  std::vector<int> number(mesh.n_nodes());
  for (int i = 0; i < mesh.n_nodes(); ++i) {
    number[i] = i < mesh.n_boundary ? 2 * i : out.n_nodes();
    if (i >= mesh.n_boundary) out.points.push_back(mesh.points[i]);
  }
  std::map<Edge, int> middle;
  int first = 0;
  for (const auto& loop : boundary) {
    const int n = static_cast<int>(loop.size());
    for (int i = 0; i < n; i += 2)
      middle[std::minmax(first + i, first + (i + 2) % n)] = first + i + 1;
    first += n;
  }
  const auto middle_of = [&](int a, int b) {
    const auto [entry, is_new] = middle.try_emplace(std::minmax(a, b), out.n_nodes());
    if (is_new) out.points.push_back(0.5 * (out.points[a] + out.points[b]));
    return entry->second;
  };
  for (int c = 0; c < mesh.n_cells(); ++c) {
    Cell cell;
    for (const int node : mesh.cell(c)) cell.push_back(number[node]);
    const int n = static_cast<int>(cell.size());
    Point2 centre = Point2::Zero();
    for (const int node : cell) centre += out.points[node] / n;
    const int in = out.n_nodes();
    out.points.push_back(centre);
    for (int i = 0; i < n; ++i) {
      const int next = middle_of(cell[i], cell[(i + 1) % n]);
      const int previous = middle_of(cell[(i + n - 1) % n], cell[i]);
      const std::array<int, 4> quad = {cell[i], next, in, previous};
      out.add_cell(quad);
    }
  }
  return out;
}

}  // namespace sweepmesh
