// A frame interval in which all pixels brighten alike.
#pragma once

#include <cmath>
#include <memory>

#include "feed/feed_interval.h"
#include "render/test_scenes.h"
#include "render/world/posed_scene.h"
#include "saccade/wire/packet_cutter.h"

namespace saccade {

inline constexpr int kWidth = 9, kHeight = 5;

// Interval `frame` (1, 2, ...) of kPacketTimeNs. The logarithm of the intensity grows by `log_change`.
inline std::unique_ptr<IntensityChange> intervalOf(FrameIndex frame, float intensity, float log_change) {
  auto change = std::make_unique<IntensityChange>(kWidth, kHeight);
  const auto index = static_cast<std::int64_t>(frame);
  change->frame = frame;
  change->t0 = TimeNs((index - 1) * kPacketTimeNs);
  change->t1 = TimeNs(index * kPacketTimeNs);
  change->I_prev.fill(intensity);
  change->dI.fill(intensity * std::expm1(log_change));
  change->I_now.fill(intensity * std::exp(log_change));
  return change;
}

// An interval of a camera that stands still before a surface at depth 2.
class StillView {
 public:
  explicit StillView(std::unique_ptr<IntensityChange> change) : change_(std::move(change)) {
    for (Frame* frame : {&cur_, &prev_}) frame->g.z.fill(2);
    cur_.index = change_->frame, prev_.index = change_->frame - 1;
    cur_.time = change_->t1, prev_.time = change_->t0;
  }
  FeedInterval interval() const {
    return {*change_, RenderedInterval{{cur_, prev_}, camera_, camera_, path_, scene(), scene()}};
  }

 private:
  static const PosedScene& scene() {
    static const PosedScene floor(std::make_shared<RenderScene>(test::floorFromAbove(0.5f)));
    return floor;
  }

  std::unique_ptr<IntensityChange> change_;
  Frame cur_{kWidth, kHeight}, prev_{kWidth, kHeight};
  const Trajectory path_{{{TimeNs(0), Pose{{1, 2, 3}, {}}}}};
  const Camera camera_{path_.at(TimeNs(0)), pinhole(45, kWidth, kHeight)};
};

}  // namespace saccade
