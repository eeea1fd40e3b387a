#include "app/stores/bake_folder.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "feed/bake_file.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

struct File {
  fs::path path;
  std::uintmax_t size;
  fs::file_time_type used;
};

std::vector<File> bakesIn(const fs::path& folder) {
  std::vector<File> files;
  std::error_code fault;
  for (const std::string& name : bakeFiles(folder)) {
    const File file{name, fs::file_size(name, fault), fs::last_write_time(name, fault)};
    if (!fault) files.push_back(file);
  }
  return files;
}

}  // namespace

void makeRoomForBake(const std::string& path, std::uint64_t most, std::uint64_t needed) {
  std::error_code fault;
  std::vector<File> files = bakesIn(fs::path(path).parent_path());
  if (fs::exists(path, fault)) {
    fs::last_write_time(path, fs::file_time_type::clock::now(), fault);
    return;
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.used > b.used; });
  std::uintmax_t left = most > needed ? most - needed : 0;
  for (const File& file : files) {
    if (file.size <= left)
      left -= file.size;
    else
      left = 0, fs::remove(file.path, fault);
  }
}

}  // namespace saccade
