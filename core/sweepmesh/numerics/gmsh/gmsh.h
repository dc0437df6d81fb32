// Gmsh as a mesher of plane domains, in processes of its own (worker.h).
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"

namespace sweepmesh {

/// Gmsh's numbers (Mesh.Algorithm). Version 4.8.4 crashes in 8 (frontal for quads).
enum class GmshAlgorithm { delaunay = 5, frontal = 6, parallelograms = 9 };

struct GmshOptions {
  GmshAlgorithm algorithm = GmshAlgorithm::frontal;
  bool recombine =
      true;  ///< pairs triangles to quads by a perfect matching where one is found (Blossom)
  double size_factor =
      1.0;  ///< interior edge lengths are those of the boundary, carried inside, times this
  double size_max = 0.0;  ///< longest interior edge; 0: no limit
};

/// Cells counterclockwise; `nodes[3]` is -1 for a triangle. The loops' points come first, in their
/// order.
struct GmshMesh {
  std::vector<Point2> points;
  std::vector<std::array<int, 4>> cells;
};

/// Meshes the domain left of the loops (outer counterclockwise, holes clockwise); each loop segment
/// stays one mesh edge. Throws SolverError when Gmsh's worker is missing, crashes or leaves no
/// mesh. Deterministic, and the same for a domain that is moved or scaled. Cost: 5 ms, and a second
/// for about 20 thousand cells; 90 ms for the first one of a context's thread.
GmshMesh mesh_by_gmsh(const std::vector<std::vector<Point2>>& loops, const GmshOptions& options,
                      const Context& context);

}  // namespace sweepmesh
