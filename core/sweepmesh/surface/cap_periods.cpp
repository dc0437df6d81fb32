#include "sweepmesh/surface/cap_periods.h"

#include <cmath>

namespace sweepmesh {

Point2 closing_periods(const Model& model, FaceId face) {
  Point2 periods = model.periods(face);
  for (const Loop& loop : model.loops(face))
    for (std::size_t i = 0; i < loop.size(); ++i)
      for (std::size_t j = i + 1; j < loop.size() && loop[i].seam; ++j) {
        if (loop[j].edge != loop[i].edge) continue;
        const double t = 0.5 * (model.range(loop[i]).first + model.range(loop[i]).second);
        const Point2 apart = (model.uv(loop[i], t) - model.uv(loop[j], t)).cwiseAbs();
        const int axis = apart.x() > apart.y() ? 0 : 1;
        if (periods[axis] == 0.0) periods[axis] = apart[axis];
      }
  return periods;
}

double nearest_period(double value, double reference, double period) {
  return period > 0.0 ? value - period * std::round((value - reference) / period) : value;
}

Point2 nearest_period(const Point2& value, const Point2& reference, const Point2& periods) {
  return {nearest_period(value.x(), reference.x(), periods.x()),
          nearest_period(value.y(), reference.y(), periods.y())};
}

UnwrappedLoop unwrapped_loop(const std::vector<Point2>& uv, const Point2& periods) {
  UnwrappedLoop out;
  for (const Point2& p : uv)
    out.uv.push_back(out.uv.empty() ? p : nearest_period(p, out.uv.back(), periods));
  const Point2 end = nearest_period(out.uv.front(), out.uv.back(), periods);
  for (int axis = 0; axis < 2; ++axis)
    if (periods[axis] > 0.0)
      out.turns[axis] =
          static_cast<int>(std::lround((end[axis] - out.uv.front()[axis]) / periods[axis]));
  return out;
}

}  // namespace sweepmesh
