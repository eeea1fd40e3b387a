#include "scene/files/confinement.h"

#include <algorithm>

#include "scene/files/scene_error.h"

namespace saccade {
namespace {

std::filesystem::path followed(const std::filesystem::path& path) {
  std::error_code fault;
  auto real = std::filesystem::weakly_canonical(path, fault);
  if (fault) throw SceneError(path.string() + ": " + fault.message());
  return real;
}

}  // namespace

bool mayRead(const std::filesystem::path& file, const std::vector<std::filesystem::path>& places) {
  if (places.empty()) return true;
  const auto real = followed(file);
  return std::any_of(places.begin(), places.end(), [&](const std::filesystem::path& place) {
    const auto root = followed(place);
    return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
  });
}

}  // namespace saccade
