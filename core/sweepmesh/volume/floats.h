// Arrays of numbers that are not touched before they are written.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace sweepmesh {

/// Memory in large pages where it is large and the system has them: a small page costs nearly as
/// much to get as to fill. Throws std::bad_alloc.
void* allocate_untouched(std::size_t n_bytes);
void free_untouched(void* memory);

/// Leaves what a vector adds without a value as it is: the thread that writes an element first also
/// fetches its memory.
template <class T>
struct Untouched {
  using value_type = T;

  Untouched() = default;
  template <class U>
  explicit Untouched(const Untouched<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(allocate_untouched(n * sizeof(T))); }
  void deallocate(T* p, std::size_t) { free_untouched(p); }
  template <class U>
  void construct(U* p) {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class... Args>
  void construct(U* p, Args&&... args) {
    ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
  }
  template <class U>
  bool operator==(const Untouched<U>&) const {
    return true;
  }
};

/// A size without a value leaves the values undefined.
using Floats = std::vector<float, Untouched<float>>;
using Ints = std::vector<int, Untouched<int>>;

}  // namespace sweepmesh
