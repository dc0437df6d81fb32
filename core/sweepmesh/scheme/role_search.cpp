#include "sweepmesh/scheme/role_search.h"

#include <algorithm>
#include <bit>

#include "sweepmesh/scheme/counts.h"
#include "sweepmesh/scheme/vertex_columns.h"

namespace sweepmesh {

namespace {

constexpr std::array kRoles = {kLinkingStates, kSourceStates, kTargetStates};

bool is_one_role(StateSet role) {
  return std::ranges::find(kRoles, role) != kRoles.end();
}

/// Costs closer than this are equal: a second scheme of the same roles must be better by more.
constexpr double kTie = 1e-6;

/// What a node of the search takes besides its propagation, in the unit of the effort.
constexpr long kWorkPerCoedge = 30;

class Search {
 public:
  Search(const Network& n, const SearchOptions& options, Context& context)
      : n_(n), options_(options), context_(context), limit_(options.max_cost) {}

  SearchResult over_roles(Choices start) {
    run_roles(std::move(start));
    result_.effort = effort_;
    return std::move(result_);
  }

  SearchResult over_states(Choices start) {
    result_.conflict = narrowed(limit_, all_faces(n_), start);
    if (!result_.conflict) finish(start);
    result_.effort = effort_;
    return std::move(result_);
  }

 private:
  std::optional<Conflict> narrowed(double limit, std::vector<int> touched, Choices& choices) {
    return propagate(n_, limit, std::move(touched), choices, effort_, context_,
                     options_.max_effort);
  }

  void run_roles(Choices start) {
    result_.conflict = narrowed(limit_, all_faces(n_), start);
    if (result_.conflict || is_exhausted()) return;
    if (options_.is_symmetric) {
      from_each_seed(std::move(start));
    } else {
      branch_roles(start);
    }
  }

  bool is_exhausted() {
    if (effort_ < options_.max_effort) return false;
    result_.is_complete = false;
    return true;
  }

  double role_cost(const Choices& choices, int face, StateSet role) const {
    const int c = n_.problem.first_coedge(face);
    double best = kImpossible;
    for (int s = 0; s < kStates; ++s)
      if (has(choices.domain[c] & role, s)) best = std::min(best, choices.marginal[c][s]);
    return best;
  }

  /// Some face is a source. Taking the faces in turn as such, each excludes itself from the caps of
  /// what follows: with sources and targets alike, all schemes that have it as a cap have been
  /// seen.
  void from_each_seed(Choices start) {
    std::vector<int> seeds;
    for (bool is_cap_only : {true, false})
      for (int f : all_faces(n_)) {
        const bool may_link = start.role[f] & kLinkingStates;
        if ((start.role[f] & kSourceStates) && may_link != is_cap_only) seeds.push_back(f);
      }
    for (int seed : seeds) {
      if (is_exhausted()) return;
      if (!(start.role[seed] & kSourceStates)) continue;
      const bool is_last = !(start.role[seed] & kLinkingStates);
      try_role(start, seed, kSourceStates);
      if (is_last) return;
      std::vector<int> touched;
      set_role(n_, start, seed, kLinkingStates, touched);
      if (narrowed(limit_, touched, start)) return;
    }
  }

  void try_role(Choices choices, int face, StateSet role) {
    std::vector<int> touched;
    set_role(n_, choices, face, role, touched);
    if (narrowed(limit_, touched, choices)) return;
    branch_roles(choices);
  }

  /// The undecided face whose cheapest role is the furthest ahead of its next, or -1.
  int clearest_face(const Choices& choices) const {
    int best = -1;
    double best_lead = -1.0;
    for (int f : all_faces(n_)) {
      if (is_one_role(choices.role[f]) || n_.problem.n_coedges(f) == 0) continue;
      std::array<double, 3> costs;
      for (int r = 0; r < 3; ++r) costs[r] = role_cost(choices, f, choices.role[f] & kRoles[r]);
      std::ranges::sort(costs);
      const double lead = std::min(costs[1], 1e6) - costs[0];
      if (lead > best_lead) {
        best = f;
        best_lead = lead;
      }
    }
    return best;
  }

