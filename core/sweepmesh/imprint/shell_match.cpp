#include "sweepmesh/imprint/shell_match.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "sweepmesh/imprint/axial_edges.h"
#include "sweepmesh/surface/cap_boundary.h"

namespace sweepmesh {
namespace {

constexpr int none = -1;

/// One use of an edge by a cap's boundary.
struct Use {
  Coedge coedge;
  int next = none, previous = none;  ///< along the loop
  int other = none;                  ///< of the same edge, by another cap of this side
  Point3 middle = Point3::Zero();    ///< of the edge, seen from the side's centre, in its size
};

struct Side {
  std::vector<FaceId> faces;
  std::vector<Use> uses;
  std::vector<int> n_loops;  ///< by `faces`
};

Point3 middle_of(const Model& model, EdgeId e) {
  constexpr int n = 8;
  const auto [first, last] = model.range(e);
  Point3 sum = Point3::Zero();
  for (int i = 0; i < n; ++i) sum += model.point(e, first + (last - first) * (i + 0.5) / n);
  return sum / n;
}

/// Moves the middles to their mean and scales them to a mean distance of one.
void normalise(std::vector<Use>& uses) {
  Point3 centre = Point3::Zero();
  for (const Use& u : uses) centre += u.middle / static_cast<double>(uses.size());
  double size = 0.0;
  for (Use& u : uses) {
    u.middle -= centre;
    size += u.middle.norm() / static_cast<double>(uses.size());
  }
  if (size > 0.0)
    for (Use& u : uses) u.middle /= size;
}

Side side_of(const Model& model, const Scheme& scheme, FaceRole role) {
  Side side;
  side.faces = scheme.faces_with(role);
  std::map<EdgeId, int> seen;
  for (const FaceId f : side.faces) {
    const auto loops = bounding_loops(model, f);
    side.n_loops.push_back(static_cast<int>(loops.size()));
    for (const Loop& loop : loops) {
      const int first = static_cast<int>(side.uses.size()), n = static_cast<int>(loop.size());
      for (int i = 0; i < n; ++i) {
        const int here = first + i;
        side.uses.push_back({loop[i], first + (i + 1) % n, first + (i + n - 1) % n, none,
                             middle_of(model, loop[i].edge)});
        const auto [at, is_new] = seen.emplace(loop[i].edge, here);
        if (is_new) continue;
        side.uses[here].other = at->second;
        side.uses[at->second].other = here;
      }
    }
  }
  normalise(side.uses);
  return side;
}

/// The vertex at the foot of each column of axial edges, by its upper vertex; none where columns
/// divide.
std::map<VertexId, VertexId> feet_of(const Model& model, const Scheme& scheme) {
  std::map<VertexId, std::vector<VertexId>> below;
  for (const AxialEdge& e : axial_edges(model, scheme)) below[e.high].push_back(e.low);
  std::map<VertexId, VertexId> feet;
  for (const auto& [upper, lower] : below) {
    VertexId at = upper;
    for (auto down = below.find(at); down != below.end(); down = below.find(at)) {
      const VertexId next = down->second.front();
      const bool divides = std::any_of(down->second.begin(), down->second.end(),
                                       [&](VertexId v) { return v != next; });
      at = divides ? VertexId{} : next;
    }
    if (at.is_valid()) feet[upper] = at;
  }
  return feet;
}

class Matcher {
 public:
  Matcher(const Model& model, const Scheme& scheme)
      : model_(model),
        source_(side_of(model, scheme, FaceRole::source)),
        target_(side_of(model, scheme, FaceRole::target)),
        feet_(feet_of(model, scheme)),
        image_(source_.uses.size(), none),
        taken_(target_.uses.size(), false) {}

  std::optional<ShellMatch> match() {
    if (source_.faces.size() != target_.faces.size() || source_.uses.size() != target_.uses.size())
      return std::nullopt;
    for (std::size_t u = 0; u < image_.size(); ++u)
      if (image_[u] == none && !match_part(static_cast<int>(u))) return std::nullopt;
    if (!match_closed_faces()) return std::nullopt;
    return result();
  }

 private:
  struct Trial {
    std::map<int, int> image;  ///< by use
    std::map<FaceId, FaceId> face;
    double cost = std::numeric_limits<double>::infinity();
  };

  /// Finds the best image of all that hangs together with a use.
  bool match_part(int seed) {
    Trial best;
    for (std::size_t t = 0; t < target_.uses.size(); ++t) {
      if (taken_[t]) continue;
      Trial trial;
      trial.face = face_;
      constexpr double clear = 1e-6;  // equal but for rounding: the first one counts
      if (spread(seed, static_cast<int>(t), trial) && trial.cost < best.cost * (1 - clear))
        best = std::move(trial);
    }
    for (const auto& [u, t] : best.image) {
      image_[u] = t;
      taken_[t] = true;
    }
    face_ = std::move(best.face);
    return !best.image.empty();
  }

