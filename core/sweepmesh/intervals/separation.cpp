#include "sweepmesh/intervals/separation.h"

#include <algorithm>
#include <optional>
#include <set>

#include "sweepmesh/intervals/grid_region.h"

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Terms = std::vector<IntegerProgram::Term>;

/// A place of a face's boundary.
struct Side {
  int loop = 0, coedge = 0;
  auto operator<=>(const Side&) const = default;
};

/// A vertex where the face's boundary turns, with its sides along k and along i.
struct Corner {
  Side axial, transverse;
  Point2 at;  ///< in the layout
};

/// A side that a line across the face meets, and where.
struct Crossing {
  Side side;
  double at = 0.0;     ///< in the layout, along the line
  bool opens = false;  ///< the face begins here, going on along the line
};

/// Lines across the face along i meet axial sides, lines along k transverse ones.
enum class Across { i, k };

/// One face with its layout and its place in the interval problem.
class FaceSides {
 public:
  FaceSides(const Model& model, const Scheme& scheme, FaceId face, const FaceLayout& layout)
      : loops_(model.loops(face)),
        directions_(scheme.face[face.index].direction),
        face_(face),
        layout_(layout),
        tolerance_(1e3 * model.tolerances().point) {}

  FaceId face() const { return face_; }
  /// Sides closer than this in the layout lie on one line.
  double tolerance() const { return tolerance_; }
  bool has_side(Across a, const Side& s) const {
    return is_axial(direction(s)) == (a == Across::i);
  }
  std::vector<Side> sides(Across a) const {
    std::vector<Side> out;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t c = 0; c < loops_[l].size(); ++c) {
        const Side s{static_cast<int>(l), static_cast<int>(c)};
        if (has_side(a, s)) out.push_back(s);
      }
    return out;
  }

  /// Where the face's interior angle is more than a half turn.
  std::vector<Corner> reentrant_corners() const {
    std::vector<Corner> out;
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const int n = static_cast<int>(loops_[l].size());
      for (int c = 0; c < n; ++c) {
        const Side before{static_cast<int>(l), (c + n - 1) % n}, after{static_cast<int>(l), c};
        const bool is_axial_after = has_side(Across::i, after);
        if (turned(direction(before), VertexType::corner) != direction(after)) continue;
        out.push_back(
            {is_axial_after ? after : before, is_axial_after ? before : after, at(after, 0.0)});
      }
    }
    return out;
  }

  bool opens(const Side& s) const {
    return direction(s) == Direction::minus_k || direction(s) == Direction::plus_i;
  }

  /// Where a line of the layout, at `height` in the other coordinate, meets a side.
  std::optional<double> meets(Across a, const Side& s, double height) const {
    const int along = a == Across::i ? 0 : 1, across = 1 - along;
    const auto& line = layout_.line[s.loop][s.coedge];
    for (std::size_t p = 0; p + 1 < line.size(); ++p) {
      const double from = line[p][across] - height, to = line[p + 1][across] - height;
      if ((from <= 0.0) == (to <= 0.0)) continue;
      const double t = from / (from - to);
      return (1.0 - t) * line[p][along] + t * line[p + 1][along];
    }
    return std::nullopt;
  }

  Point2 middle(const Side& s) const {
    const auto& line = layout_.line[s.loop][s.coedge];
    return line[line.size() / 2];
  }
  /// Layout point at a fraction of the side, from its start.
  Point2 at(const Side& s, double fraction) const {
    const auto& line = layout_.line[s.loop][s.coedge];
    const double x = fraction * static_cast<double>(line.size() - 1);
    const auto p = std::min(static_cast<std::size_t>(x), line.size() - 2);
    return line[p] + (x - static_cast<double>(p)) * (line[p + 1] - line[p]);
  }

  /// Layout points of all boundary nodes, loop by loop, at equal steps along each side.
  std::vector<Point2> boundary_points(const CountSolution& s, const IntervalDemands& d) const {
    std::vector<Point2> out;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t c = 0; c < loops_[l].size(); ++c) {
        const long n = s.values[d.edge[loops_[l][c].edge.index]];
        for (long step = 0; step < n; ++step)
          out.push_back(at({static_cast<int>(l), static_cast<int>(c)}, double(step) / n));
      }
    return out;
  }

  /// i (of an axial side) or k (of a transverse one) as a sum of unknowns.
  Terms position(Across a, const Side& s, const IntervalDemands& d) const {
    const Coedge& c = loops_[s.loop][s.coedge];
    return a == Across::k ? Terms{{d.vertex[c.start.index], 1.0}} : i_at_start(s, d);
  }

 private:
  Direction direction(const Side& s) const { return directions_[s.loop][s.coedge]; }

  Terms i_at_start(const Side& s, const IntervalDemands& d) const {
    Terms out;
    if (s.loop > 0) out.push_back({d.offset[face_.index][s.loop], 1.0});
    for (int c = 0; c < s.coedge; ++c) {
      const Direction step = direction({s.loop, c});
      const int n = d.edge[loops_[s.loop][c].edge.index];
      if (step == Direction::plus_i) out.push_back({n, 1.0});
      if (step == Direction::minus_i) out.push_back({n, -1.0});
    }
    return out;
  }

  const std::vector<Loop>& loops_;
  const std::vector<std::vector<Direction>>& directions_;
  FaceId face_;
  const FaceLayout& layout_;
  double tolerance_;
};

