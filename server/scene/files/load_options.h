// How a scene file is opened.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace saccade {

// Called after each mesh or picture with how many are read, of how many; from any thread, one call at a time.
using LoadProgress = std::function<void(int done, int total)>;

struct LoadOptions {
  std::map<std::string, std::string> definitions = {};  // override the file's <default> values ($name)
  // Folders, or single files, that hold all the scene may read, links followed; empty: any file. A server
  // sets them, as its scenes may be other people's; who opens a file by hand may read what he may read.
  std::vector<std::filesystem::path> confined_to = {};
  int threads = 0;  // that read files, at least 1; 0: the machine's, at most kMaxLoadThreads
  LoadProgress progress = {};
};

inline constexpr int kMaxLoadThreads = 8;

}  // namespace saccade
