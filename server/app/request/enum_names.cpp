#include "app/request/enum_names.h"

#include <algorithm>

namespace saccade {

std::string nameWithout(const std::string& prefix, const std::string& value) {
  std::string name = value.substr(prefix.size());
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

}  // namespace saccade
