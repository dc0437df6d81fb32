#include "sweepmesh/imprint_shapes.h"

#include "sweepmesh/imprint/divided_caps.h"
#include "sweepmesh/imprint/imprint_caps.h"
#include "sweepmesh/sweep_solids.h"

namespace sweepmesh {
namespace {

/// One source over one target: both stay whole, and are the only pair.
std::vector<CapDivision> whole_caps(const Model& model, const Scheme& scheme) {
  std::vector<CapDivision> out;
  for (const FaceRole role : {FaceRole::target, FaceRole::source})
    out.push_back({{model, scheme.faces_with(role).front(), {}}, {}, 0});
  return out;
}

class ShapeMaker {
 public:
  ShapeMaker(ImprintShapes& out, double merge_fraction, Context& context)
      : out_(out), merge_fraction_(merge_fraction), context_(context) {}

  void add_solid(const Model& model, const Scheme& scheme) {
    if (is_one_to_one(scheme)) return add(whole_caps(model, scheme), scheme, 1);
    const Imprint imprint = imprint_caps(
        model, scheme, {.size = out_.size, .merge_fraction = merge_fraction_}, context_);
    int n_runs = 0;
    for (const Patch& p : imprint.patches) n_runs += static_cast<int>(p.runs.size());
    out_.merges.insert(out_.merges.end(), imprint.merges.begin(), imprint.merges.end());
    add(divide_caps(model, scheme, imprint, context_), scheme, n_runs);
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
  double merge_fraction_;
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
  ShapeMaker maker(out, merge_fractions(options, out.size).front(), context);
  for (std::size_t s = 0; s < solids.size(); ++s)
    maker.add_solid(solids[s], verdicts[s].schemes.front());
  maker.make_shapes();
  return out;
}

}  // namespace sweepmesh
