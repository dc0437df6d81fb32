#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/scheme/face_types.h"
#include "sweepmesh/scheme/scheme.h"

namespace py = pybind11;

namespace sweepmesh {
namespace {

std::vector<FaceId> face_ids(const std::vector<int>& faces) {
  std::vector<FaceId> out;
  for (const int face : faces) out.emplace_back(face);
  return out;
}

Picks make_picks(const std::vector<int>& sources, const std::vector<int>& targets,
                 const std::vector<std::pair<int, int>>& pairs,
                 const std::vector<std::tuple<int, int, VertexType>>& types) {
  Picks picks{face_ids(sources), face_ids(targets), {}};
  for (const auto& [source, target] : pairs) picks.pairs.emplace_back(source, target);
  for (const auto& [face, vertex, type] : types)
    picks.types.push_back({FaceId{face}, VertexId{vertex}, type});
  return picks;
}

std::vector<TypedCorner> face_types(const Model& model, int face, const Picks& picks,
                                    TypeModel type_model, bool has_templates, Context& context) {
  return types_of_face(model, FaceId{face}, {type_model, has_templates, picks.types}, context);
}

void bind_face_types(py::module_& module) {
  py::enum_<TypeModel>(module, "TypeModel")
      .value("fewest_changes", TypeModel::fewest_changes)
      .value("ruiz_girones", TypeModel::ruiz_girones);
  py::class_<TypedCorner>(module, "TypedCorner")
      .def_readonly("loop", &TypedCorner::loop)
      .def_property_readonly("vertex", [](const TypedCorner& c) { return c.vertex.index; })
      .def_property_readonly("edge", [](const TypedCorner& c) { return c.edge.index; })
      .def_readonly("point", &TypedCorner::point)
      .def_readonly("angle", &TypedCorner::angle)
      .def_readonly("nearest", &TypedCorner::nearest)
      .def_readonly("type", &TypedCorner::type);
  module.def("face_types", &face_types, py::arg("model"), py::arg("face"), py::arg("picks"),
             py::arg("type_model"), py::arg("has_templates"), py::arg("context"),
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace

void bind_scheme(py::module_& module) {
  py::enum_<FaceRole>(module, "FaceRole")
      .value("none", FaceRole::none)
      .value("source", FaceRole::source)
      .value("target", FaceRole::target)
      .value("linking", FaceRole::linking)
      .value("divided", FaceRole::divided);
  py::enum_<ReasonKind>(module, "ReasonKind")
      .value("topological", ReasonKind::topological)
      .value("geometric", ReasonKind::geometric)
      .value("prescribed", ReasonKind::prescribed)
      .value("unsupported", ReasonKind::unsupported);
  py::class_<Reason>(module, "Reason")
      .def_readonly("kind", &Reason::kind)
      .def_readonly("text", &Reason::text)
      .def_readonly("entities", &Reason::entities);
  py::class_<Scheme>(module, "Scheme")
      .def_readonly("face_role", &Scheme::face_role)
      .def_readonly("cost", &Scheme::cost);
  py::class_<Assessment>(module, "Assessment")
      .def_readonly("schemes", &Assessment::schemes)
      .def_readonly("reasons", &Assessment::reasons)
      .def("is_sweepable", &Assessment::is_sweepable);
  py::enum_<VertexType>(module, "VertexType")
      .value("end", VertexType::end)
      .value("side", VertexType::side)
      .value("corner", VertexType::corner)
      .value("reversal", VertexType::reversal);
  py::class_<Picks>(module, "Picks", "What the user chose; faces and vertices count from 0.")
      .def(py::init(&make_picks), py::arg("sources"), py::arg("targets"), py::arg("pairs"),
           py::arg("types"));
  bind_face_types(module);
}

}  // namespace sweepmesh
