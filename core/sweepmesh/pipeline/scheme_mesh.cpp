#include "sweepmesh/pipeline/scheme_mesh.h"

#include <cmath>
#include <set>
#include <utility>

#include "sweepmesh/pipeline/boundary.h"
#include "sweepmesh/pipeline/covering_counts.h"
#include "sweepmesh/pipeline/faces_at_elements.h"
#include "sweepmesh/pipeline/imprinted_boundary.h"
#include "sweepmesh/pipeline/second_order_on_model.h"
#include "sweepmesh/pipeline/shell_boundary.h"
#include "sweepmesh/pipeline/sliding_nodes.h"
#include "sweepmesh/volume/place.h"

namespace sweepmesh {
namespace {

/// Edges whose inner nodes all were passed over have no mesh edges: seams of caps.
void forget_unused_edges(const BoundaryMesh& boundary, Intervals& intervals) {
  std::vector<char> is_used(intervals.edge.size(), 0);
  for (const Owner& o : boundary.surface.owner)
    if (o.kind == EntityKind::edge) is_used[o.index] = 1;
  for (std::size_t e = 0; e < is_used.size(); ++e)
    if (!is_used[e] && intervals.edge[e] > 1) intervals.edge[e] = 0;
}

/// The CAD faces that runs have nodes on.
std::vector<std::string> faces_of(const BoundaryMesh& boundary, const std::vector<int>& runs) {
  std::set<int> faces;
  for (const int r : runs)
    for (const ColumnId column : boundary.runs[r].columns)
      for (const NodeId node : boundary.columns[column.index].nodes)
        if (node.is_valid() && boundary.surface.owner[node.index].kind == EntityKind::face)
          faces.insert(boundary.surface.owner[node.index].index);
  std::vector<std::string> out;
  for (const int f : faces) out.push_back(name_of(FaceId{f}));
  return out;
}

VolumeMesh fill(const Model& model, const BoundaryMesh& boundary, const std::set<FaceId>& held,
                Context& context) {
  Assembly assembly = assemble(boundary.surface, boundary.columns, boundary.runs);
  PlacementOptions options;
  MovableNodes movable = movable_nodes(model, boundary.surface, assembly, held);
  options.sliding = std::move(movable.sliding);
  options.curved = std::move(movable.curved);
  try {
    place_interior(assembly.extrusion, assembly.fixed, assembly.points, options, context);
  } catch (const InvalidMeshError& e) {
    throw InvalidMeshError(e.stage(), e.what(),
                           faces_at_elements(boundary.surface, assembly, e.elements()),
                           e.elements());
  }
  VolumeMesh mesh = build_volume_mesh(assembly.extrusion, std::move(assembly.points));
  add_boundary(boundary.surface, assembly, mesh);
  return mesh;
}

std::string merge_warning(double fraction) {
  if (fraction == 0.0) return "Curves of different caps are not brought together, however near.";
  return "Curves of different caps are brought together where they are nearer than " +
         std::to_string(std::lround(100 * fraction)) + " % of the element size.";
}

long n_elements_of(const BoundaryMesh& boundary) {
  long n = 0;
  for (const CellRun& run : boundary.runs) n += run.k_high - run.k_low;
  return n;
}

/// Faces that are covered poorly, and were far better before.
std::set<FaceId> lost_by_sliding(const std::vector<FaceCoverage>& before,
                                 const std::vector<FaceCoverage>& after) {
  constexpr double far = 0.7;
  std::set<FaceId> out;
  for (std::size_t f = 0; f < before.size(); ++f) {
    const double was = std::abs(before[f].deviation()), is = std::abs(after[f].deviation());
    if (!is_covered(after[f]) && was < far * is) out.insert(before[f].face);
  }
  return out;
}

std::vector<std::string> caps_of(const Scheme& scheme) {
  std::vector<std::string> out;
  for (const FaceRole role : {FaceRole::source, FaceRole::target})
    for (const FaceId f : scheme.faces_with(role)) out.push_back(name_of(f));
  return out;
}

class SchemeMesher {
 public:
  SchemeMesher(const Model& model, const Scheme& scheme, const SweepOptions& options, double size,
               StageClock& clock, Context& context)
      : model_(model),
        scheme_(scheme),
        options_(options),
        intervals_(interval_options(model, options, size)),
        kind_(cells_of(options.element)),
        areas_(face_areas(model)),
        clock_(clock),
        context_(context) {}

  SchemeMesh run() {
    const std::vector<Tried> tried = mesh_surface();
    if (tried.size() > 1) try {
        return filled(tried.back());
      } catch (const Cancelled&) {
        throw;
      } catch (const Error&) {  // the mesh with fewer edges may do
      }
    return filled(tried.front());
  }

 private:
  struct Tried {
    Intervals intervals;
    BoundaryMesh boundary;
    std::vector<FaceCoverage> coverage;
    double deviation() const { return worst_deviation(coverage); }
  };

  /// Where inner nodes of faces slide so far that these are no longer covered, they stay.
  SchemeMesh filled(const Tried& surface) {
    SchemeMesh out = filled(surface, {});
    if (const auto lost = lost_by_sliding(surface.coverage, out.coverage); !lost.empty()) try {
        out = filled(surface, lost);
      } catch (const Cancelled&) {
        throw;
      } catch (const Error&) {  // it slides as before
      }
    out.warnings.insert(out.warnings.begin(), warnings_.begin(), warnings_.end());
    return out;
  }

