// An allocator for large tables that are read here and there. Their memory lies in huge pages where the
// system has some. So finding a page rarely costs a walk through the page tables.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace saccade {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

template <class T>
struct HugePages {
  using value_type = T;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(std::size_t count) {
    void* memory = ::operator new(count * sizeof(T), alignOf(count));
    // The system may refuse: the memory is then as any other.
    if (isLarge(count)) madvise(memory, count * sizeof(T) / kHugePage * kHugePage, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignOf(count)); }

  template <class U>
  bool operator==(const HugePages<U>&) const {
    return true;
  }

 private:
  static bool isLarge(std::size_t count) { return count * sizeof(T) >= kHugePage; }
  static std::align_val_t alignOf(std::size_t count) {
    return std::align_val_t{isLarge(count) ? kHugePage : std::max(alignof(T), alignof(std::max_align_t))};
  }
};

template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace saccade
