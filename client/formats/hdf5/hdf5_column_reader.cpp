#include "client/formats/hdf5/hdf5_column_reader.h"

#include <algorithm>
#include <array>

#include "client/formats/common/reader.h"
#include "client/formats/hdf5/hdf5_source.h"

namespace saccade::client {
namespace {

constexpr struct {
  H5Z_filter_t filter;
  const char* install;
} kPlugins[] = {{32001, "install hdf5-filter-plugin-blosc-serial"},
                {0x8ECF, "install the plugin hdf5_ecf of Prophesee, or write the file anew as .raw or .csv"}};
constexpr std::uint64_t kMaxChunkBytes = 256 << 20;
constexpr std::size_t kCacheSlots = 11;

hsize_t chunkOf(const Hdf5Handle& properties) {  // elements
  std::array<hsize_t, 2> chunk{1, 1};
  H5Pget_chunk(properties.id(), 2, chunk.data());
  hsize_t elements;
  return __builtin_mul_overflow(chunk[0], chunk[1], &elements) ? UINT64_MAX : elements;
}

std::string pluginFor(H5Z_filter_t filter) {
  const auto plugin = std::find_if(std::begin(kPlugins), std::end(kPlugins),
                                   [&](const auto& row) { return row.filter == filter; });
  return plugin == std::end(kPlugins) ? "" : std::string("; ") + plugin->install;
}

}  // namespace

Hdf5ColumnReader::Hdf5ColumnReader(const std::string& path, const Hdf5Handle& file, const ColumnPlace& place)
    : path_(path), place_(place), dataset_(H5Dopen2(file.id(), place.array.c_str(), H5P_DEFAULT), H5Dclose) {
  if (!dataset_) fail("is absent, or cannot be opened: " + hdf5Reason());
  checkForm();
  const Hdf5Handle properties(H5Dget_create_plist(dataset_.id()), H5Pclose);
  checkFilters(properties);
  checkIsWhole(properties);
  if (H5Pget_layout(properties.id()) == H5D_CHUNKED) keepChunk(file, properties);
}

void Hdf5ColumnReader::read(std::uint64_t count, std::vector<std::int64_t>& values) {
  values.resize(count);
  if (!real_) return readAs(H5T_NATIVE_INT64, count, values.data());
  readReal(count, real_values_);
  std::transform(real_values_.begin(), real_values_.end(), values.begin(), wholeOf);
}

void Hdf5ColumnReader::readReal(std::uint64_t count, std::vector<double>& values) {
  values.resize(count);
  readAs(H5T_NATIVE_DOUBLE, count, values.data());
}

void Hdf5ColumnReader::readAs(hid_t type, std::uint64_t count, void* values) {
  const std::array<hsize_t, 2> begin{next_, place_.column.value_or(0)}, size{count, 1};
  const Hdf5Handle from(H5Dget_space(dataset_.id()), H5Sclose);
  const Hdf5Handle to(H5Screate_simple(1, size.data(), nullptr), H5Sclose);
  H5Sselect_hyperslab(from.id(), H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr);
  Hdf5Handle field;
  if (!place_.field.empty()) {
    field = {H5Tcreate(H5T_COMPOUND, H5Tget_size(type)), H5Tclose};
    H5Tinsert(field.id(), place_.field.c_str(), 0, type);
  }
  const hid_t wanted = field ? field.id() : type;
  if (H5Dread(dataset_.id(), wanted, to.id(), from.id(), H5P_DEFAULT, values) < 0)
    fail("cannot be read from event " + std::to_string(next_ + 1) + " on: " + hdf5Reason());
  next_ += count;
}

void Hdf5ColumnReader::checkForm() {
  Hdf5Handle type(H5Dget_type(dataset_.id()), H5Tclose);
  if (!place_.field.empty()) {
    const int member =
        H5Tget_class(type.id()) == H5T_COMPOUND ? H5Tget_member_index(type.id(), place_.field.c_str()) : -1;
    if (member < 0) fail("has no field " + place_.field);
    type = {H5Tget_member_type(type.id(), static_cast<unsigned>(member)), H5Tclose};
  }
  const Hdf5Handle space(H5Dget_space(dataset_.id()), H5Sclose);
  real_ = H5Tget_class(type.id()) == H5T_FLOAT;
  std::array<hsize_t, 2> size{0, 1};
  const int dimensions = place_.column ? 2 : 1;
  if ((!isInteger(type) && !real_) || H5Sget_simple_extent_ndims(space.id()) != dimensions)
    fail("is not one column of numbers");
  H5Sget_simple_extent_dims(space.id(), size.data(), nullptr);
  if (place_.column.value_or(0) >= size[1]) fail("is not one column of numbers");
  size_ = size[0];
}

void Hdf5ColumnReader::checkFilters(const Hdf5Handle& properties) const {
  for (int i = 0; i < H5Pget_nfilters(properties.id()); ++i) {
    char name[64] = "";
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(properties.id(), static_cast<unsigned>(i), nullptr, &values,
                                               nullptr, sizeof(name) - 1, name, nullptr);
    if (H5Zfilter_avail(filter) > 0) continue;
    fail("needs filter " + std::to_string(filter) + " (" + name + ") of HDF5" + pluginFor(filter));
  }
}

// Parts that are absent would be read as zeros.
void Hdf5ColumnReader::checkIsWhole(const Hdf5Handle& properties) const {
  const Hdf5Handle type(H5Dget_type(dataset_.id()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset_.id()), H5Sclose);
  if (H5Pget_external_count(properties.id()) > 0) fail("is in another file");
  const auto wanted = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space.id()));
  hsize_t present = 0;  // elements
  switch (H5Pget_layout(properties.id())) {
    case H5D_CHUNKED:
      H5Dget_num_chunks(dataset_.id(), space.id(), &present);
      if (__builtin_mul_overflow(present, chunkOf(properties), &present)) present = UINT64_MAX;
      break;
    case H5D_CONTIGUOUS:
    case H5D_COMPACT:
      present = H5Dget_storage_size(dataset_.id()) / H5Tget_size(type.id());
      break;
    default:
      fail("is in other files");
  }
  if (present < wanted)
    fail("has " + std::to_string(present) + " of its " + std::to_string(wanted) + " values");
}

// Opens the dataset again so that each chunk is decompressed once.
void Hdf5ColumnReader::keepChunk(const Hdf5Handle& file, const Hdf5Handle& properties) {
  const Hdf5Handle type(H5Dget_type(dataset_.id()), H5Tclose);
  std::uint64_t bytes;
  if (__builtin_mul_overflow(chunkOf(properties), H5Tget_size(type.id()), &bytes)) bytes = UINT64_MAX;
  if (bytes > kMaxChunkBytes)
    fail("has chunks of " + std::to_string(bytes >> 20) + " MiB; at most " +
         std::to_string(kMaxChunkBytes >> 20) + " can be read");
  const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  H5Pset_chunk_cache(access.id(), kCacheSlots, bytes, 1);
  dataset_ = {H5Dopen2(file.id(), place_.array.c_str(), access.id()), H5Dclose};
  if (!dataset_) fail("cannot be opened: " + hdf5Reason());
}

void Hdf5ColumnReader::fail(const std::string& what) const {
  throw FileFault(path_, place_.array + " " + what);
}

}  // namespace saccade::client
