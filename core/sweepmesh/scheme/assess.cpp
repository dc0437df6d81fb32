#include "sweepmesh/scheme/assess.h"

#include <algorithm>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/scheme/graded_search.h"
#include "sweepmesh/scheme/pairs.h"
#include "sweepmesh/scheme/prismatic.h"
#include "sweepmesh/scheme/ranking.h"
#include "sweepmesh/scheme/reasons.h"
#include "sweepmesh/scheme/to_scheme.h"
#include "sweepmesh/scheme/walled.h"

namespace sweepmesh {

namespace {

/// The picks without each of which the others can be met; all where no single one is to blame.
std::vector<FaceId> blamed_picks(const Network& network, const std::vector<Pick>& picks,
                                 SearchBudget& budget, Context& context) {
  std::vector<FaceId> blamed, all;
  const double share = 1.0 / static_cast<double>(picks.size());
  for (std::size_t i = 0; i < picks.size(); ++i) {
    std::vector<Pick> others = picks;
    others.erase(others.begin() + i);
    all.push_back(picks[i].first);
    if (!others.empty() &&
        !graded_search(network, others, budget, context, share).divisions.empty())
      blamed.push_back(picks[i].first);
  }
  return blamed.empty() ? all : blamed;
}

/// Takes out what contradicts the pairs; gives the first contradiction where nothing is left.
std::optional<Reason> keep_paired(const Network& network, const Picks& picks,
                                  std::vector<Division>& divisions) {
  std::optional<Reason> first;
  std::erase_if(divisions, [&](const Division& d) {
    const auto reason = contradicted_pair(network, d, picks.pairs);
    if (reason && !first) first = reason;
    return reason.has_value();
  });
  return divisions.empty() ? first : std::nullopt;
}

/// Whether the edges of a shell bend all outwards or all inwards.
bool is_convex_shell(const SweepProblem& problem, int shell) {
  const AngleLimits limits = radial_limits();
  bool bends_out = false, bends_in = false;
  for (const ProblemEdge& edge : problem.edges) {
    if (problem.faces[problem.coedges[edge.coedge[0]].face].shell != shell) continue;
    bends_out |= edge.least < 2 * kQuarterTurn - limits.margin;
    bends_in |= edge.largest > 2 * kQuarterTurn + limits.margin;
  }
  return !(bends_out && bends_in);
}

class Assessor {
 public:
  Assessor(const Model& model, const Picks& picks, Context& context)
      : model_(model),
        picks_(picks),
        context_(context),
        problem_(sweep_problem(model, context)),
        chosen_(all_picks(picks)),
        asked_(with_types(chosen_, picks.types)) {}

  Assessment assess() {
    Assessment out = judge();
    out.folds = !out.is_sweepable() && opposed_;
    return out;
  }

  std::vector<Scheme> strained() {
    if (!reasons_in_boundary(problem_).empty()) return {};
    const Network lenient = make_network(problem_, lenient_limits());
    return strained(lenient, graded_search(lenient, {}, budget_, context_).divisions);
  }

 private:
  Assessment judge() {
    for (const auto& [id, states] : asked_) index_of(problem_, id);
    check_types(picks_);
    if (auto reasons = reasons_in_boundary(problem_); !reasons.empty()) return {{}, reasons};
    if (auto reasons = reasons_in_picks(problem_, picks_); !reasons.empty()) return {{}, reasons};
    context_.report(0.2, "Looking for sources and targets.");
    const auto fixed = fixed_corners(problem_, picks_.types);
    const Network strict = make_network(problem_, strict_limits(), fixed);
    if (auto found = try_with(strict, asked_)) return with_more(*found, fixed);
    if (opposed_) return {{}, {*opposed_}};
    for (const AngleLimits& limits : {tangent_limits(), sharp_limits()})
      if (auto found = try_with(make_network(problem_, limits, fixed), asked_))
        return with_more(*found, fixed);
    context_.report(0.5, "Looking for the reason.");
    const Network lenient = make_network(problem_, lenient_limits(), fixed);
    if (!chosen_.empty() || !fixed.empty())
      if (auto found = try_with(lenient, asked_)) return *found;
    if (auto refused = refuse_types()) return *refused;
    if (!chosen_.empty()) return refuse_picks(strict, lenient);
    if (auto found = try_walled()) return *found;
    if (auto found = try_radial()) {
      if (picks_.types.empty()) return *found;
      return {{}, {type_reason(picks_.types, {})}};
    }
    return refuse(lenient);
  }

