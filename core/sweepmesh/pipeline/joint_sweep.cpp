#include "sweepmesh/pipeline/joint_sweep.h"

#include <algorithm>
#include <optional>
#include <set>

#include "sweepmesh/imprint/axial_spacing.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/shell.h"
#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/imprinted_boundary.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/linking_faces.h"

namespace sweepmesh {
namespace {

/// One of the solids on its way.
struct Part {
  JointSolid solid;
  IntervalOptions options;
  std::optional<Imprint> imprint;  ///< of a sweep with several caps
  std::vector<int> piece;          ///< its edges' unknowns
  PieceCounts counts;
  EdgeNodes nodes;
  GivenBoundary given;
  BoundaryMesh boundary;
  bool is_meshed = false;

  const Model& model() const { return *solid.model; }
  const Scheme& scheme() const { return *solid.scheme; }
  FaceRole role(FaceId f) const { return scheme().face_role[f.index]; }
  bool is_linking(FaceId f) const { return role(f) == FaceRole::linking; }
};

/// A contact from one of its sides.
struct SideOfContact {
  int part, other_part;
  FaceId face, other_face;
};

class JointMesher {
 public:
  JointMesher(const std::vector<JointSolid>& solids, const Contacts& all,
              const std::vector<Contact>& contacts, const SweepOptions& options, double size,
              double merge_fraction, StageClock& clock, Context& context, JointFailure& failure)
      : all_(all),
        options_(options),
        merge_fraction_(merge_fraction),
        kind_(cells_of(options.element)),
        clock_(clock),
        context_(context),
        failure_(failure) {
    for (const JointSolid& s : solids) {
      parts_.emplace_back();
      parts_.back().solid = s;
      parts_.back().options = interval_options(*s.model, options, size);
      parts_.back().given.edge_t.resize(s.model->n_edges());
      for (const JointSolid& t : solids)
        parts_.back().given.tolerance =
            std::max(parts_.back().given.tolerance, 4.0 * t.model->tolerances().point);
    }
    for (const Contact& c : contacts) {
      const int a = part_of(c.solid), b = part_of(c.other);
      sides_.push_back({a, b, c.face, c.other_face});
      sides_.push_back({b, a, c.other_face, c.face});
    }
  }

  std::vector<SchemeMesh> run() {
    for (std::size_t p = 0; p < parts_.size(); ++p) in_part(p, [&] { imprint(parts_[p]); });
    clock_.run("intervals", [&] { count(); });
    clock_.run("surface", [&] {
      place_edges();
      for (std::size_t p = 0; p < parts_.size(); ++p) in_part(p, [&] { give_grids(p); });
      mesh_boundaries();
    });
    std::vector<SchemeMesh> out;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      in_part(p, [&] {
        std::set<FaceId> common;
        for (const auto& [face, mesh] : parts_[p].given.faces) common.insert(face);
        out.push_back(fill_boundary(parts_[p].model(), parts_[p].boundary,
                                    parts_[p].counts.intervals, common, options_, clock_,
                                    context_));
      });
    return out;
  }

 private:
  /// Runs a step of one solid and notes where it failed.
  template <class Step>
  void in_part(std::size_t p, const Step& step) {
    context_.check("surface");
    try {
      step();
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      failure_ = {parts_[p].solid.number, e.what(), e.entities()};
      throw;
    }
  }

  int part_of(int solid) const {
    return static_cast<int>(
        std::ranges::find(parts_, solid, [](const Part& p) { return p.solid.number; }) -
        parts_.begin());
  }

  // --- counts ------------------------------------------------------------------------------------

  void imprint(Part& part) {
    if (is_shell_like(part.model(), part.scheme()))
      throw InputError("surface",
                       "A sweep through a wall does not take over meshes of other solids.");
    if (is_one_to_one(part.scheme())) return;
    context_.report(0.05, "Imprinting");
    const ImprintOptions how{.size = part.options.size, .merge_fraction = merge_fraction_};
    part.imprint = clock_.run(
        "imprint", [&] { return imprint_caps(part.model(), part.scheme(), how, context_); });
  }

