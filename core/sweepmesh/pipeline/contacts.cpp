#include "sweepmesh/pipeline/contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "sweepmesh/base/point_finder.h"

namespace sweepmesh {
namespace {

template <class Entity>
std::vector<Entity> each_for_itself(int n) {
  std::vector<Entity> out;
  for (int i = 0; i < n; ++i) out.emplace_back(i);
  return out;
}

double largest_gap(const std::vector<Model>& solids) {
  double gap = 0.0;
  for (const Model& solid : solids) gap = std::max(gap, 2.0 * solid.tolerances().point);
  return gap;
}

/// Points of a face, evenly spread in (u,v), that lie within its boundary.
std::vector<Point2> inner_samples(const Model& model, FaceId face, int n) {
  std::vector<Point2> out;
  const auto [low, high] = model.uv_bounds(face);
  const double gap = 2.0 * model.tolerances().point;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Point2 share((i + 0.5) / n, (j + 0.5) / n);
      const Point2 uv = low + Point2((high - low).cwiseProduct(share));
      if (model.distance(face, model.point(face, uv)) <= gap) out.push_back(uv);
    }
  return out;
}

class ContactFinder {
 public:
  explicit ContactFinder(const std::vector<Model>& solids)
      : solids_(solids), gap_(largest_gap(solids)) {
    const Model& first = solids.front();
    out_.face = each_for_itself<FaceId>(first.n_faces());
    out_.edge = each_for_itself<EdgeId>(first.n_edges());
    out_.vertex = each_for_itself<VertexId>(first.n_vertices());
    out_.edge_is_turned.assign(first.n_edges(), 0);
  }

  Contacts run() {
    join_vertices();
    join_edges();
    join_faces();
    note_users();
    return std::move(out_);
  }

 private:
  // --- what coincides ----------------------------------------------------------------------------

  void join_vertices() {
    std::vector<Point3> points;
    std::vector<VertexId> ids;
    std::vector<std::size_t> solid;
    for (std::size_t s = 0; s < solids_.size(); ++s)
      for (const VertexId v : solids_[s].vertices()) {
        points.push_back(solids_[s].point(v));
        ids.push_back(v);
        solid.push_back(s);
      }
    const PointFinder finder(points, gap_);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const int j : finder.near(points[i]))
        if (solid[j] != solid[i])
          out_.vertex[ids[i].index] = std::min(out_.vertex[ids[i].index], ids[j]);
  }

  std::pair<VertexId, VertexId> ends(const Model& model, EdgeId e) const {
    return {out_.vertex[model.start(e).index], out_.vertex[model.end(e).index]};
  }

  void join_edges() {
    std::map<std::pair<VertexId, VertexId>, std::vector<EdgeOfSolid>> between;
    for (std::size_t s = 0; s < solids_.size(); ++s)
      for (const EdgeId e : solids_[s].edges()) {
        auto [a, b] = ends(solids_[s], e);
        between[std::minmax(a, b)].emplace_back(e, static_cast<int>(s));
      }
    for (auto& [key, edges] : between) {
      std::sort(edges.begin(), edges.end());
      edges.erase(std::unique(edges.begin(), edges.end(), is_same_edge), edges.end());
      for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (join_edge(edges[i], edges[j])) break;
    }
  }

  using EdgeOfSolid = std::pair<EdgeId, int>;
  static bool is_same_edge(const EdgeOfSolid& a, const EdgeOfSolid& b) {
    return a.first == b.first;
  }

  /// Edge `e` to the lower one `f`, if they coincide.
  bool join_edge(const EdgeOfSolid& e, const EdgeOfSolid& f) {
    const Model &a = solids_[e.second], &b = solids_[f.second];
    if (&a == &b) return false;
    const auto t = a.at_length_fractions(e.first, {0.2, 0.5, 0.7});
    for (const double at : t)
      if (b.distance(f.first, a.point(e.first, at)) > gap_) return false;
    const double on = b.project(f.first, a.point(e.first, t.front()));
    const bool is_against = a.tangent(e.first, t.front()).dot(b.tangent(f.first, on)) < 0.0;
    out_.edge[e.first.index] = out_.edge[f.first.index];
    out_.edge_is_turned[e.first.index] = out_.edge_is_turned[f.first.index] != is_against;
    return true;
  }

  std::vector<EdgeId> bounds_of(const Model& model, FaceId face) const {
    std::vector<EdgeId> out;
    for (const Loop& loop : model.loops(face))
      for (const Coedge& c : loop)
        if (c.edge.is_valid()) out.push_back(out_.edge[c.edge.index]);
    std::sort(out.begin(), out.end());
    return out;
  }

