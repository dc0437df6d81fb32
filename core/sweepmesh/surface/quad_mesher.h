// Meshes of plane domains whose boundary edges are given: of quads, triangles or polygons.
//
// Candidates are made, smoothed and measured, and the best one is taken: structured patterns where
// the counts admit one (quad_templates.h), and unstructured ones by Gmsh (frontal triangles paired
// by Blossom), with leftover triangles paired and irregular nodes removed (quad_cleanup.h). Should
// no pairing work, the domain is meshed at twice the size and every cell is cut into quads. Where
// all of that leaves no valid mesh, a Delaunay triangulation is paired (delaunay_quads.h).
// Smoothing is that of regular_cells.h.
#pragma once

#include "sweepmesh/base/context.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

/// Polygons are convex, most of them hexagons, with quads along straight boundaries
/// (polygon_dual.h).
enum class CellKind { quad, triangle, polygon };

struct PlanarMeshOptions {
  /// Wished length of inside edges, > 0; of polygons the width. Near the boundary the boundary's
  /// own edge lengths count.
  double size = 1.0;
  CellKind kind = CellKind::quad;
  /// Lengths and angles on the surface that the plane stands for; they decide smoothing and choice.
  Metric metric;
};

/// Interior angles of the boundary at its nodes, in radians, one row for each shape that the
/// boundary is to take.
using BoundaryAngles = std::vector<std::vector<double>>;
std::vector<double> interior_angles(const PlanarLoops& loops);

/// Whether the loops are simple, apart from one another, and bound one domain on their left.
bool is_domain(const PlanarLoops& loops);

/// A mesh of the domain left of the loops: their points are its first nodes, their segments its
/// boundary edges, none is added. Every cell has a positive scaled Jacobian. Throws InputError (a
/// loop of fewer than three points, crossing or misoriented loops, size not positive, an odd number
/// of boundary edges for quads), SolverError (Gmsh fails) and InvalidMeshError (no valid mesh
/// found). The same input gives the same mesh. Cost: some
/// 20 ms plus 0.1 ms a cell; the first mesh of a context's thread 0.1 s more (worker.h).
PlanarMesh mesh_planar(const PlanarLoops& loops, const PlanarMeshOptions& options,
                       const Context& context);

/// The meshes that mesh_planar chooses from, smoothed, some perhaps with inverted cells; at least
/// one. The number of cells at a boundary node suits all rows of `angles`. Errors as mesh_planar.
std::vector<PlanarMesh> candidate_meshes(const PlanarLoops& loops, const PlanarMeshOptions& options,
                                         const BoundaryAngles& angles, const Context& context);

/// How good a mesh is as a whole, by which candidates are compared: the worst cell counts most.
double overall_quality(const PlanarMesh& mesh, const Metric& metric = {});

}  // namespace sweepmesh
