#include "sweepmesh/pipeline/touching_sweep.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/divided_sweep.h"
#include "sweepmesh/pipeline/fold_verdict.h"
#include "sweepmesh/pipeline/joint_sweep.h"
#include "sweepmesh/pipeline/merge_meshes.h"
#include "sweepmesh/pipeline/scheme_choice.h"

namespace sweepmesh {
namespace {

std::string name_of_side(FaceId face, int solid) {
  return name_of(face) + " of solid " + std::to_string(solid + 1);
}

std::string names_of(const Contact& c) {
  return c.face == c.other_face
             ? name_of(c.face) + ", between solids " + std::to_string(c.solid + 1) + " and " +
                   std::to_string(c.other + 1) + ","
             : name_of_side(c.face, c.solid) + " and " + name_of_side(c.other_face, c.other);
}

std::string text_of(double size) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", size);
  return text;
}

/// Groups of solids that contacts connect, ascending; a solid without contacts is one by itself.
std::vector<std::vector<int>> groups_of(std::size_t n_solids,
                                        const std::vector<Contact>& contacts) {
  std::vector<int> group(n_solids);
  std::iota(group.begin(), group.end(), 0);
  for (const Contact& c : contacts) {
    const auto [low, high] = std::minmax(group[c.solid], group[c.other]);
    for (int& g : group)
      if (g == std::max(low, high)) g = std::min(low, high);
  }
  std::vector<std::vector<int>> out;
  for (std::size_t g = 0; g < n_solids; ++g) {
    std::vector<int> members;
    for (std::size_t s = 0; s < n_solids; ++s)
      if (group[s] == static_cast<int>(g)) members.push_back(static_cast<int>(s));
    if (!members.empty()) out.push_back(members);
  }
  return out;
}

class Sweeper {
 public:
  Sweeper(const std::vector<Model>& solids, const std::vector<Picks>& picks,
          const SweepOptions& options, double size, const Contacts& contacts, Context& context)
      : solids_(solids),
        picks_(picks),
        options_(options),
        size_(size),
        all_(contacts),
        context_(context),
        open_(contacts.contacts) {
    options_.size = size;
  }

  TouchingSweep run() {
    out_.parts.resize(solids_.size());
    check();
    if (!assess_all()) return std::move(out_);
    give_up_divided();
    std::vector<char> is_done(solids_.size(), 0);
    for (bool is_new = true; is_new;) {
      is_new = false;
      for (const auto& group : groups_of(solids_.size(), open_)) {
        if (is_done[group.front()] || group.size() < 2) continue;
        is_new = true;
        if (mesh_group(group))
          for (const int s : group) is_done[s] = 1;
        else
          break;  // fewer contacts are open, so groups are others
      }
    }
    for (std::size_t s = 0; s < solids_.size(); ++s)
      if (!is_done[s]) out_.parts[s] = sweep(solids_[s], picks_[s], options_, context_);
    out_.met = open_;
    return std::move(out_);
  }

 private:
  void check() const {
    check_options(options_);
    for (std::size_t s = 0; s < solids_.size(); ++s) {
      check_picks(picks_[s]);
      interval_options(solids_[s], options_, size_);
      refuse_explosion(solids_[s], options_, size_);
    }
  }

  /// False: one cannot be swept.
  bool assess_all() {
    bool is_sweepable = true;
    for (std::size_t s = 0; s < solids_.size(); ++s) {
      StageClock clock(out_.parts[s].seconds);
      context_.report(0.0, "Looking for sources and targets");
      Assessment& verdict = out_.parts[s].assessment;
      verdict =
          clock.run("assess", [&] { return assess_with_shape(solids_[s], picks_[s], context_); });
      is_divided_.push_back(!verdict.is_sweepable());
      if (is_divided_.back()) verdict = assess_or_divide(solids_[s], picks_[s], context_);
      is_sweepable = is_sweepable && verdict.is_sweepable();
    }
    return is_sweepable;
  }

  // --- contacts that are given up ----------------------------------------------------------------

  void give_up_divided() {
    for (std::size_t s = 0; s < solids_.size(); ++s)
      if (is_divided_[s])
        give_up([&](const Contact& c) { return is_at(c, static_cast<int>(s)); },
                "Solid " + std::to_string(s + 1) + " is swept with its rounded edges divided.");
  }

  template <class Which>
  std::size_t give_up(const Which& which, const std::string& why) {
    return std::erase_if(open_, [&](const Contact& c) {
      if (!which(c)) return false;
      out_.warnings.push_back(names_of(c) + " touch, but the meshes share no nodes there: " + why);
      return true;
    });
  }

  static bool is_at(const Contact& c, int solid) { return c.solid == solid || c.other == solid; }

  bool is_named(const Contact& c, const std::vector<std::string>& entities) const {
    const auto is_in = [&](const std::string& name) {
      return std::ranges::find(entities, name) != entities.end();
    };
    const auto has_side = [&](int solid, FaceId face) {
      for (const Loop& loop : solids_[solid].loops(face))
        for (const Coedge& edge : loop)
          if (edge.edge.is_valid() && is_in(name_of(edge.edge))) return true;
      return is_in(name_of(face));
    };
    return has_side(c.solid, c.face) || has_side(c.other, c.other_face);
  }

  /// The contacts that a failure names, else those of its solid, else all of the group.
  void give_up_for(const JointFailure& failure, const std::vector<int>& group) {
    const auto is_in = [&](const Contact& c) {
      return std::ranges::find(group, c.solid) != group.end();
    };
    const auto named = [&](const Contact& c) {
      return is_in(c) && is_named(c, failure.entities) &&
             (failure.solid < 0 || is_at(c, failure.solid));
    };
    if (give_up(named, failure.sentence) > 0) return;
    const auto at_solid = [&](const Contact& c) { return is_at(c, failure.solid); };
    if (failure.solid >= 0 && give_up(at_solid, failure.sentence) > 0) return;
    give_up(is_in, failure.sentence);
  }

