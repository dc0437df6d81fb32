#include "sweepmesh/scheme/vertex_types.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/numerics/lp/integer_program.h"

namespace sweepmesh {

namespace {

constexpr std::array kTypes = {VertexType::end, VertexType::side, VertexType::corner,
                               VertexType::reversal};

double angle_change(double angle, VertexType type) {
  return std::abs(angle - ideal_angle(type));
}

int difference(VertexType a, VertexType b) {
  return std::abs(static_cast<int>(a) - static_cast<int>(b));
}

/// The integer program with, for each corner, the variables of its allowed types.
class TypeProgram {
 public:
  TypeProgram(const FaceCorners& corners, const TypeOptions& options,
              const std::vector<FixedType>& fixed)
      : corners_(corners), options_(options) {
    for (std::size_t l = 0; l < corners.size(); ++l) {
      if (l == 0 || is_per_loop()) sums_.push_back({{}, Sense::equal, sum_of(l), {}});
      for (std::size_t c = 0; c < corners[l].size(); ++c) add_corner(l, c, fixed);
    }
    for (IntegerProgram::Row& row : sums_) program_.add_row(row);
  }

  std::optional<VertexTypes> solve(Context& context) {
    Solution first = sweepmesh::solve(program_, {}, context);
    if (first.status == SolveStatus::infeasible) return {};
    break_ties(std::lround(first.objective));
    Solution second = sweepmesh::solve(program_, {}, context);
    return read(second.status == SolveStatus::infeasible ? first : second);
  }

 private:
  bool is_per_loop() const { return options_.model == TypeModel::fewest_changes; }

  double sum_of(std::size_t loop) const {
    if (is_per_loop()) return loop == 0 ? 4.0 : -4.0;
    return 4.0 - 4.0 * (corners_.size() - 1);
  }

  bool is_allowed(double angle, VertexType type) const {
    if (is_per_loop()) return is_vertex_allowed(angle, type, options_.limits);
    return difference(type, nearest_type(angle)) <= 1;
  }

  double change_count(double angle, VertexType type) const {
    const int d = difference(type, nearest_type(angle));
    return is_per_loop() ? std::min(d, 1) : d;
  }

  void add_corner(std::size_t l, std::size_t c, const std::vector<FixedType>& fixed) {
    const double angle = corners_[l][c].angle;
    IntegerProgram::Row one{{}, Sense::equal, 1.0, {}};
    const auto held = std::ranges::find_if(fixed, [&](const FixedType& f) {
      return f.loop == static_cast<int>(l) && f.corner == static_cast<int>(c);
    });
    for (VertexType type : kTypes) {
      if (held != fixed.end() ? held->type != type : !is_allowed(angle, type)) continue;
      const double count = held != fixed.end() ? 0.0 : change_count(angle, type);
      const int v = program_.add_variable({0.0, 1.0, true, count, {}});
      meaning_.push_back({l, c, type});
      one.terms.push_back({v, 1.0});
      sums_.back().terms.push_back({v, static_cast<double>(static_cast<int>(type))});
    }
    program_.add_row(one);
  }

  /// Holds the number of changes and makes the change of angle the objective.
  void break_ties(long n_changes) {
    IntegerProgram::Row held{{}, Sense::less_equal, static_cast<double>(n_changes), {}};
    for (std::size_t v = 0; v < program_.variables.size(); ++v) {
      const auto& [l, c, type] = meaning_[v];
      held.terms.push_back({static_cast<int>(v), program_.variables[v].objective});
      program_.variables[v].objective = angle_change(corners_[l][c].angle, type);
    }
    program_.add_row(held);
  }

  VertexTypes read(const Solution& solution) const {
    VertexTypes out;
    for (const auto& loop : corners_) out.type.emplace_back(loop.size(), VertexType::side);
    for (std::size_t v = 0; v < meaning_.size(); ++v) {
      if (std::lround(solution.values[v]) == 0) continue;
      const auto& [l, c, type] = meaning_[v];
      out.type[l][c] = type;
      out.n_changed += type != nearest_type(corners_[l][c].angle);
      out.change += angle_change(corners_[l][c].angle, type);
    }
    return out;
  }

