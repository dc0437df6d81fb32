#include "sweepmesh/pipeline/shell_boundary.h"

#include <algorithm>
#include <limits>

#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/surface/cap_mesh.h"
#include "sweepmesh/surface/cap_periods.h"
#include "sweepmesh/surface/linking_edges.h"
#include "sweepmesh/surface/linking_faces.h"

namespace sweepmesh {
namespace {

/// The nodes of a shell edge on one side, from its start to its end.
struct SideNodes {
  std::vector<NodeId> node;
  std::vector<double> t;   ///< of a CAD edge
  std::vector<Point2> uv;  ///< of a cut
};

struct BothSides {
  SideNodes high, low;
};

template <class T>
void turn(std::vector<T>& closed, int by) {
  closed.pop_back();
  std::rotate(closed.begin(), closed.begin() + by, closed.end());
  closed.push_back(closed.front());
}

std::vector<Point3> centred(const std::vector<NodeId>& nodes, const SurfaceMesh& mesh) {
  std::vector<Point3> out;
  Point3 middle = Point3::Zero();
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) out.push_back(mesh.points[nodes[i].index]);
  for (const Point3& p : out) middle += p / static_cast<double>(out.size());
  double size = 0.0;
  for (Point3& p : out) size += (p -= middle).norm() / static_cast<double>(out.size());
  for (Point3& p : out) p /= size;
  return out;
}

/// By how many nodes a closed row must be turned so that it lies nearest to another, place and size
/// aside.
int nearest_turn(const std::vector<NodeId>& high, const std::vector<NodeId>& low,
                 const SurfaceMesh& mesh) {
  const auto a = centred(high, mesh), b = centred(low, mesh);
  double least = std::numeric_limits<double>::infinity();
  int best = 0;
  for (std::size_t by = 0; by < b.size(); ++by) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[(i + by) % b.size()]).squaredNorm();
    if (sum < least) least = sum, best = static_cast<int>(by);
  }
  return best;
}

class ShellMesher {
 public:
  ShellMesher(const Model& model, const Scheme& scheme, const Shell& shell,
              const PieceCounts& counts, const IntervalOptions& options, CellKind kind,
              Context& context)
      : model_(model),
        scheme_(scheme),
        shell_(shell),
        counts_(counts),
        options_(options),
        kind_(kind),
        context_(context) {}

  /// All but the caps. Throws where columns lead astray.
  void mesh_walls() {
    edges_ = mesh_edges(model_, counts_.intervals,
                        place_edge_nodes(model_, counts_.intervals, options_), out_.surface);
    mesh_linking_faces(model_, scheme_, counts_.intervals, edges_, context_, out_.surface);
    out_.columns = linking_columns(out_.surface);
    column_at_ = columns_at_nodes(out_.columns, out_.surface.n_nodes());
    nodes_.resize(shell_.edges.size());
    vertex_.resize(shell_.n_vertices);
    for (std::size_t e = 0; e < shell_.edges.size(); ++e) add_cad_edge(e);
  }

  BoundaryMesh run() {
    mesh_walls();
    for (std::size_t e = 0; e < shell_.edges.size(); ++e)
      for (const bool is_high : {true, false}) add_curve(e, is_high);
    for (const ShellPatch& p : shell_.patches) add_patch(p);
    drop_loose_nodes(out_);
    return std::move(out_);
  }

 private:
  struct VertexNodes {
    NodeId high, low;
  };

  ColumnId column_at(NodeId node) const {
    return node.index < static_cast<int>(column_at_.size()) ? column_at_[node.index] : ColumnId{};
  }

  /// The lowest node of the linking faces' column through a node, where there is one.
  NodeId foot_of(NodeId node) const {
    const ColumnId c = column_at(node);
    return c.is_valid() ? out_.columns[c.index].nodes.front() : NodeId{};
  }

  // --- edges -------------------------------------------------------------------------------------

