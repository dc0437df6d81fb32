#include <pybind11/stl.h>

#include "bind.h"
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
}

}  // namespace sweepmesh
