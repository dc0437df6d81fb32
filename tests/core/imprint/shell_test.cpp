// Shells of hollow solids: what must be true of each, and what has none.
#include "sweepmesh/imprint/shell.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <variant>

#include "sweepmesh/imprint/imprint.h"
#include "sweepmesh/imprint/shell_counts.h"
#include "sweepmesh/scheme/assess.h"
#include "terraces.h"
#include "walled.h"

namespace sweepmesh {
namespace {

Scheme scheme_of(const test::Walled& w) {
  Context context;
  return assess(w.model, w.picks, context).schemes.at(0);
}

class Shells : public testing::TestWithParam<test::Walled> {
 protected:
  const Model& model() const { return GetParam().model; }
  const Shell& shell() const { return shell_; }
  const Scheme& scheme() const { return scheme_; }

 private:
  Context context_;
  Scheme scheme_ = scheme_of(GetParam());
  Shell shell_ = find_shell(model(), scheme_, context_);
};

std::vector<test::Walled> all_walled() {
  return test::walled_solids();
}

TEST_P(Shells, are_asked_for) {
  EXPECT_TRUE(is_shell_like(model(), scheme()));
}

TEST_P(Shells, have_closed_loops_and_the_topology_of_the_skin) {
  const auto end = [&](const DirectedEdge& d, bool last) {
    const ShellEdge& e = shell().edges[d.edge];
    return last != d.reversed ? e.end : e.start;
  };
  int n_discs = 0;
  for (const ShellPatch& p : shell().patches) {
    n_discs += 2 - static_cast<int>(p.loops.size());
    for (const auto& loop : p.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_EQ(end(loop[i], true), end(loop[(i + 1) % loop.size()], false));
  }
  EXPECT_EQ(shell().n_vertices - static_cast<int>(shell().edges.size()) + n_discs,
            GetParam().euler);
}

TEST_P(Shells, use_every_edge_once_each_way_or_on_the_rim) {
  std::map<int, std::set<bool>> uses;
  for (const ShellPatch& p : shell().patches)
    for (const auto& loop : p.loops)
      for (const DirectedEdge& d : loop) EXPECT_TRUE(uses[d.edge].insert(d.reversed).second);
  for (std::size_t e = 0; e < shell().edges.size(); ++e) {
    const bool is_cut =
        !shell().edges[e].high.edge.is_valid() && !shell().edges[e].low.edge.is_valid();
    EXPECT_GE(uses[static_cast<int>(e)].size(), is_cut ? 2u : 1u);
  }
}

TEST_P(Shells, cover_every_cap) {
  std::set<FaceId> sources, targets;
  for (const ShellPatch& p : shell().patches) {
    sources.insert(p.source);
    targets.insert(p.target);
  }
  EXPECT_EQ(sources, std::set(GetParam().picks.sources.begin(), GetParam().picks.sources.end()));
  EXPECT_EQ(targets, std::set(GetParam().picks.targets.begin(), GetParam().picks.targets.end()));
}

TEST_P(Shells, have_counts_that_quads_can_fill) {
  Context context;
  IntervalOptions options;
  options.size = 4.0;
  const PieceCounts counts = count_shell(model(), scheme(), shell(), options, context);
  for (const ShellPatch& p : shell().patches) {
    int sum = 0;
    for (const auto& loop : p.loops)
      for (const DirectedEdge& d : loop) sum += counts.edge[d.edge];
    EXPECT_EQ(sum % 2, 0);
  }
  for (std::size_t e = 0; e < shell().edges.size(); ++e)
    for (const ShellTrace* t : {&shell().edges[e].high, &shell().edges[e].low})
      if (t->edge.is_valid()) {
        EXPECT_EQ(counts.intervals.edge[t->edge.index], counts.edge[e]);
      }
}

INSTANTIATE_TEST_SUITE_P(Walled, Shells, testing::ValuesIn(all_walled()),
                         [](const auto& info) { return info.param.name; });

TEST(ShellErrors, SkinsThatAreDividedDifferentlyAreNamed) {
  const test::Walled w = test::box_with_can_void();
  const Context context;
  try {
    find_shell(w.model, scheme_of(w), context);
    FAIL() << "no error";
  } catch (const ImprintError& e) {
    EXPECT_EQ(e.failure(), ImprintFailure::unreachable);
    EXPECT_EQ(e.entities().size(), w.picks.sources.size() + w.picks.targets.size());
  }
}

TEST(ShellErrors, PrismsAreNoShells) {
  const Model model = test::terraced(
      {{test::rectangle(0, 0, 40, 30), 0, 20}, {test::rectangle(0, 0, 20, 30), 10, 32}});
  EXPECT_FALSE(is_shell_like(model, test::upright_scheme(model)));
}

}  // namespace
}  // namespace sweepmesh
