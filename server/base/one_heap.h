// The memory of a process whose threads allocate rarely, and large blocks.
#pragma once

namespace saccade {

// Call it before any other thread runs. All threads share one heap. Blocks of 1 MiB and more are mapped, and
// each goes back to the system as soon as it is freed.
void useOneHeap();

}  // namespace saccade
