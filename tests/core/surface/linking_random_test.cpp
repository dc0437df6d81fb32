// Random rectilinear faces with holes, plain and with noise on their angles: every one is
// submapped.
//
// A face is a random set of cells of a small board, in one piece and touching itself at no corner;
// its outline and holes, with the board's lines at random distances, are the front of a solid that
// is swept upwards. The front and the back are then linking faces of that shape, and the levels
// many.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <iostream>
#include <map>
#include <optional>
#include <random>

#include "linking_pipeline.h"
#include "sweepmesh/scheme/assess.h"

namespace sweepmesh {
namespace {

using namespace testing;

class Board {
 public:
  Board(int size, std::mt19937& random) : size_(size), filled_(size * size, 0), random_(random) {
    const int wanted = size * size / 2 + static_cast<int>(random() % (size * size / 3));
    fill(static_cast<int>(random() % filled_.size()));
    for (int tries = 0; tries < 40 * size * size && n_filled_ < wanted; ++tries) {
      const int cell = static_cast<int>(random() % filled_.size());
      if (!at(cell) && touches(cell) && keeps_corners_clear(cell)) fill(cell);
    }
  }

  /// Corner points of the boundary, the region on the left of each loop; the outer loop first.
  std::vector<std::vector<std::pair<int, int>>> loops() const {
    std::map<std::pair<int, int>, std::pair<int, int>> next;
    for (int y = 0; y < size_; ++y)
      for (int x = 0; x < size_; ++x) {
        if (!get(x, y)) continue;
        if (!get(x, y - 1)) next[{x, y}] = {x + 1, y};
        if (!get(x + 1, y)) next[{x + 1, y}] = {x + 1, y + 1};
        if (!get(x, y + 1)) next[{x + 1, y + 1}] = {x, y + 1};
        if (!get(x - 1, y)) next[{x, y + 1}] = {x, y};
      }
    std::vector<std::vector<std::pair<int, int>>> out;
    while (!next.empty()) {
      std::vector<std::pair<int, int>> walk;
      for (auto p = next.begin()->first; next.count(p);) {
        walk.push_back(p);
        const auto q = next[p];
        next.erase(p);
        p = q;
      }
      out.push_back(without_straight(walk));  // the lowest, leftmost corner is on the outer loop
    }
    return out;
  }

 private:
  bool at(int cell) const { return filled_[cell]; }
  bool get(int x, int y) const {
    return x >= 0 && y >= 0 && x < size_ && y < size_ && filled_[y * size_ + x];
  }
  void fill(int cell) {
    filled_[cell] = 1;
    ++n_filled_;
  }
  bool touches(int cell) const {
    const int x = cell % size_, y = cell / size_;
    return get(x - 1, y) || get(x + 1, y) || get(x, y - 1) || get(x, y + 1);
  }
  /// No two filled cells that meet in a corner only, with this one filled.
  bool keeps_corners_clear(int cell) const {
    const int x = cell % size_, y = cell / size_;
    for (const int dx : {-1, 1})
      for (const int dy : {-1, 1}) {
        if (get(x + dx, y + dy) && !get(x + dx, y) && !get(x, y + dy)) return false;
        if (get(x + dx, y) && get(x, y + dy)) continue;
      }
    return true;
  }
  static std::vector<std::pair<int, int>> without_straight(
      const std::vector<std::pair<int, int>>& walk) {
    std::vector<std::pair<int, int>> out;
    const std::size_t n = walk.size();
    for (std::size_t j = 0; j < n; ++j) {
      const auto a = walk[(j + n - 1) % n], b = walk[j], c = walk[(j + 1) % n];
      if ((b.first - a.first) * (c.second - b.second) !=
          (b.second - a.second) * (c.first - b.first))
        out.push_back(b);
    }
    return out;
  }

  int size_;
  std::vector<char> filled_;
  int n_filled_ = 0;
  std::mt19937& random_;
};

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() % 100001) / 1e5;
}

/// `noise` moves every corner by up to that part of the smallest distance between lines.
TopoDS_Shape random_solid(std::mt19937& random, int size, double noise) {
  const Board board(size, random);
  const double least = 4.0;
  std::vector<double> x{0.0}, z{0.0};
  for (int line = 0; line < size; ++line) {
    x.push_back(x.back() + uniform(random, least, 3.0 * least));
    z.push_back(z.back() + uniform(random, least, 3.0 * least));
  }
  const auto shake = [&] { return noise * least * uniform(random, -1.0, 1.0); };
  std::vector<std::vector<gp_Pnt>> loops;
  for (const auto& walk : board.loops()) {
    loops.emplace_back();
    for (const auto& [i, k] : walk) {
      const double dx = shake(), dz = shake();
      loops.back().emplace_back(x[i] + dx, 0.0, z[k] + dz);
    }
    if (loops.size() > 1) std::reverse(loops.back().begin(), loops.back().end());
  }
  return prism(loops, gp_Vec(0, 7, 0));
}

struct Tally {
  int n = 0, n_holes = 0;
  double worst = 1.0, sum = 0.0;

  void add(const Model& model, double worst_quad) {
    for (const FaceId f : model.faces()) n_holes += static_cast<int>(model.loops(f).size()) - 1;
    worst = std::min(worst, worst_quad);
    sum += worst_quad;
    ++n;
  }
};

