#include "client/formats/ros/ros_source.h"

namespace saccade::client {

void RosSource::fail(const std::string& what) const {
  throw FileFault(file_.path(), "the record at byte " + std::to_string(place_) + " " + what);
}

std::string RosSource::bytesAt(std::uint64_t at, std::uint64_t size) {
  if (size > kMostChunk) fail("has more than 256 MiB");
  std::string bytes;
  file_.read(at, size, bytes);
  return bytes;
}

}  // namespace saccade::client
