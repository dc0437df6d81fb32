#include "sweepmesh/scheme/fold_bound.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "sweepmesh/base/element_quality.h"

namespace sweepmesh {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Ring = std::vector<Point3>;

double angle_between(const Point3& a, const Point3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The rotation that carries a ring best to its next layer.
Matrix3 rotation(const Ring& from, const Ring& to) {
  const Point3 c = centre_of(from), d = centre_of(to);
  Matrix3 h = Matrix3::Zero();
  double square = 0.0;
  for (std::size_t j = 0; j < from.size(); ++j) {
    h += (to[j] - d) * (from[j] - c).transpose();
    square += (from[j] - c).norm() * (to[j] - d).norm();
  }
  h += square * area_of(to).normalized() * area_of(from).normalized().transpose();
  const Eigen::JacobiSVD<Matrix3> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Point3 sign(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1.0 : 1.0);
  return svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
}

/// The part of a rotation around an axis.
double twist(const Matrix3& r, const Point3& axis) {
  const Eigen::Quaterniond q(r);
  return 2.0 * std::atan2(q.vec().dot(axis), q.w());
}

double wrapped(double a) {
  return std::remainder(a, 2.0 * std::numbers::pi);
}

double angle_around(const Point3& from, const Point3& to, const Point3& axis) {
  const Point3 a = from - axis * axis.dot(from), b = to - axis * axis.dot(to);
  return std::atan2(a.cross(b).dot(axis), a.dot(b));
}

struct Track {
  std::set<int> columns;
  double turn = 0.0, lowest = 0.0, highest = 0.0;
  void add(double a) {
    turn += a;
    lowest = std::min(lowest, turn);
    highest = std::max(highest, turn);
  }
};

class Winder {
 public:
  explicit Winder(FoldMeasures& out) : out_(out) {}

  void add(const WallSection& s) {
    std::vector<int> track;
    for (const WallRing& hole : s.holes) track.push_back(track_of(hole));
    for (int k = 0; k + 1 < s.outer.n_layers(); ++k) {
      const Matrix3 r = rotation(s.outer.layers[k], s.outer.layers[k + 1]);
      const Point3 axis = area_of(s.outer.layers[k]).normalized();
      for (std::size_t h = 0; h < s.holes.size(); ++h) {
        const Ring &a = s.holes[h].layers[k], &b = s.holes[h].layers[k + 1];
        note(tracks_[track[h]], wrapped(twist(r.transpose() * rotation(a, b), axis)));
        for (std::size_t g = h + 1; g < s.holes.size(); ++g) {
          const Ring &c = s.holes[g].layers[k], &d = s.holes[g].layers[k + 1];
          const Point3 before = centre_of(c) - centre_of(a),
                       after = r.transpose() * (centre_of(d) - centre_of(b));
          note(pairs_[std::minmax(track[h], track[g])], angle_around(before, after, axis));
        }
      }
    }
  }

  void finish() {
    for (const Track& t : tracks_) finish(t);
    for (const auto& [pair, t] : pairs_) finish(t);
  }

 private:
  void finish(const Track& t) {
    out_.winding = std::max(out_.winding, std::abs(t.turn));
    out_.swing = std::max(out_.swing, t.highest - t.lowest);
  }
  void note(Track& t, double a) { t.add(a); }
  int track_of(const WallRing& ring) {
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      int shared = 0;
      for (const int c : ring.columns) shared += tracks_[t].columns.contains(c);
      if (2 * shared < ring.n_columns()) continue;
      tracks_[t].columns = {ring.columns.begin(), ring.columns.end()};
      return static_cast<int>(t);
    }
    tracks_.push_back({{ring.columns.begin(), ring.columns.end()}});
    return static_cast<int>(tracks_.size()) - 1;
  }

  FoldMeasures& out_;
  std::vector<Track> tracks_;
  std::map<std::pair<int, int>, Track> pairs_;
};

void tilts(const WallSection& s, FoldMeasures& out) {
  for (int k = 0; k < s.outer.n_layers(); ++k) {
    const Point3 up = area_of(s.outer.layers[k]);
    for (const WallRing& hole : s.holes) {
      out.tilt = std::max(out.tilt, angle_between(up, -area_of(hole.layers[k])));
      if (k + 1 == s.outer.n_layers()) continue;
      const Point3 mean = centre_of(s.outer.layers[k + 1]) - centre_of(s.outer.layers[k]);
      for (int j = 0; j < hole.n_columns(); ++j) {
        const Point3 step = hole.layers[k + 1][j] - hole.layers[k][j];
        out.run_back = std::max(out.run_back, std::min(angle_between(up, step), angle_between(mean, step)));
      }
    }
  }
}

// --- mean value placement ----------------------------------------------------------------------

class Lattice {
 public:
  Lattice(const WallSection& s, FoldMeasures& out) : s_(s), out_(out) {
    rings_.push_back(&s.outer);
    for (const WallRing& hole : s.holes) rings_.push_back(&hole);
    flatten();
    measure_lattice();
    measure_rims();
  }
  double inverted = 0.0, total = 0.0;

