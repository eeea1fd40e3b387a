// Opens HDF5 files, and reads single numbers from them. Every call throws FileFault with the file's name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/formats/common/reader.h"
#include "client/formats/hdf5/hdf5_handle.h"

namespace saccade::client {

// Throws std::system_error if there is no such file.
Hdf5Handle openHdf5(const std::string& path);

// A dataset of one number; nullopt if there is nothing of this name. `path` here and below: for errors.
std::optional<std::int64_t> readScalar(const std::string& path, const Hdf5Handle& file,
                                       const std::string& name);
std::optional<std::int64_t> readRootAttribute(const std::string& path, const Hdf5Handle& file,
                                              const std::string& name);

// The attribute `geometry` of the root, "1280x720", as Metavision writes it; nullopt: there is none like
// this.
std::optional<ImageSize> readGeometry(const Hdf5Handle& file);

// Whether values can be read as whole numbers. The bool of NumPy is an enumeration.
bool isInteger(const Hdf5Handle& type);

}  // namespace saccade::client
