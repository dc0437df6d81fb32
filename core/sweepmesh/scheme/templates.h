// Rounds, fillets and chamfers: where a face's boundary turns without a vertex, virtual corners
// take the types (thesis 6.2.1, figure 6.3).
#pragma once

#include <optional>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/vertex_types.h"

namespace sweepmesh {

struct TemplateOptions {
  /// Edges are tangent where the angle between them is straight within this, radians.
  double tangent_tolerance = kQuarterTurn / 18;
  /// A run of edges is a round where its turn is a whole number of quarter turns within this,
  /// radians.
  double turn_tolerance = kQuarterTurn / 4;
  /// An edge is a chamfer where both its corners have 135 degrees (or both 225) within this,
  /// radians,
  double chamfer_tolerance = kQuarterTurn / 6;
  /// and it is shorter than this fraction of both its neighbours. 0: nothing is a chamfer.
  double chamfer_length = 0.75;
  /// Heading of a grid line of the face from d/du, radians, modulo a quarter turn. Empty: that of
  /// the straight edges, if there are any.
  std::optional<double> frame = {};
};

/// The heading that the straight edges of a face have in common modulo a quarter turn, the long
/// ones first; empty where no edge is straight.
std::optional<double> frame_of_straight_edges(const Model& model, FaceId face,
                                              const TemplateOptions& options = {});

/// The corners of a face, vertices and angles as they are. Degenerate coedges are left out.
FaceCorners face_corners(const Model& model, FaceId face);

/// The same with the templates applied:
/// - a run of tangent edges that turns by n = 1, 2, 3 or 4 quarter turns (arcs or splines, one edge
/// or several) gets n virtual corners,
///   END where it turns left (a round) and CORNER where it turns right (a fillet, a hole), at the
///   middles of n equal parts of its turn; those of a full circle lie half way between the
///   directions of the frame, where there is one. A part's middle that falls on a vertex gives its
///   turn to that vertex;
/// - a chamfer gets one virtual corner in its middle, and its own two corners become straight (180
/// degrees). Edges that turn less, or to both sides, belong to no round. The angles of the virtual
/// corners are those of the turn that they stand for, so that nearest_type gives the template's
/// type and the program may still change it.
FaceCorners face_corners_with_templates(const Model& model, FaceId face,
                                        const TemplateOptions& options = {});

}  // namespace sweepmesh
