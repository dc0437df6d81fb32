#include "sweepmesh/pipeline/imprinted_boundary.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "sweepmesh/imprint/axial_spacing.h"
#include "sweepmesh/surface/cap_mesh.h"
#include "sweepmesh/surface/linking_columns.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/linking_faces.h"

namespace sweepmesh {
namespace {

bool is_cap(FaceRole role) {
  return role == FaceRole::source || role == FaceRole::target;
}

/// The base mesh over the patches that a cap covers, its boundary in the cap's own order.
struct CapBase {
  CapMesh mesh;
  std::vector<CapNode> nodes;  ///< of the cap's boundary, as mesh.boundary
  std::vector<int> base_node;  ///< of all of mesh.plane's nodes
};

class BoundaryMesher {
 public:
  BoundaryMesher(const Model& model, const Scheme& scheme, const Imprint& imprint,
                 const PieceCounts& counts, const IntervalOptions& options, CellKind kind,
                 Context& context, const GivenBoundary& given)
      : model_(model),
        scheme_(scheme),
        imprint_(imprint),
        counts_(counts),
        options_(options),
        kind_(kind),
        context_(context),
        given_(given) {}

  BoundaryMesh run() {
    EdgeNodes nodes = place_imprinted_nodes(model_, scheme_, imprint_, counts_, options_);
    take_edges(given_, nodes);
    edges_ = mesh_edges(model_, counts_.intervals, nodes, out_.surface);
    mesh_linking_faces(model_, scheme_, counts_.intervals, edges_, context_, out_.surface);
    if (!options_.sweep_bias) space_by_levels(model_, scheme_, options_.size, out_.surface);
    take_linking_faces(scheme_, given_, out_.surface);
    base_ = mesh_base_edges(imprint_, counts_.edge);
    find_base_nodes();
    base_ = mesh_base(model_, imprint_, counts_.edge, kind_, context_, find_given());
    make_columns();
    add_linking_columns();
    for (const FaceId f : model_.faces())
      if (is_cap(scheme_.face_role[f.index])) add_cap_over_base(f);
    make_runs();
    drop_loose_nodes(out_);
    return std::move(out_);
  }

 private:
  int k_of(FaceId cap) const {
    return counts_.intervals.k[model_.loops(cap).front().front().start.index];
  }

  // --- base nodes of surface nodes ---------------------------------------------------------------

  void set_base_node(NodeId node, int base, EdgeId e) {
    base_of_.resize(out_.surface.n_nodes(), -1);
    int& place = base_of_[node.index];
    if (place < 0) place = base;
    if (place != base)
      throw InvalidMeshError(
          "surface", "The mesh nodes of " + name_of(e) + " lie over two columns of the base mesh.",
          {name_of(e)}, {});
  }

  /// Nodes on CAD edges lie over the nodes of the imprint edges that these are divided into.
  void find_base_nodes() {
    for (const EdgeId e : model_.edges()) {
      const auto& nodes = edges_.edge[e.index];
      std::size_t at = 0;
      for (const DirectedEdge& d : imprint_.chain[e.index]) {
        const auto& base = base_.edge_nodes[d.edge];
        for (std::size_t i = 0; i < base.size(); ++i)
          set_base_node(nodes[at + i], d.reversed ? base[base.size() - 1 - i] : base[i], e);
        at += base.size() - 1;
      }
    }
    base_of_.resize(out_.surface.n_nodes(), -1);
  }

  // --- given caps --------------------------------------------------------------------------------

  GivenPatches find_given() {
    GivenPatches out;
    for (const auto& [cap, mesh] : given_.faces)
      if (is_cap(scheme_.face_role[cap.index])) {
        const int patch = only_patch_of(cap);
        if (!out.emplace(patch, given_patch(cap, mesh, patch)).second)
          refuse_given(cap, "its other end has a mesh from another solid");
        given_cap_[patch] = cap;
      }
    return out;
  }

  [[noreturn]] void refuse_given(FaceId cap, const std::string& why) const {
    throw InvalidMeshError(
        "surface",
        name_of(cap) + " cannot take the mesh of the solid that touches it: " + why + ".",
        {name_of(cap)}, {});
  }

  int only_patch_of(FaceId cap) const {
    if (is_divided(imprint_, cap)) refuse_given(cap, "what lies over or under it divides it");
    int patch = 0;
    while (!is_covered(patch, cap)) ++patch;
    return patch;
  }

