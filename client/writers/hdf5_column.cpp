#include "client/writers/hdf5_column.h"

namespace saccade::client {
namespace {

Hdf5Handle space(hsize_t size, hsize_t max_size) {
  return {H5Screate_simple(1, &size, &max_size), H5Sclose};
}

Hdf5Handle scalar() {
  return {H5Screate(H5S_SCALAR), H5Sclose};
}

hid_t unsignedType(std::size_t bytes) {
  switch (bytes) {
    case 1:
      return H5T_STD_U8LE;
    case 2:
      return H5T_STD_U16LE;
    case 4:
      return H5T_STD_U32LE;
    default:
      return H5T_STD_U64LE;
  }
}

}  // namespace

void writeScalar(hid_t group, const char* name, std::int64_t value) {
  const hid_t type = H5T_STD_I64LE;
  const Hdf5Handle dataset(
      H5Dcreate2(group, name, type, scalar().id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  checkHdf5(dataset && H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) >= 0, name);
}

void writeAttribute(hid_t object, const char* name, std::int64_t value) {
  const hid_t type = H5T_STD_I64LE;
  const Hdf5Handle attribute(H5Acreate2(object, name, type, scalar().id(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  checkHdf5(attribute && H5Awrite(attribute.id(), type, &value) >= 0, name);
}

Hdf5Dataset::Hdf5Dataset(hid_t group, const std::string& name, std::size_t value_bytes, hsize_t chunk,
                         const Hdf5Handle& filters)
    : name_(name), type_(unsignedType(value_bytes)) {
  const Hdf5Handle properties(H5Pcopy(filters.id()), H5Pclose);
  H5Pset_chunk(properties.id(), 1, &chunk);
  dataset_ = {H5Dcreate2(group, name.c_str(), type_, space(0, H5S_UNLIMITED).id(), H5P_DEFAULT,
                         properties.id(), H5P_DEFAULT),
              H5Dclose};
  checkHdf5(bool(dataset_), name_);
}

void Hdf5Dataset::append(const void* values, hsize_t count) {
  const hsize_t begin = size_;
  size_ += count;
  checkHdf5(H5Dset_extent(dataset_.id(), &size_) >= 0, name_);
  const Hdf5Handle target(H5Dget_space(dataset_.id()), H5Sclose);
  H5Sselect_hyperslab(target.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr);
  checkHdf5(H5Dwrite(dataset_.id(), type_, space(count, count).id(), target.id(), H5P_DEFAULT, values) >= 0,
            name_);
}

}  // namespace saccade::client