long value(const Terms& terms, const CountSolution& s) {
  double sum = 0.0;
  for (const auto& t : terms) sum += t.coefficient * static_cast<double>(s.values[t.variable]);
  return static_cast<long>(sum);
}

Terms difference(Terms high, const Terms& low) {
  for (const auto& t : low) high.push_back({t.variable, -t.coefficient});
  return high;
}

/// Sorted along the line; empty where the sides do not take turns, so that the layout tells
/// nothing.
std::vector<Crossing> taking_turns(std::vector<Crossing> met) {
  std::stable_sort(met.begin(), met.end(),
                   [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  for (std::size_t j = 0; j < met.size(); ++j)
    if (met[j].opens != (j % 2 == 0)) return {};
  return met.size() % 2 == 0 ? met : std::vector<Crossing>{};
}

/// Sides met by a line of the layout.
std::vector<Crossing> across_layout(const FaceSides& face, Across a, double height) {
  std::vector<Crossing> met;
  for (const Side& s : face.sides(a))
    if (const auto at = face.meets(a, s, height)) met.push_back({s, *at, face.opens(s)});
  return taking_turns(std::move(met));
}

class GapAdder {
 public:
  GapAdder(const FaceSides& face, double size, IntervalDemands& demands)
      : face_(face), size_(size), demands_(demands) {}

  /// Looks from the middle of every side of a hole.
  void add(Across a) {
    for (const Side& s : face_.sides(a)) {
      if (s.loop == 0) continue;
      const auto met = across_layout(face_, a, face_.middle(s)[a == Across::i ? 1 : 0]);
      for (std::size_t j = 0; j + 1 < met.size(); j += 2)
        if (met[j].side.loop != met[j + 1].side.loop) add_gap(a, met[j], met[j + 1]);
    }
  }

 private:
  void add_gap(Across a, const Crossing& from, const Crossing& to) {
    if (!known_.insert({from.side, to.side}).second) return;
    const double wish = std::max(1.0, (to.at - from.at) / size_);
    const int gap = demands_.problem.add({1.0, unbounded, wish, wish});
    Terms terms =
        difference(face_.position(a, from.side, demands_), face_.position(a, to.side, demands_));
    terms.insert(terms.begin(), {gap, 1.0});
    const std::string name = name_of(face_.face());
    demands_.problem.demand(
        {Kind::equality, terms, 0.0, {name}, "the holes of " + name + " must lie within it"});
  }

  const FaceSides& face_;
  double size_;
  IntervalDemands& demands_;
  std::set<std::pair<Side, Side>> known_;
};

/// The face's loops as the solution has them.
std::vector<GridLoop> grid_loops(const Model& model, const Scheme& scheme, FaceId f,
                                 const IntervalDemands& d, const CountSolution& s) {
  std::vector<GridLoop> out;
  const auto& loops = model.loops(f);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const int offset = d.offset[f.index][l];
    const long i = offset < 0 ? 0 : s.values[offset];
    const long k = s.values[d.vertex[loops[l].front().start.index]];
    out.push_back({{static_cast<int>(i), static_cast<int>(k)}, {}});
    for (std::size_t c = 0; c < loops[l].size(); ++c)
      out.back().steps.insert(out.back().steps.end(), s.values[d.edge[loops[l][c].edge.index]],
                              scheme.face[f.index].direction[l][c]);
  }
  return out;
}

/// Adds the order of one face's sides in the layout where the solution has it otherwise.
class OrderAdder {
 public:
  OrderAdder(const FaceSides& face, const CountSolution& solution, IntervalDemands& demands)
      : face_(face), solution_(solution), demands_(demands) {}

  /// Sides that see each other along lines through the quarters of every side.
  int add(Across a) {
    const int before = n_added_;
    for (const Side& s : face_.sides(a))
      for (const double fraction : {0.25, 0.5, 0.75}) {
        const auto met = across_layout(face_, a, face_.at(s, fraction)[a == Across::i ? 1 : 0]);
        for (std::size_t j = 0; j + 1 < met.size(); ++j)
          require(a, met[j].side, met[j + 1].side, j % 2 == 0 ? 1 : 0);
      }
    return n_added_ - before;
  }

  /// All sides, in the order of their middles: a weak order, equal where they lie on one line. Grid
  /// lines that are monotone in the layout can only touch where a neck between two corners
  /// collapses.
  int add_all(Across a) {
    const int before = n_added_;
    const auto sides = in_order(a);
    for (std::size_t j = 0; j + 1 < sides.size(); ++j) {
      add_order(a, sides[j], sides[j + 1], 0);
      if (place(a, sides[j + 1]) - place(a, sides[j]) <= face_.tolerance())
        add_order(a, sides[j + 1], sides[j], 0);
    }
    return n_added_ - before;
  }

  /// Two re-entrant corners in one grid point: the neck of the face between them has collapsed. It
  /// is opened in the direction in which it is longer.
  int add_necks() {
    const int before = n_added_;
    const auto corners = face_.reentrant_corners();
    for (std::size_t a = 0; a < corners.size(); ++a)
      for (std::size_t b = a + 1; b < corners.size(); ++b)
        if (coincide(corners[a], corners[b])) open_neck(corners[a], corners[b]);
    return n_added_ - before;
  }

 private:
  double place(Across a, const Side& s) const { return face_.middle(s)[a == Across::i ? 0 : 1]; }

  std::vector<Side> in_order(Across a) const {
    auto sides = face_.sides(a);
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const Side& s, const Side& t) { return place(a, s) < place(a, t); });
    return sides;
  }

  long position(Across a, const Side& s) const {
    return value(face_.position(a, s, demands_), solution_);
  }
  bool coincide(const Corner& a, const Corner& b) const {
    return position(Across::i, a.axial) == position(Across::i, b.axial) &&
           position(Across::k, a.transverse) == position(Across::k, b.transverse);
  }
  void open_neck(const Corner& a, const Corner& b) {
    const Point2 apart = b.at - a.at;
    const bool along_i = std::abs(apart.x()) > std::abs(apart.y());
    const bool is_a_first = (along_i ? apart.x() : apart.y()) > 0.0;
    const Corner &low = is_a_first ? a : b, &high = is_a_first ? b : a;
    if (along_i)
      add_order(Across::i, low.axial, high.axial, 1);
    else
      add_order(Across::k, low.transverse, high.transverse, 1);
  }

  /// Where the solution has it otherwise, and each pair once.
  void require(Across a, const Side& low, const Side& high, int least) {
    if (!known_.insert({low, high}).second) return;
    const Terms terms =
        difference(face_.position(a, high, demands_), face_.position(a, low, demands_));
    if (value(terms, solution_) < least) add_order(a, low, high, least);
  }

  void add_order(Across a, const Side& low, const Side& high, int least) {
    Terms terms = difference(face_.position(a, high, demands_), face_.position(a, low, demands_));
    if (value(terms, solution_) < least) ++n_added_;
    const std::string name = name_of(face_.face());
    demands_.problem.demand({Kind::at_least,
                             std::move(terms),
                             static_cast<double>(least),
                             {name},
                             "the sides of " + name + " must not touch or cross"});
  }

  const FaceSides& face_;
  const CountSolution& solution_;
  IntervalDemands& demands_;
  std::set<std::pair<Side, Side>> known_;
  int n_added_ = 0;
};

