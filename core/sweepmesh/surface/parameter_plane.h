// A plane in which a face's mesh domain is one-to-one, seams and poles included.
//
//   planar face         orthonormal coordinates in its plane
//   no turn around      (u,v), scaled by the mean lengths of the two derivatives
//   closed around, or   polar: the angle is the parameter that closes, the radius the other one,
//   measured with a pole         from the pole (a dome) or from beyond the inner loop (a band)
//
// In polar form a seam is an ordinary ray and a pole the ordinary point 0, so nothing has to be cut
// or sewn. Counterclockwise in the plane is counterclockwise seen from outside the solid.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/cap_boundary.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

class ParameterPlane {
 public:
  /// Throws InputError naming the face for domains that have no such plane (a torus' whole tube, a
  /// sphere with a single hole off its poles, loops that wind around both ways). `outer`: of a
  /// band's two loops the one that is to be the outer one.
  ParameterPlane(const Model& model, FaceId face, const CapLoops& loops,
                 std::optional<int> outer = {});

  /// The loops in the plane, in the order of the caller's.
  const PlanarLoops& loops() const { return loops_; }
  bool is_exact() const { return kind_ == Kind::planar; }
  /// Of the exact plane: the point in space.
  Point3 in_space(const Point2& p) const { return origin_ + axes_ * p; }
  /// Parameters of a point of the plane, within the face's bounds where it is periodic.
  Point2 uv(const Point2& p) const;

 private:
  enum class Kind { planar, scaled, polar };
  void lay_planar(const CapLoops& loops);
  bool find_axis(const CapLoops& loops, std::optional<int> outer);
  void lay_centre_of_band(bool is_at_high);
  void lay_scaled(const CapLoops& loops);
  void lay_polar(const CapLoops& loops);
  /// (along, across) with `along` the parameter that closes; right-handed as (u,v) is.
  Point2 turned(const Point2& uv) const { return along_v_ ? Point2(uv.y(), -uv.x()) : uv; }
  Point2 turned_back(const Point2& st) const { return along_v_ ? Point2(-st.y(), st.x()) : st; }

  const Model* model_;
  FaceId face_;
  Kind kind_ = Kind::scaled;
  PlanarLoops loops_;
  Point2 periods_ = Point2::Zero();
  Point3 origin_ = Point3::Zero();
  Eigen::Matrix<double, 3, 2> axes_ = Eigen::Matrix<double, 3, 2>::Zero();
  Point2 scale_ =
      Point2::Ones();  ///< scaled: per parameter; polar: angle per `along`, length per `across`
  bool along_v_ = false;
  double across_of_centre_ = 0.0;  ///< polar: value of `across` at radius 0
};

}  // namespace sweepmesh
