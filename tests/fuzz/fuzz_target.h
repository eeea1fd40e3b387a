// A reader of files that other people wrote: whatever the bytes, it gives a value or throws SceneError.
//
// Each target is two programs: <name>_fuzz_test, which reads mutations of its seeds, always the same ones,
// and where the compiler is Clang <name>_fuzz, which looks for new ones with libFuzzer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace saccade {

struct FuzzTarget {
  std::vector<std::string> seeds;        // well formed
  std::vector<std::string> tokens;       // words worth trying anywhere
  void (*read)(std::string_view bytes);  // throws SceneError
};

// Each target defines it.
const FuzzTarget& fuzzTarget();

}  // namespace saccade
