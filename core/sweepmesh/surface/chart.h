// A one-to-one chart of a cap in the plane, with little distortion: where caps are meshed and
// mapped.
//
// A planar face is its own chart. Any other face is divided into facets in its parameter plane
// (parameter_plane.h), no larger than the elements, with the boundary's mesh edges as the facets'
// boundary; the facets are flattened by the symmetric Dirichlet energy (each facet tries to keep
// angles and areas alike, no facet can turn over), from the parameter plane's own layout, which is
// valid. A chart point has barycentric coordinates in its facet, these give a parameter point, and
// that is evaluated on the CAD surface: nodes lie on it exactly, whatever the facets' size.
//
// Source: thesis section 3.5 (facets between surface and domain); J. Smith, S. Schaefer, Bijective
// parameterization with free boundaries, ACM Trans. Graph. 34 (2015) (the energy).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sweepmesh/base/context.h"
#include "sweepmesh/model/model.h"
#include "sweepmesh/surface/cap_boundary.h"
#include "sweepmesh/surface/parameter_plane.h"
#include "sweepmesh/surface/planar_mesh.h"

namespace sweepmesh {

class Chart {
 public:
  /// `size`: length of facet edges, > 0 (longer where more than some 20 thousand facets would
  /// result). The model must outlive the chart. Throws InputError (loops that touch or cross, a
  /// face that closes on itself). `outer`: the loop that is wished to be the outer one, where there
  /// is a choice (a band).
  Chart(const Model& model, FaceId face, const CapLoops& loops, double size, const Context& context,
        std::optional<int> outer = {});

  /// The boundary nodes in the chart, counterclockwise around the domain; the outer loop first, the
  /// others in the caller's order. `order()[i]` is the caller's index of loop i.
  const PlanarLoops& loops() const { return loops_; }
  const std::vector<int>& order() const { return order_; }

  /// Of a chart point inside the loops (one just outside counts as on the nearest facet).
  Point2 uv(const Point2& p) const;
  Point3 point(const Point2& p) const;
  /// Lengths on the surface, facet by facet; the identity, as an empty function, for a planar face.
  /// Refers to the chart, which must outlive it.
  Metric metric() const;

 private:
  struct Facet {
    std::array<int, 3> node;
    Eigen::Matrix2d root;  ///< the metric
  };
  void sort_loops();
  void make_facets(double size);
  void flatten(const Context& context);
  bool is_one_to_one() const;
  void prepare_search();
  int facet_at(const Point2& p, Eigen::Vector3d& barycentric) const;
  Eigen::Vector3d barycentric(int facet, const Point2& p) const;

  const Model* model_;
  FaceId face_;
  ParameterPlane plane_;
  PlanarLoops loops_;
  std::vector<int> order_;
  std::vector<Facet> facets_;
  std::vector<Point2> flat_, parameter_;  ///< of facet nodes: in the chart, in the parameter plane
  std::vector<Point3> space_;
  Point2 low_ = Point2::Zero();  ///< search grid: lowest corner, cell, counts, facets per cell
  double cell_ = 1.0;
  Eigen::Vector2i counts_ = Eigen::Vector2i::Zero();
  std::vector<std::vector<int>> facets_in_cell_;
};

}  // namespace sweepmesh
