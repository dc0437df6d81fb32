// Whether a scheme can be laid out: what is decided between a scheme and its mesh.
//
// Angles alone do not tell whether sources and targets can be imprinted on each other, numbers of
// mesh edges be found and linking faces get grids. All can be tried without a mesh. Of the schemes
// whose angles are beyond what the free search takes, about nine in ten that can be laid out can be
// meshed, and hardly one of the others (docs/assessment.md).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/base/errors.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/pipeline/sweep_options.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh {

struct LayoutFault {
  Reason reason;
  bool is_of_size = true;  ///< another element size may mend it
};

/// Why not, with the entities that the stage names; empty where imprint, intervals and grids can be
/// had at the wished size. Each distance of merging near curves is tried. `is_trial`: the sentence
/// need not be for people (IntervalOptions). Cost: that of imprint and intervals, of each distance
/// where it fails. Throws Cancelled and the options' InputError.
std::optional<LayoutFault> layout_fault(const Model& model, const Scheme& scheme,
                                        const SweepOptions& options, Context& context,
                                        bool is_trial);

/// Whether an error says that there is no layout, or no valid mesh of the boundary, rather than
/// that something failed.
bool is_fault_of_layout(const Error& error);

/// The verdict where no scheme can be laid out, and what it says of an error of imprint or
/// intervals.
Assessment without_layout(Reason fault);
Assessment without_layout(const Error& error);

/// The sizes that sweep() tries, as shares of the wished one, in their order.
inline constexpr std::array kSizeShares = {1.0, 0.85, 1.2, 0.7};

/// Which of `n` schemes are tried, in this order: the best four, and the last two, which are
/// straight where the solid has such sweeps.
std::vector<std::size_t> tries(std::size_t n);

/// Takes the schemes from a verdict on a solid without picks where none of those that sweep() would
/// try can be laid out at any of its sizes; the first one's fault is the reason. Cost: mostly one
/// layout at the default size.
void refuse_without_layout(const Model& model, Context& context, Assessment& verdict);

/// Takes the schemes from a verdict that cannot be laid out. Where none is left, the first one's
/// fault is the reason. Those that sweep() would not try (tries()) are dropped.
void keep_laid_out(const Model& model, const SweepOptions& options, Context& context,
                   Assessment& verdict);

/// Whether nothing is picked.
bool is_free(const Picks& picks);

inline constexpr std::size_t kMostStrained = 6, kEnoughStrained = 3;

/// Of a solid without picks none of whose regular schemes can be laid out: schemes of poorer angles
/// with other caps than `tried`, for accept_strained. Cost: that of a search.
std::vector<Scheme> schemes_beside(const Model& model, const std::vector<Scheme>& tried,
                                   Context& context);

/// Makes a verdict sweepable by those of its strained schemes that can be laid out: `kMostStrained`
/// are tried in their order until `kEnoughStrained` are found; those that ask for a shell and
/// cannot have one, which is seen at once, are passed over. Nothing changes where none can be, or
/// where it is sweepable.
void accept_strained(const Model& model, const SweepOptions& options, Context& context,
                     Assessment& verdict);

}  // namespace sweepmesh
