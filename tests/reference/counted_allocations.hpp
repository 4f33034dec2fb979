#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

/// Replaces operator new of the program by one that counts; include it in one file of a program.
/// Sanitizers have an allocator of their own, which this must not take apart: there it counts
/// nothing.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

namespace striate {
inline long counted_allocations() {
  return 0;
}
}  // namespace striate

#else

namespace striate {
inline std::atomic<long> allocation_counter{0};
inline long counted_allocations() {
  return allocation_counter;
}
}  // namespace striate

void* operator new(std::size_t size) {
  ++striate::allocation_counter;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

#endif
