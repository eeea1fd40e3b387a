// A tar file that gets its name once it is complete.
#pragma once

#include <filesystem>
#include <string>

#include "farm/pack/tar_writer.h"

namespace saccade::farm {

class NewTar {
 public:
  // Writes beside `path`, whose folder exists, under a name of its own. Throws std::system_error, as
  // publish() does.
  explicit NewTar(const std::filesystem::path& path);
  ~NewTar();  // removes it, unless it has its name
  NewTar(const NewTar&) = delete;
  NewTar& operator=(const NewTar&) = delete;

  TarWriter& writer() { return writer_; }
  void publish();  // the last call; replaces a file of this name

 private:
  const std::filesystem::path path_, partial_;
  TarWriter writer_;
};

// Removes what killed programs have left in the folder.
void removePartialTars(const std::filesystem::path& folder);

}  // namespace saccade::farm
