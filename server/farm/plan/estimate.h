// The cost of a data set, before it is made.
#pragma once

#include <cstdint>
#include <string>

#include "farm/recipe/recipe.h"
#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

struct Estimate {
  double cpu_s = 0;          // of all sequences
  double bytes = 0;          // of all files
  double memory_bytes = 0;   // the most that a worker of one thread takes
  std::uint64_t events = 0;  // of all sequences
  std::size_t rendered = 0;  // sequences that it was measured with
};

// Renders the first frames of some sequences, one of each scene first, in a process of its own. The present
// folder must be that of the recipe. Throws std::runtime_error.
Estimate estimate(const Recipe& recipe, const RenderSettings& settings);

}  // namespace saccade::farm
