#include "sweepmesh/quality/face_coverage.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace sweepmesh {
namespace {

template <class PointAt>
double area_of(std::span<const int> polygon, const PointAt& point) {
  Point3 middle = Point3::Zero();
  for (const int n : polygon) middle += point(n);
  middle /= static_cast<double>(polygon.size());
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 a = point(polygon[i]), b = point(polygon[(i + 1) % polygon.size()]);
    twice += (a - middle).cross(b - middle).norm();
  }
  return 0.5 * twice;
}

/// Polygons in compressed rows, each with its face.
template <class PointAt>
std::vector<FaceCoverage> coverage_of(const Model& model, const std::vector<double>& areas,
                                      const std::vector<int>& offset, const std::vector<int>& nodes,
                                      const std::vector<FaceId>& faces, const PointAt& point) {
  std::vector<double> covered(areas.size(), 0.0);
  for (std::size_t p = 0; p < faces.size(); ++p)
    covered[faces[p].index] +=
        area_of(std::span(nodes).subspan(offset[p], offset[p + 1] - offset[p]), point);
  std::vector<FaceCoverage> out;
  for (const FaceId f : model.faces()) out.push_back({f, areas[f.index], covered[f.index]});
  return out;
}

}  // namespace

std::vector<double> face_areas(const Model& model) {
  std::vector<double> out(model.n_faces(), 0.0);
  for (const FaceId f : model.faces()) out[f.index] = model.area(f);
  return out;
}

std::vector<FaceCoverage> face_coverage(const Model& model, const std::vector<double>& areas,
                                        const SurfaceMesh& mesh) {
  return coverage_of(model, areas, mesh.cell_offset, mesh.cell_nodes, mesh.cell_face,
                     [&](int n) -> Point3 { return mesh.points[n]; });
}

std::vector<FaceCoverage> face_coverage(const Model& model, const std::vector<double>& areas,
                                        const VolumeMesh& mesh) {
  return coverage_of(model, areas, mesh.boundary_offset, mesh.boundary_nodes, mesh.boundary_face,
                     [&](int n) -> Point3 { return mesh.points.row(n); });
}

bool is_covered(const FaceCoverage& face) {
  return std::abs(face.deviation()) <= kMostAreaDeviation;
}

std::vector<std::string> coverage_warnings(const std::vector<FaceCoverage>& all) {
  std::vector<std::string> out;
  for (const FaceCoverage& f : all) {
    if (is_covered(f)) continue;
    const long percent = std::lround(100.0 * std::abs(f.deviation()));
    out.push_back("The mesh of " + name_of(f.face) + " has " + std::to_string(percent) + " % " +
                  (f.deviation() > 0.0 ? "more" : "less") +
                  " area than the face: choose a smaller element size, or more mesh edges there.");
  }
  return out;
}

double worst_deviation(const std::vector<FaceCoverage>& all) {
  double worst = 0.0;
  for (const FaceCoverage& f : all) worst = std::max(worst, std::abs(f.deviation()));
  return worst;
}

}  // namespace sweepmesh
