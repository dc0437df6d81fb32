// One plane that divides a solid that cannot be swept into pieces that can.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sweepmesh/model/plane_cut.h"
#include "sweepmesh/scheme/assess.h"

namespace sweepmesh {

struct CutOptions {
  int max_tries = 24;    ///< planes that are tried, >= 1
  int max_pieces = 4;    ///< a plane that leaves more is not offered, >= 2
  double seconds = 5.0;  ///< no further plane is tried after that, > 0
  /// Whether a piece can be meshed. Empty: pieces are judged by their verdict alone.
  std::function<bool(const Model&, Context&)> can_mesh = {};
  double trial_seconds = 20.0;  ///< no further plane's pieces are meshed after that, > 0
};

/// A plane and what it leaves: every piece can be swept (assess), and touches the others over the
/// faces of the cut only.
struct SuggestedCut {
  Plane plane;
  FaceId face;  ///< the plane face that it extends; invalid where it extends none
  CutPieces cut;
  double cost = 0.0;      ///< sum of the costs of the pieces' best schemes
  bool is_tried = false;  ///< the pieces have been meshed
};

/// Planes that may part what cannot be swept together, the most promising first: those of plane
/// faces with a re-entrant edge (faces and edges named by the reasons first, then by area), those
/// of plane closed edges, the middles between voids, and the middles of the solid across the
/// directions of its plane faces, or across the axes. No two are the same.
std::vector<SuggestedCut> cut_candidates(const Model& model, const std::vector<Reason>& reasons);

/// Tries the candidates, each exactly: the solid is cut and all pieces are assessed. Of those that
/// help the one with the fewest pieces is taken, then one that extends a face, then the one of
/// least cost: the first whose pieces can be meshed, where `can_mesh` is given, or the first that
/// there was no time to try. Empty where none helps. Up to the time limits the answer is always the
/// same. Throws Cancelled.
std::optional<SuggestedCut> suggest_cut(const Model& model, const std::vector<Reason>& reasons,
                                        const CutOptions& options, Context& context);

/// "Cut it ... : each of the pieces can then be swept.", and whether that was tried.
std::string sentence_of(const SuggestedCut& cut);

}  // namespace sweepmesh
