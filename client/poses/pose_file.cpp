#include "client/poses/pose_file.h"

#include "client/poses/pose_formats.h"

namespace saccade::client {

const std::map<std::string, PoseReader>& poseReaders() {
  static const std::map<std::string, PoseReader> readers{{"kitti", readKitti}, {"colmap", readColmap}};
  return readers;
}

}  // namespace saccade::client
