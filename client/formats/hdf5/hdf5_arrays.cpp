#include "client/formats/hdf5/hdf5_arrays.h"

#include <algorithm>
#include <array>

#include "client/formats/hdf5/hdf5_column_reader.h"
#include "client/formats/hdf5/hdf5_source.h"

namespace saccade::client {
namespace {

constexpr hsize_t kMostNames = 1000;  // that are looked at
constexpr int kMostFields = 64;

}  // namespace

Hdf5Arrays::Hdf5Arrays(const std::string& path, const std::string& group)
    : path_(path), file_(H5Gopen2(openHdf5(path).id(), group.c_str(), H5P_DEFAULT), H5Gclose) {}

std::vector<std::string> Hdf5Arrays::names() const {
  if (isA("events", H5I_GROUP)) return datasetsOf("events/");
  for (const char* table : {"events", "CD/events"}) {
    if (isA(table, H5I_DATASET)) return {table};
  }
  return datasetsOf("");
}

// Also where a part of the name before the last is absent.
bool Hdf5Arrays::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1)) {
    if (H5Lexists(file_.id(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return !name.empty() && H5Lexists(file_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

ArrayForm Hdf5Arrays::form(const std::string& name) const {
  const Hdf5Handle dataset(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  ArrayForm form;
  std::array<hsize_t, 2> size{};
  if (H5Sget_simple_extent_ndims(space.id()) == 2 &&
      H5Sget_simple_extent_dims(space.id(), size.data(), nullptr) == 2)
    form.columns = size[1];
  if (H5Tget_class(type.id()) != H5T_COMPOUND) return form;
  for (int i = 0; i < std::min(H5Tget_nmembers(type.id()), kMostFields); ++i) {
    char* field = H5Tget_member_name(type.id(), static_cast<unsigned>(i));
    form.fields.emplace_back(field ? field : "");
    H5free_memory(field);
  }
  return form;
}

std::unique_ptr<NumberColumn> Hdf5Arrays::open(const ColumnPlace& place) const {
  return std::make_unique<Hdf5ColumnReader>(path_, file_, place);
}

bool Hdf5Arrays::isA(const std::string& name, H5I_type_t type) const {
  if (!has(name)) return false;
  const Hdf5Handle object(H5Oopen(file_.id(), name.c_str(), H5P_DEFAULT), H5Oclose);
  return object && H5Iget_type(object.id()) == type;
}

std::vector<std::string> Hdf5Arrays::datasetsOf(const std::string& group) const {
  std::vector<std::string> names;
  const Hdf5Handle handle(H5Gopen2(file_.id(), ("./" + group).c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info{};
  if (H5Gget_info(handle.id(), &info) < 0) return names;
  for (hsize_t i = 0; i < std::min(info.nlinks, kMostNames); ++i) {
    char name[128] = "";
    H5Lget_name_by_idx(handle.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name, H5P_DEFAULT);
    if (isA(group + name, H5I_DATASET)) names.push_back(group + name);
  }
  return names;
}

}  // namespace saccade::client
