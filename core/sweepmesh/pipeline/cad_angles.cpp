#include "sweepmesh/pipeline/cad_angles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>

#include "sweepmesh/quality/quality.h"

namespace sweepmesh {
namespace {

constexpr double sharp = 20.0, flat = 160.0;  // degrees

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

bool is_cap(FaceRole role) {
  return role == FaceRole::source || role == FaceRole::target;
}

/// How far an angle is from one that a single element can fill.
double misfit(double angle) {
  return std::min(std::abs(angle), std::abs(180.0 - angle));
}

class Finder {
 public:
  Finder(const Model& model, const Scheme& scheme) : model_(model), scheme_(scheme) {
    for (const FaceId f : model.faces()) {
      const auto& loops = model.loops(f);
      for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t c = 0; c < loops[l].size(); ++c)
          corners_[loops[l][c].end].push_back({f, static_cast<int>(l), static_cast<int>(c)});
    }
  }

  std::optional<double> angle_of(const Owner& owner, const Point3& p) const {
    if (owner.kind == EntityKind::edge) return of_edge(EdgeId{owner.index}, &p);
    if (owner.kind == EntityKind::vertex) return of_vertex(VertexId{owner.index});
    return {};
  }

 private:
  struct Corner {
    FaceId face;
    int loop, coedge;
  };

  std::optional<double> of_edge(EdgeId e, const Point3* p) const {
    const auto& uses = model_.coedges(e);
    if (uses.size() != 2 || uses[0].face == uses[1].face) return {};
    const auto [first, last] = model_.range(e);
    const double fraction = p ? (model_.project(e, *p) - first) / (last - first) : 0.5;
    const double angle = degrees(model_.dihedral(e, std::clamp(fraction, 0.0, 1.0)));
    if (angle < sharp) return angle;
    const FaceRole a = scheme_.face_role[uses[0].face.index],
                   b = scheme_.face_role[uses[1].face.index];
    const bool turns =
        (is_cap(a) && b == FaceRole::linking) || (is_cap(b) && a == FaceRole::linking);
    if (turns && angle > flat && angle < 360.0 - flat) return angle;
    return {};
  }

  std::optional<double> of_vertex(VertexId v) const {
    std::optional<double> worst;
    const auto add = [&](double angle) {
      if (!worst || misfit(angle) < misfit(*worst)) worst = angle;
    };
    const auto at = corners_.find(v);
    if (at == corners_.end()) return {};
    for (const Corner& c : at->second) {
      const double angle = degrees(model_.interior_angle(c.face, c.loop, c.coedge));
      if (angle < sharp || (ends_at(c) && angle > flat)) add(angle);
    }
    for (const EdgeId e : model_.edges_at(v))
      if (const auto angle = of_edge(e, nullptr)) add(*angle);
    return worst;
  }

  /// Whether a linking face has a single quad in a corner.
  bool ends_at(const Corner& c) const {
    if (scheme_.face.size() <= static_cast<std::size_t>(c.face.index)) return false;
    const auto& type = scheme_.face[c.face.index].type;
    return !type.empty() && type[c.loop][c.coedge] == VertexType::end;
  }

  const Model& model_;
  const Scheme& scheme_;
  std::map<VertexId, std::vector<Corner>> corners_;
};

}  // namespace

std::vector<PoorAngle> poor_cad_angles(const Model& model, const Scheme& scheme,
                                       const VolumeMesh& mesh, double poor,
                                       const Context& context) {
  const std::vector<double> value = scaled_jacobians(mesh, context);
  const Finder finder(model, scheme);
  std::map<Owner, double> found;
  std::set<int> seen;
  const auto look_at = [&](std::span<const int> nodes) {
    for (const int n : nodes) {
      const Owner& owner = mesh.owner[n];
      if (owner.index < 0 || !seen.insert(n).second) continue;
      const auto angle = finder.angle_of(owner, mesh.points.row(n).transpose());
      if (!angle) continue;
      const auto [at, is_new] = found.emplace(owner, *angle);
      if (!is_new && misfit(*angle) < misfit(at->second)) at->second = *angle;
    }
  };
  for (long e = 0; e < mesh.n_elements(); ++e)
    if (value[e] < poor) look_at(mesh.element(e));
  std::vector<PoorAngle> out;
  for (const auto& [entity, angle] : found) out.push_back({entity, angle});
  return out;
}

std::string warning_of(std::vector<PoorAngle> angles) {
  constexpr std::size_t most = 6;
  if (angles.empty()) return {};
  std::ranges::stable_sort(angles, {}, [](const PoorAngle& a) { return misfit(a.degrees); });
  std::string names;
  for (std::size_t i = 0; i < std::min(most, angles.size()); ++i) {
    const Owner& o = angles[i].entity;
    const std::string name =
        o.kind == EntityKind::vertex ? name_of(VertexId{o.index}) : name_of(EdgeId{o.index});
    names += (i > 0 ? ", " : "") + name + " (" + std::to_string(std::lround(angles[i].degrees)) +
             " degrees)";
  }
  const std::size_t more = angles.size() - std::min(most, angles.size());
  if (more > 0) names += " and " + std::to_string(more) + " more";
  return "The CAD model's own angles leave only poor elements at " + names + ".";
}

}  // namespace sweepmesh
