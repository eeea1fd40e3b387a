// An HDF5 file to write that is whole on disk at every moment, whatever ends the program or fills the disk.
//
// HDF5 changes its index in place, so a file is unreadable if only a part of its changes arrives. Here the
// library writes to memory, and commit() takes it to disk: first what lengthens the file, then what changes
// it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "client/formats/common/output_file.h"
#include "client/formats/hdf5/hdf5_handle.h"

namespace saccade::client {

class Hdf5File {
 public:
  // After startHdf5(). An existing file is emptied.
  explicit Hdf5File(const std::string& path);
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  hid_t id() const { return handle_.id(); }
  // Throws std::system_error with the file's name. The file then stays as it was, and later commits do
  // nothing.
  void commit();
  bool whole() const { return !failed_; }      // whether all that was committed is on disk
  bool finished() const { return finished_; }  // finish() succeeded
  void finish();  // the last call: commits, and closes all that was opened in the file; throws the same

 private:
  // The file as the HDF5 library sees it. It reads nothing, because it forgets nothing.
  struct Driver : H5FD_t {
    haddr_t end = 0;  // of the space that is in use
    std::vector<std::pair<haddr_t, std::string>> held =
        {};  // place and bytes of writes since the last commit
  };
  static const H5FD_class_t& driverClass();
  static Hdf5Handle accessTo(Driver* driver);
  void takeToDisk();

  const std::string path_;  // for errors
  OutputFile file_;
  Driver driver_{};
  bool failed_ = false, finished_ = false;
  Hdf5Handle handle_;  // closed before the members above go
};

}  // namespace saccade::client
