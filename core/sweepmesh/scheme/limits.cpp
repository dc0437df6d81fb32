#include "sweepmesh/scheme/limits.h"

#include <limits>

namespace sweepmesh {

namespace {

double most_of_end(const AngleLimits& limits) {
  return 2 * kQuarterTurn + (limits.allows_tangent_end ? limits.margin : -limits.margin);
}

double deviation_at(Bend bend, VertexType type, const AngleLimits& limits) {
  const bool is_bent_rim = (type == VertexType::end && bend == Bend::outwards) ||
                           (type == VertexType::corner && bend == Bend::inwards);
  return is_bent_rim ? limits.rim_deviation : limits.edge_deviation;
}

}  // namespace

double angle_cost(double angle, VertexType type) {
  const double deviation = (angle - ideal_angle(type)) / kQuarterTurn;
  return deviation * deviation;
}

bool is_vertex_allowed(double angle, VertexType type, const AngleLimits& limits) {
  if (type == VertexType::end) return angle < most_of_end(limits);
  if (type == VertexType::side) return angle < 4 * kQuarterTurn - limits.margin;
  return true;
}

bool is_edge_allowed(double least, double largest, Bend bend, VertexType type,
                     const AngleLimits& general) {
  const AngleLimits limits = of_place(general, bend);
  if (least < limits.margin || largest > 4 * kQuarterTurn - limits.margin) return false;
  const double ideal = ideal_angle(type), deviation = deviation_at(bend, type, limits);
  if (ideal - least > deviation || largest - ideal > deviation) return false;
  if (type == VertexType::end) return largest < most_of_end(limits);
  if (type == VertexType::corner) return least > 2 * kQuarterTurn - limits.margin;
  return type == VertexType::side;
}

AngleLimits tangent_limits() {
  AngleLimits out;
  out.rim_deviation = kQuarterTurn + out.margin;
  out.allows_tangent_end = true;
  return out;
}

AngleLimits lenient_limits() {
  AngleLimits out;
  out.edge_deviation = out.rim_deviation = std::numeric_limits<double>::infinity();
  out.allows_tangent_end = true;
  return out;
}

AngleLimits sharp_limits() {
  AngleLimits out = tangent_limits();
  out.edge_deviation = 65 * kQuarterTurn / 90;
  return out;
}

AngleLimits radial_limits() {
  AngleLimits out;
  out.edge_deviation = out.rim_deviation = 100 * kQuarterTurn / 90;
  return out;
}

}  // namespace sweepmesh
