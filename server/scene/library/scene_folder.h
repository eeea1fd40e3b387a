// The folder of one scene. It may hold anything: links in circles, FIFOs, names that are no text. No function
// here waits for a FIFO or follows links out of the folder of all scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/files/load_options.h"

namespace saccade {

inline constexpr std::size_t kMaxEntryBytes = 1000;  // of each text of a SceneEntry

inline constexpr std::size_t kMostListedObjects = 256, kMostListedAnimations = 256;

// Shapes and lamps of one name, which may move.
struct SceneObject {
  std::string name;
  std::string motion;  // OwnMotion::text; empty: it stands unless a client moves it
};

// The parts of a scene that clients can ask for. All texts are UTF-8.
struct SceneEntry {
  std::string name;
  // The first line of text in README.md, or why it cannot be read. Without one: what an outline tells of the
  // scene, such as that its camera is a default one.
  std::string description;
  // The names of its CSV files, then of Scene::paths, then motionNames(). An outline has no paths.
  std::vector<std::string> trajectories;
  bool may_have_paths = false;  // of an outline: its file may have some
  // At most kMostListedObjects, those that move first, then by name. None of an outline.
  std::vector<SceneObject> objects = {};
  // At most kMostListedAnimations, in the order of the scene's file, but for those whose name is too long a
  // text. None of an outline.
  std::vector<std::string> animations = {};
  std::string unavailable;  // why the scene cannot be opened on this machine; empty: it can
};

// Name and trajectories of the scene in the folder `scene`, one of `scenes`. Reads no file. `unavailable`
// says why the trajectories cannot be listed, or that the scene lies elsewhere. Does not throw.
SceneEntry outlineScene(const std::filesystem::path& scene, const std::filesystem::path& scenes);
// The whole entry. Reads the README and checks the scene's file. Does not throw.
SceneEntry describeScene(const std::filesystem::path& scene, const std::filesystem::path& scenes,
                         const LoadOptions& options);

// The entries of a folder, sorted. Throws SceneError.
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);
// Whether nothing has this path. A link that leads nowhere counts as something.
bool isAbsent(const std::filesystem::path& path);
// The names of the CSV files in a folder, sorted. A name that is not UTF-8 is left out, because no request
// can hold it. Throws SceneError.
std::vector<std::string> csvNames(const std::filesystem::path& folder);
// Throws SceneError where `file`, with its links followed, lies outside of the folder of the scenes.
void requireWithin(const std::filesystem::path& file, const std::filesystem::path& scenes);

}  // namespace saccade
