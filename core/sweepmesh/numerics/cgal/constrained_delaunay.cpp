#include "sweepmesh/numerics/cgal/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>
#include <map>

#include "sweepmesh/base/errors.h"

namespace sweepmesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_tag>;

[[noreturn]] void refuse_crossing() {
  throw InputError("surface",
                   "The boundary loops of a face touch or cross; choose a smaller element size.");
}

Triangulation triangulated(const std::vector<Point2>& points,
                           const std::vector<std::vector<int>>& loops) {
  Triangulation t;
  std::vector<Triangulation::Vertex_handle> vertex(points.size());
  Triangulation::Face_handle hint;
  for (std::size_t i = 0; i < points.size(); ++i) {
    vertex[i] = t.insert(Kernel::Point_2(points[i].x(), points[i].y()), hint);
    hint = vertex[i]->face();
    vertex[i]->info() = static_cast<int>(i);
  }
  if (t.number_of_vertices() != points.size()) refuse_crossing();
  try {
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        t.insert_constraint(vertex[loop[i]], vertex[loop[(i + 1) % loop.size()]]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    refuse_crossing();
  }
  return t;
}

/// Of each face, the number of constraints between it and the outside.
std::map<Triangulation::Face_handle, int> depths(const Triangulation& t) {
  std::map<Triangulation::Face_handle, int> depth;
  std::deque<Triangulation::Face_handle> queue = {t.infinite_face()};
  depth[t.infinite_face()] = 0;
  while (!queue.empty()) {
    const auto face = queue.front();
    queue.pop_front();
    const int d = depth[face];
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      const bool is_border = face->is_constrained(i);
      if (!depth.try_emplace(next, d + is_border).second) continue;
      // Faces on this side of a border come first, so that every depth is the least one.
      if (is_border)
        queue.push_back(next);
      else
        queue.push_front(next);
    }
  }
  return depth;
}

}  // namespace

std::vector<std::array<int, 3>> constrained_delaunay(const std::vector<Point2>& points,
                                                     const std::vector<std::vector<int>>& loops) {
  const Triangulation t = triangulated(points, loops);
  const auto depth = depths(t);
  std::vector<std::array<int, 3>> out;
  for (const auto face : t.finite_face_handles())
    if (depth.at(face) % 2 == 1)
      out.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return out;
}

}  // namespace sweepmesh
