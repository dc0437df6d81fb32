#include "sweepmesh/imprint/overlay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "sweepmesh/imprint/arranged_pieces.h"
#include "sweepmesh/imprint/columns.h"
#include "sweepmesh/imprint/pieces.h"

namespace sweepmesh {
namespace {

using Place = Occupancy::Place;

class Overlayer {
 public:
  Overlayer(const Model& model, const Scheme& scheme, const Walls& walls,
            const Reference& reference, double merge_distance, const Context& context)
      : model_(model),
        walls_(walls),
        reference_(reference),
        occupancy_(model, walls, reference),
        ends_(model, walls, reference),
        columns_(find_columns(model, scheme, reference, occupancy_, ends_)),
        near_(merge_distance),
        context_(context) {}

  Overlay run() {
    make_nodes();
    find_corners();
    make_pieces();
    const std::size_t most = 100 + 10 * graph_.pieces.size();  // a guard: a few rounds are usual
    for (std::size_t round = 0; round < most; ++round) {
      context_.check("imprint");
      while (snap_nodes()) merge_pieces();
      merge_pieces();
      if (cut_stretches()) continue;
      if (cut_crossings()) continue;
      join_pieces(graph_);
      arranged_ = arrange_pieces(graph_);
      return result();
    }
    throw SolverError("imprint", "Bringing near curves together did not come to an end.");
  }

 private:
  // --- nodes -------------------------------------------------------------------------------------

  /// Columns that lie near each other and do not collide are a node.
  void make_nodes() {
    const std::vector<int> joined = joined_columns(columns_, occupancy_, near_);
    std::map<int, int> node;  // by number in `joined`
    node_of_.assign(model_.n_vertices(), -1);
    for (int c = 0; c < static_cast<int>(columns_.size()); ++c) {
      if (!node.contains(joined[c])) node[joined[c]] = add_node(columns_[joined[c]].place);
      const int n = node[joined[c]];
      columns_in_[n].push_back(c);
      auto& cad = graph_.nodes[n].cad;
      for (const VertexId v : columns_[c].vertices) {
        node_of_[v.index] = n;
        graph_.nodes[n].places.push_back(reference_.vertex[v.index]);
        cad.insert(std::upper_bound(cad.begin(), cad.end(), v), v);
      }
    }
  }

  /// Nodes at which all curves turn sharply may be moved onto a curve that passes by.
  void find_corners() {
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      bool is_corner = true;
      for (const VertexId v : graph_.nodes[n].cad)
        for (const auto& [edge, away] : ends_.directions(v))
          is_corner = is_corner && ends_.turn(edge, v) > corner_;
      is_corner_[n] = is_corner;
    }
  }

  bool collide(const std::vector<Place>& a, const std::vector<Place>& b) const {
    for (const Place& p : a)
      for (const Place& q : b)
        if (occupancy_.collide(p, q)) return true;
    return false;
  }

  bool collide_at_node(int node, const std::vector<Place>& there) const {
    const auto found = columns_in_.find(node);
    const std::vector<int> columns =
        found == columns_in_.end() ? std::vector<int>{} : found->second;
    for (const int c : columns)
      for (const Place& p : there)
        if (occupancy_.collide(columns_[c].column, p)) return true;
    const auto collide_there = [&](const Place& p, const Place& q) {
      return occupancy_.collide(p, q) && std::ranges::all_of(columns, [&](int c) {
               return occupancy_.collide(p, q, columns_[c].vertices);
             });
    };
    for (const Place& p : places_through(node))
      for (const Place& q : there)
        if (collide_there(p, q)) return true;
    return false;
  }

  // --- pieces ------------------------------------------------------------------------------------

  void make_pieces() {
    for (const ReferenceCurve& c : reference_.curves) {
      const int a = node_of_[model_.start(c.edge).index], b = node_of_[model_.end(c.edge).index];
      const Polyline points = with_ends(c.points, graph_.nodes[a].point, graph_.nodes[b].point);
      graph_.pieces.push_back({a, b, points, {{c.edge, c.points, c.t}}});
    }
  }

  int n_pieces() const { return static_cast<int>(graph_.pieces.size()); }

  std::vector<Place> places_on(int piece, double fraction) const {
    std::vector<Place> out;
    for (const PieceTrace& t : graph_.pieces[piece].traces)
      out.push_back({t.edge, at_arc(t.line, fraction * length(t.line)).point});
    return out;
  }

