// Between a scheme and its mesh: how sources and targets lie over each other, and the number of
// mesh edges on every edge.
#pragma once

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/piece_counts.h"
#include "sweepmesh/imprint/shell.h"
#include "sweepmesh/intervals/edge_nodes.h"
#include "sweepmesh/intervals/interval_options.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

/// One source over one target, as they are.
struct WholeCaps {};

/// Sources and targets matched: whole, imprinted on each other, or as the two sides of a wall.
using CapMatch = std::variant<WholeCaps, Imprint, Shell>;

/// Matches at one element size with several distances of merging: what these have in common is
/// found once, when first asked for. The arguments must outlive it.
class CapMatcher {
 public:
  CapMatcher(const Model& model, const Scheme& scheme, double size, Context& context)
      : model_(model), scheme_(scheme), size_(size), context_(context) {}

  /// Throws what imprint_caps and find_shell throw.
  CapMatch operator()(double merge_fraction);

 private:
  const Model& model_;
  const Scheme& scheme_;
  double size_;
  Context& context_;
  std::optional<ImprintBasis> basis_;
};

/// The interval problem with what the match adds to it. Throws SolverError where demands contradict
/// each other, naming them.
PieceCounts count_edges(const Model& model, const Scheme& scheme, const CapMatch& match,
                        const IntervalOptions& options, Context& context);

/// Where the nodes of each CAD edge lie. Nodes on cuts through the caps of a shell belong to no
/// edge and are left out.
EdgeNodes nodes_on_edges(const Model& model, const Scheme& scheme, const CapMatch& match,
                         const PieceCounts& counts, const IntervalOptions& options);

bool is_one_to_one(const Scheme& scheme);

/// The parts of `size` within which near curves are brought together, in the order of trying. One
/// where nothing is imprinted.
std::vector<double> merge_fractions(const Model& model, const Scheme& scheme,
                                    const SweepOptions& options, double size);
/// Curves cannot be carried to another level: that depends neither on how near they are nor on the
/// size.
bool is_final(const Error& error);
/// Whether another distance may do where one ended in `error`.
bool can_merging_help(const Error& error);

/// Whether the same curves divide R in the same way, or nothing is imprinted.
bool is_alike(const CapMatch& a, const CapMatch& b);

/// `use(match(fraction), fraction)` of the first of the `fractions` that ends in no Error. Curves
/// may get into each other's way, or cells have no room on a cap, within one distance and not
/// within another one that makes a difference. If none will do, the first error counts.
template <class Match, class Use>
auto with_some_merging(const std::vector<double>& fractions, Match&& match, Use&& use) {
  std::exception_ptr first;
  std::vector<CapMatch> tried;
  for (const double fraction : fractions) try {
      CapMatch made = match(fraction);
      if (std::ranges::any_of(tried, [&](const CapMatch& t) { return is_alike(t, made); }))
        continue;
      tried.push_back(std::move(made));
      return use(tried.back(), fraction);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (!first) first = std::current_exception();
      if (!can_merging_help(error)) break;
    }
  std::rethrow_exception(first);
}

/// A match, and the counts that go with it.
struct Layout {
  CapMatch match;
  PieceCounts counts;
};
/// With the first distance of merging that will do. Throws what CapMatcher and count_edges throw,
/// and what the grids of the linking faces do, which hang on nothing else: they are made and thrown
/// away. `is_trial`: see IntervalOptions.
Layout lay_out(const Model& model, const Scheme& scheme, const SweepOptions& options, double size,
               Context& context, bool is_trial = false);

}  // namespace sweepmesh
