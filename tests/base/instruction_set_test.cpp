#include "base/instruction_set.h"

#include <gtest/gtest.h>

#include <string>

namespace saccade {
namespace {

TEST(InstructionSet, MayBeNarrowerThanTheProcessors) {
  useInstructionSet("avx2");
  EXPECT_EQ(instructionSet(), InstructionSet::kAvx2);
  EXPECT_EQ(std::string(instructionSetName()), "avx2");
}

}  // namespace
}  // namespace saccade
