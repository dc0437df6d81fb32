// From an OpenCASCADE shape made by a test to its Model; for .cpp files that make shapes.
#pragma once

#include <BRepTools.hxx>
#include <TopoDS_Shape.hxx>
#include <sstream>

#include "sweepmesh/model/model.h"

namespace sweepmesh::test {

inline Model to_model(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return Model::from_brep(text.str());
}

}  // namespace sweepmesh::test
