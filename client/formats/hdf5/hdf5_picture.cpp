#include "client/formats/hdf5/hdf5_picture.h"

#include <array>

#include "client/formats/hdf5/hdf5_source.h"

namespace saccade::client {
namespace {

constexpr hsize_t kMostSide = UINT16_MAX + 1;  // pixels

}  // namespace

PlanePicture readMiddlePicture(const std::string& path, const std::string& data) {
  const Hdf5Handle file = openHdf5(path);
  const Hdf5Handle dataset(H5Dopen2(file.id(), data.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset) throw FileFault(path, "there is no " + data);
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 4> size{};
  if (H5Sget_simple_extent_ndims(space.id()) != 4 ||
      H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) != 4 || size[0] == 0 || size[3] == 0 ||
      size[1] > kMostSide || size[2] > kMostSide)
    throw FileFault(path, data + " has no pictures");
  const std::array<hsize_t, 4> first{size[0] / 2, 0, 0, 0}, count{1, size[1], size[2], 1};
  H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr);
  const Hdf5Handle to(H5Screate_simple(4, count.data(), nullptr), H5Sclose);
  PlanePicture picture{static_cast<int>(size[2]), static_cast<int>(size[1])};
  picture.values.resize(size[1] * size[2]);
  if (H5Dread(dataset.id(), H5T_NATIVE_FLOAT, to.id(), space.id(), H5P_DEFAULT, picture.values.data()) < 0)
    throw FileFault(path, data + " cannot be read: " + hdf5Reason());
  return picture;
}

}  // namespace saccade::client