  void branch_roles(const Choices& choices) {
    effort_ += kWorkPerCoedge * choices.domain.size();
    if (is_exhausted()) return;
    if (!level_groups(n_, choices)) {
      ++result_.rejections.n_without_levels;
      return;
    }
    const int face = clearest_face(choices);
    if (face < 0) return finish(choices);
    std::vector<std::pair<double, int>> order;
    for (int r = 0; r < 3; ++r)
      if (choices.role[face] & kRoles[r])
        order.emplace_back(role_cost(choices, face, kRoles[r]), r);
    std::ranges::sort(order);
    for (const auto& [cost, r] : order) try_role(choices, face, kRoles[r]);
  }

  /// All roles are decided: the cheapest states under them become a division.
  void finish(const Choices& choices) {
    best_states_.reset();
    states_limit_ = limit_;
    branch_states(choices);
    if (!best_states_) return;
    auto& list = result_.divisions;
    const auto place = std::ranges::upper_bound(list, best_states_->cost, {}, &Division::cost);
    list.insert(place, *best_states_);
    if (static_cast<int>(list.size()) <= options_.max_schemes) return;
    list.pop_back();
    limit_ = list.back().cost - kTie;
  }

  int clearest_coedge(const Choices& choices) const {
    int best = -1;
    double best_lead = -1.0;
    for (std::size_t c = 0; c < choices.domain.size(); ++c) {
      if (is_single(choices.domain[c])) continue;
      double first = kImpossible, second = kImpossible;
      for (int s = 0; s < kStates; ++s) {
        if (!has(choices.domain[c], s)) continue;
        const double cost = choices.marginal[c][s];
        second = std::min(second, std::max(first, cost));
        first = std::min(first, cost);
      }
      const double lead = std::min(second, 1e6) - first;
      if (lead > best_lead) {
        best = static_cast<int>(c);
        best_lead = lead;
      }
    }
    return best;
  }

  void branch_states(const Choices& choices) {
    effort_ += kWorkPerCoedge * choices.domain.size();
    if (is_exhausted() || choices.bound > states_limit_) return;
    if (!level_groups(n_, choices)) {
      ++result_.rejections.n_without_levels;
      return;
    }
    const int coedge = clearest_coedge(choices);
    if (coedge < 0) return take(choices);
    std::vector<std::pair<double, int>> order;
    for (int s = 0; s < kStates; ++s)
      if (has(choices.domain[coedge], s)) order.emplace_back(choices.marginal[coedge][s], s);
    std::ranges::sort(order);
    for (const auto& [cost, s] : order) {
      Choices next = choices;
      std::vector<int> touched;
      set_state(n_, next, coedge, StateSet(1 << s), touched);
      if (!narrowed(states_limit_, touched, next)) branch_states(next);
    }
  }

  void take(const Choices& choices) {
    if (!is_accepted(choices)) return;
    best_states_ = Division{choices, choices.bound};
    states_limit_ = choices.bound - kTie;
  }

  /// The conditions that single faces cannot tell.
  bool is_accepted(const Choices& choices) {
    Rejections& why = result_.rejections;
    if (!has_both_ends(n_, choices)) return ++why.n_without_ends, false;
    if (!is_euler_balanced(n_, choices)) return ++why.n_unbalanced, false;
    if (const auto torn = torn_vertex(n_, choices)) {
      if (!why.torn) why.torn = torn;
      return ++why.n_torn, false;
    }
    if (!do_shells_agree(n_, choices)) return ++why.n_voids_askew, false;
    if (!do_counts_exist(n_, choices, context_)) return ++why.n_without_counts, false;
    const auto walls = opposed_walls(n_, choices);
    if (!walls) return true;
    ++why.n_walls_opposed;
    if (!why.walls) why.walls = walls;
    return false;
  }

  const Network& n_;
  const SearchOptions& options_;
  Context& context_;
  double limit_;
  long effort_ = 0;
  SearchResult result_;
  std::optional<Division> best_states_;
  double states_limit_ = kImpossible;
};

}  // namespace

SearchResult search_divisions(const Network& network, const Choices& start,
                              const SearchOptions& options, Context& context) {
  return Search(network, options, context).over_roles(start);
}

SearchResult search_states(const Network& network, const Choices& start,
                           const SearchOptions& options, Context& context) {
  return Search(network, options, context).over_states(start);
}

}  // namespace sweepmesh
