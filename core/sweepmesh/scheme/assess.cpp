#include "sweepmesh/scheme/assess.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/scheme/distortion.h"
#include "sweepmesh/scheme/pairs.h"
#include "sweepmesh/scheme/prismatic.h"
#include "sweepmesh/scheme/reasons.h"
#include "sweepmesh/scheme/role_search.h"
#include "sweepmesh/scheme/to_scheme.h"
#include "sweepmesh/scheme/vertex_types.h"

namespace sweepmesh {

namespace {

/// Costs up to which schemes are looked for, one after the other until one is found: with a low
/// limit most choices are ruled out at once.
constexpr std::array kCostLimits = {2.0, 4.0, 8.0, 16.0, 64.0, kImpossible};

/// Schemes that cost so much more than the best are offered too.
constexpr double kOffered = 2.0;

int index_of(const SweepProblem& problem, FaceId id) {
  const auto at = std::ranges::find(problem.faces, id, &ProblemFace::id);
  if (at == problem.faces.end())
    throw InputError("assess", name_of(id) + " is not a face of this solid.", {name_of(id)});
  return static_cast<int>(at - problem.faces.begin());
}

/// Throws where a vertex is given two types on one face, or a type on a face that is picked as a
/// cap.
void check_types(const Picks& picks) {
  std::set<FaceId> caps(picks.sources.begin(), picks.sources.end());
  caps.insert(picks.targets.begin(), picks.targets.end());
  for (const auto& [source, target] : picks.pairs) caps.insert({source, target});
  std::map<std::pair<FaceId, VertexId>, VertexType> seen;
  for (const TypePick& pick : picks.types) {
    const std::string face = name_of(pick.face), vertex = name_of(pick.vertex);
    const VertexType other = seen.try_emplace({pick.face, pick.vertex}, pick.type).first->second;
    if (other != pick.type)
      throw InputError("assess",
                       vertex + " of " + face + " is given as " + name_of(other) + " and as " +
                           name_of(pick.type) + ".",
                       {vertex, face});
    if (caps.contains(pick.face))
      throw InputError("assess",
                       vertex + " is given a vertex type on " + face +
                           ", which is picked as a source or target: only linking faces have "
                           "vertex types.",
                       {vertex, face});
  }
}

std::vector<FixedCorner> fixed_corners(const SweepProblem& problem,
                                       const std::vector<TypePick>& types) {
  std::vector<FixedCorner> out;
  for (const TypePick& pick : types) {
    const int face = index_of(problem, pick.face), first = problem.first_coedge(face);
    const std::size_t n_before = out.size();
    for (int c = first; c < first + problem.n_coedges(face); ++c)
      if (problem.coedges[c].end == pick.vertex.index) out.push_back({c, pick.type});
    if (out.size() == n_before)
      throw InputError("assess",
                       name_of(pick.vertex) + " is not a vertex of " + name_of(pick.face) + ".",
                       {name_of(pick.vertex), name_of(pick.face)});
  }
  return out;
}

/// A picked face and the states that it may have.
using Pick = std::pair<FaceId, StateSet>;

std::vector<Pick> all_picks(const Picks& picks) {
  std::vector<Pick> out;
  for (FaceId id : picks.sources) out.emplace_back(id, kSourceStates);
  for (FaceId id : picks.targets) out.emplace_back(id, kTargetStates);
  for (const auto& [source, target] : picks.pairs) {
    out.emplace_back(source, kSourceStates);
    out.emplace_back(target, kTargetStates);
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

/// The picked caps, and every face with a picked vertex type as a linking face.
std::vector<Pick> with_types(std::vector<Pick> caps, const std::vector<TypePick>& types) {
  for (const TypePick& pick : types) caps.emplace_back(pick.face, kLinkingStates);
  return caps;
}

bool is_cap(const Pick& pick) {
  return pick.second != kLinkingStates;
}

Choices start_of(const Network& network, const std::vector<Pick>& picks) {
  Choices out = open_choices(network);
  std::vector<int> touched;
  for (const auto& [id, states] : picks)
    set_role(network, out, index_of(network.problem, id), states, touched);
  return out;
}

/// Raises the limit of cost until something is found, then looks once more for what is nearly as
/// good.
SearchResult search(const Network& network, const std::vector<Pick>& picks, Context& context,
                    SearchOptions options = {}) {
  const Choices start = start_of(network, picks);
  options.is_symmetric = std::ranges::none_of(picks, is_cap);
  SearchResult result;
  for (double limit : kCostLimits) {
    options.max_cost = limit;
    result = search_divisions(network, start, options, context);
    options.max_effort -= result.effort;
    if (!result.divisions.empty() || options.max_effort <= 0) break;
  }
  if (result.divisions.empty() || options.max_effort <= 0) return result;
  options.max_cost = std::max(options.max_cost, result.divisions.front().cost + kOffered);
  SearchResult wider = search_divisions(network, start, options, context);
  return wider.is_complete ? wider : result;
}

int count(const Division& division, StateSet role) {
  return static_cast<int>(
      std::count(division.choices.role.begin(), division.choices.role.end(), role));
}

std::size_t n_caps(const Scheme& scheme) {
  return scheme.faces_with(FaceRole::source).size() + scheme.faces_with(FaceRole::target).size();
}

bool has_picked(const std::vector<Pick>& picks, StateSet role) {
  return std::ranges::any_of(picks, [&](const Pick& p) { return p.second == role; });
}

/// Caps that were not picked, where sources and targets were; else 0.
int n_unasked_caps(const Division& division, const std::vector<Pick>& picks) {
  if (!has_picked(picks, kSourceStates) || !has_picked(picks, kTargetStates)) return 0;
  return count(division, kSourceStates) + count(division, kTargetStates) -
         static_cast<int>(picks.size());
}

/// Best first. Where nothing tells sources and targets apart (no picks), the more are the sources.
std::vector<Scheme> ranked(const Model& model, const Network& network,
                           std::vector<Division> divisions, const std::vector<Pick>& picks) {
  std::vector<std::tuple<bool, Rank, std::size_t>> order;
  std::vector<Scheme> schemes;
  for (Division& d : divisions) {
    if (picks.empty() && count(d, kSourceStates) < count(d, kTargetStates)) turn_over(d);
    Scheme scheme = to_scheme(network, d, model.n_faces(), model.n_edges());
    scheme.cost += sweep_distortion(model, scheme);
    Rank rank = rank_of(network, d);
    rank.cost = scheme.cost;
    order.emplace_back(n_unasked_caps(d, picks) > 0, rank, schemes.size());
    schemes.push_back(std::move(scheme));
  }
  std::ranges::sort(order, [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  std::vector<Scheme> out;
  for (const auto& [is_unasked, rank, s] : order) out.push_back(std::move(schemes[s]));
  return out;
}

/// Whether two schemes have the same caps, be it upside down.
bool has_same_caps(const Scheme& a, const Scheme& b) {
  for (std::size_t f = 0; f < a.face_role.size(); ++f)
    if ((a.face_role[f] == FaceRole::linking) != (b.face_role[f] == FaceRole::linking))
      return false;
  return true;
}

/// The picks without each of which the others can be met; all where no single one is to blame.
std::vector<FaceId> blamed_picks(const Network& network, const std::vector<Pick>& picks,
                                 Context& context) {
  std::vector<FaceId> blamed, all;
  SearchOptions brief;
  brief.max_effort /= 4 * static_cast<long>(picks.size());
  for (std::size_t i = 0; i < picks.size(); ++i) {
    std::vector<Pick> others = picks;
    others.erase(others.begin() + i);
    all.push_back(picks[i].first);
    if (!others.empty() && !search(network, others, context, brief).divisions.empty())
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
    if (auto found = try_radial()) {
      if (picks_.types.empty()) return *found;
      return {{}, {type_reason(picks_.types)}};
    }
    return refuse(lenient);
  }

  std::optional<Assessment> try_with(const Network& network, const std::vector<Pick>& picks) {
    SearchResult result = search(network, picks, context_);
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
      add_prismatic(found, fixed);
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

  /// Offers straight sweeps, too: in the order of cost where rounds and fillets are tangent to caps
  /// at worst, else at the end, whatever their angles cost.
  void add_prismatic(Assessment& found, const std::vector<FixedCorner>& fixed) {
    std::vector<Scheme>& schemes = found.schemes;
    for (const Scheme& s : new_prismatic(tangent_limits(), fixed, schemes))
      schemes.insert(std::ranges::upper_bound(schemes, s.cost, {}, &Scheme::cost), s);
    for (const Scheme& s : new_prismatic(lenient_limits(), fixed, schemes))
      if (s.cost >= schemes.back().cost) schemes.push_back(s);
  }

  std::vector<Scheme> new_prismatic(const AngleLimits& limits,
                                    const std::vector<FixedCorner>& fixed,
                                    const std::vector<Scheme>& known) {
    const Network network = make_network(problem_, limits, fixed);
    std::vector<Scheme> out =
        ranked(model_, network, prismatic_divisions(network, context_), chosen_);
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
    return !search(network, with_types(chosen_, types), context_).divisions.empty();
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
    return Assessment{{}, {type_reason(left)}};
  }

  Assessment refuse(const Network& lenient) {
    SearchResult result = search(lenient, {}, context_);
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
      SearchOptions brief;
      brief.max_effort /= 8;
      std::ranges::move(search(lenient, picks, context_, brief).divisions,
                        std::back_inserter(divisions));
    }
    std::vector<Scheme> out;
    for (Scheme& scheme : ranked(model_, lenient, std::move(divisions), {}))
      if (std::ranges::none_of(out, [&](const Scheme& s) { return has_same_caps(s, scheme); }))
        out.push_back(std::move(scheme));
    return out;
  }

  Assessment refuse_picks(const Network& strict, const Network& lenient) {
    SearchResult free = search(strict, {}, context_);
    if (free.divisions.empty()) return refuse(lenient);
    return {
        {},
        {pick_reason(strict, blamed_picks(lenient, chosen_, context_), free.divisions.front())}};
  }

  const Model& model_;
  const Picks& picks_;
  Context& context_;
  SweepProblem problem_;
  std::vector<Pick> chosen_;         ///< caps
  std::vector<Pick> asked_;          ///< and the faces with vertex types
  bool is_strict_complete_ = false;  ///< some search proved that there is nothing
  std::optional<Reason> opposed_;    ///< found within the strict limits, but for walls
};

}  // namespace

Assessment assess(const Model& model, const Picks& picks, Context& context) {
  return Assessor(model, picks, context).assess();
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
