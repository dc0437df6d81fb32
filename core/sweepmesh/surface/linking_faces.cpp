#include "sweepmesh/surface/linking_faces.h"

#include <string>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/surface/submap_boundary.h"
#include "sweepmesh/surface/submap_place.h"
#include "sweepmesh/surface/submap_smooth.h"

namespace sweepmesh {
namespace {

const char* const stage = "surface";

[[noreturn]] void refuse_boundary(FaceId face, const Intervals& intervals) {
  std::string sentence = "The numbers of mesh edges around " + name_of(face) +
                         " bound no structured grid: its sides would touch or cross.";
  std::vector<std::string> entities = {name_of(face)};
  if (!intervals.unmet.empty()) sentence += " " + intervals.unmet;
  for (const std::string& name : intervals.unmet_entities)
    if (name != entities.front()) entities.push_back(name);
  throw InvalidMeshError(stage, sentence, entities, {});
}

PlacedRegion with_boundary(const SubmapBoundary& b, const SurfaceMesh& mesh, FaceId face,
                           const Intervals& intervals) {
  auto region = fill_region(b.loops, b.period);
  if (!region) refuse_boundary(face, intervals);
  PlacedRegion placed{std::move(*region), b.period, {}, {}};
  for (std::size_t l = 0; l < b.loops.size(); ++l)
    for (std::size_t s = 0; s < b.nodes[l].size(); ++s) {
      placed.uv.push_back(b.uv[l][s]);
      placed.points.push_back(mesh.points[b.nodes[l][s].index]);
    }
  return placed;
}

void place(const Model& model, FaceId face, PlacedRegion& placed, const Context& context) {
  if (is_rectangle(placed.region))
    place_transfinite(placed);
  else if (is_plain_tube(placed))
    place_ruled(placed);
  else
    place_harmonic(placed);
  const double good_jacobian = 0.7, good_stretch = 3.0;  // what a grid needs no improvement with
  GridQuality quality = judge_grid(model, face, placed);
  if (quality.min_scaled_jacobian < good_jacobian || quality.max_stretch > good_stretch) {
    smooth_grid(model, face, placed, context);
    quality = judge_grid(model, face, placed);
  }
  if (quality.inverted.empty()) return;
  throw InvalidMeshError(stage,
                         "The structured grid of " + name_of(face) + " has " +
                             std::to_string(quality.inverted.size()) +
                             " inverted quads; try a smaller element size.",
                         {name_of(face)}, quality.inverted);
}

void add_to_mesh(const Model& model, FaceId face, const SubmapBoundary& boundary,
                 const PlacedRegion& placed, SurfaceMesh& mesh) {
  std::vector<NodeId> node;
  for (const auto& loop : boundary.nodes) node.insert(node.end(), loop.begin(), loop.end());
  for (std::size_t n = node.size(); n < placed.region.nodes.size(); ++n)
    node.push_back(mesh.add_node(model.point(face, placed.uv[n]), {EntityKind::face, face.index},
                                 placed.region.nodes[n].k));
  for (const auto& cell : placed.region.cells)
    mesh.add_cell({node[cell[0]], node[cell[1]], node[cell[2]], node[cell[3]]}, face);
}

}  // namespace

void mesh_linking_faces(const Model& model, const Scheme& scheme, const Intervals& intervals,
                        const EdgeMesh& edges, Context& context, SurfaceMesh& mesh) {
  const auto faces = scheme.faces_with(FaceRole::linking);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    context.check(stage);
    context.report(static_cast<double>(f) / faces.size(), "Meshing " + name_of(faces[f]));
    const auto boundary = submap_boundary(model, scheme, intervals, edges, mesh, faces[f]);
    PlacedRegion placed = with_boundary(boundary, mesh, faces[f], intervals);
    place(model, faces[f], placed, context);
    add_to_mesh(model, faces[f], boundary, placed, mesh);
  }
}

}  // namespace sweepmesh
