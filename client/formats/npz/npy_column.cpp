#include "client/formats/npz/npy_column.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "client/formats/common/reader.h"

namespace saccade::client {
namespace {

constexpr std::size_t kMaxHeaderBytes = 10000;  // as of NumPy

// Numbers of 64 bits that are too large become the largest one, which is none of an event either.
template <class T>
void widen(const std::string& bytes, std::vector<std::int64_t>& values) {
  values.resize(bytes.size() / sizeof(T));
  const char* at = bytes.data();
  for (std::int64_t& value : values) {
    T narrow;
    std::memcpy(&narrow, at, sizeof narrow);
    value = std::in_range<std::int64_t>(narrow) ? static_cast<std::int64_t>(narrow) : INT64_MAX;
    at += sizeof narrow;
  }
}

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

NpyColumn::NpyColumn(const std::string& path, const ZipArchive& archive, const std::string& name)
    : path_(path),
      name_(name + ".npy"),
      file_(zip_fopen(archive.get(), name_.c_str(), 0), zip_fclose),
      header_(readHeader(archive)),
      widen_(widening()) {}

void NpyColumn::read(std::uint64_t count, std::vector<std::int64_t>& values) {
  bytes_.resize(count * header_.value_bytes);
  readBytes(bytes_.data(), bytes_.size());
  widen_(bytes_, values);
  done_ += count;
  if (done_ == size()) checkEnd();
}

NpyHeader NpyColumn::readHeader(const ZipArchive& archive) {
  if (!file_) fail(zip_strerror(archive.get()));
  char start[8];
  readBytes(start, sizeof start);
  if (std::memcmp(start, "\x93NUMPY", 6) != 0 || start[6] < 1 || start[6] > 3)
    fail("is not an array in version 1 to 3 of NumPy's format");
  std::uint32_t size = 0;
  readBytes(reinterpret_cast<char*>(&size), start[6] == 1 ? 2 : 4);
  if (size > kMaxHeaderBytes) fail("has a header of " + std::to_string(size) + " bytes");
  std::string text(size, '\0');
  readBytes(text.data(), text.size());
  const auto header = parseNpyHeader(text);
  if (!header) fail("is not one column of numbers: " + text);
  return *header;
}

NpyColumn::Widen NpyColumn::widening() const {
  const bool bool_or_unsigned = header_.kind == 'b' || header_.kind == 'u';
  if (header_.order != '>' && (bool_or_unsigned || header_.kind == 'i')) {
    switch (header_.value_bytes) {
      case 1:
        return bool_or_unsigned ? widen<std::uint8_t> : widen<std::int8_t>;
      case 2:
        return bool_or_unsigned ? widen<std::uint16_t> : widen<std::int16_t>;
      case 4:
        return bool_or_unsigned ? widen<std::uint32_t> : widen<std::int32_t>;
      case 8:
        return bool_or_unsigned ? widen<std::uint64_t> : widen<std::int64_t>;
    }
  }
  fail(std::string("is of type ") + header_.order + header_.kind + std::to_string(header_.value_bytes) +
       "; little-endian whole numbers and bool can be read");
}

// Reading beyond the end also makes libzip compare the CRC.
void NpyColumn::checkEnd() {
  char further;
  const zip_int64_t got = zip_fread(file_.get(), &further, 1);
  if (got < 0) fail("is damaged: " + zipFault(zip_file_get_error(file_.get())));
  if (got > 0) fail("goes on after its last value");
}

void NpyColumn::readBytes(char* bytes, std::size_t count) {
  while (count > 0) {
    const zip_int64_t got = zip_fread(file_.get(), bytes, count);
    if (got < 0) fail("cannot be read: " + zipFault(zip_file_get_error(file_.get())));
    if (got == 0) fail("ends too early");
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
}

void NpyColumn::fail(const std::string& what) const {
  throw FileFault(path_, name_ + ": " + what);
}

}  // namespace saccade::client
