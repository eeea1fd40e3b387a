// Random numbers of one mutant, by address: the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/hash_rng.h"

namespace saccade {

class Draws {
 public:
  explicit Draws(std::uint64_t mutant) : mutant_(mutant) {}
  std::uint64_t bits() { return hashKey(mutant_, next_++); }
  std::size_t below(std::size_t count) { return count == 0 ? 0 : bits() % count; }
  bool oneIn(std::size_t count) { return below(count) == 0; }

 private:
  std::uint64_t mutant_, next_ = 0;
};

}  // namespace saccade
