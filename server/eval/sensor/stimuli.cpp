#include "eval/sensor/stimuli.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade::eval {
namespace {

constexpr TimeNs kStillInterval{10'000'000};  // where nothing changes
constexpr TimeNs kSlowInterval{1'000'000};    // the longest of a change
constexpr int kStillFrames = 5, kCycleFrames = 32;
constexpr double kGrowth = 1.02;  // of the intervals after a step
constexpr int kSettlingCycles = 2, kMeasuredCycles = 4;

TimeNs toEventTime(double time_s) {
  return std::llround(time_s * 1e9 / kEventTimeUnit.count()) * kEventTimeUnit;
}

void hold(Stimulus& frames, double I, TimeNs end, TimeNs interval) {
  for (TimeNs t = frames.back().t + interval; t <= end; t += interval) frames.push_back({t, I});
}

}  // namespace

Stimulus stillPicture(double I, double duration_s) {
  Stimulus frames{{TimeNs(0), I}};
  hold(frames, I, toEventTime(duration_s), kStillInterval);
  return frames;
}

Stimulus stepOf(double I, double size, TimeNs window, TimeNs shortest) {
  Stimulus frames{{TimeNs(0), I}};
  hold(frames, I, kStepTime, kStepTime / kStillFrames);
  const double after = I * std::exp(size);
  for (TimeNs since = kEventTimeUnit; since < window;) {
    frames.push_back({kStepTime + since, after});
    since = std::max(since + shortest, toEventTime(seconds(since) * kGrowth));
  }
  return frames;
}

Stimulus rampOf(double I, double size, double duration_s) {
  Stimulus frames;
  for (int k = 0; k <= kRampFrames; ++k) {
    const double part = static_cast<double>(k) / kRampFrames;
    frames.push_back({toEventTime(part * duration_s), I * std::exp(size * (part - 0.5))});
  }
  return frames;
}

Sine sineOf(double I, double amplitude, double hz) {
  const int split = static_cast<int>(std::ceil(1 / (hz * kCycleFrames * seconds(kSlowInterval))));
  const int frames = kCycleFrames * split;
  const TimeNs interval = std::max(kEventTimeUnit, toEventTime(1 / (hz * frames)));
  Sine sine{{}, frames * interval, kSettlingCycles * frames * interval, kMeasuredCycles};
  for (int k = 0; k <= (kSettlingCycles + kMeasuredCycles) * frames; ++k) {
    const double phase = 2 * std::numbers::pi * k / frames;
    sine.frames.push_back({k * interval, I * std::exp(amplitude * std::sin(phase))});
  }
  return sine;
}

}  // namespace saccade::eval
