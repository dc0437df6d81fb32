#include "sweepmesh/imprint/slab_reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sweepmesh/imprint/leaning_walls.h"
#include "sweepmesh/imprint/mean_value_field.h"
#include "sweepmesh/imprint/nearest_search.h"
#include "sweepmesh/imprint/section_map.h"

namespace sweepmesh {
namespace {

/// Of places on a line those that are more than `least` of arc apart, and both ends.
std::vector<double> apart(const Polyline& line, const std::set<double>& positions, double least) {
  std::vector<double> out;
  double arc = 0.0;
  const std::vector<double> arcs = arc_lengths(line);
  const double whole = arcs.back();
  for (const double at : positions) {
    const std::size_t i = std::min(static_cast<std::size_t>(at), line.size() - 2);
    const double here = arcs[i] + (at - static_cast<double>(i)) * (arcs[i + 1] - arcs[i]);
    if (!out.empty() && (here - arc <= least || whole - here <= least)) continue;
    out.push_back(at);
    arc = here;
  }
  const double end = static_cast<double>(line.size() - 1);
  if (out.back() != end) out.push_back(end);
  return out;
}

class SlabWalker {
 public:
  SlabWalker(const Model& model, const Scheme& scheme, const Walls& walls, const Point3& direction,
             const Reference& seen, const Context& context)
      : model_(model),
        walls_(walls),
        seen_(seen),
        context_(context),
        nearest_on_seen_(searches(seen)),
        height_(level_heights(model, walls, direction, seen)),
        panels_(find_panels(model, scheme, walls, seen, height_)),
        in_r_(panels_.size()),
        out_(seen) {}

  Reference run() {
    const int n = static_cast<int>(height_.size());
    base_ = base_level();
    for (std::size_t p = 0; p < panels_.size(); ++p)
      if (panels_[p].low <= base_ && base_ + 1 <= panels_[p].high)
        in_r_[p] = seen_at_height(panels_[p], base_height());
    is_known_.assign(out_.curves.size(), false);
    for (int f = 0; f < model_.n_faces(); ++f)
      is_upright_.push_back(is_upright(walls_, seen_, FaceId{f}));
    for (int level = base_ + 1; level < n; ++level) carry(level - 1, level, level);
    for (int level = base_; level >= 0; --level) carry(level, level + 1, level);
    for (ReferenceCurve& c : out_.curves) {
      for (Point2& p : c.points) p = on_lattice(p, seen_.lattice);
      out_.vertex[model_.start(c.edge).index] = c.points.front();
      out_.vertex[model_.end(c.edge).index] = c.points.back();
    }
    return std::move(out_);
  }

 private:
  Polyline seen_at(const Panel& p, int level) const { return seen_at_height(p, height_.at(level)); }

  Polyline seen_at_height(const Panel& p, double height) const {
    const double low = height_.at(p.low), high = height_.at(p.high);
    return p.at(std::clamp((height - low) / (high - low), 0.0, 1.0));
  }

  /// R is seen halfway up the base slab, so that what turns or grows along it is half as far away.
  double base_height() const { return (height_.at(base_) + height_.at(base_ + 1)) / 2; }

  /// The lower level of the slab with the largest section.
  int base_level() const {
    int best = 0;
    double most = 0.0;
    for (int level = 0; level + 1 < static_cast<int>(height_.size()); ++level) {
      MeanValueField outline(seen_.coincidence);
      for (const Panel& p : panels_)
        if (p.low <= level && level + 1 <= p.high)
          outline.add(seen_at(p, level), seen_at(p, level));
      if (outline.double_area() > most) {
        most = outline.double_area();
        best = level;
      }
    }
    return best;
  }

  /// Brings the curves of a level to R by the outline of the slab between low and high.
  void carry(int low, int high, int level) {
    context_.check("imprint");
    const auto parts = outline(low, high, [&](std::size_t p) {
      return OutlinePart{seen_at(panels_[p], level), in_r_[p]};
    });
    MeanValueField field(seen_.coincidence);
    for (const OutlinePart& part : parts) field.add(part.from, part.to);
    const std::set<FaceId> free_faces =
        free_leaning_faces(model_, walls_, out_.curves, panels_, is_upright_, level, level == high);
    std::vector<ReferenceCurve*> curves;
    for (ReferenceCurve& c : out_.curves)
      if (walls_.level[c.edge.index] == level) {
        refine(parts, c);
        const FaceId wall = (level == high ? walls_.above : walls_.below)[c.edge.index];
        if (free_faces.contains(wall)) lean_halfway(wall, panels_, level, level == high, c);
        curves.push_back(&c);
      }
    move(low, high, level, parts, field, curves);
    for (std::size_t p = 0; p < panels_.size(); ++p)
      if (level == high ? panels_[p].low == level : panels_[p].high == level) start_panel(p, level);
  }