  IntervalPart demands_of(Part& part) const {
    IntervalPart out{part.model(), part.scheme(), part.options, {}};
    if (!part.imprint) {
      out.demands = interval_demands(part.model(), part.scheme(), part.options);
      return out;
    }
    PieceDemands pieces = imprint_demands(part.model(), part.scheme(), *part.imprint, part.options);
    part.piece = std::move(pieces.piece);
    out.demands = std::move(pieces.whole);
    return out;
  }

  void count() {
    context_.report(0.1, "Choosing intervals");
    std::vector<IntervalPart> demands;
    for (Part& part : parts_) demands.push_back(demands_of(part));
    auto solved = solve_together(std::move(demands), ties(), context_);
    for (std::size_t p = 0; p < parts_.size(); ++p)
      parts_[p].counts = piece_counts(std::move(solved[p]), parts_[p].piece);
  }

  /// By the edge that stands for it: the uses of every edge that parts have in common.
  using EdgeUse = std::pair<int, EdgeId>;  ///< part, edge
  std::map<EdgeId, std::vector<EdgeUse>> common_edges() const {
    std::map<EdgeId, std::vector<EdgeUse>> uses;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (const EdgeId e : parts_[p].model().edges())
        uses[all_.edge[e.index]].emplace_back(static_cast<int>(p), e);
    std::erase_if(uses, [](const auto& use) { return use.second.size() < 2; });
    return uses;
  }

  std::vector<EqualCounts> ties() const {
    std::vector<EqualCounts> out;
    for (const auto& [edge, uses] : common_edges())
      for (std::size_t i = 1; i < uses.size(); ++i)
        out.push_back({uses[0].first, uses[i].first, uses[0].second, uses[i].second});
    return out;
  }

  // --- edges and grids ---------------------------------------------------------------------------

  void place_edges() {
    for (Part& part : parts_) {
      const Intervals& intervals = part.counts.intervals;
      if (part.imprint) {
        part.nodes = place_imprinted_nodes(part.model(), part.scheme(), *part.imprint, part.counts,
                                           part.options);
      } else {
        part.nodes = place_edge_nodes(part.model(), intervals, part.options);
      }
    }
    for (const auto& [edge, uses] : common_edges()) {
      const EdgeUse& from = *std::ranges::max_element(
          uses, {}, [&](const EdgeUse& use) { return parts_[use.first].imprint.has_value(); });
      for (const EdgeUse& to : uses) give_edge(from, to);
    }
    for (Part& part : parts_) take_edges(part.given, part.nodes);
  }

  void give_edge(const EdgeUse& from, const EdgeUse& to) {
    std::vector<double> t = parts_[from.first].nodes.t[from.second.index];
    if (to.second != from.second) t = carried(parts_[from.first].model(), from.second, t, to);
    parts_[to.first].given.edge_t[to.second.index] = std::move(t);
  }

  /// The same points on an edge that coincides.
  std::vector<double> carried(const Model& model, EdgeId edge, const std::vector<double>& t,
                              const EdgeUse& to) const {
    const Model& other = parts_[to.first].model();
    std::vector<double> out;
    for (const double at : t) out.push_back(other.project(to.second, model.point(edge, at)));
    if (all_.edge_is_turned[edge.index] != all_.edge_is_turned[to.second.index])
      std::reverse(out.begin(), out.end());
    std::tie(out.front(), out.back()) = other.range(to.second);
    return out;
  }

  /// Grids of linking faces to the solids on their other side that have none yet.
  void give_grids(std::size_t p) {
    Part& part = parts_[p];
    std::vector<const SideOfContact*> own;
    for (const SideOfContact& side : sides_)
      if (side.part == static_cast<int>(p) && part.is_linking(side.face) &&
          !part.given.faces.contains(side.face))
        own.push_back(&side);
    if (own.empty()) return;
    const SurfaceMesh mesh = grids_of(part);
    for (const SideOfContact* side : own) give(*side, mesh);
  }

  SurfaceMesh grids_of(const Part& part) {
    SurfaceMesh mesh;
    const EdgeMesh edges = mesh_edges(part.model(), part.counts.intervals, part.nodes, mesh);
    mesh_linking_faces(part.model(), part.scheme(), part.counts.intervals, edges, context_, mesh);
    if (part.imprint && !part.options.sweep_bias)
      space_by_levels(part.model(), part.scheme(), part.options.size, mesh);
    return mesh;
  }

