// The newest interval of a feed, for whoever wants to look at it.
#pragma once

#include <mutex>
#include <optional>

#include "frame/intensity_change.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

class FramePicture {
 public:
  FramePicture(int width, int height) : newest_(width, height) {}

  void take(const IntensityChange& change);
  // The picture as a sensor with this bias sees it; nothing before the first take().
  std::optional<v1::FramePicture> picture(double bias) const;

 private:
  mutable std::mutex mutex_;
  IntensityChange newest_;
  bool taken_ = false;
};

}  // namespace saccade