  std::optional<Assessment> try_with(const Network& network, const std::vector<Pick>& picks) {
    SearchResult result = graded_search(network, picks, budget_, context_);
    if (result.divisions.empty()) {
      is_strict_complete_ |= result.is_complete;
      if (result.rejections.walls) opposed_ = reason_of_walls(network, *result.rejections.walls);
      return {};
    }
    if (auto reason = keep_paired(network, picks_, result.divisions))
      return Assessment{{}, {*reason}};
    return Assessment{ranked(model_, network, result.divisions, chosen_), {}};
  }

  /// Schemes that the search by cost leaves out.
  Assessment with_more(Assessment found, const std::vector<FixedCorner>& fixed) {
    if (chosen_.empty())
      add_guessed(found, fixed);
    else
      prefer_picked(found, fixed);
    return found;
  }

  /// Where sources and targets were picked: a scheme of just these caps comes first, even if it
  /// takes tangent rims where others do not.
  void prefer_picked(Assessment& found, const std::vector<FixedCorner>& fixed) {
    if (!has_picked(chosen_, kSourceStates) || !has_picked(chosen_, kTargetStates)) return;
    if (found.schemes.empty() || n_caps(found.schemes.front()) == chosen_.size()) return;
    std::vector<Pick> exact = chosen_;
    for (const ProblemFace& face : problem_.faces)
      if (std::ranges::find(chosen_, face.id, &Pick::first) == chosen_.end())
        exact.emplace_back(face.id, kLinkingStates);
    const auto picked = try_with(make_network(problem_, tangent_limits(), fixed), exact);
    if (picked)
      found.schemes.insert(found.schemes.begin(), picked->schemes.begin(), picked->schemes.end());
  }

  /// Offers sweeps through walls and straight ones, too: in the order of cost where rounds and
  /// fillets are tangent to caps at worst, else at the end, whatever their angles cost.
  void add_guessed(Assessment& found, const std::vector<FixedCorner>& fixed) {
    std::vector<Scheme>& schemes = found.schemes;
    for (const Scheme& s : new_ones(prismatic_divisions, tangent_limits(), fixed, schemes))
      schemes.insert(std::ranges::upper_bound(schemes, s.cost, {}, &Scheme::cost), s);
    for (const Scheme& s : new_ones(prismatic_divisions, lenient_limits(), fixed, schemes))
      if (s.cost >= schemes.back().cost) schemes.push_back(s);
    for (const Scheme& s : new_ones(walled_divisions, radial_limits(), fixed, schemes))
      schemes.push_back(s);
  }

  /// Guessed divisions whose caps are not among those of the known schemes.
  std::vector<Scheme> new_ones(std::vector<Division> (*guess)(const Network&, Context&),
                               const AngleLimits& limits, const std::vector<FixedCorner>& fixed,
                               const std::vector<Scheme>& known) {
    const Network network = make_network(problem_, limits, fixed);
    std::vector<Scheme> out = ranked(model_, network, guess(network, context_), chosen_);
    std::erase_if(out, [&](const Scheme& scheme) {
      const bool is_known = std::ranges::any_of(
          known, [&](const Scheme& other) { return has_same_caps(scheme, other); });
      const bool is_asked = std::ranges::all_of(picks_.types, [&](const TypePick& pick) {
        return scheme.face_role[pick.face.index] == FaceRole::linking;
      });
      return is_known || !is_asked;
    });
    return out;
  }

  /// From one side of a wall to the other, where right angles between the faces of a side are all
  /// that is against it.
  std::optional<Assessment> try_walled() {
    Assessment out{new_ones(walled_divisions, radial_limits(), {}, {}), {}};
    if (!picks_.types.empty() || !out.is_sweepable()) return {};
    return out;
  }

  /// Two closed shells, each without re-entrant edges, and nothing between them: from the one to
  /// the other.
  std::optional<Assessment> try_radial() {
    std::vector<Pick> shells;
    for (const ProblemFace& face : problem_.faces) {
      if (face.shell > 1) return {};
      shells.emplace_back(face.id, face.shell == 0 ? kSourceStates : kTargetStates);
    }
    if (!is_convex_shell(problem_, 0) || !is_convex_shell(problem_, 1)) return {};
    return try_with(make_network(problem_, radial_limits()), shells);
  }

  bool can_hold(const std::vector<TypePick>& types) {
    const Network network =
        make_network(problem_, lenient_limits(), fixed_corners(problem_, types));
    return !graded_search(network, with_types(chosen_, types), budget_, context_).divisions.empty();
  }

  /// Drops each type that is not needed for the contradiction. Empty where the types are not at
  /// fault.
  std::optional<Assessment> refuse_types() {
    if (picks_.types.empty() || !can_hold({})) return {};
    std::vector<TypePick> left = picks_.types;
    for (std::size_t i = left.size(); i-- > 0;) {
      std::vector<TypePick> without = left;
      without.erase(without.begin() + i);
      if (!can_hold(without)) left = without;
    }
    return Assessment{{}, {type_reason(left, type_instead_of(left.back()))}};
  }

