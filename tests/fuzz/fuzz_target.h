// A reader of what other people wrote or sent: whatever the bytes, it takes or refuses them, and says why.
//
// Each target is two programs. <name>_fuzz_test reads its seeds, its corpus and mutations of them, always the
// same ones. Where the compiler is Clang, <name>_fuzz looks for new ones with libFuzzer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"

namespace saccade {

class Draws;

struct FuzzTarget {
  std::vector<std::string> seeds;   // well formed
  std::vector<std::string> tokens;  // words worth trying anywhere
  bool (*read)(
      std::string_view bytes);  // false: refused. Ends the program where more is wrong than the bytes
  // One change that keeps the bytes a message, see mutateMessage(); null where they are a text.
  std::string (*mutate)(const std::string& bytes, Draws& draw) = nullptr;
  int mutants = 50000;  // of a test
};

// Each target defines it.
const FuzzTarget& fuzzTarget();

// Whether `read` did not refuse, which it does by throwing `Fault`, with a reason.
template <class Fault, class Read>
bool accepts(const Read& read) {
  try {
    read();
    return true;
  } catch (const Fault& fault) {
    SACCADE_CHECK(*fault.what());
    return false;
  }
}

}  // namespace saccade
