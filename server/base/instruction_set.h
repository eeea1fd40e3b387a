// The vector instructions that this process renders with. Results differ in their last bits between them.
#pragma once

#include <array>
#include <string>

namespace saccade {

enum class InstructionSet { kAvx2, kAvx512 };
inline constexpr std::array<const char*, 2> kInstructionSetNames{"avx2", "avx512"};  // by InstructionSet

InstructionSet widestInstructionSet();  // of this processor; it must have kAvx2
InstructionSet instructionSet();        // the widest, unless useInstructionSet() says another
const char* instructionSetName();

// By its name. Call it before anything is rendered. Throws if this processor lacks it.
void useInstructionSet(const std::string& name);

}  // namespace saccade
