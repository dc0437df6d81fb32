#include "sweepmesh/imprint/vector_area.h"

namespace sweepmesh {

Point3 vector_area(const Model& model, FaceId face) {
  constexpr int n_parts = 32;
  const Point3 origin = model.point(face, model.uv_bounds(face).first);
  Point3 doubled = Point3::Zero();
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop) {
      if (!c.edge.is_valid() || c.seam) continue;
      const auto [first, last] = model.range(c.edge);
      const double sign = c.reversed ? -1.0 : 1.0;
      Point3 before = model.point(c.edge, first) - origin;
      for (int i = 1; i <= n_parts; ++i) {
        const Point3 here = model.point(c.edge, first + (last - first) * i / n_parts) - origin;
        doubled += sign * before.cross(here);
        before = here;
      }
    }
  return doubled / 2.0;
}

}  // namespace sweepmesh
