// Sides of a linking face that must not touch: offsets of holes as unknowns, and order along i and
// k.
//
//      +-----------------+     The steps along a loop say nothing of where a hole lies in its face,
//      nor |   a +----+ b    |     whether two arms of a face overlap. The layout of the face does:
//      on a line
//      |<--->|    |<---->|     across it, sides where the face begins and sides where it ends take
//      turns. |     +----+      |     From one that begins to the next that ends (the gaps in the
//      drawing) there
//      +-----------------+     must be at least one quad; from an end to the next begin, none or
//      more.
#pragma once

#include <vector>

#include "sweepmesh/intervals/face_layout.h"
#include "sweepmesh/intervals/interval_demands.h"

namespace sweepmesh {

class Separation {
 public:
  Separation(const Model& model, const Scheme& scheme, double size);

  /// Ties every hole to what lies around it: each gap between a hole's side and the next side of
  /// another loop becomes a count of its own, at least 1, wished as its length in the layout over
  /// the size.
  void add_gaps(IntervalDemands& demands) const;

  /// For every face whose loops bound no region in the solution: the order of sides that see each
  /// other in the layout, where the solution has it otherwise, as further demands on i or k; where
  /// that is not the cause, or a quad is folded by boundary nodes alone, the order of all its
  /// sides; where a neck between two re-entrant corners has collapsed, that it opens. Returns how
  /// many were added that the solution violates; none means that nothing is wrong, or nothing that
  /// order could mend.
  int add_violated(const CountSolution& solution, IntervalDemands& demands) const;

  /// The faces whose loops bound no region in the solution.
  std::vector<FaceId> crossed(const CountSolution& solution, const IntervalDemands& demands) const;

 private:
  const Model& model_;
  const Scheme& scheme_;
  double size_;
  std::vector<FaceId> faces_;        ///< linking faces that are not simply four-sided
  std::vector<FaceLayout> layouts_;  ///< of `faces_`
};

}  // namespace sweepmesh
