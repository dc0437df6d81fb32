// Quality of a volume mesh: what each element is worth, and the summary that a report shows.
//
// The measures are those of base/element_quality.h (Verdict's scaled Jacobian and edge ratio, skew,
// volume). Two meshes can be measured: a VolumeMesh, and an Extrusion with its points, for which no
// connectivity is built. Elements are numbered hexahedra first, then prisms, then polyhedra, in a
// VolumeMesh; cell by cell, from the lowest layer up, in an Extrusion.
//
// Cost: linear, threaded; the result does not depend on the number of threads.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/volume/extrusion.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

struct QualityOptions {
  /// An element is inverted when its scaled Jacobian is not above this.
  double inverted_up_to = 0.0;
  /// How many of the worst elements are listed, >= 0.
  int n_worst = 10;
};

/// One element, of those with the least scaled Jacobian.
struct BadElement {
  long element = -1;
  double scaled_jacobian = 0.0;
  Point3 centre = Point3::Zero();  ///< mean of its corners
};

/// Least, mean and greatest value of a measure.
struct Range {
  double min = 0.0, mean = 0.0, max = 0.0;
};

struct QualityReport {
  static constexpr int n_bins = 20;

  long n_elements = 0;  ///< 0: all else is zero too
  long n_inverted = 0;
  Range scaled_jacobian, edge_ratio, skew, volume;
  double total_volume = 0.0;
  /// Elements with a scaled Jacobian in [-1 + i/10, -1 + (i+1)/10); 1 itself counts in the last.
  std::array<long, n_bins> histogram = {};
  /// Worst first; equal values in the order of the elements.
  std::vector<BadElement> worst;
};

/// Throws Cancelled; points and connectivity must fit together (asserted).
QualityReport measure_quality(const VolumeMesh& mesh, const QualityOptions& options,
                              const Context& context);
QualityReport measure_quality(const Extrusion& extrusion, const Points& points,
                              const QualityOptions& options, const Context& context);

/// Scaled Jacobian of every element, in the order of the elements.
std::vector<double> scaled_jacobians(const VolumeMesh& mesh, const Context& context);
std::vector<double> scaled_jacobians(const Extrusion& extrusion, const Points& points,
                                     const Context& context);

}  // namespace sweepmesh
