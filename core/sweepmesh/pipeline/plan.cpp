#include "sweepmesh/pipeline/plan.h"

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/divided_sweep.h"
#include "sweepmesh/pipeline/fold_verdict.h"
#include "sweepmesh/pipeline/layout.h"

namespace sweepmesh {
namespace {

std::vector<CornerType> corners_of(const Model& model, const Scheme& scheme) {
  std::vector<CornerType> out;
  for (const FaceId face : scheme.faces_with(FaceRole::linking)) {
    const auto& loops = model.loops(face);
    const auto& types = scheme.face[face.index].type;
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c)
        out.push_back({face, loops[l][c].end, types[l][c], model.point(loops[l][c].end)});
  }
  return out;
}

std::vector<EdgeDirection> directions_of(const Model& model, const Scheme& scheme,
                                         const Intervals& intervals) {
  std::vector<EdgeDirection> out;
  for (const FaceId face : scheme.faces_with(FaceRole::linking)) {
    const auto& loops = model.loops(face);
    const auto& direction = scheme.face[face.index].direction;
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t i = 0; i < loops[l].size(); ++i) {
        const Coedge& c = loops[l][i];
        out.push_back({face, c.edge, direction[l][i], c.reversed, model.point(c.start),
                       model.point(c.end), intervals.edge[c.edge.index]});
      }
  }
  return out;
}

std::vector<Points> points_of(const Model& model, const EdgeNodes& nodes) {
  std::vector<Points> out(nodes.t.size());
  for (const EdgeId edge : model.edges()) {
    const auto& t = nodes.t[edge.index];
    out[edge.index].resize(static_cast<Eigen::Index>(t.size()), 3);
    for (std::size_t n = 0; n < t.size(); ++n)
      out[edge.index].row(static_cast<Eigen::Index>(n)) = model.point(edge, t[n]);
  }
  return out;
}

/// Seams of caps have no mesh edges where no patch ends at them (`used`): the mesh passes over
/// them.
void forget_seams(const Scheme& scheme, const std::set<EdgeId>& used, SweepPlan& plan) {
  for (std::size_t e = 0; e < plan.edge_nodes.size(); ++e) {
    if (scheme.edge_role[e] != EdgeRole::none || used.contains(EdgeId{e})) continue;
    if (plan.intervals.edge[e] <= 1) continue;
    plan.intervals.edge[e] = 0;
    plan.edge_nodes[e].resize(0, 3);
  }
}

/// CAD edges that patches end at.
std::set<EdgeId> used_edges(const Model& model, const CapMatch& match) {
  std::set<EdgeId> out;
  if (const auto* shell = std::get_if<Shell>(&match))
    for (const ShellEdge& e : shell->edges) out.insert({e.high.edge, e.low.edge});
  if (const auto* imprint = std::get_if<Imprint>(&match))
    for (const EdgeId e : model.edges())
      if (!imprint->chain[e.index].empty()) out.insert(e);
  return out;
}

/// Of the best scheme of plan.assessment.
void fill_best(const Model& model, const SweepOptions& options, Context& context, SweepPlan& plan) {
  const Scheme& scheme = plan.assessment.schemes.front();
  plan.corners = corners_of(model, scheme);
  const IntervalOptions intervals = interval_options(model, options, plan.size);
  auto [match, counts] = lay_out(model, scheme, options, plan.size, context);
  plan.edge_nodes = points_of(model, nodes_on_edges(model, scheme, match, counts, intervals));
  plan.intervals = std::move(counts.intervals);
  forget_seams(scheme, used_edges(model, match), plan);
  plan.directions = directions_of(model, scheme, plan.intervals);
}

/// Of the first scheme whose intervals can be had, as sweep() does; that is then the best. Throws
/// the first error where there is none.
void fill(const Model& model, const SweepOptions& options, Context& context, SweepPlan& plan) {
  auto& schemes = plan.assessment.schemes;
  std::exception_ptr first_error;
  for (const std::size_t s : tries(schemes.size())) try {
      std::rotate(schemes.begin(), schemes.begin() + s, schemes.begin() + s + 1);
      return fill_best(model, options, context, plan);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error&) {
      if (!first_error) first_error = std::current_exception();
      std::rotate(schemes.begin(), schemes.begin() + 1, schemes.begin() + s + 1);
    }
  std::rethrow_exception(first_error);
}

/// Empty where the solid cannot be divided, or swept so.
std::optional<SweepPlan> plan_of_divided(const Model& model, RoundDivision& division, Strain strain,
                                         double size, Context& context) {
  const auto divided = division.to_sweep(strain, context);
  if (!divided) return {};
  SweepPlan plan;
  plan.size = size;
  plan.assessment = divided->assessment;
  fill(divided->parts.model, divided->options, context, plan);
  return of_whole(model, divided->parts, plan);
}

/// With schemes of poor angles that can be laid out, of the solid as it is or divided.
SweepPlan plan_of_strained(const Model& model, RoundDivision& division, const SweepOptions& options,
                           Context& context, SweepPlan plan) {
  accept_strained(model, options, context, plan.assessment);
  if (plan.assessment.is_sweepable()) {
    fill(model, options, context, plan);
    return plan;
  }
  auto divided = plan_of_divided(model, division, Strain::accepted, plan.size, context);
  return divided ? *divided : plan;
}

/// As assess_or_divide goes.
SweepPlan plan_of_unsweepable(const Model& model, const Picks& picks, const SweepOptions& options,
                              Context& context, SweepPlan plan) {
  if (!may_be_divided(plan.assessment)) return plan;
  RoundDivision division(model, picks, options);
  if (auto divided = plan_of_divided(model, division, Strain::refused, plan.size, context))
    return *divided;
  return plan_of_strained(model, division, options, context, std::move(plan));
}

}  // namespace

SweepPlan plan_sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                     Context& context) {
  check_options(options);
  check_picks(picks);
  SweepPlan plan;
  plan.size = options.size.value_or(default_size(model));
  refuse_explosion(model, options, plan.size);
  plan.assessment = assess_with_shape(model, picks, context);
  if (!plan.assessment.is_sweepable())
    return plan_of_unsweepable(model, picks, options, context, std::move(plan));
  try {
    fill(model, options, context, plan);
    return plan;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    RoundDivision division(model, picks, options);
    if (auto divided = plan_of_divided(model, division, Strain::refused, plan.size, context))
      return *divided;
    if (!is_free(picks) || !is_fault_of_layout(error)) throw;
    const std::vector<Scheme> regular = std::move(plan.assessment.schemes);
    plan.assessment = without_layout(error);
    plan.assessment.strained = schemes_beside(model, regular, context);
    return plan_of_strained(model, division, options, context, std::move(plan));
  }
}

}  // namespace sweepmesh