  /// Edges that pass through a node without a CAD vertex of theirs.
  std::vector<Place> places_through(int node) const {
    std::vector<Place> out;
    const auto add = [&](const PieceTrace& t, bool at_start) {
      if (node_of_[model_.start(t.edge).index] != node &&
          node_of_[model_.end(t.edge).index] != node)
        out.push_back({t.edge, CurveEnds::beside(t.line, at_start)});
    };
    for (int p = 0; p < n_pieces(); ++p)
      for (const PieceTrace& t : graph_.pieces[p].traces) {
        if (graph_.pieces[p].start == node) add(t, true);
        if (graph_.pieces[p].end == node) add(t, false);
      }
    return out;
  }

  // --- bringing together -------------------------------------------------------------------------

  /// Puts every node on the near pieces that it does not collide with. True if there were any.
  bool snap_nodes() {
    struct Snap {
      double distance;
      int node, piece;
      double arc;
      bool operator<(const Snap& o) const {
        return std::tie(distance, node, piece) < std::tie(o.distance, o.node, o.piece);
      }
    };
    std::vector<Snap> snaps;
    for (int p = 0; p < n_pieces(); ++p) {
      if (!graph_.is_alive(p)) continue;
      const Polyline& line = graph_.pieces[p].points;
      const Box2 box = box_of(line);
      for (int n = 0; n < static_cast<int>(graph_.nodes.size()); ++n) {
        const Point2& at = graph_.nodes[n].point;
        if (graph_.has_end(p, n) || !box.is_near({at, at}, near_)) continue;
        const PolylinePoint foot = nearest(line, at);
        if (foot.distance < near_ && is_inside(line, foot.arc))
          snaps.push_back({foot.distance, n, p, foot.arc});
      }
    }
    std::sort(snaps.begin(), snaps.end());
    std::vector<char> is_cut(graph_.pieces.size(), false);
    bool any = false;
    for (const Snap& s : snaps) {
      if (is_cut[s.piece]) continue;
      const double fraction = s.arc / length(graph_.pieces[s.piece].points);
      if (collide_at_node(s.node, places_on(s.piece, fraction))) continue;
      const Point2 foot = at_arc(graph_.pieces[s.piece].points, s.arc).point;
      cut_piece(s.piece, s.arc, s.node);
      if (is_corner_[s.node] && s.distance > reference_.coincidence) move_node(s.node, foot);
      is_corner_[s.node] = false;  // it is on a curve now
      is_cut[s.piece] = any = true;
    }
    return any;
  }

  /// Moves a node once; all its pieces follow.
  void move_node(int node, const Point2& to) {
    graph_.nodes[node].point = to;
    is_corner_[node] = false;
    for (int i = 0; i < n_pieces(); ++i) {
      Piece& p = graph_.pieces[i];
      if (!graph_.is_alive(i) || (p.start != node && p.end != node)) continue;
      p.points = with_ends(p.points, graph_.nodes[p.start].point, graph_.nodes[p.end].point);
      ++changes_[i];
    }
  }

  bool is_inside(const Polyline& line, double arc) const {
    const double least = reference_.coincidence;
    return arc > least && arc < length(line) - least;
  }

  /// Pieces between the same nodes that run near each other become one.
  void merge_pieces() {
    std::map<std::pair<int, int>, std::vector<int>> between;
    for (int p = 0; p < n_pieces(); ++p)
      if (graph_.is_alive(p)) {
        const Piece& piece = graph_.pieces[p];
        between[std::minmax(piece.start, piece.end)].push_back(p);
      }
    for (const auto& [ends, pieces] : between)
      for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = i + 1; j < pieces.size(); ++j)
          if (graph_.is_alive(pieces[i]) && graph_.is_alive(pieces[j])) {
            const bool is_first = is_shape_kept(pieces[i], pieces[j]);
            merge(pieces[is_first ? i : j], pieces[is_first ? j : i]);
          }
  }

  /// Of two curves that come together the one that turns less at its ends stays where it is, so
  /// that no cap has a corner where its own boundary is smooth; or else the straighter one.
  bool is_shape_kept(int piece, int other) const {
    const double turn = turn_of(piece), other_turn = turn_of(other);
    if (std::abs(turn - other_turn) > corner_) return turn < other_turn;
    const std::size_t n = graph_.pieces[piece].points.size();
    const std::size_t m = graph_.pieces[other].points.size();
    return std::tie(n, piece) < std::tie(m, other);
  }

