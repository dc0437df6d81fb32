#include "sweepmesh/pipeline/sweep_solids.h"

#include <algorithm>

#include "sweepmesh/pipeline/divided_sweep.h"
#include "sweepmesh/pipeline/merge_meshes.h"
#include "sweepmesh/pipeline/touching_sweep.h"

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

template <class T>
void append(const std::vector<T>& from, std::vector<T>& into) {
  into.insert(into.end(), from.begin(), from.end());
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

void append_result(SweepResult&& part, SweepResult& all) {
  append_intervals(part.intervals, all.intervals);
  append(part.warnings, all.warnings);
  append(part.coverage, all.coverage);
  for (const auto& [stage, seconds] : part.seconds) all.seconds[stage] += seconds;
}

/// Of a solid that was meshed together with others.
void add_coverage(const Model& model, SweepResult& part) {
  part.coverage = face_coverage(model, face_areas(model), part.mesh);
  append(coverage_warnings(part.coverage), part.warnings);
}

void warn_of_overlaps(const std::vector<Model>& solids, const Contacts& contacts,
                      std::vector<std::string>& warnings) {
  for (const Overlap& o : overlapping_faces(solids, contacts))
    warnings.push_back(name_of(o.face) + " of solid " + std::to_string(o.solid + 1) + " and " +
                       name_of(o.other_face) + " of solid " + std::to_string(o.other + 1) +
                       " lie on each other in part, and the meshes share no nodes there; divide "
                       "the solids at each other with BooleanFragments to get one mesh.");
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
  std::vector<Picks> own;
  for (const Model& solid : solids) own.push_back(picks_on(solid, picks));
  SweepResult all;
  all.size = options.size.value_or(smallest_default_size(solids));
  const Contacts contacts = find_contacts(solids);
  TouchingSweep touching = sweep_touching(solids, own, options, all.size, contacts, context);
  std::vector<Assessment> verdicts;
  std::vector<VolumeMesh> meshes;
  for (std::size_t s = 0; s < solids.size(); ++s) {
    SweepResult& part = touching.parts[s];
    if (part.coverage.empty() && part.mesh.n_elements() > 0) add_coverage(solids[s], part);
    verdicts.push_back(std::move(part.assessment));
    meshes.push_back(std::move(part.mesh));
    append_result(std::move(part), all);
  }
  all.assessment = merged_verdicts(verdicts);
  if (!all.assessment.is_sweepable()) return all;
  all.mesh = merged(std::move(meshes), contacts, touching.met, merge_tolerance(solids));
  append(touching.warnings, all.warnings);
  warn_of_overlaps(solids, contacts, all.warnings);
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
