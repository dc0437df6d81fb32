#include "sweepmesh/imprint/nearest_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sweepmesh {
namespace {

double squared_distance(const Box2& box, const Point2& p) {
  return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

NearestSearch::NearestSearch(Polyline line) : line_(std::move(line)), arcs_(arc_lengths(line_)) {
  nodes_.reserve(line_.size());
  add_node(0, line_.size() - 1);
}

std::size_t NearestSearch::add_node(std::size_t first, std::size_t last) {
  constexpr std::size_t most_in_leaf = 4;
  const std::size_t node = nodes_.size();
  Box2 box{line_[first], line_[first]};
  for (std::size_t i = first + 1; i <= last; ++i) {
    box.low = box.low.cwiseMin(line_[i]);
    box.high = box.high.cwiseMax(line_[i]);
  }
  nodes_.push_back({box, first, last, 0});
  if (last - first <= most_in_leaf) return node;
  const std::size_t middle = first + (last - first) / 2;
  add_node(first, middle);
  const std::size_t second = add_node(middle, last);
  nodes_[node].second_half = second;
  return node;
}

void NearestSearch::look_into(const Node& leaf, const Point2& p, Best& best) const {
  for (std::size_t i = leaf.first; i < leaf.last; ++i) {
    const SegmentPlace place = nearest_on_segment(line_[i], line_[i + 1], p);
    if (place.squared > best.squared || (place.squared == best.squared && i > best.segment))
      continue;
    best = {place.squared, i, place.share};
  }
}

PolylinePoint NearestSearch::operator()(const Point2& p) const {
  Best best{std::numeric_limits<double>::infinity()};
  constexpr std::size_t deepest = 64;
  std::array<std::pair<double, std::size_t>, deepest> waiting;  // distance, node
  std::size_t n = 0;
  waiting[n++] = {0.0, 0};
  while (n > 0) {
    const auto [distance, at] = waiting[--n];
    if (distance > best.squared) continue;
    const Node& node = nodes_[at];
    if (node.is_leaf()) {
      look_into(node, p, best);
      continue;
    }
    std::pair near{squared_distance(nodes_[at + 1].box, p), at + 1};
    std::pair far{squared_distance(nodes_[node.second_half].box, p), node.second_half};
    if (far.first < near.first) std::swap(near, far);
    waiting[n++] = far;
    waiting[n++] = near;
  }
  const std::size_t i = best.segment;
  return {line_[i] + best.share * (line_[i + 1] - line_[i]),
          arcs_[i] + best.share * (arcs_[i + 1] - arcs_[i]), static_cast<double>(i) + best.share,
          std::sqrt(best.squared)};
}

}  // namespace sweepmesh
