// Time and memory of placement against the size of the mesh.
//
//     sweepmesh_bench_place [largest number of hexahedra, default 1e7] [repeats, default 3]
//     [threads, default 0: all] [one row, 0 .. 8; default all]
//
// A block of quads whose side faces bulge, so that a residual is left to solve for, and the same
// block plainly twisted, where none is. Each is placed on all threads, by the clock, and on one, by
// its CPU time, that of the system included. Beside them the time to write the same array of points
// once, and the layer-wise affine motion alone. Every row is a process of its own, so that its peak
// of memory is its own.
//
// A figure is the least of the repeats, which go on until they took 0.3 seconds. All repeats of a
// row share a context, as stages of a run do, so its threads have been started. Before each repeat
// but the first as much memory as a repeat takes is fetched and given back, so that a machine that
// lives in another one has it: what the system itself does to hand it out and to clear it is
// measured, what the outer machine does is not.
//
// The last lines say by what factor the slowest hexahedron is slower than the fastest, over the
// rows with a residual and over those without, by the clock and by CPU time. The status is 1 where
// a bound is missed: factors 1.5, 1.5 and 5 million hexahedra a second by the clock, 300 bytes a
// hexahedron at ten million. Rates are meant for two processors that have nothing else to do.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

#include "sweepmesh/base/parallel.h"
#include "sweepmesh/volume/base_metric.h"
#include "sweepmesh/volume/floats.h"
#include "sweepmesh/volume/layer_motion.h"
#include "sweepmesh/volume/place.h"
#include "sweepmesh/volume/residual.h"