  /// A use is followed the other way round on the target: its next is the image's previous one.
  bool spread(int seed, int image, Trial& trial) const {
    std::vector<std::pair<int, int>> open = {{seed, image}};
    std::map<int, int> back;
    trial.cost = 0.0;
    while (!open.empty()) {
      const auto [u, t] = open.back();
      open.pop_back();
      const auto [at, is_new] = trial.image.emplace(u, t);
      const bool is_back_new = back.emplace(t, u).second;
      if (!is_new && at->second != t) return false;
      if (is_new != is_back_new || taken_[t]) return false;
      if (!is_new) continue;
      const Use &s = source_.uses[u], &i = target_.uses[t];
      if ((s.other == none) != (i.other == none) || !fits(s, i, trial)) return false;
      trial.cost += (s.middle - i.middle).squaredNorm();
      open.emplace_back(s.next, i.previous);
      open.emplace_back(s.previous, i.next);
      if (s.other != none) open.emplace_back(s.other, i.other);
    }
    return true;
  }

  bool fits(const Use& s, const Use& t, Trial& trial) const {
    const auto [at, is_new] = trial.face.emplace(s.coedge.face, t.coedge.face);
    if (at->second != t.coedge.face) return false;
    if (is_new && (n_loops(source_, s.coedge.face) != n_loops(target_, t.coedge.face) ||
                   is_image_of_another(t.coedge.face, s.coedge.face, trial)))
      return false;
    const auto foot = feet_.find(s.coedge.start);
    return foot == feet_.end() || foot->second == t.coedge.end ||
           (is_single(s) && !is_on_cap(foot->second));
  }

  bool is_on_cap(VertexId v) const {
    const auto has = [v](const Side& side) {
      return std::ranges::any_of(side.uses, [v](const Use& u) { return u.coedge.start == v; });
    };
    return has(source_) || has(target_);
  }

  static bool is_image_of_another(FaceId image, FaceId face, const Trial& trial) {
    return std::any_of(trial.face.begin(), trial.face.end(), [&](const auto& pair) {
      return pair.second == image && pair.first != face;
    });
  }

  /// A loop of one closed edge: its vertex may lie anywhere, but over no other edge of a cap.
  bool is_single(const Use& u) const { return u.coedge.start == u.coedge.end; }

  static int n_loops(const Side& side, FaceId f) {
    const auto at = std::find(side.faces.begin(), side.faces.end(), f);
    return side.n_loops[at - side.faces.begin()];
  }

  /// Closed surfaces, each a whole shell: to the nearest one.
  bool match_closed_faces() {
    for (const FaceId s : source_.faces) {
      if (face_.contains(s)) continue;
      FaceId best;
      double least = std::numeric_limits<double>::infinity();
      for (const FaceId t : target_.faces) {
        const bool is_taken = std::any_of(face_.begin(), face_.end(),
                                          [&](const auto& pair) { return pair.second == t; });
        if (is_taken || n_loops(target_, t) != 0) continue;
        const auto [low, high] = model_.uv_bounds(t);
        const double distance = model_.distance(s, model_.point(t, 0.5 * (low + high)));
        if (distance < least) least = distance, best = t;
      }
      if (!best.is_valid()) return false;
      face_[s] = best;
    }
    return true;
  }

  ShellMatch result() const {
    ShellMatch out;
    for (const auto& [s, t] : face_) out.faces.push_back({s, t});
    for (std::size_t u = 0; u < image_.size(); ++u) {
      const Use &s = source_.uses[u], &t = target_.uses[image_[u]];
      if (s.other != none && s.other < static_cast<int>(u)) continue;
      out.edges.push_back({s.coedge.edge, t.coedge.edge, s.coedge.reversed == t.coedge.reversed});
    }
    std::sort(out.edges.begin(), out.edges.end(),
              [](const EdgePair& a, const EdgePair& b) { return a.source < b.source; });
    return out;
  }

  const Model& model_;
  Side source_, target_;
  std::map<VertexId, VertexId> feet_;
  std::vector<int> image_;   ///< by source use
  std::vector<char> taken_;  ///< by target use
  std::map<FaceId, FaceId> face_;
};

}  // namespace

std::optional<ShellMatch> match_caps(const Model& model, const Scheme& scheme) {
  return Matcher(model, scheme).match();
}

}  // namespace sweepmesh
