// All tolerances of a run in one place, derived from the size of the model.
#pragma once

namespace sweepmesh {

struct Tolerances {
  double model_size = 1.0;  ///< diagonal of the bounding box
  double point = 1e-7;     ///< points closer than this are one point (the CAD file's own tolerance)
  double angle = 1e-3;     ///< radians; directions closer than this are parallel
  double relative = 1e-9;  ///< for ratios and parameters scaled to 0..1

  static Tolerances from_size(double model_size, double cad_tolerance) {
    Tolerances t;
    t.model_size = model_size;
    t.point = cad_tolerance > 1e-7 * model_size ? cad_tolerance : 1e-7 * model_size;
    return t;
  }
};

}  // namespace sweepmesh
