// Writes columns of numbers, and single ones, into an HDF5 file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/hdf5/hdf5_handle.h"

namespace saccade::client {

// Every call from here on throws std::runtime_error if the library refuses.
void writeScalar(hid_t group, const char* name, std::int64_t value);
void writeAttribute(hid_t object, const char* name, std::int64_t value);

void writeAttribute(hid_t object, const char* name, const std::string& text);
void writeAttribute(hid_t object, const char* name, const std::vector<std::string>& texts);

// The type in files of a number without a sign, of 1, 2, 4 or 8 bytes.
hid_t unsignedType(std::size_t bytes);

// Values of which `chunk` are compressed together. A value is a number of `type`, or an array of them of
// `shape`. `filters`: properties of a dataset that name the filters.
class Hdf5Dataset {
 public:
  Hdf5Dataset(hid_t group, const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
              hsize_t chunk, const Hdf5Handle& filters);
  void append(const void* values, hsize_t count);

 private:
  const std::string name_;  // for errors
  const hid_t type_;
  Hdf5Handle dataset_;
  std::vector<hsize_t> size_;  // of all values: their number, and the shape of one
};

// Numbers without a sign, which are collected up to a chunk.
template <class T>
class Hdf5Column {
 public:
  Hdf5Column(hid_t group, const std::string& name, hsize_t chunk, const Hdf5Handle& filters)
      : chunk_(chunk), dataset_(group, name, unsignedType(sizeof(T)), {}, chunk, filters) {
    values_.reserve(chunk);
  }
  void push(T value) {
    values_.push_back(value);
    if (values_.size() == chunk_) flush();
  }
  void flush() {
    if (!values_.empty()) dataset_.append(values_.data(), values_.size());
    values_.clear();
  }

 private:
  const hsize_t chunk_;
  Hdf5Dataset dataset_;
  std::vector<T> values_;
};

}  // namespace saccade::client
