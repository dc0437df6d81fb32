#include "sweepmesh/surface/planar_pair.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/surface/cap_map.h"
#include "sweepmesh/surface/quad_cleanup.h"
#include "sweepmesh/surface/regular_cells.h"
#include "sweepmesh/surface/widened.h"
#include "sweepmesh/surface/worst_first.h"

namespace sweepmesh {
namespace {

/// A pair whose worse end is this good, in scaled Jacobians and in lengths, is taken without
/// looking at the shape between.
constexpr double good_enough = 0.55, even_enough = 0.8;
/// One that is worse is a reason to spend more cells.
constexpr double poor = 0.2;
/// Cells below this are raised at the cost of others.
constexpr double worth_raising = 0.7;
constexpr std::size_t n_finalists = 2;
constexpr int rounds_to_compare = 2, rounds_to_finish = 6;
/// Gain in quality (least and half the mean) for which one end is smoothed apart from the other.
constexpr double worth_drifting = 0.1;

using Complex = std::complex<double>;

/// p -> to + factor (p - from): rotation, scaling and move in complex form.
struct Similarity {
  Complex from, to, factor;
  Complex operator()(Complex p) const { return to + factor * (p - from); }
};

Complex as_complex(const Point2& p) {
  return {p.x(), p.y()};
}
Point2 as_point(Complex c) {
  return {c.real(), c.imag()};
}

/// Least squares over the nodes of a loop.
Similarity best_similarity(const std::vector<Point2>& a, const std::vector<Point2>& b) {
  Similarity s{};
  const double n = static_cast<double>(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    s.from += as_complex(a[i]) / n;
    s.to += as_complex(b[i]) / n;
  }
  Complex product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Complex p = as_complex(a[i]) - s.from;
    product += std::conj(p) * (as_complex(b[i]) - s.to);
    square += std::norm(p);
  }
  s.factor = square > 0.0 ? product / square : 1.0;
  return s;
}

std::vector<Point2> half_way_loop(const std::vector<Point2>& a, const std::vector<Point2>& b) {
  const Similarity whole = best_similarity(a, b);
  const Complex half = std::sqrt(whole.factor),
                turn_back = std::polar(1.0, -0.5 * std::arg(whole.factor));
  std::vector<Point2> out;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Complex left_over = as_complex(b[i]) - whole(as_complex(a[i]));
    out.push_back(as_point(0.5 * (whole.from + whole.to) + half * (as_complex(a[i]) - whole.from) +
                           0.5 * turn_back * left_over));
  }
  return out;
}

/// The affine map that takes every node of the first boundary to the second's, if there is one.
std::optional<Affine> exact_affine(const std::vector<Point2>& a, const std::vector<Point2>& b) {
  constexpr double rounding = 1e-10;  // of the domain's size
  const Affine map = best_affine(a, b);
  double size = 0.0, off = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    size = std::max(size, (b[i] - b[0]).norm());
    off = std::max(off, (map.leftCols<2>() * a[i] + map.col(2) - b[i]).norm());
  }
  if (off > rounding * size) return std::nullopt;
  return map;
}

/// A right prism and its like: the second end is the first one's image, and only one has to be
/// meshed.
PlanarPair image_pair(const PlanarLoops& first, const std::vector<Point2>& second,
                      const Affine& map, const PlanarMeshOptions& options, const Context& context) {
  PlanarPair pair;
  pair.first = mesh_planar(first, options, context);
  for (const Point2& p : pair.first.points)
    pair.second.push_back(map.leftCols<2>() * p + map.col(2));
  std::copy(second.begin(), second.end(), pair.second.begin());
  pair.first_quality = quality(pair.first.points, pair.first);
  pair.second_quality = quality(pair.second, pair.first);
  return pair;
}

