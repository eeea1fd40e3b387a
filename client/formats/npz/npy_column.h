// Reads an array of an .npz file, part by part.
#pragma once

#include <zip.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/formats/npz/npy_header.h"

namespace saccade::client {

using ZipArchive = std::unique_ptr<zip_t, void (*)(zip_t*)>;

// Throws std::system_error if there is no such file, and FileFault if it is no zip archive.
ZipArchive openZip(const std::string& path);

// A one-dimensional array of whole numbers, or a single one. Every call throws FileFault with the file's name
// and the array's.
class NpyColumn {
 public:
  // Opens NAME.npy. `path`: of the archive, for errors.
  NpyColumn(const std::string& path, const ZipArchive& archive, const std::string& name);

  bool single() const { return !header_.length; }
  std::uint64_t size() const { return header_.length.value_or(1); }
  void read(std::uint64_t count, std::vector<std::int64_t>& values);  // replaces them by the next `count`

 private:
  using Widen = void (*)(const std::string& bytes, std::vector<std::int64_t>& values);

  NpyHeader readHeader(const ZipArchive& archive);
  Widen widening() const;
  void checkEnd();
  void readBytes(char* bytes, std::size_t count);
  [[noreturn]] void fail(const std::string& what) const;

  const std::string path_, name_;
  std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file_;
  const NpyHeader header_;
  const Widen widen_;
  std::uint64_t done_ = 0;  // values
  std::string bytes_;
};

}  // namespace saccade::client
