#include "sweepmesh/quality/quality.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "sweepmesh/base/element_quality.h"
#include "sweepmesh/base/parallel.h"

namespace sweepmesh {
namespace {

constexpr long elements_per_chunk = 4096;

/// Corners of one element, low ring and high ring.
struct Corners {
  std::vector<Point3> low, high;
  int n = 0;

  void resize(int size) {
    n = size;
    low.resize(size);
    high.resize(size);
  }
  Point3 centre() const {
    Point3 sum = Point3::Zero();
    for (int i = 0; i < n; ++i) sum += low[i] + high[i];
    return sum / (2.0 * n);
  }
};

/// Hands out the corners of elements begin..end of a VolumeMesh.
struct MeshElements {
  const VolumeMesh& mesh;

  long size() const { return mesh.n_elements(); }

  template <class F>
  void visit(long begin, long end, F&& f) const {
    Corners corners;
    for (long e = begin; e < end; ++e) {
      gather(mesh.element(e), corners);
      f(e, corners);
    }
  }

 private:
  void gather(std::span<const int> rings, Corners& corners) const {
    const int n = static_cast<int>(rings.size()) / 2;
    corners.resize(n);
    for (int i = 0; i < n; ++i) {
      corners.low[i] = mesh.points.row(rings[i]);
      corners.high[i] = mesh.points.row(rings[n + i]);
    }
  }
};

/// The same of an extrusion, with the number of every cell's first element.
class ExtrusionElements {
 public:
  ExtrusionElements(const Extrusion& extrusion, const Points& points)
      : extrusion_(extrusion), points_(points), first_(extrusion.n_cells() + 1, 0) {
    for (int c = 0; c < extrusion.n_cells(); ++c)
      first_[c + 1] = first_[c] + extrusion.cell_k_high[c] - extrusion.cell_k_low[c];
  }

  long size() const { return first_.back(); }

  template <class F>
  void visit(long begin, long end, F&& f) const {
    Corners corners;
    long cell = std::upper_bound(first_.begin(), first_.end(), begin) - first_.begin() - 1;
    for (long e = begin; e < end; ++e) {
      while (first_[cell + 1] <= e) ++cell;
      gather(static_cast<int>(cell), static_cast<int>(e - first_[cell]), corners);
      f(e, corners);
    }
  }

 private:
  void gather(int cell, int layer, Corners& corners) const {
    const int k = extrusion_.cell_k_low[cell] + layer;
    const int* columns = extrusion_.cell_columns.data() + extrusion_.cell_offset[cell];
    corners.resize(extrusion_.cell_size(cell));
    for (int i = 0; i < corners.n; ++i) {
      const long node = extrusion_.node(columns[i], k);
      corners.low[i] = points_.row(node);
      corners.high[i] = points_.row(node + 1);
    }
  }