void run(int n_solids, double noise, double size, unsigned seed, Tally& tally) {
  std::mt19937 random(seed);
  for (int solid = 0; solid < n_solids; ++solid) {
    SCOPED_TRACE("solid " + std::to_string(solid));
    const TopoDS_Shape shape = random_solid(random, 4 + solid % 4, noise);
    try {
      const LinkingMesh m = mesh_upright(shape, {.size = size});
      expect_conforming(m);
      expect_columns(m);
      const double worst = worst_quad(m);
      EXPECT_GT(worst, 0.0);
      tally.add(m.model, worst);
    } catch (const Error& e) {
      ADD_FAILURE() << e.what();
    }
  }
}

void report(const std::string& what, int n_solids, const Tally& t) {
  std::cout << "[          ] " << what << ": " << t.n << " of " << n_solids << " submapped, "
            << t.n_holes << " holes, least scaled Jacobian " << t.worst << ", mean of the least "
            << t.sum / std::max(1, t.n) << '\n';
}

/// The outline with some corners cut off (two edges at 135 degrees) or rounded by a quarter circle.
TopoDS_Wire softened(const std::vector<gp_Pnt>& corners, double r, std::mt19937& random) {
  BRepBuilderAPI_MakeWire wire;
  const std::size_t n = corners.size();
  std::optional<gp_Pnt> first, last;
  const auto line_to = [&](const gp_Pnt& p) {
    if (last && last->Distance(p) > 1e-9) wire.Add(BRepBuilderAPI_MakeEdge(*last, p).Edge());
    if (!first) first = p;
    last = p;
  };
  for (std::size_t j = 0; j < n; ++j) {
    const gp_Pnt &a = corners[(j + n - 1) % n], &v = corners[j], &b = corners[(j + 1) % n];
    const int what = static_cast<int>(random() % 8);
    const gp_Vec back = gp_Vec(v, a).Normalized() * r, on = gp_Vec(v, b).Normalized() * r;
    if (what > 1) {
      line_to(v);
      continue;
    }
    const gp_Pnt from = v.Translated(back), to = v.Translated(on);
    const gp_Pnt centre = from.Translated(on);
    line_to(from);
    if (what == 0) {
      line_to(to);
      continue;
    }
    const gp_Pnt middle = centre.Translated(gp_Vec(centre, v).Normalized() * r);
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, middle, to).Value()).Edge());
    last = to;
  }
  line_to(*first);
  return wire.Wire();
}

/// `noise` moves every corner by up to so much each way.
TopoDS_Shape softened_solid(std::mt19937& random, int size, double noise) {
  const Board board(size, random);
  std::optional<BRepBuilderAPI_MakeFace> face;
  for (const auto& walk : board.loops()) {
    std::vector<gp_Pnt> corners;
    for (const auto& [i, k] : walk) {
      const double dx = uniform(random, -noise, noise), dz = uniform(random, -noise, noise);
      corners.emplace_back(10.0 * i + dx, 0.0, 9.0 * k + dz);
    }
    TopoDS_Wire wire = softened(corners, 2.5, random);
    if (face)
      face->Add(wire);
    else
      face.emplace(wire, true);
  }
  return BRepPrimAPI_MakePrism(face->Face(), gp_Vec(0, 7, 0)).Shape();
}

TEST(RandomFaces, Rectilinear) {
  Tally tally;
  run(200, 0.0, 3.0, 1, tally);
  report("rectilinear", 200, tally);
  EXPECT_EQ(tally.n, 200);
  EXPECT_GT(tally.n_holes, 50);
}

TEST(RandomFaces, RectilinearAndCoarse) {
  Tally tally;
  run(100, 0.0, 30.0, 2, tally);
  report("coarse", 100, tally);
  EXPECT_EQ(tally.n, 100);
}

TEST(RandomFaces, WithNoise) {
  Tally tally;
  run(200, 0.2, 3.0, 3, tally);
  report("with noise", 200, tally);
  EXPECT_EQ(tally.n, 200);
}

/// With the best scheme that can be meshed, as the pipeline does.
std::optional<LinkingMesh> first_meshed(const Model& model, const std::vector<Scheme>& schemes,
                                        double size) {
  for (const Scheme& scheme : schemes) {
    try {
      return mesh_scheme(model, scheme, {.size = size});
    } catch (const Error&) {
    }
  }
  return std::nullopt;
}

/// Vertex types and roles from the scheme stage: the upright direction is given, rounds and
/// chamfers are its to judge. Every solid that it calls sweepable is submapped.
void run_softened(const std::string& what, int n_solids, double noise, unsigned seed) {
  std::mt19937 random(seed);
  Tally tally;
  int n_sweepable = 0;
  for (int solid = 0; solid < n_solids; ++solid) {
    SCOPED_TRACE("solid " + std::to_string(solid));
    const Model model = model_of(softened_solid(random, 2 + solid % 4, noise));
    Context context;
    const Assessment verdict =
        assess(model, {faces_facing(model, 1, 0.99), faces_facing(model, -1, 0.99), {}}, context);
    if (!verdict.is_sweepable()) continue;
    ++n_sweepable;
    const auto m = first_meshed(model, verdict.schemes, 1.5);
    if (!m) continue;
    expect_conforming(*m);
    expect_columns(*m);
    const double worst = worst_quad(*m);
    EXPECT_GT(worst, 0.0);
    tally.add(m->model, worst);
  }
  report(what, n_sweepable, tally);
  EXPECT_GE(tally.n, n_sweepable - n_solids / 100);
  EXPECT_GT(n_sweepable, 9 * n_solids / 10);
}

TEST(RandomFaces, WithRoundsAndChamfers) {
  run_softened("with rounds and chamfers", 200, 0.0, 5);
}

TEST(RandomFaces, WithRoundsChamfersAndNoise) {
  run_softened("with rounds, chamfers and noise", 200, 0.8, 6);
}

}  // namespace
}  // namespace sweepmesh
