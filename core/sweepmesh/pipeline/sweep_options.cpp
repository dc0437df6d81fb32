#include "sweepmesh/pipeline/sweep_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/intervals/wishes.h"

namespace sweepmesh {
namespace {

[[noreturn]] void refuse(const std::string& sentence, std::vector<std::string> entities = {}) {
  throw InputError("options", sentence, std::move(entities));
}

/// What is said of edges of this solid; edges of other solids are left to those.
template <class Wish>
std::map<EdgeId, Wish> on_own_edges(const Model& model, const std::map<EdgeId, Wish>& wishes) {
  const auto& edges = model.edges();
  std::map<EdgeId, Wish> own;
  for (const auto& [edge, wish] : wishes) {
    if (edge.index < 0 || edge.index >= model.n_edges())
      refuse("The shape has no " + name_of(edge) + ".", {name_of(edge)});
    if (std::binary_search(edges.begin(), edges.end(), edge)) own.emplace(edge, wish);
  }
  return own;
}

std::string in_millions(double count) {
  char text[32];
  std::snprintf(text, sizeof text, count < 1e5 ? "%.0f" : "%.3g", count);
  return text;
}

double expected_count(const Model& model, const SweepOptions& options, double size) {
  const double expected = expected_elements(model, interval_options(model, options, size));
  return options.layers ? std::max(expected, static_cast<double>(*options.layers)) : expected;
}

}  // namespace

double default_size(const Model& model) {
  constexpr double n_elements = 3000;
  return std::cbrt(model.volume() / n_elements);
}

void check_options(const SweepOptions& options) {
  if (options.size && !(std::isfinite(*options.size) && *options.size > 0))
    refuse("The element size must be a positive number.");
  if (options.layers && *options.layers < 1) refuse("The number of layers must be at least 1.");
  if (options.order != 1 && options.order != 2) refuse("The element order must be 1 or 2.");
  if (options.imprint_tolerance &&
      !(std::isfinite(*options.imprint_tolerance) && *options.imprint_tolerance >= 0))
    refuse("The imprint tolerance must be a number that is not negative.");
  if (options.max_elements < 1) refuse("The limit of elements must be at least 1.");
  if (options.element == ElementKind::polyhedron && options.order == 2)
    refuse("Polyhedra have no second order; choose order 1, or hexahedra or prisms.");
}

void check_picks(const Picks& picks) {
  for (const FaceId source : picks.sources)
    if (std::find(picks.targets.begin(), picks.targets.end(), source) != picks.targets.end())
      refuse(name_of(source) + " is given as a source and as a target.", {name_of(source)});
  for (const auto& [source, target] : picks.pairs)
    if (source == target) refuse(name_of(source) + " is paired with itself.", {name_of(source)});
}

bool is_explosion(const Model& model, const SweepOptions& options, double size) {
  return expected_count(model, options, size) > static_cast<double>(options.max_elements);
}

void refuse_explosion(const Model& model, const SweepOptions& options, double size) {
  if (!is_explosion(model, options, size)) return;
  const double expected = expected_count(model, options, size);
  refuse("About " + in_millions(expected) +
         " elements are to be expected, more than the limit of " +
         in_millions(static_cast<double>(options.max_elements)) +
         "; choose a larger size, or lift the limit (max_elements).");
}

IntervalOptions interval_options(const Model& model, const SweepOptions& options, double size) {
  IntervalOptions out;
  out.size = size;
  out.layers = options.layers;
  out.edge_size = on_own_edges(model, options.edge_size);
  out.edge_count = on_own_edges(model, options.edge_count);
  out.edge_bias = on_own_edges(model, options.edge_bias);
  out.sweep_bias = options.sweep_bias;
  out.quad_caps = options.element == ElementKind::hex;
  return out;
}

std::vector<double> merge_fractions(const SweepOptions& options, double size) {
  if (options.imprint_tolerance) return {std::min(1.0, *options.imprint_tolerance / size)};
  const double usual = ImprintOptions{}.merge_fraction;
  return {usual, 0.4 * usual, 1.6 * usual, 0.1 * usual, 0.0};
}

}  // namespace sweepmesh
