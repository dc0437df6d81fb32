// Where the layers cross axial edges and linking faces that pass other caps on their way.
//
// Evenly spaced, layer 3 would cross the edge on the left wherever a third of its length is, and
// the cells between it and the cap's edge, however narrow, would lean by the difference. So a layer
// crosses near the height of what the solid has at that layer nearby.
//
//        |  o-----  cap at k = 3
//        |  |
//      3 +..o
//        |  |  void
//      2 +  |
#pragma once

#include <vector>

#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

/// Moves the inner nodes of all axial edges without a bias along them: springs keep the steps
/// alike, and each layer k is drawn to the place nearest to a transverse edge of layer k, with a
/// force that grows as (0.45 size / distance)^2. No step becomes shorter than a quarter of the mean
/// one. Cost: pairs of axial and transverse edges.
void space_by_levels(const Model& model, const Scheme& scheme, const Intervals& intervals,
                     const IntervalOptions& options, EdgeNodes& nodes);

/// The same for the nodes inside linking faces, column by column, along the lines that they form;
/// they stay on their faces. A face whose worst quad would become worse, and poor, is left as it
/// is. Cost: nodes of linking faces times nodes of transverse edges of their layer.
void space_by_levels(const Model& model, const Scheme& scheme, double size, SurfaceMesh& mesh);

}  // namespace sweepmesh
