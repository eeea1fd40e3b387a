#include "client/formats/ros/ros_camera.h"

#include <algorithm>

#include "client/formats/common/truth_layout.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

RosMessage cameraInfo(const std::string& arrays) {
  return {"sensor_msgs",
          "CameraInfo",
          "c9a58c1b0b154e0e6da7578cb991d214",
          "uint32 height\nuint32 width\nstring distortion_model\n" + arrays +
              "uint32 binning_x\nuint32 binning_y\nsensor_msgs/RegionOfInterest roi\n",
          std::string(80, '=') +
              "\nMSG: sensor_msgs/RegionOfInterest\n"
              "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n",
          ""};
}

}  // namespace

std::vector<RosCamera> rosCameras(const v1::Recording& about) {
  if (!about.has_request() || about.request().pushed()) return {};
  std::vector<RosCamera> cameras;
  const auto add = [&](std::uint32_t view, int channel) {
    const bool known = std::any_of(cameras.begin(), cameras.end(),
                                   [&](const RosCamera& camera) { return camera.view == view; });
    if (!known) cameras.push_back({view, channel, PinholeCamera(viewOf(about.request(), view))});
  };
  for (const bool frames : {true, false}) {
    for (int i = 0; i < about.truth_size(); ++i) {
      const bool frame = about.truth(i).info().name().starts_with("frame");
      if (isPicture(about.truth(i)) && frame == frames) add(viewOfTruth(about, i), i);
    }
  }
  add(viewOfEvents(about), kOfEvents);
  return cameras;
}

RosMessage rosCameraInfo1() {
  return cameraInfo("float64[] D\nfloat64[9] K\nfloat64[9] R\nfloat64[12] P\n");
}

RosMessage rosCameraInfo2() {
  return cameraInfo("float64[] d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\n");
}

}  // namespace saccade::client
