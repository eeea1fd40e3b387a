// Reads an array of an .npz file, part by part.
#pragma once

#include <zip.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/formats/common/array_file.h"
#include "client/formats/npz/npy_header.h"

namespace saccade::client {

using ZipArchive = std::unique_ptr<zip_t, void (*)(zip_t*)>;

// Throws std::system_error if there is no such file, and FileFault if it is no zip archive.
ZipArchive openZip(const std::string& path);

// The bytes of an array in order. Every call throws FileFault with the file's name and the array's.
class NpyStream {
 public:
  // Opens NAME.npy. `path`: of the archive, for errors.
  NpyStream(const std::string& path, const ZipArchive& archive, const std::string& name);

  const NpyHeader& header() const { return header_; }
  void read(char* bytes, std::size_t count);
  void skip(std::uint64_t count);
  void checkEnd();  // after the last byte
  [[noreturn]] void fail(const std::string& what) const;

 private:
  NpyHeader readHeader(const ZipArchive& archive);

  const std::string path_, name_;
  std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file_;
  const NpyHeader header_;
};

// A one-dimensional array of numbers, a column of a table, a field of structures, or a single number.
class NpyColumn : public NumberColumn {
 public:
  NpyColumn(const std::string& path, const ZipArchive& archive, const ColumnPlace& place);

  bool single() const { return !header().length; }
  std::uint64_t size() const override { return header().length.value_or(1); }
  bool real() const override { return field_.kind == 'f'; }
  void read(std::uint64_t count, std::vector<std::int64_t>& values) override;
  void readReal(std::uint64_t count, std::vector<double>& values) override;

 private:
  // Takes `count` numbers that are `stride` bytes apart.
  template <class Value>
  using Widen = void (*)(const char* at, std::size_t stride, std::size_t count, Value* values);

  const NpyHeader& header() const { return stream_.header(); }
  NpyField fieldAt(const ColumnPlace& place) const;
  template <class T>
  void setType();
  void chooseType();
  template <class Value>
  void widen(std::uint64_t count, Widen<Value> convert, std::vector<Value>& values);

  NpyStream stream_;
  const NpyField field_;
  std::size_t stride_;  // bytes from one value to the next
  bool to_end_ = true;  // whether the last value is the end of the array
  Widen<std::int64_t> whole_ = nullptr;
  Widen<double> real_ = nullptr;
  std::uint64_t done_ = 0;  // values
  std::string bytes_;
};

}  // namespace saccade::client
