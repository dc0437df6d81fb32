#include "sweepmesh/intervals/wishes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

const char* const stage = "intervals";

bool is_positive(double x) {
  return std::isfinite(x) && x > 0.0;
}

std::string text_of(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", x);
  return buffer;
}

void check_edge(const Model& model, EdgeId edge) {
  const auto& edges = model.edges();
  if (!std::binary_search(edges.begin(), edges.end(), edge))
    throw InputError(stage, "The solid has no edge " + name_of(edge) + ".", {name_of(edge)});
}

void check(const Model& model, const IntervalOptions& o) {
  if (!is_positive(o.size))
    throw InputError(stage,
                     "The element size must be a positive number, not " + text_of(o.size) + ".");
  if (!is_positive(o.max_turn))
    throw InputError(stage, "The largest turn must be a positive angle.");
  if (o.layers && *o.layers < 1) throw InputError(stage, "There must be at least one layer.");
  for (const auto& [edge, size] : o.edge_size) {
    check_edge(model, edge);
    if (!is_positive(size))
      throw InputError(stage, "The size on " + name_of(edge) + " must be positive.",
                       {name_of(edge)});
  }
  for (const auto& [edge, count] : o.edge_count) {
    check_edge(model, edge);
    if (count < 1)
      throw InputError(stage, "The count on " + name_of(edge) + " must be at least one.",
                       {name_of(edge)});
  }
  if (o.sweep_bias && !is_positive(o.sweep_bias->ratio))
    throw InputError(stage, "The bias along the sweep must be positive.");
  for (const auto& [a, b] : o.equal_edges) {
    check_edge(model, a);
    check_edge(model, b);
  }
  for (const auto& [edge, bias] : o.edge_bias) {
    check_edge(model, edge);
    if (!is_positive(bias.ratio))
      throw InputError(stage, "The bias on " + name_of(edge) + " must be positive.",
                       {name_of(edge)});
  }
}

/// Angle through which the edge's tangent turns, by samples: enough for arcs and smooth splines.
double turn_of(const Model& model, EdgeId edge) {
  const int n_samples = 32;
  const auto [first, last] = model.range(edge);
  double turn = 0.0;
  Point3 before = model.tangent(edge, first);
  for (int s = 1; s <= n_samples; ++s) {
    const Point3 now = model.tangent(edge, first + (last - first) * s / n_samples);
    turn += std::atan2(before.cross(now).norm(), before.dot(now));
    before = now;
  }
  return turn;
}

double wish_of(const Model& model, const IntervalOptions& o, EdgeId edge) {
  const auto own = o.edge_size.find(edge);
  const double size = own == o.edge_size.end() ? o.size : own->second;
  return std::max({1.0, model.length(edge) / size, turn_of(model, edge) / o.max_turn});
}

double expected_on(const Model& model, const IntervalOptions& o, EdgeId edge) {
  if (const auto count = o.edge_count.find(edge); count != o.edge_count.end()) return count->second;
  const auto own = o.edge_size.find(edge);
  return std::max(1.0, model.length(edge) / (own == o.edge_size.end() ? o.size : own->second));
}

}  // namespace

std::vector<double> wished_counts(const Model& model, const IntervalOptions& options) {
  check(model, options);
  const double limit = 1e7;  // more on one edge overflows nothing yet, and no mesh has it
  std::vector<double> out(model.n_edges(), 0.0);
  for (const EdgeId e : model.edges()) {
    out[e.index] = wish_of(model, options, e);
    if (out[e.index] > limit)
      throw InputError(stage,
                       "The element size " + text_of(options.size) + " asks for " +
                           text_of(out[e.index]) + " mesh edges on " + name_of(e) + ".",
                       {name_of(e)});
  }
  return out;
}

double importance(const IntervalOptions& options, EdgeId edge) {
  return options.edge_size.contains(edge) ? 1000.0 : 1.0;
}

int least_count(const IntervalOptions& options, EdgeId edge) {
  const auto least = options.least_count.find(edge);
  if (least == options.least_count.end() || options.edge_count.contains(edge)) return 1;
  return std::max(1, least->second);
}

double expected_elements(const Model& model, const IntervalOptions& options) {
  double on_edges = 0.0;
  for (const EdgeId e : model.edges()) on_edges += expected_on(model, options, e);
  return std::max(on_edges, model.volume() / std::pow(options.size, 3));
}

}  // namespace sweepmesh
