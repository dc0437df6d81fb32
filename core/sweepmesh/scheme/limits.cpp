#include "sweepmesh/scheme/limits.h"

#include <limits>

namespace sweepmesh {

double angle_cost(double angle, VertexType type) {
  const double deviation = (angle - ideal_angle(type)) / kQuarterTurn;
  return deviation * deviation;
}

bool is_vertex_allowed(double angle, VertexType type, const AngleLimits& limits) {
  if (type == VertexType::end) return angle < 2 * kQuarterTurn - limits.margin;
  if (type == VertexType::side) return angle < 4 * kQuarterTurn - limits.margin;
  return true;
}

bool is_edge_allowed(double least, double largest, VertexType type, const AngleLimits& limits) {
  if (least < limits.margin || largest > 4 * kQuarterTurn - limits.margin) return false;
  const double ideal = ideal_angle(type);
  if (ideal - least > limits.edge_deviation || largest - ideal > limits.edge_deviation)
    return false;
  const double flat = 2 * kQuarterTurn;
  if (type == VertexType::end)
    return largest < (limits.allows_tangent_end ? flat + limits.margin : flat - limits.margin);
  if (type == VertexType::corner) return least > flat - limits.margin;
  return type == VertexType::side;
}

AngleLimits lenient_limits() {
  AngleLimits out;
  out.edge_deviation = std::numeric_limits<double>::infinity();
  return out;
}

}  // namespace sweepmesh
