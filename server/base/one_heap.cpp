#include "base/one_heap.h"

#include <malloc.h>

namespace saccade {

// glibc keeps up to eight heaps per CPU, and one cannot use the memory that another has freed. Memory then
// grows for hours while the same streams come and go. One heap is fast enough: nothing that runs per frame
// allocates. By itself glibc no longer maps large blocks after the first one is freed, and the holes of later
// ones stay in the heap.
void useOneHeap() {
  constexpr int kMappedBlock = 1 << 20;  // bytes
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, kMappedBlock);
}

}  // namespace saccade
