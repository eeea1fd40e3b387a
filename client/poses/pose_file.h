// Files of poses that the server does not read. They become the text that it reads.
#pragma once

#include <map>
#include <string>

namespace saccade::client {

// Returns `csv` of v1::Trajectory. `rate_hz`: poses per second. Throws std::invalid_argument with file and
// line.
using PoseReader = std::string (*)(const std::string& path, double rate_hz);

// kitti: twelve numbers a line, the upper rows of T_world_camera.
// colmap: images.txt. The last number in the name of a picture counts its poses, from the least of them on.
const std::map<std::string, PoseReader>& poseReaders();

}  // namespace saccade::client
