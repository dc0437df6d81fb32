#include "sweepmesh/pipeline/divided_sweep.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sweepmesh/pipeline/fold_verdict.h"
#include "sweepmesh/pipeline/layout.h"
#include "sweepmesh/scheme/round_cuts.h"

namespace sweepmesh {
namespace {

std::vector<FaceCut> all_of(const std::vector<CutGroup>& groups) {
  std::vector<FaceCut> out;
  for (const CutGroup& group : groups) out.insert(out.end(), group.begin(), group.end());
  return out;
}

/// A piece of an edge, and whether it runs against it.
struct Piece {
  EdgeId id;
  bool reversed = false;
  double t = 0.0;  ///< of its middle, on the whole edge
};

/// By edge of the whole: its pieces, from its start to its end.
std::vector<std::vector<Piece>> pieces_of(const Model& model, const DividedModel& parts) {
  const auto middle = [&](EdgeId e) {
    const auto [first, last] = parts.model.range(e);
    return std::pair{0.5 * (first + last), parts.model.point(e, 0.5 * (first + last))};
  };
  std::vector<std::vector<Piece>> out(model.n_edges());
  for (const EdgeId e : parts.model.edges()) {
    const EdgeId whole = parts.edge[e.index];
    if (!whole.is_valid()) continue;
    const auto [t, p] = middle(e);
    const double on_whole = model.project(whole, p);
    const bool is_against = model.tangent(whole, on_whole).dot(parts.model.tangent(e, t)) < 0;
    out[whole.index].push_back({e, is_against, on_whole});
  }
  for (auto& pieces : out) std::ranges::sort(pieces, {}, &Piece::t);
  return out;
}

std::vector<FaceId> parts_of(const DividedModel& parts, FaceId face) {
  std::vector<FaceId> out;
  for (const FaceId f : parts.model.faces())
    if (parts.face[f.index] == face) out.push_back(f);
  return out;
}

bool has_vertex(const Model& model, FaceId face, VertexId vertex) {
  for (const Loop& loop : model.loops(face))
    for (const Coedge& c : loop)
      if (c.start == vertex) return true;
  return false;
}

void add_types(const DividedModel& parts, const TypePick& pick, std::vector<TypePick>& out) {
  for (const VertexId v : parts.model.vertices())
    if (parts.vertex[v.index] == pick.vertex)
      for (const FaceId f : parts_of(parts, pick.face))
        if (has_vertex(parts.model, f, v)) out.push_back({f, v, pick.type});
}

Picks picks_of_parts(const DividedModel& parts, const Picks& picks) {
  Picks out;
  const auto add = [&](FaceId face, std::vector<FaceId>& to) {
    const auto pieces = parts_of(parts, face);
    to.insert(to.end(), pieces.begin(), pieces.end());
  };
  for (const FaceId face : picks.sources) add(face, out.sources);
  for (const FaceId face : picks.targets) add(face, out.targets);
  for (const auto& [source, target] : picks.pairs) {
    const auto from = parts_of(parts, source), to = parts_of(parts, target);
    if (from.size() == 1 && to.size() == 1) {
      out.pairs.emplace_back(from.front(), to.front());
    } else {
      add(source, out.sources);
      add(target, out.targets);
    }
  }
  for (const TypePick& pick : picks.types) add_types(parts, pick, out.types);
  return out;
}

/// Shares of a number in proportion to lengths, at least one each.
std::vector<int> shares_of(int count, const std::vector<double>& lengths) {
  std::vector<int> out;
  double total = 0.0, left = count;
  for (const double length : lengths) total += length;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double rest = static_cast<double>(lengths.size() - i - 1);
    const double share =
        std::clamp(std::round(left * lengths[i] / total), 1.0, std::max(1.0, left - rest));
    out.push_back(static_cast<int>(share));
    left -= share;
    total -= lengths[i];
  }
  return out;
}

/// A bias is of a whole edge: a divided one is spaced evenly.
SweepOptions options_of_parts(const Model& model, const DividedModel& parts,
                              const SweepOptions& options) {
  SweepOptions out = options;
  out.edge_size.clear();
  out.edge_count.clear();
  out.edge_bias.clear();
  const auto pieces = pieces_of(model, parts);
  for (const auto& [edge, size] : options.edge_size)
    for (const Piece& p : pieces[edge.index]) out.edge_size[p.id] = size;
  for (const auto& [edge, count] : options.edge_count) {
    std::vector<double> lengths;
    for (const Piece& p : pieces[edge.index]) lengths.push_back(parts.model.length(p.id));
    const auto shares = shares_of(count, lengths);
    for (std::size_t i = 0; i < shares.size(); ++i)
      out.edge_count[pieces[edge.index][i].id] = shares[i];
  }
  for (const auto& [edge, bias] : options.edge_bias)
    if (pieces[edge.index].size() == 1) {
      const Piece& only = pieces[edge.index].front();
      const bool turns = only.reversed && !bias.symmetric;
      out.edge_bias[only.id] = {turns ? 1 / bias.ratio : bias.ratio, bias.symmetric};
    }
  return out;
}

/// Whether a scheme turns, or changes the role of faces, at an edge that is a cut.
bool is_used(const DividedModel& parts, const Scheme& scheme, EdgeId cut) {
  const auto& uses = parts.model.coedges(cut);
  if (scheme.face_role[uses[0].face.index] != scheme.face_role[uses[1].face.index]) return true;
  for (const FaceId f : scheme.faces_with(FaceRole::linking)) {
    const auto& loops = parts.model.loops(f);
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c) {
        const VertexId v = loops[l][c].end;
        const bool is_end = v == parts.model.start(cut) || v == parts.model.end(cut);
        const bool is_corner = scheme.face[f.index].type[l][c] != VertexType::side;
        if (is_end && is_corner && f != uses[0].face && f != uses[1].face) return true;
      }
  }
  return false;
}

