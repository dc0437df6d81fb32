// What the scheme stage needs to know of a solid, as plain numbers: who meets whom, and at what
// angle.
#pragma once

#include <array>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/ids.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/limits.h"

namespace sweepmesh {

/// One use of an edge by a loop; degenerate coedges are left out (ProblemFace::is_degenerate
/// tells). Indices are those of SweepProblem's vectors.
struct ProblemCoedge {
  int face = -1;
  int loop = -1;
  int place = -1;  ///< position in Model::loops(face)[loop]
  int edge = -1;
  int partner = -1;          ///< the other use of the edge
  int start = -1, end = -1;  ///< vertices (VertexId::index), along the loop
  double angle = 0.0;        ///< interior angle of the face where this coedge ends, radians
  Bend bend = Bend::none;    ///< of the loop around that corner
  double heading = 0.0;  ///< of the coedge's middle in the face's tangent plane, from d/du, radians
  double length = 0.0;
};

/// A loop is a run of coedges: `first` .. `first + count - 1`, in order. Loop 0 is the outer one.
struct ProblemLoop {
  int first = 0;
  int count = 0;
};

struct ProblemFace {
  FaceId id;
  std::vector<ProblemLoop> loops;
  bool is_degenerate = false;  ///< has a pole: cannot carry a structured grid
  double area = 0.0;
  Point3 normal = Point3::Zero();  ///< mean of unit normals over the face's parameter range
  int shell = 0;  ///< faces joined by edges have the same number; 0 is the first face's
};

struct ProblemEdge {
  EdgeId id;
  std::array<int, 2> coedge = {-1, -1};
  /// Angle through the material, radians: the least, the mean and the largest along the edge.
  double least = 0.0, mean = 0.0, largest = 0.0;
  bool is_seam = false;
  /// How the faces bend from each other's planes at the edge, together: where an edge is tangent
  /// and they bend outwards, a mesh made of chords still has an angle below 180 degrees there.
  Bend bend = Bend::none;
  /// The same of each coedge's face by itself.
  std::array<Bend, 2> face_bend = {Bend::none, Bend::none};
  bool is_closed = false;         ///< starts and ends at one vertex
  Point3 chord = Point3::Zero();  ///< from the start to the end of coedge[0]
  /// Unit tangents along coedge[0], at the middles of equal parts of the curve's parameter range,
  /// and the points there.
  std::array<Point3, 24> tangents, points;
};

/// Faces, coedges and edges of one solid in the order of the model's ids; a pure value.
struct SweepProblem {
  std::vector<ProblemFace> faces;
  std::vector<ProblemCoedge> coedges;
  std::vector<ProblemEdge> edges;
  int n_vertices = 0;  ///< one more than the largest vertex index in use

  /// The coedges of a face are a run too, as its loops follow one another.
  int first_coedge(int face) const {
    return faces[face].loops.empty() ? 0 : faces[face].loops.front().first;
  }
  int n_coedges(int face) const {
    int n = 0;
    for (const ProblemLoop& loop : faces[face].loops) n += loop.count;
    return n;
  }

  /// The coedge that follows `c` on its loop.
  int next(int c) const {
    const ProblemLoop& loop = faces[coedges[c].face].loops[coedges[c].loop];
    return c + 1 == loop.first + loop.count ? loop.first : c + 1;
  }
};

/// Measures a solid: interior angles at the corners of every loop, dihedral angles at five places
/// of every edge, headings at the middle of every coedge. Cost: a few evaluations an edge.
SweepProblem sweep_problem(const Model& model, const Context& context);

/// Direction of a coedge in the tangent plane of its face, from d/du, radians in -pi..pi, at a
/// fraction of the curve's parameter range, counted along the coedge.
double heading(const Model& model, const Coedge& coedge, double fraction);

/// Numbers the connected groups of faces (ProblemFace::shell); called by sweep_problem.
void number_shells(SweepProblem& problem);

}  // namespace sweepmesh
