// Direct accumulation [E (22)]: a pixel keeps v = L - L_ref, in (-C-, C+).
#include <utility>

#include "base/hash_rng.h"
#include "base/tile_pool.h"
#include "events/models/models.h"
#include "events/threshold_pixels.h"

namespace saccade {
namespace {

template <class Thresholds>
class Accumulating final : public EventModel {
 public:
  Accumulating(const SensorConfig& config, int width, int height)
      : pixels_(config, width, height), v_(width, height) {
    if (!config.random_start) return;
    // L_0 is unknown: every pixel starts at a random level between its thresholds.
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::uint64_t pixel = static_cast<std::uint64_t>(y) * width + x;
        v_.at(x, y) = pixels_.levelAt(x, y, toUnit(hashKey(config.seed, pixel)));
      }
    }
  }

  std::uint64_t generate(const ImageF& dL, const Interval& interval, Events& events) override {
    pixels_.begin(interval, !changed_);
    for (int y = 0; y < dL.height(); ++y) {
      TilePool::yieldToHighPriority();
      if (changed_) {
        settleRow(y, events, dL.row(y));
      } else {
        pixels_.advanceRow(y, dL.row(y), nullptr, v_.row(y), events);
      }
    }
    changed_ = false;
    return pixels_.suppressed();
  }

  void begin(const Interval& interval, Events& events) override {
    pixels_.begin(interval, false);
    if (!std::exchange(changed_, false)) return;
    for (int y = 0; y < v_.height(); ++y) settleRow(y, events);
  }

  void advance(const Pieces& pieces, Events& events) override {
    TilePool::yieldToHighPriority();
    for (int i = 0; i < pieces.count; ++i)
      if (pieces.dL[i] != 0)
        move(pieces.x[i], pieces.y[i], pieces.dL[i], {pieces.from[i], pieces.to[i]}, events);
  }

  std::uint64_t end(const ImageF& dL, const ImageF& from, Events& events) override {
    for (int y = 0; y < dL.height(); ++y) {
      TilePool::yieldToHighPriority();
      pixels_.advanceRow(y, dL.row(y), from.row(y), v_.row(y), events);
    }
    return pixels_.suppressed();
  }

  void setThresholds(const SensorConfig& config) override {
    pixels_.setThresholds(config);
    changed_ = true;
  }

  float level(int x, int y) const override { return v_.at(x, y); }

 private:
  void move(int x, int y, float change, typename ThresholdPixels<Thresholds>::Part part, Events& events) {
    float& v = v_.at(x, y);
    v = pixels_.advance(x, y, v, change, part, events);
  }

  // In the first interval with other thresholds; `dL`: what each pixel then does.
  void settleRow(int y, Events& events, const float* dL = nullptr) {
    for (int x = 0; x < v_.width(); ++x) {
      v_.at(x, y) = pixels_.settle(x, y, v_.at(x, y), events);
      if (dL && dL[x] != 0) move(x, y, dL[x], {}, events);
    }
  }

  ThresholdPixels<Thresholds> pixels_;
  ImageF v_;
  bool changed_ = false;  // the thresholds, since the last interval
};

}  // namespace

std::unique_ptr<EventModel> makeAccumulating(const SensorConfig& config, int width, int height) {
  if (config.noise.mismatch > 0) {
    return std::make_unique<Accumulating<OwnThresholds>>(config, width, height);
  }
  return std::make_unique<Accumulating<EqualThresholds>>(config, width, height);
}

}  // namespace saccade
