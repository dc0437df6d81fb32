#include "sweepmesh/surface/submap_smooth.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "sweepmesh/surface/foldover_free_2d.h"
#include "sweepmesh/surface/linking_quality.h"

namespace sweepmesh {
namespace {

/// Positions and normals at all nodes; boundary nodes lie on their edges.
struct Lifted {
  std::vector<Point3> points, normals;
};

Lifted lift(const Model& model, FaceId face, const PlacedRegion& placed) {
  Lifted out{placed.points, {}};
  for (std::size_t n = placed.points.size(); n < placed.uv.size(); ++n)
    out.points.push_back(model.point(face, placed.uv[n]));
  for (const Point2& uv : placed.uv) out.normals.push_back(model.normal(face, uv));
  return out;
}

double cell_quality(const std::array<int, 4>& cell, const Lifted& at) {
  std::array<Point3, 4> corner, normal;
  for (int c = 0; c < 4; ++c) {
    corner[c] = at.points[cell[c]];
    normal[c] = at.normals[cell[c]];
  }
  return scaled_jacobian(corner, normal);
}

/// The chart is (u, v) or (u, -v), so that counterclockwise cells have a positive determinant in
/// it.
class Chart {
 public:
  Chart(const Model& model, FaceId face, const PlacedRegion& placed) : model_(model), face_(face) {
    double area = 0.0;
    for (const auto& cell : placed.region.cells)
      area +=
          cross2(placed.uv[cell[2]] - placed.uv[cell[0]], placed.uv[cell[3]] - placed.uv[cell[1]]);
    if (area < 0.0) sign_ = -1.0;
  }
  Point2 to(const Point2& uv) const { return {uv.x(), sign_ * uv.y()}; }

  /// S with S^T S = J^T J, from the Cholesky factor; the identity where the surface is singular.
  Eigen::Matrix2d metric(const Point2& p) const {
    Eigen::Matrix<double, 3, 2> d = model_.derivatives(face_, to(p));
    d.col(1) *= sign_;
    const Eigen::LLT<Eigen::Matrix2d> factor(Eigen::Matrix2d(d.transpose() * d));
    if (factor.info() != Eigen::Success) return Eigen::Matrix2d::Identity();
    return factor.matrixU();
  }

 private:
  const Model& model_;
  FaceId face_;
  double sign_ = 1.0;
};

/// The corner triangles of all cells, each wished as that of a rectangle of its column's width and
/// its row's height.
std::vector<MapTriangle> wished_corners(const PlacedRegion& placed) {
  const GridSpacing spacing(placed);
  std::vector<MapTriangle> out;
  for (const auto& cell : placed.region.cells) {
    const GridPoint low = placed.region.nodes[cell[0]];
    const Point2 along_i(spacing.of_column(low.i), 0.0), along_k(0.0, spacing.of_row(low.k));
    const std::array<Point2, 4> leave = {along_i, along_k, -along_i, -along_k};
    for (int c = 0; c < 4; ++c) {
      Eigen::Matrix2d wished;
      wished << leave[c], -leave[(c + 3) % 4];
      out.push_back({{cell[c], cell[(c + 1) % 4], cell[(c + 3) % 4]}, wished.inverse(), 1.0});
    }
  }
  return out;
}

}  // namespace

GridQuality judge_grid(const Model& model, FaceId face, const PlacedRegion& placed) {
  const Lifted at = lift(model, face, placed);
  const GridSpacing spacing(placed);
  GridQuality out;
  for (std::size_t j = 0; j < placed.region.cells.size(); ++j) {
    const auto& cell = placed.region.cells[j];
    const double quality = cell_quality(cell, at);
    out.min_scaled_jacobian = std::min(out.min_scaled_jacobian, quality);
    if (quality <= 0.0) out.inverted.push_back(static_cast<long>(j));
    const GridPoint low = placed.region.nodes[cell[0]];
    for (int c = 0; c < 4; ++c) {
      const double wish = c % 2 == 0 ? spacing.of_column(low.i) : spacing.of_row(low.k);
      const double length = (at.points[cell[(c + 1) % 4]] - at.points[cell[c]]).norm();
      out.max_stretch = std::max({out.max_stretch, length / wish, wish / length});
    }
  }
  return out;
}

void smooth_grid(const Model& model, FaceId face, PlacedRegion& placed, const Context& context) {
  const Chart chart(model, face, placed);
  std::vector<Point2> start;
  for (const Point2& uv : placed.uv) start.push_back(chart.to(uv));
  std::vector<char> fixed(start.size(), 0);
  std::fill_n(fixed.begin(), placed.region.n_boundary, 1);
  const auto metric = [&](const Point2& p) { return chart.metric(p); };
  const auto moved = minimise_foldover(start, fixed, wished_corners(placed), metric, {}, context);
  PlacedRegion better = placed;
  for (std::size_t n = placed.region.n_boundary; n < start.size(); ++n)
    better.uv[n] = chart.to(moved.points[n]);
  if (judge_grid(model, face, better).min_scaled_jacobian >
      judge_grid(model, face, placed).min_scaled_jacobian)
    placed = std::move(better);
}

}  // namespace sweepmesh
