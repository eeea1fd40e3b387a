#include "client/formats/hdf5/hdf5_file.h"

#include <algorithm>
#include <utility>

namespace saccade::client {

const H5FD_class_t& Hdf5File::driverClass() {
  static const H5FD_class_t driver_class = [] {
    H5FD_class_t c{};
#ifdef H5FD_CLASS_VERSION  // HDF5 1.14
    c.version = H5FD_CLASS_VERSION;
    c.value = 256;  // the first of those for drivers that nobody else uses
#endif
    c.name = "saccade";
    c.maxaddr = INT64_MAX;
    c.fc_degree = H5F_CLOSE_STRONG;
    c.fapl_size = sizeof(Driver*);
    c.open = [](const char*, unsigned, hid_t access, haddr_t) -> H5FD_t* {
      return *static_cast<Driver* const*>(H5Pget_driver_info(access));
    };
    c.close = [](H5FD_t*) -> herr_t { return 0; };
    c.get_eoa = [](const H5FD_t* file, H5FD_mem_t) { return static_cast<const Driver*>(file)->end; };
    c.get_eof = c.get_eoa;
    c.set_eoa = [](H5FD_t* file, H5FD_mem_t, haddr_t end) -> herr_t {
      static_cast<Driver*>(file)->end = end;
      return 0;
    };
    c.read = [](H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, void*) -> herr_t { return -1; };
    c.write = [](H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* bytes) -> herr_t {
      static_cast<Driver*>(file)->held.emplace_back(at, std::string(static_cast<const char*>(bytes), size));
      return 0;
    };
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), c.fl_map);
    return c;
  }();
  return driver_class;
}

// The properties that make the library use `driver`, and keep the whole index of the file in memory.
Hdf5Handle Hdf5File::accessTo(Driver* driver) {
  static const hid_t driver_id = H5FDregister(&driverClass());
  checkHdf5(driver_id >= 0, "the driver of Hdf5File");
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_driver(access.id(), driver_id, &driver);
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  H5Pget_mdc_config(access.id(), &cache);
  cache.evictions_enabled = false;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  H5Pset_mdc_config(access.id(), &cache);
  return access;
}

Hdf5File::Hdf5File(const std::string& path) : path_(path), file_(path) {
  handle_ = {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, accessTo(&driver_).id()), H5Fclose};
  checkHdf5(bool(handle_), path_);
}

void Hdf5File::commit() {
  checkHdf5(H5Fflush(id(), H5F_SCOPE_LOCAL) >= 0, path_);
  takeToDisk();
}

void Hdf5File::finish() {
  checkHdf5(handle_.close(), path_);
  takeToDisk();
  file_.close();
  finished_ = whole();
}

void Hdf5File::takeToDisk() {
  const auto held = std::exchange(driver_.held, {});
  if (std::exchange(failed_, true)) return;
  const std::uint64_t size = file_.size();
  std::string tail(driver_.end - std::min(driver_.end, size), '\0');
  for (const auto& [at, bytes] : held) {
    if (at < size) continue;
    tail.resize(std::max(tail.size(), at - size + bytes.size()));
    tail.replace(at - size, bytes.size(), bytes);
  }
  file_.append(tail);
  for (const auto& [at, bytes] : held) {
    if (at < size) file_.overwrite(at, bytes);
  }
  failed_ = false;
}

}  // namespace saccade::client
