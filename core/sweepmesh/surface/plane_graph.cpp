#include "sweepmesh/surface/plane_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sweepmesh {

int PlaneGraph::add_edge(int a, int b) {
  const int dart = static_cast<int>(origin_.size());
  origin_.insert(origin_.end(), {a, b});
  twin_.insert(twin_.end(), {dart + 1, dart});
  return dart;
}

bool PlaneGraph::is_alive(int dart) const {
  return std::ranges::count(around_[origin_[dart]], dart) > 0;
}

int PlaneGraph::next(int dart) const {
  const auto& row = around_[origin_[twin_[dart]]];
  const auto at = std::ranges::find(row, twin_[dart]);
  return at == row.begin() ? row.back() : *(at - 1);
}

void PlaneGraph::remove(int dart) {
  for (const int d : {dart, twin_[dart]}) std::erase(around_[origin_[d]], d);
}

void PlaneGraph::simplify() {
  std::vector<int> queue(around_.size() - n_kept_);
  std::iota(queue.begin(), queue.end(), n_kept_);
  while (!queue.empty()) {
    const int node = queue.back();
    queue.pop_back();
    if (node < n_kept_ || around_[node].empty() || valence(node) > 2) continue;
    const int first = around_[node].front(), last = around_[node].back();
    const int before = twin_[first], behind = twin_[last];
    if (first == last || origin_[before] == origin_[behind]) {
      queue.push_back(origin_[before]);
      remove(first);
      if (first != last) remove(last);
      continue;
    }
    around_[node].clear();
    twin_[before] = behind;
    twin_[behind] = before;
  }
}

void PlaneGraph::contract(const std::vector<int>& darts) {
  const int node = origin_[darts[0]];
  std::vector<int> all;
  for (std::size_t i = 0; i < darts.size(); ++i) {
    auto& row = around_[origin_[darts[i]]];
    // Around the corner come the face's dart, the other one of its sides, and what stays.
    std::ranges::rotate(row, std::ranges::find(row, darts[i]));
    all.insert(all.end(), row.begin() + 2, row.end());
    row.clear();
  }
  for (const int d : all) origin_[d] = node;
  around_[node] = std::move(all);
}

std::vector<char> PlaneGraph::reached_from(std::vector<int> front) const {
  std::vector<char> is_reached(around_.size(), 0);
  for (const int n : front) is_reached[n] = 1;
  while (!front.empty()) {
    const int node = front.back();
    front.pop_back();
    for (const int d : around_[node])
      if (const int to = origin_[twin_[d]]; !std::exchange(is_reached[to], 1)) front.push_back(to);
  }
  return is_reached;
}

void PlaneGraph::clear_unreached(const std::vector<char>& is_reached) {
  for (int n = 0; n < n_nodes(); ++n)
    if (!is_reached[n]) around_[n].clear();
}

}  // namespace sweepmesh
