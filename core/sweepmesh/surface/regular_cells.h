// Smoothing of plane meshes: the foldover-free energy (foldover_free_2d.h) towards regular cells of
// the local boundary's edge length, so what is valid stays so.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// The same connectivity with inside nodes moved towards cells that are regular and of the local
/// boundary's size. What is valid stays valid.
PlanarMesh smoothed(const PlanarMesh& mesh, const Metric& metric, const Context& context);

}  // namespace sweepmesh
