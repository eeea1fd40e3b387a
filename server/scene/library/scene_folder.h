// The folder of one scene, which may hold anything: links in circles, FIFOs, bytes that are no text. Nothing
// of it is waited for. All throw SceneError.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace saccade {

struct SceneEntry {
  std::string name;
  std::string description;                // the first line of text in README.md, or why it cannot be read
  std::vector<std::string> trajectories;  // names of its CSV files, then motionNames()
  std::string unavailable;                // empty, or why the scene cannot be opened on this machine
};

// A mesh that scenes use by $name and that is not ours to give.
struct OutsideMesh {
  std::filesystem::path path;
  std::string origin;  // for people: where to get it
};
std::map<std::string, OutsideMesh> outsideMeshes(const std::filesystem::path& scenes);

// Of a folder; sorted.
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);
bool isAbsent(const std::filesystem::path& path);  // a link that leads nowhere is not

// What `scene` is, a folder in that of all scenes. All its texts are UTF-8. Does not throw.
SceneEntry describeScene(const std::filesystem::path& scene, const std::filesystem::path& scenes);
// Returns where the scene and its trajectories can be read on this machine.
void requireAvailable(const std::filesystem::path& scene, const std::filesystem::path& scenes);
// Of the CSV files. Those that are no UTF-8 are left out: no request can hold them.
std::vector<std::string> csvNames(const std::filesystem::path& folder);
// Returns where `file`, with its links followed, lies in the folder of the scenes.
void requireWithin(const std::filesystem::path& file, const std::filesystem::path& scenes);

}  // namespace saccade
