#include "sweepmesh/pipeline/imprint_shapes.h"

#include <map>
#include <utility>

#include "sweepmesh/imprint/divided_caps.h"
#include "sweepmesh/pipeline/cap_match.h"
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
  ShapeMaker(ImprintShapes& out, const SweepOptions& options, Context& context)
      : out_(out), options_(options), context_(context) {}

  void add_solid(const Model& model, const Scheme& scheme) {
    with_some_merging(merge_fractions(model, scheme, options_, out_.size),
                      CapMatcher(model, scheme, out_.size, context_),
                      [&](const CapMatch& match, double) { add(model, scheme, match); });
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
  void add(const Model& model, const Scheme& scheme, const CapMatch& match) {
    if (const auto* imprint = std::get_if<Imprint>(&match))
      return add_imprint(model, scheme, *imprint);
    const auto* shell = std::get_if<Shell>(&match);
    auto caps = shell ? caps_of_shell(model, *shell) : whole_caps(model, scheme);
    const int n_pairs = static_cast<int>(caps.size()) / 2;
    add(std::move(caps), scheme, n_pairs);
  }

  void add_imprint(const Model& model, const Scheme& scheme, const Imprint& imprint) {
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
  const SweepOptions& options_;
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
  ShapeMaker maker(out, options, context);
  for (std::size_t s = 0; s < solids.size(); ++s)
    maker.add_solid(solids[s], verdicts[s].schemes.front());
  maker.make_shapes();
  return out;
}

}  // namespace sweepmesh
