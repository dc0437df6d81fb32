// Ways to place interior nodes: ours, and the older ones that it is compared with.
//
// All but `harmonic_residual` are taken as they stand in the literature: nothing is untangled or
// improved after them. Their inventors describe them for one-to-one sweeps. The affine ones go on
// to any set of runs as older_affine.h says; the cage-based ones to runs that all begin (or all
// end) at one level, whose boundary is exactly the fixed nodes; `bm_sweep` and `boundary_error`
// know one-to-one sweeps only (every column and every run has the same layers, and the boundary is
// exactly the two caps and the columns of the linking faces). Otherwise InputError.
//
// Sources, after "thesis" (Cai, sweeping, 2015):
//   layer-wise: Knupp 1998 (A.1), Roca and Sarrate 2004, 2006 (2.3 to 2.5, A.2), Staten et al. 1999
//   (BMSweep, 2.2.1), Blacker 1996 (BoundaryError, 2.2.1);
//   cage-based: Ju, Schaefer, Warren 2005 (A.3), Lipman, Levin, Cohen-Or 2008 (A.4), Sieger et al.
//   2014 (A.5), Joshi et al. 2007 (4.2.3). Their cage is the boundary on the idealised prism: the
//   low cap, translated along its normal by the heights of the layers.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

enum class PlacementMethod {
  harmonic_residual,  ///< affine motion, harmonic residual, untangling; any set of runs
  layer_affine,       ///< the affine motion alone (layer_motion.h). Ignores what a layer's loops do
                      ///< apart
  knupp_affine,  ///< from loop to next loop, from the high cap down. Misses the low cap's curvature
  least_squares_f,  ///< both caps, functional F. Flattens curved caps with planar rims
  least_squares_g,  ///< both caps, functional G. Skews them
  least_squares_h,  ///< both caps, functional H. Linear: folds where holes move against the rim
  bm_sweep,         ///< barycentric in a triangulation of the rim. Folds where its triangles do
  boundary_error,   ///< functional H and its error, weighted with 1 / distance^2. Cost rim x nodes
  mean_value,       ///< negative weights behind concave corners. Cost boundary x nodes
  green,  ///< keeps shape, so it leaves the cage where that is bent. Cost boundary x nodes
  triharmonic_rbf,  ///< dense solve; refuses more than 4000 boundary nodes. Sees through holes
  harmonic_grid  ///< harmonic coordinates on a grid of 64 cells. Blind to what is finer than a cell
};

/// In the order of the enum, as written there.
const std::vector<PlacementMethod>& all_placement_methods();
std::string name_of(PlacementMethod method);

/// Sets the free nodes by one of the older methods. Throws InputError (see above), Cancelled.
void place_by_older_method(PlacementMethod method, const Extrusion& extrusion,
                           const std::vector<char>& fixed, const BaseMetric& metric, Points& points,
                           ThreadTeam& team, const Context& context);

}  // namespace sweepmesh
