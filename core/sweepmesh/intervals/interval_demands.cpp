#include "sweepmesh/intervals/interval_demands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/intervals/areas.h"
#include "sweepmesh/intervals/wishes.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Terms = std::vector<IntegerProgram::Term>;

class Builder {
 public:
  Builder(const Model& model, const Scheme& scheme, const IntervalOptions& options)
      : model_(model), scheme_(scheme), options_(options) {
    out_.edge.assign(model.n_edges(), -1);
    out_.vertex.assign(model.n_vertices(), -1);
    out_.offset.resize(model.n_faces());
  }

  IntervalDemands build() {
    add_unknowns();
    for (const FaceId f : model_.faces()) {
      if (is_cap(f)) add_cap(f);
      if (role(f) == FaceRole::linking) add_linking(f);
    }
    join_levels();
    for (const auto& [edge, count] : options_.edge_count) fix(edge, count);
    for (const auto& [a, b] : options_.equal_edges)
      demand(Kind::equality, {{count(a), 1.0}, {count(b), -1.0}}, 0.0, {name_of(a), name_of(b)},
             name_of(a) + " and " + name_of(b) + " must have the same number of mesh edges");
    if (options_.layers) add_layers(*options_.layers);
    return std::move(out_);
  }

 private:
  FaceRole role(FaceId f) const { return scheme_.face_role[f.index]; }
  bool is_cap(FaceId f) const { return role(f) == FaceRole::source || role(f) == FaceRole::target; }
  int count(EdgeId e) const { return out_.edge[e.index]; }
  int level(VertexId v) const { return out_.vertex[v.index]; }

  void demand(Kind kind, Terms terms, double right, std::vector<std::string> names,
              std::string text) {
    out_.problem.demand({kind, std::move(terms), right, std::move(names), std::move(text)});
  }
  void demand_same_level(VertexId a, VertexId b, const std::string& name) {
    if (a == b) return;
    demand(Kind::equality, {{level(a), 1.0}, {level(b), -1.0}}, 0.0, {name},
           name + " must lie within one layer");
  }

  void add_unknowns() {
    const auto wishes = wished_counts(model_, options_);
    const auto needs = area_counts(model_, options_, wishes);
    for (const EdgeId e : model_.edges()) {
      const double least = least_count(options_, e);
      const bool is_closed = model_.start(e) == model_.end(e);
      const double wish = std::max({wishes[e.index], needs[e.index], least});
      const double weight = wish * importance(options_, e);
      out_.edge[e.index] =
          out_.problem.add({std::max(least, is_closed ? 3.0 : 1.0), unbounded, wish, weight});
    }
    for (const VertexId v : model_.vertices())
      out_.vertex[v.index] = out_.problem.add({-unbounded, unbounded, std::nullopt, 0.0});
  }

  void add_cap(FaceId f) {
    const auto& loops = model_.loops(f);
    const VertexId reference = loops.front().front().start;
    Terms around;
    for (const auto& loop : loops) {
      Terms sum;
      for (const auto& c : loop) {
        demand_same_level(reference, c.start, name_of(f));
        if (c.edge.is_valid()) sum.push_back({count(c.edge), 1.0});
      }
      add_cap_loop(f, loops.size() > 1, sum);
      around.insert(around.end(), sum.begin(), sum.end());
    }
    if (options_.quad_caps)
      demand(Kind::even, around, 0.0, {name_of(f)},
             "the number of mesh edges around " + name_of(f) + " must be even");
  }

  /// A seam of the cap lies in its loop twice, which leaves the parity alone.
  void add_cap_loop(FaceId f, bool has_others, const Terms& sum) {
    const double least = options_.quad_caps ? 4.0 : 3.0;
    demand(Kind::at_least, sum, least, {name_of(f)},
           "each loop of " + name_of(f) + " must have at least " +
               (least > 3.0 ? "four" : "three") + " mesh edges");
    if (has_others && options_.quad_caps)
      demand(Kind::preferably_even, sum, 0.0, {name_of(f)}, "each loop should be even");
  }

  void refuse_poles(FaceId f) {
    for (const Loop& loop : model_.loops(f))
      for (const Coedge& c : loop)
        if (!c.edge.is_valid())
          throw InputError("intervals",
                           name_of(f) +
                               " is a linking face with a pole, where a structured grid would "
                               "collapse to a point.",
                           {name_of(f)});
  }