/// Whether a corner of a quad is folded that no interior node could unfold: it and its two
/// neighbours in the quad lie on the boundary, and turn the wrong way in the layout.
bool has_folded_corner(const GridRegion& region, const FaceSides& face,
                       const CountSolution& solution, const IntervalDemands& demands) {
  const auto at = face.boundary_points(solution, demands);
  for (const auto& cell : region.cells)
    for (int c = 0; c < 4; ++c) {
      const int a = cell[c], next = cell[(c + 1) % 4], before = cell[(c + 3) % 4];
      if (std::max({a, next, before}) >= region.n_boundary) continue;
      if (cross2(at[next] - at[a], at[before] - at[a]) <= 0.0) return true;
    }
  return false;
}

/// Steps that a loop ends beside its start: around a tube, else none.
int around(const GridLoop& loop) {
  GridPoint p = loop.start;
  for (const Direction d : loop.steps) p = stepped(p, d);
  return std::abs(p.i - loop.start.i);
}

/// Whether the loops bound a region; on a tube with some turn of the second rim against the first.
bool bound_a_region(std::vector<GridLoop> loops) {
  const int period = around(loops.front());
  if (period == 0) return fill_region(loops).has_value();
  for (int turn = 0; turn < period; ++turn) {
    if (fill_region(loops, period)) return true;
    for (std::size_t l = 1; l < loops.size(); ++l) ++loops[l].start.i;
  }
  return false;
}

