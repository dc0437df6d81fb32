#include "sweepmesh/pipeline/imprint_shapes.h"

#include <exception>
#include <map>
#include <utility>

#include "sweepmesh/imprint/divided_caps.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/imprint/shell.h"
#include "sweepmesh/pipeline/sweep_solids.h"

namespace sweepmesh {
namespace {

/// One source over one target: both stay whole, and are the only pair.
std::vector<CapDivision> whole_caps(const Model& model, const Scheme& scheme) {
  std::vector<CapDivision> out;
  for (const FaceRole role : {FaceRole::target, FaceRole::source})
    out.push_back({{model, scheme.faces_with(role).front(), {}}, {}, 0});
  return out;
}

/// The caps of a shell stay whole: its sources and targets are divided alike (shell.h).
std::vector<CapDivision> caps_of_shell(const Model& model, const Shell& shell) {
  std::map<std::pair<FaceId, FaceId>, int> pairs;
  for (const ShellPatch& p : shell.patches)
    pairs.try_emplace({p.source, p.target}, static_cast<int>(pairs.size()));
  std::vector<CapDivision> out;
  for (const auto& [faces, pair] : pairs)
    for (const FaceId f : {faces.first, faces.second}) out.push_back({{model, f, {}}, {}, pair});
  return out;
}

class ShapeMaker {
 public:
  ShapeMaker(ImprintShapes& out, std::vector<double> merge_fractions, Context& context)
      : out_(out), merge_fractions_(std::move(merge_fractions)), context_(context) {}

  /// Where near curves, brought together within one distance, cannot be imprinted or drawn, within
  /// the next one, as sweep() does.
  void add_solid(const Model& model, const Scheme& scheme) {
    if (is_one_to_one(scheme)) return add(whole_caps(model, scheme), scheme, 1);
    if (is_shell_like(model, scheme)) {
      auto caps = caps_of_shell(model, find_shell(model, scheme, context_));
      const int n_pairs = static_cast<int>(caps.size()) / 2;
      return add(std::move(caps), scheme, n_pairs);
    }
    std::exception_ptr first;
    for (const double fraction : merge_fractions_) try {
        return add_imprint(model, scheme, fraction);
      } catch (const InvalidMeshError&) {
        if (!first) first = std::current_exception();
      } catch (const ImprintError&) {
        if (!first) first = std::current_exception();
      }
    std::rethrow_exception(first);
  }

  void make_shapes() {
    std::vector<FaceDivision> divisions;
    for (const CapDivision& c : caps_) divisions.push_back(c.division);
    DividedFaces divided = divide_faces(divisions);
    out_.caps = std::move(divided.faces);
    out_.curves = std::move(divided.curves);
    for (const FacePiece& piece : divided.pieces) {
      const CapDivision& cap = caps_[piece.division];
      const int pair = piece.curve < 0 ? cap.whole
                       : piece.is_left ? cap.sides[piece.curve].left
                                       : cap.sides[piece.curve].right;
      out_.parts.push_back({cap.division.face, is_source_[piece.division], pair});
    }
  }

 private:
  void add_imprint(const Model& model, const Scheme& scheme, double merge_fraction) {
    const ImprintOptions how{.size = out_.size, .merge_fraction = merge_fraction};
    const Imprint imprint = imprint_caps(model, scheme, how, context_);
    auto caps = divide_caps(model, scheme, imprint, context_);
    int n_runs = 0;
    for (const Patch& p : imprint.patches) n_runs += static_cast<int>(p.runs.size());
    out_.merges.insert(out_.merges.end(), imprint.merges.begin(), imprint.merges.end());
    add(std::move(caps), scheme, n_runs);
  }

  void add(std::vector<CapDivision> caps, const Scheme& scheme, int n_pairs) {
    for (CapDivision& c : caps) {
      for (auto& side : c.sides) side.left += out_.n_pairs, side.right += out_.n_pairs;
      if (c.whole >= 0) c.whole += out_.n_pairs;
      const FaceId face = c.division.face;
      out_.curve_on.insert(out_.curve_on.end(), c.division.curves.size(), face);
      is_source_.push_back(scheme.face_role[face.index] == FaceRole::source);
      caps_.push_back(std::move(c));
    }
    out_.n_pairs += n_pairs;
  }

  ImprintShapes& out_;
  std::vector<double> merge_fractions_;
  Context& context_;
  std::vector<CapDivision> caps_;
  std::vector<bool> is_source_;  ///< by cap
};

}  // namespace

ImprintShapes imprint_solids(const std::vector<Model>& solids, const Picks& picks,
                             const SweepOptions& options, Context& context) {
  check_options(options);
  check_picks(picks);
  check_pairs(solids, picks);
  ImprintShapes out;
  out.size = options.size.value_or(smallest_default_size(solids));
  std::vector<Assessment> verdicts;
  for (const Model& solid : solids)
    verdicts.push_back(assess(solid, picks_on(solid, picks), context));
  out.assessment = solids.size() == 1 ? verdicts.front() : merged_verdicts(verdicts);
  if (!out.assessment.is_sweepable()) return out;
  ShapeMaker maker(out, merge_fractions(options, out.size), context);
  for (std::size_t s = 0; s < solids.size(); ++s)
    maker.add_solid(solids[s], verdicts[s].schemes.front());
  maker.make_shapes();
  return out;
}

}  // namespace sweepmesh
