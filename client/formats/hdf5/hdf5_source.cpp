#include "client/formats/hdf5/hdf5_source.h"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

namespace saccade::client {
namespace {

void check(bool done, const std::string& path, const std::string& name) {
  if (!done) throw FileFault(path, name + " is not a single whole number");
}

bool isSingle(const Hdf5Handle& space) {
  return H5Sget_simple_extent_npoints(space.id()) == 1;
}

bool isSide(std::uint32_t pixels) {
  return pixels >= 1 && pixels <= UINT16_MAX + 1;
}

// Of an attribute that is one short string; empty: it is another thing.
std::string textOf(const Hdf5Handle& attribute) {
  constexpr std::size_t kLongest = 64;
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || !isSingle(space)) return "";
  if (H5Tis_variable_str(type.id()) > 0) {
    char* value = nullptr;
    if (H5Aread(attribute.id(), type.id(), &value) < 0 || !value) return "";
    std::string text(value, strnlen(value, kLongest));
    H5free_memory(value);
    return text;
  }
  char value[kLongest + 1] = "";
  if (H5Tget_size(type.id()) > kLongest || H5Aread(attribute.id(), type.id(), value) < 0) return "";
  return value;
}

}  // namespace

Hdf5Handle openHdf5(const std::string& path) {
  if (access(path.c_str(), R_OK) != 0) throw std::system_error(errno, std::generic_category(), path);
  startHdf5();
  const Hdf5Handle how(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(how.id(), false, true);  // some file systems have no locks
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, how.id()), H5Fclose);
  if (!file) throw FileFault(path, "is not a whole file of HDF5: " + hdf5Reason());
  return file;
}

std::optional<std::int64_t> readScalar(const std::string& path, const Hdf5Handle& file,
                                       const std::string& name) {
  if (H5Lexists(file.id(), name.c_str(), H5P_DEFAULT) <= 0) return std::nullopt;
  const Hdf5Handle dataset(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  check(isInteger(type) && isSingle(space), path, name);
  std::int64_t value;
  check(H5Dread(dataset.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) >= 0, path, name);
  return value;
}

std::optional<std::int64_t> readRootAttribute(const std::string& path, const Hdf5Handle& file,
                                              const std::string& name) {
  if (H5Aexists(file.id(), name.c_str()) <= 0) return std::nullopt;
  const Hdf5Handle attribute(H5Aopen(file.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  check(isInteger(type) && isSingle(space), path, "attribute " + name);
  std::int64_t value;
  check(H5Aread(attribute.id(), H5T_NATIVE_INT64, &value) >= 0, path, "attribute " + name);
  return value;
}

std::optional<ImageSize> readGeometry(const Hdf5Handle& file) {
  if (H5Aexists(file.id(), "geometry") <= 0) return std::nullopt;
  const Hdf5Handle attribute(H5Aopen(file.id(), "geometry", H5P_DEFAULT), H5Aclose);
  const std::string text = textOf(attribute);
  ImageSize size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  const bool valid =
      height.ec == std::errc() && height.ptr == end && isSide(size.width) && isSide(size.height);
  return valid ? std::optional(size) : std::nullopt;
}

bool isInteger(const Hdf5Handle& type) {
  const H5T_class_t kind = H5Tget_class(type.id());
  return kind == H5T_INTEGER || kind == H5T_ENUM;
}

}  // namespace saccade::client
