// Numbers rounded so that rounding errors decide nothing.
#pragma once

#include <cmath>

#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// The nearest multiple of `step`, a power of two: numbers that differ by rounding errors become
/// the same, and so do the decisions taken on them, however a solid lies and however large it is.
inline double on_lattice(double x, double step) {
  return std::round(x / step) * step + 0.0;  // no zero with a minus
}

inline Point2 on_lattice(const Point2& p, double step) {
  return {on_lattice(p.x(), step), on_lattice(p.y(), step)};
}

}  // namespace sweepmesh
