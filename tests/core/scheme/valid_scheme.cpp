#include "valid_scheme.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <optional>

namespace sweepmesh::test {

namespace {

struct Use {
  FaceRole role;
  std::optional<Direction> direction;  // on a linking face
  VertexId start, end;
};

std::map<EdgeId, std::vector<Use>> uses_of_edges(const Model& model, const Scheme& scheme) {
  std::map<EdgeId, std::vector<Use>> out;
  for (FaceId f : model.faces()) {
    const FaceRole role = scheme.face_role[f.index];
    const auto& loops = model.loops(f);
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c) {
        if (!loops[l][c].edge.is_valid()) continue;
        Use use{role, {}, loops[l][c].start, loops[l][c].end};
        if (role == FaceRole::linking) use.direction = scheme.face[f.index].direction[l][c];
        out[loops[l][c].edge].push_back(use);
      }
  }
  return out;
}

void expect_closed_loops(const Model& model, const Scheme& scheme, FaceId f) {
  const FaceScheme& face = scheme.face[f.index];
  ASSERT_EQ(face.type.size(), model.loops(f).size()) << name_of(f);
  int total = 0, n_open = 0;
  for (std::size_t l = 0; l < face.type.size(); ++l) {
    ASSERT_EQ(face.type[l].size(), model.loops(f)[l].size()) << name_of(f);
    int sum = 0;
    for (std::size_t c = 0; c < face.type[l].size(); ++c) {
      sum += static_cast<int>(face.type[l][c]);
      const Direction next = face.direction[l][(c + 1) % face.direction[l].size()];
      EXPECT_EQ(turned(face.direction[l][c], face.type[l][c]), next) << name_of(f);
    }
    total += sum;
    n_open += sum == 0;
    EXPECT_TRUE(sum == 0 || sum == (l == 0 ? 4 : -4)) << name_of(f) << " loop " << l;
  }
  EXPECT_EQ(total, 4 - 4 * static_cast<int>(face.type.size() - 1)) << name_of(f);
  EXPECT_TRUE(n_open == 0 || n_open == 2) << name_of(f);
}

bool is_cap(FaceRole role) {
  return role == FaceRole::source || role == FaceRole::target;
}

void expect_fitting(const Model& model, const Scheme& scheme, EdgeId e, const Use& a,
                    const Use& b) {
  const EdgeRole role = scheme.edge_role[e.index];
  if (is_cap(a.role) && is_cap(b.role)) {
    EXPECT_EQ(a.role, b.role) << name_of(e);
    EXPECT_EQ(role, EdgeRole::none) << name_of(e);
    return;
  }
  if (a.direction && b.direction) {
    EXPECT_EQ(*a.direction, opposite(*b.direction)) << name_of(e);
    EXPECT_EQ(role, is_axial(*a.direction) ? EdgeRole::axial : EdgeRole::transverse) << name_of(e);
    return;
  }
  const Use &cap = a.direction ? b : a, &linking = a.direction ? a : b;
  EXPECT_EQ(role, EdgeRole::transverse) << name_of(e);
  ASSERT_FALSE(is_axial(*linking.direction)) << name_of(e);
  const bool is_above = *linking.direction == Direction::plus_i;
  const bool is_end = is_above == (cap.role == FaceRole::target);
  const double tangent = 5 * std::numbers::pi / 180;
  if (is_end)
    EXPECT_LT(model.dihedral(e), std::numbers::pi + tangent) << name_of(e);
  else
    EXPECT_GT(model.dihedral(e), std::numbers::pi - tangent) << name_of(e);
}

/// Relaxes k upwards; a cycle would push it beyond the number of vertices.
void expect_layers(const Model& model, const Scheme& scheme,
                   const std::map<EdgeId, std::vector<Use>>& uses) {
  std::map<VertexId, int> k;
  const int most = static_cast<int>(model.vertices().size());
  bool is_changed = true;
  const auto raise = [&](VertexId v, int least) {
    if (k[v] >= least) return;
    k[v] = least;
    is_changed = true;
  };
  const auto join = [&](VertexId a, VertexId b) {
    raise(a, k[b]);
    raise(b, k[a]);
  };
  while (is_changed) {
    is_changed = false;
    for (const auto& [edge, list] : uses)
      for (const Use& use : list) {
        if (use.direction == Direction::plus_k) raise(use.end, k[use.start] + 1);
        if (scheme.edge_role[edge.index] != EdgeRole::axial) join(use.start, use.end);
      }
    for (FaceId f : model.faces())
      for (const Loop& loop : model.loops(f))
        for (const Coedge& c : loop)
          if (is_cap(scheme.face_role[f.index])) join(model.loops(f)[0][0].start, c.start);
    for (const auto& [v, layer] : k) ASSERT_LE(layer, most) << "k grows around a cycle";
  }
}

}  // namespace

void expect_valid_scheme(const Model& model, const Scheme& scheme) {
  ASSERT_EQ(static_cast<int>(scheme.face_role.size()), model.n_faces());
  ASSERT_EQ(static_cast<int>(scheme.edge_role.size()), model.n_edges());
  EXPECT_FALSE(scheme.faces_with(FaceRole::source).empty());
  EXPECT_FALSE(scheme.faces_with(FaceRole::target).empty());
  for (FaceId f : model.faces()) {
    ASSERT_NE(scheme.face_role[f.index], FaceRole::none) << name_of(f);
    if (scheme.face_role[f.index] == FaceRole::linking) expect_closed_loops(model, scheme, f);
  }
  const auto uses = uses_of_edges(model, scheme);
  for (const auto& [edge, list] : uses) {
    ASSERT_EQ(list.size(), 2u) << name_of(edge);
    expect_fitting(model, scheme, edge, list[0], list[1]);
  }
  expect_layers(model, scheme, uses);
}

}  // namespace sweepmesh::test
