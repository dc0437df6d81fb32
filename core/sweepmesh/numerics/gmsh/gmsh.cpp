#include "sweepmesh/numerics/gmsh/gmsh.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "sweepmesh/numerics/gmsh/temporary_directory.h"
#include "sweepmesh/numerics/gmsh/worker.h"

namespace sweepmesh {
namespace {

using Loops = std::vector<std::vector<Point2>>;

double local_size(const std::vector<Point2>& loop, std::size_t i) {
  const std::size_t n = loop.size();
  return 0.5 * ((loop[(i + 1) % n] - loop[i]).norm() + (loop[(i + n - 1) % n] - loop[i]).norm());
}

void write_loop(std::ostream& out, const std::vector<Point2>& loop, int first, int loop_tag,
                double factor) {
  const int n = static_cast<int>(loop.size());
  for (int i = 0; i < n; ++i)
    out << "Point(" << first + i << ")={" << loop[i].x() << "," << loop[i].y() << ",0,"
        << factor * local_size(loop, i) << "};\n";
  for (int i = 0; i < n; ++i)
    out << "Line(" << first + i << ")={" << first + i << "," << first + (i + 1) % n << "};\n";
  out << "Line Loop(" << loop_tag << ")={" << first << ":" << first + n - 1 << "};\n";
}

void write_geo(const std::filesystem::path& file, const Loops& loops, const GmshOptions& options) {
  std::ofstream out(file);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  std::size_t n_points = 0;
  for (const auto& loop : loops) n_points += loop.size();
  const int first_loop = static_cast<int>(n_points) + 1;
  int first = 1;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    write_loop(out, loops[l], first, first_loop + static_cast<int>(l), options.size_factor);
    first += static_cast<int>(loops[l].size());
  }
  out << "Plane Surface(1)={" << first_loop << ":" << first_loop + loops.size() - 1 << "};\n"
      << "Transfinite Line{1:" << n_points << "}=2;\n"
      << "Mesh.Algorithm=" << static_cast<int>(options.algorithm) << ";\n"
      << "Mesh.CharacteristicLengthExtendFromBoundary=1;\n";
  if (options.size_max > 0.0) out << "Mesh.CharacteristicLengthMax=" << options.size_max << ";\n";
  if (options.recombine) out << "Mesh.RecombineAll=1;\nMesh.RecombinationAlgorithm=1;\n";
}

/// Gmsh's MSH 2 text: $Nodes (tag x y z) and $Elements (tag type n_tags tags... nodes...).
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : in_(file) {}

  GmshMesh read(std::size_t n_boundary) {
    std::string word;
    while (in_ >> word) {
      if (word == "$Nodes") read_nodes();
      if (word == "$Elements") read_elements();
    }
    if (mesh_.points.size() < n_boundary || mesh_.cells.empty()) return {};
    return std::move(mesh_);
  }

 private:
  void read_nodes() {
    long count = 0;
    in_ >> count;
    for (long i = 0; i < count && in_; ++i) {
      long tag = 0;
      double x = 0.0, y = 0.0, z = 0.0;
      in_ >> tag >> x >> y >> z;
      index_[tag] = static_cast<int>(mesh_.points.size());
      mesh_.points.emplace_back(x, y);
    }
  }

  void read_elements() {
    constexpr int triangle = 2, quad = 3;
    long count = 0;
    in_ >> count;
    std::string rest;
    for (long i = 0; i < count && in_; ++i) {
      long number = 0;
      int type = 0, n_tags = 0;
      in_ >> number >> type >> n_tags;
      for (int tag = 0, value = 0; tag < n_tags; ++tag) in_ >> value;
      if (type == triangle || type == quad)
        read_cell(type == quad ? 4 : 3);
      else
        std::getline(in_, rest);
    }
  }

  void read_cell(int n) {
    std::array<int, 4> cell = {-1, -1, -1, -1};
    for (int i = 0; i < n; ++i) {
      long tag = 0;
      in_ >> tag;
      cell[i] = index_.at(tag);
    }
    mesh_.cells.push_back(cell);
  }

  std::ifstream in_;
  GmshMesh mesh_;
  std::map<long, int> index_;
};

/// The domain in units of its mean segment, rounded: what differs by rounding errors only, or by
/// its scale, gives the same mesh.
class Units {
 public:
  explicit Units(const Loops& loops) : origin_(loops.front().front()) {
    double sum = 0.0;
    std::size_t n = 0;
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i, ++n)
        sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    unit_ = sum / static_cast<double>(n);
  }

  double rounded(double x) const { return std::round(x / unit_ * grid_) / grid_; }
  Loops rounded(Loops loops) const {
    for (auto& loop : loops)
      for (Point2& p : loop) p = (p - origin_).unaryExpr([&](double x) { return rounded(x); });
    return loops;
  }
  Point2 restored(const Point2& p) const { return unit_ * p + origin_; }

 private:
  static constexpr double grid_ = 1 << 18;
  Point2 origin_;
  double unit_ = 1.0;
};

}  // namespace

GmshMesh mesh_by_gmsh(const Loops& loops, const GmshOptions& options, const Context& context) {
  const TemporaryDirectory directory;
  const Units units(loops);
  GmshOptions in_units = options;
  in_units.size_max = units.rounded(options.size_max);
  write_geo(directory.path() / "cap.geo", units.rounded(loops), in_units);
  GmshWorkers& workers = context.kept<GmshWorkers>();
  std::unique_ptr<GmshWorker> worker = workers.take();
  const int status = worker->run(directory.path(), context);
  workers.give_back(std::move(worker));
  std::size_t n_boundary = 0;
  for (const auto& loop : loops) n_boundary += loop.size();
  GmshMesh mesh = Reader(directory.path() / "cap.msh").read(n_boundary);
  if (status != 0 || mesh.cells.empty())
    throw SolverError("surface", "Gmsh could not mesh a face: it ended with status " +
                                     std::to_string(status) + " and no mesh.");
  for (Point2& p : mesh.points) p = units.restored(p);
  std::size_t node = 0;
  for (const auto& loop : loops)
    for (const Point2& p : loop) mesh.points[node++] = p;
  return mesh;
}

}  // namespace sweepmesh
