#include "sweepmesh/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <utility>

#include "sweepmesh/boundary.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprinted_boundary.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/intervals/wishes.h"
#include "sweepmesh/second_order_on_model.h"
#include "sweepmesh/shell_boundary.h"
#include "sweepmesh/volume/place.h"

namespace sweepmesh {
namespace {

/// Runs stages and notes how long each took.
class StageClock {
 public:
  explicit StageClock(std::map<std::string, double>& seconds) : seconds_(seconds) {}

  template <class F>
  auto run(const char* stage, F&& f) {
    const Timer timer(seconds_[stage]);
    return f();
  }

 private:
  class Timer {
   public:
    explicit Timer(double& total) : total_(total) {}
    ~Timer() {
      total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

   private:
    double& total_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  };

  std::map<std::string, double>& seconds_;
};

[[noreturn]] void refuse(const std::string& sentence, std::vector<std::string> entities = {}) {
  throw InputError("options", sentence, std::move(entities));
}

}  // namespace

void check_options(const SweepOptions& options) {
  if (options.size && !(std::isfinite(*options.size) && *options.size > 0))
    refuse("The element size must be a positive number.");
  if (options.layers && *options.layers < 1) refuse("The number of layers must be at least 1.");
  if (options.order != 1 && options.order != 2) refuse("The element order must be 1 or 2.");
  if (options.imprint_tolerance &&
      !(std::isfinite(*options.imprint_tolerance) && *options.imprint_tolerance >= 0))
    refuse("The imprint tolerance must be a number that is not negative.");
  if (options.max_elements < 1) refuse("The limit of elements must be at least 1.");
  if (options.element == ElementKind::polyhedron)
    refuse("Polyhedral sweeps are not served yet; choose hexahedra or prisms.");
}

void check_picks(const Picks& picks) {
  for (const FaceId source : picks.sources)
    if (std::find(picks.targets.begin(), picks.targets.end(), source) != picks.targets.end())
      refuse(name_of(source) + " is given as a source and as a target.", {name_of(source)});
  for (const auto& [source, target] : picks.pairs)
    if (source == target) refuse(name_of(source) + " is paired with itself.", {name_of(source)});
}

namespace {

/// What is said of edges of this solid; edges of other solids are left to those.
template <class Wish>
std::map<EdgeId, Wish> on_own_edges(const Model& model, const std::map<EdgeId, Wish>& wishes) {
  const auto& edges = model.edges();
  std::map<EdgeId, Wish> own;
  for (const auto& [edge, wish] : wishes) {
    if (edge.index < 0 || edge.index >= model.n_edges())
      refuse("The shape has no " + name_of(edge) + ".", {name_of(edge)});
    if (std::binary_search(edges.begin(), edges.end(), edge)) own.emplace(edge, wish);
  }
  return own;
}

}  // namespace

IntervalOptions interval_options(const Model& model, const SweepOptions& options, double size) {
  IntervalOptions out;
  out.size = size;
  out.layers = options.layers;
  out.edge_size = on_own_edges(model, options.edge_size);
  out.edge_count = on_own_edges(model, options.edge_count);
  out.edge_bias = on_own_edges(model, options.edge_bias);
  out.sweep_bias = options.sweep_bias;
  out.quad_caps = options.element == ElementKind::hex;
  return out;
}

std::vector<double> merge_fractions(const SweepOptions& options, double size) {
  if (options.imprint_tolerance) return {std::min(1.0, *options.imprint_tolerance / size)};
  const double usual = ImprintOptions{}.merge_fraction;
  return {usual, 0.4 * usual, 1.6 * usual, 0.1 * usual};
}

namespace {

std::string in_millions(double count) {
  char text[32];
  std::snprintf(text, sizeof text, count < 1e5 ? "%.0f" : "%.3g", count);
  return text;
}

}  // namespace

void refuse_explosion(const Model& model, const SweepOptions& options, double size) {
  const IntervalOptions intervals = interval_options(model, options, size);
  double expected = expected_elements(model, intervals);
  if (options.layers) expected = std::max(expected, static_cast<double>(*options.layers));
  if (expected <= static_cast<double>(options.max_elements)) return;
  refuse("About " + in_millions(expected) +
         " elements are to be expected, more than the limit of " +
         in_millions(static_cast<double>(options.max_elements)) +
         "; choose a larger size, or lift the limit (max_elements).");
}

bool is_one_to_one(const Scheme& scheme) {
  return scheme.faces_with(FaceRole::source).size() == 1 &&
         scheme.faces_with(FaceRole::target).size() == 1;
}

namespace {

BoundaryMesh boundary_of_one(const Model& model, const Scheme& scheme,
                             const IntervalOptions& options, CellKind kind, StageClock& clock,
                             Context& context, SweepResult& result) {
  context.report(0.1, "Choosing intervals");
  result.intervals =
      clock.run("intervals", [&] { return assign_intervals(model, scheme, options, context); });
  context.report(0.2, "Meshing the surface");
  return clock.run("surface", [&] {
    return mesh_boundary(model, scheme, result.intervals, options, kind, context);
  });
}

BoundaryMesh boundary_with_merging(const Model& model, const Scheme& scheme, double merge_fraction,
                                   const IntervalOptions& options, CellKind kind, StageClock& clock,
                                   Context& context, SweepResult& result) {
  context.report(0.05, "Imprinting");
  const Imprint imprint = clock.run("imprint", [&] {
    const ImprintOptions how{.size = options.size, .merge_fraction = merge_fraction};
    return imprint_caps(model, scheme, how, context);
  });
  context.report(0.1, "Choosing intervals");
  const ImprintCounts counts = clock.run(
      "intervals", [&] { return count_imprint(model, scheme, imprint, options, context); });
  result.intervals = counts.intervals;
  context.report(0.2, "Meshing the surface");
  return clock.run("surface", [&] {
    return mesh_imprinted_boundary(model, scheme, imprint, counts, options, kind, context);
  });
}

/// Near curves are brought together within the first distance, or, where curves then get into each
/// other's way or cells have no room on a cap, within another one. If none will do, the first error
/// counts.
BoundaryMesh boundary_of_many(const Model& model, const Scheme& scheme,
                              const IntervalOptions& options, CellKind kind,
                              const std::vector<double>& fractions, StageClock& clock,
                              Context& context, SweepResult& result) {
  std::exception_ptr first;
  for (const double fraction : fractions) try {
      BoundaryMesh boundary =
          boundary_with_merging(model, scheme, fraction, options, kind, clock, context, result);
      if (fraction != fractions.front())
        result.warnings.push_back(
            "Curves of different caps are brought together where they are nearer than " +
            std::to_string(std::lround(100 * fraction)) + " % of the element size.");
      return boundary;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      if (!first) first = std::current_exception();
      if (e.entities().empty()) break;  // nothing that merging could change
    }
  std::rethrow_exception(first);
}

BoundaryMesh boundary_of_shell(const Model& model, const Scheme& scheme,
                               const IntervalOptions& options, CellKind kind, StageClock& clock,
                               Context& context, SweepResult& result) {
  context.report(0.05, "Matching sources and targets");
  const Shell shell = clock.run("imprint", [&] { return find_shell(model, scheme, context); });
  context.report(0.1, "Choosing intervals");
  const ShellCounts counts =
      clock.run("intervals", [&] { return count_shell(model, scheme, shell, options, context); });
  result.intervals = counts.intervals;
  context.report(0.2, "Meshing the surface");
  return clock.run("surface", [&] {
    return mesh_shell_boundary(model, scheme, shell, counts, options, kind, context);
  });
}

BoundaryMesh boundary_of(const Model& model, const Scheme& scheme, const IntervalOptions& options,
                         CellKind kind, const std::vector<double>& merge_fractions,
                         StageClock& clock, Context& context, SweepResult& result) {
  if (is_shell_like(model, scheme))
    return boundary_of_shell(model, scheme, options, kind, clock, context, result);
  if (is_one_to_one(scheme))
    return boundary_of_one(model, scheme, options, kind, clock, context, result);
  return boundary_of_many(model, scheme, options, kind, merge_fractions, clock, context, result);
}

/// Edges whose inner nodes all were passed over have no mesh edges: seams of caps.
void forget_unused_edges(const BoundaryMesh& boundary, Intervals& intervals) {
  std::vector<char> is_used(intervals.edge.size(), 0);
  for (const Owner& o : boundary.surface.owner)
    if (o.kind == EntityKind::edge) is_used[o.index] = 1;
  for (std::size_t e = 0; e < is_used.size(); ++e)
    if (!is_used[e] && intervals.edge[e] > 1) intervals.edge[e] = 0;
}

VolumeMesh fill(const BoundaryMesh& boundary, Context& context) {
  Assembly assembly = assemble(boundary.surface, boundary.columns, boundary.runs);
  place_interior(assembly.extrusion, assembly.fixed, assembly.points, {}, context);
  VolumeMesh mesh = build_volume_mesh(assembly.extrusion, std::move(assembly.points));
  add_boundary(boundary.surface, assembly, mesh);
  return mesh;
}

/// Meshes one scheme into result.mesh and result.intervals; throws the stages' errors.
void mesh_scheme(const Model& model, const Scheme& scheme, const SweepOptions& options,
                 StageClock& clock, Context& context, SweepResult& result) {
  const IntervalOptions intervals = interval_options(model, options, result.size);
  const CellKind kind = options.element == ElementKind::hex ? CellKind::quad : CellKind::triangle;
  const BoundaryMesh boundary =
      boundary_of(model, scheme, intervals, kind, merge_fractions(options, result.size), clock,
                  context, result);
  forget_unused_edges(boundary, result.intervals);
  context.report(0.6, "Placing interior nodes");
  result.mesh = clock.run("place", [&] {
    VolumeMesh mesh = fill(boundary, context);
    if (options.order == 2) add_mid_nodes_on(model, mesh, context, result.warnings);
    return mesh;
  });
  if (!result.intervals.is_optimal)
    result.warnings.push_back("The interval solver ran out of time; its best solution is used.");
}

std::string caps_of(const Scheme& scheme) {
  const auto listed = [&](FaceRole role) {
    std::string text;
    for (const FaceId f : scheme.faces_with(role)) text += (text.empty() ? "" : ", ") + name_of(f);
    return text;
  };
  return listed(FaceRole::source) + " to " + listed(FaceRole::target);
}

/// The verdict where every scheme ends in elements that no position of the inner nodes makes valid.
Assessment folded(const InvalidMeshError& error) {
  Assessment verdict;
  verdict.reasons.push_back(
      {ReasonKind::geometric,
       std::string(error.what()) + " Cut the solid, or sweep it in another direction.",
       error.entities()});
  return verdict;
}

/// Which of `n` schemes are tried, in this order: the best four, and the last two, which are
/// straight where the solid has such sweeps.
std::vector<std::size_t> tries(std::size_t n) {
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < n; ++s)
    if (s < 4 || s + 2 >= n) out.push_back(s);
  return out;
}

/// Meshes the schemes in their order until one succeeds; that one is moved to the front, and a
/// warning tells of those before it. False: the solid turned out not to be sweepable, see the
/// assessment. Throws the first scheme's error where all fail otherwise.
bool mesh_first_possible(const Model& model, const SweepOptions& options, StageClock& clock,
                         Context& context, SweepResult& result) {
  auto& schemes = result.assessment.schemes;
  std::exception_ptr first_error;
  std::optional<InvalidMeshError> fold;
  for (const std::size_t s : tries(schemes.size())) try {
      mesh_scheme(model, schemes[s], options, clock, context, result);
      std::rotate(schemes.begin(), schemes.begin() + s, schemes.begin() + s + 1);
      return true;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (!first_error) first_error = std::current_exception();
      const auto* invalid = dynamic_cast<const InvalidMeshError*>(&error);
      if (s == 0 && invalid && invalid->stage() == "place") fold = *invalid;
      result.warnings.push_back("The sweep from " + caps_of(schemes[s]) +
                                " could not be meshed: " + error.what());
    }
  if (!fold) std::rethrow_exception(first_error);
  result.assessment = folded(*fold);
  result.warnings.clear();
  return false;
}

}  // namespace

double default_size(const Model& model) {
  constexpr double n_elements = 3000;
  return std::cbrt(model.volume() / n_elements);
}

SweepResult sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                  Context& context) {
  check_options(options);
  check_picks(picks);
  SweepResult result;
  StageClock clock(result.seconds);
  result.size = options.size.value_or(default_size(model));
  refuse_explosion(model, options, result.size);

  context.report(0.0, "Looking for sources and targets");
  result.assessment = clock.run("assess", [&] { return assess(model, picks, context); });
  if (!result.assessment.is_sweepable()) return result;
  if (!mesh_first_possible(model, options, clock, context, result)) return result;

  context.report(0.9, "Measuring quality");
  result.quality = clock.run("quality", [&] { return measure_quality(result.mesh, {}, context); });
  context.report(1.0, "Done");
  return result;
}

}  // namespace sweepmesh
