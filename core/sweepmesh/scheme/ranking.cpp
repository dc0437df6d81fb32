#include "sweepmesh/scheme/ranking.h"

#include <algorithm>
#include <tuple>

#include "sweepmesh/scheme/distortion.h"
#include "sweepmesh/scheme/to_scheme.h"

namespace sweepmesh {
namespace {

int count(const Division& division, StateSet role) {
  return static_cast<int>(
      std::count(division.choices.role.begin(), division.choices.role.end(), role));
}

/// Caps that were not picked, where sources and targets were; else 0.
int n_unasked_caps(const Division& division, const std::vector<Pick>& picks) {
  if (!has_picked(picks, kSourceStates) || !has_picked(picks, kTargetStates)) return 0;
  return count(division, kSourceStates) + count(division, kTargetStates) -
         static_cast<int>(picks.size());
}

}  // namespace

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

std::size_t n_caps(const Scheme& scheme) {
  return scheme.faces_with(FaceRole::source).size() + scheme.faces_with(FaceRole::target).size();
}

bool has_same_caps(const Scheme& a, const Scheme& b) {
  for (std::size_t f = 0; f < a.face_role.size(); ++f)
    if ((a.face_role[f] == FaceRole::linking) != (b.face_role[f] == FaceRole::linking))
      return false;
  return true;
}

}  // namespace sweepmesh
