// A column of an .npz file: deflated block by block into a spool file, then moved to its place in the
// archive.
#pragma once

#include <zlib.h>

#include <string>
#include <string_view>

#include "client/formats/common/spool_file.h"
#include "client/formats/npz/zip_archive.h"

namespace saccade::client {

// The header of an array in version 1.0 of NumPy's format, of 128 bytes. `type` as "<u2"; `shape` as "(3,)".
std::string npyHeader(const std::string& type, const std::string& shape);

class NpzColumn {
 public:
  // `strategy`: of zlib's deflateInit2(). `path`: of the archive; the spool file is beside it.
  // `shape`: of a value that is an array, "24, 32, 1"; empty: of a number.
  NpzColumn(const std::string& path, const std::string& name, const char* type, std::size_t value_bytes,
            int strategy, const std::string& shape = "");
  ~NpzColumn();
  NpzColumn(const NpzColumn&) = delete;
  NpzColumn& operator=(const NpzColumn&) = delete;

  // Spools a block of values. keep() makes it a part of the column, else the next block replaces it. Throws
  // std::system_error.
  void spool(std::string_view values);
  void keep();

  ZipMember member() const;                                   // of all kept blocks; without its place
  void moveTo(OutputFile& archive, const ZipMember& member);  // the last call; throws std::system_error

 private:
  std::string header() const;

  const std::string name_, type_, shape_;
  const std::size_t value_bytes_;
  SpoolFile file_;
  z_stream deflate_{};
  struct {
    std::uint64_t size = 0, packed = 0;
    std::uint32_t crc = 0;
  } kept_, spooled_;
  std::string packed_;
};

}  // namespace saccade::client
