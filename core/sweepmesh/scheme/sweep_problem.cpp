#include "sweepmesh/scheme/sweep_problem.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sweepmesh/scheme/limits.h"

namespace sweepmesh {

namespace {

/// Away from the ends, where a blend may have no normal, and symmetric.
constexpr std::array kDihedralFractions = {0.1, 0.3, 0.5, 0.7, 0.9};

/// How much the outward normal of a coedge's face leans away from the edge, radians, over a step
/// from its middle into the face.
double lean(const Model& model, const Coedge& coedge, double step) {
  const auto [first, last] = model.range(coedge.edge);
  const double t = 0.5 * (first + last);
  const Point2 uv = model.uv(coedge, t);
  const Point3 normal = model.normal(coedge.face, uv);
  const Point3 inward =
      normal.cross(model.tangent(coedge.edge, t)) * (coedge.reversed ? -1.0 : 1.0);
  const Eigen::Matrix<double, 3, 2> d = model.derivatives(coedge.face, uv);
  const Point2 move = (d.transpose() * d).ldlt().solve(d.transpose() * inward) * step;
  return model.normal(coedge.face, uv + move).dot(inward);
}

Bend bend_of(double turn, double least) {
  return turn > least ? Bend::outwards : turn < -least ? Bend::inwards : Bend::none;
}

void measure_bend(const Model& model, ProblemEdge& edge) {
  constexpr double kStep = 1e-4;    // of the edge's length: small against the radius of any fillet
  constexpr double kMinTurn = 0.2;  // radians over the edge's length
  const double step = kStep * model.length(edge.id);
  double sum = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    const double turn = lean(model, model.coedges(edge.id)[side], step);
    edge.face_bend[side] = bend_of(turn, kStep * kMinTurn);
    sum += turn;
  }
  edge.bend = bend_of(sum, kStep * kMinTurn);
}

void measure(const Model& model, ProblemEdge& edge) {
  if (edge.is_seam) {
    edge.least = edge.mean = edge.largest = std::numbers::pi;
    return;
  }
  edge.least = 2 * std::numbers::pi;
  edge.mean = edge.largest = 0.0;
  for (double fraction : kDihedralFractions) {
    const double angle = model.dihedral(edge.id, fraction);
    edge.least = std::min(edge.least, angle);
    edge.largest = std::max(edge.largest, angle);
    edge.mean += angle / kDihedralFractions.size();
  }
  measure_bend(model, edge);
}

/// How the boundary turns over the ends of two coedges that follow each other, the corner between
/// them left out.
Bend bend_between(const Model& model, const Coedge& before, const Coedge& after) {
  constexpr double kPart = 0.1;      // of each coedge
  constexpr double kMinTurn = 0.02;  // radians over that part
  const double turn =
      std::remainder(heading(model, before, 1.0) - heading(model, before, 1 - kPart),
                     4 * kQuarterTurn) +
      std::remainder(heading(model, after, kPart) - heading(model, after, 0.0), 4 * kQuarterTurn);
  return bend_of(turn, kMinTurn);
}

void measure_direction(const Model& model, const Coedge& coedge, ProblemEdge& edge) {
  edge.chord = model.point(coedge.end) - model.point(coedge.start);
  const auto [first, last] = model.range(coedge.edge);
  const std::size_t n = edge.tangents.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double fraction = (j + 0.5) / n;
    const double t = first + (coedge.reversed ? 1 - fraction : fraction) * (last - first);
    edge.tangents[j] = model.tangent(coedge.edge, t) * (coedge.reversed ? -1.0 : 1.0);
    edge.points[j] = model.point(coedge.edge, t);
  }
}

Point3 mean_normal(const Model& model, FaceId id) {
  constexpr int kSamples = 5;  // each way
  const auto [low, high] = model.uv_bounds(id);
  Point3 sum = Point3::Zero();
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const Point2 at((i + 0.5) / kSamples, (j + 0.5) / kSamples);
      sum += model.normal(id, low + at.cwiseProduct(high - low));
    }
  return sum / (kSamples * kSamples);
}

