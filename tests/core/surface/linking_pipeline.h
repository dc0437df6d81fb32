// From a solid that stands along z to the mesh of its linking faces, and what must hold for it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "simple_scheme.h"
#include "solids.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/surface/linking_columns.h"
#include "sweepmesh/surface/linking_faces.h"
#include "sweepmesh/surface/linking_quality.h"

namespace sweepmesh::testing {

struct LinkingMesh {
  Model model;
  Scheme scheme;
  Intervals intervals;
  SurfaceMesh mesh;
};

inline LinkingMesh mesh_scheme(Model model, Scheme scheme, const IntervalOptions& options) {
  Context context;
  Intervals intervals = assign_intervals(model, scheme, options, context);
  SurfaceMesh mesh;
  const EdgeMesh edges =
      mesh_edges(model, intervals, place_edge_nodes(model, intervals, options), mesh);
  mesh_linking_faces(model, scheme, intervals, edges, context, mesh);
  return {std::move(model), std::move(scheme), std::move(intervals), std::move(mesh)};
}

inline LinkingMesh mesh_upright(const TopoDS_Shape& shape, const IntervalOptions& options) {
  Model model = model_of(shape);
  Scheme scheme = simple_scheme(model, faces_facing(model, 1), faces_facing(model, -1));
  return mesh_scheme(std::move(model), std::move(scheme), options);
}

/// Least scaled Jacobian, with normals from the surface at the nodes' closest points.
inline double worst_quad(const LinkingMesh& m) {
  double worst = 1.0;
  for (int cell = 0; cell < m.mesh.n_cells(); ++cell) {
    std::array<Point3, 4> corner, normal;
    for (int c = 0; c < 4; ++c) {
      corner[c] = m.mesh.points[m.mesh.cell_nodes[m.mesh.cell_offset[cell] + c]];
      normal[c] = m.model.normal(m.mesh.cell_face[cell],
                                 m.model.project(m.mesh.cell_face[cell], corner[c]));
    }
    worst = std::min(worst, scaled_jacobian(corner, normal));
  }
  return worst;
}

inline void expect_nodes_on_their_entities(const LinkingMesh& m) {
  const double tolerance = 1e-6 * m.model.tolerances().model_size;
  for (int n = 0; n < m.mesh.n_nodes(); ++n) {
    const Owner owner = m.mesh.owner[n];
    const Point3& p = m.mesh.points[n];
    double off = 0.0;
    if (owner.kind == EntityKind::vertex) off = (m.model.point(VertexId{owner.index}) - p).norm();
    if (owner.kind == EntityKind::edge) off = m.model.distance(EdgeId{owner.index}, p);
    if (owner.kind == EntityKind::face) off = m.model.distance(FaceId{owner.index}, p);
    EXPECT_LE(off, tolerance) << "node " << n;
  }
}

/// The sides of the grids fit together: each lies between two quads that run through it in opposite
/// directions, or on the rim of a cap, where it lies within a layer.
inline void expect_conforming(const LinkingMesh& m) {
  std::map<std::pair<int, int>, int> sides;
  for (int cell = 0; cell < m.mesh.n_cells(); ++cell) {
    ASSERT_EQ(m.mesh.cell_size(cell), 4);
    const int* node = &m.mesh.cell_nodes[m.mesh.cell_offset[cell]];
    for (int c = 0; c < 4; ++c) ++sides[{node[c], node[(c + 1) % 4]}];
    EXPECT_EQ(m.mesh.k[node[0]], m.mesh.k[node[1]]);
    EXPECT_EQ(m.mesh.k[node[3]], m.mesh.k[node[2]]);
    EXPECT_EQ(m.mesh.k[node[0]] + 1, m.mesh.k[node[3]]);
  }
  for (const auto& [side, n] : sides) {
    EXPECT_EQ(n, 1);
    const bool is_closed = sides.count({side.second, side.first}) > 0;
    EXPECT_TRUE(is_closed || m.mesh.k[side.first] == m.mesh.k[side.second]) << "an open axial side";
  }
}

/// Every column runs from a target to a source, one layer at a time.
inline void expect_columns(const LinkingMesh& m) {
  for (const auto& chain : columns_from(m.mesh).chains) {
    ASSERT_GE(chain.size(), 2u);
    for (std::size_t j = 1; j < chain.size(); ++j)
      EXPECT_EQ(m.mesh.k[chain[j].index], m.mesh.k[chain[j - 1].index] + 1);
  }
}

inline void expect_valid_linking_mesh(const LinkingMesh& m, double least_jacobian = 1e-6) {
  expect_nodes_on_their_entities(m);
  expect_conforming(m);
  expect_columns(m);
  EXPECT_GE(worst_quad(m), least_jacobian);
}

}  // namespace sweepmesh::testing
