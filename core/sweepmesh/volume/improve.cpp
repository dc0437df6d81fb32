#include "sweepmesh/volume/improve.h"

#include <algorithm>

#include "sweepmesh/volume/element_check.h"
#include "sweepmesh/volume/raise_least.h"

namespace sweepmesh {
namespace {

/// Elements below a threshold that could be better.
struct Candidates {
  double least = 1.0;          ///< of all elements
  double least_bound = 1.0;    ///< by the boundary, of those below the threshold
  std::vector<long> elements;  ///< ascending
};

class Improver {
 public:
  Improver(const Extrusion& x, const std::vector<char>& fixed, const BaseMetric& metric,
           const ImproveOptions& options, Points& points, ThreadTeam& team, const Context& context)
      : x_(x),
        fixed_(fixed),
        metric_(metric),
        options_(options),
        points_(points),
        team_(team),
        context_(context),
        index_(x) {}

  double run(double least) {
    constexpr int most_lifts = 4, even = 1, worst_first = 4;
    if (least <= options_.up_to) least = follow_energy(options_.up_to, even);
    for (int lift = 0; lift < most_lifts && least < options_.lift_below; ++lift) {
      const double before = least;
      least = follow_energy(least + options_.lift_within, worst_first);
      if (least < before + worth_it()) break;
    }
    // First within the boundary's mesh as it is: from there sliding nodes find more often on.
    const Points whole = points_;
    RaiseOptions how;
    how.lengths_of = &whole;
    least = raise(least, how);
    how.sliding = options_.sliding;
    how.curved = options_.curved;
    return how.sliding.empty() && how.curved.nodes.empty() ? least : raise(least, std::move(how));
  }

 private:
  /// A gain, or room below what the boundary allows, that is worth the work.
  double worth_it() const { return 0.25 * options_.lift_within; }

  Candidates find(double threshold, double room, const std::vector<char>& held) const {
    const ElementCheck check = check_elements(x_, points_, threshold, team_);
    Candidates out{check.min_scaled_jacobian, 1.0, {}};
    std::vector<std::pair<double, long>> found;
    for (const long e : check.bad) {
      const SweptElement element = index_.element(e);
      const double value = scaled_jacobian_of(x_, points_, element),
                   bound = bound_by_boundary(x_, held, points_, element);
      out.least_bound = std::min(out.least_bound, bound);
      if (value + room < bound) found.emplace_back(value, e);
    }
    const double part = options_.at_most_part * static_cast<double>(x_.n_elements());
    const long most = std::max(options_.at_most, static_cast<long>(part));
    if (static_cast<long>(found.size()) > most) {
      std::nth_element(found.begin(), found.begin() + most, found.end());
      found.resize(most);
    }
    for (const auto& [value, e] : found) out.elements.push_back(e);
    std::sort(out.elements.begin(), out.elements.end());
    return out;
  }

  double follow_energy(double threshold, int power) {
    const Candidates poor = find(threshold, worth_it(), fixed_);
    if (poor.elements.empty()) return poor.least;
    UntangleOptions how;
    how.threshold = threshold;
    how.max_attempts = 1;
    how.energy.power = power;
    how.keeps_lengths = power > 1;
    untangle(x_, metric_, fixed_, points_, how, poor.elements, team_, context_);
    return check_elements(x_, points_, threshold, team_).min_scaled_jacobian;
  }

  double raise(double least, RaiseOptions how) {
    constexpr int most_rounds = 8, most_rings = 4;
    const double window = 3.0 * options_.lift_within, least_gain = 0.1 * worth_it();
    const std::vector<char> held = without_moving(fixed_, how);
    for (int round = 0; round < most_rounds && how.rings <= most_rings; ++round) {
      Candidates worst = find(std::min(least + window, options_.lift_below), least_gain, held);
      // What is better than the boundary lets the worst be needs no help.
      std::erase_if(worst.elements, [&](long e) {
        return scaled_jacobian_of(x_, points_, index_.element(e)) >= worst.least_bound;
      });
      if (worst.elements.empty() || least + least_gain >= worst.least_bound) break;
      raise_least(x_, fixed_, points_, how, worst.elements, team_, context_);
      const double before = least;
      least = check_elements(x_, points_, 0.0, team_).min_scaled_jacobian;
      if (least < before + worth_it()) how.rings *= 2;
    }
    return least;
  }

  const Extrusion& x_;
  const std::vector<char>& fixed_;
  const BaseMetric& metric_;
  const ImproveOptions& options_;
  Points& points_;
  ThreadTeam& team_;
  const Context& context_;
  const ElementIndex index_;
};

}  // namespace

double improve_elements(const Extrusion& extrusion, const std::vector<char>& fixed,
                        const BaseMetric& metric, const ImproveOptions& options, double least,
                        Points& points, ThreadTeam& team, const Context& context) {
  if (least > options.up_to && least >= options.lift_below) return least;
  return Improver(extrusion, fixed, metric, options, points, team, context).run(least);
}

}  // namespace sweepmesh
