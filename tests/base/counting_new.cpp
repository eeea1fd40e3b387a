#include "base/counting_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<int> count{0};
thread_local bool failing = false;

// Null where there is no memory, or there is to be none.
void* tryAllocate(std::size_t size) {
  if (failing) return nullptr;
  ++count;
  return std::malloc(size);
}

void* orThrow(void* p) {
  if (!p) throw std::bad_alloc();
  return p;
}

}  // namespace

void saccade::test::failAllAllocations() {
  failing = true;
}

int saccade::test::allocations() {
  return count;
}

void* operator new(std::size_t size) {
  return orThrow(tryAllocate(size));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return tryAllocate(size);
}
void* operator new(std::size_t size, std::align_val_t align) {
  const auto a = static_cast<std::size_t>(align);
  if (failing) throw std::bad_alloc();
  ++count;
  return orThrow(std::aligned_alloc(a, (size + a - 1) / a * a));
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}
