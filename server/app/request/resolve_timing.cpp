#include "app/request/enum_names.h"
#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"

namespace saccade {

void resolveTiming(ResolvedStream& stream) {
  v1::Timing& timing = *stream.request.mutable_timing();
  checkRange("timing.frame_rate_hz", timing.frame_rate_hz(), ranges::kFrameRate);
  checkRange("timing.duration_s", timing.duration_s(), ranges::kDuration);
  if (timing.speed() != 0) checkRange("timing.speed", timing.speed(), ranges::kSpeed);
  timing.set_clock(resolveEnum("timing.clock", timing.clock(), v1::CLOCK_FAST));
  if (timing.clock() == v1::CLOCK_LOCKSTEP) timing.set_steerable(true), timing.set_packet_per_frame(true);
  // FAST ignores the speed: cleared, so that equal feeds have equal keys.
  const double speed = timing.speed() == 0 ? 1 : timing.speed();
  timing.set_speed(timing.clock() == v1::CLOCK_PACED ? speed : 0);
  stream.feed.frame_rate_hz = timing.frame_rate_hz();
  if (timing.duration_s() == 0) return;
  // A duration within rounding of a whole number of frames counts as that number.
  stream.frames = static_cast<FrameIndex>(timing.duration_s() * timing.frame_rate_hz() + 1e-6);
  if (stream.frames == 0)
    checkRange("timing.duration_s", timing.duration_s(), 1 / timing.frame_rate_hz(), ranges::kDuration.max);
}

}  // namespace saccade
