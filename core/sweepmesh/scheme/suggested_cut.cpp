#include "sweepmesh/scheme/suggested_cut.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include "sweepmesh/scheme/sweep_problem.h"

namespace sweepmesh {
namespace {

bool is_re_entrant(const Model& model, EdgeId e) {
  return model.dihedral(e) > 2 * kQuarterTurn + strict_limits().margin;
}

class Candidates {
 public:
  Candidates(const Model& model, const std::vector<Reason>& reasons)
      : model_(model), problem_(sweep_problem(model, Context())) {
    for (const Reason& reason : reasons)
      named_.insert(reason.entities.begin(), reason.entities.end());
  }

  std::vector<SuggestedCut> run() {
    add_faces();
    add_closed_edges();
    add_between_voids();
    add_middles();
    return std::move(out_);
  }

 private:
  void add(const Plane& plane, FaceId face = {}) {
    const Tolerances& tolerances = model_.tolerances();
    const bool is_known = std::ranges::any_of(out_, [&](const SuggestedCut& other) {
      return other.plane.normal.cross(plane.normal).norm() < tolerances.angle &&
             std::abs((plane.point - other.plane.point).dot(plane.normal)) < 10 * tolerances.point;
    });
    if (!is_known) out_.push_back({.plane = plane, .face = face, .cut = {}});
  }

  /// Plane faces that could be extended into the solid.
  void add_faces() {
    struct Entry {
      int rank;
      double area;
      FaceId face;
    };
    std::vector<Entry> entries;
    for (const FaceId f : model_.faces()) {
      if (!model_.is_planar(f)) continue;
      int n_re_entrant = 0, n_named = named_.contains(name_of(f)) ? 1 : 0;
      for (const Loop& loop : model_.loops(f))
        for (const Coedge& c : loop) {
          if (!c.edge.is_valid() || !is_re_entrant(model_, c.edge)) continue;
          ++n_re_entrant;
          n_named += named_.contains(name_of(c.edge)) || named_.contains(name_of(other_face(c)));
        }
      if (n_re_entrant > 0) entries.push_back({n_named > 0 ? 0 : 1, model_.area(f), f});
    }
    std::ranges::stable_sort(entries, [](const Entry& a, const Entry& b) {
      return a.rank != b.rank ? a.rank < b.rank : a.area > b.area;
    });
    for (const Entry& entry : entries) add(plane_of(model_, entry.face), entry.face);
  }

  FaceId other_face(const Coedge& c) const { return model_.partner(c).face; }

  /// Circles and other plane closed edges, such as the rim of a boss on a round body.
  void add_closed_edges() {
    for (const EdgeId e : model_.edges()) {
      if (model_.start(e) != model_.end(e) || model_.coedges(e).front().seam) continue;
      const auto [first, last] = model_.range(e);
      const auto at = [&](double share) { return model_.point(e, first + share * (last - first)); };
      const Point3 a = at(0.0), normal = (at(1.0 / 3) - a).cross(at(2.0 / 3) - a);
      if (normal.norm() < model_.tolerances().point) continue;
      const Plane plane{a, normal.normalized()};
      const bool is_plane = std::ranges::all_of(std::vector{0.2, 0.5, 0.8}, [&](double share) {
        return std::abs((at(share) - a).dot(plane.normal)) < 10 * model_.tolerances().point;
      });
      if (is_plane) add(plane);
    }
  }

  /// Middles of the shells' corners and poles, but for the outer one.
  void add_between_voids() {
    const std::vector<Point3> centres = void_centres();
    for (std::size_t i = 0; i < centres.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Point3 way = centres[i] - centres[j];
        if (way.norm() > model_.tolerances().point)
          add({(centres[i] + centres[j]) / 2, way.normalized()});
      }
  }

  std::vector<Point3> void_centres() const {
    std::vector<std::pair<Point3, Point3>> boxes;
    for (const ProblemFace& face : problem_.faces) {
      const auto at = static_cast<std::size_t>(face.shell);
      while (boxes.size() <= at)
        boxes.emplace_back(Point3::Constant(INFINITY), Point3::Constant(-INFINITY));
      grow(face.id, boxes[at]);
    }
    std::size_t outer = 0;
    for (std::size_t s = 1; s < boxes.size(); ++s)
      if ((boxes[s].second - boxes[s].first).norm() >
          (boxes[outer].second - boxes[outer].first).norm())
        outer = s;
    std::vector<Point3> out;
    for (std::size_t s = 0; s < boxes.size(); ++s)
      if (s != outer) out.push_back((boxes[s].first + boxes[s].second) / 2);
    return out;
  }