  void join_faces() {
    std::map<std::vector<EdgeId>, std::vector<std::pair<int, FaceId>>> within;
    for (std::size_t s = 0; s < solids_.size(); ++s)
      for (const FaceId f : solids_[s].faces())
        within[bounds_of(solids_[s], f)].emplace_back(static_cast<int>(s), f);
    for (const auto& [bounds, faces] : within)
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) join_face(faces[j], faces[i]);
    std::ranges::sort(out_.contacts, {}, [](const Contact& c) {
      return std::tuple(c.face, c.other_face, c.solid, c.other);
    });
  }

  void join_face(std::pair<int, FaceId> one, std::pair<int, FaceId> two) {
    if (one.first == two.first) return;
    if (one.first > two.first) std::swap(one, two);
    const Model &a = solids_[one.first], &b = solids_[two.first];
    if (one.second != two.second && !coincide(a, one.second, b, two.second)) return;
    FaceId& low = out_.face[two.second.index];
    low = std::min(low, out_.face[one.second.index]);
    out_.contacts.push_back({one.first, two.first, one.second, two.second});
  }

  /// Faces of equal boundaries are one where they also agree between these.
  bool coincide(const Model& a, FaceId f, const Model& b, FaceId g) const {
    constexpr int n_samples = 5;
    constexpr double alike = 1e-4;  // of the area; equal boundaries leave no room for a little
    if (std::abs(a.area(f) - b.area(g)) > alike * a.area(f)) return false;
    for (const Point2& uv : inner_samples(a, f, n_samples))
      if (b.distance(g, a.point(f, uv)) > gap_) return false;
    return true;
  }

  void note_users() {
    out_.solids_at_edge.resize(out_.edge.size());
    out_.solids_at_vertex.resize(out_.vertex.size());
    for (std::size_t s = 0; s < solids_.size(); ++s) {
      for (const EdgeId e : solids_[s].edges())
        out_.solids_at_edge[out_.edge[e.index].index].push_back(static_cast<int>(s));
      for (const VertexId v : solids_[s].vertices())
        out_.solids_at_vertex[out_.vertex[v.index].index].push_back(static_cast<int>(s));
    }
  }

  const std::vector<Model>& solids_;
  const double gap_;
  Contacts out_;
};

// --- partial contact
// -------------------------------------------------------------------------------

/// A face by some of its points.
struct Sampled {
  int solid;
  FaceId face;
  std::vector<Point3> points, normals;
  Eigen::AlignedBox3d box;
};

Sampled sampled(const Model& model, int solid, FaceId face) {
  constexpr int n_samples = 8, n_on_edge = 8;
  Sampled out{solid, face, {}, {}, {}};
  for (const Point2& uv : inner_samples(model, face, n_samples)) {
    out.points.push_back(model.point(face, uv));
    out.normals.push_back(model.normal(face, uv));
    out.box.extend(out.points.back());
  }
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop) {
      if (!c.edge.is_valid()) continue;
      const auto [first, last] = model.range(c.edge);
      for (int i = 0; i <= n_on_edge; ++i)
        out.box.extend(model.point(c.edge, first + (last - first) * i / n_on_edge));
    }
  constexpr double margin = 0.05;  // for what bulges between the samples
  const Point3 more = Point3::Constant(margin * out.box.diagonal().norm());
  out.box = {out.box.min() - more, out.box.max() + more};
  return out;
}

/// Faces that only meet along a line have that on an edge of one of them.
bool is_on_edge(const Model& model, FaceId face, const Point3& p, double gap) {
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop)
      if (c.edge.is_valid() && !c.seam && model.distance(c.edge, p) <= gap) return true;
  return false;
}

bool lies_on(const Sampled& a, const Model& own, const Sampled& b, const Model& other, double gap) {
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Point3& p = a.points[i];
    if (!b.box.contains(p) || other.distance(b.face, p) > gap) continue;
    const Point3 facing = other.normal(b.face, other.project(b.face, p));
    if (facing.dot(a.normals[i]) > -std::cos(other.tolerances().angle)) continue;
    if (!is_on_edge(own, a.face, p, gap) && !is_on_edge(other, b.face, p, gap)) return true;
  }
  return false;
}

}  // namespace

Contacts find_contacts(const std::vector<Model>& solids) {
  return ContactFinder(solids).run();
}

std::vector<Overlap> overlapping_faces(const std::vector<Model>& solids, const Contacts& contacts) {
  const double gap = largest_gap(solids);
  std::set<std::pair<FaceId, FaceId>> known;
  for (const Contact& c : contacts.contacts) known.insert(std::minmax(c.face, c.other_face));
  std::vector<Sampled> faces;
  for (std::size_t s = 0; s < solids.size(); ++s)
    for (const FaceId f : solids[s].faces())
      faces.push_back(sampled(solids[s], static_cast<int>(s), f));
  std::vector<Overlap> out;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      const Sampled &a = faces[i], &b = faces[j];
      if (a.solid == b.solid || a.face == b.face || !a.box.intersects(b.box)) continue;
      if (known.contains(std::minmax(a.face, b.face))) continue;
      const Model &one = solids[a.solid], &two = solids[b.solid];
      if (lies_on(a, one, b, two, gap) || lies_on(b, two, a, one, gap))
        out.push_back({a.solid, b.solid, a.face, b.face});
    }
  return out;
}

}  // namespace sweepmesh
