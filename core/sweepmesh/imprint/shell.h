// A sweep through the thickness of a wall: sources and targets divided alike, where no plane shows
// all of them at once.
//
// The *shell* is one surface with two images: its *high* image lies on the sources, its *low* one
// on the targets. Patches are the caps, or pieces of them where a cap cannot be laid flat whole:
//
//      a band (a pipe's wall)      cut from rim to rim              .--------.      +--------+
//      a closed ball               cut along a girdle         |    (    ..    )  -> |  |  |  |
//      a ring torus                cut along both its circles |     '--------'      +--------+
//
// A cut is an edge of the shell on both images, with the same patch on both sides or with two.
#pragma once

#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/imprint/shell_match.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/numerics/cgal/arrangement.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// Where a shell edge lies on one side: a whole CAD edge, or a curve inside a cap.
struct ShellTrace {
  EdgeId edge;               ///< the CAD edge; invalid for a curve inside a cap
  bool is_reversed = false;  ///< of a CAD edge: it runs from the shell edge's end to its start
  FaceId face;               ///< the cap, for a curve inside one
  /// Of a curve inside a cap: parameters from start to end without a jump; empty for the straight
  /// line between the ends.
  std::vector<Point2> uv;
};

struct ShellEdge {
  int start = -1, end = -1;  ///< vertices; equal for a closed edge
  ShellTrace high, low;
};

struct ShellPatch {
  FaceId source, target;
  /// Edges with the patch on their left, seen from outside the source. An edge may be there twice,
  /// once each way: a cut with the patch on both sides.
  std::vector<std::vector<DirectedEdge>> loops;
};

struct Shell {
  int n_vertices = 0;
  std::vector<ShellEdge> edges;
  std::vector<ShellPatch> patches;
};

/// Whether a scheme asks for a shell: closed or banded caps, columns without a common direction
/// or path,
/// or, between caps that are divided alike, columns that fan out from it or caps that stand on edge
/// seen along it (a sheet that is bent over).
bool is_shell_like(const Model& model, const Scheme& scheme);

/// Whether a scheme that asks for a shell has one: sources and targets are divided alike, or one
/// side can be carried to the other. True where it asks for none. Cheap, beside an imprint.
bool may_be_shell(const Model& model, const Scheme& scheme);

/// The shell of a scheme. Throws ImprintError (unreachable) where sources and targets are divided
/// differently, or a cap closes on itself in a way that no cut is known for.
Shell find_shell(const Model& model, const Scheme& scheme, const Context& context);

}  // namespace sweepmesh
