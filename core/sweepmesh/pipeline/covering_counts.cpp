#include "sweepmesh/pipeline/covering_counts.h"

#include <algorithm>
#include <cmath>

namespace sweepmesh {
namespace {

constexpr double kTooMuch = 0.085;  ///< nodes may slide a little afterwards
constexpr double kGoal = 0.06;
constexpr double kToBlame = 0.5;  ///< of the most that the chords of an edge cost

/// What chords of even length do to an edge.
struct Chords {
  double beside =
      0.0;  ///< area between them and the curve, about: two thirds of chord times height
  double shorter = 0.0;  ///< by which part of its length
};

Chords chords_of(const Model& model, EdgeId edge, int n) {
  std::vector<double> fractions;
  for (int i = 0; i <= 2 * n; ++i) fractions.push_back(i / (2.0 * n));
  const auto t = model.at_length_fractions(edge, fractions);
  Chords out;
  double length = 0.0;
  for (int i = 0; i < n; ++i) {
    const Point3 a = model.point(edge, t[2 * i]), b = model.point(edge, t[2 * i + 2]);
    const Point3 middle = model.point(edge, t[2 * i + 1]);
    length += (b - a).norm();
    out.beside += 2.0 / 3.0 * (middle - a).cross(b - a).norm();
  }
  out.shorter = std::max(0.0, 1.0 - length / model.length(edge));
  return out;
}

struct Side {
  EdgeId edge;
  double cost;  ///< of its chords, in area of the face
};

/// A face that the edge runs along gets narrower with it; half of that is each side's.
std::vector<Side> sides_of(const Model& model, const FaceCoverage& face,
                           const Intervals& intervals) {
  std::vector<Side> out;
  for (const Loop& loop : model.loops(face.face))
    for (const Coedge& c : loop) {
      if (!c.edge.is_valid() || intervals.edge[c.edge.index] < 1) continue;
      const Chords chords = chords_of(model, c.edge, intervals.edge[c.edge.index]);
      out.push_back({c.edge, chords.beside + 0.5 * chords.shorter * face.area});
    }
  return out;
}

/// Those whose chords are to blame; all where the face misses far more than they cost.
std::vector<Side> to_blame(const std::vector<Side>& sides, double missed) {
  double sum = 0.0, most = 0.0;
  for (const Side& s : sides) {
    sum += s.cost;
    most = std::max(most, s.cost);
  }
  if (sum < 0.5 * missed) return sides;
  std::vector<Side> out;
  std::ranges::copy_if(sides, std::back_inserter(out),
                       [&](const Side& s) { return s.cost >= kToBlame * most; });
  return out;
}

bool is_user_s(const IntervalOptions& options, EdgeId edge) {
  return options.edge_count.contains(edge) || options.edge_size.contains(edge);
}

bool is_poor(const FaceCoverage& face) {
  return std::abs(face.deviation()) > kTooMuch;
}

}  // namespace

bool is_poorly_covered(const std::vector<FaceCoverage>& coverage) {
  return std::ranges::any_of(coverage, is_poor);
}

bool raise_for_coverage(const Model& model, const std::vector<FaceCoverage>& coverage,
                        const Intervals& intervals, IntervalOptions& options) {
  bool is_raised = false;
  for (const FaceCoverage& face : coverage) {
    if (!is_poor(face)) continue;
    const double missed = std::abs(face.deviation());
    const double factor = std::min(2.0, std::sqrt(missed / kGoal));
    for (const Side& side : to_blame(sides_of(model, face, intervals), missed * face.area)) {
      if (is_user_s(options, side.edge)) continue;
      const int now = intervals.edge[side.edge.index];
      int& least = options.least_count[side.edge];
      least = std::max({least, now + 1, static_cast<int>(std::lround(factor * now))});
      is_raised = true;
    }
  }
  return is_raised;
}

}  // namespace sweepmesh
