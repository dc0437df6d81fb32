#include "sweepmesh/intervals/areas.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/base/lattice.h"

namespace sweepmesh {
namespace {

constexpr int kFine = 48;                     ///< chords that stand for the curve itself
constexpr double kMostTimes = 6.0;            ///< a sliver of a face must not rule the whole mesh
constexpr double kLattice = 1.0 / (1 << 20);  ///< of wishes, far above rounding errors
constexpr double kNearEnough = 1.2;  ///< what is chosen may miss by so much more than is wished

/// Twice the area between a coedge's chord and the polygon of `n` chords of equal parameter along
/// it, positive where the face bulges outwards.
double bulge(const Model& model, const Coedge& c, int n, const Point3& normal) {
  const auto [first, last] = model.range(c.edge);
  const Point3 origin = model.point(c.edge, first);
  Point3 before = Point3::Zero(), sum = Point3::Zero();
  for (int i = 1; i <= n; ++i) {
    const Point3 now = model.point(c.edge, first + (last - first) * i / n) - origin;
    sum += before.cross(now);
    before = now;
  }
  return (c.reversed ? -1.0 : 1.0) * sum.dot(normal);
}

struct Loss {
  const Coedge* coedge;
  double twice_area;  ///< that the chords leave out; negative where they add
};

template <class Count>
std::vector<Loss> losses(const Model& model, FaceId face, const Count& count) {
  const auto [low, high] = model.uv_bounds(face);
  const Point3 normal = model.normal(face, (low + high) / 2);
  const double negligible = model.tolerances().relative * model.area(face);
  std::vector<Loss> out;
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop) {
      if (!c.edge.is_valid() || count(c.edge) >= kFine) continue;
      const double lost =
          bulge(model, c, kFine, normal) - bulge(model, c, std::max(1, count(c.edge)), normal);
      if (std::abs(lost) > negligible) out.push_back({&c, lost});
    }
  return out;
}

/// By which part of its area a face is missed; above 0 where it lacks area.
double error_of(const Model& model, FaceId face, const std::vector<Loss>& all) {
  double twice = 0.0;
  for (const Loss& loss : all) twice += loss.twice_area;
  return twice / (2.0 * model.area(face));
}

}  // namespace

std::vector<double> area_counts(const Model& model, const IntervalOptions& options,
                                const std::vector<double>& wishes) {
  std::vector<double> out(model.n_edges(), 0.0);
  const auto count = [&](EdgeId e) {
    const double wish = on_lattice(std::min<double>(wishes[e.index], kFine), kLattice);
    return static_cast<int>(std::lround(wish));
  };
  for (const FaceId face : model.faces()) {
    if (!model.is_planar(face)) continue;
    const auto all = losses(model, face, count);
    const double error = std::abs(error_of(model, face, all));
    if (error <= options.max_area_error) continue;
    // chords miss an area by the square of their length
    const double factor = std::min(kMostTimes, std::sqrt(error / options.max_area_error));
    for (const Loss& loss : all) {
      const EdgeId e = loss.coedge->edge;
      out[e.index] = std::max(out[e.index], factor * std::max(1, count(e)));
    }
  }
  return out;
}

int raise_for_areas(const Model& model, const IntervalOptions& options,
                    const std::vector<int>& counts, IntervalDemands& demands) {
  int n_raised = 0;
  for (const FaceId face : model.faces()) {
    if (!model.is_planar(face)) continue;
    const auto all = losses(model, face, [&](EdgeId e) { return counts[e.index]; });
    const double error = error_of(model, face, all);
    if (std::abs(error) <= kNearEnough * options.max_area_error) continue;
    for (const Loss& loss : all) {
      const EdgeId e = loss.coedge->edge;
      auto& least = demands.problem.unknowns[demands.edge[e.index]].lower;
      if (loss.twice_area * error < 0.0 || options.edge_count.contains(e)) continue;
      if (least > counts[e.index]) continue;
      least = counts[e.index] + 1;
      ++n_raised;
    }
  }
  return n_raised;
}

}  // namespace sweepmesh