  SideNodes cad_nodes(const ShellTrace& trace) const {
    SideNodes out;
    out.node = edges_.edge[trace.edge.index];
    out.t = edges_.parameters.t[trace.edge.index];
    if (trace.is_reversed) {
      std::reverse(out.node.begin(), out.node.end());
      std::reverse(out.t.begin(), out.t.end());
    }
    return out;
  }

  void add_cad_edge(std::size_t e) {
    const ShellEdge& edge = shell_.edges[e];
    const bool has_high = edge.high.edge.is_valid(), has_low = edge.low.edge.is_valid();
    BothSides& both = nodes_[e];
    if (has_high) both.high = cad_nodes(edge.high);
    if (has_low) both.low = cad_nodes(edge.low);
    if (has_high && has_low) tie(edge, both);
    if (has_high) {
      vertex_[edge.start].high = both.high.node.front();
      vertex_[edge.end].high = both.high.node.back();
    }
    if (has_low) {
      vertex_[edge.start].low = both.low.node.front();
      vertex_[edge.end].low = both.low.node.back();
    }
  }

  /// Turns a closed edge to its image, and makes sure that linking faces agree.
  void tie(const ShellEdge& edge, BothSides& both) const {
    if (edge.start == edge.end) {
      const int by = turn_of(both);
      turn(both.low.node, by);
      turn(both.low.t, by);
    }
    for (std::size_t i = 0; i < both.high.node.size(); ++i) {
      const NodeId foot = foot_of(both.high.node[i]);
      if (foot.is_valid() && foot != both.low.node[i])
        throw InvalidMeshError("surface",
                               "The columns of the linking faces do not lead from " +
                                   name_of(edge.high.edge) + " to " + name_of(edge.low.edge) + ".",
                               {name_of(edge.high.edge), name_of(edge.low.edge)}, {});
    }
  }

  int turn_of(const BothSides& both) const {
    const NodeId foot = foot_of(both.high.node.front());
    const auto at = std::find(both.low.node.begin(), both.low.node.end(), foot);
    if (at != both.low.node.end()) return static_cast<int>(at - both.low.node.begin());
    return nearest_turn(both.high.node, both.low.node, out_.surface);
  }

  /// The nodes of a curve inside a cap.
  void add_curve(std::size_t e, bool is_high) {
    const ShellEdge& edge = shell_.edges[e];
    const ShellTrace& trace = is_high ? edge.high : edge.low;
    if (trace.edge.is_valid()) return;
    SideNodes& side = is_high ? nodes_[e].high : nodes_[e].low;
    const auto line = trace.uv.empty() ? straight_line(edge, trace.face, is_high) : trace.uv;
    side.uv = even_on_face(model_, trace.face, line, counts_.edge[e]);
    const std::size_t last = side.uv.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
      side.node.push_back(i == 0      ? end_node(edge.start, trace.face, side.uv[i], is_high)
                          : i == last ? end_node(edge.end, trace.face, side.uv[i], is_high)
                                      : new_node(trace.face, side.uv[i]));
  }

  Point3 point_on(FaceId face, const Point2& uv) const {
    const auto [low, high] = model_.uv_bounds(face);
    return model_.point(face,
                        nearest_period(uv, 0.5 * (low + high), closing_periods(model_, face)));
  }

  NodeId new_node(FaceId face, const Point2& uv) {
    return out_.surface.add_node(point_on(face, uv), {EntityKind::face, face.index});
  }

  NodeId end_node(int vertex, FaceId face, const Point2& uv, bool is_high) {
    NodeId& node = is_high ? vertex_[vertex].high : vertex_[vertex].low;
    if (!node.is_valid()) node = new_node(face, uv);
    return node;
  }

  std::vector<Point2> straight_line(const ShellEdge& cut, FaceId face, bool is_high) const {
    const Point2 from = uv_of_vertex(cut.start, face, is_high);
    const Point2 to = uv_of_vertex(cut.end, face, is_high);
    return {from, nearest_period(to, from, closing_periods(model_, face))};
  }

