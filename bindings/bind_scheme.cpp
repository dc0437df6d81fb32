#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "bind.h"
#include "sweepmesh/scheme/suggested_cut.h"

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

std::optional<SuggestedCut> suggest_cut_of(const Model& model, const std::vector<Reason>& reasons,
                                           Context& context, int max_tries, double seconds) {
  return suggest_cut(model, reasons, {.max_tries = max_tries, .seconds = seconds}, context);
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
  py::class_<SuggestedCut>(module, "SuggestedCut")
      .def_property_readonly("point", [](const SuggestedCut& c) { return c.plane.point; })
      .def_property_readonly("normal", [](const SuggestedCut& c) { return c.plane.normal; })
      .def_property_readonly("face", [](const SuggestedCut& c) { return c.face.index; })
      .def_property_readonly("pieces", [](const SuggestedCut& c) { return c.cut.pieces; })
      .def_property_readonly("shape", [](const SuggestedCut& c) { return c.cut.shape; })
      .def_property_readonly("text", &sentence_of);
  module.def("suggest_cut", &suggest_cut_of, py::arg("model"), py::arg("reasons"),
             py::arg("context"), py::arg("max_tries") = CutOptions{}.max_tries,
             py::arg("seconds") = CutOptions{}.seconds,
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace sweepmesh
