#include "sweepmesh/scheme/distortion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sweepmesh {
namespace {

double area_of(const Model& model, const Scheme& scheme, FaceRole role) {
  double area = 0;
  for (const FaceId f : scheme.faces_with(role)) area += model.area(f);
  return area;
}

double squared_turn(const Model& model, EdgeId e) {
  const auto [a, b] = model.range(e);
  const double cosine = std::clamp(model.tangent(e, a).dot(model.tangent(e, b)), -1.0, 1.0);
  const double quarters = std::acos(cosine) / (std::numbers::pi / 2);
  return quarters * quarters;
}

double mean_turn(const Model& model, const Scheme& scheme) {
  double sum = 0, length = 0;
  for (const EdgeId e : model.edges()) {
    if (scheme.edge_role[e.index] != EdgeRole::axial) continue;
    sum += model.length(e) * squared_turn(model, e);
    length += model.length(e);
  }
  return length > 0 ? sum / length : 0.0;
}

}  // namespace

double sweep_distortion(const Model& model, const Scheme& scheme) {
  const double sources = area_of(model, scheme, FaceRole::source);
  const double targets = area_of(model, scheme, FaceRole::target);
  const double ratio = sources > 0 && targets > 0 ? std::log(sources / targets) : 0.0;
  return std::min(1.0, ratio * ratio) / 2 + std::min(1.0, mean_turn(model, scheme)) / 2;
}

}  // namespace sweepmesh