  /// In the order of the patch's loops, which run around a target the other way than it sees them.
  GivenPatch given_patch(FaceId cap, const FaceMesh& mesh, int patch) const {
    std::map<int, Point3> at;  // by base node
    for (const auto& loop : cap_loops(model_, cap, edges_.edge, edges_.parameters.t))
      for (const CapNode& n : loop) at.emplace(base_of_[n.node.index], n.point);
    GivenPatch out;
    for (const int b : loop_nodes(base_, imprint_.patches[patch])) {
      const auto point = at.find(b);
      if (point == at.end()) refuse_given(cap, "a curve from elsewhere runs through it");
      out.points.push_back(point->second);
    }
    const bool is_source = scheme_.face_role[cap.index] == FaceRole::source;
    out.cells =
        numbered_from(out.points, is_source ? mesh : seen_from_behind(mesh), given_.tolerance);
    out.points.insert(out.points.end(), out.cells.inner.begin(), out.cells.inner.end());
    return out;
  }

  /// Where a cap's mesh is given, its inner nodes go there.
  void move_to_given(FaceId cap, const CapBase& base, CapMesh& image) const {
    for (const auto& [patch, its_cap] : given_cap_) {
      if (its_cap != cap) continue;
      const FaceMesh& mesh = given_.faces.at(cap);
      const GivenPatch given = given_patch(cap, mesh, patch);
      for (std::size_t n = 0; n < base.base_node.size(); ++n) {
        const int inner = base.base_node[n] - base_.first_inner[patch];
        if (inner < 0 || inner >= static_cast<int>(given.cells.inner.size())) continue;
        image.points[n] = given.cells.inner[inner];
        image.uv[n] = model_.project(cap, image.points[n]);
      }
    }
  }

  // --- columns -----------------------------------------------------------------------------------

  struct LayerRange {
    int low, high;
    ColumnId column;
  };

  /// Over each base node: the layers of all runs there, those that share a layer together.
  void make_columns() {
    std::vector<std::vector<LayerRange>> ranges(base_.n_nodes());
    for (int c = 0; c < base_.n_cells(); ++c)
      for (const Run& r : imprint_.patches[base_.cell_patch[c]].runs)
        for (const int n : base_.cell(c)) ranges[n].push_back({k_of(r.target), k_of(r.source), {}});
    over_.resize(base_.n_nodes());
    for (int n = 0; n < base_.n_nodes(); ++n) {
      std::sort(ranges[n].begin(), ranges[n].end(),
                [](const LayerRange& a, const LayerRange& b) { return a.low < b.low; });
      for (const LayerRange& r : ranges[n]) {
        if (!over_[n].empty() && r.low < over_[n].back().high)
          over_[n].back().high = std::max(over_[n].back().high, r.high);
        else
          over_[n].push_back(r);
      }
      for (LayerRange& r : over_[n]) {
        r.column = ColumnId{out_.columns.size()};
        out_.columns.push_back({r.low, std::vector<NodeId>(r.high - r.low + 1)});
      }
    }
  }

  /// The column over a base node that has the layers low..high.
  std::optional<ColumnId> column_at(int base, int low, int high) const {
    for (const LayerRange& r : over_[base])
      if (r.low <= low && high <= r.high) return r.column;
    return std::nullopt;
  }

  void put(ColumnId column, int k, NodeId node) {
    ColumnNodes& c = out_.columns[column.index];
    c.nodes[k - c.k_low] = node;
  }

  void add_linking_columns() {
    for (const auto& chain : columns_from(out_.surface).chains) {
      int base = -1;
      for (const NodeId n : chain) {
        const int b = base_of_[n.index];
        if (b >= 0 && base >= 0 && b != base) throw_astray(chain);
        base = std::max(base, b);
      }
      const int low = out_.surface.k[chain.front().index];
      const int high = out_.surface.k[chain.back().index];
      const auto column = base < 0 ? std::nullopt : column_at(base, low, high);
      if (!column) throw_astray(chain);
      for (std::size_t i = 0; i < chain.size(); ++i)
        put(*column, low + static_cast<int>(i), chain[i]);
    }
  }

  [[noreturn]] void throw_astray(const std::vector<NodeId>& chain) const {
    std::set<std::string> names;
    for (const NodeId n : chain) {
      const Owner& o = out_.surface.owner[n.index];
      names.insert(o.kind == EntityKind::vertex ? name_of(VertexId{o.index})
                   : o.kind == EntityKind::edge ? name_of(EdgeId{o.index})
                                                : name_of(FaceId{o.index}));
    }
    throw InvalidMeshError("surface",
                           "A column of nodes on the linking faces does not stand over one node of "
                           "the base mesh.",
                           {names.begin(), names.end()}, {});
  }

  // --- caps --------------------------------------------------------------------------------------

