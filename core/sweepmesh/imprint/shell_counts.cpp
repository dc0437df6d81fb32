#include "sweepmesh/imprint/shell_counts.h"

#include <algorithm>
#include <cmath>

#include "sweepmesh/intervals/assign_intervals.h"
#include "sweepmesh/intervals/interval_demands.h"
#include "sweepmesh/surface/cap_boundary.h"
#include "sweepmesh/surface/cap_periods.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Terms = std::vector<IntegerProgram::Term>;

/// A polyline in a face's parameter plane with the lengths in space from its start.
struct MeasuredLine {
  std::vector<Point2> uv;
  std::vector<double> length;
};

MeasuredLine measured(const Model& model, FaceId face, const std::vector<Point2>& line) {
  constexpr int least_samples = 128;
  const int n_parts = std::max<int>(1, least_samples / (static_cast<int>(line.size()) - 1));
  const Point2 periods = closing_periods(model, face);
  const auto [low, high] = model.uv_bounds(face);
  MeasuredLine out;
  Point3 last = Point3::Zero();
  const auto add = [&](const Point2& uv) {
    const Point3 p = model.point(face, nearest_period(uv, 0.5 * (low + high), periods));
    out.length.push_back(out.uv.empty() ? 0.0 : out.length.back() + (p - last).norm());
    out.uv.push_back(uv);
    last = p;
  };
  add(line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int s = 1; s <= n_parts; ++s)
      add(line[i] + (line[i + 1] - line[i]) * s / static_cast<double>(n_parts));
  return out;
}

class Demands {
 public:
  Demands(const Model& model, const Scheme& scheme, const Shell& shell,
          const IntervalOptions& options)
      : model_(model),
        shell_(shell),
        options_(options),
        out_(interval_demands(model, scheme, options)) {}

  void add() {
    std::erase_if(out_.problem.demands, [](const auto& d) {
      return d.kind == Kind::even || d.kind == Kind::preferably_even;
    });
    for (const ShellEdge& e : shell_.edges) add_edge(e);
    for (const ShellPatch& p : shell_.patches) add_patch(p);
  }

  const IntervalDemands& demands() const { return out_; }
  int unknown(int edge) const { return edge_[edge]; }

 private:
  void demand(Kind kind, Terms terms, double right, std::vector<std::string> names,
              std::string text) {
    out_.problem.demand({kind, std::move(terms), right, std::move(names), std::move(text)});
  }

  void add_edge(const ShellEdge& e) {
    const int high = count_of(e, e.high), low = count_of(e, e.low);
    edge_.push_back(high);
    std::vector<std::string> names;
    for (const ShellTrace* t : {&e.high, &e.low})
      names.push_back(t->edge.is_valid() ? name_of(t->edge) : name_of(t->face));
    demand(Kind::equality, {{high, 1.0}, {low, -1.0}}, 0.0, names,
           names[0] + " must have as many mesh edges as its image on " + names[1]);
  }

  /// The unknown of a CAD edge, or a new one for a curve inside a cap.
  int count_of(const ShellEdge& e, const ShellTrace& trace) {
    if (trace.edge.is_valid()) return out_.edge[trace.edge.index];
    const double wish = std::max(1.0, length_of(e, trace) / options_.size);
    return out_.problem.add({e.start == e.end ? 4.0 : 1.0, unbounded, wish, wish});
  }

  double length_of(const ShellEdge& e, const ShellTrace& trace) const {
    if (!trace.uv.empty()) return measured(model_, trace.face, trace.uv).length.back();
    const bool is_high = &trace == &e.high;
    return (end_point(e.start, is_high) - end_point(e.end, is_high)).norm();
  }

  /// Of a vertex that some CAD edge of the shell begins or ends at.
  Point3 end_point(int vertex, bool is_high) const {
    for (const ShellEdge& e : shell_.edges) {
      const ShellTrace& trace = is_high ? e.high : e.low;
      if (!trace.edge.is_valid() || (e.start != vertex && e.end != vertex)) continue;
      return model_.point((e.start == vertex) != trace.is_reversed ? model_.start(trace.edge)
                                                                   : model_.end(trace.edge));
    }
    return Point3::Zero();
  }

  void add_patch(const ShellPatch& p) {
    const std::vector<std::string> names = {name_of(p.source), name_of(p.target)};
    demand(Kind::at_least, {{level_of(p.source), 1.0}, {level_of(p.target), -1.0}}, 1.0, names,
           names[0] + " must lie at least a layer above " + names[1]);
    Terms around;
    for (const auto& loop : p.loops) {
      Terms sum;
      for (const DirectedEdge& d : loop) sum.push_back({edge_[d.edge], 1.0});
      demand(Kind::at_least, sum, options_.quad_caps ? 4.0 : 3.0, names,
             "each loop of a cap must have enough mesh edges");
      if (options_.quad_caps && p.loops.size() > 1)
        demand(Kind::preferably_even, sum, 0.0, names, "each loop of a cap should be even");
      around.insert(around.end(), sum.begin(), sum.end());
    }
    if (options_.quad_caps)
      demand(Kind::even, without_pairs(around), 0.0, names,
             "the number of mesh edges around " + names[0] + " must be even");
  }

  /// What is there twice leaves the parity alone.
  static Terms without_pairs(Terms terms) {
    std::sort(terms.begin(), terms.end(),
              [](const auto& a, const auto& b) { return a.variable < b.variable; });
    Terms out;
    for (const auto& t : terms)
      if (!out.empty() && out.back().variable == t.variable)
        out.pop_back();
      else
        out.push_back(t);
    return out;
  }

  int level_of(FaceId cap) const {
    return out_.vertex[model_.loops(cap).front().front().start.index];
  }

  const Model& model_;
  const Shell& shell_;
  const IntervalOptions& options_;
  IntervalDemands out_;
  std::vector<int> edge_;
};

}  // namespace

std::vector<Point2> even_on_face(const Model& model, FaceId face, const std::vector<Point2>& uv,
                                 int n) {
  const MeasuredLine line = measured(model, face, uv);
  std::vector<Point2> out = {line.uv.front()};
  for (int i = 1; i < n; ++i) {
    const double at = line.length.back() * i / n;
    const auto upper = std::upper_bound(line.length.begin() + 1, line.length.end() - 1, at);
    const std::size_t s = upper - line.length.begin();
    const double step = line.length[s] - line.length[s - 1];
    const double f = step > 0.0 ? (at - line.length[s - 1]) / step : 0.0;
    out.push_back(line.uv[s - 1] + f * (line.uv[s] - line.uv[s - 1]));
  }
  out.push_back(line.uv.back());
  return out;
}

PieceCounts count_shell(const Model& model, const Scheme& scheme, const Shell& shell,
                        const IntervalOptions& options, Context& context) {
  Demands demands(model, scheme, shell, options);
  demands.add();
  SolvedIntervals solved = solve_intervals(model, scheme, demands.demands(), options, context);
  std::vector<int> piece;
  for (std::size_t e = 0; e < shell.edges.size(); ++e)
    piece.push_back(demands.unknown(static_cast<int>(e)));
  return piece_counts(std::move(solved), piece);
}

}  // namespace sweepmesh
