#include "sweepmesh/pipeline/given_boundary.h"

#include "sweepmesh/base/errors.h"
#include "sweepmesh/base/point_finder.h"

namespace sweepmesh {
namespace {

/// The nodes of `mesh` at `points`, where `is_known`; -1 elsewhere, and where there is none.
std::vector<int> nodes_at(const std::vector<Point3>& points, const std::vector<char>& is_known,
                          const FaceMesh& mesh, double tolerance) {
  const PointFinder finder(mesh.points, tolerance);
  std::vector<int> out(points.size(), -1);
  for (std::size_t n = 0; n < points.size(); ++n)
    if (is_known[n]) out[n] = finder.at(points[n]);
  return out;
}

void take_linking_face(FaceId face, const FaceMesh& given, double tolerance, SurfaceMesh& mesh) {
  std::vector<NodeId> nodes;
  const FaceMesh own = mesh_of_face(mesh, face, &nodes);
  std::vector<char> is_known;
  for (const NodeId n : nodes) is_known.push_back(mesh.owner[n.index].kind != EntityKind::face);
  const auto image = matched(own, given, nodes_at(own.points, is_known, given, tolerance));
  if (!image)
    throw InvalidMeshError(
        "surface", "The two solids at " + name_of(face) + " have different structured grids there.",
        {name_of(face)}, {});
  for (std::size_t n = 0; n < nodes.size(); ++n)
    mesh.points[nodes[n].index] = given.points[(*image)[n]];
}

FaceMesh in_space(const PlanarMesh& plane, const std::vector<Point3>& points) {
  return {points, plane.cell_offset, plane.cell_nodes};
}

}  // namespace

void take_edges(const GivenBoundary& given, EdgeNodes& nodes) {
  for (std::size_t e = 0; e < given.edge_t.size(); ++e)
    if (!given.edge_t[e].empty()) nodes.t[e] = given.edge_t[e];
}

void take_linking_faces(const Scheme& scheme, const GivenBoundary& given, SurfaceMesh& mesh) {
  for (const auto& [face, cells] : given.faces)
    if (scheme.face_role[face.index] == FaceRole::linking)
      take_linking_face(face, cells, given.tolerance, mesh);
}

CapMesh same_mesh_on(const Model& model, const CapMesh& cap, FaceId face,
                     const std::vector<CapNode>& boundary, const FaceMesh& mesh, double tolerance) {
  CapMesh out = cap;
  out.face = face;
  out.is_mirrored = !cap.is_mirrored;
  out.metric = {};
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    out.boundary[i] = boundary[i].node;
    out.uv[i] = boundary[i].uv;
    out.points[i] = boundary[i].point;
  }
  // Seen from outside the other end the cells run the other way.
  const FaceMesh there = out.is_mirrored ? seen_from_behind(mesh) : mesh;
  std::vector<char> is_known(out.points.size(), 0);
  std::fill_n(is_known.begin(), cap.plane.n_boundary, 1);
  const auto image = matched(in_space(cap.plane, out.points), there,
                             nodes_at(out.points, is_known, there, tolerance));
  if (!image)
    throw InvalidMeshError("surface",
                           name_of(cap.face) + " and " + name_of(face) +
                               ", source and target of one sweep, have different meshes from the "
                               "solids that touch there.",
                           {name_of(cap.face), name_of(face)}, {});
  for (std::size_t n = boundary.size(); n < out.points.size(); ++n) {
    out.points[n] = there.points[(*image)[n]];
    out.uv[n] = model.project(face, out.points[n]);
  }
  return out;
}

}  // namespace sweepmesh
