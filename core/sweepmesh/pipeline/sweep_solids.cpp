#include "sweepmesh/pipeline/sweep_solids.h"

#include <algorithm>

#include "sweepmesh/pipeline/divided_sweep.h"

namespace sweepmesh {
namespace {

bool has_face(const Model& model, FaceId face) {
  return std::binary_search(model.faces().begin(), model.faces().end(), face);
}

void merge_scheme(const Scheme& from, Scheme& into) {
  for (std::size_t f = 0; f < from.face_role.size(); ++f)
    if (from.face_role[f] != FaceRole::none) {
      into.face_role[f] = from.face_role[f];
      into.face[f] = from.face[f];
    }
  for (std::size_t e = 0; e < from.edge_role.size(); ++e)
    if (from.edge_role[e] != EdgeRole::none) into.edge_role[e] = from.edge_role[e];
  into.cost += from.cost;
}

template <class Item>
void append_shifted(const std::vector<Item>& from, int shift, std::vector<Item>& into) {
  for (Item item : from) {
    if constexpr (std::is_same_v<Item, int>)
      item += shift;
    else
      for (int& node : item) node += shift;
    into.push_back(item);
  }
}

template <class T>
void append(const std::vector<T>& from, std::vector<T>& into) {
  into.insert(into.end(), from.begin(), from.end());
}

void append_mesh(const VolumeMesh& from, VolumeMesh& into) {
  const int shift = static_cast<int>(into.points.rows());
  into.points.conservativeResize(shift + from.points.rows(), 3);
  into.points.bottomRows(from.points.rows()) = from.points;
  append_shifted(from.hexahedra, shift, into.hexahedra);
  append_shifted(from.prisms, shift, into.prisms);
  append_shifted(from.hexahedron_mid_nodes, shift, into.hexahedron_mid_nodes);
  append_shifted(from.prism_mid_nodes, shift, into.prism_mid_nodes);
  append_shifted(from.boundary_nodes, shift, into.boundary_nodes);
  append_shifted(from.boundary_mid_nodes, shift, into.boundary_mid_nodes);
  const int boundary_shift = into.boundary_offset.back();
  for (std::size_t c = 1; c < from.boundary_offset.size(); ++c)
    into.boundary_offset.push_back(from.boundary_offset[c] + boundary_shift);
  append(from.boundary_face, into.boundary_face);
  append(from.owner, into.owner);
}

void append_intervals(const Intervals& from, Intervals& into) {
  into.edge.resize(from.edge.size());
  into.k.resize(from.k.size(), -1);
  for (std::size_t e = 0; e < from.edge.size(); ++e)
    into.edge[e] = std::max(into.edge[e], from.edge[e]);
  for (std::size_t v = 0; v < from.k.size(); ++v) into.k[v] = std::max(into.k[v], from.k[v]);
  into.n_layers = std::max(into.n_layers, from.n_layers);
  into.is_optimal = into.is_optimal && from.is_optimal;
}

bool boxes_touch(const Model& a, const Model& b) {
  const auto [low_a, high_a] = a.bounding_box();
  const auto [low_b, high_b] = b.bounding_box();
  const double gap = a.tolerances().point + b.tolerances().point;
  return ((low_a - high_b).array() <= gap).all() && ((low_b - high_a).array() <= gap).all();
}

bool any_touch(const std::vector<Model>& solids) {
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t j = i + 1; j < solids.size(); ++j)
      if (boxes_touch(solids[i], solids[j])) return true;
  return false;
}

void append_result(SweepResult&& part, SweepResult& all) {
  append_mesh(part.mesh, all.mesh);
  append_intervals(part.intervals, all.intervals);
  append(part.warnings, all.warnings);
  for (const auto& [stage, seconds] : part.seconds) all.seconds[stage] += seconds;
}

}  // namespace

Picks picks_on(const Model& model, const Picks& picks) {
  Picks own;
  const auto keep = [&](const std::vector<FaceId>& from, std::vector<FaceId>& to) {
    std::copy_if(from.begin(), from.end(), std::back_inserter(to),
                 [&](FaceId f) { return has_face(model, f); });
  };
  keep(picks.sources, own.sources);
  keep(picks.targets, own.targets);
  for (const auto& pair : picks.pairs)
    if (has_face(model, pair.first) && has_face(model, pair.second)) own.pairs.push_back(pair);
  for (const TypePick& pick : picks.types)
    if (has_face(model, pick.face)) own.types.push_back(pick);
  return own;
}

void check_pairs(const std::vector<Model>& solids, const Picks& picks) {
  for (const auto& [source, target] : picks.pairs)
    if (std::none_of(solids.begin(), solids.end(),
                     [&](const Model& m) { return has_face(m, source) && has_face(m, target); }))
      throw InputError("options",
                       name_of(source) + " and " + name_of(target) + " are not of one solid.",
                       {name_of(source), name_of(target)});
}

Assessment merged_verdicts(const std::vector<Assessment>& parts) {
  Assessment all;
  for (std::size_t s = 0; s < parts.size(); ++s)
    for (Reason reason : parts[s].reasons) {
      reason.text = "Solid " + std::to_string(s + 1) + ": " + reason.text;
      all.reasons.push_back(std::move(reason));
    }
  if (!all.reasons.empty()) return all;
  all.schemes.push_back(parts.front().schemes.front());
  for (std::size_t s = 1; s < parts.size(); ++s)
    merge_scheme(parts[s].schemes.front(), all.schemes.front());
  return all;
}

double smallest_default_size(const std::vector<Model>& solids) {
  double size = default_size(solids.front());
  for (const Model& solid : solids) size = std::min(size, default_size(solid));
  return size;
}

std::vector<Model> solids_of(const Model& model) {
  std::vector<Model> solids;
  for (int s = 0; s < model.n_solids(); ++s) solids.push_back(model.of_solid(s));
  return solids;
}

SweepResult sweep_solids(const std::vector<Model>& solids, const Picks& picks,
                         const SweepOptions& options, Context& context) {
  if (solids.size() == 1) return sweep(solids.front(), picks, options, context);
  check_pairs(solids, picks);
  SweepOptions each = options;
  if (!each.size) each.size = smallest_default_size(solids);
  SweepResult all;
  all.size = *each.size;
  std::vector<Assessment> verdicts;
  for (const Model& solid : solids) {
    SweepResult part = sweep(solid, picks_on(solid, picks), each, context);
    verdicts.push_back(std::move(part.assessment));
    append_result(std::move(part), all);
  }
  all.assessment = merged_verdicts(verdicts);
  if (!all.assessment.is_sweepable()) {
    all.mesh = {};
    return all;
  }
  if (any_touch(solids))
    all.warnings.push_back(
        "The solids are meshed one by one: where they touch they share no nodes.");
  all.quality = measure_quality(all.mesh, {}, context);
  return all;
}

Assessment assess_solids(const std::vector<Model>& solids, const Picks& picks, Context& context) {
  if (solids.size() == 1) return assess_or_divide(solids.front(), picks, context);
  check_pairs(solids, picks);
  std::vector<Assessment> verdicts;
  for (const Model& solid : solids)
    verdicts.push_back(assess_or_divide(solid, picks_on(solid, picks), context));
  return merged_verdicts(verdicts);
}

}  // namespace sweepmesh
