// Raises the worst cells of a valid mesh at the cost of good ones.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// Moves inside nodes so that the least scaled Jacobian grows: a few rounds of the foldover-free
/// energy towards rectangles with each quad's present edge lengths (regular polygons of the present
/// area for other cells), in which a cell weighs the more the smaller its scaled Jacobian is (so
/// the sum tends to the maximum's norm). The best round is kept, of those that shrink no edge to
/// next to nothing; nothing changes where none is better, or where no cell is below `limit`. Only
/// cells within some rings of those below it move. The mesh must be valid. Cost: a sparse
/// factorisation of the neighbourhoods a step, some 8 steps a round; two rounds tell what is
/// possible, six get it.
std::vector<Point2> with_worst_raised(const PlanarMesh& mesh, const std::vector<Point2>& points,
                                      double limit, int max_rounds, const Metric& metric,
                                      const Context& context);

}  // namespace sweepmesh
