#include "scene/scene_warnings.h"

#include <set>

#include "scene/default_view.h"

namespace saccade {
namespace {

constexpr std::size_t kMostFiles = 8;  // that are told one by one

}  // namespace

std::vector<std::string> warningsOf(const Scene& scene) {
  std::set<std::string> unread;
  for (const Mesh& mesh : scene.meshes)
    if (!mesh.unread.empty()) unread.insert(mesh.unread);
  std::vector<std::string> warnings(unread.begin(), unread.end());
  if (warnings.size() > kMostFiles) {
    warnings.resize(kMostFiles);
    warnings.push_back("the same holds for " + std::to_string(unread.size() - kMostFiles) +
                       " more mesh files");
  }
  warnings.insert(warnings.end(), scene.unread.begin(), scene.unread.end());
  if (!isLit(scene)) warnings.push_back("the scene has no light, so that all is black");
  return warnings;
}

}  // namespace saccade
