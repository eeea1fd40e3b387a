#include "scene/confinement.h"

#include <algorithm>

namespace saccade {

bool mayRead(const std::filesystem::path& file, const std::vector<std::filesystem::path>& places) {
  if (places.empty()) return true;
  const auto real = std::filesystem::weakly_canonical(file);
  return std::any_of(places.begin(), places.end(), [&](const std::filesystem::path& place) {
    const auto root = std::filesystem::weakly_canonical(place);
    return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
  });
}

}  // namespace saccade
