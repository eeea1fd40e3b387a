// Reads a column of numbers of a dataset, part by part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/common/array_file.h"
#include "client/formats/hdf5/hdf5_handle.h"

namespace saccade::client {

// A one-dimensional dataset, a column of a two-dimensional one, or a field of structures.
class Hdf5ColumnReader : public NumberColumn {
 public:
  // `path`: of the file, for errors.
  Hdf5ColumnReader(const std::string& path, const Hdf5Handle& file, const ColumnPlace& place);

  std::uint64_t size() const override { return size_; }
  bool real() const override { return real_; }
  void read(std::uint64_t count, std::vector<std::int64_t>& values) override;
  void readReal(std::uint64_t count, std::vector<double>& values) override;

 private:
  void checkForm();
  void checkFilters(const Hdf5Handle& properties) const;
  void checkIsWhole(const Hdf5Handle& properties) const;
  void keepChunk(const Hdf5Handle& file, const Hdf5Handle& properties);
  void readAs(hid_t type, std::uint64_t count, void* values);
  [[noreturn]] void fail(const std::string& what) const;

  const std::string path_;
  const ColumnPlace place_;
  Hdf5Handle dataset_;
  bool real_ = false;
  std::uint64_t size_ = 0, next_ = 0;  // rows
  std::vector<double> real_values_;
};

}  // namespace saccade::client
