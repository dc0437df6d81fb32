#include "sweepmesh/intervals/separation.h"

#include <algorithm>
#include <optional>
#include <set>

namespace sweepmesh {
namespace {

using Kind = CountProblem::Kind;
using Terms = std::vector<IntegerProgram::Term>;

/// A place of a face's boundary.
struct Side {
  int loop = 0, coedge = 0;
  auto operator<=>(const Side&) const = default;
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
        layout_(layout) {}

  FaceId face() const { return face_; }
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

  /// i (of an axial side) or k (of a transverse one) as a sum of unknowns.
  Terms position(Across a, const Side& s, const IntervalDemands& d) const {
    const Coedge& c = loops_[s.loop][s.coedge];
    return a == Across::k ? Terms{{d.vertex[c.start.index], 1.0}} : i_at_start(s, d);
  }

  /// Range of the other coordinate that a side covers: its start and end there.
  std::pair<Terms, Terms> extent(Across a, const Side& s, const IntervalDemands& d) const {
    const Coedge& c = loops_[s.loop][s.coedge];
    if (a == Across::i) return {{{d.vertex[c.start.index], 1.0}}, {{d.vertex[c.end.index], 1.0}}};
    Terms end = i_at_start(s, d);
    end.push_back({d.edge[c.edge.index], direction(s) == Direction::plus_i ? 1.0 : -1.0});
    return {i_at_start(s, d), end};
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

/// Order of the sides in the strips between the whole numbers where sides begin or end.
class OrderChecker {
 public:
  OrderChecker(const FaceSides& face, Across a, const CountSolution& solution,
               IntervalDemands& demands)
      : face_(face), across_(a), demands_(demands), sides_(face.sides(a)) {
    for (const Side& s : sides_) {
      const auto [start, end] = face.extent(a, s, demands);
      start_.push_back(value(start, solution));
      end_.push_back(value(end, solution));
      position_.push_back(value(face.position(a, s, demands), solution));
    }
  }

  int check() {
    std::set<long> breaks(start_.begin(), start_.end());
    breaks.insert(end_.begin(), end_.end());
    for (auto b = breaks.begin(); b != breaks.end() && std::next(b) != breaks.end(); ++b)
      check_strip(0.5 * static_cast<double>(*b + *std::next(b)));
    return n_added_;
  }

 private:
  void check_strip(double middle) {
    std::vector<Crossing> met;
    for (std::size_t j = 0; j < sides_.size(); ++j) {
      const double fraction = (middle - start_[j]) / static_cast<double>(end_[j] - start_[j]);
      if (!(fraction > 0.0 && fraction < 1.0)) continue;
      const double at = face_.at(sides_[j], fraction)[across_ == Across::i ? 0 : 1];
      met.push_back({sides_[j], at, face_.opens(sides_[j])});
    }
    met = taking_turns(std::move(met));
    for (std::size_t j = 0; j + 1 < met.size(); ++j)
      require(met[j].side, met[j + 1].side, j % 2 == 0 ? 1 : 0);
  }

  void require(const Side& low, const Side& high, int least) {
    if (position_of(high) - position_of(low) >= least || !known_.insert({low, high}).second) return;
    const std::string name = name_of(face_.face());
    Terms terms =
        difference(face_.position(across_, high, demands_), face_.position(across_, low, demands_));
    demands_.problem.demand({Kind::at_least,
                             std::move(terms),
                             static_cast<double>(least),
                             {name},
                             "the sides of " + name + " must not touch or cross"});
    ++n_added_;
  }

  long position_of(const Side& s) const {
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), s);
    return position_[static_cast<std::size_t>(at - sides_.begin())];
  }

  const FaceSides& face_;
  Across across_;
  IntervalDemands& demands_;
  std::vector<Side> sides_;
  std::vector<long> start_, end_, position_;
  std::set<std::pair<Side, Side>> known_;
  int n_added_ = 0;
};

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
    const FaceSides face(model_, scheme_, faces_[j], layouts_[j]);
    for (const Across a : {Across::i, Across::k})
      n_added += OrderChecker(face, a, solution, demands).check();
  }
  return n_added;
}

}  // namespace sweepmesh
