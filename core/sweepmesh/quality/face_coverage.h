// How well a mesh covers the faces of its solid: areas of its boundary against those of the model.
//
// A boundary polygon is a flat (or slightly warped) piece between nodes that lie on the face. Where
// too few of them stand for a curved face or its curved edges, or where they lie over each other,
// their areas do not add up to that of the face. No measure of single elements shows that.
//
// The area of a polygon is that of the triangles between its sides and the mean of its corners;
// mid-side nodes are left out. Cost: linear in the boundary, and one surface integral a face.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/surface_mesh.h"
#include "sweepmesh/volume/volume_mesh.h"

namespace sweepmesh {

/// A CAD face is covered poorly where the mesh misses its area by more than this part of it.
inline constexpr double kMostAreaDeviation = 0.1;

struct FaceCoverage {
  FaceId face;
  double area = 0.0;     ///< of the CAD face
  double covered = 0.0;  ///< by the polygons on it
  /// Above 0: the polygons have too much area. 0 for a face without area.
  double deviation() const { return area > 0.0 ? covered / area - 1.0 : 0.0; }
};

/// By face id: the area of each face of the solid; 0 for faces of other solids.
std::vector<double> face_areas(const Model& model);

/// Of all faces of the solid, in their order. `areas` as face_areas gives them.
std::vector<FaceCoverage> face_coverage(const Model& model, const std::vector<double>& areas,
                                        const SurfaceMesh& mesh);
std::vector<FaceCoverage> face_coverage(const Model& model, const std::vector<double>& areas,
                                        const VolumeMesh& mesh);

bool is_covered(const FaceCoverage& face);
/// The faces that are not, in a sentence each: "Face3 is covered by a mesh with ...".
std::vector<std::string> coverage_warnings(const std::vector<FaceCoverage>& all);

/// The largest deviation, without its sign; 0 without faces.
double worst_deviation(const std::vector<FaceCoverage>& all);

}  // namespace sweepmesh
