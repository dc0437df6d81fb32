// Names of tests that run over a family of solids.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "solids.h"

namespace sweepmesh::test {

/// The solid's name, as far as a test's name may have it.
inline std::string name_of_case(const testing::TestParamInfo<NamedModel>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace sweepmesh::test
