// Counts the allocations of a test program that links saccade_counting_new.
#pragma once

namespace saccade::test {

int allocations();          // calls of operator new so far, on all threads
void failAllAllocations();  // from now on, of the calling thread

}  // namespace saccade::test
