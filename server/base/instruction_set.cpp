#include "base/instruction_set.h"

#include <algorithm>
#include <stdexcept>

#include "base/check.h"

namespace saccade {
namespace {

InstructionSet& inUse() {
  static InstructionSet set = widestInstructionSet();
  return set;
}

}  // namespace

InstructionSet widestInstructionSet() {
  __builtin_cpu_init();
  // One feature at a time: Clang 14 does not know the levels by name.
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  return avx512 ? InstructionSet::kAvx512 : InstructionSet::kAvx2;
}

InstructionSet instructionSet() {
  return inUse();
}

const char* instructionSetName() {
  return kInstructionSetNames[static_cast<std::size_t>(inUse())];
}

void useInstructionSet(const std::string& name) {
  const auto at = std::find(kInstructionSetNames.begin(), kInstructionSetNames.end(), name);
  SACCADE_CHECK(at != kInstructionSetNames.end());
  const auto set = static_cast<InstructionSet>(at - kInstructionSetNames.begin());
  if (set > widestInstructionSet()) throw std::runtime_error("this processor has no " + name);
  inUse() = set;
}

}  // namespace saccade
