#include "app/config/nearest_name.h"

#include <algorithm>

#include "base/check.h"
#include "saccade/wire/edit_distance.h"

namespace saccade {

std::string nearestName(const std::string& name, const std::vector<std::string>& valid) {
  SACCADE_CHECK(!valid.empty());
  return *std::min_element(valid.begin(), valid.end(), [&](const std::string& a, const std::string& b) {
    return editDistance(name, a) < editDistance(name, b);
  });
}

}  // namespace saccade
