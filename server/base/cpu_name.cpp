#include "base/cpu_name.h"

#include <fstream>

namespace saccade {

std::string cpuName() {
  std::ifstream cores("/proc/cpuinfo");
  std::string line;
  while (std::getline(cores, line)) {
    const auto name = line.find(": ");
    if (line.starts_with("model name") && name != std::string::npos) return line.substr(name + 2);
  }
  return "unknown";
}

}  // namespace saccade
