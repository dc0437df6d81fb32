#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/pipeline/sweep_solids.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

// A numpy view, n x width of T, of a vector whose items start with those values; `owner` keeps it
// alive.
template <class T, class Item>
py::array view(const std::vector<Item>& items, py::ssize_t width, const py::object& owner) {
  const auto* data = reinterpret_cast<const T*>(items.data());
  const py::ssize_t n = static_cast<py::ssize_t>(items.size());
  if (width == 1) return py::array_t<T>({n}, {sizeof(Item)}, data, owner);
  return py::array_t<T>({n, width}, {sizeof(Item), sizeof(T)}, data, owner);
}

const VolumeMesh& mesh_of(const py::object& result) {
  return result.cast<const SweepResult&>().mesh;
}

py::array owner_column(const py::object& result, std::size_t offset) {
  const auto& owners = mesh_of(result).owner;
  const auto* first = reinterpret_cast<const char*>(owners.data()) + offset;
  return py::array_t<int>({owners.size()}, {sizeof(Owner)}, reinterpret_cast<const int*>(first),
                          result);
}

template <class T>
auto property(py::ssize_t width, std::vector<T> VolumeMesh::*member) {
  return
      [=](const py::object& result) { return view<int>(mesh_of(result).*member, width, result); };
}

void bind_options(py::module_& module) {
  py::enum_<ElementKind>(module, "ElementKind")
      .value("hex", ElementKind::hex)
      .value("prism", ElementKind::prism)
      .value("polyhedron", ElementKind::polyhedron);
  py::class_<Bias>(module, "Bias")
      .def(py::init([](double ratio, bool symmetric) {
             return Bias{ratio, symmetric};
           }),
           py::arg("ratio"), py::arg("symmetric") = Bias{}.symmetric)
      .def_readonly("ratio", &Bias::ratio)
      .def_readonly("symmetric", &Bias::symmetric);
  py::class_<SweepOptions>(module, "SweepOptions")
      .def(py::init<>())
      .def_readwrite("size", &SweepOptions::size)
      .def_readwrite("layers", &SweepOptions::layers)
      .def_readwrite("element", &SweepOptions::element)
      .def_readwrite("order", &SweepOptions::order)
      .def(
          "set_edge_size",
          [](SweepOptions& o, int edge, double size) { o.edge_size[EdgeId(edge)] = size; },
          py::arg("edge"), py::arg("size"))
      .def(
          "set_edge_count",
          [](SweepOptions& o, int edge, int count) { o.edge_count[EdgeId(edge)] = count; },
          py::arg("edge"), py::arg("count"))
      .def(
          "set_edge_bias",
          [](SweepOptions& o, int edge, const Bias& bias) { o.edge_bias[EdgeId(edge)] = bias; },
          py::arg("edge"), py::arg("bias"))
      .def_readwrite("sweep_bias", &SweepOptions::sweep_bias)
      .def_readwrite("imprint_tolerance", &SweepOptions::imprint_tolerance)
      .def_readwrite("max_elements", &SweepOptions::max_elements)
      .def_readwrite("refuse_folds", &SweepOptions::refuse_folds);
}

}  // namespace

void bind_sweep(py::module_& module) {
  static_assert(sizeof(FaceId) == sizeof(int) && sizeof(EntityKind) == sizeof(int));
  bind_options(module);
  py::class_<SweepResult>(module, "SweepResult",
                          "Arrays are views: they live as long as this object.")
      .def_readonly("assessment", &SweepResult::assessment)
      .def_readonly("quality", &SweepResult::quality)
      .def_readonly("size", &SweepResult::size)
      .def_readonly("warnings", &SweepResult::warnings)
      .def_readonly("seconds", &SweepResult::seconds)
      .def_property_readonly("edge_intervals",
                             [](const SweepResult& r) { return r.intervals.edge; })
      .def_property_readonly("n_layers", [](const SweepResult& r) { return r.intervals.n_layers; })
      .def_property_readonly("area_deviation",
                             [](const SweepResult& r) {
                               std::map<int, double> by_face;
                               for (const FaceCoverage& f : r.coverage)
                                 by_face[f.face.index] = f.deviation();
                               return by_face;
                             })
      .def_property_readonly(
          "points", [](const SweepResult& r) -> const Points& { return r.mesh.points; },
          py::return_value_policy::reference_internal)
      .def_property_readonly("hexahedra", property(8, &VolumeMesh::hexahedra))
      .def_property_readonly("prisms", property(6, &VolumeMesh::prisms))
      .def_property_readonly("polyhedron_offset", property(1, &VolumeMesh::polyhedron_offset))
      .def_property_readonly("polyhedron_nodes", property(1, &VolumeMesh::polyhedron_nodes))
      .def_property_readonly("hexahedron_mid_nodes",
                             property(12, &VolumeMesh::hexahedron_mid_nodes))
      .def_property_readonly("prism_mid_nodes", property(9, &VolumeMesh::prism_mid_nodes))
      .def_property_readonly("boundary_mid_nodes", property(1, &VolumeMesh::boundary_mid_nodes))
      .def_property_readonly("boundary_offset", property(1, &VolumeMesh::boundary_offset))
      .def_property_readonly("boundary_nodes", property(1, &VolumeMesh::boundary_nodes))
      .def_property_readonly("boundary_face", property(1, &VolumeMesh::boundary_face))
      .def_property_readonly(
          "owner_kind", [](const py::object& r) { return owner_column(r, offsetof(Owner, kind)); })
      .def_property_readonly("owner_index", [](const py::object& r) {
        return owner_column(r, offsetof(Owner, index));
      });
  using unlocked = py::call_guard<py::gil_scoped_release>;
  module.def("solids_of", &solids_of, py::arg("model"), unlocked());
  module.def("sweep", &sweep_solids, py::arg("solids"), py::arg("picks"), py::arg("options"),
             py::arg("context"), unlocked());
  module.def(
      "scaled_jacobians",
      [](const SweepResult& result, const Context& context) {
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
            scaled_jacobians(result.mesh, context).data(), result.quality.n_elements));
      },
      py::arg("result"), py::arg("context"), unlocked());
  module.def("assess", &assess_solids, py::arg("solids"), py::arg("picks"), py::arg("context"),
             unlocked());
}

}  // namespace sweepmesh
