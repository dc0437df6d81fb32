#include "sweepmesh/surface/chart.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "sweepmesh/numerics/cgal/constrained_delaunay.h"
#include "sweepmesh/surface/foldover_free_2d.h"
#include "sweepmesh/surface/quad_mesher.h"

namespace sweepmesh {
namespace {

using Triangle = std::array<int, 3>;
using Edge = std::pair<int, int>;

constexpr double most_facets = 20000.0;

std::vector<std::vector<int>> numbered(const PlanarLoops& loops) {
  std::vector<std::vector<int>> out;
  int first = 0;
  for (const auto& loop : loops) {
    out.emplace_back(loop.size());
    for (int& i : out.back()) i = first++;
  }
  return out;
}

std::set<Edge> boundary_edges(const std::vector<std::vector<int>>& loops) {
  std::set<Edge> out;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      out.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  return out;
}

/// Inside edges longer than `size`, longest first, no two of one triangle. An edge that is shorter
/// than a boundary edge of its triangle is left: that one is not split, and only a sliver along it
/// would result.
std::vector<Edge> edges_to_split(const std::vector<Triangle>& triangles,
                                 const std::set<Edge>& boundary, const std::vector<Point3>& space,
                                 double size) {
  struct Candidate {
    double length;
    Edge edge;
    int triangle;
  };
  std::vector<Candidate> all;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    constexpr double most_share = 1.25;  // of the size, what a long boundary edge may ask for
    double least = size;
    std::vector<Candidate> inside;
    for (int i = 0; i < 3; ++i) {
      const Edge e = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      const double length = (space[e.first] - space[e.second]).norm();
      if (boundary.contains(e))
        least = std::max(least, std::min(length, most_share * size));
      else
        inside.push_back({length, e, static_cast<int>(t)});
    }
    for (const Candidate& c : inside)
      if (c.length > least) all.push_back(c);
  }
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return a.length != b.length ? a.length > b.length : a.edge < b.edge;
  });
  std::vector<Edge> out;
  std::vector<char> is_used(triangles.size(), 0);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {  // the two sides of an edge follow one another
    if (all[i].edge != all[i + 1].edge) continue;
    if (is_used[all[i].triangle] || is_used[all[i + 1].triangle]) continue;
    is_used[all[i].triangle] = is_used[all[i + 1].triangle] = 1;
    out.push_back(all[i].edge);
  }
  return out;
}

/// Edges of a triangle in space, laid into the plane as columns.
Eigen::Matrix2d laid_flat(const std::vector<Point3>& p, const Triangle& t) {
  const Point3 a = p[t[1]] - p[t[0]], b = p[t[2]] - p[t[0]];
  const double along = a.norm(), dot = a.dot(b);
  Eigen::Matrix2d m;
  m << along, dot / along, 0.0, a.cross(b).norm() / along;
  return m;
}

Eigen::Matrix2d edges_of(const std::vector<Point2>& p, const Triangle& t) {
  Eigen::Matrix2d m;
  m << p[t[1]] - p[t[0]], p[t[2]] - p[t[0]];
  return m;
}

}  // namespace

Chart::Chart(const Model& model, FaceId face, const CapLoops& loops, double size,
             const Context& context, std::optional<int> outer)
    : model_(&model), face_(face), plane_(model, face, loops, outer), loops_(plane_.loops()) {
  if (!(size > 0.0)) throw InputError("surface", "The element size of a cap must be positive.");
  sort_loops();
  if (plane_.is_exact()) return;
  make_facets(std::max(size, std::sqrt(2.0 * model.area(face) / most_facets)));
  flatten(context);
  prepare_search();
}

