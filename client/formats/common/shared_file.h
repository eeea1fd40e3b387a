// A file that several writers fill, one for each sensor.
#pragma once

#include <cstddef>
#include <utility>

namespace saccade::client {

// `File` is BagFile, McapFile or Hdf5File.
template <class File>
class SharedFile {
 public:
  template <class... Arguments>
  explicit SharedFile(std::size_t writers, Arguments&&... arguments)
      : writers_(writers), file_(std::forward<Arguments>(arguments)...) {}

  File& file() { return file_; }
  // Each writer's last call. The last of them completes the file; throws as File::finish().
  void finish() {
    if (--writers_ == 0) file_.finish();
  }

 private:
  std::size_t writers_;  // that have not finished
  File file_;
};

}  // namespace saccade::client