  /// By a CAD edge of the shell that ends there and bounds the face.
  Point2 uv_of_vertex(int vertex, FaceId face, bool is_high) const {
    for (std::size_t e = 0; e < shell_.edges.size(); ++e) {
      const ShellEdge& edge = shell_.edges[e];
      const EdgeId cad = (is_high ? edge.high : edge.low).edge;
      if (!cad.is_valid() || (edge.start != vertex && edge.end != vertex)) continue;
      const SideNodes& side = is_high ? nodes_[e].high : nodes_[e].low;
      for (const Coedge& c : model_.coedges(cad))
        if (c.face == face)
          return model_.uv(c, edge.start == vertex ? side.t.front() : side.t.back());
    }
    throw Error("surface", "A cut of " + name_of(face) + " begins at none of its edges.",
                {name_of(face)});
  }

  // --- patches -----------------------------------------------------------------------------------

  std::vector<CapNode> nodes_on(const DirectedEdge& d, FaceId face, bool is_high) const {
    const SideNodes& side = is_high ? nodes_[d.edge].high : nodes_[d.edge].low;
    const ShellTrace& trace = is_high ? shell_.edges[d.edge].high : shell_.edges[d.edge].low;
    Coedge coedge;
    if (trace.edge.is_valid())
      for (const Coedge& c : model_.coedges(trace.edge))
        if (c.face == face) coedge = c;
    std::vector<CapNode> out;
    const int n = static_cast<int>(side.node.size()) - 1;
    for (int s = 0; s < n; ++s) {
      const int i = d.reversed ? n - s : s;
      out.push_back({side.node[i], out_.surface.points[side.node[i].index],
                     trace.edge.is_valid() ? model_.uv(coedge, side.t[i]) : side.uv[i]});
    }
    return out;
  }

  CapLoops loops_on(const ShellPatch& patch, bool is_high) const {
    CapLoops out;
    for (const auto& loop : patch.loops) {
      out.emplace_back();
      for (const DirectedEdge& d : loop) {
        const auto nodes = nodes_on(d, is_high ? patch.source : patch.target, is_high);
        out.back().insert(out.back().end(), nodes.begin(), nodes.end());
      }
    }
    return out;
  }

  int k_of(FaceId cap) const {
    return counts_.intervals.k[model_.loops(cap).front().front().start.index];
  }

  void add_patch(const ShellPatch& patch) {
    context_.check("surface");
    const auto [upper, lower] =
        mesh_cap_pair(model_, patch.source, loops_on(patch, true), patch.target,
                      loops_on(patch, false), options_.size, kind_, context_);
    const std::vector<NodeId> up = add_cap(upper, out_.surface);
    const std::vector<NodeId> down = add_cap(lower, out_.surface);
    add_runs_between(upper, up, down, k_of(patch.target), k_of(patch.source), column_at_, out_);
  }

  const Model& model_;
  const Scheme& scheme_;
  const Shell& shell_;
  const PieceCounts& counts_;
  const IntervalOptions& options_;
  const CellKind kind_;
  Context& context_;
  BoundaryMesh out_;
  EdgeMesh edges_;
  std::vector<BothSides> nodes_;     ///< by shell edge
  std::vector<VertexNodes> vertex_;  ///< by shell vertex
  std::vector<ColumnId> column_at_;  ///< by surface node
};

}  // namespace

void try_shell_walls(const Model& model, const Scheme& scheme, const Shell& shell,
                     const PieceCounts& counts, const IntervalOptions& options, Context& context) {
  ShellMesher(model, scheme, shell, counts, options, CellKind::quad, context).mesh_walls();
}

BoundaryMesh mesh_shell_boundary(const Model& model, const Scheme& scheme, const Shell& shell,
                                 const PieceCounts& counts, const IntervalOptions& options,
                                 CellKind kind, Context& context) {
  return ShellMesher(model, scheme, shell, counts, options, kind, context).run();
}

}  // namespace sweepmesh
