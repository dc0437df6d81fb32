// The caps divided so that every piece of a source lies over exactly one piece of a target.
//
// All columns of a sweep stand on one plane *reference domain* R: a linking face is a curve there
// with a range of levels, a cap is a region at one level, an edge of a cap a curve at one level.
// Laid over each other, these curves divide R into *patches*. A *run* is what the solid holds over
// a patch without interruption: a target below, a source above. A patch with several runs has a
// slot.
//
//        source A   | source B          R:  +-----+-----+
//        +----------+                       |  1  |  2  |    edges know which CAD edges they
//        |    1     |  2  +--- ..           +-----+-----+    stand for; a wall's lower and upper
//        |          |     |                 |  3  |  4  |    edge are one curve in R.
//        +----------+-----+                 +-----+-----+
//             target
#pragma once

#include <string>
#include <vector>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/base/geometry.h"
#include "sweepmesh/base/ids.h"
#include "sweepmesh/numerics/cgal/arrangement.h"

namespace sweepmesh {

/// A part of a CAD edge that an imprint edge stands for.
struct Trace {
  EdgeId edge;
  int level = 0;       ///< of the CAD edge
  double first, last;  ///< parameters on the CAD edge at the imprint edge's start and end
};

struct ImprintVertex {
  Point2 point;
  std::vector<VertexId> cad;  ///< CAD vertices of this column, ascending; empty at a crossing
};

struct ImprintEdge {
  int start = -1, end = -1;    ///< vertices; equal for a closed edge
  std::vector<Point2> points;  ///< in R, both ends included
  std::vector<Trace> traces;   ///< ascending levels
};

struct Run {
  int low = 0, high = 0;  ///< levels, low < high
  FaceId target, source;  ///< the caps there
};

struct Patch {
  /// Edges with the patch on their left: the outer loop first, then holes.
  std::vector<std::vector<DirectedEdge>> loops;
  std::vector<Run> runs;  ///< ascending, at least one
};

/// Curves that were brought together because they lie nearer than the merge distance.
struct Merge {
  EdgeId kept, merged;
  double distance = 0.0;  ///< the largest between them, where they are one; a length of the model
};

struct Imprint {
  double unit = 1.0;              ///< the length by which R is measured: the element size
  std::vector<int> vertex_level;  ///< by VertexId (sweep_levels.h)
  std::vector<ImprintVertex> vertices;
  std::vector<ImprintEdge> edges;
  std::vector<Patch> patches;
  /// By EdgeId: the imprint edges that make up a transverse edge, or an edge between two caps, from
  /// its start to its end; empty for all others.
  std::vector<std::vector<DirectedEdge>> chain;
  std::vector<Merge> merges;
};

enum class ImprintFailure {
  unreachable,  ///< a curve cannot be brought to the reference domain
  collision,    ///< two curves of the same levels lie over each other
  open_run,     ///< what bounds a column below or above is not one target and one source
  no_room       ///< a target and the source above it lie at the same level
};

/// The curves cannot be imprinted: the entities are those that stand in each other's way.
class ImprintError : public Error {
 public:
  ImprintError(ImprintFailure failure, const std::string& sentence,
               std::vector<std::string> entities)
      : Error("imprint", sentence, std::move(entities)), failure_(failure) {}
  ImprintFailure failure() const { return failure_; }

 private:
  ImprintFailure failure_;
};

}  // namespace sweepmesh
