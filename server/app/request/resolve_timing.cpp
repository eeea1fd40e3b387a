#include "app/request/enum_names.h"
#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"

namespace saccade {
namespace {

// Replaces until_path_ends by the duration of the path.
void takeDuration(const std::optional<Trajectory>& path, v1::Timing& timing) {
  const std::string field = "timing.until_path_ends";
  if (timing.duration_s() != 0) refuse(field, "timing.duration_s is given too");
  if (!path)
    refuse(field, "only trajectory.keyframes and trajectory.csv have an end; give timing.duration_s");
  if (path->lastTime() <= TimeNs{0})
    refuse(field, "the path has no pose after time 0; give timing.duration_s");
  timing.set_duration_s(seconds(path->lastTime()));
  timing.clear_until_path_ends();
}

}  // namespace

void resolveTiming(ResolvedStream& stream) {
  v1::Timing& timing = *stream.request.mutable_timing();
  if (timing.until_path_ends()) takeDuration(stream.given_path, timing);
  checkRange("timing.duration_s", timing.duration_s(), ranges::kDuration);
  resolveRates(stream);
  if (timing.speed() != 0) checkRange("timing.speed", timing.speed(), ranges::kSpeed);
  timing.set_clock(resolveEnum("timing.clock", timing.clock(), v1::CLOCK_FAST));
  if (timing.clock() == v1::CLOCK_LOCKSTEP) timing.set_steerable(true), timing.set_packet_per_frame(true);
  // FAST ignores the speed: cleared, so that equal feeds have equal keys.
  const double speed = timing.speed() == 0 ? 1 : timing.speed();
  const bool paced = timing.clock() == v1::CLOCK_PACED;
  if (paced && timing.min_speed() != 0)
    checkRange("timing.min_speed", timing.min_speed(), ranges::kSpeed.min, speed);
  timing.set_speed(paced ? speed : 0);
  if (!paced) timing.clear_min_speed();
  if (timing.duration_s() == 0) return;
  // A duration within rounding of a whole number of frames counts as that number.
  stream.frames = static_cast<FrameIndex>(timing.duration_s() * timing.frame_rate_hz() + 1e-6);
  if (stream.frames == 0)
    checkRange("timing.duration_s", timing.duration_s(), 1 / timing.frame_rate_hz(), ranges::kDuration.max);
}

}  // namespace saccade
