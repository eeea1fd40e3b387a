#include "scene/library/scene_folder.h"

#include <algorithm>
#include <set>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/camera/motion.h"
#include "scene/files/confinement.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"
#include "scene/library/scene_format.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxReadmeBytes = 64 << 10;

// The first line that is not blank, a title or a picture.
std::string describe(const fs::path& readme, const fs::path& scenes) {
  if (isAbsent(readme)) return {};
  requireWithin(readme, scenes);
  const std::string bytes = readBeginning(readme.string(), kMaxReadmeBytes);
  for (std::string_view text = bytes; !text.empty();) {
    const auto line = takeLine(text);
    if (!line.empty() && line[0] != '#' && !line.starts_with("![")) return std::string(line);
  }
  return {};
}

// Objects that move come first.
std::vector<SceneObject> objectsOf(const Scene& scene) {
  std::set<std::string> others = objectNames(scene);
  std::vector<SceneObject> objects;
  for (const OwnMotion& motion : scene.motions) {
    objects.push_back({cutText(motion.name, kMaxEcho), cutText(motion.text, kMaxEcho)});
    others.erase(motion.name);
  }
  for (const std::string& name : others) {
    if (objects.size() >= kMostListedObjects) break;
    objects.push_back({cutText(name, kMaxEcho), {}});
  }
  return objects;
}

std::vector<std::string> animationsOf(const fs::path& file, const LoadOptions& options) {
  const SceneFormat& format = formatOf(file);
  if (!format.animations) return {};
  std::vector<std::string> names = format.animations(file.string(), options);
  std::erase_if(names, [](const std::string& name) { return name.size() > kMaxEntryBytes; });
  if (names.size() > kMostListedAnimations) names.resize(kMostListedAnimations);
  return names;
}

// Before the motions that any scene offers.
void addPaths(const Scene& scene, SceneEntry& entry) {
  auto at = entry.trajectories.end() - static_cast<std::ptrdiff_t>(motionNames().size());
  for (const ScenePath& path : scene.paths)
    at = entry.trajectories.insert(at, cutText(path.name, kMaxEntryBytes)) + 1;
}

}  // namespace

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::error_code fault;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault))
    paths.push_back(entry->path());
  if (fault) throw SceneError(folder.string() + ": is not a folder that can be read: " + fault.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool isAbsent(const fs::path& path) {
  std::error_code other;
  return fs::symlink_status(path, other).type() == fs::file_type::not_found;
}

SceneEntry outlineScene(const fs::path& scene, const fs::path& scenes) {
  SceneEntry entry;
  entry.name = cutText(scene.filename().string(), kMaxEntryBytes);
  try {
    if (!isUtf8(scene.filename().string()))
      throw SceneError("the name of the folder is not UTF-8, so that no request can hold it");
    requireWithin(sceneFileIn(scene), scenes);
    entry.trajectories = csvNames(scene / "trajectories");
    entry.may_have_paths = formatOf(sceneFileIn(scene)).has_paths;
  } catch (const SceneError& fault) {
    entry.unavailable = cutText(fault.what(), kMaxEntryBytes);
  }
  entry.trajectories.insert(entry.trajectories.end(), motionNames().begin(), motionNames().end());
  return entry;
}

SceneEntry describeScene(const fs::path& scene, const fs::path& scenes, const LoadOptions& options) {
  SceneEntry entry = outlineScene(scene, scenes);
  try {
    entry.description = cutText(describe(scene / "README.md", scenes), kMaxEntryBytes);
  } catch (const SceneError& fault) {
    entry.description = "no description: " + cutText(fault.what(), kMaxEntryBytes);
  }
  if (!entry.unavailable.empty()) return entry;
  try {
    const Scene outline = outlineSceneFile(sceneFileIn(scene), options);
    entry.objects = objectsOf(outline);
    entry.animations = animationsOf(sceneFileIn(scene), options);
    if (entry.description.empty() && !outline.unread.empty())
      entry.description = cutText(joinNames(outline.unread), kMaxEntryBytes);
    addPaths(outline, entry);
  } catch (const SceneError& fault) {
    entry.unavailable = cutText(fault.what(), kMaxEntryBytes);
  }
  return entry;
}

std::vector<std::string> csvNames(const fs::path& folder) {
  std::vector<std::string> names;
  if (isAbsent(folder)) return names;
  for (const fs::path& path : entriesOf(folder))
    if (path.extension() == ".csv" && isUtf8(path.stem().string())) names.push_back(path.stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void requireWithin(const fs::path& file, const fs::path& scenes) {
  if (!mayRead(file, {scenes})) throw SceneError(file.string() + " leads out of the folder of the scenes");
}

}  // namespace saccade
