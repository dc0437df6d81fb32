// Numbers rounded so that rounding errors decide nothing.
#pragma once

#include <cmath>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// A multiple of `step`, a power of two, that is nearer than it: numbers that differ by rounding
/// errors become the same, and so do the decisions taken on them, however a solid lies and however
/// large it is. Multiples stay what they are. What lies halfway between two of them, or at another
/// simple fraction, as middles of what was rounded before do, is far from where rounding turns.
inline double on_lattice(double x, double step) {
  constexpr double turn = 0.3819660112501051;      // the golden section of a step
  return std::ceil(x / step - turn) * step + 0.0;  // no zero with a minus
}

inline Point2 on_lattice(const Point2& p, double step) {
  return {on_lattice(p.x(), step), on_lattice(p.y(), step)};
}

}  // namespace sweepmesh
