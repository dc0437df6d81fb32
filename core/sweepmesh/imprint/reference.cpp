#include "sweepmesh/imprint/reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sweepmesh {
namespace {

/// Puts the view across a direction, in a frame that turns with the solid: its origin is a vertex,
/// its first axis runs along `along`.
void look_along(const Point3& direction, const Point3& origin, const Point3& along,
                Reference& reference) {
  reference.origin = origin;
  reference.axes.row(0) = (along - along.dot(direction) * direction).normalized();
  reference.axes.row(1) = direction.cross(Point3(reference.axes.row(0)));
}

/// In the frame at the first transverse edge that has a chord (a third of it, for closed ones)
/// across the direction.
void look_along(const Model& model, const Walls& walls, const Point3& direction,
                Reference& reference) {
  for (const EdgeId e : walls.edges) {
    const auto [first, last] = model.range(e);
    const Point3 origin = reference.straightened(model.point(e, first));
    const Point3 third = reference.straightened(model.point(e, first + (last - first) / 3));
    const Point3 along = third - origin;
    if (along.cross(direction).norm() > model.tolerances().point)
      return look_along(direction, origin, along, reference);
  }
  look_along(direction, Point3::Zero(), direction.unitOrthogonal(), reference);
}

/// Halves the edge's parameter range until chords are nearer than `sag` to the curve.
class Sampler {
 public:
  Sampler(const Model& model, EdgeId e, const Reference& view, double sag)
      : model_(model), edge_(e), view_(view), sag_(sag) {}

  ReferenceCurve sample() {
    constexpr int n_parts = 3;  // no symmetry of a curve can hide its bulge from all of them
    const auto [first, last] = model_.range(edge_);
    out_.edge = edge_;
    add(first, at(first));
    for (int i = 0; i < n_parts; ++i) {
      const double a = first + (last - first) * i / n_parts;
      const double b = first + (last - first) * (i + 1) / n_parts;
      refine(a, at(a), b, at(b), 0);
    }
    out_.t.back() = last;
    if (model_.start(edge_) == model_.end(edge_)) out_.points.back() = out_.points.front();
    if (is_straight()) {
      out_.points = {out_.points.front(), out_.points.back()};
      out_.t = {out_.t.front(), out_.t.back()};
    }
    return std::move(out_);
  }

 private:
  static constexpr int deepest_ = 12;

  Point2 at(double t) const { return view_.project(model_.point(edge_, t)); }

  void add(double t, const Point2& p) {
    out_.t.push_back(t);
    out_.points.push_back(p);
  }

  void refine(double a, const Point2& pa, double b, const Point2& pb, int depth) {
    const double m = (a + b) / 2;
    const Point2 pm = at(m);
    double off = 0.0;
    for (const Point2& p : {at(a + 0.3 * (b - a)), pm, at(a + 0.8 * (b - a))})
      off = std::max(off, nearest({pa, pb}, p).distance);
    if (off <= sag_ || depth == deepest_) return add(b, pb);
    refine(a, pa, m, pm, depth + 1);
    refine(m, pm, b, pb, depth + 1);
  }

  /// At even speed too: parameters must follow from places on the line.
  bool is_straight() const {
    if (out_.points.front() == out_.points.back()) return false;
    const Polyline chord = {out_.points.front(), out_.points.back()};
    const double length = (chord[1] - chord[0]).norm();
    for (std::size_t i = 0; i < out_.points.size(); ++i) {
      const PolylinePoint foot = nearest(chord, out_.points[i]);
      const double f = (out_.t[i] - out_.t.front()) / (out_.t.back() - out_.t.front());
      if (foot.distance > sag_ || std::abs(foot.arc - f * length) > sag_) return false;
    }
    return true;
  }

