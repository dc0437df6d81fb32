#include "sweepmesh/imprint/imprint_caps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sweepmesh/base/listed.h"
#include "sweepmesh/imprint/overlay.h"
#include "sweepmesh/imprint/patches.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/slab_reference.h"
#include "sweepmesh/imprint/sweep_levels.h"
#include "sweepmesh/imprint/vector_area.h"
#include "sweepmesh/imprint/walls.h"

namespace sweepmesh {
namespace {

constexpr double coincidence_of_size = 1e-3;  ///< what CAD models leave apart is far below this

/// In element sizes. Well below the shortest curve, too: both of its ends must not become one.
double coincidence(const Model& model, const Walls& walls, double size) {
  constexpr double safety = 3.0, share_of_edge = 0.1;
  double out = coincidence_of_size;
  for (const EdgeId e : walls.edges) out = std::min(out, share_of_edge * model.length(e) / size);
  return std::max(safety * model.tolerances().point / size, out);
}

double upright_area(const Model& model, const Walls& walls, const Reference& seen) {
  double area = 0.0;
  for (const FaceId f : model.faces())
    if (!walls.bottoms[f.index].empty() && is_upright(walls, seen, f)) area += model.area(f);
  return area;
}

int level_of(const Model& model, const Walls& walls, FaceId cap) {
  return walls.vertex_level[model.loops(cap).front().front().start.index];
}

/// Whether the caps at the sweep's beginning and its end look in different directions.
bool has_turned(const Model& model, const Scheme& scheme, const Walls& walls) {
  constexpr double most_cosine = 0.866;  // 30 degrees
  const int last = std::ranges::max(walls.vertex_level);
  Point3 begin = Point3::Zero(), end = Point3::Zero();
  for (const FaceId f : scheme.faces_with(FaceRole::target))
    if (level_of(model, walls, f) == 0) begin -= vector_area(model, f);
  for (const FaceId f : scheme.faces_with(FaceRole::source))
    if (level_of(model, walls, f) == last) end += vector_area(model, f);
  return begin.dot(end) < most_cosine * begin.norm() * end.norm();
}

/// The solid as it is seen in one way, and how much of its linking faces stands upright then.
struct View {
  Walls walls;
  Point3 direction;
  Reference seen;
  double upright = 0.0;     ///< area
  bool is_upright = false;  ///< all of it
};

/// Along the directions that all columns have in common, or along the path on which they turn: the
/// first in which all linking faces stand upright; else the path where the caps turn with it, or
/// the direction in which most of them do.
std::optional<View> best_view(const Model& model, const Scheme& scheme, double size,
                              const Context& context) {
  const std::vector<int> level = sweep_levels(model, scheme);
  const Walls walls = find_walls(model, scheme, level);
  const double tolerance = coincidence(model, walls, size);
  std::optional<View> best;
  const auto offer = [&](View view) {
    view.upright = upright_area(model, view.walls, view.seen);
    view.is_upright = is_upright(view.walls, view.seen);
    if (best && view.upright <= best->upright * (1.0 + model.tolerances().relative)) return false;
    best = std::move(view);
    return best->is_upright;
  };
  for (const Point3& d : common_directions(model, scheme, level))
    if (offer({walls, d, projected_reference(model, walls, d, size, tolerance, context)}))
      return best;
  if (const auto path = sweep_path(model, scheme)) {
    const Walls along = find_walls(model, scheme, sweep_levels(model, scheme, &*path));
    if (has_turned(model, scheme, along)) best.reset();
    offer({along, Point3::UnitZ(),
           straightened_reference(model, along, *path, size, tolerance, context)});
  }
  return best;
}

/// Slabs whose sections turn on edge are carried to anywhere; nothing can be read there.
void refuse_runaways(const Model& model, const Reference& reference) {
  constexpr double farthest = 100.0;  // in sizes of the model
  const double limit = farthest * model.tolerances().model_size / reference.unit;
  for (const ReferenceCurve& curve : reference.curves)
    for (const Point2& p : curve.points)
      if (!(p.norm() < limit))
        throw ImprintError(ImprintFailure::unreachable,
                           name_of(curve.edge) + " cannot be carried to the other levels.",
                           {name_of(curve.edge)});
}

/// An edge of a cap that runs along the columns has no length in R, so no cell could end at it.
void refuse_edges_on_end(const Reference& reference) {
  std::vector<std::string> names;
  for (const ReferenceCurve& curve : reference.curves)
    if (length(curve.points) <= reference.lattice) names.push_back(name_of(curve.edge));
  if (names.empty()) return;
  throw ImprintError(
      ImprintFailure::unreachable,
      names.size() == 1 ? listed(names) + ", an edge of a cap, runs along the columns of the sweep."
                        : listed(names) + ", edges of caps, run along the columns of the sweep.",
      names);
}

}  // namespace

ImprintBasis imprint_basis(const Model& model, const Scheme& scheme, double size,
                           const Context& context) {
  if (!(size > 0.0) || !std::isfinite(size))
    throw InputError("imprint", "The element size must be positive.");
  auto view = best_view(model, scheme, size, context);
  if (!view)
    throw ImprintError(ImprintFailure::unreachable,
                       "The columns of the sweep do not run along one direction.", {});
  Walls& walls = view->walls;
  Reference reference =
      view->is_upright ? std::move(view->seen)
                       : slab_reference(model, scheme, walls, view->direction, view->seen, context);
  refuse_runaways(model, reference);
  refuse_edges_on_end(reference);
  return {std::move(walls), std::move(reference)};
}

Imprint imprint_on(const ImprintBasis& basis, const Model& model, const Scheme& scheme,
                   double merge_fraction, const Context& context) {
  if (!(merge_fraction >= 0.0 && merge_fraction <= 1.0))
    throw InputError("imprint", "The merge fraction must lie between 0 and 1.");
  const auto& [walls, reference] = basis;
  // What lies apart by the limit itself, but for the lattice, is kept apart everywhere.
  const double tolerance = reference.coincidence;
  const double merge = std::max(tolerance, merge_fraction - tolerance / 2);
  Imprint out =
      imprint_of(model, scheme, walls, overlay(model, scheme, walls, reference, merge, context));
  out.unit = reference.unit;
  for (Merge& m : out.merges) m.distance *= out.unit;
  return out;
}

Imprint imprint_caps(const Model& model, const Scheme& scheme, const ImprintOptions& options,
                     const Context& context) {
  return imprint_on(imprint_basis(model, scheme, options.size, context), model, scheme,
                    options.merge_fraction, context);
}

}  // namespace sweepmesh
