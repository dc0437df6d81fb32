#include "sweepmesh/scheme/strain.h"

#include "sweepmesh/scheme/limits.h"
#include "sweepmesh/scheme/to_scheme.h"

namespace sweepmesh {
namespace {

double excess_of_edges(const Network& network, const Division& division) {
  const std::vector<PairCosts> strict = pair_costs(network.problem, strict_limits());
  double sum = 0.0;
  for (std::size_t e = 0; e < network.problem.edges.size(); ++e) {
    const auto& coedge = network.problem.edges[e].coedge;
    const int a = first_state(division.choices.domain[coedge[0]]);
    const int b = first_state(division.choices.domain[coedge[1]]);
    if (strict[e][a][b] == kImpossible) sum += network.pair[e][a][b];
  }
  return sum;
}

double excess_of_vertices(const Model& model, const Scheme& scheme) {
  const double deviation = strict_limits().edge_deviation / kQuarterTurn;
  double sum = 0.0;
  for (const FaceId f : scheme.faces_with(FaceRole::linking)) {
    const auto& types = scheme.face[f.index].type;
    for (std::size_t l = 0; l < types.size(); ++l)
      for (std::size_t c = 0; c < types[l].size(); ++c) {
        const double angle = model.interior_angle(f, static_cast<int>(l), static_cast<int>(c));
        const double cost = angle_cost(angle, types[l][c]);
        if (cost > deviation * deviation) sum += cost;
      }
  }
  return sum;
}

}  // namespace

double excess_of(const Model& model, const Network& network, const Division& division) {
  return excess_of_edges(network, division) +
         excess_of_vertices(model, to_scheme(network, division, model.n_faces(), model.n_edges()));
}

}  // namespace sweepmesh
