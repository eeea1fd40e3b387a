// How a scene file is read.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace saccade {

// Called after each mesh or picture with the number of files read so far, and of all. It may be called from
// any thread, but never twice at once.
using LoadProgress = std::function<void(int done, int total)>;

struct LoadOptions {
  // Where meshes and pictures are looked up that do not stand beside the scene; in this order.
  std::vector<std::filesystem::path> search_folders = {};
  // Folders or single files that hold all the scene may read, with links followed. Empty: any file may be
  // read. A server sets them, because its scenes may be other people's.
  std::vector<std::filesystem::path> confined_to = {};
  // The animation of a glTF file that plays alone. Empty: that of motion.toml, else all that do not move the
  // same.
  std::string animation = {};
  int threads = 0;  // that read files; 0: one for each core, at most kMaxLoadThreads
  LoadProgress progress = {};
  // Takes the fault of an object, which is then left out of the scene, and may be called with one fault
  // again. Empty: the first fault ends the load. For reports on a file alone: such a scene lacks a part.
  std::function<void(const std::string& fault)> fault = {};
  std::stop_token stop = {};  // once requested, no more files are read, and Cancelled is thrown
};

inline constexpr int kMaxLoadThreads = 8;

}  // namespace saccade
