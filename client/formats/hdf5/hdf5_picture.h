// Reads a picture of a truth channel from an HDF5 file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace saccade::client {

struct PlanePicture {
  int width = 0, height = 0;
  std::vector<float> values = {};  // row by row from the top
};

// The first plane of the picture in the middle of data [n, height, width, planes], such as
// "truth/depth/data". Throws FileFault where there is none, and std::system_error if there is no such file.
PlanePicture readMiddlePicture(const std::string& path, const std::string& data);

}  // namespace saccade::client