  SchemeMesh filled(const Tried& surface, const std::set<FaceId>& held) {
    SchemeMesh out = fill_boundary(model_, surface.boundary, surface.intervals, held, options_,
                                   clock_, context_);
    out.coverage = face_coverage(model_, areas_, out.mesh);
    return out;
  }

  std::vector<Tried> mesh_surface() {
    const auto fractions = merge_fractions(model_, scheme_, options_, intervals_.size);
    CapMatcher match(model_, scheme_, intervals_.size, context_);
    return with_some_merging(
        fractions, [&](double fraction) { return matched(match, fraction); },
        [&](CapMatch& made, double fraction) {
          std::vector<Tried> tried = covering(made);
          if (fraction != fractions.front()) warnings_.push_back(merge_warning(fraction));
          return tried;
        });
  }

  CapMatch matched(CapMatcher& match, double merge_fraction) {
    context_.report(0.05, "Matching sources and targets");
    return clock_.run("imprint", [&] { return match(merge_fraction); });
  }

  /// The surface's mesh and, where faces are covered poorly, the best of those with more edges
  /// there.
  std::vector<Tried> covering(const CapMatch& match) {
    constexpr int most_rounds = 4;
    constexpr long most_growth = 2;  // in elements: beyond, the cure is worse than the disease
    IntervalOptions intervals = intervals_;
    std::vector<Tried> out;
    out.push_back(over(match, intervals));
    if (!is_poorly_covered(out.front().coverage)) return out;
    const long n_elements = n_elements_of(out.front().boundary);
    Tried now = out.front();
    for (int round = 0; round < most_rounds && is_poorly_covered(now.coverage); ++round) try {
        if (!raise_for_coverage(model_, now.coverage, now.intervals, intervals)) break;
        now = over(match, intervals);
        if (n_elements_of(now.boundary) > most_growth * n_elements) break;
        if (now.deviation() >= out.back().deviation()) continue;
        out.resize(1);
        out.push_back(now);
      } catch (const Cancelled&) {
        throw;
      } catch (const Error&) {
        break;
      }
    return out;
  }

  Tried over(const CapMatch& match, const IntervalOptions& intervals) {
    context_.report(0.1, "Choosing intervals");
    PieceCounts counts = clock_.run(
        "intervals", [&] { return count_edges(model_, scheme_, match, intervals, context_); });
    context_.report(0.2, "Meshing the surface");
    return clock_.run("surface", [&] {
      BoundaryMesh boundary = without_overlaps(
          mesh_matched(model_, scheme_, match, counts, intervals, kind_, context_));
      auto coverage = face_coverage(model_, areas_, boundary.surface);
      return Tried{std::move(counts.intervals), std::move(boundary), std::move(coverage)};
    });
  }

  const Model& model_;
  const Scheme& scheme_;
  const SweepOptions& options_;
  const IntervalOptions intervals_;
  const CellKind kind_;
  const std::vector<double> areas_;
  StageClock& clock_;
  Context& context_;
  std::vector<std::string> warnings_;
};

}  // namespace

SchemeMesh mesh_scheme(const Model& model, const Scheme& scheme, const SweepOptions& options,
                       double size, StageClock& clock, Context& context) {
  try {
    return SchemeMesher(model, scheme, options, size, clock, context).run();
  } catch (const SolverError& e) {
    if (!e.entities().empty()) throw;
    throw SolverError(e.stage(), e.what(), caps_of(scheme));  // it knows of numbers only
  }
}

BoundaryMesh mesh_matched(const Model& model, const Scheme& scheme, const CapMatch& match,
                          const PieceCounts& counts, const IntervalOptions& options, CellKind kind,
                          Context& context) {
  if (const auto* shell = std::get_if<Shell>(&match))
    return mesh_shell_boundary(model, scheme, *shell, counts, options, kind, context);
  if (const auto* imprint = std::get_if<Imprint>(&match))
    return mesh_imprinted_boundary(model, scheme, *imprint, counts, options, kind, context);
  return mesh_boundary(model, scheme, counts.intervals, options, kind, context);
}

BoundaryMesh without_overlaps(BoundaryMesh boundary) {
  const std::vector<int> runs = overlapping_runs(boundary.runs);
  if (!runs.empty())
    throw InvalidMeshError("surface",
                           std::to_string(runs.size()) +
                               " cells of the caps' mesh lie over each other; try another size.",
                           faces_of(boundary, runs), {});
  return boundary;
}

SchemeMesh fill_boundary(const Model& model, const BoundaryMesh& boundary, Intervals intervals,
                         const std::set<FaceId>& held, const SweepOptions& options,
                         StageClock& clock, Context& context) {
  SchemeMesh out;
  forget_unused_edges(boundary, intervals);
  context.report(0.6, "Placing interior nodes");
  out.mesh = clock.run("place", [&] {
    VolumeMesh mesh = fill(model, boundary, held, context);
    if (options.order == 2) add_mid_nodes_on(model, mesh, context, out.warnings);
    return mesh;
  });
  if (!intervals.is_optimal)
    out.warnings.push_back("The interval solver reached its limit; its best solution is used.");
  out.intervals = std::move(intervals);
  return out;
}

CellKind cells_of(ElementKind element) {
  if (element == ElementKind::hex) return CellKind::quad;
  return element == ElementKind::prism ? CellKind::triangle : CellKind::polygon;
}

}  // namespace sweepmesh
