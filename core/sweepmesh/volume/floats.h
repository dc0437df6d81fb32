// Arrays of numbers that are not touched before they are written.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace sweepmesh {

/// Leaves what a vector adds without a value as it is: the thread that writes an element first also
/// fetches its memory.
template <class T>
struct Untouched : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = Untouched<U>;
  };
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
};

/// A size without a value leaves the values undefined.
using Floats = std::vector<float, Untouched<float>>;
using Doubles = std::vector<double, Untouched<double>>;

}  // namespace sweepmesh
