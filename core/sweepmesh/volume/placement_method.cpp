#include "sweepmesh/volume/placement_method.h"

#include "sweepmesh/volume/cage.h"
#include "sweepmesh/volume/layer_motion.h"
#include "sweepmesh/volume/older_affine.h"
#include "sweepmesh/volume/one_to_one.h"
#include "sweepmesh/volume/residual.h"

namespace sweepmesh {
namespace {

constexpr int grid_cells = 64;

std::vector<Point3> cage_positions(PlacementMethod method, const Cage& cage, ThreadTeam& team,
                                   const Context& context) {
  switch (method) {
    case PlacementMethod::mean_value:
      return mean_value_positions(cage, team, context);
    case PlacementMethod::green:
      return green_positions(cage, team, context);
    case PlacementMethod::triharmonic_rbf:
      return rbf_positions(cage, team, context);
    default:
      return harmonic_grid_positions(cage, grid_cells, context);
  }
}

}  // namespace

const std::vector<PlacementMethod>& all_placement_methods() {
  using enum PlacementMethod;
  static const std::vector<PlacementMethod> all = {
      harmonic_residual, layer_affine,    knupp_affine,    least_squares_f,
      least_squares_g,   least_squares_h, bm_sweep,        boundary_error,
      mean_value,        green,           triharmonic_rbf, harmonic_grid};
  return all;
}

std::string name_of(PlacementMethod method) {
  switch (method) {
    case PlacementMethod::harmonic_residual:
      return "harmonic_residual";
    case PlacementMethod::layer_affine:
      return "layer_affine";
    case PlacementMethod::knupp_affine:
      return "knupp_affine";
    case PlacementMethod::least_squares_f:
      return "least_squares_f";
    case PlacementMethod::least_squares_g:
      return "least_squares_g";
    case PlacementMethod::least_squares_h:
      return "least_squares_h";
    case PlacementMethod::bm_sweep:
      return "bm_sweep";
    case PlacementMethod::boundary_error:
      return "boundary_error";
    case PlacementMethod::mean_value:
      return "mean_value";
    case PlacementMethod::green:
      return "green";
    case PlacementMethod::triharmonic_rbf:
      return "triharmonic_rbf";
    case PlacementMethod::harmonic_grid:
      return "harmonic_grid";
  }
  return {};
}

void place_by_older_method(PlacementMethod method, const Extrusion& extrusion,
                           const std::vector<char>& fixed, const BaseMetric& metric, Points& points,
                           ThreadTeam& team, const Context& context) {
  using enum PlacementMethod;
  switch (method) {
    case harmonic_residual:
    case layer_affine:
      set_predictions(extrusion, make_layer_motion(extrusion, fixed, points, metric, team), fixed,
                      points, team);
      return;
    case knupp_affine:
      return place_knupp(extrusion, fixed, points, team);
    case least_squares_f:
      return place_least_squares(extrusion, fixed, metric, Functional::f, points, team);
    case least_squares_g:
      return place_least_squares(extrusion, fixed, metric, Functional::g, points, team);
    case least_squares_h:
      return place_least_squares(extrusion, fixed, metric, Functional::h, points, team);
    case bm_sweep:
      return place_bm_sweep(make_one_to_one(extrusion, fixed, metric), points);
    case boundary_error:
      return place_boundary_error(make_one_to_one(extrusion, fixed, metric), points, team, context);
    case mean_value:
    case green:
    case triharmonic_rbf:
    case harmonic_grid:
      break;
  }
  const Cage cage = make_cage(extrusion, fixed, metric, points);
  const std::vector<Point3> placed = cage_positions(method, cage, team, context);
  for (std::size_t i = 0; i < placed.size(); ++i) points.row(cage.inner[i]) = placed[i];
}

}  // namespace sweepmesh
