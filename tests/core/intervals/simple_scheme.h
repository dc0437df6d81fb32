// A scheme for tests: sources and targets given, vertex types from the nearest multiple of 90
// degrees. It knows nothing of the scheme stage, so intervals and grids are tested on their own.
#pragma once

#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "sweepmesh/model/model.h"
#include "sweepmesh/scheme/scheme.h"

namespace sweepmesh::testing {

inline bool contains(const std::vector<FaceId>& list, FaceId f) {
  for (const FaceId g : list)
    if (g == f) return true;
  return false;
}

inline VertexType nearest_type(double angle) {
  const int t = static_cast<int>(std::lround(2.0 * (1.0 - angle / std::numbers::pi)));
  return static_cast<VertexType>(std::max(-2, std::min(1, t)));
}

inline void set_types(const Model& model, FaceId f, FaceScheme& face) {
  const auto& loops = model.loops(f);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    face.type.emplace_back();
    face.direction.emplace_back(loops[l].size(), Direction::plus_i);
    for (std::size_t c = 0; c < loops[l].size(); ++c)
      face.type[l].push_back(nearest_type(model.interior_angle(f, int(l), int(c))));
  }
}

/// Directions of a loop from that of one of its coedges.
inline void spread(const Model& model, FaceId f, std::size_t l, std::size_t c, Direction d,
                   FaceScheme& face) {
  const std::size_t n = model.loops(f)[l].size();
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t at = (c + step) % n;
    face.direction[l][at] = d;
    d = turned(d, face.type[l][at]);
  }
}

/// What lies across an edge gives a coedge its direction: a linking face above a cap (on a target's
/// convex edge, on a source's concave one) has +i there, one below it -i; another linking face
/// gives the opposite of its own coedge's.
inline Scheme simple_scheme(const Model& model, const std::vector<FaceId>& sources,
                            const std::vector<FaceId>& targets) {
  Scheme s;
  s.face_role.assign(model.n_faces(), FaceRole::none);
  s.edge_role.assign(model.n_edges(), EdgeRole::none);
  s.face.resize(model.n_faces());
  std::vector<std::vector<char>> known(model.n_faces());
  for (const FaceId f : model.faces()) {
    s.face_role[f.index] = contains(sources, f)   ? FaceRole::source
                           : contains(targets, f) ? FaceRole::target
                                                  : FaceRole::linking;
    if (s.face_role[f.index] == FaceRole::linking) set_types(model, f, s.face[f.index]);
    known[f.index].assign(model.loops(f).size(), 0);
  }
  bool changed = true;
  while (changed) {
    changed = false;
    for (const FaceId f : model.faces()) {
      if (s.face_role[f.index] != FaceRole::linking) continue;
      for (std::size_t l = 0; l < model.loops(f).size(); ++l) {
        if (known[f.index][l]) continue;
        const Loop& loop = model.loops(f)[l];
        for (std::size_t c = 0; c < loop.size() && !known[f.index][l]; ++c) {
          if (!loop[c].edge.is_valid() || loop[c].seam) continue;
          const Coedge& other = model.partner(loop[c]);
          const FaceRole role = s.face_role[other.face.index];
          std::optional<Direction> d;
          const bool is_convex = model.dihedral(loop[c].edge) < std::numbers::pi;
          if (role == FaceRole::target) d = is_convex ? Direction::plus_i : Direction::minus_i;
          if (role == FaceRole::source) d = is_convex ? Direction::minus_i : Direction::plus_i;
          if (role == FaceRole::linking) {
            const auto& loops = model.loops(other.face);
            for (std::size_t m = 0; m < loops.size(); ++m)
              for (std::size_t j = 0; j < loops[m].size(); ++j)
                if (known[other.face.index][m] && loops[m][j].edge == loop[c].edge)
                  d = opposite(s.face[other.face.index].direction[m][j]);
          }
          if (!d) continue;
          spread(model, f, l, c, *d, s.face[f.index]);
          known[f.index][l] = 1;
          changed = true;
        }
      }
    }
  }
  for (const FaceId f : model.faces()) {
    if (s.face_role[f.index] != FaceRole::linking) continue;
    for (std::size_t l = 0; l < model.loops(f).size(); ++l)
      for (std::size_t c = 0; c < model.loops(f)[l].size(); ++c) {
        const EdgeId e = model.loops(f)[l][c].edge;
        if (e.is_valid())
          s.edge_role[e.index] =
              is_axial(s.face[f.index].direction[l][c]) ? EdgeRole::axial : EdgeRole::transverse;
      }
  }
  return s;
}

}  // namespace sweepmesh::testing
