#include "sweepmesh/imprint/arranged_pieces.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace sweepmesh {
namespace {

[[noreturn]] void throw_on_one_point(const PieceGraph& graph, int a, int b) {
  std::vector<std::string> names;
  for (const int n : {a, b})
    for (const VertexId v : graph.nodes[n].cad) names.push_back(name_of(v));
  throw ImprintError(ImprintFailure::collision,
                     "Vertices of the same levels lie over each other along the sweep.", names);
}

[[noreturn]] void throw_on_one_curve(const Piece& a, const Piece& b) {
  const EdgeId first = a.traces[0].edge, second = b.traces[0].edge;
  throw ImprintError(ImprintFailure::collision,
                     name_of(first) + " and " + name_of(second) +
                         " lie over each other along the sweep, in the same levels.",
                     {name_of(first), name_of(second)});
}

/// The nodes at which the pieces end, by vertex of the arrangement; -1 at crossings.
std::vector<int> nodes_of(const ArrangedPieces& arranged, const PieceGraph& graph) {
  std::map<std::pair<double, double>, int> at;
  for (const int p : arranged.piece)
    for (const int n : {graph.pieces[p].start, graph.pieces[p].end}) {
      const Point2& point = graph.nodes[n].point;
      const auto [place, is_new] = at.try_emplace({point.x(), point.y()}, n);
      if (!is_new && place->second != n) throw_on_one_point(graph, place->second, n);
    }
  std::vector<int> out;
  for (const Point2& v : arranged.arrangement.vertices) {
    const auto found = at.find({v.x(), v.y()});
    out.push_back(found == at.end() ? -1 : found->second);
  }
  return out;
}

}  // namespace

ArrangedPieces arrange_pieces(const PieceGraph& graph) {
  ArrangedPieces out;
  std::vector<Polyline> lines;
  for (int p = 0; p < static_cast<int>(graph.pieces.size()); ++p)
    if (graph.is_alive(p)) {
      out.piece.push_back(p);
      lines.push_back(graph.pieces[p].points);
    }
  out.arrangement = arrange(lines);
  out.node = nodes_of(out, graph);
  return out;
}

std::vector<std::vector<Trace>> traces_of(const ArrangedPieces& arranged, const PieceGraph& graph,
                                          const Walls& walls) {
  std::vector<std::vector<Trace>> out;
  const auto piece = [&](const auto& use) -> const Piece& {
    return graph.pieces[arranged.piece[use.polyline]];
  };
  for (const auto& edge : arranged.arrangement.edges) {
    if (edge.uses.size() > 1) throw_on_one_curve(piece(edge.uses[0]), piece(edge.uses[1]));
    const auto& use = edge.uses.front();
    const bool is_along = use.first < use.last;
    std::vector<Trace> traces;
    for (const PieceTrace& t : piece(use).traces)
      traces.push_back({t.edge, walls.level[t.edge.index], is_along ? t.t.front() : t.t.back(),
                        is_along ? t.t.back() : t.t.front()});
    std::sort(traces.begin(), traces.end(), [](const Trace& a, const Trace& b) {
      return std::tie(a.level, a.edge) < std::tie(b.level, b.edge);
    });
    out.push_back(std::move(traces));
  }
  return out;
}

}  // namespace sweepmesh
