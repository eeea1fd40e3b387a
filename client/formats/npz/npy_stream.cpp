#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "client/formats/common/reader.h"
#include "client/formats/npz/npy_column.h"

namespace saccade::client {
namespace {

constexpr std::size_t kMaxHeaderBytes = 10000;  // as of NumPy

std::string zipFault(zip_error_t* error) {
  return zip_error_strerror(error);
}

}  // namespace

ZipArchive openZip(const std::string& path) {
  if (access(path.c_str(), R_OK) != 0) throw std::system_error(errno, std::generic_category(), path);
  int code = 0;
  ZipArchive archive(zip_open(path.c_str(), ZIP_RDONLY, &code), zip_discard);
  if (archive) return archive;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string reason = zipFault(&error);
  zip_error_fini(&error);
  throw FileFault(path, "is not a whole zip archive, as .npz is one: " + reason);
}

NpyStream::NpyStream(const std::string& path, const ZipArchive& archive, const std::string& name)
    : path_(path),
      name_(name + ".npy"),
      file_(zip_fopen(archive.get(), name_.c_str(), 0), zip_fclose),
      header_(readHeader(archive)) {}

NpyHeader NpyStream::readHeader(const ZipArchive& archive) {
  if (!file_) fail(zip_strerror(archive.get()));
  char start[8];
  read(start, sizeof start);
  if (std::memcmp(start, "\x93NUMPY", 6) != 0 || start[6] < 1 || start[6] > 3)
    fail("is not an array in version 1 to 3 of NumPy's format");
  std::uint32_t size = 0;
  read(reinterpret_cast<char*>(&size), start[6] == 1 ? 2 : 4);
  if (size > kMaxHeaderBytes) fail("has a header of " + std::to_string(size) + " bytes");
  std::string text(size, '\0');
  read(text.data(), text.size());
  const auto header = parseNpyHeader(text);
  if (!header) fail("is not of numbers in columns: " + text);
  return *header;
}

void NpyStream::read(char* bytes, std::size_t count) {
  while (count > 0) {
    const zip_int64_t got = zip_fread(file_.get(), bytes, count);
    if (got < 0) fail("cannot be read: " + zipFault(zip_file_get_error(file_.get())));
    if (got == 0) fail("ends too early");
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
}

void NpyStream::skip(std::uint64_t count) {
  char passed[4096];
  while (count > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, sizeof passed));
    read(passed, part);
    count -= part;
  }
}

// Reading beyond the end also makes libzip compare the CRC.
void NpyStream::checkEnd() {
  char further;
  const zip_int64_t got = zip_fread(file_.get(), &further, 1);
  if (got < 0) fail("is damaged: " + zipFault(zip_file_get_error(file_.get())));
  if (got > 0) fail("goes on after its last value");
}

void NpyStream::fail(const std::string& what) const {
  throw FileFault(path_, name_ + ": " + what);
}

}  // namespace saccade::client
