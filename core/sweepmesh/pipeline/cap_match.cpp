#include "sweepmesh/pipeline/cap_match.h"

#include <string>
#include <utility>

#include "sweepmesh/imprint/imprint_counts.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/pipeline/shell_boundary.h"
#include "sweepmesh/surface/linking_columns.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/linking_faces.h"

namespace sweepmesh {
namespace {

void refuse_crossed(const Intervals& intervals) {
  if (intervals.crossed.empty()) return;
  const std::string name = name_of(intervals.crossed.front());
  throw InvalidMeshError("intervals", "The sides of " + name + " would touch or cross in its grid.",
                         {name}, {});
}

/// Throws what making the grids of the linking faces, and following their columns, does.
void try_grids(const Model& model, const Scheme& scheme, const CapMatch& match,
               const PieceCounts& counts, const IntervalOptions& options, Context& context) {
  if (const auto* shell = std::get_if<Shell>(&match))
    return try_shell_walls(model, scheme, *shell, counts, options, context);
  SurfaceMesh surface;
  const EdgeNodes nodes = nodes_on_edges(model, scheme, match, counts, options);
  const EdgeMesh edges = mesh_edges(model, counts.intervals, nodes, surface);
  mesh_linking_faces(model, scheme, counts.intervals, edges, context, surface);
  columns_from(surface);
}

}  // namespace

bool is_one_to_one(const Scheme& scheme) {
  return scheme.faces_with(FaceRole::source).size() == 1 &&
         scheme.faces_with(FaceRole::target).size() == 1;
}

CapMatch CapMatcher::operator()(double merge_fraction) {
  if (is_shell_like(model_, scheme_)) return find_shell(model_, scheme_, context_);
  if (is_one_to_one(scheme_)) return WholeCaps{};
  if (!basis_) basis_ = imprint_basis(model_, scheme_, size_, context_);
  return imprint_on(*basis_, model_, scheme_, merge_fraction, context_);
}

PieceCounts count_edges(const Model& model, const Scheme& scheme, const CapMatch& match,
                        const IntervalOptions& options, Context& context) {
  if (const auto* shell = std::get_if<Shell>(&match))
    return count_shell(model, scheme, *shell, options, context);
  if (const auto* imprint = std::get_if<Imprint>(&match))
    return count_imprint(model, scheme, *imprint, options, context);
  return {assign_intervals(model, scheme, options, context), {}};
}

EdgeNodes nodes_on_edges(const Model& model, const Scheme& scheme, const CapMatch& match,
                         const PieceCounts& counts, const IntervalOptions& options) {
  if (const auto* imprint = std::get_if<Imprint>(&match))
    return place_imprinted_nodes(model, scheme, *imprint, counts, options);
  return place_edge_nodes(model, counts.intervals, options);
}

std::vector<double> merge_fractions(const Model& model, const Scheme& scheme,
                                    const SweepOptions& options, double size) {
  std::vector<double> out = merge_fractions(options, size);
  if (is_shell_like(model, scheme) || is_one_to_one(scheme)) out.resize(1);
  return out;
}

Layout lay_out(const Model& model, const Scheme& scheme, const SweepOptions& options, double size,
               Context& context, bool is_trial) {
  IntervalOptions intervals = interval_options(model, options, size);
  intervals.is_trial = is_trial;
  return with_some_merging(merge_fractions(model, scheme, options, size),
                           CapMatcher(model, scheme, size, context), [&](CapMatch& match, double) {
                             PieceCounts counts =
                                 count_edges(model, scheme, match, intervals, context);
                             refuse_crossed(counts.intervals);
                             try_grids(model, scheme, match, counts, intervals, context);
                             return Layout{std::move(match), std::move(counts)};
                           });
}

bool is_alike(const CapMatch& a, const CapMatch& b) {
  const auto* of_a = std::get_if<Imprint>(&a);
  const auto* of_b = std::get_if<Imprint>(&b);
  if (!of_a || !of_b) return !of_a && !of_b;
  return std::ranges::equal(of_a->edges, of_b->edges,
                            [](const ImprintEdge& x, const ImprintEdge& y) {
                              return x.start == y.start && x.end == y.end && x.points == y.points;
                            });
}

bool is_final(const Error& error) {
  const auto* imprint = dynamic_cast<const ImprintError*>(&error);
  return imprint && imprint->failure() == ImprintFailure::unreachable;
}

bool can_merging_help(const Error& error) {
  return !error.entities().empty() && !is_final(error);
}

}  // namespace sweepmesh