  void add_linking(FaceId f) {
    refuse_poles(f);
    const auto& loops = model_.loops(f);
    const auto& scheme = scheme_.face[f.index];
    out_.offset[f.index].assign(loops.size(), -1);
    Terms winding;
    std::vector<std::size_t> winding_loops;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const Terms steps = walk(f, l);
      if (l > 0)
        out_.offset[f.index][l] = out_.problem.add({-unbounded, unbounded, std::nullopt, 0.0});
      if (turning_of(scheme, l) != 0) {
        demand_closed(f, steps);
      } else {
        winding.insert(winding.end(), steps.begin(), steps.end());
        winding_loops.push_back(l);
      }
    }
    if (winding_loops.empty()) return;
    demand_closed(f, winding);
    if (winding_loops.size() == 2) separate_rims(f, winding_loops[0], winding_loops[1]);
  }

  void demand_closed(FaceId f, const Terms& steps) {
    demand(Kind::equality, steps, 0.0, {name_of(f)},
           "opposite sides of " + name_of(f) + " must have the same number of mesh edges");
  }

  /// The signed steps along i of a loop; on the way, each axial edge's count is tied to its levels.
  Terms walk(FaceId f, std::size_t l) {
    Terms steps;
    const auto& loop = model_.loops(f)[l];
    for (std::size_t c = 0; c < loop.size(); ++c) {
      const Direction d = scheme_.face[f.index].direction[l][c];
      if (is_axial(d))
        tie_levels(loop[c], d);
      else
        demand_same_level(loop[c].start, loop[c].end, name_of(loop[c].edge));
      if (d == Direction::plus_i) steps.push_back({count(loop[c].edge), 1.0});
      if (d == Direction::minus_i) steps.push_back({count(loop[c].edge), -1.0});
    }
    return steps;
  }

  void tie_levels(const Coedge& c, Direction d) {
    const bool up = d == Direction::plus_k;
    const VertexId head = up ? c.end : c.start, tail = up ? c.start : c.end;
    demand(Kind::equality, {{count(c.edge), 1.0}, {level(head), -1.0}, {level(tail), 1.0}}, 0.0,
           {name_of(c.edge)}, name_of(c.edge) + " must rise from one layer to another");
  }

  /// The rim that runs along +i has the face above it.
  void separate_rims(FaceId f, std::size_t a, std::size_t b) {
    const auto& directions = scheme_.face[f.index].direction[a];
    const bool a_is_low = std::count(directions.begin(), directions.end(), Direction::plus_i) > 0;
    const auto& low = model_.loops(f)[a_is_low ? a : b].front();
    const auto& high = model_.loops(f)[a_is_low ? b : a].front();
    const int rise = add_rise(distance(model_.loops(f)[a_is_low ? b : a], model_.point(low.start)));
    demand(Kind::equality, {{rise, 1.0}, {level(high.start), -1.0}, {level(low.start), 1.0}}, 0.0,
           {name_of(f)}, name_of(f) + " must rise from one layer to another");
  }

  double distance(const Loop& loop, const Point3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Coedge& c : loop)
      if (c.edge.is_valid()) least = std::min(least, model_.distance(c.edge, p));
    return least;
  }

  /// Caps that no linking face connects (a shell between two closed surfaces): a source lies above
  /// the nearest target, by its distance in element sizes.
  void join_levels() {
    if (!scheme_.faces_with(FaceRole::linking).empty()) return;
    for (const FaceId source : scheme_.faces_with(FaceRole::source)) {
      const auto [low, high] = model_.uv_bounds(source);
      const Point3 middle = model_.point(source, 0.5 * (low + high));
      FaceId nearest;
      double apart = std::numeric_limits<double>::infinity();
      for (const FaceId target : scheme_.faces_with(FaceRole::target)) {
        const double distance = model_.distance(target, middle);
        if (distance < apart) apart = distance, nearest = target;
      }
      if (nearest.is_valid()) rise_between(nearest, source, apart);
    }
  }

  void rise_between(FaceId target, FaceId source, double apart) {
    const VertexId low = model_.loops(target).front().front().start;
    const VertexId high = model_.loops(source).front().front().start;
    const int rise = add_rise(apart);
    demand(Kind::equality, {{rise, 1.0}, {level(high), -1.0}, {level(low), 1.0}}, 0.0,
           {name_of(source), name_of(target)},
           name_of(source) + " must lie above " + name_of(target));
  }

  int add_rise(double length) {
    const double wish = std::max(1.0, length / options_.size);
    return out_.problem.add({1.0, unbounded, wish, wish});
  }

  void fix(EdgeId e, int n) {
    demand(Kind::equality, {{count(e), 1.0}}, n, {name_of(e)},
           name_of(e) + " must have " + std::to_string(n) + " mesh edges");
  }

  /// All levels in 0..n, and some cap at either end. Which caps these are is left to the solver.
  void add_layers(int n) {
    const std::string text = "there must be " + std::to_string(n) + " layers";
    Terms any_low, any_high;
    for (const FaceId f : model_.faces()) {
      if (!is_cap(f)) continue;
      const int k = level(model_.loops(f).front().front().start);
      demand(Kind::at_least, {{k, 1.0}}, 0.0, {}, text);
      demand(Kind::at_most, {{k, 1.0}}, n, {}, text);
      const int low = out_.problem.add({0.0, 1.0, std::nullopt, 0.0});
      const int high = out_.problem.add({0.0, 1.0, std::nullopt, 0.0});
      demand(Kind::at_most, {{k, 1.0}, {low, double(n)}}, n, {}, text);       // low = 1: k = 0
      demand(Kind::at_least, {{k, 1.0}, {high, -double(n)}}, 0.0, {}, text);  // high = 1: k = n
      any_low.push_back({low, 1.0});
      any_high.push_back({high, 1.0});
    }
    demand(Kind::at_least, any_low, 1.0, {}, text);
    demand(Kind::at_least, any_high, 1.0, {}, text);
  }

  const Model& model_;
  const Scheme& scheme_;
  const IntervalOptions& options_;
  IntervalDemands out_;
};

}  // namespace

int turning_of(const FaceScheme& face, std::size_t loop) {
  int sum = 0;
  for (const VertexType t : face.type[loop]) sum += static_cast<int>(t);
  return sum;
}

IntervalDemands interval_demands(const Model& model, const Scheme& scheme,
                                 const IntervalOptions& options) {
  return Builder(model, scheme, options).build();
}

}  // namespace sweepmesh