  // --- meshing together --------------------------------------------------------------------------

  std::vector<Contact> contacts_of(const std::vector<int>& group) const {
    std::vector<Contact> out;
    std::ranges::copy_if(open_, std::back_inserter(out), [&](const Contact& c) {
      return std::ranges::find(group, c.solid) != group.end();
    });
    return out;
  }

  /// False: contacts have been given up instead.
  bool mesh_group(const std::vector<int>& group) {
    std::vector<Assessment> verdicts(solids_.size());
    for (const int s : group) verdicts[s] = out_.parts[s].assessment;
    const auto choices =
        scheme_choices(verdicts, contacts_of(group), options_.element == ElementKind::hex);
    std::optional<JointFailure> first;
    const auto is_made = [&](const SchemeChoice& choice, double share, double merging) {
      JointFailure failure;
      if (try_choice(group, choice, share * size_, merging, failure)) return true;
      if (!first) first = failure;
      return false;
    };
    const std::vector<double> merging = merge_fractions(options_, size_);
    for (const SchemeChoice& choice : choices)
      if (!first || may_help(choice, choices.front(), *first))
        if (is_made(choice, 1.0, merging.front())) return true;
    for (std::size_t m = 1; m < merging.size() && has_imprint(group, choices.front()); ++m)
      if (is_made(choices.front(), 1.0, merging[m])) return true;
    for (const double share : {0.85, 1.2, 0.7})
      if (is_made(choices.front(), share, merging.front())) {
        warn_of_size(group, share * size_, first->sentence);
        return true;
      }
    give_up_for(*first, group);
    return false;
  }

  /// Whether another choice changes the solid that failed, or one that it touches.
  bool may_help(const SchemeChoice& choice, const SchemeChoice& failed,
                const JointFailure& failure) const {
    if (failure.solid < 0) return true;
    const auto is_changed = [&](int s) { return choice[s] != failed[s]; };
    return is_changed(failure.solid) || std::ranges::any_of(open_, [&](const Contact& c) {
             return is_at(c, failure.solid) && (is_changed(c.solid) || is_changed(c.other));
           });
  }

  bool has_imprint(const std::vector<int>& group, const SchemeChoice& choice) const {
    return std::ranges::any_of(
        group, [&](int s) { return !is_one_to_one(out_.parts[s].assessment.schemes[choice[s]]); });
  }

  void warn_of_size(const std::vector<int>& group, double size, const std::string& why) {
    for (const int s : group) out_.parts[s].size = size;
    out_.parts[group.front()].warnings.push_back("The element size is " + text_of(size) +
                                                 " where solids touch: " + why);
  }

  bool try_choice(const std::vector<int>& group, const SchemeChoice& choice, double size,
                  double merging, JointFailure& failure) {
    std::vector<JointSolid> joint;
    for (const int s : group)
      joint.push_back({s, &solids_[s], &out_.parts[s].assessment.schemes[choice[s]]});
    const auto contacts = contacts_of(group);
    StageClock clock(out_.parts[group.front()].seconds);
    try {
      auto made =
          mesh_together(joint, all_, contacts, options_, size, merging, clock, context_, failure);
      if (!is_conforming(group, made, contacts, failure)) return false;
      take(group, choice, std::move(made), size);
      return true;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      if (failure.sentence.empty()) failure = {-1, e.what(), e.entities()};
      return false;
    }
  }

  /// Made sure of, whatever the stages promise.
  bool is_conforming(const std::vector<int>& group, const std::vector<SchemeMesh>& made,
                     const std::vector<Contact>& contacts, JointFailure& failure) const {
    std::vector<VolumeMesh> meshes(solids_.size());
    for (std::size_t i = 0; i < group.size(); ++i) meshes[group[i]] = made[i].mesh;
    const auto unmet = unmet_contacts(meshes, contacts, merge_tolerance(solids_));
    if (unmet.empty()) return true;
    const Contact& c = unmet.front();
    failure = {-1, "The two sides got different meshes.", {name_of(c.face), name_of(c.other_face)}};
    return false;
  }

  void take(const std::vector<int>& group, const SchemeChoice& choice, std::vector<SchemeMesh> made,
            double size) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      SweepResult& part = out_.parts[group[i]];
      auto& schemes = part.assessment.schemes;
      const auto used = schemes.begin() + static_cast<std::ptrdiff_t>(choice[group[i]]);
      std::rotate(schemes.begin(), used, used + 1);
      part.intervals = std::move(made[i].intervals);
      part.mesh = std::move(made[i].mesh);
      part.warnings = std::move(made[i].warnings);
      part.size = size;
    }
  }

  const std::vector<Model>& solids_;
  const std::vector<Picks>& picks_;
  SweepOptions options_;
  const double size_;
  const Contacts& all_;
  Context& context_;
  std::vector<Contact> open_;     ///< contacts that are to be met
  std::vector<char> is_divided_;  ///< by solid: it cannot be swept as it is
  TouchingSweep out_;
};

}  // namespace

TouchingSweep sweep_touching(const std::vector<Model>& solids, const std::vector<Picks>& picks,
                             const SweepOptions& options, double size, const Contacts& contacts,
                             Context& context) {
  return Sweeper(solids, picks, options, size, contacts, context).run();
}

double merge_tolerance(const std::vector<Model>& solids) {
  double out = 0.0;
  for (const Model& solid : solids) out = std::max(out, 4.0 * solid.tolerances().point);
  return out;
}

}  // namespace sweepmesh