  /// Adds points where the outline has some, so that both bend alike in R.
  void refine(const std::vector<OutlinePart>& parts, ReferenceCurve& c) const {
    std::set<double> positions;
    for (const PolylinePoint& p : resampled(c.points, spacing_ / 2)) positions.insert(p.position);
    const NearestSearch nearest_on(c.points);
    for (const OutlinePart& part : parts)
      for (const Point2& x : part.from) {
        const PolylinePoint foot = nearest_on(x);
        if (foot.distance <= seen_.coincidence) positions.insert(foot.position);
      }
    ReferenceCurve fine{c.edge, {}, {}};
    for (const double at : apart(c.points, positions, seen_.coincidence)) {
      const std::size_t i = std::min(static_cast<std::size_t>(at), c.points.size() - 2);
      fine.points.push_back(point_at(c.points, at));
      fine.t.push_back(c.t[i] + (at - i) * (c.t[i + 1] - c.t[i]));
    }
    c = std::move(fine);
  }

  /// Points on the outline, and outside of it, move with the field; those inside by the section's
  /// map.
  void move(int low, int high, int level, const std::vector<OutlinePart>& parts,
            const MeanValueField& field, const std::vector<ReferenceCurve*>& curves) {
    const auto loops = joined_loops(parts, 2 * seen_.coincidence);
    std::map<std::pair<double, double>, Point2> image;
    const auto key = [&](const Point2& p) {
      const Point2 rounded = on_lattice(p, seen_.lattice);
      return std::pair(rounded.x(), rounded.y());
    };
    std::vector<Point2> inside;
    const bool is_fixed = largest_move(parts) <= seen_.coincidence;
    for (const ReferenceCurve* c : curves)
      for (const Point2& p : c->points) {
        const auto [place, is_new] = image.try_emplace(key(p), p);
        if (!is_new) continue;
        if (const auto known = over_known_edges(c->edge, p))
          place->second = *known;
        else if (!is_fixed && field.distance(p) > seen_.coincidence && is_inside(loops, p))
          inside.push_back(p);
        else
          place->second = field(p);
      }
    if (!inside.empty()) {
      const std::vector<Point2> carried = carried_through(low, high, level, inside);
      for (std::size_t i = 0; i < inside.size(); ++i) image[key(inside[i])] = carried[i];
    }
    for (ReferenceCurve* c : curves) {
      for (Point2& p : c->points) p = image.at(key(p));
      is_known_[c - out_.curves.data()] = true;
    }
  }

  /// R at a place of an edge of an upright linking face, where another edge of that face lies over
  /// it and is known: what is between them need not be solid.
  std::optional<Point2> over_known_edges(EdgeId e, const Point2& x) const {
    std::vector<std::size_t> curves;
    for (const FaceId f : {walls_.above[e.index], walls_.below[e.index]}) {
      if (!f.is_valid() || !is_upright_[f.index]) continue;
      for (std::size_t c = 0; c < out_.curves.size(); ++c) {
        const EdgeId other = out_.curves[c].edge;
        if (is_known_[c] && (walls_.above[other.index] == f || walls_.below[other.index] == f) &&
            nearest_on_seen_[c](x).distance <= seen_.coincidence)
          curves.push_back(c);
      }
    }
    if (curves.empty()) return std::nullopt;
    return along_edges(curves, x);
  }

  static double largest_move(const std::vector<OutlinePart>& parts) {
    double most = 0.0;
    for (const OutlinePart& part : parts)
      for (std::size_t i = 0; i < part.from.size(); ++i)
        most = std::max(most, (part.from[i] - part.to[i]).norm());
    return most;
  }

  using Section = std::vector<OutlinePart>;  ///< loops, and where they are after a step

  /// Carries points inside the section at `level` to R: through the slab to its other end, and from
  /// there.
  std::vector<Point2> carried_through(int low, int high, int level,
                                      const std::vector<Point2>& points) const {
    constexpr int n = 16;
    try {
      const std::vector<Section> sections = sections_in_steps(low, high, level, n);
      return carried_over(sections, n, 2 * n, carried_over(sections, 0, n, points));
    } catch (const InvalidMeshError& e) {
      throw_unreachable(low, high, e);
    } catch (const InputError& e) {
      throw_unreachable(low, high, e);
    }
  }