  /// To itself too: what follows must not move it.
  void give(const SideOfContact& side, const SurfaceMesh& mesh) {
    const bool is_grid_for_cap = parts_[side.part].is_linking(side.face) &&
                                 !parts_[side.other_part].is_linking(side.other_face);
    if (is_grid_for_cap && kind_ == CellKind::triangle)
      throw InvalidMeshError("surface",
                             "The structured grid of " + name_of(side.face) +
                                 " does not fit triangles, of which the end of the other sweep is.",
                             {name_of(side.face), name_of(side.other_face)}, {});
    const FaceMesh cells = mesh_of_face(mesh, side.face);
    parts_[side.part].given.faces.emplace(side.face, cells);
    parts_[side.other_part].given.faces.emplace(side.other_face, seen_from_behind(cells));
  }

  // --- caps --------------------------------------------------------------------------------------

  /// The lower the earlier. A divided cap can take no mesh; what has one at one end carries it on
  /// to the other at once; a sweep with contacts at both ends comes before one that can take a mesh
  /// for each of its caps.
  int rank(int p) const {
    const Part& part = parts_[p];
    int n_caps = 0, n_given = 0;
    for (const SideOfContact& side : sides_) {
      if (side.part != p || part.is_linking(side.face)) continue;
      if (part.imprint && is_divided(*part.imprint, side.face)) return 0;
      ++n_caps;
      n_given += part.given.faces.contains(side.face);
    }
    if (part.imprint) return must_carry_on(p) ? 1 : 4;
    return n_given > 0 ? 1 : n_caps > 1 ? 2 : 3;
  }

  /// Whether a mesh that a cap has been given lies opposite one that another solid waits for.
  bool must_carry_on(int p) const {
    const Part& part = parts_[p];
    const auto is_given = [&](FaceId f) { return part.given.faces.contains(f); };
    const auto is_waiting = [&](FaceId f) {
      return !is_given(f) && std::ranges::any_of(sides_, [&](const SideOfContact& side) {
        return side.part == p && side.face == f;
      });
    };
    return std::ranges::any_of(part.imprint->patches, [&](const Patch& patch) {
      return std::ranges::any_of(patch.runs, [&](const Run& run) {
        return (is_given(run.target) && is_waiting(run.source)) ||
               (is_given(run.source) && is_waiting(run.target));
      });
    });
  }

  void mesh_boundaries() {
    for (std::size_t n = 0; n < parts_.size(); ++n) {
      int next = -1;
      for (int p = 0; p < static_cast<int>(parts_.size()); ++p)
        if (!parts_[p].is_meshed && (next < 0 || rank(p) < rank(next))) next = p;
      in_part(next, [&] { mesh_boundary_of(parts_[next]); });
      for (const SideOfContact& side : sides_)
        if (side.part == next && !parts_[side.other_part].is_meshed &&
            !parts_[side.part].is_linking(side.face))
          give(side, parts_[next].boundary.surface);
    }
  }

  void mesh_boundary_of(Part& part) {
    context_.report(0.2, "Meshing the surface");
    part.boundary = without_overlaps(
        part.imprint
            ? mesh_imprinted_boundary(part.model(), part.scheme(), *part.imprint, part.counts,
                                      part.options, kind_, context_, part.given)
            : mesh_boundary(part.model(), part.scheme(), part.counts.intervals, part.options, kind_,
                            context_, part.given));
    part.is_meshed = true;
  }

  const Contacts& all_;
  const SweepOptions& options_;
  const double merge_fraction_;
  const CellKind kind_;
  StageClock& clock_;
  Context& context_;
  JointFailure& failure_;
  std::vector<Part> parts_;
  std::vector<SideOfContact> sides_;
};

}  // namespace

std::vector<SchemeMesh> mesh_together(const std::vector<JointSolid>& solids, const Contacts& all,
                                      const std::vector<Contact>& contacts,
                                      const SweepOptions& options, double size,
                                      double merge_fraction, StageClock& clock, Context& context,
                                      JointFailure& failure) {
  return JointMesher(solids, all, contacts, options, size, merge_fraction, clock, context, failure)
      .run();
}

}  // namespace sweepmesh
