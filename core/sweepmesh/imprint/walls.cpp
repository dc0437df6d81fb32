#include "sweepmesh/imprint/walls.h"

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

/// A seam, or an edge with the same cap on both sides, divides nothing.
bool divides(const Model& model, EdgeId e) {
  const auto& uses = model.coedges(e);
  return uses.size() == 2 && uses[0].face != uses[1].face;
}

int level_of(const Model& model, EdgeId e, const std::vector<int>& level) {
  const int first = level[model.start(e).index], last = level[model.end(e).index];
  if (first < 0 || first != last)
    throw Error("imprint", "The ends of " + name_of(e) + " do not lie on one level.", {name_of(e)});
  return first;
}

void set_side(std::vector<FaceId>& side, EdgeId e, FaceId f) {
  if (side[e.index].is_valid())
    throw Error("imprint", "Two linking faces lie on the same side of " + name_of(e) + ".",
                {name_of(e), name_of(side[e.index]), name_of(f)});
  side[e.index] = f;
}

/// A coedge along +i has its face above it and the solid on its left; one along -i has the face
/// below and the solid on its right.
void add_coedge(const Coedge& c, Direction d, Walls& walls) {
  if (d == Direction::plus_i) {
    set_side(walls.above, c.edge, c.face);
    walls.solid_left_above[c.edge.index] = !c.reversed;
    walls.bottoms[c.face.index].push_back(c.edge);
  } else {
    set_side(walls.below, c.edge, c.face);
    walls.solid_left_below[c.edge.index] = c.reversed;
    walls.tops[c.face.index].push_back(c.edge);
  }
}

void add_sides(const Loop& loop, const std::vector<Direction>& directions, FaceId f, Walls& walls) {
  const std::size_t n = loop.size();
  for (std::size_t first = 0; first < n; ++first) {
    const Direction d = directions[first];
    if (!is_axial(d) || directions[(first + n - 1) % n] == d) continue;
    std::size_t last = first;
    while (directions[(last + 1) % n] == d) ++last;
    walls.sides[f.index].push_back({loop[first].start, loop[last % n].end});
  }
}

}  // namespace

Walls find_walls(const Model& model, const Scheme& scheme, const std::vector<int>& level) {
  Walls walls;
  walls.vertex_level = level;
  walls.level.assign(model.n_edges(), -1);
  walls.above.resize(model.n_edges());
  walls.below.resize(model.n_edges());
  walls.solid_left_above.assign(model.n_edges(), 0);
  walls.solid_left_below.assign(model.n_edges(), 0);
  walls.bottoms.resize(model.n_faces());
  walls.tops.resize(model.n_faces());
  walls.sides.resize(model.n_faces());
  for (const EdgeId e : model.edges()) {
    if (scheme.edge_role[e.index] == EdgeRole::axial || !divides(model, e)) continue;
    walls.level[e.index] = level_of(model, e, level);
    walls.edges.push_back(e);
  }
  for (const FaceId f : model.faces()) {
    if (scheme.face_role[f.index] != FaceRole::linking) continue;
    const auto& loops = model.loops(f);
    for (std::size_t l = 0; l < loops.size(); ++l) {
      add_sides(loops[l], scheme.face[f.index].direction[l], f, walls);
      for (std::size_t c = 0; c < loops[l].size(); ++c) {
        const Coedge& coedge = loops[l][c];
        const Direction d = scheme.face[f.index].direction[l][c];
        if (coedge.edge.is_valid() && !is_axial(d) && walls.level[coedge.edge.index] >= 0)
          add_coedge(coedge, d, walls);
      }
    }
  }
  return walls;
}

}  // namespace sweepmesh