std::set<std::size_t> used_groups(const Model& model, const DividedModel& parts,
                                  const Scheme& scheme, const std::vector<CutGroup>& groups) {
  std::set<std::size_t> used;
  for (const EdgeId e : parts.model.edges()) {
    if (parts.edge[e.index].is_valid() || !is_used(parts, scheme, e)) continue;
    const auto [first, last] = parts.model.range(e);
    const Point3 middle = parts.model.point(e, 0.5 * (first + last));
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t owner = 0;
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const FaceCut& cut : groups[g]) {
        if (cut.face != parts.edge_face[e.index]) continue;
        const double d = (model.point(cut.face, 0.5 * (cut.from + cut.to)) - middle).norm();
        if (d < nearest) nearest = d, owner = g;
      }
    used.insert(owner);
  }
  return used;
}

/// With the verdict on the parts, sweepable or not.
DividedSweep divided_by(const Model& model, const std::vector<CutGroup>& groups, const Picks& picks,
                        const SweepOptions& options, Context& context) {
  DividedModel parts = divide_model(model, all_of(groups));
  const Picks own = picks_of_parts(parts, picks);
  SweepOptions wishes = options_of_parts(model, parts, options);
  Assessment assessment = assess(parts.model, own, context);
  if (is_free(picks)) keep_laid_out(parts.model, wishes, context, assessment);
  return {std::move(parts), own, std::move(wishes), std::move(assessment)};
}

/// Whether it can be swept after all.
bool accept(DividedSweep& divided, Strain strain, Context& context) {
  if (strain == Strain::accepted)
    accept_strained(divided.parts.model, divided.options, context, divided.assessment);
  return divided.assessment.is_sweepable();
}

}  // namespace

bool may_be_divided(const Assessment& whole) {
  return !whole.folds;
}

void RoundDivision::divide(Context& context) {
  is_known_ = true;
  groups_ = round_cuts(model_);
  if (!groups_.empty()) all_ = divided_by(model_, groups_, picks_, options_, context);
}

std::optional<DividedSweep> RoundDivision::swept(Strain strain, Context& context) {
  if (!is_known_) divide(context);
  is_made_.clear();
  scheme_ = 0;
  if (!all_ || !accept(*all_, strain, context)) return {};
  auto least = divided_as(all_->assessment.schemes[scheme_++], strain, context);
  return least ? std::move(least) : all_;
}

/// Empty where these cuts were made before, or are all of them or none.
std::optional<DividedSweep> RoundDivision::divided_as(const Scheme& scheme, Strain strain,
                                                      Context& context) {
  const auto used = used_groups(model_, all_->parts, scheme, groups_);
  if (!is_made_.insert(used).second || used.empty() || used.size() == groups_.size()) return {};
  std::vector<CutGroup> cuts;
  for (const std::size_t g : used) cuts.push_back(groups_[g]);
  DividedSweep out = divided_by(model_, cuts, picks_, options_, context);
  if (!accept(out, strain, context)) return {};
  return out;
}

std::optional<DividedSweep> RoundDivision::other(Strain strain, Context& context) try {
  while (all_ && scheme_ < all_->assessment.schemes.size())
    if (auto out = divided_as(all_->assessment.schemes[scheme_++], strain, context)) return out;
  return {};
} catch (const Cancelled&) {
  throw;
} catch (const Error&) {
  return {};
}

std::optional<DividedSweep> RoundDivision::to_sweep(Strain strain, Context& context) try {
  return swept(strain, context);
} catch (const Cancelled&) {
  throw;
} catch (const Error&) {
  return {};  // the solid stays what it is without being divided
}

Assessment assess_or_divide(const Model& model, const Picks& picks, Context& context) {
  Assessment whole = assess_with_shape(model, picks, context);
  const std::vector<Scheme> regular = whole.schemes;
  if (is_free(picks)) refuse_without_layout(model, context, whole);
  if (whole.is_sweepable() || !may_be_divided(whole)) return whole;
  const SweepOptions options;
  RoundDivision division(model, picks, options);
  const auto divided = [&](Strain strain) -> std::optional<Assessment> {
    const auto found = division.to_sweep(strain, context);
    if (!found) return {};
    return of_whole(model, found->parts, found->assessment);
  };
  if (auto found = divided(Strain::refused)) return *found;
  if (!regular.empty()) whole.strained = schemes_beside(model, regular, context);
  accept_strained(model, options, context, whole);
  if (whole.is_sweepable()) return whole;
  return divided(Strain::accepted).value_or(whole);
}