namespace {

using namespace sweepmesh;

struct Case {
  int nx, ny, n_layers;
  long n_hexes() const { return static_cast<long>(nx) * ny * n_layers; }
};

struct Input {
  Extrusion extrusion;
  std::vector<char> fixed;
  Points points;
};

/// A block nx x ny x n_layers that twists; its sides bulge by `bulge` of its shortest length.
Input make_block(const Case& size, double bulge) {
  Input b;
  bulge *= static_cast<double>(std::min({size.nx, size.ny, size.n_layers})) / size.nx;
  const auto column = [&](int i, int j) { return j * (size.nx + 1) + i; };
  for (int c = 0; c < (size.nx + 1) * (size.ny + 1); ++c) b.extrusion.add_column(0, size.n_layers);
  for (int j = 0; j < size.ny; ++j)
    for (int i = 0; i < size.nx; ++i)
      b.extrusion.add_cell({column(i, j), column(i + 1, j), column(i + 1, j + 1), column(i, j + 1)},
                           0, size.n_layers);
  b.points.resize(b.extrusion.n_nodes(), 3);
  b.fixed.assign(b.extrusion.n_nodes(), 0);
  for (int j = 0; j <= size.ny; ++j)
    for (int i = 0; i <= size.nx; ++i)
      for (int k = 0; k <= size.n_layers; ++k) {
        const double x = i - 0.5 * size.nx, y = j - 0.5 * size.ny;
        const double w = static_cast<double>(k) / size.n_layers,
                     turn = 0.5 * std::min(1.0, static_cast<double>(size.n_layers) / size.nx) * w;
        const double f = 1 + bulge * std::sin(M_PI * w) * std::sin(5.0 * M_PI * i / size.nx) *
                                 std::cos(3.0 * M_PI * j / size.ny);
        const bool is_bound = i == 0 || j == 0 || i == size.nx || j == size.ny;
        const double g = is_bound ? f : 1.0;
        const long node = b.extrusion.node(column(i, j), k);
        b.fixed[node] = is_bound || k == 0 || k == size.n_layers;
        b.points.row(node) << g * (std::cos(turn) * x - std::sin(turn) * y),
            g * (std::sin(turn) * x + std::cos(turn) * y), k;
      }
  return b;
}

/// Least time of the repeats: on the wall, and of all threads together.
struct Seconds {
  double wall = 1e300, cpu = 1e300;
};

double cpu_now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Largest number of bytes that the process has had so far.
double peak_bytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Fetches memory and gives it back.
void warm(std::size_t n_bytes) {
  constexpr std::size_t page = 4096;
  Floats memory(n_bytes / sizeof(float));
  for (std::size_t i = 0; i < memory.size(); i += page / sizeof(float)) memory[i] = 0.0f;
}

/// `n_bytes` is about what f takes beside what there is.
Seconds seconds_of(int repeats, std::size_t n_bytes, const std::function<void()>& f) {
  constexpr double least_total = 0.3;
  Seconds best;
  double total = 0.0;
  for (int r = 0; r < repeats || total < least_total; ++r) {
    if (r > 0) warm(n_bytes);
    const auto start = std::chrono::steady_clock::now();
    const double cpu = cpu_now();
    f();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    best = {std::min(best.wall, wall.count()), std::min(best.cpu, cpu_now() - cpu)};
    total += wall.count();
  }
  return best;
}

Seconds write_arrays(Input& b, int repeats, int threads) {
  ThreadTeam team(threads);
  return seconds_of(repeats, 0, [&] {
    team.for_chunks(b.points.size(), 1 << 16, [&](long begin, long end, long) {
      for (long i = begin; i < end; ++i) b.points.data()[i] = static_cast<double>(i);
    });
  });
}

Seconds affine_only(Input& b, int repeats, int threads) {
  ThreadTeam team(threads);
  return seconds_of(repeats, 0, [&] {
    const BaseMetric metric = make_layer_heights(b.extrusion, b.fixed, b.points, team);
    const LayerMotion motion = make_layer_motion(b.extrusion, b.fixed, b.points, metric, team);
    set_predictions(b.extrusion, motion, b.fixed, b.points, team);
  });
}

/// Of one row; a row that did not end has no rate. In millions a second, bytes a hexahedron.
struct Measured {
  double n_hexes = 0.0, rate = 0.0, rate_of_one = 0.0, bytes = 0.0;
};

Measured run(const Case& size, double bulge, int repeats, int threads) {
  Input b = make_block(size, bulge);
  const double n = static_cast<double>(size.n_hexes()), before = peak_bytes();
  PlacementReport report;
  double peak = 0.0;
  const auto place = [&](int n_threads) {
    Context context(n_threads);
    const auto once = [&] { report = place_interior(b.extrusion, b.fixed, b.points, {}, context); };
    if (peak == 0.0) {
      once();
      peak = peak_bytes();
    }
    return seconds_of(repeats, static_cast<std::size_t>(peak - before), once);
  };
  const Seconds all = place(threads), one = place(1);
  const Seconds affine = affine_only(b, repeats, threads),
                write = write_arrays(b, repeats, threads);
  const Measured m = {n, n / all.wall * 1e-6, n / one.cpu * 1e-6, peak / n};
  std::printf("%10.0f %8d %6d %9s %5d %9.4f %8.2f %8.1f %8.2f %8.1f %8.0f %8.3f\n", n,
              size.nx * size.ny, size.n_layers, bulge > 0 ? "solved" : "vanishes",
              report.n_iterations, all.wall, m.rate, 1e3 / m.rate_of_one, n / affine.wall * 1e-6,
              n / write.wall * 1e-6, m.bytes, report.min_scaled_jacobian);
  std::fflush(stdout);
  return m;
}

/// Runs f in a process of its own.
template <class F>
Measured in_child(F&& f) {
  void* shared =
      mmap(nullptr, sizeof(Measured), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return {};
  Measured* result = new (shared) Measured;
  const pid_t child = fork();
  if (child == 0) {
    *result = f();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) std::printf("failed: %d\n", status);
  const Measured copy = status == 0 ? *result : Measured{};
  munmap(shared, sizeof(Measured));
  return copy;
}

/// Of the fastest row to the slowest.
double factor_of(const std::vector<Measured>& rows, double Measured::*rate) {
  double slowest = 1e300, fastest = 0.0;
  for (const Measured& row : rows) {
    slowest = std::min(slowest, row.*rate);
    fastest = std::max(fastest, row.*rate);
  }
  return slowest > 0.0 ? fastest / slowest : 1e300;
}

/// Prints what the rows of one kind reached; whether all bounds are kept.
bool keeps_bounds(const char* kind, const std::vector<Measured>& rows, double least_rate) {
  constexpr double most_factor = 1.5, most_bytes = 300.0, large = 9e6;
  if (rows.empty()) return true;
  double slowest = 1e300, bytes = 0.0;
  for (const Measured& row : rows) {
    slowest = std::min(slowest, row.rate);
    if (row.n_hexes > large) bytes = std::max(bytes, row.bytes);
  }
  const double clock = factor_of(rows, &Measured::rate),
               cpu = factor_of(rows, &Measured::rate_of_one);
  const bool is_kept =
      std::max(clock, cpu) <= most_factor && slowest >= least_rate && bytes <= most_bytes;
  std::printf(
      "%s: factor %.2f by the clock, %.2f by CPU time on one thread (at most %.1f), least %.2f "
      "Mhex/s (at least %.1f), most %.0f bytes at ten million (at most %.0f): %s\n",
      kind, clock, cpu, most_factor, slowest, least_rate, bytes, most_bytes,
      is_kept ? "kept" : "MISSED");
  return is_kept;
}

}  // namespace

int main(int argc, char** argv) {
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e7;
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 3,
            threads = argc > 3 ? std::atoi(argv[3]) : 0, row = argc > 4 ? std::atoi(argv[4]) : -1;
  std::printf("%10s %8s %6s %9s %5s %9s %8s %8s %8s %8s %8s %8s\n", "hexes", "base", "layers",
              "residual", "iter", "seconds", "Mhex/s", "1 cpu ns", "affine", "write", "bytes",
              "min SJ");
  std::printf("%60s %8s %8s %8s %8s\n", "placed", "per hex", "Mhex/s", "Mhex/s", "per hex");
  std::fflush(stdout);
  const std::vector<Case> cases = {{22, 22, 21},    {46, 47, 46},     {100, 100, 100},
                                   {316, 316, 10},  {32, 31, 1000},   {200, 200, 100},
                                   {316, 316, 100}, {100, 100, 1000}, {1000, 1000, 10}};
  std::vector<Measured> solved, vanishing;
  for (const Case& size : cases) {
    if (row >= 0 && &size != &cases[row]) continue;
    if (size.n_hexes() > 1.05 * largest) continue;
    for (const double bulge : {0.02, 0.0})
      (bulge > 0.0 ? solved : vanishing).push_back(in_child([&] {
        return run(size, bulge, repeats, threads);
      }));
  }
  const bool is_kept = keeps_bounds("solved", solved, 1.5);
  return keeps_bounds("vanishing", vanishing, 5.0) && is_kept ? 0 : 1;
}
