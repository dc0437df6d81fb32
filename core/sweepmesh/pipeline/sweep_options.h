// What a run of the pipeline can be told, and what follows from it for single stages.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/assess.h"

namespace sweepmesh {

enum class ElementKind { hex, prism, polyhedron };

struct SweepOptions {
  /// Wished edge length, > 0 and finite. Empty: default_size().
  std::optional<double> size;
  /// Layers from the lowest to the highest level, >= 1. Empty: from the size.
  std::optional<int> layers;
  ElementKind element = ElementKind::hex;
  int order = 1;
  // Wishes for chosen edges of the shape, see IntervalOptions; the solid takes those of its own.
  std::map<EdgeId, double> edge_size = {};
  std::map<EdgeId, int> edge_count = {};
  std::map<EdgeId, Bias> edge_bias = {};
  std::optional<Bias> sweep_bias = {};
  /// Curves of different caps are brought together where they are nearer than this, >= 0; less than
  /// an element's size makes sense. Empty: a part of the size that works (sweep() tries some).
  std::optional<double> imprint_tolerance;
  /// The run is refused (InputError that says the count) when more elements than this are to be
  /// expected, >= 1.
  long max_elements = 5'000'000;
  /// Whether schemes whose holes wind too far to be meshed (scheme/fold_bound.h) are refused before
  /// any mesh. False: they are tried all the same, as the calibration of that bound does.
  bool refuse_folds = true;
};

/// The size that fills the solid's volume with about 3000 cubes.
double default_size(const Model& model);

/// Both throw InputError.
void check_options(const SweepOptions& options);
void check_picks(const Picks& picks);

/// Whether more elements of this size are to be expected than `options` allow.
bool is_explosion(const Model& model, const SweepOptions& options, double size);
/// Throws InputError where that is so.
void refuse_explosion(const Model& model, const SweepOptions& options, double size);

/// Throws InputError where the shape has no such edge as `options` name.
IntervalOptions interval_options(const Model& model, const SweepOptions& options, double size);
/// The parts of the size within which near curves are brought together, in the order of trying.
std::vector<double> merge_fractions(const SweepOptions& options, double size);

}  // namespace sweepmesh