  /// The type of that vertex in the best scheme where it is free, its face links and all other
  /// types hold.
  std::optional<TypePick> type_instead_of(TypePick pick) {
    std::vector<TypePick> others = picks_.types;
    std::erase_if(
        others, [&](const TypePick& t) { return t.face == pick.face && t.vertex == pick.vertex; });
    std::vector<Pick> asked = with_types(chosen_, others);
    asked.emplace_back(pick.face, kLinkingStates);
    for (const AngleLimits& limits : {strict_limits(), tangent_limits(), lenient_limits()}) {
      const Network network = make_network(problem_, limits, fixed_corners(problem_, others));
      const auto found = graded_search(network, asked, budget_, context_).divisions;
      if (found.empty()) continue;
      const Scheme scheme = to_scheme(network, found.front(), model_.n_faces(), model_.n_edges());
      const auto& loops = model_.loops(pick.face);
      for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t c = 0; c < loops[l].size(); ++c)
          if (loops[l][c].end == pick.vertex) pick.type = scheme.face[pick.face.index].type[l][c];
      return pick;
    }
    return {};
  }

  Assessment refuse(const Network& lenient) {
    SearchResult result = graded_search(lenient, {}, budget_, context_);
    result.is_complete |= is_strict_complete_;
    if (!result.divisions.empty()) {
      Assessment out{{}, {angle_reason(lenient, result.divisions.front())}};
      out.strained = strained(lenient, std::move(result.divisions));
      return out;
    }
    return {{}, reasons_of_failure(lenient, result, context_)};
  }

  /// What the lenient search found, and the best for each direction with its plane faces as caps.
  std::vector<Scheme> strained(const Network& lenient, std::vector<Division> divisions) {
    for (const PlaneCaps& caps : plane_caps(problem_)) {
      std::vector<Pick> picks;
      for (FaceId id : caps.along) picks.emplace_back(id, kSourceStates);
      for (FaceId id : caps.against) picks.emplace_back(id, kTargetStates);
      constexpr double brief = 0.25;
      std::ranges::move(graded_search(lenient, picks, budget_, context_, brief).divisions,
                        std::back_inserter(divisions));
    }
    std::vector<Scheme> out;
    for (Scheme& scheme : ranked(model_, lenient, std::move(divisions), {}))
      if (std::ranges::none_of(out, [&](const Scheme& s) { return has_same_caps(s, scheme); }))
        out.push_back(std::move(scheme));
    return out;
  }

  Assessment refuse_picks(const Network& strict, const Network& lenient) {
    SearchResult free = graded_search(strict, {}, budget_, context_);
    if (free.divisions.empty()) return refuse(lenient);
    const std::vector<FaceId> blamed = blamed_picks(lenient, chosen_, budget_, context_);
    std::vector<Pick> others = chosen_;
    std::erase_if(others, [&](const Pick& pick) { return pick.first == blamed.front(); });
    const SearchResult kept = graded_search(strict, others, budget_, context_);
    return {
        {},
        {pick_reason(strict, blamed, (kept.divisions.empty() ? free : kept).divisions.front())}};
  }

  const Model& model_;
  const Picks& picks_;
  Context& context_;
  SweepProblem problem_;
  std::vector<Pick> chosen_;  ///< caps
  std::vector<Pick> asked_;   ///< and the faces with vertex types
  SearchBudget budget_;
  bool is_strict_complete_ = false;  ///< some search proved that there is nothing
  std::optional<Reason> opposed_;    ///< found within the strict limits, but for walls
};

}  // namespace

Assessment assess(const Model& model, const Picks& picks, Context& context) {
  return Assessor(model, picks, context).assess();
}

std::vector<Scheme> strained_schemes(const Model& model, Context& context) {
  const Picks none;
  return Assessor(model, none, context).strained();
}

std::variant<Scheme, std::vector<Reason>> solve_scheme(const Model& model,
                                                       const std::vector<FaceRole>& roles,
                                                       Context& context) {
  const SweepProblem problem = sweep_problem(model, context);
  if (auto reasons = reasons_in_boundary(problem); !reasons.empty()) return reasons;
  const Network network = make_network(problem, lenient_limits());
  std::vector<Pick> picks;
  for (const ProblemFace& face : problem.faces)
    picks.emplace_back(face.id, states_of(roles.at(face.id.index)));
  const SearchResult result =
      search_states(network, start_of(network, picks), SearchOptions{}, context);
  if (result.divisions.empty()) return reasons_of_failure(network, result, context);
  return to_scheme(network, result.divisions.front(), model.n_faces(), model.n_edges());
}

}  // namespace sweepmesh