  const Model& model_;
  EdgeId edge_;
  const Reference& view_;
  double sag_;
  ReferenceCurve out_;
};

/// Whether each of `edges` lies over the edges `others`, at its ends and between.
bool lie_over(const std::vector<EdgeId>& edges, const std::vector<EdgeId>& others,
              const std::vector<const ReferenceCurve*>& curve, double tolerance) {
  constexpr int n_parts = 32;
  for (const EdgeId e : edges) {
    const Polyline& line = curve[e.index]->points;
    const double whole = length(line);
    for (int i = 0; i <= n_parts; ++i) {
      const Point2 p = at_arc(line, whole * i / n_parts).point;
      const bool is_over = std::any_of(others.begin(), others.end(), [&](EdgeId o) {
        return nearest(curve[o.index]->points, p).distance <= tolerance;
      });
      if (!is_over) return false;
    }
  }
  return true;
}

std::vector<const ReferenceCurve*> by_edge(const Walls& walls, const Reference& reference) {
  std::vector<const ReferenceCurve*> curve(walls.level.size(), nullptr);
  for (const ReferenceCurve& c : reference.curves) curve[c.edge.index] = &c;
  return curve;
}

Reference seen_along(const Model& model, const Walls& walls, const Point3& direction,
                     std::shared_ptr<const SweepPath> path, double unit, double coincidence,
                     const Context& context) {
  constexpr int finer = 12;  // powers of two, than the coincidence
  Reference reference;
  reference.path = std::move(path);
  look_along(model, walls, direction, reference);
  reference.unit = unit;
  reference.coincidence = coincidence;
  reference.lattice = std::exp2(std::floor(std::log2(coincidence)) - finer);
  for (const EdgeId e : walls.edges) {
    context.check("imprint");
    reference.curves.push_back(Sampler(model, e, reference, coincidence / 4).sample());
  }
  for (int v = 0; v < model.n_vertices(); ++v) reference.vertex.push_back(Point2::Zero());
  for (const VertexId v : model.vertices())
    reference.vertex[v.index] = reference.project(model.point(v));
  return reference;
}

}  // namespace

std::vector<Point3> common_directions(const Model& model, const Scheme& scheme,
                                      const std::vector<int>& level) {
  constexpr std::size_t most = 10;
  std::vector<Point3> chords;
  Point3 sum = Point3::Zero();
  for (const EdgeId e : model.edges()) {
    if (scheme.edge_role[e.index] != EdgeRole::axial) continue;
    const VertexId a = model.start(e), b = model.end(e);
    const Point3 chord = model.point(b) - model.point(a);
    chords.push_back(level[b.index] >= level[a.index] ? chord : Point3(-chord));
    sum += chords.back();
  }
  std::vector<Point3> out;
  const auto add = [&](const Point3& d) {
    const bool is_new = std::none_of(out.begin(), out.end(), [&](const Point3& other) {
      return other.cross(d).norm() < model.tolerances().angle;
    });
    const bool rises =
        std::all_of(chords.begin(), chords.end(), [&](const Point3& c) { return c.dot(d) > 0.0; });
    if (is_new && rises && out.size() < most) out.push_back(d);
  };
  if (sum.norm() > model.tolerances().point) add(sum.normalized());
  for (const Point3& c : chords)
    if (c.norm() > model.tolerances().point) add(c.normalized());
  return out;
}

Reference projected_reference(const Model& model, const Walls& walls, const Point3& direction,
                              double unit, double coincidence, const Context& context) {
  return seen_along(model, walls, direction, nullptr, unit, coincidence, context);
}

Reference straightened_reference(const Model& model, const Walls& walls, const SweepPath& path,
                                 double unit, double coincidence, const Context& context) {
  return seen_along(model, walls, Point3::UnitZ(), std::make_shared<const SweepPath>(path), unit,
                    coincidence, context);
}

bool is_upright(const Walls& walls, const Reference& seen, FaceId face) {
  const auto curve = by_edge(walls, seen);
  const auto &bottoms = walls.bottoms[face.index], &tops = walls.tops[face.index];
  const auto is_steep = [&](const std::pair<VertexId, VertexId>& side) {
    return (seen.vertex[side.first.index] - seen.vertex[side.second.index]).norm() <=
           2 * seen.coincidence;
  };
  return std::ranges::all_of(walls.sides[face.index], is_steep) &&
         lie_over(bottoms, tops, curve, seen.coincidence) &&
         lie_over(tops, bottoms, curve, seen.coincidence);
}

bool is_upright(const Walls& walls, const Reference& seen) {
  for (std::size_t f = 0; f < walls.tops.size(); ++f)
    if (!is_upright(walls, seen, FaceId{f})) return false;
  return true;
}

}  // namespace sweepmesh