class PairMesher {
 public:
  PairMesher(const PlanarLoops& first, const PlanarLoops& second, const PlanarMeshOptions& options,
             const Metric& second_metric, const Context& context)
      : first_(first), second_(flattened(second)), options_(options), context_(context) {
    onto_first_.squeezed = onto_second_.squeezed = 0.0;  // the best one is widened in the end
    onto_first_.target_metric = options.metric;
    onto_second_.source_metric = options.metric;
    onto_second_.target_metric = second_metric;
    angles_.push_back(interior_angles(first));
    angles_.push_back(interior_angles(second));
  }

  PlanarPair run(const PlanarLoops& second) {
    const auto direct = candidate_meshes(first_, options_, angles_, context_);
    for (const PlanarMesh& mesh : direct) offer([&] { return carried_on(mesh); });
    if (is_best_at_least(good_enough) && evenness_of(best_.front().pair) >= even_enough)
      return finished(std::move(best_.front().pair));
    const PlanarLoops between = half_way(first_, second);
    if (is_domain(between)) {
      PlanarMeshOptions flat = options_;
      flat.metric = {};
      for (const PlanarMesh& mesh : candidate_meshes(between, flat, angles_, context_))
        offer([&] { return carried_both_ways(mesh); });
    }
    // A hole that is tied to another loop by single cells cannot move: give it a ring of its own.
    // Of quads, so there is none for triangles.
    if (options_.kind != CellKind::triangle)
      for (const PlanarMesh& mesh : direct)
        if (!is_best_at_least(poor)) offer([&] { return carried_on(ringed(mesh)); });
    if (best_.empty()) throw *failure_;
    return best_finished();
  }

 private:
  static double worse_end(const PlanarPair& p) {
    return std::min(p.first_quality.min, p.second_quality.min);
  }
  double score(const PlanarPair& p) const {
    return worse_end(p) + 0.25 * (p.first_quality.mean + p.second_quality.mean) + evenness_of(p);
  }

  /// Of the worse end.
  double evenness_of(const PlanarPair& p) const {
    const auto at = [&](const std::vector<Point2>& points, const Metric& metric) {
      PlanarMesh there = p.first;
      there.points = points;
      return evenness(there, points, lengths_of_regular(there, metric), metric);
    };
    return std::min(at(p.first.points, options_.metric), at(p.second, onto_second_.target_metric));
  }

  template <class Make>
  void offer(const Make& make) {
    try {
      PlanarPair pair = make();
      const double its_score = score(pair);
      best_.insert(std::ranges::find_if(best_, [&](const Rated& r) { return r.score < its_score; }),
                   {its_score, std::move(pair)});
      if (best_.size() > n_finalists) best_.pop_back();
    } catch (const InvalidMeshError& e) {
      if (!failure_) failure_ = e;
    }
  }

  bool is_best_at_least(double value) const {
    return !best_.empty() && worse_end(best_.front().pair) >= value;
  }

  PlanarMesh ringed(const PlanarMesh& mesh) const {
    const PlanarMesh more = smoothed(with_rings(mesh, first_, angles_), options_.metric, context_);
    if (options_.kind != CellKind::quad) return more;
    return smoothed(with_regular_valences(more, angles_), options_.metric, context_);
  }

  PlanarPair carried_on(PlanarMesh mesh) const {
    PlanarPair pair;
    pair.first_quality = raise(mesh, mesh.points, rounds_to_compare, options_.metric);
    pair.second = map_planar(mesh, second_, onto_second_, context_).points;
    pair.first = std::move(mesh);
    pair.second_quality = settle(pair.first, pair.second, onto_second_.target_metric);
    return pair;
  }

  PlanarPair carried_both_ways(const PlanarMesh& between) const {
    PlanarPair pair;
    pair.first = between;
    pair.first.points = map_planar(between, flattened(first_), onto_first_, context_).points;
    MapOptions onto_second = onto_second_;
    onto_second.source_metric = {};
    pair.second = map_planar(between, second_, onto_second, context_).points;
    std::vector<Point2> points = pair.first.points;
    pair.first_quality = settle(pair.first, points, options_.metric);
    pair.first.points = std::move(points);
    pair.second_quality = settle(pair.first, pair.second, onto_second_.target_metric);
    return pair;
  }

