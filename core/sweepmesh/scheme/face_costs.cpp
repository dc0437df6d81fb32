#include "sweepmesh/scheme/face_costs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sweepmesh/scheme/loop_program.h"

namespace sweepmesh {

namespace {

constexpr double kMaxFrameError = 75.0 * std::numbers::pi / 180.0;

/// Angle between a coedge's heading and where it points in a frame for a direction, 0..pi.
double frame_error(double heading, double frame, int direction) {
  return std::abs(std::remainder(heading - frame - direction * kQuarterTurn, 4 * kQuarterTurn));
}

class FaceSolver {
 public:
  FaceSolver(const SweepProblem& problem, int face, const std::vector<StateCosts>& coedge_cost,
             const std::vector<std::array<double, 4>>& corner_cost, const Preferences& preferences,
             double limit)
      : problem_(problem),
        face_(problem.faces[face]),
        first_(problem.first_coedge(face)),
        coedge_cost_(coedge_cost),
        corner_cost_(corner_cost),
        preferences_(preferences),
        limit_(limit) {
    StateCosts none;
    none.fill(kImpossible);
    out_.marginal.assign(coedge_cost.size(), none);
  }

  FaceCosts solve() {
    add_cap(kSourceState);
    add_cap(kTargetState);
    if (!face_.is_degenerate && is_linking_possible()) add_linking();
    return std::move(out_);
  }

 private:
  bool is_linking_possible() const {
    return std::ranges::all_of(coedge_cost_, [](const StateCosts& cost) {
      return *std::min_element(cost.begin(), cost.begin() + 4) < kImpossible;
    });
  }

  void add_cap(int state) {
    double sum = preferences_.per_cap;
    for (const StateCosts& cost : coedge_cost_) sum += cost[state];
    for (StateCosts& marginal : out_.marginal) marginal[state] = sum;
    out_.best = std::min(out_.best, sum);
  }

  void add_linking() {
    const std::size_t n_loops = face_.loops.size();
    if (n_loops == 1) return merge({program(0, 4)}, 0.0);
    const double frame = outer_frame();
    for (int turn = 0; turn < 4; ++turn) {
      std::vector<LoopProgram> programs;
      for (std::size_t l = 0; l < n_loops; ++l)
        programs.push_back(in_frame(l, frame - turn * kQuarterTurn));
      merge(std::move(programs), 0.0);
    }
    for (std::size_t hole = 1; hole < n_loops; ++hole)
      for (Direction outer : {Direction::plus_i, Direction::minus_i}) {
        std::vector<LoopProgram> programs = {around(0, outer)};
        for (std::size_t l = 1; l < n_loops; ++l)
          programs.push_back(l == hole ? around(l, opposite(outer)) : program(l, -4));
        merge(std::move(programs), preferences_.per_annulus);
      }
  }

  LoopProgram program(std::size_t l, int sum) const {
    LoopProgram out;
    out.sum = sum;
    const ProblemLoop& loop = face_.loops[l];
    for (int c = loop.first - first_; c < loop.first - first_ + loop.count; ++c) {
      out.direction_cost.push_back(
          {coedge_cost_[c][0], coedge_cost_[c][1], coedge_cost_[c][2], coedge_cost_[c][3]});
      out.type_cost.push_back(corner_cost_[c]);
    }
    return out;
  }

  /// A loop that runs once around an annulus, its transverse coedges all one way.
  LoopProgram around(std::size_t l, Direction way) const {
    LoopProgram out = program(l, 0);
    for (auto& cost : out.direction_cost) cost[static_cast<int>(opposite(way))] = kImpossible;
    return out;
  }

  /// The angle that the outer loop's headings have in common, modulo a quarter turn.
  double outer_frame() const {
    double x = 0.0, y = 0.0;
    const ProblemLoop& outer = face_.loops[0];
    for (int c = outer.first; c < outer.first + outer.count; ++c) {
      const ProblemCoedge& coedge = problem_.coedges[c];
      x += coedge.length * std::cos(4 * coedge.heading);
      y += coedge.length * std::sin(4 * coedge.heading);
    }
    return std::atan2(y, x) / 4;
  }

  /// Hole: only directions near its headings in the frame. Outer loop: the coedge that lies best in
  /// the frame has the direction that it has there.
  LoopProgram in_frame(std::size_t l, double frame) const {
    LoopProgram out = program(l, l == 0 ? 4 : -4);
    const ProblemLoop& loop = face_.loops[l];
    int best = -1, best_direction = 0;
    double best_error = kImpossible;
    for (int c = 0; c < loop.count; ++c)
      for (int d = 0; d < 4; ++d) {
        const double error = frame_error(problem_.coedges[loop.first + c].heading, frame, d);
        if (l > 0 && error > kMaxFrameError) out.direction_cost[c][d] = kImpossible;
        if (error < best_error - kMaxFrameError * 1e-6) {
          best_error = error;
          best = c;
          best_direction = d;
        }
      }
    for (int d = 0; l == 0 && d < 4; ++d)
      if (d != best_direction) out.direction_cost[best][d] = kImpossible;
    return out;
  }

  /// Lowers the marginals to what one choice of sums and frame allows, which costs `sum` by itself.
  void merge(std::vector<LoopProgram> programs, double sum) {
    std::vector<LoopMarginals> loops;
    for (LoopProgram& p : programs) {
      p.limit = limit_ - sum;
      loops.push_back(loop_marginals(p));
      sum += loops.back().best;
      out_.work += loops.back().work;
      if (!(sum <= limit_ && sum < kImpossible)) return;
    }
    out_.best = std::min(out_.best, sum);
    std::size_t c = 0;
    for (const LoopMarginals& loop : loops)
      for (const auto& marginal : loop.marginal) {
        for (int d = 0; d < 4; ++d)
          out_.marginal[c][d] = std::min(out_.marginal[c][d], sum - loop.best + marginal[d]);
        ++c;
      }
  }

  const SweepProblem& problem_;
  const ProblemFace& face_;
  int first_;
  const std::vector<StateCosts>& coedge_cost_;
  const std::vector<std::array<double, 4>>& corner_cost_;
  const Preferences& preferences_;
  double limit_;
  FaceCosts out_;
};

}  // namespace

double FaceCosts::of_role(FaceRole role) const {
  if (marginal.empty()) return best;
  const StateCosts& m = marginal.front();
  if (role == FaceRole::source) return m[kSourceState];
  if (role == FaceRole::target) return m[kTargetState];
  return *std::min_element(m.begin(), m.begin() + 4);
}

FaceCosts face_costs(const SweepProblem& problem, int face,
                     const std::vector<StateCosts>& coedge_cost,
                     const std::vector<std::array<double, 4>>& corner_cost,
                     const Preferences& preferences, double limit) {
  return FaceSolver(problem, face, coedge_cost, corner_cost, preferences, limit).solve();
}

}  // namespace sweepmesh
