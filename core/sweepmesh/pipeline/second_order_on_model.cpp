#include "sweepmesh/pipeline/second_order_on_model.h"

#include "sweepmesh/volume/second_order.h"

namespace sweepmesh {
namespace {

MidPoint on_face(const Model& model, FaceId face, const Point3& middle) {
  return {model.point(face, model.project(face, middle)), {EntityKind::face, face.index}};
}

/// The nearest point of the edges between two faces; of the first face where they share none.
MidPoint on_edge_between(const Model& model, const BoundarySide& side, const Point3& middle) {
  MidPoint best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const Loop& loop : model.loops(side.one))
    for (const Coedge& coedge : loop) {
      if (!coedge.edge.is_valid() || model.partner(coedge).face != side.other) continue;
      const Point3 p = model.point(coedge.edge, model.project(coedge.edge, middle));
      const double distance = (p - middle).norm();
      if (distance >= best_distance) continue;
      best = {p, {EntityKind::edge, coedge.edge.index}};
      best_distance = distance;
    }
  return best.owner.index >= 0 ? best : on_face(model, side.one, middle);
}

}  // namespace

void add_mid_nodes_on(const Model& model, VolumeMesh& mesh, Context& context,
                      std::vector<std::string>& warnings) {
  const auto find = [&](const BoundarySide& side, const Point3& middle) {
    return side.other.is_valid() && side.one != side.other ? on_edge_between(model, side, middle)
                                                           : on_face(model, side.one, middle);
  };
  const SecondOrderReport report = add_mid_nodes(mesh, find, context);
  if (report.n_straightened > 0)
    warnings.push_back(std::to_string(report.n_straightened) +
                       " mid-side nodes were drawn off the CAD geometry to keep elements valid.");
}

}  // namespace sweepmesh
