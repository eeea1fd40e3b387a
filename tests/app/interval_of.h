// A frame interval in which all pixels brighten alike.
#pragma once

#include <cmath>
#include <memory>

#include "frame/intensity_change.h"
#include "wire/packet_cutter.h"

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

}  // namespace saccade
