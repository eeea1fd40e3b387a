#include "client/formats/common/ros_names.h"

#include <algorithm>

#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

std::string numbered(const std::string& name, std::uint32_t view) {
  return view == 0 ? name : name + "_" + std::to_string(view);
}

}  // namespace

std::string rosSpace(const std::string& space, std::uint32_t view) {
  return numbered(space, view);
}

std::string rosFrame(std::uint32_t view) {
  return numbered("camera", view);
}

std::vector<std::string> rosTopics(const v1::Recording& about, const std::string& space) {
  std::vector<std::string> topics;
  for (int i = 0; i < about.truth_size(); ++i) {
    const std::string own = rosSpace(space, viewOfTruth(about, i)) + "/", image = own + "image_raw";
    const bool frame = about.truth(i).info().name().starts_with("frame");
    const bool taken = std::find(topics.begin(), topics.end(), image) != topics.end();
    topics.push_back(frame && !taken ? image : own + nameInView(about, i));
  }
  return topics;
}

}  // namespace saccade::client
