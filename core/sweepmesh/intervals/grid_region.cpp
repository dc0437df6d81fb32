#include "sweepmesh/intervals/grid_region.h"

#include <algorithm>
#include <limits>

namespace sweepmesh {
namespace {

int index_of(Direction d) {
  return static_cast<int>(d);
}

/// A dense table over the cells of the bounding box; i wraps around on a tube.
class Box {
 public:
  Box(const std::vector<GridLoop>& loops, int period) : period_(period) {
    GridPoint low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
    GridPoint high{std::numeric_limits<int>::min(), std::numeric_limits<int>::min()};
    for (const auto& loop : loops) {
      GridPoint p = loop.start;
      for (const Direction d : loop.steps) {
        low = {std::min(low.i, p.i), std::min(low.k, p.k)};
        high = {std::max(high.i, p.i), std::max(high.k, p.k)};
        p = stepped(p, d);
      }
    }
    low_ = low;
    width_ = period > 0 ? period : high.i - low.i;
    height_ = high.k - low.k;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool is_empty() const { return width_ <= 0 || height_ <= 0; }
  GridPoint cell(int column, int row) const { return {low_.i + column, low_.k + row}; }

  /// Index of the cell whose low corner is p, or -1 outside.
  int at(GridPoint p) const {
    int column = p.i - low_.i;
    if (period_ > 0) column = ((column % period_) + period_) % period_;
    const int row = p.k - low_.k;
    if (column < 0 || column >= width_ || row < 0 || row >= height_) return -1;
    return row * width_ + column;
  }

 private:
  int period_;
  GridPoint low_;
  int width_ = 0, height_ = 0;
};

/// How often the loops wind around each cell: steps along +i open a column, those along -i close
/// it.
std::vector<int> winding_numbers(const std::vector<GridLoop>& loops, const Box& box) {
  std::vector<int> winding(box.width() * box.height(), 0);
  for (const auto& loop : loops) {
    GridPoint p = loop.start;
    for (const Direction d : loop.steps) {
      const GridPoint next = stepped(p, d);
      const int cell = box.at(d == Direction::plus_i ? p : next);
      if (!is_axial(d) && cell >= 0) winding[cell] += d == Direction::plus_i ? 1 : -1;
      p = next;
    }
  }
  for (int cell = box.width(); cell < static_cast<int>(winding.size()); ++cell)
    winding[cell] += winding[cell - box.width()];
  return winding;
}

class Filler {
 public:
  Filler(const std::vector<GridLoop>& loops, int period)
      : loops_(loops), period_(period), box_(loops, period) {}

  std::optional<GridRegion> fill() {
    if (box_.is_empty() || !all_closed()) return std::nullopt;
    const auto winding = winding_numbers(loops_, box_);
    const auto is_wrong = [](int w) { return w != 0 && w != 1; };
    if (std::any_of(winding.begin(), winding.end(), is_wrong)) return std::nullopt;
    corners_.assign(winding.size(), {-1, -1, -1, -1});
    inside_ = winding;
    for (const auto& loop : loops_)
      if (!claim_boundary(loop)) return std::nullopt;
    out_.n_boundary = static_cast<int>(out_.nodes.size());
    if (!claim_interior() || !collect_cells()) return std::nullopt;
    return std::move(out_);
  }

 private:
  bool all_closed() const {
    return std::all_of(loops_.begin(), loops_.end(), [&](const GridLoop& loop) {
      GridPoint p = loop.start;
      for (const Direction d : loop.steps) p = stepped(p, d);
      const int around = p.i - loop.start.i;
      return !loop.steps.empty() && p.k == loop.start.k &&
             (around == 0 || (period_ > 0 && around % period_ == 0));
    });
  }

  /// The cell in quadrant q (0 north-east, then counterclockwise) of a point, and which corner of
  /// that cell the point is.
  int quadrant(GridPoint p, int q) const {
    const GridPoint low{p.i - (q == 1 || q == 2), p.k - (q == 2 || q == 3)};
    return box_.at(low);
  }

  bool claim(GridPoint p, int q, int node) {
    const int cell = quadrant(p, q);
    if (cell < 0 || inside_[cell] != 1 || corners_[cell][q] >= 0) return false;
    corners_[cell][q] = node;
    return true;
  }

  /// A boundary node has the quadrants from its outgoing step counterclockwise to its incoming one:
  /// one at an END, four at a REVERSAL.
  bool claim_boundary(const GridLoop& loop) {
    GridPoint p = loop.start;
    const int n = static_cast<int>(loop.steps.size());
    for (int j = 0; j < n; ++j) {
      const int out = index_of(loop.steps[j]), in = index_of(loop.steps[(j + n - 1) % n]);
      const int around = (in + 2 - out + 4) % 4;
      const int node = static_cast<int>(out_.nodes.size());
      out_.nodes.push_back(p);
      for (int q = 0; q < (around == 0 ? 4 : around); ++q)
        if (!claim(p, (out + q) % 4, node)) return false;
      p = stepped(p, loop.steps[j]);
    }
    return true;
  }

  /// A corner that no boundary node has is an interior node, and all four of its cells must agree.
  bool claim_interior() {
    for (int row = 0; row < box_.height(); ++row) {
      for (int column = 0; column < box_.width(); ++column) {
        const GridPoint p = box_.cell(column, row);
        const int cell = box_.at(p);
        if (inside_[cell] != 1 || corners_[cell][0] >= 0) continue;
        const int node = static_cast<int>(out_.nodes.size());
        out_.nodes.push_back(p);
        for (int q = 0; q < 4; ++q)
          if (!claim(p, q, node)) return false;
      }
    }
    return true;
  }

  bool collect_cells() {
    for (std::size_t cell = 0; cell < inside_.size(); ++cell) {
      if (inside_[cell] != 1) continue;
      const auto& corners = corners_[cell];
      if (std::find(corners.begin(), corners.end(), -1) != corners.end()) return false;
      out_.cells.push_back(corners);
    }
    return !out_.cells.empty();
  }

  const std::vector<GridLoop>& loops_;
  int period_;
  Box box_;
  std::vector<int> inside_;
  std::vector<std::array<int, 4>>
      corners_;  ///< per cell and quadrant of the corner point: its node
  GridRegion out_;
};

}  // namespace

GridPoint stepped(GridPoint p, Direction d) {
  switch (d) {
    case Direction::plus_i:
      return {p.i + 1, p.k};
    case Direction::plus_k:
      return {p.i, p.k + 1};
    case Direction::minus_i:
      return {p.i - 1, p.k};
    default:
      return {p.i, p.k - 1};
  }
}

std::optional<GridRegion> fill_region(const std::vector<GridLoop>& loops, int period) {
  return Filler(loops, period).fill();
}

}  // namespace sweepmesh
