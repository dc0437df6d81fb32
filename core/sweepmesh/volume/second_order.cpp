#include "sweepmesh/volume/second_order.h"

#include <algorithm>
#include <utility>

#include "sweepmesh/volume/shape_functions.h"

namespace sweepmesh {
namespace {

using Side = std::pair<int, int>;  // lower node first

Side make_side(int a, int b) {
  return a < b ? Side(a, b) : Side(b, a);
}

/// All sides of the elements, sorted and unique; a side's place is its mid-node's number.
class SideTable {
 public:
  explicit SideTable(const VolumeMesh& mesh) {
    sides_.reserve(4 * mesh.points.rows());
    for (const auto& hex : mesh.hexahedra)
      for (const auto& [a, b] : hexahedron_sides) sides_.push_back(make_side(hex[a], hex[b]));
    for (const auto& prism : mesh.prisms)
      for (const auto& [a, b] : prism_sides) sides_.push_back(make_side(prism[a], prism[b]));
    std::sort(sides_.begin(), sides_.end());
    sides_.erase(std::unique(sides_.begin(), sides_.end()), sides_.end());
  }
  long size() const { return static_cast<long>(sides_.size()); }
  const Side& operator[](long i) const { return sides_[i]; }
  long find(int a, int b) const {
    return std::lower_bound(sides_.begin(), sides_.end(), make_side(a, b)) - sides_.begin();
  }

 private:
  std::vector<Side> sides_;
};

/// The one or two CAD faces at each side that lies on the boundary; invalid faces elsewhere.
std::vector<BoundarySide> boundary_sides(const VolumeMesh& mesh, const SideTable& sides) {
  std::vector<BoundarySide> out(sides.size());
  for (std::size_t cell = 0; cell < mesh.boundary_face.size(); ++cell) {
    const int begin = mesh.boundary_offset[cell], end = mesh.boundary_offset[cell + 1];
    for (int j = begin; j < end; ++j) {
      const int next = j + 1 < end ? j + 1 : begin;
      BoundarySide& side = out[sides.find(mesh.boundary_nodes[j], mesh.boundary_nodes[next])];
      (side.one.is_valid() ? side.other : side.one) = mesh.boundary_face[cell];
    }
  }
  return out;
}

void place_mid_nodes(VolumeMesh& mesh, const SideTable& sides, const MidPointFinder& find,
                     Context& context) {
  const std::vector<BoundarySide> boundary = boundary_sides(mesh, sides);
  const long n_corners = mesh.points.rows();
  mesh.points.conservativeResize(n_corners + sides.size(), 3);
  mesh.owner.resize(n_corners + sides.size());
  for (long s = 0; s < sides.size(); ++s) {
    if (s % 4096 == 0) context.check("place");
    const Point3 middle =
        (mesh.points.row(sides[s].first) + mesh.points.row(sides[s].second)).transpose() / 2;
    MidPoint mid{middle, Owner{}};
    if (boundary[s].one.is_valid()) mid = find(boundary[s], middle);
    mesh.points.row(n_corners + s) = mid.point;
    mesh.owner[n_corners + s] = mid.owner;
  }
}

void connect(VolumeMesh& mesh, const SideTable& sides, int n_corners) {
  const auto mid = [&](int a, int b) { return n_corners + static_cast<int>(sides.find(a, b)); };
  for (const auto& hex : mesh.hexahedra) {
    auto& mids = mesh.hexahedron_mid_nodes.emplace_back();
    for (std::size_t i = 0; i < mids.size(); ++i)
      mids[i] = mid(hex[hexahedron_sides[i].first], hex[hexahedron_sides[i].second]);
  }
  for (const auto& prism : mesh.prisms) {
    auto& mids = mesh.prism_mid_nodes.emplace_back();
    for (std::size_t i = 0; i < mids.size(); ++i)
      mids[i] = mid(prism[prism_sides[i].first], prism[prism_sides[i].second]);
  }
  for (std::size_t cell = 0; cell < mesh.boundary_face.size(); ++cell) {
    const int begin = mesh.boundary_offset[cell], end = mesh.boundary_offset[cell + 1];
    for (int j = begin; j < end; ++j)
      mesh.boundary_mid_nodes.push_back(
          mid(mesh.boundary_nodes[j], mesh.boundary_nodes[j + 1 < end ? j + 1 : begin]));
  }
}

/// Halves the bulge of the element's mid-nodes until its Jacobian is positive; counts those it
/// moved.
template <std::size_t N, std::size_t M>
long straighten(VolumeMesh& mesh, const std::array<int, N>& corners, const std::array<int, M>& mids,
                const std::array<std::pair<int, int>, M>& sides, std::vector<char>& moved) {
  constexpr int n_halvings = 6;
  long n = 0;
  for (int round = 0; round <= n_halvings; ++round) {
    if (min_jacobian(mesh.points, corners, mids) > 0) break;
    const double keep = round == n_halvings ? 0.0 : 0.5;
    for (std::size_t i = 0; i < M; ++i) {
      const auto a = mesh.points.row(corners[sides[i].first]);
      const auto b = mesh.points.row(corners[sides[i].second]);
      const Eigen::RowVector3d straight = (a + b) / 2;
      const Eigen::RowVector3d bulge = mesh.points.row(mids[i]) - straight;
      if (bulge.squaredNorm() == 0) continue;
      mesh.points.row(mids[i]) = straight + keep * bulge;
      if (!moved[mids[i]]) moved[mids[i]] = 1, ++n;
    }
  }
  return n;
}

long straighten_folded(VolumeMesh& mesh, Context& context) {
  std::vector<char> moved(mesh.points.rows(), 0);
  long n = 0, before = -1;
  while (n != before) {  // a halved node may fold its other elements, which are then halved in turn
    before = n;
    context.check("place");
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      n += straighten(mesh, mesh.hexahedra[h], mesh.hexahedron_mid_nodes[h], hexahedron_sides,
                      moved);
    for (std::size_t p = 0; p < mesh.prisms.size(); ++p)
      n += straighten(mesh, mesh.prisms[p], mesh.prism_mid_nodes[p], prism_sides, moved);
  }
  return n;
}

}  // namespace

SecondOrderReport add_mid_nodes(VolumeMesh& mesh, const MidPointFinder& find, Context& context) {
  const SideTable sides(mesh);
  const int n_corners = static_cast<int>(mesh.points.rows());
  place_mid_nodes(mesh, sides, find, context);
  connect(mesh, sides, n_corners);
  return {sides.size(), straighten_folded(mesh, context)};
}

}  // namespace sweepmesh
