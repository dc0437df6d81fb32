#include "sweepmesh/pipeline/merge_meshes.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "sweepmesh/base/disjoint_sets.h"
#include "sweepmesh/base/point_finder.h"

namespace sweepmesh {
namespace {

Point3 point_of(const VolumeMesh& mesh, int node) {
  return mesh.points.row(node);
}

/// The nodes of a face's polygons, mid-side nodes included, each once.
std::vector<int> nodes_on(const VolumeMesh& mesh, FaceId face) {
  std::set<int> out;
  for (std::size_t c = 0; c < mesh.boundary_face.size(); ++c) {
    if (mesh.boundary_face[c] != face) continue;
    for (int i = mesh.boundary_offset[c]; i < mesh.boundary_offset[c + 1]; ++i) {
      out.insert(mesh.boundary_nodes[i]);
      if (!mesh.boundary_mid_nodes.empty()) out.insert(mesh.boundary_mid_nodes[i]);
    }
  }
  return {out.begin(), out.end()};
}

std::vector<Point3> points_at(const VolumeMesh& mesh, const std::vector<int>& nodes) {
  std::vector<Point3> out;
  for (const int n : nodes) out.push_back(point_of(mesh, n));
  return out;
}

/// The polygons of a face as sets of corners, told by `number`.
std::set<std::vector<int>> polygons(const VolumeMesh& mesh, FaceId face,
                                    const std::map<int, int>& number) {
  std::set<std::vector<int>> out;
  for (std::size_t c = 0; c < mesh.boundary_face.size(); ++c) {
    if (mesh.boundary_face[c] != face) continue;
    std::vector<int> corners;
    for (int i = mesh.boundary_offset[c]; i < mesh.boundary_offset[c + 1]; ++i) {
      const auto at = number.find(mesh.boundary_nodes[i]);
      corners.push_back(at == number.end() ? -1 : at->second);
    }
    std::sort(corners.begin(), corners.end());
    out.insert(corners);
  }
  return out;
}

bool is_met(const VolumeMesh& a, FaceId f, const VolumeMesh& b, FaceId g, double tolerance) {
  const std::vector<int> own = nodes_on(a, f), others = nodes_on(b, g);
  const PointFinder finder(points_at(a, own), tolerance);
  std::map<int, int> same, number;
  for (std::size_t i = 0; i < own.size(); ++i) same[own[i]] = static_cast<int>(i);
  for (const int n : others) number[n] = finder.at(point_of(b, n));
  return own.size() == others.size() && polygons(a, f, same) == polygons(b, g, number);
}

class Merger {
 public:
  Merger(std::vector<VolumeMesh> meshes, const Contacts& all, const std::vector<Contact>& met,
         double tolerance)
      : meshes_(std::move(meshes)),
        all_(all),
        met_(met),
        tolerance_(tolerance),
        first_(first_nodes(meshes_)),
        classes_(first_.back()) {}

  VolumeMesh run() {
    for (const Contact& c : met_) join_on_faces(c);
    join_on_edges();
    number();
    out_.points.resize(n_nodes_, 3);
    out_.owner.resize(n_nodes_);
    for (std::size_t s = 0; s < meshes_.size(); ++s) add(static_cast<int>(s));
    return std::move(out_);
  }

 private:
  static std::vector<int> first_nodes(const std::vector<VolumeMesh>& meshes) {
    std::vector<int> out = {0};
    for (const VolumeMesh& mesh : meshes)
      out.push_back(out.back() + static_cast<int>(mesh.points.rows()));
    return out;
  }

  void join_on_faces(const Contact& c) {
    const VolumeMesh &a = meshes_[c.solid], &b = meshes_[c.other];
    const std::vector<int> own = nodes_on(a, c.face);
    const PointFinder finder(points_at(a, own), tolerance_);
    for (const int n : nodes_on(b, c.other_face)) {
      const int i = finder.at(point_of(b, n));
      if (i >= 0) classes_.join(first_[c.solid] + own[i], first_[c.other] + n);
    }
  }

  /// Solids that are connected by contacts share edges and vertices too, where they have them.
  void join_on_edges() {
    DisjointSets group(static_cast<int>(meshes_.size()));
    for (const Contact& c : met_) group.join(c.solid, c.other);
    std::map<std::tuple<int, EntityKind, int>, std::vector<int>> at;
    for (std::size_t s = 0; s < meshes_.size(); ++s)
      for (std::size_t n = 0; n < meshes_[s].owner.size(); ++n) {
        const Owner& o = meshes_[s].owner[n];
        if (o.index < 0 || o.kind == EntityKind::face) continue;
        const int entity =
            o.kind == EntityKind::edge ? all_.edge[o.index].index : all_.vertex[o.index].index;
        at[{group.root(static_cast<int>(s)), o.kind, entity}].push_back(first_[s] +
                                                                        static_cast<int>(n));
      }
    for (const auto& [entity, nodes] : at) join_near(nodes);
  }

