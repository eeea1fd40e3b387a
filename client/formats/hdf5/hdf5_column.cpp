#include "client/formats/hdf5/hdf5_column.h"

namespace saccade::client {
namespace {

Hdf5Handle space(const std::vector<hsize_t>& size, const hsize_t* max_size = nullptr) {
  return {H5Screate_simple(static_cast<int>(size.size()), size.data(), max_size), H5Sclose};
}

Hdf5Handle scalar() {
  return {H5Screate(H5S_SCALAR), H5Sclose};
}

void writeTexts(hid_t object, const char* name, const std::vector<const char*>& texts,
                const Hdf5Handle& size) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  const Hdf5Handle attribute(H5Acreate2(object, name, type.id(), size.id(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  checkHdf5(attribute && H5Awrite(attribute.id(), type.id(), texts.data()) >= 0, name);
}

// By default a data set has the time at which it was made, and equal recordings would differ in it.
void leaveOutTimes(const Hdf5Handle& properties) {
  H5Pset_obj_track_times(properties.id(), false);
}

}  // namespace

void writeScalar(hid_t group, const char* name, std::int64_t value) {
  const hid_t type = H5T_STD_I64LE;
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  leaveOutTimes(properties);
  const Hdf5Handle dataset(
      H5Dcreate2(group, name, type, scalar().id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose);
  checkHdf5(dataset && H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) >= 0, name);
}

void writeAttribute(hid_t object, const char* name, std::int64_t value) {
  const hid_t type = H5T_STD_I64LE;
  const Hdf5Handle attribute(H5Acreate2(object, name, type, scalar().id(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  checkHdf5(attribute && H5Awrite(attribute.id(), type, &value) >= 0, name);
}

void writeAttribute(hid_t object, const char* name, const std::string& text) {
  writeTexts(object, name, {text.c_str()}, scalar());
}

void writeAttribute(hid_t object, const char* name, const std::vector<std::string>& texts) {
  std::vector<const char*> values;
  for (const std::string& text : texts) values.push_back(text.c_str());
  writeTexts(object, name, values, space({texts.size()}));
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

Hdf5Dataset::Hdf5Dataset(hid_t group, const std::string& name, hid_t type, const std::vector<hsize_t>& shape,
                         hsize_t chunk, const Hdf5Handle& filters)
    : name_(name), type_(type), size_{0} {
  size_.insert(size_.end(), shape.begin(), shape.end());
  std::vector<hsize_t> most = size_, chunks = size_;
  most[0] = H5S_UNLIMITED, chunks[0] = chunk;
  const Hdf5Handle properties(H5Pcopy(filters.id()), H5Pclose);
  H5Pset_chunk(properties.id(), static_cast<int>(chunks.size()), chunks.data());
  leaveOutTimes(properties);
  dataset_ = {H5Dcreate2(group, name.c_str(), type_, space(size_, most.data()).id(), H5P_DEFAULT,
                         properties.id(), H5P_DEFAULT),
              H5Dclose};
  checkHdf5(bool(dataset_), name_);
}

void Hdf5Dataset::append(const void* values, hsize_t count) {
  std::vector<hsize_t> begin(size_.size()), part = size_;
  begin[0] = size_[0], part[0] = count;
  size_[0] += count;
  checkHdf5(H5Dset_extent(dataset_.id(), size_.data()) >= 0, name_);
  const Hdf5Handle target(H5Dget_space(dataset_.id()), H5Sclose);
  H5Sselect_hyperslab(target.id(), H5S_SELECT_SET, begin.data(), nullptr, part.data(), nullptr);
  checkHdf5(H5Dwrite(dataset_.id(), type_, space(part).id(), target.id(), H5P_DEFAULT, values) >= 0, name_);
}

}  // namespace saccade::client
