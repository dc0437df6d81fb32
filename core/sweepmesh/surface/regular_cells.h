// Smoothing of plane meshes: the foldover-free energy (foldover_free_2d.h) towards regular cells of
// the local boundary's edge length, so what is valid stays so.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// The length that each cell's sides should have: as long as the boundary's near by, and together
/// as large as the domain. Polygons of more than four sides are as large as the hexagon that is the
/// boundary's edge wide.
std::vector<double> wished_lengths(const PlanarMesh& mesh, const Metric& metric);

/// The same connectivity with inside nodes moved towards cells that are regular and of the local
/// boundary's size. What is valid stays valid.
PlanarMesh smoothed(const PlanarMesh& mesh, const Metric& metric, const Context& context);

}  // namespace sweepmesh