  /// The section at its level and after each of n steps through the slab, and as many from what is
  /// seen at its other end to R.
  std::vector<Section> sections_in_steps(int low, int high, int level, int n) const {
    const double other_end = height_.at(level == high ? low : high);
    const double from = height_.at(level), to = low == base_ ? base_height() : other_end;
    const auto at_step = [&](std::size_t p, int i) {
      if (i <= n) return seen_at_height(panels_[p], from + (to - from) * i / n);
      Polyline line = seen_at_height(panels_[p], to);
      const double share = static_cast<double>(i - n) / n;
      for (std::size_t k = 0; k < line.size(); ++k) line[k] += share * (in_r_[p][k] - line[k]);
      return line;
    };
    std::vector<Section> out;
    for (int i = 0; i <= 2 * n; ++i)  // ends that meet at first belong together all the way
      out.push_back(joined_loops(
          outline(low, high,
                  [&](std::size_t p) {
                    return OutlinePart{at_step(p, 0), i < 2 * n ? at_step(p, i) : in_r_[p]};
                  }),
          2 * seen_.coincidence));
    return out;
  }

  Section step_between(const std::vector<Section>& sections, int first, int last) const {
    Section step;
    for (std::size_t l = 0; l < sections[first].size(); ++l)
      step.push_back({sections[first][l].to, sections[last][l].to});
    return step;
  }

  /// In one step where some map has no folds, else in halves. What lies between does not count if
  /// it can be had without: caps are mapped onto each other in one step too.
  std::vector<Point2> carried_over(const std::vector<Section>& sections, int first, int last,
                                   const std::vector<Point2>& points) const {
    try {
      const Section step = step_between(sections, first, last);
      if (step.empty() || largest_move(step) > seen_.coincidence)
        return carried_inside(step, points, spacing_, context_);
      return points;
    } catch (const InvalidMeshError&) {
      return carried_between(sections, first, last, points);
    }
  }

  /// At once where the harmonic map has no folds, else in two halves, in which the section keeps
  /// its shape more nearly. Only a single step is worth the search for another map.
  std::vector<Point2> carried_between(const std::vector<Section>& sections, int first, int last,
                                      const std::vector<Point2>& points) const {
    const Section step = step_between(sections, first, last);
    if (!step.empty() && largest_move(step) <= seen_.coincidence) return points;
    if (last - first == 1) return carried_inside(step, points, spacing_, context_);
    if (auto there = carried_harmonically(step, points, spacing_)) return *there;
    const int middle = (first + last) / 2;
    if (is_crossed(sections[middle], 2 * seen_.coincidence))
      throw InputError("imprint", "The outline of their section crosses itself.");
    return carried_between(sections, middle, last,
                           carried_between(sections, first, middle, points));
  }

  [[noreturn]] void throw_unreachable(int low, int high, const Error& e) const {
    std::set<std::string> names;
    for (const Panel& p : panels_)
      if (p.low <= low && high <= p.high) names.insert(name_of(p.face));
    throw ImprintError(ImprintFailure::unreachable,
                       std::string("Curves between these linking faces cannot be carried from one "
                                   "level to another: ") +
                           e.what(),
                       {names.begin(), names.end()});
  }

  /// A part of the slab's outline for each panel of it.
  template <class MakePart>
  std::vector<OutlinePart> outline(int low, int high, const MakePart& make) const {
    std::vector<OutlinePart> parts;
    for (std::size_t p = 0; p < panels_.size(); ++p)
      if (panels_[p].low <= low && high <= panels_[p].high) parts.push_back(make(p));
    return parts;
  }

