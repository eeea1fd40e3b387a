// SACCADE_CHECK ends the program at a logic fault, in every build. For faults of input, throw or return a
// status.
#pragma once

#include <cstdio>
#include <cstdlib>

#define SACCADE_CHECK(condition)                                                                      \
  do {                                                                                                \
    if (!(condition)) {                                                                               \
      std::fprintf(stderr, "%s:%d: logic fault: %s does not hold\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                                   \
    }                                                                                                 \
  } while (false)
