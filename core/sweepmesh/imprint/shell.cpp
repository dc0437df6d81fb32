#include "sweepmesh/imprint/shell.h"

#include <algorithm>
#include <map>

#include "sweepmesh/imprint/axial_edges.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/reference.h"
#include "sweepmesh/imprint/shell_carried.h"
#include "sweepmesh/imprint/shell_cuts.h"
#include "sweepmesh/imprint/sweep_levels.h"
#include "sweepmesh/imprint/sweep_path.h"
#include "sweepmesh/imprint/vector_area.h"
#include "sweepmesh/surface/cap_boundary.h"

namespace sweepmesh {
namespace {

bool has_seam(const Model& model, FaceId face) {
  for (const Loop& loop : model.loops(face))
    if (std::any_of(loop.begin(), loop.end(), [](const Coedge& c) { return c.seam; })) return true;
  return false;
}

std::vector<std::string> caps_of(const Scheme& scheme) {
  std::vector<std::string> names;
  for (const FaceRole role : {FaceRole::source, FaceRole::target})
    for (const FaceId f : scheme.faces_with(role)) names.push_back(name_of(f));
  return names;
}

/// Whether some axial edge leans far away from a direction: seen along that, caps are
/// foreshortened.
bool is_fanned_out(const Model& model, const Scheme& scheme, const Point3& direction) {
  constexpr double least_cosine = 0.7071;  // 45 degrees
  return std::any_of(model.edges().begin(), model.edges().end(), [&](EdgeId e) {
    const Point3 chord = model.point(model.end(e)) - model.point(model.start(e));
    return scheme.edge_role[e.index] == EdgeRole::axial &&
           std::abs(chord.dot(direction)) < least_cosine * chord.norm();
  });
}

/// Whether some cap stands nearly on edge, seen along a direction: a wall's that turns aside.
bool has_cap_on_edge(const Model& model, const Scheme& scheme, const Point3& direction) {
  constexpr double least_cosine = 0.5;  // 60 degrees
  return std::ranges::any_of(scheme.faces_with(FaceRole::source), [&](FaceId f) {
    return std::abs(vector_area(model, f).dot(direction)) < least_cosine * model.area(f);
  });
}

/// Whether all sources lie at one level, and all targets at one below it.
bool is_one_slab(const std::vector<int>& level) {
  return *std::ranges::max_element(level) == 1;
}

/// Whether all axial edges rise along a path that turns.
bool has_common_path(const Model& model, const Scheme& scheme) {
  const auto path = sweep_path(model, scheme);
  return path && std::ranges::all_of(axial_edges(model, scheme), [&](const AxialEdge& e) {
           return path->straightened(model.point(e.low)).z() <
                  path->straightened(model.point(e.high)).z();
         });
}

class Builder {
 public:
  Builder(const Model& model, const ShellMatch& match) : model_(model), match_(match) {}

  Shell build() {
    for (const EdgePair& pair : match_.edges) add_edge(pair);
    for (const FacePair& pair : match_.faces) add_patch(pair);
    return std::move(shell_);
  }

 private:
  int vertex_at(VertexId v) {
    const auto [at, is_new] = vertex_.emplace(v, shell_.n_vertices);
    shell_.n_vertices += is_new;
    return at->second;
  }

  void add_edge(const EdgePair& pair) {
    edge_[pair.source] = static_cast<int>(shell_.edges.size());
    ShellEdge edge;
    edge.start = vertex_at(model_.start(pair.source));
    edge.end = vertex_at(model_.end(pair.source));
    edge.high.edge = pair.source;
    edge.low.edge = pair.target;
    edge.low.is_reversed = pair.is_reversed;
    shell_.edges.push_back(edge);
  }

  void add_patch(const FacePair& pair) {
    ShellPatch patch{pair.source, pair.target, {}};
    for (const Loop& loop : bounding_loops(model_, pair.source)) {
      patch.loops.emplace_back();
      for (const Coedge& c : loop) patch.loops.back().push_back({edge_.at(c.edge), c.reversed});
    }
    shell_.patches.push_back(std::move(patch));
  }

  const Model& model_;
  const ShellMatch& match_;
  Shell shell_;
  std::map<VertexId, int> vertex_;
  std::map<EdgeId, int> edge_;
};

}  // namespace

bool is_shell_like(const Model& model, const Scheme& scheme) {
  const auto sources = scheme.faces_with(FaceRole::source),
             targets = scheme.faces_with(FaceRole::target);
  if (sources.size() == 1 && targets.size() == 1)
    return has_seam(model, sources[0]) && has_seam(model, targets[0]);
  const std::vector<int> level = sweep_levels(model, scheme);
  const auto directions = common_directions(model, scheme, level);
  if (directions.empty())
    return !has_common_path(model, scheme) || match_caps(model, scheme).has_value();
  const Point3& up = directions.front();
  const bool is_turned = is_fanned_out(model, scheme, up) ||
                         (is_one_slab(level) && has_cap_on_edge(model, scheme, up));
  return is_turned && match_caps(model, scheme).has_value();
}

bool may_be_shell(const Model& model, const Scheme& scheme) {
  return !is_shell_like(model, scheme) || match_caps(model, scheme) || carried_shell(model, scheme);
}

Shell find_shell(const Model& model, const Scheme& scheme, const Context& context) {
  context.check("imprint");
  const auto match = match_caps(model, scheme);
  if (!match) {
    if (auto carried = carried_shell(model, scheme)) return std::move(*carried);
    throw ImprintError(ImprintFailure::unreachable,
                       "The columns of the sweep do not run along one direction, and its sources "
                       "are not divided into faces as its targets are.",
                       caps_of(scheme));
  }
  Shell shell = Builder(model, *match).build();
  const int n = static_cast<int>(shell.patches.size());
  for (int p = 0; p < n; ++p) cut_patch(model, false, p, shell);
  return shell;
}

}  // namespace sweepmesh
