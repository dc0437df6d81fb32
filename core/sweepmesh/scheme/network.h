// Faces and edges as a network of choices: which states are left to each coedge, and what the best
// choice costs at least.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/scheme/face_costs.h"
#include "sweepmesh/scheme/states.h"

namespace sweepmesh {

/// What never changes during a search.
struct Network {
  SweepProblem problem;
  std::vector<PairCosts> pair;                ///< by edge
  std::vector<std::array<double, 4>> corner;  ///< by coedge: types at its end
  Preferences preferences;
};

/// A vertex type that is fixed: of the corner where a coedge (SweepProblem index) ends.
struct FixedCorner {
  int coedge;
  VertexType type;
};

Network make_network(SweepProblem problem, const AngleLimits& limits,
                     const std::vector<FixedCorner>& fixed = {},
                     const Preferences& preferences = {});

/// A state of the search. `domain[c]` are the states left to coedge c, `role[f]` the roles left to
/// a face (a mask of the same bits: kLinkingStates as a whole, kSourceStates, kTargetStates).
/// `bound` is the sum over the faces of what each costs at least by itself; every edge's cost is
/// split in halves between its two faces, so no completion of the choices costs less.
struct Choices {
  std::vector<StateSet> domain;
  std::vector<StateSet> role;
  std::vector<StateCosts> marginal;  ///< by coedge: FaceCosts::marginal of its face
  std::vector<double> face_bound;
  double bound = 0.0;
};

/// All choices open. Nothing is computed yet: propagate with every face.
Choices open_choices(const Network& network);
std::vector<int> all_faces(const Network& network);

/// Narrowing; each returns the faces whose costs have to be computed anew.
void set_role(const Network& network, Choices& choices, int face, StateSet states,
              std::vector<int>& touched);
void set_state(const Network& network, Choices& choices, int coedge, StateSet states,
               std::vector<int>& touched);

/// What made a set of choices impossible: no role or state of this face is left under the limit.
struct Conflict {
  int face = -1;
};

/// Removes every state that cannot be part of a completion of cost <= `max_cost`, as far as single
/// faces tell, until nothing changes. `effort` counts the steps taken (about ten nanoseconds each).
/// Faces with few coedges come first. Returns the conflict where a face is left without a state;
/// once `effort` is more than `max_effort` it ends as it stands, with more states than need be.
/// Throws Cancelled.
std::optional<Conflict> propagate(const Network& network, double max_cost, std::vector<int> touched,
                                  Choices& choices, long& effort, const Context& context,
                                  long max_effort = std::numeric_limits<long>::max());

/// True when each coedge has one state only.
bool is_decided(const Choices& choices);

}  // namespace sweepmesh