void Chart::sort_loops() {
  order_.resize(loops_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
  const auto outer = std::find_if(order_.begin(), order_.end(),
                                  [&](int i) { return signed_area(loops_[i]) > 0.0; });
  if (outer == order_.end())
    throw InputError("surface", name_of(face_) + " has no outer boundary.", {name_of(face_)});
  std::rotate(order_.begin(), outer, outer + 1);
  PlanarLoops sorted;
  for (const int i : order_) sorted.push_back(loops_[i]);
  loops_ = std::move(sorted);
}

void Chart::make_facets(double size) {
  constexpr int max_passes = 40;
  const auto loops = numbered(loops_);
  const auto boundary = boundary_edges(loops);
  parameter_ = flattened(loops_);
  std::vector<Triangle> triangles;
  for (int pass = 0; pass < max_passes; ++pass) {
    for (std::size_t i = space_.size(); i < parameter_.size(); ++i)
      space_.push_back(model_->point(face_, plane_.uv(parameter_[i])));
    triangles = constrained_delaunay(parameter_, loops);
    const auto split = edges_to_split(triangles, boundary, space_, size);
    if (split.empty()) break;
    for (const auto& [a, b] : split) parameter_.push_back(0.5 * (parameter_[a] + parameter_[b]));
  }
  space_.resize(parameter_.size(), Point3::Zero());
  for (const Triangle& t : triangles) facets_.push_back({t, Eigen::Matrix2d::Identity()});
}

void Chart::flatten(const Context& context) {
  FoldoverOptions options;
  options.area_share = 0.5;
  options.max_iterations = 200;
  std::vector<MapTriangle> triangles;
  double area = 0.0, area_now = 0.0;
  for (const Facet& f : facets_) {
    const Eigen::Matrix2d ideal = laid_flat(space_, f.node);
    const double now = edges_of(parameter_, f.node).determinant();
    if (!(ideal.determinant() > 0.0) || !(now > 0.0)) continue;
    triangles.push_back({f.node, ideal.inverse(), ideal.determinant()});
    area += ideal.determinant();
    area_now += now;
  }
  flat_ = parameter_;
  for (Point2& p : flat_) p *= std::sqrt(area / area_now);
  const std::vector<Point2> start = flat_;
  const std::vector<char> fixed(flat_.size(), 0);
  flat_ = minimise_foldover(flat_, fixed, triangles, {}, options, context).points;
  if (!is_one_to_one()) flat_ = start;
  double area_flat = 0.0;
  for (const Facet& f : facets_) area_flat += std::max(0.0, edges_of(flat_, f.node).determinant());
  for (Point2& p : flat_) p *= std::sqrt(area / area_flat);
  std::size_t node = 0;
  for (auto& loop : loops_)
    for (Point2& p : loop) p = flat_[node++];
  for (Facet& f : facets_) {
    const Eigen::Matrix2d to_space = laid_flat(space_, f.node) * edges_of(flat_, f.node).inverse();
    const Eigen::LLT<Eigen::Matrix2d> cholesky(to_space.transpose() * to_space);
    f.root = cholesky.matrixU();
  }
}

/// The flattened boundary does not touch itself and bounds exactly the facets.
bool Chart::is_one_to_one() const {
  double inside = 0.0, bounded = 0.0;
  for (const Facet& f : facets_) {
    const double area = 0.5 * edges_of(flat_, f.node).determinant();
    if (!(area > 0.0)) return false;
    inside += area;
  }
  PlanarLoops loops;
  auto node = flat_.begin();
  for (const auto& loop : loops_) {
    loops.emplace_back(node, node + loop.size());
    bounded += signed_area(loops.back());
    node += loop.size();
  }
  return is_domain(loops) && std::abs(inside - bounded) <= model_->tolerances().relative * inside;
}

void Chart::prepare_search() {
  Point2 high = flat_[0];
  low_ = flat_[0];
  for (const Point2& p : flat_) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
  const Point2 extent = high - low_;
  cell_ = std::sqrt(extent.x() * extent.y() / static_cast<double>(facets_.size()));
  for (int axis = 0; axis < 2; ++axis) counts_[axis] = static_cast<int>(extent[axis] / cell_) + 1;
  facets_in_cell_.resize(static_cast<std::size_t>(counts_.x()) * counts_.y());
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    Eigen::Vector2i from = counts_, to = Eigen::Vector2i::Zero();
    for (const int node : facets_[f].node) {
      const Eigen::Vector2i at = ((flat_[node] - low_) / cell_).cast<int>();
      from = from.cwiseMin(at), to = to.cwiseMax(at);
    }
    for (int j = from.y(); j <= to.y(); ++j)
      for (int i = from.x(); i <= to.x(); ++i)
        facets_in_cell_[j * counts_.x() + i].push_back(static_cast<int>(f));
  }
}

Eigen::Vector3d Chart::barycentric(int facet, const Point2& p) const {
  const Triangle& t = facets_[facet].node;
  const Point2 share = edges_of(flat_, t).inverse() * (p - flat_[t[0]]);
  return {1.0 - share.sum(), share.x(), share.y()};
}

/// The facet in which the least barycentric coordinate is largest, from the grid cells around the
/// point.
int Chart::facet_at(const Point2& p, Eigen::Vector3d& coordinates) const {
  const Point2 at = (p - low_) / cell_;
  const Eigen::Vector2i centre =
      at.array().floor().cast<int>().max(0).min(counts_.array() - 1).matrix();
  int best = -1;
  double best_value = -std::numeric_limits<double>::infinity();
  for (int reach = 0; reach <= counts_.maxCoeff(); ++reach) {
    for (int j = std::max(0, centre.y() - reach);
         j <= std::min(counts_.y() - 1, centre.y() + reach); ++j)
      for (int i = std::max(0, centre.x() - reach);
           i <= std::min(counts_.x() - 1, centre.x() + reach); ++i)
        for (const int f : facets_in_cell_[j * counts_.x() + i]) {
          const Eigen::Vector3d b = barycentric(f, p);
          if (b.minCoeff() > best_value) best = f, best_value = b.minCoeff(), coordinates = b;
        }
    if (best_value >= 0.0 || (best >= 0 && reach > 0)) break;
  }
  coordinates = coordinates.cwiseMax(0.0);
  coordinates /= coordinates.sum();
  return best;
}

Point2 Chart::uv(const Point2& p) const {
  if (plane_.is_exact()) return plane_.uv(p);
  Eigen::Vector3d b;
  const Triangle& t = facets_[facet_at(p, b)].node;
  return plane_.uv(b[0] * parameter_[t[0]] + b[1] * parameter_[t[1]] + b[2] * parameter_[t[2]]);
}

Point3 Chart::point(const Point2& p) const {
  return plane_.is_exact() ? plane_.in_space(p) : model_->point(face_, uv(p));
}

Metric Chart::metric() const {
  if (plane_.is_exact()) return {};
  return [this](const Point2& p) {
    Eigen::Vector3d b;
    return facets_[facet_at(p, b)].root;
  };
}

}  // namespace sweepmesh
