// Vertex types of any one face, as if it were to carry a structured grid by itself: for people to
// look at.
#pragma once

#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/templates.h"

namespace sweepmesh {

struct TypedCorner {
  int loop = 0;
  VertexId vertex;  ///< invalid for a virtual corner
  EdgeId edge;      ///< of a virtual one: where it lies
  Point3 point;
  double angle = 0.0;  ///< FaceCorner::angle
  VertexType nearest = VertexType::side, type = VertexType::side;
};

struct FaceTypeOptions {
  TypeModel model = TypeModel::fewest_changes;
  bool has_templates = true;
  std::vector<TypePick> picks = {};  ///< those on other faces are passed over
};

/// The corners along the face's loops with the types that solve_vertex_types finds, apart from any
/// sweep. Throws InputError("assess") where there are none (the sentence and the entities of its
/// reason) or a picked vertex is not on the face; SolverError, Cancelled.
std::vector<TypedCorner> types_of_face(const Model& model, FaceId face,
                                       const FaceTypeOptions& options, Context& context);

}  // namespace sweepmesh
