#include "sweepmesh/imprint/imprint_counts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sweepmesh/imprint/axial_spacing.h"
#include "sweepmesh/imprint/edge_lengths.h"
#include "sweepmesh/imprint/polyline.h"
#include "sweepmesh/intervals/areas.h"
#include "sweepmesh/intervals/wishes.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Terms = std::vector<IntegerProgram::Term>;

class Demands {
 public:
  Demands(const Model& model, const Scheme& scheme, const Imprint& imprint,
          const IntervalOptions& options)
      : model_(model),
        scheme_(scheme),
        imprint_(imprint),
        options_(options),
        out_(interval_demands(model, scheme, options)) {}

  void add() {
    auto& demands = out_.problem.demands;
    std::erase_if(demands, [](const auto& d) {
      return d.kind == Kind::even || d.kind == Kind::preferably_even;
    });
    add_edges();
    for (const Patch& p : imprint_.patches) add_patch(p);
    for (const ImprintEdge& e : imprint_.edges)
      for (std::size_t i = 1; i < e.traces.size(); ++i)
        keep_apart(model_.start(e.traces[i - 1].edge), model_.start(e.traces[i].edge),
                   name_of(e.traces[i - 1].edge), name_of(e.traces[i].edge));
    keep_curves_apart();
    for (const ImprintVertex& v : imprint_.vertices) add_column(v);
    for (const FaceId f : scheme_.faces_with(FaceRole::linking)) add_offsets(f);
  }

  const IntervalDemands& demands() const { return out_; }
  int unknown(int imprint_edge) const { return edge_[imprint_edge]; }

 private:
  void demand(Kind kind, Terms terms, double right, std::vector<std::string> names,
              std::string text) {
    out_.problem.demand({kind, std::move(terms), right, std::move(names), std::move(text)});
  }

  // --- counts ------------------------------------------------------------------------------------

  void add_edges() {
    const auto wishes = wished_counts(model_, options_);
    const auto needs = area_counts(model_, options_, wishes);
    for (const ImprintEdge& e : imprint_.edges) {
      double sum = 0.0, weights = 0.0, need = 0.0;
      for (const Trace& t : e.traces) {
        const auto f = length_fractions(model_, t.edge, {t.first, t.last});
        const double weight = importance(options_, t.edge);
        sum += weight * std::log(std::max(wishes[t.edge.index] * std::abs(f[1] - f[0]), 1e-3));
        weights += weight;
        need = std::max(need, needs[t.edge.index] * std::abs(f[1] - f[0]));
      }
      const double wish = std::max(need, std::exp(sum / weights));
      const double weight =
          std::max(weights / e.traces.size(), need > 0.0 ? std::max(1.0, need) : 0.0);
      edge_.push_back(out_.problem.add({e.start == e.end ? 3.0 : 1.0, unbounded, wish, weight}));
    }
    for (const EdgeId e : model_.edges()) {
      const auto& chain = imprint_.chain[e.index];
      if (chain.empty()) continue;
      const int whole = out_.edge[e.index];
      out_.problem.unknowns[whole].wish.reset();
      Terms terms = {{whole, 1.0}};
      for (const DirectedEdge& d : chain) terms.push_back({edge_[d.edge], -1.0});
      demand(Kind::equality, terms, 0.0, {name_of(e)},
             name_of(e) + " must have the mesh edges of the parts that it is divided into");
    }
  }

  void add_patch(const Patch& p) {
    Terms around;
    std::vector<std::string> names;
    for (const Run& r : p.runs) {
      for (const FaceId f : {r.target, r.source}) names.push_back(name_of(f));
      keep_apart(vertex_of(r.target), vertex_of(r.source), name_of(r.target), name_of(r.source));
    }
    for (std::size_t i = 1; i < p.runs.size(); ++i)
      keep_apart(vertex_of(p.runs[i - 1].source), vertex_of(p.runs[i].target),
                 name_of(p.runs[i - 1].source), name_of(p.runs[i].target));
    for (const auto& loop : p.loops) {
      Terms sum;
      for (const DirectedEdge& d : loop) sum.push_back({edge_[d.edge], 1.0});
      demand(Kind::at_least, sum, options_.quad_caps ? 4.0 : 3.0, names,
             "each loop of a patch must have enough mesh edges");
      if (options_.quad_caps && p.loops.size() > 1)
        demand(Kind::preferably_even, sum, 0.0, names, "each loop of a patch should be even");
      around.insert(around.end(), sum.begin(), sum.end());
    }
    if (options_.quad_caps)
      demand(Kind::even, around, 0.0, names,
             "the number of mesh edges around the patch between " + names[0] + " and " + names[1] +
                 " must be even");
  }