  double turn_of(int piece) const {
    const Piece& p = graph_.pieces[piece];
    const EdgeId e = p.traces.front().edge;
    double sum = 0.0;
    for (const int node : {p.start, p.end})
      for (const VertexId v : {model_.start(e), model_.end(e)})
        if (node_of_[v.index] == node) sum += ends_.turn(e, v);
    return sum;
  }

  void merge(int a, int b) {
    const Piece &kept = graph_.pieces[a], &gone = graph_.pieces[b];
    const Polyline &own = kept.traces[0].line, &other = gone.traces[0].line;
    if (!are_within(kept.points, gone.points, near_) && !are_within(own, other, near_)) return;
    constexpr double middle = 0.5;
    if (collide(places_on(a, middle), places_on(b, middle))) return;
    for (const PieceTrace& t : gone.traces) {
      double farthest = 0.0;
      for (const Point2& p : t.line) farthest = std::max(farthest, nearest(own, p).distance);
      if (farthest > reference_.coincidence)
        merges_.push_back({kept.traces[0].edge, t.edge, farthest});
    }
    absorb(graph_, a, b);
    ++changes_[a];
  }

  /// Cuts two pieces where a stretch along which they run near each other begins or ends. True if
  /// any was cut.
  bool cut_stretches() {
    bool any = false;
    const int n = n_pieces();
    std::vector<Box2> box(n);  // splitting a piece leaves it in its box
    for (int p = 0; p < n; ++p)
      if (graph_.is_alive(p)) box[p] = box_of(graph_.pieces[p].traces[0].line);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        if (a != b && graph_.is_alive(a) && graph_.is_alive(b) && box[a].is_near(box[b], near_))
          any |= cut_stretch_once(a, b);
    return any;
  }

  /// Pieces that have been looked at and are still the same need no second look.
  bool cut_stretch_once(int a, int b) {
    const std::pair now{changes_of(a), changes_of(b)};
    const auto [seen, is_new] = seen_apart_.try_emplace({a, b}, now);
    if (!is_new && seen->second == now) return false;
    if (cut_stretch(a, b)) return true;
    seen->second = now;
    return false;
  }

  int changes_of(int piece) const {
    const auto found = changes_.find(piece);
    return found == changes_.end() ? 0 : found->second;
  }

  void cut_piece(int piece, double arc, int node) {
    split(graph_, piece, arc, node, reference_.coincidence);
    ++changes_[piece];
  }

  bool cut_stretch(int a, int b) {
    // The curves as they are in the CAD model: what has been moved together would always be near.
    const Polyline &line = graph_.pieces[a].traces[0].line,
                   &other = graph_.pieces[b].traces[0].line;
    const double total = length(line);
    for (const Stretch& s : near_stretches(line, other, near_)) {
      const bool starts = s.first <= 0.0, ends = s.last >= total;
      const bool is_start_shared = starts && graph_.has_end(b, graph_.pieces[a].start);
      const bool is_end_shared = ends && graph_.has_end(b, graph_.pieces[a].end);
      if ((starts && !is_start_shared) || (ends && !is_end_shared) || (starts && ends)) continue;
      // About the length over which curves that cross (or part) at 30 degrees are near.
      const double least = (starts || ends ? 2.0 : 4.0) * near_;
      if (s.last - s.first < least) continue;
      if (cut_both(a, b, starts ? s.last : s.first, (s.first + s.last) / 2)) return true;
    }
    return false;
  }

  /// Puts a node on both pieces at `arc` of a's own line, unless they collide at arc `middle`.
  bool cut_both(int a, int b, double arc, double middle) {
    const Polyline &line = graph_.pieces[a].traces[0].line,
                   &other = graph_.pieces[b].traces[0].line;
    const double fraction_a = arc / length(line);
    const PolylinePoint foot = nearest(other, at_arc(line, arc).point);
    const double fraction_b = foot.arc / length(other);
    const double arc_a = fraction_a * length(graph_.pieces[a].points);
    const double arc_b = fraction_b * length(graph_.pieces[b].points);
    if (!is_inside(graph_.pieces[a].points, arc_a) || !is_inside(graph_.pieces[b].points, arc_b))
      return false;
    const double middle_b = nearest(other, at_arc(line, middle).point).arc / length(other);
    if (collide(places_on(a, middle / length(line)), places_on(b, middle_b))) return false;
    const int node = add_node(is_shape_kept(a, b) ? at_arc(graph_.pieces[a].points, arc_a).point
                                                  : at_arc(graph_.pieces[b].points, arc_b).point);
    cut_piece(a, arc_a, node);
    cut_piece(b, arc_b, node);
    return true;
  }

