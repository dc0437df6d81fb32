// Names in a sentence.
#pragma once

#include <string>
#include <vector>

namespace sweepmesh {

/// "Face1, Face4 and Face7".
inline std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

}  // namespace sweepmesh