 private:
  void flatten() {
    const int m = s_.outer.n_layers() / 2;
    const Point3 up = area_of(s_.outer.layers[m]).normalized();
    const Point3 u = up.unitOrthogonal(), v = up.cross(u), c = centre_of(s_.outer.layers[m]);
    double length = 0.0;
    int n = 0;
    for (const WallRing* ring : rings_) {
      auto& flat = flat_.emplace_back();
      for (const Point3& p : ring->layers[m]) flat.emplace_back((p - c).dot(u), (p - c).dot(v));
      for (std::size_t j = 0; j < flat.size(); ++j) length += (flat[j] - flat[(j + 1) % flat.size()]).norm();
      n += static_cast<int>(flat.size());
    }
    spacing_ = length / n;
    Point2 low = flat_[0][0], high = low;
    for (const Point2& p : flat_[0]) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    low_ = low;
    const double most = 32.0;
    spacing_ = std::max(spacing_, (high - low).maxCoeff() / most);
    nx_ = static_cast<int>((high - low).x() / spacing_) + 2;
    ny_ = static_cast<int>((high - low).y() / spacing_) + 2;
    low_ -= Point2::Constant(0.37 * spacing_);
  }

  /// Empty for a point outside.
  std::vector<double> weights(const Point2& p) const {
    std::vector<double> w;
    double sum = 0.0, turn = 0.0;
    for (const auto& ring : flat_) {
      const std::size_t n = ring.size();
      std::vector<double> half(n), r(n);
      for (std::size_t j = 0; j < n; ++j) r[j] = (ring[j] - p).norm();
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t i = (j + 1) % n;
        const double cross = cross2(ring[j] - p, ring[i] - p), dot = (ring[j] - p).dot(ring[i] - p);
        const double below = r[j] * r[i] + dot;
        if (!(r[j] > 0.0) || !(below > 0.0)) return {};
        half[j] = cross / below;
        turn += std::atan2(cross, dot);
      }
      for (std::size_t j = 0; j < n; ++j) {
        w.push_back((half[j] + half[(j + n - 1) % n]) / r[j]);
        sum += w.back();
      }
    }
    if (turn < std::numbers::pi) return {};
    for (double& x : w) x /= sum;
    return w;
  }

  Point3 at(const std::vector<double>& w, int k) const {
    Point3 out = Point3::Zero();
    std::size_t i = 0;
    for (const WallRing* ring : rings_)
      for (const Point3& p : ring->layers[k]) out += w[i++] * p;
    return out;
  }

  std::vector<Point3> column(const Point2& p) const {
    const auto w = weights(p);
    std::vector<Point3> out;
    if (w.empty()) return out;
    for (int k = 0; k < s_.outer.n_layers(); ++k) out.push_back(at(w, k));
    return out;
  }

  void note(double det, double weight) {
    total += weight;
    if (det <= 0.0) inverted += weight;
  }

  void measure_lattice() {
    std::vector<std::vector<Point3>> node;
    for (int y = 0; y < ny_; ++y)
      for (int x = 0; x < nx_; ++x) node.push_back(column(low_ + spacing_ * Point2(x, y)));
    for (int y = 0; y + 1 < ny_; ++y)
      for (int x = 0; x + 1 < nx_; ++x) {
        const auto &a = node[y * nx_ + x], &b = node[y * nx_ + x + 1], &c = node[(y + 1) * nx_ + x + 1],
                   &d = node[(y + 1) * nx_ + x];
        if (a.empty() || b.empty() || c.empty() || d.empty()) continue;
        for (std::size_t k = 0; k + 1 < a.size(); ++k) {
          const Point3 low[4] = {a[k], b[k], c[k], d[k]}, high[4] = {a[k + 1], b[k + 1], c[k + 1], d[k + 1]};
          const auto axes = principal_axes(low, high);
          const double det = normalised_determinant(axes[0], axes[1], axes[2]);
          out_.least = std::min(out_.least, det);
          note(det, spacing_ * spacing_);
        }
      }
  }

  void measure_rims() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const auto& flat = flat_[r];
      const auto& layers = rings_[r]->layers;
      const std::size_t n = flat.size();
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t i = (j + 1) % n;
        const Point2 along = flat[i] - flat[j];
        const Point2 inward = Point2(-along.y(), along.x()).normalized() * 0.7 * spacing_;
        const auto inner = column(0.5 * (flat[i] + flat[j]) + inward);
        if (inner.empty()) continue;
        for (std::size_t k = 0; k + 1 < layers.size(); ++k) {
          const Point3 mid_low = 0.5 * (layers[k][j] + layers[k][i]), mid_high = 0.5 * (layers[k + 1][j] + layers[k + 1][i]);
          const Point3 tangent = layers[k][i] - layers[k][j] + layers[k + 1][i] - layers[k + 1][j];
          const Point3 in = inner[k] - mid_low + inner[k + 1] - mid_high;
          const Point3 up = mid_high - mid_low + inner[k + 1] - inner[k];
          const double det = normalised_determinant(tangent, in, up);
          out_.rim_least = std::min(out_.rim_least, det);
          note(det, along.norm() * 0.7 * spacing_);
        }
      }
    }
  }

  const WallSection& s_;
  FoldMeasures& out_;
  std::vector<const WallRing*> rings_;
  std::vector<std::vector<Point2>> flat_;
  double spacing_ = 1.0;
  Point2 low_;
  int nx_ = 0, ny_ = 0;
};

}  // namespace

FoldMeasures fold_measures(const std::vector<WallSection>& sections) {
  FoldMeasures out;
  Winder winder(out);
  for (const WallSection& s : sections) {
    winder.add(s);
    tilts(s, out);
    const Lattice lattice(s, out);
    if (lattice.total > 0.0) out.folded = std::max(out.folded, lattice.inverted / lattice.total);
  }
  winder.finish();
  return out;
}

}  // namespace sweepmesh
