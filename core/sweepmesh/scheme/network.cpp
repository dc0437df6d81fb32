#include "sweepmesh/scheme/network.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "sweepmesh/scheme/loop_program.h"

namespace sweepmesh {

namespace {

constexpr std::array kTypes = {VertexType::end, VertexType::side, VertexType::corner,
                               VertexType::reversal};
constexpr std::array kRoles = {kLinkingStates, kSourceStates, kTargetStates};
/// What the rest of a face's renewal takes, in steps of a path.
constexpr long kWorkPerCoedge = 40;

/// Sums of costs are compared with this slack, which rounding stays far below.
double slack(double cost) {
  return 1e-9 * (1.0 + cost);
}

double pair_cost(const Network& n, int coedge, int state, int other) {
  const int edge = n.problem.coedges[coedge].edge;
  const bool is_first = n.problem.edges[edge].coedge[0] == coedge;
  return is_first ? n.pair[edge][state][other] : n.pair[edge][other][state];
}

/// Half of the cheapest meeting of a coedge's states with those of its partner.
StateCosts own_costs(const Network& n, const Choices& choices, int coedge) {
  StateCosts out;
  out.fill(kImpossible);
  const int partner = n.problem.coedges[coedge].partner;
  for (int a = 0; a < kStates; ++a) {
    if (!has(choices.domain[coedge], a)) continue;
    for (int b = 0; b < kStates; ++b)
      if (has(choices.domain[partner], b))
        out[a] = std::min(out[a], pair_cost(n, coedge, a, b) / 2);
  }
  return out;
}

class Propagation {
 public:
  Propagation(const Network& n, double max_cost, Choices& choices, long& effort, long max_effort)
      : n_(n), max_cost_(max_cost), choices_(choices), effort_(effort), max_effort_(max_effort) {}

  std::optional<Conflict> run(std::vector<int> touched, const Context& context) {
    for (const int face : touched) open(face);
    while (!open_.empty() && effort_ <= max_effort_) {
      context.check("assess");
      const int face = open_.begin()->second;
      open_.erase(open_.begin());
      if (!renew(face)) return Conflict{face};
    }
    return {};
  }

 private:
  void open(int face) { open_.insert({n_.problem.n_coedges(face), face}); }

  bool renew(int face) {
    const int first = n_.problem.first_coedge(face), count = n_.problem.n_coedges(face);
    if (count == 0) return true;
    std::vector<StateCosts> own;
    for (int c = first; c < first + count; ++c) own.push_back(own_costs(n_, choices_, c));
    const std::vector<std::array<double, 4>> corner(n_.corner.begin() + first,
                                                    n_.corner.begin() + first + count);
    // What narrow() below would remove need not be found: twice its slack, to be on the safe side.
    const double others = choices_.bound - choices_.face_bound[face];
    const double most = max_cost_ - others + 2 * slack(max_cost_);
    FaceCosts costs = face_costs(n_.problem, face, own, corner, n_.preferences, most);
    effort_ += costs.work + kWorkPerCoedge * count;
    if (costs.best == kImpossible) return false;
    choices_.bound += costs.best - choices_.face_bound[face];
    choices_.face_bound[face] = costs.best;
    const double spare = max_cost_ - choices_.bound + slack(max_cost_);
    if (spare < 0) return false;
    std::copy(costs.marginal.begin(), costs.marginal.end(), choices_.marginal.begin() + first);
    for (int c = first; c < first + count; ++c) narrow(c, costs.best + spare);
    return narrow_role(face, first);
  }

  void narrow(int coedge, double limit) {
    StateSet left = 0;
    for (int s = 0; s < kStates; ++s)
      if (has(choices_.domain[coedge], s) && choices_.marginal[coedge][s] <= limit &&
          choices_.marginal[coedge][s] < kImpossible)
        left |= 1 << s;
    if (left == choices_.domain[coedge]) return;
    choices_.domain[coedge] = left;
    open(n_.problem.coedges[n_.problem.coedges[coedge].partner].face);
  }

  bool narrow_role(int face, int first) {
    StateSet left = 0;
    for (StateSet role : kRoles)
      if (choices_.domain[first] & role) left |= role;
    choices_.role[face] &= left;
    return choices_.role[face] != 0;
  }

  const Network& n_;
  double max_cost_;
  Choices& choices_;
  long& effort_;
  long max_effort_;
  std::set<std::pair<int, int>> open_;  ///< number of coedges, face
};

}  // namespace

Network make_network(SweepProblem problem, const AngleLimits& limits,
                     const std::vector<FixedCorner>& fixed, const Preferences& preferences) {
  Network out{std::move(problem), {}, {}, preferences};
  out.pair = pair_costs(out.problem, limits, preferences);
  for (const ProblemCoedge& coedge : out.problem.coedges)
    out.corner.push_back(corner_costs(coedge.angle, of_place(limits, coedge.bend)));
  for (const FixedCorner& f : fixed)
    for (int t = 0; t < 4; ++t) out.corner[f.coedge][t] = kTypes[t] == f.type ? 0.0 : kImpossible;
  return out;
}

Choices open_choices(const Network& network) {
  StateCosts zero{};
  return {std::vector<StateSet>(network.problem.coedges.size(), kAllStates),
          std::vector<StateSet>(network.problem.faces.size(), kAllStates),
          std::vector<StateCosts>(network.problem.coedges.size(), zero),
          std::vector<double>(network.problem.faces.size(), 0.0), 0.0};
}

std::vector<int> all_faces(const Network& network) {
  std::vector<int> out(network.problem.faces.size());
  std::iota(out.begin(), out.end(), 0);
  return out;
}

void set_role(const Network& network, Choices& choices, int face, StateSet states,
              std::vector<int>& touched) {
  choices.role[face] &= states;
  const int first = network.problem.first_coedge(face);
  for (int c = first; c < first + network.problem.n_coedges(face); ++c)
    set_state(network, choices, c, states, touched);
  touched.push_back(face);
}

void set_state(const Network& network, Choices& choices, int coedge, StateSet states,
               std::vector<int>& touched) {
  choices.domain[coedge] &= states;
  const ProblemCoedge& c = network.problem.coedges[coedge];
  touched.push_back(c.face);
  touched.push_back(network.problem.coedges[c.partner].face);
}

std::optional<Conflict> propagate(const Network& network, double max_cost, std::vector<int> touched,
                                  Choices& choices, long& effort, const Context& context,
                                  long max_effort) {
  return Propagation(network, max_cost, choices, effort, max_effort)
      .run(std::move(touched), context);
}

bool is_decided(const Choices& choices) {
  return std::ranges::all_of(choices.domain, is_single);
}

}  // namespace sweepmesh