  void add_cap_over_base(FaceId cap) {
    context_.check("surface");
    const bool is_source = scheme_.face_role[cap.index] == FaceRole::source;
    const CapBase base = base_of_cap(cap, is_source);
    CapMesh image = map_cap(model_, base.mesh, cap, base.nodes, options_.size, context_,
                            is_source ? Facing::same : Facing::opposite);
    move_to_given(cap, base, image);
    const std::vector<NodeId> nodes = add_cap(image, out_.surface);
    const int k = k_of(cap);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto column =
          column_at(base.base_node[n], is_source ? k - 1 : k, is_source ? k : k + 1);
      if (column) put(*column, k, nodes[n]);
    }
  }

  CapBase base_of_cap(FaceId cap, bool is_source) const {
    CapBase out;
    std::map<int, int> local;  // by base node
    for (auto& loop : loops_over_base(cap, is_source)) {
      out.mesh.loop_sizes.push_back(static_cast<int>(loop.size()));
      for (CapNode& n : loop) {
        const int b = base_of_[n.node.index];
        local.emplace(b, static_cast<int>(out.base_node.size()));
        out.base_node.push_back(b);
        out.mesh.boundary.push_back(n.node);
        out.nodes.push_back(n);
      }
    }
    PlanarMesh& plane = out.mesh.plane;
    plane.n_boundary = static_cast<int>(out.base_node.size());
    for (int c = 0; c < base_.n_cells(); ++c) {
      if (!is_covered(base_.cell_patch[c], cap)) continue;
      std::vector<int> nodes;
      for (const int b : base_.cell(c)) {
        const auto [at, is_new] = local.emplace(b, static_cast<int>(out.base_node.size()));
        if (is_new) out.base_node.push_back(b);
        nodes.push_back(at->second);
      }
      plane.add_cell(nodes);
    }
    for (const int b : out.base_node) plane.points.push_back(imprint_.unit * base_.points[b]);
    return out;
  }

  bool is_covered(int patch, FaceId cap) const {
    const auto& runs = imprint_.patches[patch].runs;
    return std::any_of(runs.begin(), runs.end(),
                       [&](const Run& r) { return r.target == cap || r.source == cap; });
  }

  /// The cap's loops as seen from above, the outer one in R first.
  CapLoops loops_over_base(FaceId cap, bool is_source) const {
    CapLoops loops = cap_loops(model_, cap, edges_.edge, edges_.parameters.t);
    const auto area = [&](const std::vector<CapNode>& loop) {
      std::vector<Point2> points;
      for (const CapNode& n : loop) points.push_back(base_.points[base_of_[n.node.index]]);
      return signed_area(points);
    };
    if (!is_source)
      for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
    const auto outer = std::max_element(loops.begin(), loops.end(),
                                        [&](auto& a, auto& b) { return area(a) < area(b); });
    std::rotate(loops.begin(), outer, outer + 1);
    return loops;
  }

  // --- runs --------------------------------------------------------------------------------------

  void make_runs() {
    for (int c = 0; c < base_.n_cells(); ++c)
      for (const Run& r : imprint_.patches[base_.cell_patch[c]].runs) {
        CellRun run{{}, k_of(r.target), k_of(r.source)};
        for (const int b : base_.cell(c))
          run.columns.push_back(*column_at(b, run.k_low, run.k_high));
        out_.runs.push_back(std::move(run));
      }
  }

  const Model& model_;
  const Scheme& scheme_;
  const Imprint& imprint_;
  const PieceCounts& counts_;
  const IntervalOptions& options_;
  const CellKind kind_;
  Context& context_;
  const GivenBoundary& given_;
  BoundaryMesh out_;
  EdgeMesh edges_;
  BaseMesh base_;
  std::map<int, FaceId> given_cap_;            ///< by patch
  std::vector<int> base_of_;                   ///< by surface node; -1 inside linking faces
  std::vector<std::vector<LayerRange>> over_;  ///< by base node
};

}  // namespace

BoundaryMesh mesh_imprinted_boundary(const Model& model, const Scheme& scheme,
                                     const Imprint& imprint, const PieceCounts& counts,
                                     const IntervalOptions& options, CellKind kind,
                                     Context& context, const GivenBoundary& given) {
  return BoundaryMesher(model, scheme, imprint, counts, options, kind, context, given).run();
}

bool is_divided(const Imprint& imprint, FaceId cap) {
  const auto covers = [&](const Patch& p) {
    return std::ranges::any_of(p.runs,
                               [&](const Run& r) { return r.target == cap || r.source == cap; });
  };
  return std::ranges::count_if(imprint.patches, covers) > 1;
}

}  // namespace sweepmesh
