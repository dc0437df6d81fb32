#include "sweepmesh/scheme/prismatic.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sweepmesh {

namespace {

constexpr std::size_t kMostDirections = 6;
constexpr double kCapCosine = 0.7071;  // 45 degrees
constexpr double kParallelCosine = 0.9999;
/// Length of the mean of a face's unit normals, one where it is plane.
constexpr double kPlane = 0.9999;

/// Directions of plane faces, opposite ones taken as one, by descending area.
std::vector<Point3> directions(const SweepProblem& problem) {
  std::vector<std::pair<double, Point3>> sums;
  for (const ProblemFace& face : problem.faces) {
    if (face.normal.norm() < kPlane) continue;
    const auto same = std::ranges::find_if(sums, [&](const auto& sum) {
      return std::abs(sum.second.dot(face.normal)) > kParallelCosine;
    });
    if (same == sums.end())
      sums.emplace_back(face.area, face.normal);
    else
      same->first += face.area;
  }
  std::ranges::stable_sort(sums, std::greater(), &std::pair<double, Point3>::first);
  std::vector<Point3> out;
  for (const auto& [area, direction] : sums) out.push_back(direction);
  if (out.size() > kMostDirections) out.resize(kMostDirections);
  return out;
}

StateSet role_along(const ProblemFace& face, const Point3& direction) {
  const double cosine = face.normal.dot(direction);
  if (cosine > kCapCosine) return kSourceStates;
  return cosine < -kCapCosine ? kTargetStates : kLinkingStates;
}

}  // namespace

std::vector<PlaneCaps> plane_caps(const SweepProblem& problem) {
  std::vector<PlaneCaps> out;
  for (const Point3& direction : directions(problem)) {
    PlaneCaps caps;
    for (const ProblemFace& face : problem.faces) {
      const double cosine = face.normal.dot(direction);
      if (std::abs(cosine) > kParallelCosine)
        (cosine > 0.0 ? caps.along : caps.against).push_back(face.id);
    }
    if (!caps.along.empty() && !caps.against.empty()) out.push_back(std::move(caps));
  }
  return out;
}

std::vector<Division> prismatic_divisions(const Network& network, Context& context) {
  std::vector<Division> out;
  for (const Point3& direction : directions(network.problem)) {
    Choices start = open_choices(network);
    std::vector<int> touched;
    for (int f : all_faces(network))
      set_role(network, start, f, role_along(network.problem.faces[f], direction), touched);
    SearchOptions options;
    options.max_effort /= 10;
    for (Division& d : search_states(network, start, options, context).divisions)
      out.push_back(std::move(d));
  }
  std::ranges::stable_sort(out, {}, &Division::cost);
  return out;
}

}  // namespace sweepmesh
