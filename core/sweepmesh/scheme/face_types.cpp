#include "sweepmesh/scheme/face_types.h"

#include "sweepmesh/base/errors.h"

namespace sweepmesh {

namespace {

std::vector<FixedType> fixed_types(const FaceCorners& corners, FaceId face,
                                   const std::vector<TypePick>& picks) {
  std::vector<FixedType> out;
  for (const TypePick& pick : picks) {
    if (pick.face != face) continue;
    const std::size_t n_before = out.size();
    for (std::size_t l = 0; l < corners.size(); ++l)
      for (std::size_t c = 0; c < corners[l].size(); ++c)
        if (corners[l][c].vertex == pick.vertex)
          out.push_back({static_cast<int>(l), static_cast<int>(c), pick.type});
    if (out.size() == n_before)
      throw InputError("assess",
                       name_of(pick.vertex) + " is not a vertex of " + name_of(face) + ".",
                       {name_of(pick.vertex), name_of(face)});
  }
  return out;
}

Point3 point_of(const Model& model, FaceId face, const FaceCorner& corner) {
  if (corner.vertex.is_valid()) return model.point(corner.vertex);
  const auto& uses = model.coedges(corner.edge);
  const Coedge& c = uses[0].face == face ? uses[0] : uses[1];
  const double fraction = c.reversed ? 1 - corner.at : corner.at;
  return model.point(corner.edge, model.at_length_fractions(corner.edge, {fraction}).front());
}

}  // namespace

std::vector<TypedCorner> types_of_face(const Model& model, FaceId face,
                                       const FaceTypeOptions& options, Context& context) {
  const FaceCorners corners =
      options.has_templates ? face_corners_with_templates(model, face) : face_corners(model, face);
  TypeOptions how;
  how.model = options.model;
  how.fixed = fixed_types(corners, face, options.picks);
  const auto solved = solve_vertex_types(corners, how, context);
  if (const auto* reasons = std::get_if<std::vector<Reason>>(&solved))
    throw InputError("assess", reasons->front().text, reasons->front().entities);
  const auto& type = std::get<VertexTypes>(solved).type;
  std::vector<TypedCorner> out;
  for (std::size_t l = 0; l < corners.size(); ++l)
    for (std::size_t c = 0; c < corners[l].size(); ++c) {
      const FaceCorner& corner = corners[l][c];
      out.push_back({static_cast<int>(l), corner.vertex, corner.edge, point_of(model, face, corner),
                     corner.angle, nearest_type(corner.angle), type[l][c]});
    }
  return out;
}

}  // namespace sweepmesh
