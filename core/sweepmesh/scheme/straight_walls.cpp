#include "sweepmesh/scheme/straight_walls.h"

#include <algorithm>
#include <array>

namespace sweepmesh {
namespace {

constexpr double kParallelCosine = 0.9998;  // one degree

bool is_straight(const Model& model, EdgeId e) {
  const auto [first, last] = model.range(e);
  const Point3 at_start = model.tangent(e, first);
  constexpr std::array places = {0.25, 0.5, 0.75, 1.0};
  return std::ranges::all_of(places, [&](double s) {
    return at_start.dot(model.tangent(e, first + s * (last - first))) > kParallelCosine;
  });
}

bool has_one_normal(const Model& model, const Coedge& c) {
  const auto [first, last] = model.range(c);
  const auto normal = [&](double t) { return model.normal(c.face, model.uv(c, t)); };
  return normal(first).dot(normal(last)) > kParallelCosine;
}

bool is_straight_wall(const Model& model, const Scheme& scheme, FaceId face) {
  bool has_axial = false;
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop) {
      if (!c.edge.is_valid() || scheme.edge_role[c.edge.index] != EdgeRole::axial) continue;
      has_axial = true;
      if (!is_straight(model, c.edge)) return false;
      if (!model.is_planar(face) && !has_one_normal(model, c)) return false;
    }
  return has_axial;
}

}  // namespace

bool has_straight_walls(const Model& model, const Scheme& scheme) {
  return std::ranges::all_of(scheme.faces_with(FaceRole::linking),
                             [&](FaceId f) { return is_straight_wall(model, scheme, f); });
}

}  // namespace sweepmesh
