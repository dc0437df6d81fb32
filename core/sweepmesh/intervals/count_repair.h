// Even sums by the least change of counts that meet all other demands already.
#pragma once

#include <optional>
#include <vector>

#include "sweepmesh/intervals/count_reduction.h"

namespace sweepmesh {

struct RepairOptions {
  int max_step = 1;              ///< how far a count may move, >= 1
  double odd_penalty = 0.5;      ///< for each preferably even sum that stays odd
  std::size_t max_states = 500;  ///< states kept per step; beyond, only the cheapest are
};

/// `value` meets the demands `part` of `classes` but for the even ones. Returns values that meet
/// those too (preferred ones as far as they are worth their penalty), each at most `max_step` away,
/// at the least cost; or nothing where there are none. Classes marked `fixed` keep their value.
///
/// Branch and bound is lost here: its linear relaxation sees no parity at all, and n loops cost 2^n
/// nodes. This is dynamic programming over the classes instead: what has been decided so far
/// matters only through the open demands' partial sums (a bit for a parity). A demand is open from
/// its first class to its last, and the order keeps few of them open; so the cost is linear in the
/// classes for solids whose faces lie side by side, and bounded by `max_states` for any.
std::optional<std::vector<double>> repair_parity(const CountClasses& classes,
                                                 const std::vector<int>& part,
                                                 const std::vector<bool>& fixed,
                                                 const std::vector<double>& value,
                                                 const RepairOptions& options);

}  // namespace sweepmesh
