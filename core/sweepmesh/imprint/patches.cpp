#include "sweepmesh/imprint/patches.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace sweepmesh {
namespace {

/// A linking face over an imprint edge, in the levels low..high.
struct Wall {
  FaceId face;
  int low, high;
  bool is_solid_left;  ///< of the imprint edge
};

class PatchFinder {
 public:
  PatchFinder(const Model& model, const Scheme& scheme, const Walls& walls, Overlay overlay)
      : model_(model),
        scheme_(scheme),
        walls_(walls),
        overlay_(std::move(overlay)),
        arrangement_(overlay_.arrangement) {}

  Imprint run() {
    find_levels();
    find_sides();
    find_chains();
    for (std::size_t e = 0; e < arrangement_.edges.size(); ++e) find_walls_over(e);
    for (std::size_t s = 0; s + 1 < levels_.size(); ++s) find_inside(s);
    for (const FaceId f : model_.faces())
      if (scheme_.face_role[f.index] == FaceRole::source ||
          scheme_.face_role[f.index] == FaceRole::target)
        find_cap(f);
    return result();
  }

 private:
  // --- incidence ---------------------------------------------------------------------------------

  void find_levels() {
    std::set<int> levels;
    for (const auto& traces : overlay_.traces)
      for (const Trace& t : traces) levels.insert(t.level);
    levels_.assign(levels.begin(), levels.end());
  }

  int level_of(int level) const {
    return static_cast<int>(std::lower_bound(levels_.begin(), levels_.end(), level) -
                            levels_.begin());
  }

  void find_sides() {
    left_.assign(arrangement_.edges.size(), -1);
    right_ = left_;
    for (std::size_t f = 0; f < arrangement_.faces.size(); ++f) {
      if (!arrangement_.faces[f].is_bounded) outside_ = static_cast<int>(f);
      for (const auto& loop : arrangement_.faces[f].loops)
        for (const DirectedEdge& d : loop)
          (d.reversed ? right_ : left_)[d.edge] = static_cast<int>(f);
    }
    inside_.assign(arrangement_.faces.size(), std::vector<char>(levels_.size(), false));
    cap_.assign(arrangement_.faces.size(), {});
  }

  /// The imprint edges of each CAD edge, in its direction.
  void find_chains() {
    struct Part {
      double first, last;
      DirectedEdge edge;
    };
    std::vector<std::vector<Part>> parts(model_.n_edges());
    for (std::size_t e = 0; e < overlay_.traces.size(); ++e)
      for (const Trace& t : overlay_.traces[e]) {
        const bool is_against = t.first > t.last;
        parts[t.edge.index].push_back({std::min(t.first, t.last),
                                       std::max(t.first, t.last),
                                       {static_cast<int>(e), is_against}});
      }
    chain_.resize(model_.n_edges());
    for (std::size_t e = 0; e < parts.size(); ++e) {
      std::sort(parts[e].begin(), parts[e].end(),
                [](const Part& a, const Part& b) { return a.first < b.first; });
      for (const Part& p : parts[e]) chain_[e].push_back(p.edge);
    }
  }

  // --- inside or outside -------------------------------------------------------------------------

  void find_walls_over(std::size_t e) {
    over_.resize(arrangement_.edges.size());
    std::map<FaceId, std::vector<const Trace*>> bottoms, tops;
    for (const Trace& t : overlay_.traces[e]) {  // ascending levels
      if (const FaceId f = walls_.above[t.edge.index]; f.is_valid()) bottoms[f].push_back(&t);
      if (const FaceId f = walls_.below[t.edge.index]; f.is_valid()) tops[f].push_back(&t);
    }
    for (const auto& [face, low] : bottoms) add_walls(e, face, low, tops[face]);
    for (const auto& [face, high] : tops)
      if (!bottoms.contains(face)) add_walls(e, face, {}, high);
  }

  void add_walls(std::size_t e, FaceId face, const std::vector<const Trace*>& low,
                 const std::vector<const Trace*>& high) {
    bool is_right = low.size() == high.size();
    for (std::size_t i = 0; is_right && i < low.size(); ++i)
      is_right = low[i]->level < high[i]->level && (i == 0 || high[i - 1]->level <= low[i]->level);
    if (!is_right) {
      std::vector<std::string> names = {name_of(face)};
      for (const auto* list : {&low, &high})
        for (const Trace* t : *list) names.push_back(name_of(t->edge));
      throw ImprintError(ImprintFailure::unreachable,
                         "The lower and upper edges of linking face " + name_of(face) +
                             " do not lie over each other along the sweep.",
                         names);
    }
    for (std::size_t i = 0; i < low.size(); ++i) {
      const bool is_left = walls_.solid_left_above[low[i]->edge.index];
      const bool is_against = low[i]->first > low[i]->last;
      over_[e].push_back({face, low[i]->level, high[i]->level, is_left != is_against});
    }
  }

