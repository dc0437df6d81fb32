#include "sweepmesh/volume/node_ascent.h"

#include <algorithm>
#include <limits>

#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/element_index.h"

namespace sweepmesh {
namespace {

constexpr long nodes_per_chunk = 64;

/// Columns with an element in common have different colours.
std::vector<int> colour_columns(const Extrusion& x, const CellsOfColumns& cells) {
  std::vector<int> colour(x.n_columns(), -1);
  std::vector<char> is_used;
  for (int c = 0; c < x.n_columns(); ++c) {
    is_used.assign(is_used.size(), 0);
    for (int i = cells.offset[c]; i < cells.offset[c + 1]; ++i)
      for (int j = x.cell_offset[cells.cell[i]]; j < x.cell_offset[cells.cell[i] + 1]; ++j)
        if (colour[x.cell_columns[j]] >= 0) is_used[colour[x.cell_columns[j]]] = 1;
    colour[c] = static_cast<int>(std::find(is_used.begin(), is_used.end(), 0) - is_used.begin());
    if (colour[c] == static_cast<int>(is_used.size())) is_used.push_back(0);
  }
  return colour;
}

struct FreeNode {
  int column, k;
  Point3 normal = Point3::Zero();  ///< of the plane that it stays in, if any
};

/// Free nodes in sets that move at the same time.
std::vector<std::vector<FreeNode>> independent_sets(const Extrusion& x,
                                                    const std::vector<char>& fixed,
                                                    const CellsOfColumns& cells,
                                                    const std::vector<SlidingNode>& sliding) {
  const std::vector<int> colour = colour_columns(x, cells);
  std::vector<std::vector<FreeNode>> sets;
  for (int c = 0; c < x.n_columns(); ++c)
    for (int k = x.k_low[c]; k <= x.k_high[c]; ++k) {
      const SlidingNode* plane = find_sliding(sliding, x.node(c, k));
      if (fixed[x.node(c, k)] && !plane) continue;
      const std::size_t set = 2 * colour[c] + (k - x.k_low[c]) % 2;
      if (sets.size() <= set) sets.resize(set + 1);
      sets[set].push_back({c, k, plane ? plane->normal : Point3::Zero()});
    }
  return sets;
}

struct Worth {
  double sum = 0.0, least = 1.0;
  double shortest = std::numeric_limits<double>::infinity();  ///< edge
};

/// One node, the elements around it, and its moves.
class Mover {
 public:
  Mover(const Extrusion& x, const CellsOfColumns& cells, FreeNode at, Points& points)
      : x_(x),
        points_(points),
        node_(x.node(at.column, at.k)),
        start_(points.row(node_)),
        normal_(at.normal) {
    for (int i = cells.offset[at.column]; i < cells.offset[at.column + 1]; ++i) {
      const int cell = cells.cell[i];
      if (x.cell_k_low[cell] < at.k && at.k <= x.cell_k_high[cell])
        elements_.push_back({cell, at.k - 1});
      if (x.cell_k_low[cell] <= at.k && at.k < x.cell_k_high[cell])
        elements_.push_back({cell, at.k});
      see_edges(cell, cells.corner[i], at.k);
    }
    if (at.k > x.k_low[at.column]) see_node(node_ - 1);
    if (at.k < x.k_high[at.column]) see_node(node_ + 1);
    for (const long other : others_)
      mean_ += (Point3(points_.row(other)) - start_).norm() / static_cast<double>(others_.size());
    before_ = worth();
  }

  /// A step of `length` shortest edges uphill; returns whether it was taken.
  bool go(double floor, double& length, double longest) {
    constexpr int n_trials = 3;
    constexpr double narrow = 0.3;  // of the mean edge at the node
    const Point3 uphill = gradient();
    if (elements_.empty() || !(uphill.norm() > 0.0)) return false;
    for (int trial = 0; trial < n_trials; ++trial) {
      put(start_ + length * shortest_ * uphill.normalized());
      const Worth now = worth();
      if (now.sum > before_.sum && now.least >= std::min(before_.least, floor) &&
          now.shortest >= std::min(before_.shortest, narrow * mean_)) {
        length = std::min(longest, 1.5 * length);
        return true;
      }
      length *= 0.35;
    }
    put(start_);
    return false;
  }

 private:
  void put(const Point3& p) { points_.row(node_) = p; }
  void see_node(long other) {
    others_.push_back(other);
    shortest_ = std::min(shortest_, (Point3(points_.row(other)) - start_).norm());
  }
  void see_edges(int cell, int corner, int k) {
    const int n = x_.cell_size(cell);
    for (const int next : {(corner + 1) % n, (corner + n - 1) % n}) {
      const int column = x_.cell_columns[x_.cell_offset[cell] + next];
      if (x_.k_low[column] <= k && k <= x_.k_high[column]) see_node(x_.node(column, k));
    }
  }
  Worth worth() const {
    Worth w;
    for (const SweptElement& e : elements_) {
      const double value = scaled_jacobian_of(x_, points_, e);
      w.sum += value;
      w.least = std::min(w.least, value);
    }
    for (const long other : others_)
      w.shortest = std::min(w.shortest, (points_.row(other) - points_.row(node_)).norm());
    return w;
  }
  Point3 gradient() {
    constexpr double part_of_edge = 1e-3;
    Point3 g;
    for (int d = 0; d < 3; ++d) {
      const Point3 h = part_of_edge * shortest_ * Point3::Unit(d);
      put(start_ + h);
      g[d] = worth().sum;
      put(start_ - h);
      g[d] -= worth().sum;
    }
    put(start_);
    return g - g.dot(normal_) * normal_;
  }

  const Extrusion& x_;
  Points& points_;
  long node_;
  Point3 start_, normal_;
  double shortest_ = std::numeric_limits<double>::infinity();
  double mean_ = 0.0;  ///< edge
  std::vector<long> others_;
  std::vector<SweptElement> elements_;
  Worth before_;
};

}  // namespace

void ascend_nodes(const Extrusion& extrusion, const std::vector<char>& fixed,
                  const AscentOptions& options, Points& points, ThreadTeam& team,
                  const Context& context) {
  const CellsOfColumns cells(extrusion);
  const std::vector<std::vector<FreeNode>> sets =
      independent_sets(extrusion, fixed, cells, options.sliding);
  const double floor = check_elements(extrusion, points, 0.0, team).min_scaled_jacobian;
  std::vector<double> length(fixed.size(), options.first_step);
  for (int sweep = 0; sweep < options.n_sweeps; ++sweep)
    for (const std::vector<FreeNode>& set : sets) {
      context.check("place");
      team.for_chunks(
          static_cast<long>(set.size()), nodes_per_chunk, [&](long begin, long end, long) {
            for (long i = begin; i < end; ++i) {
              const long node = extrusion.node(set[i].column, set[i].k);
              Mover(extrusion, cells, set[i], points).go(floor, length[node], options.longest_step);
            }
          });
    }
}

}  // namespace sweepmesh
