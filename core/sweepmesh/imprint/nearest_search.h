// Many questions for the nearest place on one polyline.
#pragma once

#include <cstddef>
#include <vector>

#include "sweepmesh/imprint/polyline.h"

namespace sweepmesh {

/// Gives what nearest() does, for the same cost as that once, and then for that of a search in a
/// tree of boxes around parts of the line. The first of several places equally near counts.
class NearestSearch {
 public:
  /// A line of at least two points.
  explicit NearestSearch(Polyline line);

  PolylinePoint operator()(const Point2& p) const;

 private:
  /// A box around the segments first..last-1; its halves follow it, the first one next.
  struct Node {
    Box2 box;
    std::size_t first, last, second_half;
    bool is_leaf() const { return second_half == 0; }
  };
  struct Best {
    double squared;
    std::size_t segment = 0;
    double share = 0.0;
  };
  std::size_t add_node(std::size_t first, std::size_t last);
  void look_into(const Node& leaf, const Point2& p, Best& best) const;

  Polyline line_;
  std::vector<double> arcs_;
  std::vector<Node> nodes_;
};

}  // namespace sweepmesh
