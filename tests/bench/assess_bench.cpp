// Time of the search for sources and targets against the number of faces, over star-shaped prisms
// given as plain numbers and over the CAD files named on the command line.
#include <chrono>
#include <cmath>
#include <cstdio>

#include "sweepmesh/scheme/assess.h"
#include "sweepmesh/scheme/role_search.h"

using namespace sweepmesh;

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void add_face(SweepProblem& p, const std::vector<std::array<int, 3>>& sides,
              const std::vector<double>& angles) {
  ProblemFace face;
  face.id = FaceId{p.faces.size()};
  face.loops = {{static_cast<int>(p.coedges.size()), static_cast<int>(sides.size())}};
  face.area = 1.0;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    ProblemCoedge c;
    c.face = static_cast<int>(p.faces.size());
    c.loop = 0;
    c.place = static_cast<int>(s);
    c.edge = sides[s][0];
    c.start = sides[s][1];
    c.end = sides[s][2];
    c.angle = angles[s];
    c.length = 1.0;
    auto& uses = p.edges[c.edge].coedge;
    (uses[0] < 0 ? uses[0] : uses[1]) = static_cast<int>(p.coedges.size());
    p.coedges.push_back(c);
  }
  p.faces.push_back(face);
}

/// A prism over a star of n corners (even), in turn sharp (60 degrees) and re-entrant, so that no
/// cap can link cheaply.
SweepProblem star_prism(int n) {
  SweepProblem p;
  p.n_vertices = 2 * n;
  p.edges.resize(3 * n);  // bottom, top, upright
  const double sharp = kQuarterTurn * 2 / 3,
               flat = (2.0 * (n - 2) / n) * kQuarterTurn * 2 - sharp * 1.0;
  for (int e = 0; e < 3 * n; ++e) {
    ProblemEdge& edge = p.edges[e];
    edge.id = EdgeId{e};
    edge.least = edge.mean = edge.largest = e < 2 * n ? kQuarterTurn : (e % 2 ? sharp : flat);
    for (Point3& t : edge.tangents) t = e < 2 * n ? Point3(1, 0, 0) : Point3(0, 0, 1);
    edge.chord = edge.tangents[0];
  }
  std::vector<std::array<int, 3>> bottom, top;
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    add_face(p, {{i, i, j}, {2 * n + j, j, n + j}, {n + i, n + j, n + i}, {2 * n + i, n + i, i}},
             std::vector(4, kQuarterTurn));
    top.push_back({n + i, n + i, n + j});
    bottom.insert(bottom.begin(), {i, j, i});
    angles.push_back(j % 2 ? sharp : flat);
  }
  add_face(p, top, angles);
  add_face(p, bottom, angles);
  for (const ProblemEdge& edge : p.edges) {
    p.coedges[edge.coedge[0]].partner = edge.coedge[1];
    p.coedges[edge.coedge[1]].partner = edge.coedge[0];
  }
  number_shells(p);
  return p;
}

void run_prism(int n) {
  Context context;
  const Network network = make_network(star_prism(n), strict_limits());
  SearchOptions options;
  options.max_cost = 4.0;
  const double start = seconds();
  const SearchResult result = search_divisions(network, open_choices(network), options, context);
  std::printf("star prism   faces %5d  edges %5d  search %8.4f s  schemes %zu  steps %ld\n", n + 2,
              3 * n, seconds() - start, result.divisions.size(), result.effort);
}

void run_file(const char* path) {
  Context context;
  const Model model = Model::from_file(path);
  const double start = seconds();
  const Assessment found = assess(model, {}, context);
  std::printf("%s  faces %zu  edges %zu  assess %.4f s  schemes %zu\n", path, model.faces().size(),
              model.edges().size(), seconds() - start, found.schemes.size());
}

}  // namespace

int main(int argc, char** argv) {
  for (int n : {8, 16, 32, 64, 128, 256, 512, 1024, 2048}) run_prism(n);
  for (int a = 1; a < argc; ++a) run_file(argv[a]);
}
