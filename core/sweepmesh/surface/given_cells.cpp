#include "sweepmesh/surface/given_cells.h"

#include <Eigen/QR>
#include <set>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/base/point_finder.h"
#include "sweepmesh/surface/cap_map.h"

namespace sweepmesh {
namespace {

[[noreturn]] void refuse() {
  throw InvalidMeshError(
      "surface", "The mesh of the solid on the other side does not fit the boundary here.", {}, {});
}

/// Nodes on sides that have a cell on one side only.
std::set<int> outer_nodes(const FaceMesh& mesh) {
  std::set<std::pair<int, int>> sides;
  for (int c = 0; c < mesh.n_cells(); ++c) {
    const auto cell = mesh.cell(c);
    for (std::size_t i = 0; i < cell.size(); ++i)
      sides.emplace(cell[i], cell[(i + 1) % cell.size()]);
  }
  std::set<int> out;
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a})) out.insert({a, b});
  return out;
}

}  // namespace

GivenCells numbered_from(const std::vector<Point3>& boundary, const FaceMesh& mesh,
                         double tolerance) {
  GivenCells out;
  out.n_boundary = static_cast<int>(boundary.size());
  out.cell_offset = mesh.cell_offset;
  const PointFinder finder(mesh.points, tolerance);
  std::vector<int> number(mesh.points.size(), -1);
  for (int b = 0; b < out.n_boundary; ++b) {
    const int n = finder.at(boundary[b]);
    if (n < 0 || number[n] >= 0) refuse();
    number[n] = b;
  }
  for (const int n : outer_nodes(mesh))
    if (number[n] < 0) refuse();
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] < 0) {
      number[n] = out.n_boundary + static_cast<int>(out.inner.size());
      out.inner.push_back(mesh.points[n]);
    }
  for (const int n : mesh.cell_nodes) out.cell_nodes.push_back(number[n]);
  return out;
}

PlanarMesh laid_flat(const GivenCells& cells, const std::vector<Point3>& points,
                     const std::vector<Point2>& flat, const Metric& metric,
                     const Context& context) {
  Point3 middle = Point3::Zero();
  for (int n = 0; n < cells.n_boundary; ++n) middle += points[n] / cells.n_boundary;
  double reach = 0.0;
  for (int n = 0; n < cells.n_boundary; ++n) reach = std::max(reach, (points[n] - middle).norm());
  const auto row = [&](const Point3& p) -> Eigen::RowVector4d {
    const Point3 q = (p - middle) / reach;
    return {q.x(), q.y(), q.z(), 1.0};
  };
  Eigen::MatrixXd from(cells.n_boundary, 4), to(cells.n_boundary, 2);
  for (int n = 0; n < cells.n_boundary; ++n) {
    from.row(n) = row(points[n]);
    to.row(n) = flat[n].transpose();
  }
  constexpr double flatness = 1e-7;  // a boundary flatter than this says nothing of what is off it
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  fit.setThreshold(flatness);
  const Eigen::MatrixXd map = fit.compute(from).solve(to);
  PlanarMesh out;
  out.n_boundary = cells.n_boundary;
  out.cell_offset = cells.cell_offset;
  out.cell_nodes = cells.cell_nodes;
  for (const Point3& p : points) out.points.push_back((row(p) * map).transpose());
  MapOptions options;
  options.target_metric = metric;
  out.points = map_planar(out, flat, options, context).points;
  return out;
}

}  // namespace sweepmesh