  int add_node(const Point2& p) {
    is_corner_.push_back(false);
    graph_.nodes.push_back({p, {}, {}});
    return static_cast<int>(graph_.nodes.size()) - 1;
  }

  // --- crossings ---------------------------------------------------------------------------------

  /// Arranges all pieces and cuts them where the arrangement says that they meet between their
  /// ends. True if any was cut.
  bool cut_crossings() {
    arranged_ = arrange_pieces(graph_);
    name_crossings();
    std::map<int, std::map<double, int, std::greater<>>> cuts;  // piece -> position -> node
    for (const auto& edge : arranged_.arrangement.edges)
      for (const auto& use : edge.uses) {
        const auto add = [&](double position, int vertex) {
          const int p = arranged_.piece[use.polyline], node = arranged_.node[vertex];
          if (!graph_.has_end(p, node)) cuts[p].emplace(position, node);
        };
        add(use.first, edge.start);
        add(use.last, edge.end);
      }
    for (const auto& [p, places] : cuts) {
      // What is left of a piece keeps its arcs from the start, but not its positions.
      const Polyline line = graph_.pieces[p].points;
      int last = -1;
      double last_arc = length(line);
      for (const auto& [position, node] : places) {
        const double arc = at_position(line, position).arc;
        if (node == last && last_arc - arc <= reference_.coincidence) continue;
        cut_piece(p, arc, node);
        last = node;
        last_arc = arc;
      }
    }
    return !cuts.empty();
  }

  /// Gives each crossing a node. Crossings as good as at one place have the same, or that of an end
  /// there: two nodes so near each other could not be brought together later.
  void name_crossings() {
    std::vector<std::vector<int>> beside(arranged_.node.size());
    for (const auto& edge : arranged_.arrangement.edges) {
      if (length(edge.points) > reference_.coincidence) continue;
      beside[edge.start].push_back(edge.end);
      beside[edge.end].push_back(edge.start);
    }
    const std::vector<int> ends = arranged_.node;
    for (std::size_t v = 0; v < ends.size(); ++v)
      for (const int other : beside[v])
        if (ends[v] < 0 && ends[other] >= 0) arranged_.node[v] = ends[other];
    for (std::size_t v = 0; v < ends.size(); ++v) {
      if (arranged_.node[v] >= 0) continue;
      arranged_.node[v] = add_node(arranged_.arrangement.vertices[v]);
      for (const int other : beside[v])
        if (arranged_.node[other] < 0) arranged_.node[other] = arranged_.node[v];
    }
  }

  Overlay result() {
    Overlay out;
    for (const int n : arranged_.node) out.cad.push_back(graph_.nodes[n].cad);
    out.traces = traces_of(arranged_, graph_, walls_);
    out.arrangement = std::move(arranged_.arrangement);
    out.merges = std::move(merges_);
    return out;
  }

  const Model& model_;
  const Walls& walls_;
  const Reference& reference_;
  const Occupancy occupancy_;
  const CurveEnds ends_;
  const std::vector<CadColumn> columns_;
  const double near_;
  const Context& context_;
  static constexpr double corner_ = 0.35;  ///< radians; what turns less is smooth
  PieceGraph graph_;
  std::vector<char> is_corner_;                 ///< by node: it may still be moved
  std::map<int, std::vector<int>> columns_in_;  ///< by node
  std::vector<int> node_of_;  ///< by VertexId; -1 where no curve ends in its column
  std::vector<Merge> merges_;
  std::map<int, int> changes_;  ///< how often a piece has been cut, joined or moved
  /// Pieces that were not to be cut where they run near each other, with their changes by then.
  std::map<std::pair<int, int>, std::pair<int, int>> seen_apart_;
  ArrangedPieces arranged_;
};

}  // namespace

Overlay overlay(const Model& model, const Scheme& scheme, const Walls& walls,
                const Reference& reference, double merge_distance, const Context& context) {
  return Overlayer(model, scheme, walls, reference, merge_distance, context).run();
}

}  // namespace sweepmesh