// --- back ----------------------------------------------------------------------------------------

namespace {

template <class Role>
void merge_role(Role role, Role none, Role divided, Role& into) {
  if (role == none) return;
  into = into == none || into == role ? role : divided;
}

Scheme whole_scheme(const Model& model, const DividedModel& parts, const Scheme& scheme) {
  Scheme out;
  out.cost = scheme.cost;
  out.face_role.assign(model.n_faces(), FaceRole::none);
  out.edge_role.assign(model.n_edges(), EdgeRole::none);
  out.face.resize(model.n_faces());
  for (const FaceId f : parts.model.faces())
    merge_role(scheme.face_role[f.index], FaceRole::none, FaceRole::divided,
               out.face_role[parts.face[f.index].index]);
  for (const EdgeId e : parts.model.edges())
    if (parts.edge[e.index].is_valid())
      merge_role(scheme.edge_role[e.index], EdgeRole::none, EdgeRole::divided,
                 out.edge_role[parts.edge[e.index].index]);
  return out;
}

Points joined(const std::vector<Piece>& pieces, const std::vector<Points>& nodes) {
  Points out;
  for (const Piece& piece : pieces) {
    Points part = nodes[piece.id.index];
    if (piece.reversed) part = part.colwise().reverse().eval();
    const Eigen::Index kept = out.rows() > 0 ? out.rows() - 1 : 0;
    out.conservativeResize(kept + part.rows(), 3);
    out.bottomRows(part.rows()) = part;
  }
  return out;
}

Owner whole_owner(const DividedModel& parts, const Owner& owner) {
  if (owner.index < 0) return owner;
  const auto of_face = [](FaceId f) { return Owner{EntityKind::face, f.index}; };
  const auto of_edge = [](EdgeId e) { return Owner{EntityKind::edge, e.index}; };
  if (owner.kind == EntityKind::face) return of_face(parts.face[owner.index]);
  if (owner.kind == EntityKind::edge) {
    const EdgeId edge = parts.edge[owner.index];
    return edge.is_valid() ? of_edge(edge) : of_face(parts.edge_face[owner.index]);
  }
  const VertexId vertex = parts.vertex[owner.index];
  return vertex.is_valid() ? Owner{EntityKind::vertex, vertex.index}
                           : of_edge(parts.vertex_edge[owner.index]);
}

}  // namespace

Assessment of_whole(const Model& model, const DividedModel& parts, const Assessment& assessment) {
  Assessment out;
  for (const Scheme& scheme : assessment.schemes)
    out.schemes.push_back(whole_scheme(model, parts, scheme));
  return out;
}

Intervals of_whole(const Model& model, const DividedModel& parts, const Intervals& intervals) {
  Intervals out = intervals;
  out.edge.assign(model.n_edges(), 0);
  out.k.assign(model.n_vertices(), -1);
  out.loop_i.assign(model.n_faces(), {});
  for (const EdgeId e : parts.model.edges())
    if (parts.edge[e.index].is_valid())
      out.edge[parts.edge[e.index].index] += intervals.edge[e.index];
  for (const VertexId v : parts.model.vertices())
    if (parts.vertex[v.index].is_valid()) out.k[parts.vertex[v.index].index] = intervals.k[v.index];
  return out;
}

SweepPlan of_whole(const Model& model, const DividedModel& parts, const SweepPlan& plan) {
  SweepPlan out{of_whole(model, parts, plan.assessment),
                plan.size,
                of_whole(model, parts, plan.intervals),
                plan.corners,
                plan.directions,
                {}};
  for (CornerType& corner : out.corners) {
    corner.face = parts.face[corner.face.index];
    corner.edge = parts.vertex_edge[corner.vertex.index];
    corner.vertex = parts.vertex[corner.vertex.index];
  }
  const auto pieces = pieces_of(model, parts);
  std::vector<char> is_against(parts.edge.size(), 0);
  for (const auto& of_edge : pieces)
    for (const Piece& piece : of_edge) is_against[piece.id.index] = piece.reversed;
  for (EdgeDirection& d : out.directions) {
    d.reversed = d.reversed != is_against[d.edge.index];
    d.face = parts.face[d.face.index];
    d.edge = parts.edge[d.edge.index];
  }
  for (const auto& of_edge : pieces) out.edge_nodes.push_back(joined(of_edge, plan.edge_nodes));
  return out;
}

VolumeMesh of_whole(const DividedModel& parts, VolumeMesh mesh) {
  for (Owner& owner : mesh.owner) owner = whole_owner(parts, owner);
  for (FaceId& face : mesh.boundary_face) face = parts.face[face.index];
  return mesh;
}

}  // namespace sweepmesh
