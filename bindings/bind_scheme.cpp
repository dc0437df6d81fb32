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
                 const std::vector<std::pair<int, int>>& pairs) {
  Picks picks{face_ids(sources), face_ids(targets), {}};
  for (const auto& [source, target] : pairs) picks.pairs.emplace_back(source, target);
  return picks;
}

}  // namespace

void bind_scheme(py::module_& module) {
  py::enum_<FaceRole>(module, "FaceRole")
      .value("none", FaceRole::none)
      .value("source", FaceRole::source)
      .value("target", FaceRole::target)
      .value("linking", FaceRole::linking);
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
  py::class_<Picks>(module, "Picks", "What the user chose; faces count from 0.")
      .def(py::init(&make_picks), py::arg("sources"), py::arg("targets"), py::arg("pairs"));
}

}  // namespace sweepmesh
