// Vertex types of one face that is to carry a structured grid, by itself: what its angles suggest,
// and the least change of that which makes the grid close.
#pragma once

#include <variant>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/ids.h"
#include "sweepmesh/scheme/limits.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// A corner of a face: a CAD vertex, or a virtual one in the middle of an edge where a round turns
/// (templates.h).
struct FaceCorner {
  VertexId vertex;  ///< invalid for a virtual one
  EdgeId edge;      ///< of a virtual one: the edge that it lies on
  double at =
      0.0;  ///< of a virtual one: fraction of the coedge's length, in the direction of the loop
  double angle = 0.0;  ///< interior angle, radians; of a virtual one: what remains of a half turn
                       ///< after the turn that it stands for
};

/// Loops of corners, the outer one first, each in the order of the loop.
using FaceCorners = std::vector<std::vector<FaceCorner>>;

/// "END" and so on.
const char* name_of(VertexType type);

/// "Vertex12", or "the middle of Edge7" of a virtual corner.
std::string name_of(const FaceCorner& corner);

/// Equation 6.1: the integer nearest to 2 (1 - angle / pi), within END and REVERSAL. Of two equally
/// near the sharper one (END before SIDE).
VertexType nearest_type(double angle);

struct FixedType {
  int loop = 0;
  int corner = 0;
  VertexType type = VertexType::side;
};

enum class TypeModel {
  /// Least number of changed types; of those, the least sum of changes of angle. Angle limits; no
  /// bound on the change.
  fewest_changes,
  /// Ruiz-Girones (A.27 to A.29): least sum of changes, each at most one, one sum for all loops, no
  /// angle limits. The reference.
  ruiz_girones
};

struct TypeOptions {
  TypeModel model = TypeModel::fewest_changes;
  AngleLimits limits;            ///< used by fewest_changes
  std::vector<FixedType> fixed;  ///< wins over the limits
};

struct VertexTypes {
  std::vector<std::vector<VertexType>> type;  ///< shaped like the corners
  int n_changed = 0;                          ///< types that differ from the nearest
  double change = 0.0;                        ///< sum of |angle - ideal angle|, radians
};

/// The linear program of the thesis, 6.22 to 6.33, solved by lp_solve: with binary x_it for "corner
/// i has type t",
///   minimise sum d_i, d_i = 1 - x_i,nearest;  sum_t x_it = 1;  sum of types = 4 (outer loop), -4
///   (each hole).
/// The thesis asks for 4 - 4g over all loops together (6.10); that each loop closes by itself is
/// our refinement. With a binary for each type its conditional constraints need no big M; for the
/// record, as printed they do not hold together:
/// - 6.15 joins alpha - nearest >= d and alpha - nearest <= -d by "and", which only d = 0 meets:
/// they are an either-or;
/// - 6.16 and 6.24 subtract M y where it has to be added, else y = 1 demands alpha - nearest >= d +
/// M;
/// - 6.21 and 6.31, 1 - alpha + M z >= 0, hold for every type: for 6.13, alpha < 0, it has to be -1
/// - alpha + M z >= 0;
/// - 6.3 is the sum of the exterior angles.
/// Ties are broken by a second program with the number of changes held and the change of angle as
/// objective. The reasons (kind prescribed) name a smallest set of fixed types that cannot hold
/// together; where even without fixed types there is no solution, one reason (geometric) names the
/// face's corners that are limited. Throws SolverError, Cancelled.
std::variant<VertexTypes, std::vector<Reason>> solve_vertex_types(const FaceCorners& corners,
                                                                  const TypeOptions& options,
                                                                  Context& context);

}  // namespace sweepmesh
