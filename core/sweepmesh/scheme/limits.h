// The angles that a scheme may use and what their deviation costs.
//
// An angle that a vertex or an edge should have for its type is a multiple of a quarter turn: END
// 90, SIDE 180, CORNER 270, REVERSAL 360 degrees. The cost of a type is the squared deviation from
// that, in quarter turns, so that one bad corner is worse than two half as bad.
#pragma once

#include <numbers>

#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

inline constexpr double kQuarterTurn = std::numbers::pi / 2;

/// Geometric limits (thesis 7.1.2 and figure 6.5), radians.
struct AngleLimits {
  /// END edges and END vertices stay this far below 180 degrees; everything stays this far above 0
  /// and below 360.
  double margin = 5.0 * std::numbers::pi / 180.0;
  /// How far an edge's dihedral angle may be anywhere from what its type asks for. With 60 degrees
  /// an edge is only what its angle suggests; infinite, only `margin` counts.
  double edge_deviation = std::numbers::pi / 3;
  /// The same for a cap's rim that the boundary bends around: END edges where it bends outwards
  /// (the edge of a round), CORNER edges where it bends inwards (the foot of a fillet). The chords
  /// of the mesh meet at a better angle there than the tangent faces do.
  double rim_deviation = std::numbers::pi / 3;
  /// Whether END edges and END vertices may be as flat as 180 degrees where the boundary bends
  /// outwards around them: the mesh, being made of chords, is still valid there, though poor.
  bool allows_tangent_end = false;
};

/// What is wanted where the roles of faces are free.
inline AngleLimits strict_limits() {
  return {};
}
/// As strict, but that rounds and fillets may be tangent to caps: for solids that have nothing
/// better.
AngleLimits tangent_limits();
/// As tangent, but that edges may be 5 degrees sharper or flatter: cells of 25 degrees are poor,
/// but better than none.
AngleLimits sharp_limits();
/// What is possible at all: where somebody has decided on sources and targets.
AngleLimits lenient_limits();
/// Between the two: what a radial sweep takes that nobody asked for. Right angles between the faces
/// of a shell are halved by it.
AngleLimits radial_limits();

/// How the boundary goes on beside a corner or an edge that may be tangent.
enum class Bend { none, outwards, inwards };

/// The limits at a place where the boundary bends so.
inline AngleLimits of_place(AngleLimits limits, Bend bend) {
  limits.allows_tangent_end &= bend == Bend::outwards;
  return limits;
}

/// 90, 180, 270 or 360 degrees in radians.
inline double ideal_angle(VertexType type) {
  return (2 - static_cast<int>(type)) * kQuarterTurn;
}

/// Squared deviation of an angle (radians) from what the type asks for, in quarter turns.
double angle_cost(double angle, VertexType type);

/// Figure 6.5: END needs an angle below 180 degrees less the margin; below 360 less the margin a
/// vertex may have any other type; a vertex of 360 degrees is CORNER or REVERSAL.
bool is_vertex_allowed(double angle, VertexType type, const AngleLimits& limits);

/// An edge across which the sweep turns (END: a cap's convex rim, CORNER: a cap's concave rim) or
/// goes on (SIDE). `least` and `largest` are the extremes of its dihedral angle. CORNER needs 180
/// degrees or more. `limits` are the general ones, which hold at the place of that bend.
bool is_edge_allowed(double least, double largest, Bend bend, VertexType type,
                     const AngleLimits& limits);

}  // namespace sweepmesh