  /// A panel that begins at a level whose edges are known: takes R from these edges, and bends
  /// where they bend.
  void start_panel(std::size_t p, int level) {
    Panel& panel = panels_[p];
    std::vector<std::size_t> curves;
    const auto& edges = (level == panel.low ? walls_.bottoms : walls_.tops)[panel.face.index];
    for (std::size_t c = 0; c < out_.curves.size(); ++c) {
      const EdgeId e = out_.curves[c].edge;
      if (walls_.level[e.index] == level && std::find(edges.begin(), edges.end(), e) != edges.end())
        curves.push_back(c);
    }
    const Polyline line = seen_at(panel, level);
    std::set<double> positions;
    for (std::size_t i = 0; i < line.size(); ++i) positions.insert(static_cast<double>(i));
    const NearestSearch nearest_on(line);
    for (const std::size_t c : curves)
      for (const double t : out_.curves[c].t) {
        const PolylinePoint foot = nearest_on(at_parameter(seen_.curves[c], t));
        if (foot.distance <= seen_.coincidence) positions.insert(foot.position);
      }
    const auto met = met_panels(panel, level);
    for (const std::size_t m : met)
      for (const Point2& x : seen_at(panels_[m], level)) {
        const PolylinePoint foot = nearest_on(x);
        if (foot.distance <= seen_.coincidence) positions.insert(foot.position);
      }
    Polyline bottom, top;
    in_r_[p].clear();
    for (const double at : apart(line, positions, seen_.coincidence)) {
      bottom.push_back(point_at(panel.bottom, at));
      top.push_back(point_at(panel.top, at));
      in_r_[p].push_back(along_edges_or_panels(curves, met, level, point_at(line, at)));
    }
    panel.bottom = std::move(bottom);
    panel.top = std::move(top);
  }

  /// Panels of the same face that end where this one begins, and are known.
  std::vector<std::size_t> met_panels(const Panel& panel, int level) const {
    std::vector<std::size_t> out;
    for (std::size_t m = 0; m < panels_.size(); ++m)
      if (panels_[m].face == panel.face && !in_r_[m].empty() &&
          (level == panel.low ? panels_[m].high : panels_[m].low) == level)
        out.push_back(m);
    return out;
  }

  /// R at a place that lies on one of the curves, or else on the end of one of the panels.
  Point2 along_edges_or_panels(const std::vector<std::size_t>& curves,
                               const std::vector<std::size_t>& panels, int level,
                               const Point2& x) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t c : curves) least = std::min(least, nearest_on_seen_[c](x).distance);
    Point2 best = x;
    bool is_panel = false;
    for (const std::size_t m : panels) {
      const PolylinePoint foot = nearest(seen_at(panels_[m], level), x);
      if (foot.distance >= least - seen_.coincidence) continue;
      least = foot.distance;
      best = point_at(in_r_[m], foot.position);
      is_panel = true;
    }
    return is_panel ? best : along_edges(curves, x);
  }

  /// R at a place that lies on one of the curves as they are seen.
  Point2 along_edges(const std::vector<std::size_t>& curves, const Point2& x) const {
    double least = std::numeric_limits<double>::infinity();
    Point2 best = x;
    for (const std::size_t c : curves) {
      // Both lines have the same parameters: find the place on the one, take it from the other.
      const ReferenceCurve& before = seen_.curves[c];
      const PolylinePoint foot = nearest_on_seen_[c](x);
      if (foot.distance >= least) continue;
      least = foot.distance;
      best = at_parameter(out_.curves[c], parameter_at(before, foot.position));
    }
    return best;
  }

  static std::vector<NearestSearch> searches(const Reference& seen) {
    std::vector<NearestSearch> out;
    for (const ReferenceCurve& c : seen.curves) out.emplace_back(c.points);
    return out;
  }

  static double parameter_at(const ReferenceCurve& c, double position) {
    const std::size_t i = std::min(static_cast<std::size_t>(position), c.t.size() - 2);
    return c.t[i] + (position - i) * (c.t[i + 1] - c.t[i]);
  }

  static Point2 at_parameter(const ReferenceCurve& c, double t) {
    const auto upper = std::upper_bound(c.t.begin() + 1, c.t.end() - 1, t);
    const std::size_t i = upper - c.t.begin() - 1;
    const double f = std::clamp((t - c.t[i]) / (c.t[i + 1] - c.t[i]), 0.0, 1.0);
    return c.points[i] + f * (c.points[i + 1] - c.points[i]);
  }

  const Model& model_;
  const Walls& walls_;
  const Reference& seen_;
  static constexpr double spacing_ = 1.0;  ///< of what is triangulated
  const Context& context_;
  const std::vector<NearestSearch> nearest_on_seen_;  ///< by curve, where it is seen
  const Heights height_;
  std::vector<Panel> panels_;
  std::vector<Polyline> in_r_;    ///< by panel, once known
  std::vector<char> is_known_;    ///< by curve: it is in R
  std::vector<char> is_upright_;  ///< by FaceId
  int base_ = 0;                  ///< level at the lower end of the base slab
  Reference out_;
};

}  // namespace

Reference slab_reference(const Model& model, const Scheme& scheme, const Walls& walls,
                         const Point3& direction, const Reference& seen, const Context& context) {
  return SlabWalker(model, scheme, walls, direction, seen, context).run();
}

}  // namespace sweepmesh
