// A picture as an active pixel sensor gives it: an exposure, a gain, a gamma and whole numbers.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "frame/plane_bytes.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// Number: std::uint8_t or std::uint16_t.
template <class Number>
class ExposedFrame final : public TruthSource {
 public:
  explicit ExposedFrame(const TruthConfig& config)
      : config_(config), sum_(static_cast<std::size_t>(config.width) * config.height) {}

  // Exposures end at the frames that are wanted. One that would begin during another is left out.
  TruthSamples sample(const FeedInterval& interval) override {
    const FrameIndex last = interval.frame + config_.exposure_frames - 1;
    const TimeNs frame_begin = timeOf(interval.frame - 1), t0 = interval.change.t0, t1 = interval.change.t1;
    if (t0 == frame_begin && config_.frames.takes(last, timeOf(last)) && left_ == 0) open(frame_begin);
    if (left_ == 0) return {};
    expose(interval.change.I_now, seconds(t1 - t0) / seconds(timeOf(interval.frame) - frame_begin));
    if (!interval.ends_frame || --left_ > 0) return {};
    const std::int64_t end = t1.count();
    return {{end, read(), begin_.count(), end}};
  }

 private:
  TimeNs timeOf(FrameIndex frame) const { return frameTime(frame, config_.frame_rate_hz); }

  void open(TimeNs t) {
    begin_ = t;
    left_ = config_.exposure_frames;
    std::ranges::fill(sum_, 0);
  }

  // `frames`: for how much of a frame.
  void expose(const ImageF& intensity, double frames) {
    auto sum = sum_.begin();
    for (int y = 0; y < config_.height; ++y) {
      const float* row = intensity.row(y);
      for (int x = 0; x < config_.width; ++x) *sum++ += frames * row[x];
    }
  }

  std::string read() const {
    constexpr double kMost = std::numeric_limits<Number>::max();
    const double scale = config_.gain / static_cast<double>(config_.exposure_frames);
    std::string elements;
    appendPixels(config_.width, config_.height, elements, [&](int x, int y) {
      const std::size_t pixel = static_cast<std::size_t>(y) * config_.width + x;
      const double light = std::clamp(scale * sum_[pixel], 0.0, 1.0);
      return static_cast<Number>(std::lround(kMost * std::pow(light, 1 / config_.gamma)));
    });
    return elements;
  }

  TruthConfig config_;
  std::vector<double> sum_;  // of intensity, row by row, since the exposure began
  TimeNs begin_{0};
  FrameIndex left_ = 0;  // frames until the exposure ends; 0: there is none
};

}  // namespace

std::unique_ptr<TruthSource> makeFrame(const TruthConfig& config) {
  return std::make_unique<ExposedFrame<std::uint8_t>>(config);
}

std::unique_ptr<TruthSource> makeFrame16(const TruthConfig& config) {
  return std::make_unique<ExposedFrame<std::uint16_t>>(config);
}

}  // namespace saccade
