#include "client/formats/hdf5/hdf5_column_reader.h"

#include "client/formats/common/reader.h"
#include "client/formats/hdf5/hdf5_source.h"

namespace saccade::client {
namespace {

constexpr H5Z_filter_t kBlosc = 32001;
constexpr std::uint64_t kMaxChunkBytes = 256 << 20;
constexpr std::size_t kCacheSlots = 11;

hsize_t chunkOf(const Hdf5Handle& properties) {
  hsize_t chunk = 0;
  H5Pget_chunk(properties.id(), 1, &chunk);
  return chunk;
}

}  // namespace

Hdf5ColumnReader::Hdf5ColumnReader(const std::string& path, const Hdf5Handle& file, const std::string& name)
    : path_(path), name_(name), dataset_(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose) {
  if (!dataset_) fail("is absent, or cannot be opened: " + hdf5Reason());
  const Hdf5Handle type(H5Dget_type(dataset_.id()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset_.id()), H5Sclose);
  if (!isInteger(type) || H5Sget_simple_extent_ndims(space.id()) != 1)
    fail("is not one column of whole numbers");
  size_ = static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space.id()));
  const Hdf5Handle properties(H5Dget_create_plist(dataset_.id()), H5Pclose);
  checkFilters(properties);
  checkIsWhole(properties);
  if (H5Pget_layout(properties.id()) == H5D_CHUNKED) keepChunk(file, properties);
}

void Hdf5ColumnReader::read(std::uint64_t count, std::vector<std::int64_t>& values) {
  values.resize(count);
  const hsize_t begin = next_, size = count;
  const Hdf5Handle from(H5Dget_space(dataset_.id()), H5Sclose);
  const Hdf5Handle to(H5Screate_simple(1, &size, nullptr), H5Sclose);
  H5Sselect_hyperslab(from.id(), H5S_SELECT_SET, &begin, nullptr, &size, nullptr);
  if (H5Dread(dataset_.id(), H5T_NATIVE_INT64, to.id(), from.id(), H5P_DEFAULT, values.data()) < 0)
    fail("cannot be read from event " + std::to_string(begin + 1) + " on: " + hdf5Reason());
  next_ += count;
}

void Hdf5ColumnReader::checkFilters(const Hdf5Handle& properties) const {
  for (int i = 0; i < H5Pget_nfilters(properties.id()); ++i) {
    char name[64] = "";
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(properties.id(), static_cast<unsigned>(i), nullptr, &values,
                                               nullptr, sizeof(name) - 1, name, nullptr);
    if (H5Zfilter_avail(filter) > 0) continue;
    fail("needs filter " + std::to_string(filter) + " (" + name + ") of HDF5" +
         (filter == kBlosc ? "; install hdf5-filter-plugin-blosc-serial" : ""));
  }
}

// Parts that are absent would be read as zeros.
void Hdf5ColumnReader::checkIsWhole(const Hdf5Handle& properties) const {
  const Hdf5Handle type(H5Dget_type(dataset_.id()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset_.id()), H5Sclose);
  if (H5Pget_external_count(properties.id()) > 0) fail("is in another file");
  hsize_t present = 0;  // elements
  switch (H5Pget_layout(properties.id())) {
    case H5D_CHUNKED:
      H5Dget_num_chunks(dataset_.id(), space.id(), &present);
      present *= chunkOf(properties);
      break;
    case H5D_CONTIGUOUS:
    case H5D_COMPACT:
      present = H5Dget_storage_size(dataset_.id()) / H5Tget_size(type.id());
      break;
    default:
      fail("is in other files");
  }
  if (present < size_)
    fail("has " + std::to_string(present) + " of its " + std::to_string(size_) + " values");
}

// Opens the dataset again so that each chunk is decompressed once.
void Hdf5ColumnReader::keepChunk(const Hdf5Handle& file, const Hdf5Handle& properties) {
  const Hdf5Handle type(H5Dget_type(dataset_.id()), H5Tclose);
  const std::uint64_t bytes = chunkOf(properties) * H5Tget_size(type.id());
  if (bytes > kMaxChunkBytes)
    fail("has chunks of " + std::to_string(bytes >> 20) + " MiB; at most " +
         std::to_string(kMaxChunkBytes >> 20) + " can be read");
  const Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
  H5Pset_chunk_cache(access.id(), kCacheSlots, bytes, 1);
  dataset_ = {H5Dopen2(file.id(), name_.c_str(), access.id()), H5Dclose};
  if (!dataset_) fail("cannot be opened: " + hdf5Reason());
}

void Hdf5ColumnReader::fail(const std::string& what) const {
  throw FileFault(path_, name_ + " " + what);
}

}  // namespace saccade::client