  /// Smooths one end towards regular cells where that is much better, and raises the worst cells.
  /// What is smoothed alone drifts away from what lies over it, so it must be worth that.
  PlanarQuality settle(const PlanarMesh& cells, std::vector<Point2>& points,
                       const Metric& metric) const {
    const PlanarQuality before = quality(points, cells, metric);
    PlanarMesh there = cells;
    there.points = points;
    there = smoothed(there, metric, context_);
    const PlanarQuality after = quality(there.points, there, metric);
    if (after.min + 0.5 * after.mean > before.min + 0.5 * before.mean + worth_drifting)
      points = std::move(there.points);
    return raise(cells, points, rounds_to_compare, metric);
  }

  PlanarQuality raise(const PlanarMesh& cells, std::vector<Point2>& points, int rounds,
                      const Metric& metric) const {
    points = with_worst_raised(cells, points, worth_raising, rounds, metric, context_);
    return quality(points, cells, metric);
  }

  PlanarQuality finish(PlanarMesh mesh, std::vector<Point2>& points, const Metric& metric) const {
    raise(mesh, points, rounds_to_finish, metric);
    mesh.points = points;
    points = widened(mesh, points, lengths_of_regular(mesh, metric), {}, metric, context_);
    return quality(points, mesh, metric);
  }

  PlanarPair finished(PlanarPair pair) const {
    std::vector<Point2> points = pair.first.points;
    pair.first_quality = finish(pair.first, points, options_.metric);
    pair.first.points = std::move(points);
    pair.second_quality = finish(pair.first, pair.second, onto_second_.target_metric);
    return pair;
  }

  /// What raises the worst cells changes the order of those that are nearly as good as each other.
  PlanarPair best_finished() {
    for (Rated& r : best_) {
      r.pair = finished(std::move(r.pair));
      r.score = score(r.pair);
    }
    return std::move(std::ranges::max_element(best_, {}, &Rated::score)->pair);
  }

  struct Rated {
    double score;
    PlanarPair pair;
  };

  const PlanarLoops& first_;
  std::vector<Point2> second_;
  const PlanarMeshOptions& options_;
  const Context& context_;
  MapOptions onto_first_, onto_second_;
  BoundaryAngles angles_;
  std::vector<Rated> best_;  ///< the best first
  std::optional<InvalidMeshError> failure_;
};

}  // namespace

PlanarLoops half_way(const PlanarLoops& first, const PlanarLoops& second) {
  // The second shape in the place of the first: as the outer loop has moved.
  const Similarity back = best_similarity(second[0], first[0]);
  PlanarLoops out;
  for (std::size_t l = 0; l < first.size(); ++l) {
    std::vector<Point2> placed;
    for (const Point2& p : second[l]) placed.push_back(as_point(back(as_complex(p))));
    out.push_back(half_way_loop(first[l], placed));
  }
  return out;
}

PlanarPair mesh_planar_pair(const PlanarLoops& first, const PlanarLoops& second,
                            const PlanarMeshOptions& options, const Metric& second_metric,
                            const Context& context) {
  const auto count = [](const std::vector<Point2>& loop) { return loop.size(); };
  if (!std::equal(first.begin(), first.end(), second.begin(), second.end(),
                  [&](const auto& a, const auto& b) { return count(a) == count(b); }))
    throw InputError("surface", "Source and target cap have different numbers of boundary nodes.");
  const std::vector<Point2> there = flattened(second);
  const auto affine = exact_affine(flattened(first), there);
  if (affine && !options.metric && !second_metric) {
    PlanarPair pair = image_pair(first, there, *affine, options, context);
    if (pair.second_quality.min >= good_enough * pair.first_quality.min) return pair;
  }
  return PairMesher(first, second, options, second_metric, context).run(second);
}

}  // namespace sweepmesh