  struct Meaning {
    std::size_t loop, corner;
    VertexType type;
  };

  const FaceCorners& corners_;
  const TypeOptions& options_;
  IntegerProgram program_;
  std::vector<IntegerProgram::Row> sums_;  // the rows that the types add up in
  std::vector<Meaning> meaning_;           // by variable
};

bool is_feasible(const FaceCorners& corners, const TypeOptions& options,
                 const std::vector<FixedType>& fixed, Context& context) {
  return TypeProgram(corners, options, fixed).solve(context).has_value();
}

/// Drops each fixed type that is not needed for the contradiction.
std::vector<FixedType> smallest_conflict(const FaceCorners& corners, const TypeOptions& options,
                                         Context& context) {
  std::vector<FixedType> left = options.fixed;
  for (std::size_t i = left.size(); i-- > 0;) {
    std::vector<FixedType> without = left;
    without.erase(without.begin() + i);
    if (!is_feasible(corners, options, without, context)) left = without;
  }
  return left;
}

Reason conflict_reason(const FaceCorners& corners, const std::vector<FixedType>& conflict) {
  Reason out{ReasonKind::prescribed, {}, {}};
  std::string list;
  for (const FixedType& f : conflict) {
    const FaceCorner& corner = corners[f.loop][f.corner];
    list += (list.empty() ? "" : ", ") + name_of(corner) + " as " + name_of(f.type);
    out.entities.push_back(corner.vertex.is_valid() ? name_of(corner.vertex)
                                                    : name_of(corner.edge));
  }
  out.text = "No structured grid closes with " + list +
             ": the vertex types of a loop must add up to 4 around a face and -4 around a hole. "
             "Free one of them.";
  return out;
}

Reason loop_reason(const FaceCorners& corners) {
  Reason out{ReasonKind::geometric,
             "The angles of this face allow no vertex types that add up to 4 around it and to -4 "
             "around each hole. Split an edge where a corner of the grid may be.",
             {}};
  for (const auto& loop : corners)
    for (const FaceCorner& corner : loop)
      if (corner.vertex.is_valid()) out.entities.push_back(name_of(corner.vertex));
  return out;
}

void check(const FaceCorners& corners, const std::vector<FixedType>& fixed) {
  for (const FixedType& f : fixed)
    if (f.loop < 0 || f.loop >= static_cast<int>(corners.size()) || f.corner < 0 ||
        f.corner >= static_cast<int>(corners[f.loop].size()))
      throw InputError("assess",
                       "A fixed vertex type is for a corner that the face does not have.");
}

}  // namespace

const char* name_of(VertexType type) {
  switch (type) {
    case VertexType::end:
      return "END";
    case VertexType::side:
      return "SIDE";
    case VertexType::corner:
      return "CORNER";
    case VertexType::reversal:
      return "REVERSAL";
  }
  return "";
}

std::string name_of(const FaceCorner& corner) {
  return corner.vertex.is_valid() ? name_of(corner.vertex)
                                  : "the middle of " + name_of(corner.edge);
}

VertexType nearest_type(double angle) {
  const double exact = 2 - angle / kQuarterTurn;
  return static_cast<VertexType>(std::clamp(static_cast<int>(std::floor(exact + 0.5)), -2, 1));
}

std::variant<VertexTypes, std::vector<Reason>> solve_vertex_types(const FaceCorners& corners,
                                                                  const TypeOptions& options,
                                                                  Context& context) {
  check(corners, options.fixed);
  if (auto types = TypeProgram(corners, options, options.fixed).solve(context)) return *types;
  if (!is_feasible(corners, options, {}, context)) return std::vector{loop_reason(corners)};
  return std::vector{conflict_reason(corners, smallest_conflict(corners, options, context))};
}

}  // namespace sweepmesh
