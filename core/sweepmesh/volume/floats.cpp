#include "sweepmesh/volume/floats.h"

#include <cstdlib>
#include <new>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace sweepmesh {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;
/// From here on, what is left unused of the last page does not matter.
constexpr std::size_t large = 2 * large_page;

}  // namespace

void* allocate_untouched(std::size_t n_bytes) {
#if defined(__linux__)
  if (n_bytes >= large) {
    const std::size_t n = (n_bytes + large_page - 1) / large_page * large_page;
    void* memory = std::aligned_alloc(large_page, n);
    if (!memory) throw std::bad_alloc();
    madvise(memory, n, MADV_HUGEPAGE);  // a wish: without it pages are small
    return memory;
  }
#endif
  void* memory = std::malloc(n_bytes);
  if (!memory && n_bytes > 0) throw std::bad_alloc();
  return memory;
}

void free_untouched(void* memory) {
  std::free(memory);
}

}  // namespace sweepmesh
