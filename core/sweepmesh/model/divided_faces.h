// Faces cut along curves that lie on them: shapes for people to see and to keep.
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/model/model.h"

namespace sweepmesh {

/// A curve on a face through `points`, which lie on it. It is smooth where the points turn little
/// and has a corner where they turn more. Curves of one face that begin or end with the same number
/// meet there.
struct DividingCurve {
  std::vector<Point3> points;  ///< at least two; the first is the last for a closed curve
  int start = -1, end = -1;
};

struct FaceDivision {
  Model model;  ///< of the solid that has the face
  FaceId face;
  std::vector<DividingCurve> curves;  ///< none: the face stays whole
};

/// A piece of a face, and by which curve it lies: on the left of it, seen from outside the solid,
/// or on its right. `curve` is -1 for a piece that no curve bounds.
struct FacePiece {
  int division = -1, curve = -1;
  bool is_left = false;
};

struct DividedFaces {
  std::string faces;  ///< BREP text of a compound of faces, their normals out of the solids
  std::vector<FacePiece> pieces;  ///< of each face in `faces`
  std::string curves;             ///< BREP text of a compound with one wire a curve, in their order
};

/// Cuts each face along its curves (OpenCASCADE's splitter: a piece that closes around a seam stays
/// whole, one that crosses it is cut there). Throws SolverError("imprint") naming a face that is
/// not cut by each of its curves.
DividedFaces divide_faces(const std::vector<FaceDivision>& divisions);

}  // namespace sweepmesh
