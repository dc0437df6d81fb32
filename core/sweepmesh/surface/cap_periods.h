// Parameters of a face that closes on itself, without jumps.
#pragma once

#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// Periods of a face's parameters: the surface's, or what lies between the two sides of a seam; 0
/// where it does not close.
Point2 closing_periods(const Model& model, FaceId face);

/// `value` moved by whole periods to where it is nearest to `reference`; period 0 moves nothing.
double nearest_period(double value, double reference, double period);
Point2 nearest_period(const Point2& value, const Point2& reference, const Point2& periods);

/// A row of parameters without jumps, and how often it turns around each way where it is closed.
struct UnwrappedLoop {
  std::vector<Point2> uv;
  Eigen::Vector2i turns = Eigen::Vector2i::Zero();
};
UnwrappedLoop unwrapped_loop(const std::vector<Point2>& uv, const Point2& periods);

}  // namespace sweepmesh
