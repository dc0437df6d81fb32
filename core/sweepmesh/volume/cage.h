// The idealised prism of a set of runs and its cage, for the cage-based methods of placement.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/extrusion.h"

namespace sweepmesh {

struct Cage {
  std::vector<long> node;                     ///< of the extrusion, per cage vertex
  std::vector<Point3> ideal, actual;          ///< per cage vertex: on the prism, and where it is
  std::vector<std::array<int, 3>> triangles;  ///< of cage vertices, outward on the prism
  std::vector<long> inner;                    ///< nodes that are to be placed
  std::vector<Point3> inner_ideal;            ///< where they are on the prism
};

/// The prism is the base at the level where all runs begin (or else end), translated along its
/// normal by the heights of the layers. Throws InputError where runs have no such level, or where
/// fixed nodes are not exactly those of the boundary.
Cage make_cage(const Extrusion& extrusion, const std::vector<char>& fixed, const BaseMetric& metric,
               const Points& points);

/// Positions of the inner nodes, in their order. Cost: triangles (or vertices) times inner nodes.
std::vector<Point3> mean_value_positions(const Cage& cage, ThreadTeam& team,
                                         const Context& context);
std::vector<Point3> green_positions(const Cage& cage, ThreadTeam& team, const Context& context);
/// Throws InputError for more than 4000 cage vertices (a dense matrix of their square).
std::vector<Point3> rbf_positions(const Cage& cage, ThreadTeam& team, const Context& context);
/// Grid of `n_cells` along the longest side of the prism, relaxed until values change by less than
/// 1e-6 of the cage's size in a sweep.
std::vector<Point3> harmonic_grid_positions(const Cage& cage, int n_cells, const Context& context);

}  // namespace sweepmesh
