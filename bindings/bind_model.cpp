#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/model/model.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

template <class Ids>
std::vector<int> indices(const Ids& ids) {
  std::vector<int> out;
  for (const auto id : ids) out.push_back(id.index);
  return out;
}

}  // namespace

void bind_model(py::module_& module) {
  using unlocked = py::call_guard<py::gil_scoped_release>;
  py::class_<Model>(module, "Model",
                    "One solid of a CAD shape. Faces, edges and vertices count from 0 here.")
      .def_static("from_file", &Model::from_file, py::arg("path"), py::arg("solid"), unlocked())
      .def_static("from_brep", &Model::from_brep, py::arg("text"), py::arg("solid"), unlocked())
      .def("of_solid", &Model::of_solid, py::arg("solid"), unlocked())
      .def_property_readonly("n_solids", &Model::n_solids)
      .def_property_readonly("n_faces", &Model::n_faces)
      .def_property_readonly("n_edges", &Model::n_edges)
      .def_property_readonly("n_vertices", &Model::n_vertices)
      .def_property_readonly("faces", [](const Model& m) { return indices(m.faces()); })
      .def_property_readonly("volume", &Model::volume, unlocked())
      .def_property_readonly("model_size", [](const Model& m) { return m.tolerances().model_size; })
      .def(
          "area", [](const Model& m, int face) { return m.area(FaceId{face}); }, py::arg("face"))
      .def(
          "distance_to_face",
          [](const Model& m, int face, const Point3& p) { return m.distance(FaceId{face}, p); },
          py::arg("face"), py::arg("point"), unlocked())
      .def(
          "distance_to_edge",
          [](const Model& m, int edge, const Point3& p) { return m.distance(EdgeId{edge}, p); },
          py::arg("edge"), py::arg("point"), unlocked())
      .def(
          "vertex_point", [](const Model& m, int vertex) { return m.point(VertexId{vertex}); },
          py::arg("vertex"))
      .def(
          "nearest_face", [](const Model& m, const Point3& p) { return m.nearest_face(p).index; },
          py::arg("point"), unlocked());
}

}  // namespace sweepmesh
