// Reads a one-dimensional dataset of whole numbers, part by part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/hdf5/hdf5_handle.h"

namespace saccade::client {

// Every call throws FileFault with the file's name and the dataset's.
class Hdf5ColumnReader {
 public:
  // `path`: of the file, for errors.
  Hdf5ColumnReader(const std::string& path, const Hdf5Handle& file, const std::string& name);

  std::uint64_t size() const { return size_; }
  void read(std::uint64_t count, std::vector<std::int64_t>& values);  // replaces them by the next `count`

 private:
  void checkFilters(const Hdf5Handle& properties) const;
  void checkIsWhole(const Hdf5Handle& properties) const;
  void keepChunk(const Hdf5Handle& file, const Hdf5Handle& properties);
  [[noreturn]] void fail(const std::string& what) const;

  const std::string path_, name_;
  Hdf5Handle dataset_;
  std::uint64_t size_ = 0, next_ = 0;  // elements
};

}  // namespace saccade::client