  /// Two curves with the same ends would be the same chord: the one that leaves it farther bends.
  void keep_curves_apart() {
    std::map<std::pair<int, int>, std::vector<std::size_t>> between;
    for (std::size_t e = 0; e < imprint_.edges.size(); ++e)
      between[std::minmax(imprint_.edges[e].start, imprint_.edges[e].end)].push_back(e);
    for (const auto& [ends, edges] : between)
      for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const std::string a = name_of(imprint_.edges[edges[i]].traces.front().edge);
          const std::string b = name_of(imprint_.edges[edges[j]].traces.front().edge);
          const std::size_t bent = bulge(edges[i]) > bulge(edges[j]) ? edges[i] : edges[j];
          demand(Kind::at_least, {{edge_[bent], 1.0}}, 2.0, {a, b},
                 a + " and " + b + " must not be the same mesh edge");
        }
  }

  /// How far an imprint edge is from its chord.
  double bulge(std::size_t edge) const {
    const Polyline& line = imprint_.edges[edge].points;
    double most = 0.0;
    for (const Point2& p : line)
      most = std::max(most, nearest({line.front(), line.back()}, p).distance);
    return most;
  }

  // --- layers ------------------------------------------------------------------------------------

  VertexId vertex_of(FaceId cap) const { return model_.loops(cap).front().front().start; }

  void keep_apart(VertexId low, VertexId high, const std::string& a, const std::string& b) {
    if (imprint_.vertex_level[low.index] == imprint_.vertex_level[high.index]) return;
    const int i = out_.vertex[low.index], j = out_.vertex[high.index];
    if (!apart_.insert({i, j}).second) return;
    demand(Kind::at_least, {{j, 1.0}, {i, -1.0}}, 1.0, {a, b},
           b + " must lie at least a layer above " + a);
  }

  void add_column(const ImprintVertex& v) {
    std::vector<VertexId> sorted = v.cad;
    std::sort(sorted.begin(), sorted.end(), [&](VertexId a, VertexId b) {
      return std::pair(imprint_.vertex_level[a.index], a) <
             std::pair(imprint_.vertex_level[b.index], b);
    });
    for (std::size_t i = 1; i < sorted.size(); ++i)
      keep_apart(sorted[i - 1], sorted[i], name_of(sorted[i - 1]), name_of(sorted[i]));
  }

  // --- loops of linking faces --------------------------------------------------------------------

  /// Where loop 0 passes below or above the first vertex of another loop.
  void add_offsets(FaceId f) {
    const auto& loops = model_.loops(f);
    for (std::size_t l = 1; l < loops.size(); ++l) {
      auto terms = steps_to(f, column_of(loops[l].front().start));
      if (!terms) continue;
      terms->push_back({out_.offset[f.index][l], -1.0});
      demand(Kind::equality, *terms, 0.0, {name_of(f)},
             "the loops of " + name_of(f) + " must stand over the same columns");
    }
  }

  int column_of(VertexId v) const {
    for (std::size_t i = 0; i < imprint_.vertices.size(); ++i)
      if (std::binary_search(imprint_.vertices[i].cad.begin(), imprint_.vertices[i].cad.end(), v))
        return static_cast<int>(i);
    return -1;
  }

  /// Signed counts along i on the way along a face's loop 0 from its first vertex to an imprint
  /// vertex; empty where the loop does not pass it.
  std::optional<Terms> steps_to(FaceId f, int vertex) const {
    const Loop& loop = model_.loops(f)[0];
    Terms terms;
    for (std::size_t c = 0; c < loop.size(); ++c) {
      const Direction d = scheme_.face[f.index].direction[0][c];
      if (!loop[c].edge.is_valid() || is_axial(d)) continue;
      const auto& chain = imprint_.chain[loop[c].edge.index];
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const DirectedEdge& e = chain[loop[c].reversed ? chain.size() - 1 - i : i];
        const ImprintEdge& edge = imprint_.edges[e.edge];
        const bool is_against = e.reversed != loop[c].reversed;
        if ((is_against ? edge.end : edge.start) == vertex) return terms;
        terms.push_back({edge_[e.edge], d == Direction::plus_i ? 1.0 : -1.0});
        if ((is_against ? edge.start : edge.end) == vertex) return terms;
      }
    }
    return std::nullopt;
  }

  const Model& model_;
  const Scheme& scheme_;
  const Imprint& imprint_;
  const IntervalOptions& options_;
  IntervalDemands out_;
  std::vector<int> edge_;
  std::set<std::pair<int, int>> apart_;
};

}  // namespace

PieceDemands imprint_demands(const Model& model, const Scheme& scheme, const Imprint& imprint,
                             const IntervalOptions& options) {
  Demands demands(model, scheme, imprint, options);
  demands.add();
  PieceDemands out{demands.demands(), {}};
  for (std::size_t e = 0; e < imprint.edges.size(); ++e)
    out.piece.push_back(demands.unknown(static_cast<int>(e)));
  return out;
}

PieceCounts count_imprint(const Model& model, const Scheme& scheme, const Imprint& imprint,
                          const IntervalOptions& options, Context& context) {
  PieceDemands demands = imprint_demands(model, scheme, imprint, options);
  return piece_counts(solve_intervals(model, scheme, std::move(demands.whole), options, context),
                      demands.piece);
}

EdgeNodes place_imprinted_nodes(const Model& model, const Scheme& scheme, const Imprint& imprint,
                                const PieceCounts& counts, const IntervalOptions& options) {
  EdgeNodes out = place_edge_nodes(model, counts.intervals, options);
  for (const EdgeId e : model.edges()) {
    if (imprint.chain[e.index].size() < 2) continue;
    std::vector<double> t = {model.range(e).first};
    for (const DirectedEdge& d : imprint.chain[e.index]) {
      const auto& traces = imprint.edges[d.edge].traces;
      const auto trace =
          std::find_if(traces.begin(), traces.end(), [&](const Trace& tr) { return tr.edge == e; });
      const auto [low, high] = std::minmax(trace->first, trace->last);
      const auto part = even_parameters(model, e, low, high, counts.edge[d.edge]);
      t.insert(t.end(), part.begin() + 1, part.end());
    }
    t.back() = model.range(e).second;
    out.t[e.index] = std::move(t);
  }
  space_by_levels(model, scheme, counts.intervals, options, out);
  return out;
}

}  // namespace sweepmesh