  const Extrusion& extrusion_;
  const Points& points_;
  std::vector<long> first_;
};

double scaled_jacobian_of(const Corners& c) {
  return scaled_jacobian(c.low.data(), c.high.data(), c.n);
}

bool is_worse(const BadElement& a, const BadElement& b) {
  return std::tie(a.scaled_jacobian, a.element) < std::tie(b.scaled_jacobian, b.element);
}

/// Takes in one value; `mean` holds the sum until the end.
void extend(Range& range, double value, bool is_first) {
  range.min = is_first ? value : std::min(range.min, value);
  range.max = is_first ? value : std::max(range.max, value);
  range.mean += value;
}

void join(Range& a, const Range& b, bool is_first) {
  a.min = is_first ? b.min : std::min(a.min, b.min);
  a.max = is_first ? b.max : std::max(a.max, b.max);
  a.mean += b.mean;
}

/// Puts one element in its place among the n worst.
void keep_worst(std::vector<BadElement>& worst, const BadElement& bad, int n) {
  const bool is_full = static_cast<int>(worst.size()) >= n;
  if (n == 0 || (is_full && !is_worse(bad, worst.back()))) return;
  if (is_full) worst.pop_back();
  worst.insert(std::upper_bound(worst.begin(), worst.end(), bad, is_worse), bad);
}

void add_element(QualityReport& report, long element, const Corners& c,
                 const QualityOptions& options) {
  const double value = scaled_jacobian_of(c);
  const bool is_first = report.n_elements == 0;
  extend(report.scaled_jacobian, value, is_first);
  extend(report.edge_ratio, edge_ratio(c.low.data(), c.high.data(), c.n), is_first);
  extend(report.skew, skew(c.low.data(), c.high.data(), c.n), is_first);
  extend(report.volume, prism_volume(c.low.data(), c.high.data(), c.n), is_first);
  ++report.n_elements;
  if (!(value > options.inverted_up_to)) ++report.n_inverted;
  const int bin = static_cast<int>((value + 1.0) * 0.5 * QualityReport::n_bins);
  ++report.histogram[std::clamp(bin, 0, QualityReport::n_bins - 1)];
  keep_worst(report.worst, {element, value, c.centre()}, options.n_worst);
}

void join(QualityReport& sum, const QualityReport& part, int n_worst) {
  const bool is_first = sum.n_elements == 0;
  join(sum.scaled_jacobian, part.scaled_jacobian, is_first);
  join(sum.edge_ratio, part.edge_ratio, is_first);
  join(sum.skew, part.skew, is_first);
  join(sum.volume, part.volume, is_first);
  sum.n_elements += part.n_elements;
  sum.n_inverted += part.n_inverted;
  for (int b = 0; b < QualityReport::n_bins; ++b) sum.histogram[b] += part.histogram[b];
  for (const BadElement& bad : part.worst) keep_worst(sum.worst, bad, n_worst);
}

template <class Elements>
QualityReport measure(const Elements& elements, const QualityOptions& options,
                      const Context& context) {
  assert(options.n_worst >= 0);
  ThreadTeam& team = team_of(context);
  std::vector<QualityReport> parts(ThreadTeam::n_chunks(elements.size(), elements_per_chunk));
  team.for_chunks(elements.size(), elements_per_chunk, [&](long begin, long end, long chunk) {
    context.check("quality");
    elements.visit(begin, end,
                   [&](long e, const Corners& c) { add_element(parts[chunk], e, c, options); });
  });
  QualityReport report;
  for (const QualityReport& part : parts) join(report, part, options.n_worst);
  report.total_volume = report.volume.mean;
  if (report.n_elements > 0)
    for (Range* r : {&report.scaled_jacobian, &report.edge_ratio, &report.skew, &report.volume})
      r->mean /= static_cast<double>(report.n_elements);
  return report;
}

template <class Elements>
std::vector<double> scaled_jacobians_of(const Elements& elements, const Context& context) {
  ThreadTeam& team = team_of(context);
  std::vector<double> values(elements.size());
  team.for_chunks(elements.size(), elements_per_chunk, [&](long begin, long end, long) {
    context.check("quality");
    elements.visit(begin, end,
                   [&](long e, const Corners& c) { values[e] = scaled_jacobian_of(c); });
  });
  return values;
}

}  // namespace

QualityReport measure_quality(const VolumeMesh& mesh, const QualityOptions& options,
                              const Context& context) {
  return measure(MeshElements{mesh}, options, context);
}

QualityReport measure_quality(const Extrusion& extrusion, const Points& points,
                              const QualityOptions& options, const Context& context) {
  assert(points.rows() == extrusion.n_nodes());
  return measure(ExtrusionElements(extrusion, points), options, context);
}

std::vector<double> scaled_jacobians(const VolumeMesh& mesh, const Context& context) {
  return scaled_jacobians_of(MeshElements{mesh}, context);
}

std::vector<double> scaled_jacobians(const Extrusion& extrusion, const Points& points,
                                     const Context& context) {
  assert(points.rows() == extrusion.n_nodes());
  return scaled_jacobians_of(ExtrusionElements(extrusion, points), context);
}

}  // namespace sweepmesh
