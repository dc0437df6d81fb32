#include "sweepmesh/scheme/fold_bound.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace sweepmesh {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Ring = std::vector<Point3>;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMostStep = 60.0 * kDegree;   ///< from layer to layer
constexpr double kMostTilt = 120.0 * kDegree;  ///< of a hole in its section
constexpr double kMostChange = 0.5;            ///< of an outer ring's shape, of its size
constexpr double kLeastSide = 0.2;             ///< sine of the angle between an axis and a distance

/// A ring around its centre, with its unit normal as long as the ring is wide.
struct Arms {
  explicit Arms(const Ring& ring) : centre(centre_of(ring)) {
    for (const Point3& p : ring) arm.push_back(p - centre);
    for (const Point3& a : arm) square += a.squaredNorm();
    normal = area_of(ring).normalized() * std::sqrt(square);
  }
  Point3 centre, normal;
  Ring arm;
  double square = 0.0;
};

/// The rotation that carries a ring, normal and all, best to another one (Kabsch).
Matrix3 best_rotation(const Arms& from, const Arms& to) {
  Matrix3 h = to.normal * from.normal.transpose();
  for (std::size_t j = 0; j < from.arm.size(); ++j) h += to.arm[j] * from.arm[j].transpose();
  const Eigen::JacobiSVD<Matrix3> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3 u = svd.matrixU(), v = svd.matrixV();
  const double sign = (u * v.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return u * Point3(1.0, 1.0, sign).asDiagonal() * v.transpose();
}

/// What a rotation and a scaling leave over, of the ring's size.
double change(const Arms& from, const Arms& to, const Matrix3& rotation) {
  const double scale = std::sqrt(to.square / from.square);
  double left = 0.0;
  for (std::size_t j = 0; j < from.arm.size(); ++j)
    left += (to.arm[j] - scale * rotation * from.arm[j]).squaredNorm();
  return std::sqrt(left / to.square);
}

double angle_of(const Matrix3& rotation) {
  return Eigen::AngleAxisd(rotation).angle();
}

/// The turn of a rotation around an axis once the axis has swung to where it goes.
double turn_around(const Matrix3& rotation, const Point3& axis) {
  const Eigen::Quaterniond q(rotation);
  return 2.0 * std::atan2(q.vec().dot(axis), q.w());
}

double angle_between(const Point3& a, const Point3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The frames of a ring in all layers, relative to the first; empty where it turns too fast.
std::vector<Matrix3> frames_of(const std::vector<Arms>& ring) {
  std::vector<Matrix3> out = {Matrix3::Identity()};
  for (std::size_t k = 1; k < ring.size(); ++k) {
    const Matrix3 step = best_rotation(ring[k - 1], ring[k]);
    if (angle_of(step) > kMostStep) return {};
    out.push_back(step * out.back());
  }
  return out;
}

std::vector<Arms> arms_of(const WallRing& ring) {
  return {ring.layers.begin(), ring.layers.end()};
}

/// Adds up an angle from layer to layer; unknown once a step is too large.
class Turns {
 public:
  void to(double angle) {
    const double step = std::remainder(angle - last_, 2.0 * std::numbers::pi);
    if (std::abs(step) > kMostStep) is_known_ = false;
    sum_ += step;
    last_ = angle;
  }
  void lose() { is_known_ = false; }
  std::optional<double> sum() const { return is_known_ ? std::optional(sum_) : std::nullopt; }

 private:
  double last_ = 0.0, sum_ = 0.0;
  bool is_known_ = true;
};

/// One section: the outer ring's frames, and what its holes do in them.
class Frame {
 public:
  explicit Frame(const WallSection& section) {
    const std::vector<Arms> outer = arms_of(section.outer);
    frames_ = frames_of(outer);
    axis_ = outer.front().normal.normalized();
    bool is_rigid = true;
    for (std::size_t k = 0; k < frames_.size(); ++k)
      is_rigid = is_rigid && change(outer.front(), outer[k], frames_[k]) <= kMostChange;
    if (!is_rigid) frames_.clear();
  }
  bool is_known() const { return !frames_.empty(); }

  /// By how much a hole turns around itself.
  std::optional<double> spin(const std::vector<Arms>& hole) const {
    const std::vector<Matrix3> own = frames_of(hole);
    if (own.empty()) return {};
    Turns turns;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const Point3 up = -(frames_[k].transpose() * hole[k].normal);
      if (angle_between(axis_, up) > kMostTilt) return {};
      turns.to(turn_around(frames_[k].transpose() * own[k], axis_));
    }
    return turns.sum();
  }

  /// By how much two holes turn around each other.
  std::optional<double> orbit(const std::vector<Arms>& a, const std::vector<Arms>& b) const {
    Turns turns;
    const Point3 first = b.front().centre - a.front().centre;
    for (std::size_t k = 0; k < frames_.size(); ++k) {
      const Point3 d = frames_[k].transpose() * (b[k].centre - a[k].centre);
      if (axis_.cross(d).norm() < kLeastSide * d.norm()) return {};
      const Point3 from = axis_.cross(first), to = axis_.cross(d);
      turns.to(std::atan2(from.cross(to).dot(axis_), from.dot(to)));
    }
    return turns.sum();
  }

 private:
  std::vector<Matrix3> frames_;
  Point3 axis_ = Point3::Zero();
};

/// What is known of a hole, or two, over several slabs.
struct Track {
  double sum = 0.0, largest = 0.0;
  std::set<FaceId> faces;

  void add(std::optional<double> angle, const std::vector<FaceId>& more) {
    sum = angle ? sum + *angle : 0.0;
    if (!angle) faces.clear();
    faces.insert(more.begin(), more.end());
  }
};

class Winder {
 public:
  void add(const WallSection& section) {
    std::vector<int> numbers;
    for (const WallRing& hole : section.holes) numbers.push_back(number_of(hole));
    const Frame frame(section);
    std::vector<std::vector<Arms>> holes;
    for (const WallRing& hole : section.holes) holes.push_back(arms_of(hole));
    for (std::size_t a = 0; a < holes.size(); ++a) {
      const auto known = frame.is_known() ? frame.spin(holes[a]) : std::nullopt;
      note({numbers[a], numbers[a]}, known, section.holes[a].face, {});
      for (std::size_t b = a + 1; b < holes.size(); ++b) {
        const auto both = frame.is_known() ? frame.orbit(holes[a], holes[b]) : std::nullopt;
        note(std::minmax(numbers[a], numbers[b]), both, section.holes[a].face,
             section.holes[b].face);
      }
    }
  }
  const Winding& largest() const { return largest_; }

 private:
  /// Holes of different slabs are one where they have most columns in common.
  int number_of(const WallRing& hole) {
    const std::set<int> columns(hole.columns.begin(), hole.columns.end());
    for (std::size_t h = 0; h < columns_.size(); ++h) {
      const auto n_shared =
          std::ranges::count_if(columns, [&](int c) { return columns_[h].contains(c); });
      if (2 * n_shared < hole.n_columns()) continue;
      columns_[h] = columns;
      return static_cast<int>(h);
    }
    columns_.push_back(columns);
    return static_cast<int>(columns_.size()) - 1;
  }

  void note(std::pair<int, int> holes, std::optional<double> angle,
            const std::vector<FaceId>& faces, const std::vector<FaceId>& others) {
    Track& track = tracks_[holes];
    track.add(angle, faces);
    track.faces.insert(others.begin(), others.end());
    if (std::abs(track.sum) > largest_.angle)
      largest_ = {std::abs(track.sum),
                  holes.first != holes.second,
                  {track.faces.begin(), track.faces.end()}};
  }

  std::vector<std::set<int>> columns_;  ///< by number of a hole, in the last slab that it was seen
  std::map<std::pair<int, int>, Track> tracks_;
  Winding largest_;
};

}  // namespace

Winding largest_winding(const std::vector<WallSection>& sections) {
  Winder winder;
  for (const WallSection& section : sections) winder.add(section);
  return winder.largest();
}

}  // namespace sweepmesh
