// How often a stream is rendered: at the rate of the request, or as the picture moves.
#include <algorithm>
#include <cmath>

#include "app/request/refusal.h"
#include "app/request/resolve.h"
#include "app/request/resolve_parts.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// Of a request that leaves them open. At 100 Hz the events of a PACED stream come within 10 ms. A picture
// that moves more slowly than 100 pixels per second has few events. At 1000 Hz a stream has no more frames
// than users of frames took before. A picture of 4000 pixels per second then moves by 4 in an interval.
// Refined, its events are still better than those of frames every half pixel [ours: misses of 1 % for 3 %].
constexpr double kIntervalPx = 1, kLeastRate = 100, kMostRate = 1000;

// Throws Refusal where the request counts frames: then only its client knows their rate.
void checkNeedsNoRate(const v1::OpenStream& request) {
  const auto check = [](bool counts, const std::string& what) {
    if (counts) refuse("timing.frame_rate_hz", "give the frames per second: " + what);
  };
  const v1::Quality& quality = request.quality();
  check(request.pushed(), "`pushed` frames come at this rate");
  check(request.timing().clock() == v1::CLOCK_LOCKSTEP, "CLOCK_LOCKSTEP goes from frame to frame");
  check(request.trajectory().motion().has_px_per_frame(), "trajectory.motion.px_per_frame counts them");
  check(quality.has_budget_ms(), "quality.budget_ms is that of a frame");
  check(quality.has_max_false_rate(), "quality.max_false_rate is that of a frame");
  for (const v1::Truth& truth : request.truth()) {
    const TruthChannelInfo* info = findTruth(truth.name());
    check(info && info->needs_pairs, truth.name() + " goes from frame to frame");
  }
}

// A rate whose frames fill the duration.
double leastRate(const v1::Timing& timing) {
  const double most = timing.max_rate_hz() > 0 ? std::min(kLeastRate, timing.max_rate_hz()) : kLeastRate;
  const double frames = timing.duration_s() * most, whole = std::max(1.0, std::floor(frames + 1e-6));
  if (std::abs(frames - whole) < 1e-6 || timing.duration_s() == 0) return most;
  return std::clamp(whole / timing.duration_s(), ranges::kFrameRate.min, ranges::kFrameRate.max);
}

IntervalBounds resolveIntervals(v1::Timing& timing) {
  if (timing.interval_px() == 0) {
    if (timing.max_rate_hz() != 0) refuse("timing.max_rate_hz", "it needs timing.interval_px");
    return {};
  }
  checkRange("timing.interval_px", timing.interval_px(), ranges::kIntervalPx);
  if (timing.max_rate_hz() == 0) timing.set_max_rate_hz(std::max(kMostRate, timing.frame_rate_hz()));
  checkRange("timing.max_rate_hz", timing.max_rate_hz(), timing.frame_rate_hz(), ranges::kFrameRate.max);
  return {timing.interval_px(), timing.max_rate_hz()};
}

}  // namespace

void limitRates(double most_hz, v1::Timing& timing) {
  const bool open = timing.frame_rate_hz() == 0 || timing.interval_px() != 0;
  if (open && timing.max_rate_hz() == 0 && most_hz < kMostRate) timing.set_max_rate_hz(most_hz);
}

void resolveRates(ResolvedStream& stream) {
  v1::Timing& timing = *stream.request.mutable_timing();
  if (timing.frame_rate_hz() == 0) {
    checkNeedsNoRate(stream.request);
    timing.set_frame_rate_hz(leastRate(timing));
    if (timing.interval_px() == 0) timing.set_interval_px(kIntervalPx);
  }
  checkRange("timing.frame_rate_hz", timing.frame_rate_hz(), ranges::kFrameRate);
  stream.feed.frame_rate_hz = timing.frame_rate_hz();
  stream.feed.intervals = resolveIntervals(timing);
}

}  // namespace saccade