  /// The linking face over an edge between levels s and s + 1.
  const Wall* wall_at(std::size_t edge, std::size_t s) const {
    const Wall* found = nullptr;
    for (const Wall& w : over_[edge]) {
      if (w.low > levels_[s] || w.high < levels_[s + 1]) continue;
      if (found)
        throw ImprintError(ImprintFailure::collision,
                           name_of(found->face) + " and " + name_of(w.face) +
                               " lie over each other along the sweep, in the same levels.",
                           {name_of(found->face), name_of(w.face)});
      found = &w;
    }
    return found;
  }

  /// Spreads inside and outside over the faces: the same across an edge without a linking face.
  void find_inside(std::size_t s) {
    constexpr char unknown = 2;
    std::vector<char> state(arrangement_.faces.size(), unknown);
    state[outside_] = false;
    const auto set = [&](int face, char value, std::size_t edge) {
      if (state[face] == unknown) state[face] = value;
      if (state[face] != value) throw_open_section(edge, s);
    };
    for (std::size_t e = 0; e < arrangement_.edges.size(); ++e)
      if (const Wall* w = wall_at(e, s)) {
        set(left_[e], w->is_solid_left, e);
        set(right_[e], !w->is_solid_left, e);
      }
    for (bool is_changing = true; is_changing;) {
      is_changing = false;
      for (std::size_t e = 0; e < arrangement_.edges.size(); ++e) {
        if (wall_at(e, s) || (state[left_[e]] == unknown && state[right_[e]] == unknown)) continue;
        is_changing |= state[left_[e]] == unknown || state[right_[e]] == unknown;
        const char known = state[left_[e]] == unknown ? state[right_[e]] : state[left_[e]];
        set(left_[e], known, e);
        set(right_[e], known, e);
      }
    }
    for (std::size_t f = 0; f < state.size(); ++f) inside_[f][s] = state[f] == true;
  }

  /// At an edge of the arrangement, between levels s and s + 1.
  [[noreturn]] void throw_open_section(std::size_t edge, std::size_t s) const {
    std::set<std::string> names;
    if (const Wall* w = wall_at(edge, s)) names.insert(name_of(w->face));
    for (const Trace& t : overlay_.traces[edge]) names.insert(name_of(t.edge));
    throw ImprintError(ImprintFailure::unreachable,
                       "The linking faces do not enclose the solid's section between two levels.",
                       {names.begin(), names.end()});
  }

  // --- caps --------------------------------------------------------------------------------------

  /// The faces that a cap covers: from its boundary inwards.
  void find_cap(FaceId cap) {
    const bool is_source = scheme_.face_role[cap.index] == FaceRole::source;
    std::set<int> border, region;
    std::optional<int> level;
    for (const Loop& loop : model_.loops(cap))
      for (const Coedge& c : loop) {
        if (!c.edge.is_valid() || chain_[c.edge.index].empty()) continue;
        level = walls_.level[c.edge.index];
        for (const DirectedEdge& d : chain_[c.edge.index]) {
          border.insert(d.edge);
          const bool is_against = d.reversed != c.reversed;
          region.insert((is_source != is_against ? left_ : right_)[d.edge]);
        }
      }
    if (!level)
      throw ImprintError(ImprintFailure::unreachable,
                         name_of(cap) + " has no boundary at which linking faces begin or end.",
                         {name_of(cap)});
    std::vector<int> open(region.begin(), region.end());
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      for (const auto& loop : arrangement_.faces[f].loops)
        for (const DirectedEdge& d : loop) {
          if (border.contains(d.edge)) continue;
          const int other = (d.reversed ? left_ : right_)[d.edge];
          if (region.insert(other).second) open.push_back(other);
        }
    }
    for (const int f : region) claim(f, cap, level_of(*level), is_source);
  }

  struct Claim {
    FaceId target, source;
  };

  void claim(int face, FaceId cap, int level, bool is_source) {
    Claim& c = cap_[face][level];
    FaceId& place = is_source ? c.source : c.target;
    if (place.is_valid() || face == outside_) {
      std::vector<std::string> names = {name_of(cap)};
      if (place.is_valid()) names.push_back(name_of(place));
      throw ImprintError(ImprintFailure::open_run,
                         name_of(cap) + " overlaps another cap of its level along the sweep.",
                         names);
    }
    place = cap;
  }

  // --- runs --------------------------------------------------------------------------------------