/// One loop of END and SIDE vertices is a rectangle, whatever the counts.
bool is_four_sided(const FaceScheme& face) {
  const auto bends_back = [](VertexType t) { return static_cast<int>(t) < 0; };
  return face.type.size() == 1 &&
         std::none_of(face.type[0].begin(), face.type[0].end(), bends_back);
}

}  // namespace

Separation::Separation(const Model& model, const Scheme& scheme, double size)
    : model_(model), scheme_(scheme), size_(size) {
  for (const FaceId f : model.faces()) {
    if (scheme.face_role[f.index] != FaceRole::linking) continue;
    if (is_four_sided(scheme.face[f.index])) continue;
    FaceLayout layout = lay_out(model, scheme.face[f.index], f);
    if (layout.is_empty()) continue;
    faces_.push_back(f);
    layouts_.push_back(std::move(layout));
  }
}

void Separation::add_gaps(IntervalDemands& demands) const {
  for (std::size_t j = 0; j < faces_.size(); ++j) {
    const FaceSides face(model_, scheme_, faces_[j], layouts_[j]);
    GapAdder along_i(face, size_, demands), along_k(face, size_, demands);
    along_i.add(Across::i);
    along_k.add(Across::k);
  }
}

int Separation::add_violated(const CountSolution& solution, IntervalDemands& demands) const {
  int n_added = 0;
  for (std::size_t j = 0; j < faces_.size(); ++j) {
    const auto region = fill_region(grid_loops(model_, scheme_, faces_[j], demands, solution));
    const FaceSides face(model_, scheme_, faces_[j], layouts_[j]);
    OrderAdder order(face, solution, demands);
    int n_of_face = 0;
    if (!region) n_of_face = order.add(Across::i) + order.add(Across::k);
    if (n_of_face == 0 && (!region || has_folded_corner(*region, face, solution, demands)))
      n_of_face = order.add_all(Across::i) + order.add_all(Across::k);
    if (n_of_face == 0 && !region) n_of_face = order.add_necks();
    n_added += n_of_face;
  }
  return n_added;
}

std::vector<FaceId> Separation::crossed(const CountSolution& solution,
                                        const IntervalDemands& demands) const {
  std::vector<FaceId> out;
  for (const FaceId f : faces_)
    if (!bound_a_region(grid_loops(model_, scheme_, f, demands, solution))) out.push_back(f);
  return out;
}

}  // namespace sweepmesh