  void join_near(const std::vector<int>& nodes) {
    std::vector<Point3> points;
    for (const int n : nodes) points.push_back(point_of_all(n));
    const PointFinder finder(points, tolerance_);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const int j : finder.near(points[i]))
        if (solid_of(nodes[j]) != solid_of(nodes[i])) classes_.join(nodes[i], nodes[j]);
  }

  std::ptrdiff_t solid_of(int node) const {
    return std::upper_bound(first_.begin(), first_.end(), node) - first_.begin() - 1;
  }
  Point3 point_of_all(int node) const {
    const auto s = solid_of(node);
    return point_of(meshes_[s], node - first_[s]);
  }

  void number() {
    number_.resize(first_.back());
    for (int n = 0; n < first_.back(); ++n)
      number_[n] = classes_.root(n) == n ? n_nodes_++ : number_[classes_.root(n)];
  }

  /// Of a node of one solid.
  int number_of(int solid, int node) const { return number_[first_[solid] + node]; }

  void add(int solid) {
    const VolumeMesh& mesh = meshes_[solid];
    for (int n = 0; n < static_cast<int>(mesh.points.rows()); ++n) {
      if (classes_.root(first_[solid] + n) != first_[solid] + n) continue;
      out_.points.row(number_of(solid, n)) = mesh.points.row(n);
      out_.owner[number_of(solid, n)] = mesh.owner[n];
    }
    add_rows(solid, mesh.hexahedra, out_.hexahedra);
    add_rows(solid, mesh.prisms, out_.prisms);
    add_rows(solid, mesh.hexahedron_mid_nodes, out_.hexahedron_mid_nodes);
    add_rows(solid, mesh.prism_mid_nodes, out_.prism_mid_nodes);
    add_polyhedra(solid);
    add_polygons(solid);
  }

  template <class Row>
  void add_rows(int solid, const std::vector<Row>& from, std::vector<Row>& to) const {
    for (Row row : from) {
      for (int& n : row) n = number_of(solid, n);
      to.push_back(row);
    }
  }

  void add_polyhedra(int solid) {
    const VolumeMesh& mesh = meshes_[solid];
    const int first = static_cast<int>(out_.polyhedron_nodes.size());
    for (const int n : mesh.polyhedron_nodes) out_.polyhedron_nodes.push_back(number_of(solid, n));
    for (int i = 1; i <= mesh.n_polyhedra(); ++i)
      out_.polyhedron_offset.push_back(first + mesh.polyhedron_offset[i]);
  }

  void add_polygons(int solid) {
    std::set<FaceId> has_other;
    for (const Contact& c : met_)
      if (c.other == solid && c.face == c.other_face) has_other.insert(c.face);
    const VolumeMesh& mesh = meshes_[solid];
    for (std::size_t c = 0; c < mesh.boundary_face.size(); ++c) {
      if (has_other.contains(mesh.boundary_face[c])) continue;
      for (int i = mesh.boundary_offset[c]; i < mesh.boundary_offset[c + 1]; ++i) {
        out_.boundary_nodes.push_back(number_of(solid, mesh.boundary_nodes[i]));
        if (!mesh.boundary_mid_nodes.empty())
          out_.boundary_mid_nodes.push_back(number_of(solid, mesh.boundary_mid_nodes[i]));
      }
      out_.boundary_offset.push_back(static_cast<int>(out_.boundary_nodes.size()));
      out_.boundary_face.push_back(mesh.boundary_face[c]);
    }
  }

  const std::vector<VolumeMesh> meshes_;
  const Contacts& all_;
  const std::vector<Contact>& met_;
  const double tolerance_;
  const std::vector<int> first_;  ///< by solid, and one more
  DisjointSets classes_;
  std::vector<int> number_;
  int n_nodes_ = 0;
  VolumeMesh out_;
};

}  // namespace

std::vector<Contact> unmet_contacts(const std::vector<VolumeMesh>& meshes,
                                    const std::vector<Contact>& contacts, double tolerance) {
  std::vector<Contact> out;
  for (const Contact& c : contacts)
    if (!is_met(meshes[c.solid], c.face, meshes[c.other], c.other_face, tolerance))
      out.push_back(c);
  return out;
}

VolumeMesh merged(std::vector<VolumeMesh> meshes, const Contacts& all,
                  const std::vector<Contact>& met, double tolerance) {
  return Merger(std::move(meshes), all, met, tolerance).run();
}

}  // namespace sweepmesh