  std::vector<Run> runs_over(int face) const {
    std::vector<Run> runs;
    const int n_slabs = static_cast<int>(levels_.size()) - 1;
    for (int s = 0; s < n_slabs; ++s) {
      if (!inside_[face][s]) continue;
      const int low = s;
      while (s + 1 < n_slabs && inside_[face][s + 1] && !claim_at(face, s + 1)) ++s;
      const int high = s + 1;
      const Claim *below = claim_at(face, low), *above = claim_at(face, high);
      if (!below || !below->target.is_valid()) throw_open(face, low, below, "target");
      if (!above || !above->source.is_valid()) throw_open(face, high, above, "source");
      runs.push_back({levels_[low], levels_[high], below->target, above->source});
    }
    return runs;
  }

  const Claim* claim_at(int face, int level) const {
    const auto found = cap_[face].find(level);
    return found == cap_[face].end() ? nullptr : &found->second;
  }

  [[noreturn]] void throw_open(int face, int level, const Claim* there, const char* wanted) const {
    std::set<std::string> names;
    if (there && there->source.is_valid()) names.insert(name_of(there->source));
    if (there && there->target.is_valid()) names.insert(name_of(there->target));
    if (names.empty())
      for (const auto& loop : arrangement_.faces[face].loops)
        for (const DirectedEdge& d : loop)
          for (const Trace& t : overlay_.traces[d.edge])
            if (t.level == levels_[level]) names.insert(name_of(t.edge));
    const bool is_low = std::string(wanted) == "target";
    throw ImprintError(ImprintFailure::open_run,
                       std::string("A column of the solid has no ") + wanted + " face at its " +
                           (is_low ? "lower" : "upper") + " end.",
                       {names.begin(), names.end()});
  }

  /// Every part of a cap must begin or end a run.
  void check_claims(int face, const std::vector<Run>& runs) const {
    for (const auto& [level, claim] : cap_[face]) {
      const int k = levels_[level];
      const bool begins =
          std::any_of(runs.begin(), runs.end(), [&](const Run& r) { return r.low == k; });
      const bool ends =
          std::any_of(runs.begin(), runs.end(), [&](const Run& r) { return r.high == k; });
      const FaceId loose = claim.target.is_valid() && !begins ? claim.target
                           : claim.source.is_valid() && !ends ? claim.source
                                                              : FaceId{};
      if (!loose.is_valid()) continue;
      std::vector<std::string> names = {name_of(loose)};
      ImprintFailure failure = ImprintFailure::open_run;
      if (claim.target.is_valid() && claim.source.is_valid()) {
        failure = ImprintFailure::no_room;
        names.push_back(name_of(loose == claim.target ? claim.source : claim.target));
      }
      throw ImprintError(
          failure,
          "Between " + name_of(loose) + " and the cap over it there is nothing of the solid.",
          names);
    }
  }

  Imprint result() {
    Imprint out;
    out.vertex_level = walls_.vertex_level;
    for (std::size_t v = 0; v < arrangement_.vertices.size(); ++v)
      out.vertices.push_back({arrangement_.vertices[v], std::move(overlay_.cad[v])});
    for (std::size_t f = 0; f < arrangement_.faces.size(); ++f) {
      std::vector<Run> runs = runs_over(static_cast<int>(f));
      check_claims(static_cast<int>(f), runs);
      if (!runs.empty()) out.patches.push_back({arrangement_.faces[f].loops, std::move(runs)});
    }
    for (std::size_t e = 0; e < arrangement_.edges.size(); ++e) {
      auto& edge = arrangement_.edges[e];
      out.edges.push_back({edge.start, edge.end, edge.points, std::move(overlay_.traces[e])});
    }
    out.chain = std::move(chain_);
    out.merges = std::move(overlay_.merges);
    return out;
  }

  const Model& model_;
  const Scheme& scheme_;
  const Walls& walls_;
  Overlay overlay_;
  PlaneArrangement& arrangement_;
  std::vector<int> levels_;
  std::vector<int> left_, right_;  ///< faces beside each edge
  int outside_ = -1;
  std::vector<std::vector<DirectedEdge>> chain_;
  std::vector<std::vector<Wall>> over_;    ///< by edge
  std::vector<std::vector<char>> inside_;  ///< by face and level: in the slab above that level
  std::vector<std::map<int, Claim>> cap_;  ///< by face: caps at levels
};

}  // namespace

Imprint imprint_of(const Model& model, const Scheme& scheme, const Walls& walls, Overlay overlay) {
  return PatchFinder(model, scheme, walls, std::move(overlay)).run();
}

}  // namespace sweepmesh
