// The mesh of a cap: made on the source, carried to the target.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/cap_boundary.h"
#include "sweepmesh/surface/face_mesh.h"
#include "sweepmesh/surface/planar_mesh.h"
#include "sweepmesh/surface/quad_mesher.h"
#include "sweepmesh/surface/surface_mesh.h"

namespace sweepmesh {

/// Nodes and cells of one cap. Nodes 0 .. plane.n_boundary - 1 are those of the boundary, which
/// exist in the surface mesh already; the others are new and lie exactly on the face.
struct CapMesh {
  FaceId face;
  PlanarMesh plane;              ///< in the cap's chart; cells counterclockwise there
  std::vector<NodeId> boundary;  ///< of the boundary nodes: their ids in the surface mesh
  std::vector<int> loop_sizes;   ///< boundary nodes per loop; loop 0 is the outer one in the chart
  std::vector<Point2> uv;        ///< of all nodes
  std::vector<Point3> points;    ///< of all nodes
  /// The chart is looked at from inside the solid (a target): its cells are clockwise seen from
  /// outside.
  bool is_mirrored = false;
  Metric metric;  ///< lengths on the face; empty for a planar one
};

/// Scaled Jacobians of the cells in space, each corner measured in the plane of its two edges and
/// signed by the face's outward normal.
PlanarQuality quality_in_space(const Model& model, const CapMesh& cap);

/// Meshes a face, or a patch of it, within the given boundary. Seen from outside the cells are
/// counterclockwise. Errors are those of Chart and mesh_planar, naming the face.
CapMesh mesh_cap(const Model& model, FaceId face, const CapLoops& boundary, double size,
                 CellKind kind, const Context& context);

/// The cap whose mesh is given, as another solid has it on the same face: its nodes on the boundary
/// are those of `boundary`, within `tolerance`. Throws InvalidMeshError naming the face where they
/// are not.
CapMesh cap_with_mesh(const Model& model, FaceId face, const CapLoops& boundary,
                      const FaceMesh& mesh, double size, double tolerance, const Context& context);

/// Which way a face looks, compared with the mesh that is carried to it: a target against its
/// source, a source against a base mesh seen from above.
enum class Facing { opposite, same };

/// Carries a cap's mesh to another face: `boundary[i]` is the target's node for the source's
/// boundary node i (CapMesh::boundary). The plane mesh of the result has the same cells, node for
/// node. `source` may lie on no face (an invalid FaceId): then it is the plane mesh alone. Throws
/// InvalidMeshError naming both faces when no valid image is found.
CapMesh map_cap(const Model& model, const CapMesh& source, FaceId target,
                const std::vector<CapNode>& boundary, double size, const Context& context,
                Facing facing = Facing::opposite);

/// Source and target meshed together, so that distortion is shared (planar_pair.h): better than
/// mesh_cap and map_cap wherever the two differ in shape. `partner` gives the target's node of each
/// of the source's boundary nodes, shaped like `boundary`. Errors as mesh_cap and map_cap.
struct CapPair {
  CapMesh source, target;
};
CapPair mesh_cap_pair(const Model& model, FaceId source, const CapLoops& boundary, FaceId target,
                      const CapLoops& partner, double size, CellKind kind, const Context& context);

/// Adds a cap's inside nodes and its cells to a surface mesh, counterclockwise seen from outside.
/// Gives the ids of all its nodes, in the cap's order.
std::vector<NodeId> add_cap(const CapMesh& cap, SurfaceMesh& mesh);

}  // namespace sweepmesh
