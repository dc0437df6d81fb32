#include "sweepmesh/imprint/pieces.h"

#include <algorithm>
#include <optional>

#include "sweepmesh/imprint/nearest_search.h"

namespace sweepmesh {
namespace {

PieceTrace reversed(PieceTrace trace) {
  std::reverse(trace.line.begin(), trace.line.end());
  std::reverse(trace.t.begin(), trace.t.end());
  return trace;
}

/// Whether a closed piece runs the same way round as another that lies over it.
bool runs_along(const Polyline& line, const Polyline& other) {
  const double quarter = length(other) / 4;
  const PolylinePoint foot = nearest(line, at_arc(other, quarter).point);
  return foot.arc < length(line) / 2;
}

/// Where a trace is to be cut: at `fraction` of its length, unless one of the places lies on it.
double fraction_at(const PieceTrace& trace, double fraction, const std::vector<Point2>& places,
                   double coincidence) {
  const double whole = length(trace.line);
  for (const Point2& p : places) {
    const PolylinePoint foot = nearest(trace.line, p);
    if (foot.distance <= coincidence && foot.arc > coincidence && foot.arc < whole - coincidence)
      return foot.arc / whole;
  }
  return fraction;
}

/// The piece walked so that it ends, or starts, in `node`.
Piece walked(const Piece& piece, int node, bool ends_there) {
  if ((ends_there ? piece.end : piece.start) == node) return piece;
  Piece out{piece.end, piece.start, piece.points, {}};
  std::reverse(out.points.begin(), out.points.end());
  for (const PieceTrace& trace : piece.traces) out.traces.push_back(reversed(trace));
  return out;
}

template <class T>
void append_after_first(std::vector<T>& line, const std::vector<T>& more) {
  line.insert(line.end(), more.begin() + 1, more.end());
}

/// Both as one, where each trace of `first` goes on in `second`.
std::optional<Piece> joined(Piece first, const Piece& second) {
  if (first.traces.size() != second.traces.size()) return {};
  for (PieceTrace& trace : first.traces) {
    const auto goes_on = std::ranges::find_if(second.traces, [&](const PieceTrace& other) {
      return other.edge == trace.edge && other.t.front() == trace.t.back();
    });
    if (goes_on == second.traces.end()) return {};
    append_after_first(trace.line, goes_on->line);
    append_after_first(trace.t, goes_on->t);
  }
  append_after_first(first.points, second.points);
  first.end = second.end;
  return first;
}

}  // namespace

std::pair<PieceTrace, PieceTrace> cut(const PieceTrace& trace, double fraction) {
  const PolylinePoint p = at_arc(trace.line, fraction * length(trace.line));
  const std::size_t i = static_cast<std::size_t>(p.position);
  const std::size_t j = std::min(i, trace.line.size() - 2);
  const double t = trace.t[j] + (p.position - j) * (trace.t[j + 1] - trace.t[j]);
  PieceTrace first{trace.edge, {}, {}}, second{trace.edge, {p.point}, {t}};
  for (std::size_t n = 0; n < trace.line.size(); ++n) {
    PieceTrace& side = static_cast<double>(n) < p.position ? first : second;
    if (static_cast<double>(n) == p.position) continue;
    side.line.push_back(trace.line[n]);
    side.t.push_back(trace.t[n]);
  }
  first.line.push_back(p.point);
  first.t.push_back(t);
  return {std::move(first), std::move(second)};
}

int split(PieceGraph& graph, int piece, double arc, int node, double coincidence) {
  const Piece whole = std::move(graph.pieces[piece]);
  const PolylinePoint p = at_arc(whole.points, arc);
  const double last = static_cast<double>(whole.points.size() - 1);
  const Point2& place = graph.nodes[node].point;
  Piece first{whole.start, node, {}, {}}, second{node, whole.end, {}, {}};
  first.points = part(whole.points, 0.0, p.position);
  second.points = part(whole.points, p.position, last);
  // A node that lies on the curve but for the error of chords leaves other points where they are:
  // else the curve could come to lie on the wrong side of one that it touches there.
  const auto put = (place - p.point).norm() > coincidence ? with_ends : with_ends_only;
  const double tiny = 1e-3 * coincidence;  // a chord that short may point anywhere
  first.points = apart_from_ends(put(first.points, whole.points.front(), place), tiny);
  second.points = apart_from_ends(put(second.points, place, whole.points.back()), tiny);
  const double fraction = p.arc / length(whole.points);
  for (const PieceTrace& trace : whole.traces) {
    auto [a, b] = cut(trace, fraction_at(trace, fraction, graph.nodes[node].places, coincidence));
    first.traces.push_back(std::move(a));
    second.traces.push_back(std::move(b));
  }
  graph.pieces[piece] = std::move(first);
  graph.pieces.push_back(std::move(second));
  return static_cast<int>(graph.pieces.size()) - 1;
}

void join_pieces(PieceGraph& graph) {
  std::vector<std::vector<int>> at(graph.nodes.size());
  for (int p = 0; p < static_cast<int>(graph.pieces.size()); ++p)
    if (graph.is_alive(p))
      for (const int n : {graph.pieces[p].start, graph.pieces[p].end}) at[n].push_back(p);
  for (int n = 0; n < static_cast<int>(at.size()); ++n) {
    if (!graph.nodes[n].cad.empty() || at[n].size() != 2 || at[n][0] == at[n][1]) continue;
    const int kept = std::min(at[n][0], at[n][1]), gone = std::max(at[n][0], at[n][1]);
    auto whole = joined(walked(graph.pieces[kept], n, true), walked(graph.pieces[gone], n, false));
    if (!whole) continue;
    graph.pieces[kept] = std::move(*whole);
    graph.pieces[gone].traces.clear();
    std::ranges::replace(at[graph.pieces[kept].end], gone, kept);
    at[n].clear();
  }
}

void absorb(PieceGraph& graph, int kept, int gone) {
  Piece& a = graph.pieces[kept];
  Piece& b = graph.pieces[gone];
  const bool is_along = a.start != a.end ? a.start == b.start : runs_along(a.points, b.points);
  for (PieceTrace& trace : b.traces)
    a.traces.push_back(is_along ? std::move(trace) : reversed(std::move(trace)));
  b.traces.clear();
}

bool are_within(const Polyline& a, const Polyline& b, double distance) {
  constexpr int n_parts = 16;
  const auto is_one_way = [&](const Polyline& from, const Polyline& to) {
    const NearestSearch nearest_on(to);
    for (const PolylinePoint& p : resampled(from, length(from) / n_parts))
      if (nearest_on(p.point).distance > distance) return false;
    return true;
  };
  return is_one_way(a, b) && is_one_way(b, a);
}

std::vector<Stretch> near_stretches(const Polyline& a, const Polyline& b, double distance) {
  std::vector<Stretch> out;
  const NearestSearch nearest_on_b(b);
  const std::vector<double> arcs = arc_lengths(a);
  const double total = arcs.back(), least_step = distance / 4;
  std::size_t i = 0;
  const auto place_at = [&](double arc) -> Point2 {
    while (i + 2 < a.size() && arcs[i + 1] <= arc) ++i;
    const double step = arcs[i + 1] - arcs[i];
    return a[i] + (step > 0.0 ? std::min((arc - arcs[i]) / step, 1.0) : 0.0) * (a[i + 1] - a[i]);
  };
  bool is_inside = false;
  for (double arc = 0.0;;) {
    // The distance changes by no more than the arc, so what it is ahead of the limit can be
    // skipped.
    const double d = nearest_on_b(place_at(arc)).distance;
    const bool is_near = d < distance;
    if (is_near && !is_inside) out.push_back({arc, arc});
    if (is_near) out.back().last = arc;
    is_inside = is_near;
    if (arc >= total) return out;
    arc = std::min(total, arc + std::max(least_step, std::abs(d - distance)));
  }
}

}  // namespace sweepmesh