/// Adds a face and its coedges; partners are filled in when both uses of an edge are known.
void add_face(const Model& model, FaceId id, std::map<EdgeId, int>& edge_index, SweepProblem& out) {
  ProblemFace face;
  face.id = id;
  face.area = model.area(id);
  face.normal = mean_normal(model, id);
  const auto& loops = model.loops(id);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    ProblemLoop loop{static_cast<int>(out.coedges.size()), 0};
    for (std::size_t i = 0; i < loops[l].size(); ++i) {
      const Coedge& coedge = loops[l][i];
      if (!coedge.edge.is_valid()) {
        face.is_degenerate = true;
        continue;
      }
      ProblemCoedge c;
      c.face = static_cast<int>(out.faces.size());
      c.loop = static_cast<int>(l);
      c.place = static_cast<int>(i);
      c.edge = edge_index.at(coedge.edge);
      c.start = coedge.start.index;
      c.end = coedge.end.index;
      c.angle = model.interior_angle(id, c.loop, c.place);
      c.heading = heading(model, coedge, 0.5);
      const Coedge& after = loops[l][(i + 1) % loops[l].size()];
      if (after.edge.is_valid()) c.bend = bend_between(model, coedge, after);
      c.length = model.length(coedge.edge);
      ProblemEdge& edge = out.edges[c.edge];
      if (edge.coedge[0] < 0) measure_direction(model, coedge, edge);
      (edge.coedge[0] < 0 ? edge.coedge[0] : edge.coedge[1]) = static_cast<int>(out.coedges.size());
      out.coedges.push_back(c);
      ++loop.count;
    }
    face.loops.push_back(loop);
  }
  out.faces.push_back(std::move(face));
}

}  // namespace

double heading(const Model& model, const Coedge& coedge, double fraction) {
  const auto [first, last] = model.range(coedge.edge);
  const double t = first + (coedge.reversed ? 1 - fraction : fraction) * (last - first);
  const Point2 uv = model.uv(coedge, t);
  const Point3 x = model.derivatives(coedge.face, uv).col(0).normalized();
  Point3 tangent = model.tangent(coedge.edge, t);
  if (coedge.reversed) tangent = -tangent;
  return std::atan2(tangent.dot(model.normal(coedge.face, uv).cross(x)), tangent.dot(x));
}

SweepProblem sweep_problem(const Model& model, const Context& context) {
  SweepProblem out;
  std::map<EdgeId, int> edge_index;
  for (EdgeId id : model.edges()) {
    context.check("assess");
    edge_index[id] = static_cast<int>(out.edges.size());
    ProblemEdge edge;
    edge.id = id;
    const auto& uses = model.coedges(id);
    edge.is_seam = !uses.empty() && uses.front().seam;
    edge.is_closed = model.start(id) == model.end(id);
    measure(model, edge);
    out.edges.push_back(edge);
  }
  for (FaceId id : model.faces()) {
    context.check("assess");
    add_face(model, id, edge_index, out);
  }
  for (const ProblemEdge& edge : out.edges) {
    const auto [a, b] = edge.coedge;
    if (a < 0 || b < 0) continue;
    out.coedges[a].partner = b;
    out.coedges[b].partner = a;
  }
  for (VertexId v : model.vertices()) out.n_vertices = std::max(out.n_vertices, v.index + 1);
  number_shells(out);
  return out;
}

void number_shells(SweepProblem& problem) {
  for (ProblemFace& face : problem.faces) face.shell = -1;
  int n_shells = 0;
  for (std::size_t seed = 0; seed < problem.faces.size(); ++seed) {
    if (problem.faces[seed].shell >= 0) continue;
    std::vector<std::size_t> open = {seed};
    problem.faces[seed].shell = n_shells;
    while (!open.empty()) {
      const ProblemFace& face = problem.faces[open.back()];
      open.pop_back();
      for (const ProblemLoop& loop : face.loops)
        for (int c = loop.first; c < loop.first + loop.count; ++c) {
          const int partner = problem.coedges[c].partner;
          if (partner < 0) continue;
          const int other = problem.coedges[partner].face;
          if (problem.faces[other].shell >= 0) continue;
          problem.faces[other].shell = n_shells;
          open.push_back(other);
        }
    }
    ++n_shells;
  }
}

}  // namespace sweepmesh