  void grow(FaceId f, std::pair<Point3, Point3>& box) const {
    constexpr int n_parts = 8;
    const auto [low, high] = model_.uv_bounds(f);
    for (int i = 0; i <= n_parts; ++i)
      for (int j = 0; j <= n_parts; ++j) {
        const Point2 share(static_cast<double>(i) / n_parts, static_cast<double>(j) / n_parts);
        const Point3 p = model_.point(f, Point2(low + share.cwiseProduct(high - low)));
        box = {box.first.cwiseMin(p), box.second.cwiseMax(p)};
      }
  }

  void add_middles() {
    const auto [low, high] = model_.bounding_box();
    const Point3 middle = (low + high) / 2;
    for (const ProblemFace& face : problem_.faces)
      if (model_.is_planar(face.id) && face.normal.norm() > 0.0)
        add({middle, face.normal.normalized()});
    for (int axis = 0; axis < 3; ++axis) add({middle, Point3(Point3::Unit(axis))});
  }

  const Model& model_;
  const SweepProblem problem_;
  std::set<std::string> named_;  ///< by the reasons
  std::vector<SuggestedCut> out_;
};

/// Cuts, and assesses every piece; false where one of them cannot be swept.
bool is_help(const Model& model, const CutOptions& options, SuggestedCut& candidate,
             Context& context) {
  candidate.cut = cut_by_plane(model, candidate.plane);
  const auto& pieces = candidate.cut.pieces;
  if (pieces.size() < 2 || static_cast<int>(pieces.size()) > options.max_pieces) return false;
  for (const Model& piece : pieces) {
    const Assessment found = assess(piece, {}, context);
    if (!found.is_sweepable()) return false;
    candidate.cost += found.schemes.front().cost;
  }
  return true;
}

bool is_better(const SuggestedCut& a, const SuggestedCut& b) {
  constexpr double rounding = 1e-6;
  if (a.cut.pieces.size() != b.cut.pieces.size()) return a.cut.pieces.size() < b.cut.pieces.size();
  if (a.face.is_valid() != b.face.is_valid()) return a.face.is_valid();
  return a.cost < b.cost - rounding;
}

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

std::optional<SuggestedCut> first_that_meshes(std::vector<SuggestedCut>& cuts,
                                              const CutOptions& options, Context& context) {
  const Stopwatch watch;
  for (SuggestedCut& cut : cuts) {
    if (!options.can_mesh || watch.seconds() > options.trial_seconds) return std::move(cut);
    const auto can_mesh = [&](const Model& piece) { return options.can_mesh(piece, context); };
    cut.is_tried = std::ranges::all_of(cut.cut.pieces, can_mesh);
    if (cut.is_tried) return std::move(cut);
  }
  return {};
}

}  // namespace

std::vector<SuggestedCut> cut_candidates(const Model& model, const std::vector<Reason>& reasons) {
  return Candidates(model, reasons).run();
}

std::optional<SuggestedCut> suggest_cut(const Model& model, const std::vector<Reason>& reasons,
                                        const CutOptions& options, Context& context) {
  const Stopwatch watch;
  std::vector<SuggestedCut> helpful;
  int n_tries = 0;
  for (SuggestedCut& candidate : cut_candidates(model, reasons)) {
    context.check("assess");
    if (++n_tries > options.max_tries || watch.seconds() > options.seconds) break;
    context.report(static_cast<double>(n_tries) / options.max_tries, "Trying cuts.");
    if (is_help(model, options, candidate, context)) helpful.push_back(std::move(candidate));
  }
  std::ranges::stable_sort(helpful, is_better);
  return first_that_meshes(helpful, options, context);
}

std::string sentence_of(const SuggestedCut& cut) {
  const auto triple = [](const Point3& p) {
    char text[96];
    const auto shown = [](double x) { return std::abs(x) < 1e-9 ? 0.0 : x; };
    std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", shown(p.x()), shown(p.y()),
                  shown(p.z()));
    return std::string(text);
  };
  const std::string where =
      "the plane " + (cut.face.is_valid() ? "of " + name_of(cut.face) + ", " : "") + "through " +
      triple(cut.plane.point) + " with normal " + triple(cut.plane.normal);
  const std::string pieces = "the " + std::to_string(cut.cut.pieces.size()) + " pieces";
  return "Cut it along " + where + ": each of " + pieces + " can then be swept" +
         (cut.is_tried ? ", as a trial has shown." : ".");
}

}  // namespace sweepmesh
