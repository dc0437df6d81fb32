#include "sweepmesh/scheme/round_cuts.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "sweepmesh/scheme/sweep_problem.h"

namespace sweepmesh {

namespace {

/// Places nearer than this, as a fraction of their edge's length, are one.
constexpr double kSamePlace = 0.05;

/// A place on an edge where it is divided, or a vertex of it that is as good as there.
struct Place {
  EdgeId edge;
  double fraction = 0.0;  ///< of the edge's length
  double t = 0.0;         ///< of its curve
  int group = -1;         ///< may be joined to another (Groups)
};

/// Numbers of groups, joined as cuts connect their places.
class Groups {
 public:
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int root(int g) const {
    while (parent_[g] != g) g = parent_[g];
    return g;
  }
  void join(int a, int b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }
  int count() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
};

/// Where a line of constant u or v from a coedge meets the boundary again.
struct Landing {
  const Coedge* coedge = nullptr;
  double t = 0.0;
  Point2 uv;
};

/// The line from a place on a coedge into its face: `fixed` is the coordinate that it keeps.
struct Ray {
  Point2 from;
  int fixed = 0;
  double sign = 1.0;  ///< of the other coordinate's growth

  double along(const Point2& uv) const { return sign * (uv[1 - fixed] - from[1 - fixed]); }
  double beside(const Point2& uv) const { return uv[fixed] - from[fixed]; }
};

Ray ray_from(const Model& model, const Coedge& c, double t) {
  Ray ray{model.uv(c, t)};
  const Eigen::Matrix<double, 3, 2> d = model.derivatives(c.face, ray.from);
  const Point3 tangent = model.tangent(c.edge, t) * (c.reversed ? -1.0 : 1.0);
  const auto steepness = [&](int axis) {
    return 1 - std::abs(d.col(axis).normalized().dot(tangent));
  };
  ray.fixed = steepness(0) > steepness(1) ? 1 : 0;
  const Point3 inward = model.normal(c.face, ray.from).cross(tangent);
  ray.sign = d.col(1 - ray.fixed).dot(inward) > 0 ? 1.0 : -1.0;
  return ray;
}

double crossing(const Model& model, const Coedge& c, const Ray& ray, double low, double high) {
  constexpr int kSteps = 60;
  const bool is_rising = ray.beside(model.uv(c, low)) < 0;
  for (int i = 0; i < kSteps; ++i) {
    const double middle = 0.5 * (low + high);
    ((ray.beside(model.uv(c, middle)) < 0) == is_rising ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Parameters at which a coedge meets a ray; its ends where they are as good as on it.
std::vector<double> meetings(const Model& model, const Coedge& c, const Ray& ray, double on_ray) {
  constexpr int kSamples = 64;
  std::vector<double> out;
  const auto [first, last] = model.range(c);
  for (const double end : {first, last})
    if (!c.seam && std::abs(ray.beside(model.uv(c, end))) <= on_ray) out.push_back(end);
  for (int j = 0; j < kSamples; ++j) {
    const double a = first + (last - first) * j / kSamples;
    const double b = first + (last - first) * (j + 1) / kSamples;
    if ((ray.beside(model.uv(c, a)) < 0) != (ray.beside(model.uv(c, b)) < 0))
      out.push_back(crossing(model, c, ray, a, b));
  }
  return out;
}

Landing land(const Model& model, const Coedge& start, const Ray& ray) {
  constexpr double kNothing = 1e3;  // in the relative tolerance of parameters
  const auto [low, high] = model.uv_bounds(start.face);
  const Point2 nothing = kNothing * model.tolerances().relative * (high - low);
  Landing out;
  for (const Loop& loop : model.loops(start.face))
    for (const Coedge& c : loop)
      for (const double t : meetings(model, c, ray, nothing[ray.fixed])) {
        const Point2 uv = model.uv(c, t);
        if (ray.along(uv) <= nothing[1 - ray.fixed]) continue;
        if (!out.coedge || ray.along(uv) < ray.along(out.uv)) out = {&c, t, uv};
      }
  return out;
}

class CutFinder {
 public:
  CutFinder(const Model& model, const TemplateOptions& options)
      : model_(model), options_(options), frame_(model.n_faces()) {
    options_.chamfer_length = 0.0;  // a chamfer is straight: it has a vertex to turn at
  }

  std::vector<CutGroup> run() {
    for (const FaceId f : model_.faces()) {
      frame_[f.index] = frame_of_straight_edges(model_, f, options_);
      if (frame_[f.index]) add_corners(f);
    }
    while (!open_.empty()) {
      const auto [place, face] = open_.front();
      open_.pop_front();
      go_on(place, face);
    }
    return grouped();
  }

 private:
  using Arrival = std::pair<int, FaceId>;  ///< a place and the face that it is to go on through

  bool is_round(FaceId face, EdgeId edge) {
    auto [at, is_new] = rounds_.try_emplace(face);
    if (is_new)
      for (const auto& loop : face_corners_with_templates(model_, face, options_))
        for (const FaceCorner& corner : loop)
          if (corner.edge.is_valid()) at->second.insert(corner.edge);
    return at->second.contains(edge);
  }

  /// The place on an edge at a fraction of its length; one nearby, or an end, where there is one.
  int place_at(EdgeId edge, double fraction) {
    if (fraction < kSamePlace) fraction = 0.0;
    if (fraction > 1 - kSamePlace) fraction = 1.0;
    const bool is_closed = model_.start(edge) == model_.end(edge);
    for (const int p : on_edge_[edge]) {
      const double apart = std::abs(places_[p].fraction - fraction);
      if (apart < kSamePlace || (is_closed && apart > 1 - kSamePlace)) return p;
    }
    const double t = model_.at_length_fractions(edge, {fraction}).front();
    places_.push_back({edge, fraction, t, groups_.add()});
    const int p = static_cast<int>(places_.size()) - 1;
    on_edge_[edge].push_back(p);
    return p;
  }

  const Coedge& use_of(EdgeId edge, FaceId face) const {
    const auto& both = model_.coedges(edge);
    return both[0].face == face ? both[0] : both[1];
  }

  /// Places at the virtual corners of a face; each goes on through the face beyond.
  void add_corners(FaceId face) {
    TemplateOptions framed = options_;
    framed.frame = frame_[face.index];
    for (const auto& loop : face_corners_with_templates(model_, face, framed))
      for (const FaceCorner& corner : loop) {
        if (!corner.edge.is_valid()) continue;
        const Coedge& c = use_of(corner.edge, face);
        if (c.seam) continue;
        const int p = place_at(corner.edge, c.reversed ? 1 - corner.at : corner.at);
        open_.emplace_back(p, model_.partner(c).face);
      }
  }

  void go_on(int p, FaceId face) {
    const Place place = places_[p];
    const Coedge& c = use_of(place.edge, face);
    if (!done_.insert({p, face}).second || has_corner_at(face, place)) return;
    if (is_round(face, place.edge)) return turn_with(c, place);
    const Ray ray = ray_from(model_, c, place.t);
    const Landing landing = land(model_, c, ray);
    if (!landing.coedge || !landing.coedge->edge.is_valid() || landing.coedge->seam ||
        places_.size() > kMaxPlaces)
      return void(spoilt_.insert(p));
    const int q = place_at(landing.coedge->edge, fraction_of(landing.coedge->edge, landing.t));
    groups_.join(place.group, places_[q].group);
    done_.insert({q, face});
    const Point2 end = model_.uv(*landing.coedge, places_[q].t);
    const auto [low, high] = model_.uv_bounds(face);
    if (std::abs(ray.beside(end)) > kMaxSlant * (high - low)[ray.fixed])
      return void(spoilt_.insert(p));
    cuts_.push_back({{face, model_.uv(c, place.t), end}, p});
    open_.emplace_back(q, model_.partner(*landing.coedge).face);
  }

  /// Whether the place is a vertex where the face has a corner: an edge leaves there already.
  bool has_corner_at(FaceId face, const Place& place) const {
    if (place.fraction > 0.0 && place.fraction < 1.0) return false;
    const VertexId v = place.fraction == 0.0 ? model_.start(place.edge) : model_.end(place.edge);
    for (std::size_t l = 0; l < model_.loops(face).size(); ++l)
      for (std::size_t i = 0; i < model_.loops(face)[l].size(); ++i) {
        const Coedge& c = model_.loops(face)[l][i];
        const double angle = model_.interior_angle(face, static_cast<int>(l), static_cast<int>(i));
        if (c.end == v && std::abs(angle - 2 * kQuarterTurn) > kQuarterTurn / 2 &&
            is_sharp_without_seam(face, l, i))
          return true;
      }
    return false;
  }

  /// At a seam's end every face has corners.
  bool is_sharp_without_seam(FaceId face, std::size_t l, std::size_t i) const {
    const Loop& loop = model_.loops(face)[l];
    return !loop[i].seam && !loop[(i + 1) % loop.size()].seam;
  }

  /// A round of a face that has no frame takes it from the first cut that arrives.
  void turn_with(const Coedge& c, const Place& place) {
    auto& frame = frame_[c.face.index];
    if (frame) return;
    const auto [first, last] = model_.range(c.edge);
    const double fraction = (place.t - first) / (last - first);
    frame = heading(model_, c, c.reversed ? 1 - fraction : fraction) + kQuarterTurn / 2;
    add_corners(c.face);
  }

  double fraction_of(EdgeId edge, double t) const {
    constexpr int kSamples = 64;
    const auto [first, last] = model_.range(edge);
    double length = 0.0, before = 0.0;
    Point3 p = model_.point(edge, first);
    for (int j = 1; j <= kSamples; ++j) {
      const double s = first + (last - first) * j / kSamples;
      const Point3 q = model_.point(edge, s);
      const double step = (q - p).norm(), share = (t - s) / (last - first) * kSamples + 1;
      if (share > 0) before = length + std::min(share, 1.0) * step;
      length += step;
      p = q;
    }
    return before / length;
  }

  std::vector<CutGroup> grouped() const {
    std::set<int> spoilt;
    for (const int p : spoilt_) spoilt.insert(groups_.root(places_[p].group));
    std::map<int, CutGroup> by_group;
    for (const auto& [cut, place] : cuts_) {
      const int group = groups_.root(places_[place].group);
      if (!spoilt.contains(group)) by_group[group].push_back(cut);
    }
    std::vector<CutGroup> out;
    for (auto& [group, cuts] : by_group) out.push_back(std::move(cuts));
    return out;
  }

  static constexpr std::size_t kMaxPlaces = 4000;
  static constexpr double kMaxSlant = 0.1;  ///< of a cut, as a fraction of its face's width

  const Model& model_;
  TemplateOptions options_;
  std::vector<std::optional<double>> frame_;  ///< by face
  std::map<FaceId, std::set<EdgeId>> rounds_;
  std::vector<Place> places_;
  std::map<EdgeId, std::vector<int>> on_edge_;
  Groups groups_;
  std::deque<Arrival> open_;
  std::set<Arrival> done_;
  std::set<int> spoilt_;  ///< places from which a cut cannot go on
  std::vector<std::pair<FaceCut, int>> cuts_;
};

}  // namespace

std::vector<CutGroup> round_cuts(const Model& model, const TemplateOptions& options) {
  return CutFinder(model, options).run();
}

}  // namespace sweepmesh
