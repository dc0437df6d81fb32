#include "sweepmesh/volume/assemble.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

[[noreturn]] void fail(const std::string& sentence) {
  throw Error("assemble", sentence);
}

Extrusion make_extrusion(const std::vector<ColumnNodes>& columns,
                         const std::vector<CellRun>& runs) {
  Extrusion extrusion;
  for (const ColumnNodes& column : columns)
    extrusion.add_column(column.k_low, column.k_low + static_cast<int>(column.nodes.size()) - 1);
  std::vector<int> cell;
  for (const CellRun& run : runs) {
    cell.clear();
    for (const ColumnId c : run.columns) {
      if (run.k_low < extrusion.k_low[c.index] || run.k_high > extrusion.k_high[c.index])
        fail("A run of elements leaves the layers of one of its columns.");
      cell.push_back(c.index);
    }
    extrusion.add_cell(cell, run.k_low, run.k_high);
  }
  return extrusion;
}

}  // namespace

Assembly assemble(const SurfaceMesh& surface, const std::vector<ColumnNodes>& columns,
                  const std::vector<CellRun>& runs) {
  Assembly out;
  out.extrusion = make_extrusion(columns, runs);
  out.fixed.assign(out.extrusion.n_nodes(), 0);
  out.points = Points::Zero(out.extrusion.n_nodes(), 3);
  out.volume_node.assign(surface.n_nodes(), -1);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t j = 0; j < columns[c].nodes.size(); ++j) {
      const NodeId node = columns[c].nodes[j];
      if (!node.is_valid()) continue;
      if (out.volume_node[node.index] >= 0) fail("A node of the boundary lies in two columns.");
      const long volume_node = out.extrusion.column_offset[c] + static_cast<long>(j);
      out.volume_node[node.index] = static_cast<int>(volume_node);
      out.fixed[volume_node] = 1;
      out.points.row(volume_node) = surface.points[node.index];
    }
  for (const int node : out.volume_node)
    if (node < 0) fail("A node of the boundary lies in no column.");
  return out;
}

std::vector<int> overlapping_runs(const std::vector<CellRun>& runs) {
  struct Side {
    int from, to, k_low, k_high, run;
    auto key() const { return std::tuple(from, to, k_low); }
  };
  std::vector<Side> sides;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& columns = runs[r].columns;
    for (std::size_t i = 0; i < columns.size(); ++i)
      sides.push_back({columns[i].index, columns[(i + 1) % columns.size()].index, runs[r].k_low,
                       runs[r].k_high, static_cast<int>(r)});
  }
  std::ranges::sort(sides, {}, &Side::key);
  std::set<int> out;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    if (a.from == b.from && a.to == b.to && b.k_low < a.k_high) out.insert({a.run, b.run});
  }
  return {out.begin(), out.end()};
}

void add_boundary(const SurfaceMesh& surface, const Assembly& assembly, VolumeMesh& mesh) {
  for (const int node : surface.cell_nodes)
    mesh.boundary_nodes.push_back(assembly.volume_node[node]);
  mesh.boundary_offset = surface.cell_offset;
  mesh.boundary_face = surface.cell_face;
  mesh.owner.assign(assembly.extrusion.n_nodes(), Owner{});
  for (int n = 0; n < surface.n_nodes(); ++n)
    mesh.owner[assembly.volume_node[n]] = surface.owner[n];
}

}  // namespace sweepmesh
