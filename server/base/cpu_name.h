// The name of this machine's processor.
#pragma once

#include <string>

namespace saccade {

// "model name" of the first core in /proc/cpuinfo, such as "AMD EPYC 7763 64-Core Processor"; "unknown" where
// there is none.
std::string cpuName();

}  // namespace saccade
