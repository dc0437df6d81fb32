// The whole pipeline in one call: from a model and picks to a volume mesh.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/intervals/intervals.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/quality/quality.h"
#include "sweepmesh/scheme/assess.h"
#include "sweepmesh/scheme/scheme.h"
#include "sweepmesh/volume/volume_mesh.h"

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
};

struct SweepResult {
  Assessment assessment;  ///< not sweepable: the mesh is empty
  Intervals intervals;
  VolumeMesh mesh;
  QualityReport quality;  ///< of `mesh`
  double size = 0.0;      ///< the element size that was used
  std::vector<std::string> warnings;
  std::map<std::string, double>
      seconds;  ///< per stage: assess, imprint, intervals, surface, place, quality
};

/// Decides (or takes from `picks`) sources and targets, meshes caps and linking faces, and places
/// the interior. Where the best scheme cannot be meshed, the next ones are tried; the one that was
/// used is the first of result.assessment.schemes, and a warning tells of the others. Throws the
/// stages' errors; a solid that cannot be swept is a normal result with reasons, and so is one
/// whose elements stay inverted wherever the inner nodes are put (a geometric reason, no mesh).
SweepResult sweep(const Model& model, const Picks& picks, const SweepOptions& options,
                  Context& context);

// For callers that run the stages one by one, as plan.h does. The first three throw InputError.
void check_options(const SweepOptions& options);
void check_picks(const Picks& picks);
/// Throws where more elements are to be expected than `options` allow.
void refuse_explosion(const Model& model, const SweepOptions& options, double size);
/// Throws InputError where the shape has no such edge as `options` name.
IntervalOptions interval_options(const Model& model, const SweepOptions& options, double size);
/// The parts of the size within which near curves are brought together, in the order of trying.
std::vector<double> merge_fractions(const SweepOptions& options, double size);
/// Which of `n` schemes are tried, in this order: the best four, and the last two, which are
/// straight where the solid has such sweeps.
std::vector<std::size_t> tries(std::size_t n);
bool is_one_to_one(const Scheme& scheme);

/// The size that fills the solid's volume with about 3000 cubes.
double default_size(const Model& model);

}  // namespace sweepmesh
